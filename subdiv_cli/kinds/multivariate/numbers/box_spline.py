"""Box splines, recognised from the mask alone.

With M^r = c I, c >= 2, φ is refinable by c I too, with the mask of S^r, Π_(i<r) a(z^(M^i)). Where that is c^(s-n) times
a monomial times Π_j (1 + z^ξ_j + … + z^((c-1)ξ_j)), φ is the box spline of the directions ξ_1, …, ξ_n, up to a shift.
With d the least number of directions whose removal leaves a set that does not span R^s, it is piecewise polynomial,
C^(d-2) and no smoother, and its Hölder exponent is d - 1 (de Boor, Höllig & Riemenschneider 1993, I.36 and I.41), for
stable masks and for others. Its translates are stable, and linearly independent, iff the directions are unimodular:
all s of them have the determinant -1, 0 or 1 (ibid., II.57; Dahmen & Micchelli 1983; Jia 1984).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from heapq import heappop, heappush
from itertools import combinations
from math import lcm
from typing import NamedTuple, TypeVar

from flint import fmpq_mat

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort
from subdiv_cli.spaces.lattice import Index, Lattice

_MOST_TERMS = 20_000
"""The most terms of the mask of S^r."""

Terms = Mapping[Index, Fraction]
Number = TypeVar("Number", int, Fraction)


class BoxSpline(NamedTuple):
    """A box spline φ: S^r has the dilation c I and the mask c^(s-n) z^shift Π_j (1 + z^ξ_j + … + z^((c-1)ξ_j))."""

    directions: tuple[Index, ...]
    """The directions ξ_1, …, ξ_n, sorted, each greater than 0 in lexicographic order."""
    power: int
    """The power r of S."""
    scale: int
    """The factor c of the dilation c I."""
    shift: Index

    @property
    def multiplicities(self) -> dict[Index, int]:
        """The different directions, sorted, with the number of times that each stands there."""
        return {xi: self.directions.count(xi) for xi in dict.fromkeys(self.directions)}

    @property
    def depth(self) -> int:
        """The number d of directions that must go until the others do not span; those in one hyperplane may stay."""
        count = self.multiplicities
        planes = combinations(sorted(count), len(self.shift) - 1)
        return len(self.directions) - max(
            sum(times for xi, times in count.items() if _rank((*some, xi)) <= _rank(some)) for some in planes
        )

    @property
    def is_unimodular(self) -> bool:
        """Whether the determinants of any s of the directions are -1, 0 or 1."""
        return all(abs(_determinant(some)) <= 1 for some in combinations(sorted({*self.directions}), len(self.shift)))


def box_spline(scheme: MultivariateScheme, lattice: Lattice, effort: Effort) -> BoxSpline | None:
    """The box spline that φ is; None where it is none, or where no power of M is a multiple of I.

    The lexicographically first two indices of the mask of S^r differ by the first direction: there nothing cancels.
    Raises ClockStruckError.
    """
    if lattice.scalar_power is None or lattice.scalar_power[1] < 2:
        return None
    power, c = lattice.scalar_power
    if (mask := iterated(scheme, lattice, power)) is None:
        return None
    common = lcm(*(x.denominator for x in mask.values()))
    rest: Mapping[Index, int] | None = {alpha: int(x * common) for alpha, x in mask.items()}
    directions: list[Index] = []
    while rest is not None and len(rest) > 1:
        effort.look()
        first, second = sorted(rest)[:2]
        directions.append(tuple(b - a for a, b in zip(first, second, strict=True)))
        rest = divided(rest, directions[-1], c)
    if rest is None or len(rest) > 1 or _rank(tuple(directions)) < lattice.dimension:
        return None
    ((shift, value),) = rest.items()
    if Fraction(value, common) != Fraction(c) ** (lattice.dimension - len(directions)):
        return None
    return BoxSpline(tuple(sorted(directions)), power, c, shift)


def iterated(scheme: MultivariateScheme, lattice: Lattice, times: int) -> dict[Index, Fraction] | None:
    """The mask of S^times, Π_(i<times) a(z^(M^i)); None where it is too long."""
    total: dict[Index, Fraction] = dict(scheme.terms)
    factor: dict[Index, Fraction] = dict(scheme.terms)
    for _ in range(times - 1):
        factor = {lattice.image(alpha): x for alpha, x in factor.items()}
        if len(total) * len(factor) > _MOST_TERMS:
            return None
        total = multiplied(total, factor)
    return total


def multiplied(a: Terms, b: Terms) -> dict[Index, Fraction]:
    """The product of two Laurent polynomials."""
    total: dict[Index, Fraction] = {}
    for alpha, x in a.items():
        for beta, y in b.items():
            index = tuple(i + j for i, j in zip(alpha, beta, strict=True))
            total[index] = total.get(index, Fraction(0)) + x * y
    return {index: x for index, x in total.items() if x}


def divided(a: Mapping[Index, Number], xi: Index, c: int) -> dict[Index, Number] | None:
    """The quotient a(z) / (1 + z^ξ + … + z^((c-1)ξ)), ξ > 0 lexicographically; None where it is no Laurent polynomial.

    Long division, the smallest index first. The quotient's indices, (c-1)ξ added, stay in the smallest box around a's.
    """
    columns = list(zip(*a, strict=True))
    lowest, highest = [min(column) for column in columns], [max(column) for column in columns]
    rest, quotient = dict(a), dict[Index, Number]()
    pending = sorted(rest)
    while pending:
        alpha = heappop(pending)
        value = rest.pop(alpha, None)
        if not value:
            continue
        quotient[alpha] = value
        last = [x + (c - 1) * t for x, t in zip(alpha, xi, strict=True)]
        if not all(low <= x <= high for low, x, high in zip(lowest, last, highest, strict=True)):
            return None
        for i in range(1, c):
            index = tuple(x + i * t for x, t in zip(alpha, xi, strict=True))
            if index not in rest:
                heappush(pending, index)
            rest[index] = rest.get(index, 0) - value
    return quotient


def _rank(vectors: tuple[Index, ...]) -> int:
    return int(fmpq_mat([list(v) for v in vectors]).rank()) if vectors else 0


def _determinant(vectors: tuple[Index, ...]) -> int:
    return int(fmpq_mat([list(v) for v in vectors]).det().p)
