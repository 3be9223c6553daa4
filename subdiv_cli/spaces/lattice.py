"""Integer matrices, and the lattice M Z^s of a dilation matrix: its cosets, and division by M."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import count, product
from operator import mul

Index = tuple[int, ...]
IntMatrix = tuple[tuple[int, ...], ...]

MOST_PERIODS = 24
"""The most powers of M that are looked at for a multiple of the identity."""


class Lattice:
    """The lattice M Z^s of an integer s×s matrix M with det M ≠ 0, in integers: the adjugate A has M A = det(M) I."""

    def __init__(self, dilation: IntMatrix) -> None:
        self.dilation = dilation
        self.dimension = len(dilation)
        self.determinant: int = (-1) ** self.dimension * characteristic_polynomial(dilation)[0]
        self._adjugate = _adjugate(dilation)

    @property
    def index(self) -> int:
        """The index m = |det M|, the number of cosets."""
        return abs(self.determinant)

    def image(self, alpha: Index) -> Index:
        """The index M α."""
        return tuple(sum(x * y for x, y in zip(row, alpha, strict=True)) for row in self.dilation)

    def preimage(self, alpha: Index) -> Index | None:
        """The index M^-1 α where that is an integer vector, else None."""
        scaled = self._scaled(alpha)
        if any(x % self.determinant for x in scaled):
            return None
        return tuple(x // self.determinant for x in scaled)

    def place(self, alpha: Index) -> tuple[Fraction, ...]:
        """The rational point M^-1 α."""
        return tuple(Fraction(x, self.determinant) for x in self._scaled(alpha))

    def coset(self, alpha: Index) -> Index:
        """A key of the coset α + M Z^s: equal for two indices iff they differ by an element of M Z^s."""
        return tuple(x % self.index for x in self._scaled(alpha))

    def inverse_power(self, n: int) -> tuple[tuple[Fraction, ...], ...]:
        """The rows of M^-n, n >= 0."""
        units = (tuple(int(i == j) for i in range(self.dimension)) for j in range(self.dimension))
        columns = []
        for column in units:
            for _ in range(n):
                column = self._scaled(column)
            columns.append([Fraction(x, self.determinant**n) for x in column])
        return tuple(zip(*columns, strict=True))

    def _scaled(self, alpha: Index) -> Index:
        return tuple(sum(x * y for x, y in zip(row, alpha, strict=True)) for row in self._adjugate)

    @cached_property
    def representatives(self) -> tuple[Index, ...]:
        """The m representatives, one index >= 0 of each coset, the smallest ones, 0 first."""
        of_coset: dict[Index, Index] = {}
        for total in range(self.index * self.dimension):
            for alpha in indices_of_degree(self.dimension, total):
                of_coset.setdefault(self.coset(alpha), alpha)
            if len(of_coset) == self.index:
                break
        return tuple(of_coset.values())

    @cached_property
    def corner(self) -> tuple[Index, ...]:
        """The m representatives from a box at 0, that of the Hermite normal form of M: small sums first.

        The i-th side is the smallest h > 0 with h e_i in MZ^s + Z e_1 + … + Z e_(i-1); a direct sum of these is
        Z^s/MZ^s.
        """
        sides: list[int] = []
        for i in range(self.dimension):
            after = (0,) * (self.dimension - i)
            reached = {self.coset((*alpha, *after)) for alpha in product(*map(range, sides))}
            unit = tuple(int(i == j) for j in range(self.dimension))
            sides.append(next(h for h in count(1) if self.coset(tuple(h * x for x in unit)) in reached))
        return tuple(sorted(product(*map(range, sides)), key=lambda alpha: (sum(alpha), [-k for k in alpha])))

    @cached_property
    def scalar_power(self) -> tuple[int, int] | None:
        """The pair (r, c) with M^r = c I and the smallest such r; None where there is no r <= MOST_PERIODS."""
        power = self.dilation
        for r in range(1, MOST_PERIODS + 1):
            c = power[0][0]
            if power == multiple_of_identity(c, self.dimension):
                return r, c
            power = times(power, self.dilation)
        return None

    @property
    def is_isotropic(self) -> bool:
        """Whether M is diagonalisable over C with eigenvalues of one modulus λ = m^(1/s), as far as is recognised.

        A power is a multiple of the identity; or s = 2 and the eigenvalues are not real: conjugate, so different and of
        one modulus. Others of that kind are not recognised.
        """
        if self.scalar_power is not None:
            return True
        trace = sum(row[i] for i, row in enumerate(self.dilation))
        return self.dimension == 2 and trace**2 < 4 * self.determinant


def indices_of_degree(dimension: int, total: int) -> Iterator[Index]:
    """All multi-indices μ >= 0 with |μ| = total, in lexicographic order."""
    if dimension == 1:
        yield (total,)
        return
    for first in range(total + 1):
        yield from ((first, *rest) for rest in indices_of_degree(dimension - 1, total - first))


def _adjugate(matrix: IntMatrix) -> IntMatrix:
    n = len(matrix)
    return tuple(tuple((-1) ** (i + j) * _minor(matrix, j, i) for j in range(n)) for i in range(n))


def _minor(matrix: IntMatrix, row: int, column: int) -> int:
    """The determinant without a row and a column."""
    rest = [[x for j, x in enumerate(r) if j != column] for i, r in enumerate(matrix) if i != row]
    return (-1) ** len(rest) * characteristic_polynomial(rest)[0] if rest else 1


def box(lowest: Index, highest: Index) -> Iterator[Index]:
    """All indices between two corners, in lexicographic order."""
    return product(*(range(a, b + 1) for a, b in zip(lowest, highest, strict=True)))


def multiple_of_identity(factor: int, dimension: int) -> IntMatrix:
    """The rows of the s×s matrix cI."""
    return tuple(tuple(factor * (i == j) for j in range(dimension)) for i in range(dimension))


def times(g: IntMatrix, f: IntMatrix) -> IntMatrix:
    """g f."""
    columns = list(zip(*f, strict=True))
    return tuple([tuple([sum(map(mul, row, column)) for column in columns]) for row in g])


def is_expanding(matrix: Sequence[Sequence[int]]) -> bool:
    """Whether a square integer matrix has all its eigenvalues in |z| > 1."""
    if not matrix or any(len(row) != len(matrix) for row in matrix):
        return False
    return _roots_lie_outside(characteristic_polynomial(matrix))


def characteristic_polynomial(matrix: Sequence[Sequence[int]]) -> list[int]:
    """The coefficients of det(z - M), lowest power first (Faddeev & LeVerrier: all divisions are exact)."""
    n = len(matrix)
    product = [[int(i == j) for j in range(n)] for i in range(n)]
    coefficients = [1]
    for k in range(1, n + 1):
        product = [[sum(row[i] * product[i][j] for i in range(n)) for j in range(n)] for row in matrix]
        coefficients.append(-sum(product[i][i] for i in range(n)) // k)
        for i in range(n):
            product[i][i] += coefficients[-1]
    return coefficients[::-1]


def _roots_lie_outside(f: Sequence[int]) -> bool:
    """Whether all zeros of f lie in |z| > 1: then those of the reverse lie inside (Schur & Cohn)."""
    g = list(f)[::-1]
    while len(g) > 1:
        low, top = g[0], g[-1]
        if abs(low) >= abs(top):
            return False
        g = [top * x - low * y for x, y in zip(g[1:], g[-2::-1], strict=True)]
    return True
