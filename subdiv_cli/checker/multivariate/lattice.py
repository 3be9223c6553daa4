"""Z^s and its dilations: cosets of M Z^s, M^-1, isotropy, sparse Laurent polynomials. Integers only.

A sparse polynomial is a dictionary from indices to numerators, without zeros where it says so.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import lcm
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker import matrices
from subdiv_cli.checker.matrices import Matrix
from subdiv_cli.checker.reading import require_few

Index = tuple[int, ...]
Sparse = dict[Index, int]

MAX_POWER = 24
"""The highest power of a dilation that is looked at."""
MAX_TERMS = 500_000
"""The most terms of a product of sparse polynomials."""


class DilationMatrix(NamedTuple):
    """An expanding integer matrix M, and M^-1 = inverse/scale in integers; |scale| = |det M|."""

    rows: Matrix
    inverse: Matrix
    scale: int

    @property
    def dimension(self) -> int:
        """The number s of variables."""
        return len(self.rows)

    @property
    def cosets(self) -> int:
        """The number m = |det M| of cosets of M Z^s in Z^s."""
        return abs(self.scale)

    @property
    def factor(self) -> int:
        """The factor c where M = cI, c >= 2, otherwise 0."""
        return factor_of(self.rows)

    def residue(self, x: Sequence[int]) -> Index:
        """A key that is the same for two indices iff they are congruent: iff M^-1 (x - y) is integral."""
        m = abs(self.scale)
        return tuple(sum(map(mul, row, x)) % m for row in self.inverse)

    def divided(self, x: Sequence[int]) -> Index:
        """The index M^-1 x for x in M Z^s."""
        return tuple(sum(map(mul, row, x)) // self.scale for row in self.inverse)

    def image(self, x: Sequence[int]) -> Index:
        """The index M x."""
        return tuple(sum(map(mul, row, x)) for row in self.rows)

    def is_isotropic(self) -> bool:
        """Whether M is seen to be diagonalisable over C, all its eigenvalues of the modulus m^(1/s).

        M^r = ±cI for some r <= 24, or s = 2 and the eigenvalues are not real (tr² < 4 det): a complex pair.
        """
        if self.dimension == 2:
            (a, b), (c, d) = self.rows
            if (a + d) ** 2 < 4 * (a * d - b * c):
                return True
        power = self.rows
        for _ in range(MAX_POWER):
            if factor_of(power) or factor_of([[-x for x in row] for row in power]):
                return True
            power = matrices.multiply(self.rows, power)
        return False


def over_one(terms: Sequence[tuple[Index, Fraction]]) -> tuple[Sparse, int]:
    """The numerators of a sparse polynomial, and their common denominator."""
    common = lcm(*(value.denominator for _, value in terms))
    return {index: value.numerator * (common // value.denominator) for index, value in terms}, common


def factor_of(matrix: Matrix) -> int:
    """The factor c where the matrix is cI with c >= 2, otherwise 0."""
    c = matrix[0][0]
    is_scalar = all(x == (c if i == j else 0) for i, row in enumerate(matrix) for j, x in enumerate(row))
    return c if is_scalar and c >= 2 else 0


def add(x: Sequence[int], y: Sequence[int]) -> Index:
    """The sum of two indices."""
    return tuple([i + j for i, j in zip(x, y, strict=True)])


def multiply(f: Mapping[Index, int], g: Mapping[Index, int]) -> Sparse:
    """The product f(z) g(z), without zeros."""
    product: Sparse = {}
    for x, p in f.items():
        for y, q in g.items():
            at = add(x, y)
            product[at] = product.get(at, 0) + p * q
        require_few(len(product) <= MAX_TERMS, "a product has too many terms")
    return {at: value for at, value in product.items() if value}


def geometric(direction: Index, count: int) -> Sparse:
    """The polynomial 1 + z^θ + … + z^((count-1)θ), θ ≠ 0."""
    return {tuple(j * t for t in direction): 1 for j in range(count)}


def monomials(s: int, degree: int) -> Iterator[Index]:
    """All multi-indices μ in s variables with |μ| = degree, in lexicographic order."""
    if s == 1:
        yield (degree,)
        return
    for first in range(degree + 1):
        for rest in monomials(s - 1, degree - first):
            yield (first, *rest)


def power(x: Sequence[int], mu: Sequence[int]) -> int:
    """The power x^μ = Π_j x_j^μ_j."""
    value = 1
    for i, n in zip(x, mu, strict=True):
        value *= i**n
    return value


def determinant(rows: Sequence[Sequence[int]]) -> int:
    """The determinant of a square integer matrix, by its first row (Laplace); 1 for no rows."""
    if not rows:
        return 1
    return sum(
        (-1) ** j * x * determinant([[*row[:j], *row[j + 1 :]] for row in rows[1:]]) for j, x in enumerate(rows[0]) if x
    )
