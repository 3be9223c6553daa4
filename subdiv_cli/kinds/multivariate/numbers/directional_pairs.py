"""Quotients of a mask with dilation c I by pairs of directional factors, and their norms.

Where a(z) = d(z) G_θ(z) G_η(z), G_θ(z) = 1 + z^θ + … + z^((c-1)θ), ∇_θ ∇_η S = S_d ∇_θ ∇_η. The scheme of
a_θη = c d is that of the differences along η of c ∇_θ (Dyn 1992, Corollary 7.9).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import combinations
from typing import NamedTuple

from flint import fmpq_mat

from subdiv_cli.kinds.multivariate.lattice import Lattice
from subdiv_cli.kinds.multivariate.numbers.box_spline import divided
from subdiv_cli.kinds.multivariate.numbers.directional import contraction, factored
from subdiv_cli.kinds.multivariate.scheme import Index, MultivariateScheme
from subdiv_cli.model import Effort

_MOST_DIRECTIONS = 8


class PairContraction(NamedTuple):
    """‖S_(cd)^level‖∞ = norm < 1 for the quotient d of the mask by the factors of two directions."""

    directions: tuple[Index, Index]
    quotient: Mapping[Index, Fraction]
    level: int
    norm: Fraction


def pair_contractions(
    scheme: MultivariateScheme, lattice: Lattice, effort: Effort
) -> tuple[PairContraction, ...] | None:
    """For s+1 directions, any s of determinant ±1, whose factors together divide the mask: all pairs, contracting.

    None without; the first such directions, short ones before long ones, are looked at.
    """
    counted, _ = factored(scheme, lattice)
    s = lattice.dimension
    for some in combinations(list(counted)[:_MOST_DIRECTIONS], s + 1):
        if all(abs(int(fmpq_mat([list(x) for x in part]).det().p)) == 1 for part in combinations(some, s)):
            c = (lattice.scalar_power or (0, 0))[1]
            found = []
            for pair in combinations(some, 2):
                if (contracts := _contraction(scheme, pair, c, effort)) is None:
                    return None
                found.append(contracts)
            return tuple(found)
    return None


def _contraction(scheme: MultivariateScheme, pair: tuple[Index, ...], c: int, effort: Effort) -> PairContraction | None:
    first, second = pair
    once = divided(scheme.terms, first, c)
    quotient = None if once is None else divided(once, second, c)
    if quotient is None:
        return None
    found = contraction(first, {alpha: c * x for alpha, x in quotient.items()}, c, effort)
    return None if found is None else PairContraction((first, second), quotient, found.level, found.norm)
