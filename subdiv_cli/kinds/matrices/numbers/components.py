"""The polynomials among the components c·ψ of a curve: their degree, and the matrices U_i of Micchelli & Prautzsch.

Theorem (Micchelli & Prautzsch 1989, Theorems 7.1 to 7.3). u_δ·ψ(x) = x^δ for δ <= d iff u_0·ψ = 1 and, modulo polygons
whose curve is 0, A_i u_δ = p^-δ Σ_j C(δ, j) i^(δ-j) u_j for all i and δ.

  On piece i, u·ψ(x) = (A_i u)·ψ(px - i), and x^δ = p^-δ Σ_j C(δ, j) i^(δ-j) (px - i)^j, so the condition is necessary;
  where it holds, y = (u_0·ψ, …, u_d·ψ) and (1, x, …, x^d) solve one refinement equation, whose continuous solution is
  determined, component by component, as p^-δ < 1.

With Q the n×(d+1) matrix of columns u_δ, Q^T ψ = (1, x, …, x^d), and Q^T B_i = M_i Q^T on the curve with M_i = U_i D
U_i^-1, D = diag(1, p^-1, …, p^-d), U_i = T(-i/(p-1)) for (T(a))_jk = (-a)^(j-k) C(j, k): x^j = Σ_k (T(-a))_jk (x-a)^k,
and i/(p-1) is the fixed point of piece i. Where ψ = P (1, x, …) has n = d+1 components, B_i = U_i D U_i^-1 with U_i =
P T(-i/(p-1)). The theorems print T(i/(p-1)): with T as they define it the sign is the other one.

That x^(d+1) is no component is seen on a grid: weights μ_j with Σ μ_j ψ(j p^-L) = 0 and Σ μ_j (j p^-L)^(d+1) ≠ 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from itertools import count
from math import comb
from typing import NamedTuple

from flint import fmpq_mat

from subdiv_cli.exact.linalg import Vector, identity, matrix, nullspace, rows_of, solution
from subdiv_cli.exact.rationals import to_fmpq, to_fraction


class Relation(NamedTuple):
    """A relation of points of the curve that x^(d+1) does not satisfy."""

    level: int
    weights: Vector
    """The weights μ_j, 0 <= j <= p^level, of the points ψ(j p^-level)."""


class Components:
    """The polynomials among the components of a curve with these B_i and a basis of its span, m rows."""

    def __init__(self, operators: Sequence[fmpq_mat], span: fmpq_mat) -> None:
        self._operators, self._span = operators, span

    @cached_property
    def polygons(self) -> tuple[Vector, ...]:
        """The polygons u_0, …, u_d."""
        p, n = len(self._operators), self._span.ncols()
        polygons: list[Vector] = [(Fraction(1),) * n]
        while len(polygons) < self._span.nrows():
            d = len(polygons)
            rows: list[Vector] = []
            values: list[Fraction] = []
            for i, b in enumerate(self._operators):
                rows += rows_of(self._span * (b.transpose() - identity(n) * to_fmpq(Fraction(1, p**d))))
                weights = [Fraction(comb(d, j) * i ** (d - j), p**d) for j in range(d)]
                lower = [sum((w * u[k] for w, u in zip(weights, polygons, strict=True)), Fraction(0)) for k in range(n)]
                column = self._span * fmpq_mat([[to_fmpq(x)] for x in lower])
                values += [to_fraction(x) for x in column.entries()]
            if (following := solution(matrix(rows), values)) is None:
                break
            polygons.append(following)
        return tuple(polygons)

    @property
    def degree(self) -> int:
        """The degree d: π_d is in Ψ, and π_(d+1) is not."""
        return len(self.polygons) - 1

    def excluding(self, points: Sequence[fmpq_mat], level: int) -> Relation | None:
        """A relation of the points of a grid that excludes x^(d+1); None where they have none."""
        rows = matrix([[to_fraction(x) for x in point.entries()] for point in points]).transpose()
        d, p = self.degree, len(self._operators)
        for weights in nullspace(rows):
            if sum(w * Fraction(j, p**level) ** (d + 1) for j, w in enumerate(weights)):
                return Relation(level, weights)
        return None

    def fixed_points(self) -> tuple[tuple[Vector, ...], ...]:
        """The matrices U_i, d+1 rows each."""
        p, size = len(self._operators), self.degree + 1
        return tuple(
            tuple(
                tuple(Fraction(i, p - 1) ** (j - k) * comb(j, k) if k <= j else Fraction(0) for k in range(size))
                for j in range(size)
            )
            for i in range(p)
        )


def smallest_level(p: int, points: int) -> int:
    """The least level at which a grid has so many points."""
    return next(level for level in count() if p**level + 1 >= points)
