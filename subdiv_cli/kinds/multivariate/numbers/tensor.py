"""Tensor products: masks a(z) = Π_j a_j(z_(P_j)) over a partition of the variables, M block diagonal for it.

Then φ(x) = Π_j φ_j(x_(P_j)) (Dyn 1992, Proposition 6.3), the φ_j those of masks with coefficients that add up to
m_j = |det M_j|. The factorisation is exact, and its parts are the smallest there are.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import combinations
from typing import NamedTuple

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.spaces.lattice import Index, Lattice

Variables = tuple[int, ...]
Terms = Mapping[Index, Fraction]


class TensorFactor(NamedTuple):
    """A factor of a mask, and its variables, rising."""

    variables: Variables
    scheme: ScalarScheme | MultivariateScheme


def tensor_factors(scheme: MultivariateScheme, lattice: Lattice) -> tuple[TensorFactor, ...]:
    """The factors of a mask whose coefficients add up to |det M|: two or more, or none."""
    if sum(scheme.terms.values()) != lattice.index:
        return ()
    parts = _finest(_blocks(scheme), scheme.terms)
    if len(parts) < 2:
        return ()
    factors = [_factor(scheme, variables) for variables in parts]
    return tuple(factor for factor in factors if factor is not None) if None not in factors else ()


def _blocks(scheme: MultivariateScheme) -> list[Variables]:
    """The finest partition of the variables for which M is block diagonal."""
    blocks = [{i} for i in range(scheme.dimension)]
    for i, row in enumerate(scheme.dilation):
        for j, x in enumerate(row):
            if x:
                joined = [block for block in blocks if block & {i, j}]
                blocks = [block for block in blocks if not block & {i, j}] + [set().union(*joined)]
    return sorted(tuple(sorted(block)) for block in blocks)


def _finest(blocks: list[Variables], terms: Terms) -> list[Variables]:
    """The unions of blocks over which the mask is a product: a smallest one with the first block, then the rest's."""
    if not blocks:
        return []
    first, rest = blocks[0], blocks[1:]
    for count in range(len(rest)):
        for others in combinations(rest, count):
            part = tuple(sorted(sum(others, first)))
            if _splits(terms, part):
                return [part, *_finest([block for block in rest if block not in others], terms)]
    return [tuple(sorted(sum(rest, first)))]


def _splits(terms: Terms, variables: Variables) -> bool:
    """Whether a_(x,y) = f_x g_y, x the coordinates of these variables: a matrix of rank one."""
    pairs = {_taken(alpha, variables): value for alpha, value in terms.items()}
    rows = {x for x, _ in pairs}
    columns = {y for _, y in pairs}
    if len(rows) * len(columns) != len(pairs):
        return False
    x0, y0 = next(iter(pairs))
    corner = pairs[x0, y0]
    return all(value * corner == pairs[x, y0] * pairs[x0, y] for (x, y), value in pairs.items())


def _taken(alpha: Index, variables: Variables) -> tuple[Index, Index]:
    """The coordinates of these variables, and the others."""
    kept = tuple(alpha[i] for i in variables)
    return kept, tuple(x for i, x in enumerate(alpha) if i not in variables)


def _factor(scheme: MultivariateScheme, variables: Variables) -> TensorFactor | None:
    """The factor in these variables: the sums over the other variables, scaled; None for a negative arity."""
    rows = tuple(tuple(scheme.dilation[i][j] for j in variables) for i in variables)
    index = Lattice(rows).index
    sums: dict[Index, Fraction] = {}
    for alpha, value in scheme.terms.items():
        x, _ = _taken(alpha, variables)
        sums[x] = sums.get(x, Fraction(0)) + value
    scale = index / sum(sums.values(), Fraction(0))
    terms = {x: scale * value for x, value in sums.items()}
    if len(variables) > 1:
        return TensorFactor(variables, MultivariateScheme(dilation=rows, terms=terms))
    if rows[0][0] < 2:
        return None
    low, high = min(terms)[0], max(terms)[0]
    coefficients = tuple(terms.get((i,), Fraction(0)) for i in range(low, high + 1))
    return TensorFactor(variables, ScalarScheme(arity=rows[0][0], start=low, coefficients=coefficients))
