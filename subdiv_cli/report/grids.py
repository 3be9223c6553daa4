"""Planes of numbers as text: small grids on axes, beside each other.

An example:

    coset (1, 0) at (1/2, 0), in 1/8
     0 │   ·  1
    -1 │   3  3
    -2 │   1  ·
       └───────
          -1  0

The first coordinate goes to the right, the second upwards.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from subdiv_cli.model.blocks import Grid, Place, Plane, Planes, Text
from subdiv_cli.model.formulas import point
from subdiv_cli.report.letters import width
from subdiv_cli.report.page import INDENT, Page, wrap

_GAP = 4
_WIDE = 16
"""The columns of a table beyond which its numbers are listed."""
_LARGEST = 20_000
"""The places beyond which they are listed, however wide the page is."""


def put_planes(page: Page, planes: Sequence[Plane]) -> None:
    """Put the planes on a page, each under its title, as many in a row as fit."""
    room = page.look.width - 2 * INDENT
    row: list[list[str]] = []
    for title, cells in planes:
        pieces = _drawn(page, cells, room)
        if pieces is None:
            _flush(page, row)
            page.put(f"{title}: {_listed(cells)}", indent=2 * INDENT, hanging=2)
            continue
        for k, piece in enumerate(pieces):
            block = [*wrap(page.say(title) if k == 0 else "...", room), *piece]
            taken = sum(max(map(width, other)) + _GAP for other in row)
            if row and taken + max(map(width, block)) > room:
                _flush(page, row)
            row.append(block)
    _flush(page, row)


def tables(planes: Planes) -> Iterator[Text | Grid]:
    """The planes as titles and tables; the numbers of a wide one as a list."""
    for title, cells in planes.planes:
        if title:
            yield Text(title)
        if not cells:
            continue
        columns, rows = _axes(cells)
        if len(columns) > _WIDE or len(columns) * len(rows) > _LARGEST:
            yield Text(_listed(cells))
        else:
            lines = ((str(y), tuple(cells.get((x, y), "·") for x in columns)) for y in rows)
            yield Grid("", tuple(map(str, columns)), tuple(lines))


def _listed(cells: Mapping[Place, str]) -> str:
    return ", ".join(f"{point(place)}: {text}" for place, text in sorted(cells.items()))


def _axes(cells: Mapping[Place, str]) -> tuple[range, range]:
    """The first coordinates from left to right, and the second ones from above."""
    (left, right), (low, high) = ((min(side), max(side)) for side in zip(*cells, strict=True))
    return range(left, right + 1), range(high, low - 1, -1)


def _flush(page: Page, row: list[list[str]]) -> None:
    """Put blocks on the page beside each other, if there are any, and forget them."""
    widths = [max(map(width, block)) for block in row]
    for i in range(max(map(len, row), default=0)):
        texts = [block[i] if i < len(block) else "" for block in row]
        line = (" " * _GAP).join(text + " " * (size - width(text)) for text, size in zip(texts, widths, strict=True))
        page.lines.append([(" " * 2 * INDENT + line.rstrip(), "quiet" if i == 0 else "text")])
    if row:
        page.blank()
        row.clear()


def _drawn(page: Page, cells: Mapping[Place, str], room: int) -> list[list[str]] | None:
    """A grid in pieces that fit, each with its axes; None where a number alone is too wide. No cells are no lines."""
    if not cells:
        return [[]]
    dot, bar, corner, rule = ("·", "│", "└", "─") if page.look.unicode else (".", "|", "+", "-")
    columns, rows = _axes(cells)
    if len(columns) * len(rows) > _LARGEST:
        return None
    lead = max(len(str(y)) for y in rows)
    widths = {x: max(len(str(x)), *(len(cells.get((x, y), dot)) for y in rows)) for x in columns}
    room -= lead + 2
    if max(widths.values()) + 2 > room:
        return None
    pieces, start = [], columns.start
    while start < columns.stop:
        end, used = start, 0
        while end < columns.stop and used + widths[end] + 2 <= room:
            used += widths[end] + 2
            end += 1
        part = range(start, end)
        lines = [f"{y:>{lead}} {bar}" + "".join(f"  {cells.get((x, y), dot):>{widths[x]}}" for x in part) for y in rows]
        lines.append(" " * lead + f" {corner}{rule * used}")
        lines.append(" " * (lead + 2) + "".join(f"  {x:>{widths[x]}}" for x in part))
        pieces.append(lines)
        start = end
    return pieces
