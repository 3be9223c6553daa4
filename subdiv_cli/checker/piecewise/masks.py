"""Piecewise masks: the one that a document is about, its rows and cells, and plain mask files."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.checker.core import Claim, Subject
from subdiv_cli.checker.plain import PlainMask, literal
from subdiv_cli.checker.polynomials import Polynomial
from subdiv_cli.checker.reading import Fields, record, require, require_few, several

MAX_ARITY = 64
MAX_POINT = 1_000
"""The largest size of the index of a special row, of a point it reads, and of one in the support of a mask."""
MAX_WINDOW = 400
_ROW: Fields = {"row": "integer", "start": "start", "coefficients": "rational[]"}
FIELDS: Fields = {
    "arity": "natural",
    "left": "polynomial",
    "right": "polynomial",
    "spacing": "rational[]",
    "special": several(record(_ROW), 2 * MAX_POINT + 1),
}
Weights = dict[int, Fraction]


class SideCells(NamedTuple):
    """The cells of a side: those that generate all others, and where each has its data."""

    mask: Polynomial
    spacing: Fraction
    low: int
    high: int
    numbers: range

    @property
    def points(self) -> range:
        """The indices of the data of all cells."""
        return range(min(self.numbers) + self.low, max(self.numbers) + self.high + 1)


class TwoMasks(NamedTuple):
    """The masks of both sides, the spacings, and the special rows by their points."""

    arity: int
    left: Polynomial
    right: Polynomial
    spacing: tuple[Fraction, Fraction]
    special: dict[int, Weights]

    def row(self, i: int) -> Weights:
        """The weights of new point i."""
        if i in self.special:
            return self.special[i]
        mask, p = self.left if i < 0 else self.right, self.arity
        last = mask.start + len(mask.numerators) - 1
        reached = range(-(-(i - last) // p), (i - mask.start) // p + 1)
        return {j: Fraction(mask.at(i - p * j), mask.denominator) for j in reached if mask.at(i - p * j)}

    def cells(self) -> tuple[SideCells, SideCells]:
        """The cells J <= j < pJ of both sides, as FORMAT.md has them, the left one first."""
        p = self.arity
        s, e = self.left.start, self.left.start + len(self.left.numerators) - 1
        first = min([0, *self.special]) - 1
        j = max(1, _up(_up(max(0, -s), p - 1) - first, p))
        left = SideCells(self.left, self.spacing[0], _up(-e, p - 1), 1 + (-s) // (p - 1), range(-p * j, -j))
        s, e = self.right.start, self.right.start + len(self.right.numerators) - 1
        first = max([-1, *self.special]) + 1
        j = max(1, _up(_up(max(0, e), p - 1) + first, p))
        return left, SideCells(self.right, self.spacing[1], _up(-e, p - 1), 1 + (-s) // (p - 1), range(j, p * j))

    def window(self) -> range:
        """The smallest interval with 0 and the data of all cells that has all points its own are computed from."""
        points = [i for cells in self.cells() for i in (cells.points[0], cells.points[-1])]
        low, high = min(0, *points), max(0, *points)
        while True:
            require_few(high - low < MAX_WINDOW, "the window is too large")
            inputs = [j for i in range(low, high + 1) for j in self.row(i)]
            if low <= min(inputs, default=low) and max(inputs, default=high) <= high:
                return range(low, high + 1)
            low, high = min(low, *inputs), max(high, *inputs)

    @property
    def bits(self) -> int:
        """The bits of the longest number, numerator and denominator together."""
        masks = [max(map(abs, m.numerators)).bit_length() + m.denominator.bit_length() for m in (self.left, self.right)]
        numbers = [*self.spacing, *(x for row in self.special.values() for x in row.values())]
        return max(*masks, *(x.numerator.bit_length() + x.denominator.bit_length() for x in numbers))


def _up(a: int, b: int) -> int:
    """The quotient a/b, b > 0, rounded up."""
    return -(-a // b)


def subject(parts: dict[str, Any]) -> Subject:
    """The masks of a document, from its parts. Raises Rejected where they make no piecewise scheme."""
    p, left, right, spacing = parts["arity"], parts["left"], parts["right"], parts["spacing"]
    require(2 <= p <= MAX_ARITY, f"the arity is not one of 2, …, {MAX_ARITY}")
    for mask in (left, right):
        require(bool(mask.numerators), "a mask is zero")
        require(max(-mask.start, mask.start + len(mask.numerators) - 1) <= MAX_POINT, "a mask is too far from 0")
    require(len(spacing) == 2 and min(spacing) > 0, "the spacing is not two positive numbers")
    special: dict[int, Weights] = {}
    for row in parts["special"]:
        i, start, entries = row["row"], row["start"], row["coefficients"]
        require(i not in special, f"row {i} stands twice")
        require(max(abs(i), abs(start), abs(start + len(entries))) <= MAX_POINT, "a special row is too far from 0")
        special[i] = {j: x for j, x in enumerate(entries, start) if x}
    return Subject(p, TwoMasks(p, left, right, (spacing[0], spacing[1]), special))


def masks_of(c: Claim) -> TwoMasks:
    """The masks that the document is about."""
    masks: TwoMasks = c.about
    return masks


def _plain(
    p: int, sides: list[tuple[int, list[Fraction]]], spacing: list[Fraction], special: Mapping[int, Weights]
) -> PlainMask:
    """The masks in their normal form: no zeros at ends, no special row that says what the mask says."""
    masks: list[tuple[int, tuple[Fraction, ...]]] = []
    for start, coefficients in sides:
        support = [i for i, x in enumerate(coefficients) if x] or [0]
        masks.append((start + support[0], tuple(coefficients[support[0] : support[-1] + 1])))
    rows = []
    for i, row in sorted(special.items()):
        first, entries = masks[0 if i < 0 else 1]
        ordinary = {(i - k) // p: x for k, x in enumerate(entries, first) if x and not (i - k) % p}
        kept = {j: x for j, x in sorted(row.items()) if x}
        if kept != ordinary:
            rows.append((i, tuple(kept.items())))
    return PlainMask("piecewise", (p, tuple(masks), tuple(spacing), tuple(rows)))


def of_file(document: Mapping[str, Any]) -> PlainMask | None:
    """The masks of a file: `left` and `right` with coefficients, `spacing` and `special`, which may be left out."""
    sides, arities = [], set()
    for name in ("left", "right"):
        table = document.get(name)
        if type(table) is not dict or not {"coefficients"} <= table.keys() <= {"arity", "start", "coefficients"}:
            return None
        arity, start, entries = table.get("arity", 2), table.get("start", 0), table["coefficients"]
        if type(arity) is not int or type(start) is not int or type(entries) is not list or not entries:
            return None
        sides.append((start, [literal(x) for x in entries]))
        arities.add(arity)
    spacing, special = document.get("spacing", [1, 1]), document.get("special", {})
    if len(arities) != 1 or type(spacing) is not list or type(special) is not dict:
        return None
    rows = {int(i): {int(j): literal(x) for j, x in row.items()} for i, row in special.items()}
    return _plain(arities.pop(), sides, [literal(x) for x in spacing], rows)


def of_certificate(mask: Mapping[str, Any]) -> PlainMask:
    """The masks in their normal form, from the part of a verified certificate under `mask`."""
    sides = [(mask[name]["start"], [Fraction(x) for x in mask[name]["coefficients"]]) for name in ("left", "right")]
    special = {
        row["row"]: {j: Fraction(x) for j, x in enumerate(row["coefficients"], row["start"])} for row in mask["special"]
    }
    return _plain(mask["arity"], sides, [Fraction(x) for x in mask["spacing"]], special)
