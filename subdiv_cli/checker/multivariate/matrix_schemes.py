"""Norms of matrix schemes of differences on Z^s (Dyn 1992, 6.8 to 6.10, 7.5; any M and order). See FORMAT.md."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from math import comb, lcm, prod

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.multivariate.differences import difference
from subdiv_cli.checker.multivariate.lattice import DilationMatrix, Index, Sparse, monomials, multiply
from subdiv_cli.checker.multivariate.masks import mask_of
from subdiv_cli.checker.reading import Rejected, require, require_few
from subdiv_cli.checker.scalar.symbols import MAX_LEVEL

MAX_COMPONENTS = 35
"""The most ν with |ν| = k."""
MAX_COEFFICIENTS = 40_000
"""The most coefficients of the matrix."""
MAX_MODULUS = 1 << 24
"""The largest m^level."""

Entries = list[list[Sparse]]
"""The numerators of a square matrix of Laurent polynomials."""


def matrix_norm(c: Claim) -> None:
    """ρ_k^L <= x = ‖S_Q^t‖∞, L = rt: (1-z)^μ a^[r](z) = Σ_ν q_μν(z) (1-z^M^r)^ν, |μ| = |ν| = k <= order of sum rules.

    x is the largest Σ_ν Σ_β |coefficients| of Q(z) Q(z^M^r) … Q(z^M^(r(t-1))) in a row, over a coset of M^L Z^s.
    """
    a, k, level = mask_of(c), c.statement["order"], c.statement["level"]
    power, s = c.witness["power"], a.dilation.dimension
    order = c.use("total-sum-rules").statement["order"]
    require(1 <= k <= order, f"the sum rules are of order {order}")
    require(1 <= level <= MAX_LEVEL, f"the level is not one of 1, …, {MAX_LEVEL}")
    require(power > 0 and level % power == 0, "the power does not divide the level")
    require_few(a.dilation.cosets**level <= MAX_MODULUS, "the level is too high")
    require_few(comb(k + s - 1, s - 1) <= MAX_COMPONENTS, "there are too many differences of the order")
    orders = list(monomials(s, k))
    q, denominator = _entries(c.witness["entries"], s, len(orders))
    steps = [[[int(i == j) for j in range(s)] for i in range(s)]]
    for _ in range(level):
        steps.append(matrices.multiply(a.dilation.rows, steps[-1]))
    done = _reduces(c, orders, q, denominator, steps[: power + 1])
    product = q
    for i in range(power, level, power):
        factor = [[_spread(f, steps[i]) for f in row] for row in q]
        done += sum(len(f) * len(g) for row in product for j, f in enumerate(row) for g in factor[j])
        c.count(done, _bits(product) + _bits(q))
        product = _multiplied(product, factor)
    c.count(done + sum(len(f) for row in product for f in row), _bits(product))
    largest, x = _largest_sum(product, steps[level]), c.statement["norm"]
    require(x.numerator * denominator ** (level // power) == largest * x.denominator, "the norm is another")


def _entries(rows: Sequence[Sequence[tuple[Index, Fraction]]], s: int, size: int) -> tuple[Entries, int]:
    """The matrix of Laurent polynomials by rows, over one denominator."""
    require(len(rows) == size**2, f"the matrix has not {size}^2 entries")
    require_few(sum(map(len, rows)) <= MAX_COEFFICIENTS, "the matrix has too many coefficients")
    common = 1
    for terms in rows:
        for x, value in terms:
            require(len(x) == s, f"an index is not one of Z^{s}")
            require(bool(value), "a coefficient is zero")
            common = lcm(common, value.denominator)
            require_few(common.bit_length() <= 1 << 16, "the common denominator is too large")
        require(all(x < y for (x, _), (y, _) in pairwise(terms)), "indices do not increase")
    flat = [{x: value.numerator * (common // value.denominator) for x, value in terms} for terms in rows]
    return [flat[i : i + size] for i in range(0, size**2, size)], common


def _reduces(c: Claim, orders: list[Index], q: Entries, denominator: int, steps: Sequence[matrices.Matrix]) -> int:
    """The number of products of two terms that it takes to check the identity, for all μ."""
    a, power = mask_of(c), len(steps) - 1
    symbol, done = a.terms, 0
    for i in range(1, power):
        done += len(symbol) * len(a.terms)
        c.count(done, power * (a.bits + len(a.terms).bit_length()))
        symbol = multiply(symbol, _spread(a.terms, steps[i]))
    corners = [prod(x + 1 for x in mu) for mu in orders]
    done += len(symbol) * sum(corners) + sum(len(f) * n for row in q for f, n in zip(row, corners, strict=True))
    c.count(done, power * (a.bits + len(a.terms).bit_length()) + _bits(q) + denominator.bit_length())
    below = a.denominator**power
    corner = [_spread(difference(nu), steps[power]) for nu in orders]
    for mu, row in zip(orders, q, strict=True):
        left, right = multiply(symbol, difference(mu)), _sum(multiply(f, d) for f, d in zip(row, corner, strict=True))
        same = left.keys() == right.keys() and all(denominator * left[x] == below * right[x] for x in left)
        require(same, f"the matrix is no reduction: row {mu}")
    return done


def _spread(f: Mapping[Index, int], matrix: matrices.Matrix) -> Sparse:
    """The polynomial f(z^M)."""
    return {tuple(matrices.apply(matrix, x)): value for x, value in f.items()}


def _sum(polynomials: Iterable[Sparse]) -> Sparse:
    total: Sparse = {}
    for f in polynomials:
        for x, value in f.items():
            total[x] = total.get(x, 0) + value
    return {x: value for x, value in total.items() if value}


def _multiplied(a: Entries, b: Entries) -> Entries:
    return [
        [_sum(multiply(f, g) for f, g in zip(row, column, strict=True)) for column in zip(*b, strict=True)] for row in a
    ]


def _largest_sum(entries: Entries, matrix: matrices.Matrix) -> int:
    """The largest sum of absolute values in a row over a coset modulo the matrix."""
    if (inverted := matrices.inverse(matrix)) is None:
        raise Rejected("the dilation is singular")
    modulus = DilationMatrix(matrix, *inverted)
    largest = 0
    for row in entries:
        sums: dict[Index, int] = {}
        for f in row:
            for x, value in f.items():
                coset = modulus.residue(x)
                sums[coset] = sums.get(coset, 0) + abs(value)
        largest = max([largest, *sums.values()])
    return largest


def _bits(entries: Entries) -> int:
    """The bits of the sums of products of these numerators, less those of the other factor."""
    values = [abs(value) for row in entries for f in row for value in f.values()]
    return max(values, default=0).bit_length() + len(values).bit_length()
