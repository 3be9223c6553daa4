"""Blocks of any kind of scheme put into words, tables and lines of text: what all formats that set them share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from subdiv_cli.model import Finding, Result, Verdict
from subdiv_cli.model.blocks import Block, Formula, Grid, Matrix, Picture, Planes, Section, Statements, Text, Words
from subdiv_cli.model.findings import HOLDER_LOWER, HOLDER_UPPER, SOBOLEV, answering
from subdiv_cli.report import findings, marks, words
from subdiv_cli.report.grids import put_planes, tables
from subdiv_cli.report.letters import width
from subdiv_cli.report.numbers import interval
from subdiv_cli.report.page import INDENT, Page

Draw = Callable[[Picture], Sequence[str]]
"""A function that draws a picture in lines of letters."""
_WIDE = 11
"""The nodes beyond which the numbers of a row are listed instead of drawn."""
_LONG = 14
"""The letters of a number beyond which they are listed, too."""
_BRACKETS = (("⎡", "⎢", "⎣", "["), ("⎤", "⎥", "⎦", "]"))


def worded(block: Block, result: Result) -> Iterator[Block]:
    """The block in parts: results in words, findings as sentences, and what is too wide to draw as a list."""
    if isinstance(block, Words):
        yield from [Text(", ".join(words.facts(result)))] if block.about == "facts" else _exponents(result)
    elif isinstance(block, Statements):
        yield from (Text(_sentence(finding), marks.of_finding(result, finding).role) for finding in block.findings)
    elif isinstance(block, Grid):
        yield from _narrow(block)
    else:
        yield block


def tabled(block: Block, result: Result) -> Iterator[Block]:
    """The block in parts, as in `worded`, for formats that know tables and no axes."""
    for part in worded(block, result):
        yield from tables(part) if isinstance(part, Planes) else [part]


def _exponents(result: Result) -> Iterator[Text]:
    bounds = (answering(result.findings, question) for question in (HOLDER_LOWER, HOLDER_UPPER))
    if (holder := words.holder(result)) is not None:
        yield Text(f"Hölder exponent {holder} ({', '.join(bound.code for bound in bounds if bound is not None)})")
    finding = answering(result.findings, SOBOLEV)
    if finding is not None and result.sobolev is not None and (sobolev := interval(result.sobolev)) is not None:
        yield Text(f"Sobolev exponent {sobolev} ({finding.code})")
    yield from (Text(line, "quiet") for line in words.figures(result, digits=True))


def _sentence(finding: Finding) -> str:
    """The statement of a finding, with verdict and code behind it."""
    asks = finding.verdict in (Verdict.UNDECIDED, Verdict.SKIPPED)
    why = f" {finding.reason}" if asks and finding.reason else ""
    return f"{finding.statement}{why} ({finding.verdict.value}, {finding.code})"


def _narrow(grid: Grid) -> Iterator[Block]:
    """The grid if it is seen at a glance, else each row with numbers by itself, or these as a list."""
    longest = max((len(text) for _, numbers in grid.rows for text in numbers), default=0)
    if 0 < len(grid.nodes) <= _WIDE and longest <= _LONG:
        yield grid
        return
    for name, numbers in grid.rows:
        used = [i for i, text in enumerate(numbers) if text not in ("", "0")]
        if len(grid.rows) > 1 and used:
            own = slice(used[0], used[-1] + 1)
            yield from _narrow(Grid(grid.corner, grid.nodes[own], ((name, numbers[own]),)))
        else:
            entries = ", ".join(f"{grid.nodes[i]}: {numbers[i]}" for i in used) or "0"
            yield Text(f"{name}  {entries}".lstrip())


def has_grids(section: Section) -> bool:
    """Whether a section has rows or planes of numbers."""
    return any(isinstance(block, Grid | Planes) for block in section.blocks)


def put(page: Page, blocks: Iterable[Block], result: Result, draw: Draw = lambda _: ()) -> None:
    """Put blocks on a page of text; pictures are left out unless `draw` makes lines of them."""
    for block in blocks:
        if isinstance(block, Statements) and block.full:
            findings.show(page, result, page.look.shown(block.findings))
            continue
        for part in worded(block, result):
            _put(page, part, draw)


def _put(page: Page, block: Block, draw: Draw) -> None:
    if isinstance(block, Text):
        page.put(block.text, block.role, indent=INDENT, hanging=2)
    elif isinstance(block, Formula):
        page.put(f"{block.left} = {block.right}", indent=INDENT, hanging=4)
    elif isinstance(block, Grid):
        _grid(page, block)
    elif isinstance(block, Planes):
        put_planes(page, block.planes)
    elif isinstance(block, Matrix):
        _matrix(page, block)
    elif isinstance(block, Picture):
        page.lines += [[(" " * INDENT + line, "text")] for line in draw(block)]


def _grid(page: Page, grid: Grid) -> None:
    """Put a grid on a page: nodes above numbers, columns as wide as their widest entries; in pieces if need be."""
    named = [(page.say(name), [page.say(x) for x in numbers]) for name, numbers in grid.rows]
    nodes = [page.say(node) for node in grid.nodes]
    lead = max(width(page.say(grid.corner)), *(width(name) for name, _ in named))
    widths = [max(width(node), *(width(row[i]) for _, row in named)) for i, node in enumerate(nodes)]
    start = 0
    while start < len(widths):
        room, end = page.look.width - 2 * INDENT - lead - 2, start
        while end < len(widths) and (end == start or room >= widths[end] + 2):
            room -= widths[end] + 2
            end += 1
        rows = [(page.say(grid.corner), nodes, "quiet"), *((name, row, "text") for name, row in named)]
        for name, entries, role in rows:
            cells = "  ".join(_centred(entries[i], widths[i]) for i in range(start, end))
            page.lines.append([(" " * (INDENT + 2) + name + " " * (lead - width(name) + 2), "quiet"), (cells, role)])
        start = end


def _centred(text: str, columns: int) -> str:
    missing = columns - width(text)
    return " " * (missing // 2) + text + " " * (missing - missing // 2)


def _matrix(page: Page, matrix: Matrix) -> None:
    rows = [[page.say(x) for x in row] for row in matrix.rows]
    widths = [max(width(row[i]) for row in rows) for i in range(len(rows[0]))]
    name = f"{matrix.name} = "
    for at, row in enumerate(rows):
        edge = 3 if len(rows) == 1 else 0 if at == 0 else 2 if at == len(rows) - 1 else 1
        left, right = (side[edge] if page.look.unicode else "|" for side in _BRACKETS)
        lead = name if at == (len(rows) - 1) // 2 else " " * len(name)
        cells = "  ".join(" " * (widths[i] - width(x)) + x for i, x in enumerate(row))
        page.lines.append([(" " * (INDENT + 2) + lead, "quiet"), (f"{left} {cells} {right}", "text")])
