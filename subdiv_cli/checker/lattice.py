"""Masks on Z^s and their dilation: cosets of M Z^s, M^-1, isotropy, sparse Laurent polynomials. Integers only.

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
from subdiv_cli.checker.reading import Rejected, require, require_few

Index = tuple[int, ...]
Sparse = dict[Index, int]

MAX_POWER = 24
"""Of a dilation that is looked at."""
MAX_COSETS = 4096
MAX_TERMS = 500_000
"""Of a product of sparse polynomials."""


class Dilation(NamedTuple):
    """An expanding integer matrix M, and M^-1 = inverse/scale in integers; |scale| = |det M|."""

    rows: Matrix
    inverse: Matrix
    scale: int

    @property
    def dimension(self) -> int:
        """s."""
        return len(self.rows)

    @property
    def cosets(self) -> int:
        """m = |det M|, how many cosets Z^s has modulo M Z^s."""
        return abs(self.scale)

    @property
    def factor(self) -> int:
        """c where M = cI, c >= 2, otherwise 0."""
        return factor_of(self.rows)

    def residue(self, x: Sequence[int]) -> Index:
        """The same for two indices iff they are congruent: iff M^-1 (x - y) is integral."""
        m = abs(self.scale)
        return tuple(sum(map(mul, row, x)) % m for row in self.inverse)

    def divided(self, x: Sequence[int]) -> Index:
        """M^-1 x for x in M Z^s."""
        return tuple(sum(map(mul, row, x)) // self.scale for row in self.inverse)

    def image(self, x: Sequence[int]) -> Index:
        """M x."""
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


class LatticeMask(NamedTuple):
    """A mask on Z^s, numerators over one common denominator > 0, none of them zero, and its dilation."""

    dilation: Dilation
    terms: Sparse
    denominator: int

    @property
    def bits(self) -> int:
        return max(map(abs, self.terms.values())).bit_length() + self.denominator.bit_length()

    def sum_is_m(self) -> bool:
        """Whether the coefficients add up to m: φ with ∫φ = 1 exists."""
        return sum(self.terms.values()) == self.dilation.cosets * self.denominator

    def by_coset(self) -> list[list[tuple[Index, int]]]:
        """The terms of each of the m cosets, in any order."""
        groups: dict[Index, list[tuple[Index, int]]] = {}
        for index, numerator in self.terms.items():
            groups.setdefault(self.dilation.residue(index), []).append((index, numerator))
        return [*groups.values(), *([] for _ in range(self.dilation.cosets - len(groups)))]


def lattice_mask(rows: Sequence[Index], terms: Sequence[tuple[Index, Fraction]]) -> LatticeMask:
    """Rejects what is no mask on Z^s with an expanding M."""
    s = len(rows)
    require(
        2 <= s <= 4 and all(len(row) == s for row in rows), "the dilation is not a square matrix of order 2, 3 or 4"
    )
    require(all(len(index) == s for index, _ in terms), f"an index is not one of Z^{s}")
    matrix = [list(row) for row in rows]
    if (found := matrices.inverse(matrix)) is None:
        raise Rejected("the dilation is singular")
    f = matrices.characteristic_polynomial(matrix)
    require(matrices.roots_lie_inside(f[::-1], Fraction(1)), "the dilation is not expanding")
    require(abs(found[1]) <= MAX_COSETS, f"the determinant of the dilation is larger than {MAX_COSETS}")
    return LatticeMask(Dilation(matrix, *found), *over_one(terms))


def over_one(terms: Sequence[tuple[Index, Fraction]]) -> tuple[Sparse, int]:
    """Numerators and their common denominator."""
    common = lcm(*(value.denominator for _, value in terms))
    return {index: value.numerator * (common // value.denominator) for index, value in terms}, common


def factor_of(matrix: Matrix) -> int:
    """c where the matrix is cI with c >= 2, otherwise 0."""
    c = matrix[0][0]
    is_scalar = all(x == (c if i == j else 0) for i, row in enumerate(matrix) for j, x in enumerate(row))
    return c if is_scalar and c >= 2 else 0


def add(x: Sequence[int], y: Sequence[int]) -> Index:
    return tuple([i + j for i, j in zip(x, y, strict=True)])


def multiply(f: Mapping[Index, int], g: Mapping[Index, int]) -> Sparse:
    """f(z) g(z), without zeros."""
    product: Sparse = {}
    for x, p in f.items():
        for y, q in g.items():
            at = add(x, y)
            product[at] = product.get(at, 0) + p * q
        require_few(len(product) <= MAX_TERMS, "a product has too many terms")
    return {at: value for at, value in product.items() if value}


def geometric(direction: Index, count: int) -> Sparse:
    """1 + z^θ + … + z^((count-1)θ), θ ≠ 0."""
    return {tuple(j * t for t in direction): 1 for j in range(count)}


def monomials(s: int, degree: int) -> Iterator[Index]:
    """All μ in s variables with |μ| = degree, in lexicographic order."""
    if s == 1:
        yield (degree,)
        return
    for first in range(degree + 1):
        for rest in monomials(s - 1, degree - first):
            yield (first, *rest)


def power(x: Sequence[int], mu: Sequence[int]) -> int:
    """x^μ."""
    value = 1
    for i, n in zip(x, mu, strict=True):
        value *= i**n
    return value
