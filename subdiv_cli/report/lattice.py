"""Stencils of a mask in several variables as text: for each coset of Z^s/MZ^s a small grid of exact weights.

    coset (1, 0) at (1/2, 0), in 1/8
     0 │   ·  1
    -1 │   3  3
    -2 │   1  ·
       └───────
          -1  0

The first coordinate goes to the right, the second upwards; further ones are cut into slices.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby, product
from math import lcm
from typing import NamedTuple, cast

from subdiv_cli.model import Finding, Verdict
from subdiv_cli.report.layout import wrap
from subdiv_cli.report.letters import width
from subdiv_cli.report.numbers import exact
from subdiv_cli.report.page import INDENT, Page

Index = tuple[int, ...]

MOST_COSETS = 16
"""Of a mask that are drawn."""
QUASI = "SD619"
QUASI_TITLE = "Q f(α) = Σ t_j f(α+j)"
_LARGEST_DENOMINATOR = 10**6
"""Up to here weights are shown as multiples of 1/denominator, which keeps them short."""
_GAP = 4


class Stencil(NamedTuple):
    """(S f)(γ + Mβ) = Σ_δ weights[δ] f(β + δ), for all β: the rule of the new points M^-1 γ + Z^s."""

    coset: Index
    """γ."""
    at: tuple[Fraction, ...]
    """M^-1 γ."""
    weights: Mapping[Index, Fraction]
    """δ -> a_(γ - Mδ), those that are not zero."""


def stencils(terms: Mapping[Index, Fraction], dilation: Sequence[Sequence[int]]) -> Iterator[Stencil]:
    """One for each of the |det M| cosets, representatives with small entries first.

    `terms`: α -> a_α on Z^s; `dilation`: the rows of M, not singular.
    """
    inverse = _inverse(dilation)
    by_residue: dict[tuple[Fraction, ...], list[Index]] = {}
    for index in terms:
        by_residue.setdefault(_residue(_times(inverse, index)), []).append(index)
    for coset in _representatives(inverse):
        at = _times(inverse, coset)
        weights = {}
        for index in by_residue.get(_residue(at), ()):
            delta = _times(inverse, [g - a for g, a in zip(coset, index, strict=True)])
            weights[tuple(map(int, delta))] = terms[index]
        yield Stencil(coset, at, weights)


def put_stencils(page: Page, terms: Mapping[Index, Fraction], dilation: Sequence[Sequence[int]]) -> None:
    """All of them, side by side where the page is wide enough; of many cosets the first `MOST_COSETS`."""
    shown: list[Stencil] = []
    more = 0
    for stencil in stencils(terms, dilation):
        if len(shown) < MOST_COSETS:
            shown.append(stencil)
        else:
            more += 1
    if len(dilation) == 2:
        _put_beside(page, [(titled(stencil), _cells(stencil.weights)) for stencil in shown])
    else:
        for stencil in shown:
            page.put(titled(stencil), "quiet", indent=INDENT, hanging=2)
            _put_beside(page, _slices(stencil.weights))
    if more:
        page.put(f"and {more} more coset{'' if more == 1 else 's'}", "quiet", indent=INDENT)


def put_values(page: Page, title: str, values: Mapping[Index, Fraction]) -> None:
    """A function on Z^s, where it is not zero, as the weights of a stencil are put."""
    scaled = title + scaled_by(values)
    if len(next(iter(values))) == 2:
        _put_beside(page, [(scaled, _cells(values))])
    else:
        page.put(scaled, "quiet", indent=INDENT, hanging=2)
        _put_beside(page, _slices(values))


def put_quasi_interpolation(page: Page, findings: Sequence[Finding]) -> None:
    """The stencil of Q, where it is found to be more than one weight."""
    found = next((found for found in findings if found.code == QUASI and found.verdict is Verdict.PROVED), None)
    stencil = cast(
        "tuple[tuple[Index, Fraction | str], ...]", () if found is None else found.witness.get("stencil", ())
    )
    if len(stencil) > 1:
        put_values(page, QUASI_TITLE, {tuple(j): Fraction(x) for j, x in stencil})


def _inverse(rows: Sequence[Sequence[int]]) -> list[list[Fraction]]:
    """By Gauss and Jordan. Raises ValueError for a singular matrix."""
    size = len(rows)
    work = [[*map(Fraction, row), *(Fraction(i == j) for j in range(size))] for i, row in enumerate(rows)]
    for column in range(size):
        pivot = next((i for i in range(column, size) if work[i][column]), None)
        if pivot is None:
            raise ValueError("the dilation matrix is singular")
        work[column], work[pivot] = work[pivot], work[column]
        work[column] = [x / work[column][column] for x in work[column]]
        for i in range(size):
            if i != column:
                work[i] = [x - work[i][column] * y for x, y in zip(work[i], work[column], strict=True)]
    return [row[size:] for row in work]


def _times(matrix: Sequence[Sequence[Fraction]], vector: Sequence[int]) -> tuple[Fraction, ...]:
    return tuple(sum((x * k for x, k in zip(row, vector, strict=True)), Fraction(0)) for row in matrix)


def _residue(point: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    """Equal for two points that differ by one of Z^s."""
    return tuple(x % 1 for x in point)


def _representatives(inverse: Sequence[Sequence[Fraction]]) -> Iterator[Index]:
    """One of each coset, from the box of the Hermite normal form of M: its sides are read off M^-1, column by column.

    The i-th side is the smallest h > 0 with h e_i in MZ^s + Z e_1 + … + Z e_(i-1); a direct sum of these is Z^s/MZ^s.
    """
    size = len(inverse)
    reached: set[tuple[Fraction, ...]] = {(Fraction(0),) * size}
    sides = []
    for i in range(size):
        step = _times(inverse, [int(i == j) for j in range(size)])
        multiples = [(Fraction(0),) * size]
        while True:
            following = tuple(x + y for x, y in zip(multiples[-1], step, strict=True))
            if _residue(following) in reached:
                break
            multiples.append(following)
        sides.append(len(multiples))
        reached = {_residue(tuple(x + y for x, y in zip(a, b, strict=True))) for a, b in product(reached, multiples)}
    yield from sorted(product(*map(range, sides)), key=lambda coset: (sum(coset), [-k for k in coset]))


def titled(stencil: Stencil) -> str:
    """`coset (1, 0) at (1/2, 0), in 1/8`."""
    coset = f"coset {_tuple(stencil.coset)}"
    where = f" at {_tuple(stencil.at)}" if any(stencil.at) else " at the old points"
    if not stencil.weights:
        return f"{coset}{where}: no weights"
    return f"{coset}{where}{scaled_by(stencil.weights)}"


def scaled_by(weights: Mapping[Index, Fraction]) -> str:
    """`, in 1/8` where the cells have eight times the weights."""
    denominator = _denominator(weights)
    return f", in 1/{denominator}" if denominator > 1 else ""


def _tuple(entries: Sequence[Fraction | int]) -> str:
    return f"({', '.join(map(exact, entries))})"


def _denominator(weights: Mapping[Index, Fraction]) -> int:
    """What the weights are multiplied by before they are shown."""
    common = lcm(*(weight.denominator for weight in weights.values()))
    return common if common <= _LARGEST_DENOMINATOR else 1


def _cells(weights: Mapping[Index, Fraction]) -> dict[Index, str]:
    scale = _denominator(weights)
    return {index: exact(weight * scale) for index, weight in weights.items()}


def planes(weights: Mapping[Index, Fraction]) -> list[tuple[str, dict[Index, str]]]:
    """Cells of two coordinates: all of them, or slices with their titles."""
    return [("", _cells(weights))] if len(next(iter(weights), (0, 0))) == 2 else _slices(weights)


def _slices(weights: Mapping[Index, Fraction]) -> list[tuple[str, dict[Index, str]]]:
    """Planes of the first two coordinates, the others fixed."""
    cells = sorted(_cells(weights).items(), key=lambda cell: cell[0][2:])
    found = []
    for above, group in groupby(cells, key=lambda cell: cell[0][2:]):
        title = ", ".join(f"x{i} = {k}" for i, k in enumerate(above, 3))
        found.append((title, {index[:2]: text for index, text in group}))
    return found


def _put_beside(page: Page, grids: Sequence[tuple[str, Mapping[Index, str]]]) -> None:
    """Grids under their titles, as many in a row as fit."""
    room = page.look.width - 2 * INDENT
    row: list[list[str]] = []
    for title, cells in grids:
        pieces = _drawn(page, cells, room)
        if pieces is None:
            _flush(page, row)
            listed = ", ".join(f"{_tuple(index)}: {text}" for index, text in sorted(cells.items()))
            page.put(f"{title}: {listed}", indent=2 * INDENT, hanging=2)
            continue
        for k, piece in enumerate(pieces):
            block = [*wrap(page.say(title) if k == 0 else "...", room), *piece]
            taken = sum(max(map(width, other)) + _GAP for other in row)
            if row and taken + max(map(width, block)) > room:
                _flush(page, row)
            row.append(block)
    _flush(page, row)


def _flush(page: Page, row: list[list[str]]) -> None:
    """Prints blocks beside each other, if there are any, and forgets them."""
    widths = [max(map(width, block)) for block in row]
    for i in range(max(map(len, row), default=0)):
        texts = [block[i] if i < len(block) else "" for block in row]
        line = (" " * _GAP).join(text + " " * (size - width(text)) for text, size in zip(texts, widths, strict=True))
        page.lines.append([(" " * 2 * INDENT + line.rstrip(), "quiet" if i == 0 else "text")])
    if row:
        page.blank()
        row.clear()


def _drawn(page: Page, cells: Mapping[Index, str], room: int) -> list[list[str]] | None:
    """A grid in pieces that fit, each with its axes; None where a number alone is too wide. No cells are no lines."""
    if not cells:
        return [[]]
    dot, bar, corner, rule = ("·", "│", "└", "─") if page.look.unicode else (".", "|", "+", "-")
    low, high = [min(k) for k in zip(*cells, strict=True)], [max(k) for k in zip(*cells, strict=True)]
    columns, rows = range(low[0], high[0] + 1), range(high[1], low[1] - 1, -1)
    lead = max(len(str(y)) for y in rows)
    widths = {x: max(len(str(x)), *(len(cells.get((x, y), dot)) for y in rows)) for x in columns}
    room -= lead + 2
    if max(widths.values()) + 2 > room:
        return None
    pieces, start = [], low[0]
    while start <= high[0]:
        end, used = start, 0
        while end <= high[0] and used + widths[end] + 2 <= room:
            used += widths[end] + 2
            end += 1
        part = range(start, end)
        lines = [f"{y:>{lead}} {bar}" + "".join(f"  {cells.get((x, y), dot):>{widths[x]}}" for x in part) for y in rows]
        lines.append(" " * lead + f" {corner}{rule * used}")
        lines.append(" " * (lead + 2) + "".join(f"  {x:>{widths[x]}}" for x in part))
        pieces.append(lines)
        start = end
    return pieces
