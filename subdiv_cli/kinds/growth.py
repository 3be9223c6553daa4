"""The growth of transition operators on invariant spaces of sequences, as all kinds with limit stencils use it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

from subdiv_cli.jsr.family import Family, Word
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius
from subdiv_cli.model import Effort
from subdiv_cli.spaces.stencils import SequenceSpace, StencilSpaces

_TIE = 1e-6


class SequenceGrowth(NamedTuple):
    """An invariant space of sequences, and the joint spectral radius of the transition operators on it."""

    order: int
    """The order k of differences of limit stencils, 0 for the space of all sequences that die out."""
    on: SequenceSpace
    radius: Radius
    product: WordProduct | None
    """A product that bounds the radius from below."""


def growth_on(order: int, on: SequenceSpace | None, effort: Effort) -> SequenceGrowth | None:
    """The growth on a space; None without one, on the space 0, and where the effort ends before a bound."""
    from subdiv_cli.jsr.radius import joint_spectral_radius  # numpy comes with it

    if on is None or not on.space.dimension:
        return None
    matrices = on.space.matrices
    radius = joint_spectral_radius(Family(matrices), effort)
    if radius is None:
        return None
    product = None if radius.word is None else WordProduct.of_word(matrices, radius.word)
    return SequenceGrowth(order, on, radius, product)


def first_above(
    spaces: StencilSpaces, orders: Iterable[int], longest: int
) -> tuple[int, SequenceSpace, tuple[Word, ...]] | None:
    """The first of the orders k that is above the Hölder exponent of a scheme that converges, V_k(w), and products.

    Products of at most `longest` letters tell so, in floats: those of the largest radii. That it is so is the caller's
    to prove. None where no k is, or the spaces are too large before.
    """
    from subdiv_cli.jsr.search import candidates  # numpy comes with it

    lattice = spaces.operators.lattice
    unit = math.log2(lattice.index) / lattice.dimension
    for k in orders:
        on = spaces.differences(k)
        if on is None or not on.space.dimension:
            return None
        family = Family(on.space.matrices)
        rate, best = candidates(family, longest)
        if rate > 0 and math.log2(rate) + math.log2(family.unit) > -(k - _TIE) * unit:
            return k, on, tuple(candidate.word for candidate in best)
    return None
