"""`subdiv show` for a terminal: stencils drawn as stencils, matrices as matrices, φ with letters."""

from __future__ import annotations

from collections.abc import Sequence

from subdiv_cli.model import Result
from subdiv_cli.model.blocks import Anatomy
from subdiv_cli.report import words
from subdiv_cli.report.layout import joined, paint
from subdiv_cli.report.letters import width
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import exact
from subdiv_cli.report.page import INDENT, Page
from subdiv_cli.report.show.content import Block, Drawing, Formula, Grid, Matrix, Text, sections

_BRACKETS = (("⎡", "⎢", "⎣", "["), ("⎤", "⎥", "⎦", "]"))


def render(result: Result, anatomy: Anatomy, picture: Sequence[str], look: Look) -> str:
    page = Page(look)
    page.put(f"{words.name(result)}: {words.headline(result)}", "head", hanging=2)
    items = [result.file, result.kind or "", *(f"{name} = {exact(x)}" for name, x in result.parameters.items())]
    items = [page.say(item) for item in (*items, result.reference or "") if item]
    page.lines += joined(items, " · " if look.unicode else "; ", look.width, indent=INDENT, role="quiet")
    for hint in result.hints:
        page.put(f"hint: {hint}", "open", indent=INDENT, hanging=6)
    for section in sections(result, anatomy):
        page.blank()
        page.put(section.title, "head")
        for block in section.blocks:
            _put(page, block, picture)
    return paint(page.lines, colour=look.colour)


def _put(page: Page, block: Block, picture: Sequence[str]) -> None:
    if isinstance(block, Text):
        page.put(block.text, block.role, indent=INDENT, hanging=2)
    elif isinstance(block, Formula):
        page.put(f"{block.left} = {block.right}", indent=INDENT, hanging=4)
    elif isinstance(block, Grid):
        _grid(page, block)
    elif isinstance(block, Matrix):
        _matrix(page, block)
    elif isinstance(block, Drawing):
        page.lines += [[(" " * INDENT + line, "text")] for line in picture]


def _grid(page: Page, grid: Grid) -> None:
    """Nodes above numbers, each column as wide as its widest entry; in pieces where the page is narrow."""
    named = [(page.say(name), [page.say(x) for x in numbers]) for name, numbers in grid.rows]
    lead = max(width(page.say(grid.corner)), *(width(name) for name, _ in named))
    widths = [max(width(node), *(width(row[i]) for _, row in named)) for i, node in enumerate(grid.nodes)]
    start = 0
    while start < len(widths):
        room, end = page.look.width - 2 * INDENT - lead - 2, start
        while end < len(widths) and (end == start or room >= widths[end] + 2):
            room -= widths[end] + 2
            end += 1
        rows = [(page.say(grid.corner), grid.nodes, "quiet"), *((name, row, "text") for name, row in named)]
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
