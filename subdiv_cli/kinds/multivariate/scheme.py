"""Scalar subdivision schemes in several variables: (S f)_α = Σ_β a_(α-Mβ) f_β, α in Z^s (Dyn 1992, 6.1, for any M)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import mul
from typing import Any

Index = tuple[int, ...]
IntMatrix = tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class MultivariateScheme:
    """A finitely supported rational mask on Z^s, s >= 2, and an expanding integer dilation matrix M.

    The terms are sorted and not zero. Raises ValueError for an all-zero mask, indices of another dimension, and a
    matrix that is not square or not expanding; readers of files report all of them before they come here.
    """

    dilation: IntMatrix
    """The s rows of M; column j is M e_j."""
    terms: Mapping[Index, Fraction]
    """The coefficients: α -> a_α."""

    @property
    def kind(self) -> str:
        """The name of the kind, `multivariate`."""
        return "multivariate"

    def __post_init__(self) -> None:
        if not is_expanding(self.dilation):
            raise ValueError("the dilation matrix is not square or not expanding")
        terms = {index: value for index, value in sorted(self.terms.items()) if value}
        if not terms:
            raise ValueError("all coefficients are zero")
        if any(len(index) != self.dimension for index in terms):
            raise ValueError(f"an index is not one of Z^{self.dimension}")
        object.__setattr__(self, "terms", terms)

    @property
    def dimension(self) -> int:
        """The number s of variables."""
        return len(self.dilation)

    def bounds(self) -> tuple[Index, Index]:
        """The corners of the smallest box that contains the support: the lowest and the highest."""
        columns = list(zip(*self.terms, strict=True))
        return tuple(map(min, columns)), tuple(map(max, columns))


def base(mask: Mapping[str, Any], variables: Sequence[int] | None) -> tuple[int, int]:
    """The pair (|det M|, s) of a canonical mask, or of its factor in these variables."""
    rows = mask["dilation"]
    block = rows if variables is None else [[rows[i][j] for j in variables] for i in variables]
    return abs(characteristic_polynomial(block)[0]), len(block)


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
