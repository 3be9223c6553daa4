"""Special rules between two masks: S Q = Q σ solved for them (A. Levin 2003, 3.5), smallest support first.

Q is that of the left mask at points i < b and that of the right one at i >= b, b = 1 or 0. A new point i needs weights
of old points with Σ_j w_j (Q x^d)(j) = p^-d (Q x^d)(i), d <= m, which is linear; where the mask of its side gives them,
or that of the other side, it is no special point. Weights are looked for on as few consecutive points as have any,
nearest to i/p; where they are not unique, the smallest of them is made as large as it can be. Positive weights exist on
some points iff that is >= 0: a linear program, whose dual says why where there are none, by a polynomial g of degree
<= m with (Q g)(j) >= 0 at all these points and (Q σ g)(i) < 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.exact.programs import Optimum, largest_least_weight
from subdiv_cli.kinds.piecewise.numbers.polynomials import Polynomial, at, eigen_polynomials
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme, Row
from subdiv_cli.kinds.piecewise.text import LARGEST_POINT
from subdiv_cli.kinds.scalar.scheme import ScalarScheme

_BOUNDARIES = (1, 0)
"""The first points of the right side that are tried for Q."""
_MORE = 8
"""How many points more than there are conditions a rule may read."""


class ImpossibleError(Exception):
    """Raised where there are no special rules as asked for; the message says why."""


class Conditions(NamedTuple):
    """The operator Q on π_m, by the polynomials of both masks, and from which point on it is that of the right one."""

    left: tuple[Polynomial, ...]
    right: tuple[Polynomial, ...]
    boundary: int
    arity: int

    def column(self, j: int) -> list[Fraction]:
        """The values (Q 1)(j), …, (Q x^m)(j)."""
        return [at(q, j) for q in (self.left if j < self.boundary else self.right)]

    def right_side(self, i: int) -> list[Fraction]:
        """The values that the rule of new point i must give: p^-d (Q x^d)(i)."""
        return [x / self.arity**d for d, x in enumerate(self.column(i))]

    def are_met(self, i: int, row: Row) -> bool:
        """Whether a row meets the conditions of new point i."""
        columns = [(weight, self.column(j)) for j, weight in row]
        total = [sum((weight * column[d] for weight, column in columns), Fraction(0)) for d in range(len(self.left))]
        return total == self.right_side(i)


class SpecialRule(NamedTuple):
    """The rule of a special point, and the program that it comes from."""

    row: Row
    points: range
    optimum: Optimum


class Blend(NamedTuple):
    """Two masks with special rules between them."""

    scheme: PiecewiseScheme
    degree: int
    rules: dict[int, SpecialRule]
    """The special rules that are of neither mask."""
    boundary: int


def conditions(
    left: ScalarScheme, right: ScalarScheme, spacing: tuple[Fraction, Fraction], degree: int | None, boundary: int
) -> Conditions:
    """The conditions for a degree, by default the largest one that both masks generate. Raises ImpossibleError."""
    polynomials = eigen_polynomials(left, spacing[0]), eigen_polynomials(right, spacing[1])
    most = {name: len(each) - 1 for name, each in zip(("left", "right"), polynomials, strict=True)}
    for name, own in most.items():
        if own < max(0, degree or 0):
            has = f"generates polynomials of degree {own}" if own >= 0 else "has no sum rule"
            raise ImpossibleError(f"the {name} mask {has}, and S Q = Q σ is wanted on degree {max(0, degree or 0)}")
    count = min(most.values()) + 1 if degree is None else degree + 1
    return Conditions(polynomials[0][:count], polynomials[1][:count], boundary, left.arity)


def blended(
    left: ScalarScheme,
    right: ScalarScheme,
    spacing: tuple[Fraction, Fraction] = (Fraction(1), Fraction(1)),
    degree: int | None = None,
    support: int | None = None,
    positive: bool = False,
) -> list[Blend]:
    """The schemes for both choices of Q at 0, the one with the fewest special points and the smallest rules first.

    `support` is the number of points that a special rule reads, `positive` asks for rules without negative weights.
    Raises ImpossibleError where neither choice has rules.
    """
    results, reasons = [], []
    for boundary in _BOUNDARIES:
        wanted = conditions(left, right, spacing, degree, boundary)
        try:
            results.append(_blend(left, right, spacing, wanted, support, positive))
        except ImpossibleError as why:
            reasons.append(f"with Q of the {'left' if boundary else 'right'} mask at 0: {why}")
    if not results:
        raise ImpossibleError("\n".join(reasons))
    return sorted(results, key=lambda blend: (len(blend.rules), sum(len(rule.row) for rule in blend.rules.values())))


def _blend(
    left: ScalarScheme,
    right: ScalarScheme,
    spacing: tuple[Fraction, Fraction],
    wanted: Conditions,
    support: int | None,
    positive: bool,
) -> Blend:
    """The scheme for one choice of Q. Raises ImpossibleError."""
    plain = PiecewiseScheme(left, right, spacing)
    rows, rules = [], {}
    for i in _candidates(left, right):
        if wanted.are_met(i, plain.ordinary(i)):
            continue
        other = _row_of(right if i < 0 else left, i)
        if wanted.are_met(i, other) and not (positive and any(weight < 0 for _, weight in other)):
            rows.append((i, other))
            continue
        rules[i] = _rule(wanted, i, support, positive)
        rows.append((i, rules[i].row))
    if any(abs(x) > LARGEST_POINT for i, row in rows for x in (i, *dict(row))):
        raise ImpossibleError(f"special rules lie or read beyond {LARGEST_POINT}; shift the masks towards 0")
    return Blend(PiecewiseScheme(left, right, spacing, tuple(rows)), len(wanted.left) - 1, rules, wanted.boundary)


def _candidates(left: ScalarScheme, right: ScalarScheme) -> range:
    """The new points whose rules may read across the boundary."""
    reach = max(abs(x) for mask in (left, right) for x in (mask.start, mask.start + mask.degree)) + 2 * left.arity
    return range(-reach, reach + 1)


def _row_of(mask: ScalarScheme, i: int) -> Row:
    """The row of new point i by a mask."""
    return PiecewiseScheme(mask, mask).ordinary(i)


def _windows(i: int, arity: int, size: int) -> Iterator[range]:
    """The intervals of so many points around i/p, the most central ones first, nearer to 0 where there is a tie."""
    middle = Fraction(i, arity)
    firsts = range(int(middle) - size, int(middle) + 2)
    around = [range(first, first + size) for first in firsts if first - 1 < middle < first + size]

    def distance(window: range) -> tuple[Fraction, Fraction, int]:
        centre = Fraction(window[0] + window[-1], 2)
        return abs(centre - middle), abs(centre), window[0]

    return iter(sorted(around, key=distance))


def _rule(wanted: Conditions, i: int, support: int | None, positive: bool) -> SpecialRule:
    """The rule of a special point on as few points as have one. Raises ImpossibleError, with the reason of the last."""
    count, right = len(wanted.left), wanted.right_side(i)
    last: SpecialRule | None = None
    for size in range(1, count + _MORE + 1) if support is None else (support,):
        for points in _windows(i, wanted.arity, size):
            optimum = largest_least_weight([wanted.column(j) for j in points], right)
            if optimum is None:
                continue
            row = tuple((j, w) for j, w in zip(points, optimum.weights, strict=True) if w)
            rule = SpecialRule(row, points, optimum)
            if not positive or optimum.least >= 0:
                return rule
            last = rule if last is None or len(points) > len(last.points) else last
    raise ImpossibleError(_why(wanted, i, last, support))


def _why(wanted: Conditions, i: int, last: SpecialRule | None, support: int | None) -> str:
    """The reason why a point has no rule: no weights meet the conditions, or a polynomial forbids positive ones."""
    degree = len(wanted.left) - 1
    if last is None:
        points = f"{support} points" if support is not None else "so few points"
        return f"point {i} has no rule on {points} with S Q = Q σ on degree {degree}"
    from subdiv_cli.model.formulas import polynomial

    y = last.optimum.multipliers
    scale = max(map(abs, y))
    g = polynomial(tuple(x / scale for x in y))
    points = f"{last.points[0]}, …, {last.points[-1]}"
    return (
        f"point {i} has no rule without negative weights on the old points {points}: "
        f"g = {g} has Q g ≥ 0 at all of them, and Q σ g = {last.optimum.least / scale} < 0 at {i}"
    )


def certificate_holds(wanted: Conditions, i: int, rule: SpecialRule) -> bool:
    """Whether the multipliers of a rule are what their description says: exactly, from Q alone."""
    y = rule.optimum.multipliers

    def value(column: Sequence[Fraction]) -> Fraction:
        return sum((a * b for a, b in zip(y, column, strict=True)), Fraction(0))

    values = [value(wanted.column(j)) for j in rule.points]
    return min(values) >= 0 and sum(values) == 1 and value(wanted.right_side(i)) == rule.optimum.least
