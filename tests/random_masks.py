"""Random masks near the critical radius: smoothing factors times a cofactor, with unstable variants among them."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TypeVar

from subdiv_cli.kinds.multivariate.numbers.box_spline import multiplied
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.spaces.lattice import Index, IntMatrix, Lattice

DILATIONS: tuple[IntMatrix, ...] = (
    ((2, 0), (0, 2)),
    ((1, -1), (1, 1)),
    ((0, 2), (1, 0)),
    ((0, -2), (1, 1)),
    ((5, 23), (-1, -5)),
    ((1, 2), (-2, -1)),
    ((2, 1), (0, 3)),
    ((3, 0), (0, 3)),
)
"""Multiples of I, quincunx-like and skew ones, and one that is not isotropic."""
_DIRECTIONS = ((1, 0), (0, 1), (1, 1), (1, -1))
Mask = TypeVar("Mask", ScalarScheme, MultivariateScheme)


def random_scalar(rng: random.Random) -> ScalarScheme:
    """A mask of arity 2 or 3 with some sum rules, times g(z^p)/g(z), g = z^n - 1, one time in four."""
    p = rng.choice((2, 2, 2, 3))
    mask = {at: p * x for at, x in _cofactor(rng, [(i,) for i in range(rng.randint(1, 4))]).items()}
    smoothing = {(i,): Fraction(1, p) for i in range(p)}
    for _ in range(rng.randint(1, 4)):
        mask = multiplied(mask, smoothing)
    if rng.random() < 0.25:
        n = rng.choice((3, 5) if p == 2 else (2, 4))
        mask = multiplied(mask, {(n * i,): x for (i,), x in smoothing.items()})
    low, high = min(mask)[0], max(mask)[0]
    coefficients = tuple(mask.get((i,), Fraction(0)) for i in range(low, high + 1))
    return ScalarScheme(arity=p, start=low + rng.randint(-3, 3), coefficients=coefficients)


def random_multivariate(rng: random.Random, dilations: Sequence[IntMatrix] = DILATIONS) -> MultivariateScheme:
    """A mask in two variables with some sum rules, one of two directions with a determinant of 2 among the factors."""
    dilation = rng.choice(dilations)
    lattice = Lattice(dilation)
    m, (power, c) = lattice.index, lattice.scalar_power or (0, 0)
    places = [(rng.randint(-1, 1), rng.randint(-1, 1)) for _ in range(rng.randint(1, 3))]
    mask = {at: m * x for at, x in _cofactor(rng, places).items()}
    for _ in range(rng.randint(1, 2)):
        if power == 1 and rng.random() < 0.6:
            for theta in rng.sample(_DIRECTIONS, 2):
                mask = multiplied(mask, {tuple(i * x for x in theta): Fraction(1, c) for i in range(c)})
        else:
            mask = multiplied(mask, dict.fromkeys(lattice.representatives, Fraction(1, m)))
    return MultivariateScheme(dilation=dilation, terms=mask)


def _cofactor(rng: random.Random, places: Sequence[Index]) -> dict[Index, Fraction]:
    """Coefficients at these places that add up to 1, between one place alone and arbitrary ones."""
    while True:
        values = {at: Fraction(rng.randint(-4, 4), rng.choice((1, 2, 3))) for at in places}
        if total := sum(values.values()):
            break
    share, alone = Fraction(rng.randint(0, 8), 8), rng.choice(places)
    mixed = {at: share * x / total + (1 - share) * (at == alone) for at, x in values.items()}
    return {at: x for at, x in mixed.items() if x}


def moved(mask: Mask, by: Index) -> Mask:
    """The mask shifted; one in one variable by the first number."""
    if isinstance(mask, ScalarScheme):
        return ScalarScheme(arity=mask.arity, start=mask.start + by[0], coefficients=mask.coefficients)
    terms: Mapping[Index, Fraction] = {
        tuple(i + j for i, j in zip(at, by, strict=True)): x for at, x in mask.terms.items()
    }
    return MultivariateScheme(dilation=mask.dilation, terms=terms)
