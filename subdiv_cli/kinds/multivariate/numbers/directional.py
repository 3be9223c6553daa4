"""Directional factors of a mask with dilation c I, and the norms of the difference schemes that they give.

Where a(z) = d(z) (1 + z^θ + … + z^((c-1)θ)), Δ_θ S = S_d Δ_θ with (Δ_θ f)_α = f_(α+θ) - f_α, a shift aside, and
‖S_d^L‖∞ is the largest absolute coset sum mod c^L of Π_(i<L) d(z^(c^i)) (Dyn 1992, Proposition 6.10).

Quotients of a mask with dilation c I by pairs of directional factors, and their norms.

Where a(z) = d(z) G_θ(z) G_η(z), G_θ(z) = 1 + z^θ + … + z^((c-1)θ), ∇_θ ∇_η S = S_d ∇_θ ∇_η. The scheme of
a_θη = c d is that of the differences along η of c ∇_θ (Dyn 1992, Corollary 7.9).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import combinations
from typing import NamedTuple

from flint import fmpq_mat

from subdiv_cli.kinds.multivariate.numbers.box_spline import divided, multiplied
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort
from subdiv_cli.spaces.lattice import Index, Lattice, box

HIGHEST_LEVEL = 6
_MOST_DIRECTIONS = 2000
_LARGEST = 3
"""The largest entry, in modulus, of a direction that is tried."""


class Contraction(NamedTuple):
    """A contraction ‖S_d^level‖∞ = norm < 1 for the quotient d of the mask by the factor of the direction."""

    direction: Index
    quotient: Mapping[Index, Fraction]
    level: int
    norm: Fraction


def directional_factors(scheme: MultivariateScheme, c: int) -> dict[Index, dict[Index, Fraction]]:
    """The directions θ > 0 (in lexicographic order) whose factor divides the mask, with the quotients.

    Directions of entries at most `_LARGEST` in modulus; primitive and others.
    """
    lowest, highest = scheme.bounds()
    reach = [min(_LARGEST, (b - a) // (c - 1)) for a, b in zip(lowest, highest, strict=True)]
    quotients: dict[Index, dict[Index, Fraction]] = {}
    tried = 0
    for theta in box(tuple(-r for r in reach), tuple(reach)):
        if theta <= (0,) * len(theta) or tried >= _MOST_DIRECTIONS:
            continue
        tried += 1
        if (quotient := divided(scheme.terms, theta, c)) is not None:
            quotients[theta] = quotient
    return quotients


def factored(scheme: MultivariateScheme, lattice: Lattice) -> tuple[dict[Index, int], Mapping[Index, Fraction]]:
    """The number of times that the factor of each direction divides the mask, and the quotient by all of them.

    Short directions come first. No factors where M is not c I, c >= 2.
    """
    power, c = lattice.scalar_power or (0, 0)
    rest, counted = scheme.terms, dict[Index, int]()
    if power != 1 or c < 2:
        return counted, rest
    for theta in sorted(directional_factors(scheme, c), key=lambda theta: (sum(map(abs, theta)), theta)):
        while len(rest) > 1 and (quotient := divided(rest, theta, c)) is not None:
            counted[theta], rest = counted.get(theta, 0) + 1, quotient
    return counted, rest


def norms(quotient: Mapping[Index, Fraction], c: int, effort: Effort) -> Iterator[Fraction]:
    """The norms ‖S_d‖∞, ‖S_d^2‖∞, … as far as the effort goes; work is counted in products of coefficients."""
    iterated: Mapping[Index, Fraction] = {(0,) * len(next(iter(quotient))): Fraction(1)}
    spent, step = 0, 1
    while True:
        spent += len(iterated) * len(quotient)
        if not effort.allows(spent):
            return
        iterated = multiplied(iterated, {tuple(step * x for x in alpha): y for alpha, y in quotient.items()})
        step *= c
        sums: dict[Index, Fraction] = {}
        for alpha, x in iterated.items():
            coset = tuple(y % step for y in alpha)
            sums[coset] = sums.get(coset, Fraction(0)) + abs(x)
        yield max(sums.values())


def contractions(scheme: MultivariateScheme, lattice: Lattice, effort: Effort) -> tuple[Contraction, ...] | None:
    """The contractions for the first s directions of determinant ±1, with a level each; None unless all contract."""
    if lattice.scalar_power is None or lattice.scalar_power[0] != 1:
        return None
    c = lattice.scalar_power[1]
    if c < 2:
        return None
    factors = directional_factors(scheme, c)
    for some in combinations(sorted(factors, key=lambda theta: (sum(map(abs, theta)), theta)), lattice.dimension):
        if abs(int(fmpq_mat([list(theta) for theta in some]).det().p)) == 1:
            each = [contraction(theta, factors[theta], c, effort) for theta in some]
            known = tuple(contracts for contracts in each if contracts is not None)
            return known if len(known) == len(some) else None
    return None


def contraction(theta: Index, quotient: Mapping[Index, Fraction], c: int, effort: Effort) -> Contraction | None:
    """The contraction of the quotient's scheme at the first level that has one; None where no level does."""
    for level, norm in enumerate(norms(quotient, c, effort), 1):
        if norm < 1:
            return Contraction(theta, quotient, level, norm)
        if level == HIGHEST_LEVEL:
            break
    return None


_MOST_PAIRED_DIRECTIONS = 8


class PairContraction(NamedTuple):
    """A contraction ‖S_(cd)^level‖∞ = norm < 1 for the quotient d of the mask by the factors of two directions."""

    directions: tuple[Index, Index]
    quotient: Mapping[Index, Fraction]
    level: int
    norm: Fraction


def pair_contractions(
    scheme: MultivariateScheme, lattice: Lattice, effort: Effort
) -> tuple[PairContraction, ...] | None:
    """The contractions for all pairs of s+1 directions, any s of determinant ±1, whose factors divide the mask.

    All factors together must divide it. None where there are no such directions or not all pairs contract; the first
    such directions, short ones before long ones, are looked at.
    """
    counted, _ = factored(scheme, lattice)
    s = lattice.dimension
    for some in combinations(list(counted)[:_MOST_PAIRED_DIRECTIONS], s + 1):
        if all(abs(int(fmpq_mat([list(x) for x in part]).det().p)) == 1 for part in combinations(some, s)):
            c = (lattice.scalar_power or (0, 0))[1]
            contractions = []
            for pair in combinations(some, 2):
                if (contracts := _contraction(scheme, pair, c, effort)) is None:
                    return None
                contractions.append(contracts)
            return tuple(contractions)
    return None


def _contraction(scheme: MultivariateScheme, pair: tuple[Index, ...], c: int, effort: Effort) -> PairContraction | None:
    first, second = pair
    once = divided(scheme.terms, first, c)
    quotient = None if once is None else divided(once, second, c)
    if quotient is None:
        return None
    contracts = contraction(first, {alpha: c * x for alpha, x in quotient.items()}, c, effort)
    return None if contracts is None else PairContraction((first, second), quotient, contracts.level, contracts.norm)
