"""Facts of a mask in several variables, seen without a theorem: its dilation, support, signs and symmetries."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations, product

from subdiv_cli.model import Data
from subdiv_cli.quantities.multivariate import MultivariateNumbers
from subdiv_cli.schemes.multivariate import IntMatrix, MultivariateScheme, characteristic_polynomial


def facts(numbers: MultivariateNumbers) -> dict[str, Data]:
    """Keys: dimension, dilation, cosets (their number), isotropic, lowest and highest (corners of the support's box),
    coefficients (their number), symmetries (the number of `symmetries`), interpolatory and nonnegative.
    """
    scheme = numbers.scheme
    lowest, highest = scheme.bounds()
    return {
        "dimension": numbers.dimension,
        "dilation": scheme.dilation,
        "cosets": numbers.lattice.index,
        "isotropic": numbers.lattice.is_isotropic,
        "lowest": lowest,
        "highest": highest,
        "coefficients": len(scheme.terms),
        "symmetries": len(symmetries(scheme)),
        "interpolatory": numbers.is_interpolatory,
        "nonnegative": all(x >= 0 for x in scheme.terms.values()),
    }


def symmetries(scheme: MultivariateScheme) -> tuple[IntMatrix, ...]:
    """The matrices g of determinant ±1 with a_(g α + t) = a_α for some t and all α, the identity among them.

    In the plane those of entries -1, 0, 1; in more variables signed permutations.
    """
    kept = sorted(scheme.terms.items())
    found = []
    for g in _candidates(scheme.dimension):
        turned = sorted(
            (tuple(sum(x * y for x, y in zip(row, alpha, strict=True)) for row in g), x) for alpha, x in kept
        )
        first, to = turned[0][0], kept[0][0]
        shift = [b - a for a, b in zip(first, to, strict=True)]
        if [(tuple(x + t for x, t in zip(alpha, shift, strict=True)), x) for alpha, x in turned] == kept:
            found.append(g)
    return tuple(found)


def _candidates(s: int) -> Iterator[IntMatrix]:
    if s == 2:
        for a, b, c, d in product((-1, 0, 1), repeat=4):
            if abs(characteristic_polynomial(((a, b), (c, d)))[0]) == 1:
                yield (a, b), (c, d)
        return
    for places in permutations(range(s)):
        for signs in product((1, -1), repeat=s):
            yield tuple(tuple(sign * (j == place) for j in range(s)) for place, sign in zip(places, signs, strict=True))
