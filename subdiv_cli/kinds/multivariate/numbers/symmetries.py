"""Facts of a mask in several variables, seen without a theorem: its dilation, support, signs and symmetries."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator
from itertools import permutations, product
from operator import mul
from typing import TYPE_CHECKING

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Data
from subdiv_cli.spaces.lattice import IntMatrix, characteristic_polynomial, multiple_of_identity, times

if TYPE_CHECKING:
    from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers


def facts(numbers: MultivariateNumbers) -> dict[str, Data]:
    """The facts of a mask by name: dimension, dilation, cosets, isotropic, lowest and highest, coefficients and so on.

    `cosets`, `coefficients` and `symmetries` are numbers of these, `lowest` and `highest` the corners of the support's
    box; the others are interpolatory and nonnegative.
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
        "symmetries": len(numbers.symmetries),
        "interpolatory": numbers.is_interpolatory,
        "nonnegative": all(x >= 0 for x in scheme.terms.values()),
    }


def symmetries(scheme: MultivariateScheme) -> tuple[IntMatrix, ...]:
    """The matrices g of determinant ±1 with a_(g α + t) = a_α for some t and all α, the identity among them.

    In the plane those of entries -1, 0, 1; in more variables signed permutations.
    """
    candidates = tuple(_candidates(scheme.dimension))
    known, group = set(candidates), {multiple_of_identity(1, scheme.dimension)}
    for g in candidates:
        if g not in group and _keeps(scheme, g):
            group = generated([*group, g], known)
    return tuple(g for g in candidates if g in group)


def generated(matrices: Iterable[IntMatrix], within: Container[IntMatrix]) -> set[IntMatrix]:
    """The products of the matrices, as long as they are `within`; the group where this is finite and closed."""
    generators: list[IntMatrix] = []
    group: set[IntMatrix] = set()
    for g in matrices:
        if g in group:
            continue
        generators.append(g)
        last = group | {g}
        while last:
            group |= last
            last = {h for f in last for x in generators if (h := times(f, x)) in within} - group
    return group


def _keeps(scheme: MultivariateScheme, g: IntMatrix) -> bool:
    """Whether a_(g α + t) = a_α for the t that keeps the centre of the support."""
    count, total = len(scheme.terms), [sum(column) for column in zip(*scheme.terms, strict=True)]
    shift = [x - sum(map(mul, row, total)) for x, row in zip(total, g, strict=True)]
    if any(x % count for x in shift):
        return False
    rows = [(row, x // count) for row, x in zip(g, shift, strict=True)]
    return all(
        scheme.terms.get(tuple([sum(map(mul, row, alpha)) + t for row, t in rows])) == value
        for alpha, value in scheme.terms.items()
    )


def _candidates(s: int) -> Iterator[IntMatrix]:
    if s == 2:
        for a, b, c, d in product((-1, 0, 1), repeat=4):
            if abs(characteristic_polynomial(((a, b), (c, d)))[0]) == 1:
                yield (a, b), (c, d)
        return
    for places in permutations(range(s)):
        for signs in product((1, -1), repeat=s):
            yield tuple(tuple(sign * (j == place) for j in range(s)) for place, sign in zip(places, signs, strict=True))
