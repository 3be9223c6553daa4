"""A search for special rules with a larger exponent at 0, among those with S Q = Q σ on the same polynomials.

Each special rule may read a few points more; its weights then have free parameters. They are moved in steps that are
halved, one parameter at a time and in a few random directions, as long as the largest eigenvalue near 0 that belongs to
no polynomial of Q falls. Eigenvalues are balls; what comes of it is checked by the stages as any scheme is.
"""

from __future__ import annotations

import random
from collections.abc import Generator, Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from flint import fmpq_mat

from subdiv_cli.exact.algebraic import roots
from subdiv_cli.exact.linalg import Vector, matrix, nullspace
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.kinds.piecewise.blend import Blend, Conditions, SpecialRule
from subdiv_cli.kinds.piecewise.numbers.functionals import attractor, cells_of, window_of
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme, Row
from subdiv_cli.model import Effort, watch

_MORE = (1, 2)
"""The points that special rules read more than they must, at either end by turns."""
_STEPS = 5
_FIRST = Fraction(1, 8)
_DIRECTIONS = 6
_COST = 12
"""The cost of one set of eigenvalues, in the count of effort."""


class FreeRule(NamedTuple):
    """The rules of a special point with the same conditions: weights on some points, and how they may change."""

    points: range
    weights: Vector
    changes: tuple[Vector, ...]

    def row(self, parameters: Mapping[int, Fraction], first: int) -> Row:
        """The row where the change number k has the parameter number first + k."""
        total = list(self.weights)
        for k, change in enumerate(self.changes, first):
            if x := parameters.get(k):
                total = [w + x * c for w, c in zip(total, change, strict=True)]
        return tuple((j, w) for j, w in zip(self.points, total, strict=True) if w)


def improved(blend: Blend, wanted: Conditions, effort: Effort, positive: bool) -> Iterator[PiecewiseScheme]:
    """The schemes with a larger exponent at 0 than the one given, as balls see it: the best ones of each search."""
    watch.begin("special rules")
    counted = 0
    for more in _MORE:
        free = {i: _freed(wanted, i, rule, more) for i, rule in blend.rules.items()}
        search = _RuleSearch(blend, free, positive)
        if search.count:
            counted = yield from search.run(effort, counted)


def _freed(wanted: Conditions, i: int, rule: SpecialRule, more: int) -> FreeRule:
    """The rules of a point on some points more."""
    first, last = rule.points[0], rule.points[-1]
    outwards = 2 * Fraction(i, wanted.arity) < first + last
    before, after = (more + 1) // 2, more // 2
    if not outwards:
        before, after = after, before
    points = range(first - before, last + after + 1)
    known = dict(rule.row)
    changes = nullspace(matrix(list(zip(*(wanted.column(j) for j in points), strict=True))))
    return FreeRule(points, tuple(known.get(j, Fraction(0)) for j in points), changes)


class _RuleSearch:
    """One search from the rules of a blend."""

    def __init__(self, blend: Blend, free: Mapping[int, FreeRule], positive: bool) -> None:
        self._blend, self._free, self._positive = blend, free, positive
        self.count = sum(len(rule.changes) for rule in free.values())

    def scheme(self, parameters: Mapping[int, Fraction]) -> PiecewiseScheme:
        """The scheme at some parameters."""
        base, rows, first = self._blend.scheme, dict(self._blend.scheme.special), 0
        for i, rule in self._free.items():
            rows[i] = rule.row(parameters, first)
            first += len(rule.changes)
        return PiecewiseScheme(base.left, base.right, base.spacing, tuple(rows.items()))

    def size(self, parameters: Mapping[int, Fraction]) -> float | None:
        """The largest eigenvalue near 0 but those of polynomials, in floats; None for rules that are not allowed."""
        scheme = self.scheme(parameters)
        if self._positive and any(w < 0 for i in self._free for _, w in dict(scheme.special).get(i, ())):
            return None
        window = window_of(scheme, cells_of(scheme))
        if window is None:
            return None
        points = attractor(scheme, window)
        places = {j: k for k, j in enumerate(points)}
        a = fmpq_mat(len(points), len(points))
        for i in points:
            for j, w in scheme.row(i):
                a[places[i], places[j]] = to_fmpq(w)
        p, f = scheme.arity, a.charpoly()
        for d in range(self._blend.degree + 1):
            quotient, rest = divmod(f, type(f)([to_fmpq(-Fraction(1, p**d)), 1]))
            f = f if rest else quotient
        return float(roots(f)[0][0].region.__abs__().mid()) if f.degree() else 0.0

    def run(self, effort: Effort, counted: int) -> Generator[PiecewiseScheme, None, int]:
        """The best scheme of steps that are halved, if it is better; returns how many sets of eigenvalues it took."""
        rng = random.Random(self.count)
        now: dict[int, Fraction] = {}
        best = start = self.size(now)
        step = _FIRST
        for _ in range(_STEPS):
            moved = True
            while moved:
                moved = False
                for direction in self._directions(rng):
                    counted += 1
                    watch.count(counted, "sets of rules")
                    if best is None or not effort.allows(_COST * counted):
                        break
                    tried = {k: now.get(k, Fraction(0)) + step * direction.get(k, 0) for k in {*now, *direction}}
                    size = self.size(tried)
                    if size is not None and size < best * (1 - 1e-9):
                        now, best, moved = tried, size, True
            step /= 2
        if best is not None and start is not None and best < start:
            yield self.scheme(now)
        return counted

    def _directions(self, rng: random.Random) -> Iterator[dict[int, int]]:
        """Each parameter up and down, and some directions at random."""
        for k in range(self.count):
            yield {k: 1}
            yield {k: -1}
        for _ in range(_DIRECTIONS):
            yield {k: rng.choice((-1, 0, 1)) for k in range(self.count)}
