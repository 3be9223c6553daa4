"""Control nets on Z^2, refined: (S f)_α = Σ_β a_(α-Mβ) f_β where all f_β of the rule are given."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from fractions import Fraction
from math import lcm

from subdiv_cli.kinds.multivariate.numbers.directional import directional_factors
from subdiv_cli.kinds.multivariate.numbers.symmetries import symmetries
from subdiv_cli.kinds.multivariate.numbers.values import MOST_PRODUCTS, NoValuesError
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.spaces.lattice import Index, Lattice

Vertices = Mapping[Index, tuple[Fraction, ...]]

_TURNS = {(1, 1): ((1, -1), (1, 0)), (1, -1): ((1, 1), (-1, 0))}
"""The third direction d -> a linear map of order 6 that takes e_1, e_2, d and their opposites around."""


def refined(scheme: MultivariateScheme, lattice: Lattice, net: Vertices, levels: int) -> Vertices:
    """The net S^levels of a net: the new vertices whose rule uses given ones alone, exactly.

    Raises NoValuesError for a net that determines no vertex of a level, and for one that is too large.
    """
    mask_denominator = lcm(*(x.denominator for x in scheme.terms.values()))
    mask = [(gamma, int(x * mask_denominator)) for gamma, x in scheme.terms.items()]
    uses = Counter(lattice.coset(gamma) for gamma in scheme.terms)
    denominator = lcm(*(x.denominator for vertex in net.values() for x in vertex))
    points = {beta: tuple(int(x * denominator) for x in vertex) for beta, vertex in net.items()}
    for level in range(1, levels + 1):
        if len(points) * len(mask) > MOST_PRODUCTS // 2:
            raise NoValuesError(f"the net of level {level} is too large")
        points = _step(lattice, mask, uses, points)
        if not points:
            raise NoValuesError(f"the net is too small: it determines no vertex of level {level}")
        denominator *= mask_denominator
    return {alpha: tuple(Fraction(x, denominator) for x in vertex) for alpha, vertex in points.items()}


def _step(
    lattice: Lattice,
    mask: list[tuple[Index, int]],
    uses: Mapping[Index, int],
    points: Mapping[Index, tuple[int, ...]],
) -> dict[Index, tuple[int, ...]]:
    """The numerators of the next level; `uses` has for each coset how many vertices its rule uses."""
    sums: dict[Index, list[int]] = {}
    used: Counter[Index] = Counter()
    for beta, vertex in points.items():
        image = lattice.image(beta)
        for gamma, a in mask:
            alpha = tuple(x + g for x, g in zip(image, gamma, strict=True))
            used[alpha] += 1
            total = sums.setdefault(alpha, [0] * len(vertex))
            for i, x in enumerate(vertex):
                total[i] += a * x
    whole = (alpha for alpha, count in used.items() if count == uses[lattice.coset(alpha)])
    return {alpha: tuple(sums[alpha]) for alpha in whole}


def diagonal(scheme: MultivariateScheme, lattice: Lattice) -> tuple[int, int] | None:
    """The third direction of a mask made for a mesh of triangles, (1, 1) or (1, -1); None for one of quadrilaterals.

    The mask has the symmetry of that mesh, or of these two directional factors the one alone.
    """
    turns = symmetries(scheme)
    for direction, turn in _TURNS.items():
        if turn in turns:
            return direction
    if lattice.scalar_power is None or lattice.scalar_power[0] > 1 or lattice.scalar_power[1] < 2:
        return None
    factors = directional_factors(scheme, lattice.scalar_power[1])
    diagonals = [direction for direction in _TURNS if direction in factors]
    return diagonals[0] if len(diagonals) == 1 else None
