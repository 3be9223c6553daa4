"""Polynomial eigen-sequences of a mask of matrices: S y = p^-j y with y of exact degree j.

With y(i) = Σ_l c_l i^l, l <= j, the coefficients of a^t in Σ_β A_(ε+pβ) y(a-β) = p^-j y(ε+pa), ε = 0 … p-1, are

    Σ_(l>=t) C(l,t) (Σ_β (-β)^(l-t) A_(ε+pβ) - p^(t-j) ε^(l-t)) c_l = 0,

linear equations for the c_l. Their leading coefficients c_j lie in E_A: at t = j they say A^ε c_j = c_j. Solutions of
lower degree, with c_j = 0, do not count.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb
from typing import NamedTuple

from flint import fmpq, fmpq_mat

from subdiv_cli.exact.linalg import Vector, identity, matrix, nullspace, solution
from subdiv_cli.exact.rationals import to_fmpq, to_fraction


class EigenSequences(NamedTuple):
    """The eigen-sequences of degrees 0, …, k-1 that lead in all of E_A, and why those of degree k do not."""

    each: tuple[tuple[tuple[Vector, ...], ...], ...]
    """For each degree j < k and each u of the basis of E_A the coefficients c_0, …, c_j = u of an eigen-sequence."""
    multipliers: Vector
    """The weights of the equations of degree k whose sum is g·c_k = 0."""
    functional: Vector
    """The functional g, which is not 0 on E_A."""

    @property
    def order(self) -> int:
        """The order k."""
        return len(self.each)


def eigen_sequences(
    arity: int, start: int, matrices: Sequence[fmpq_mat], constants: Sequence[Vector]
) -> EigenSequences:
    """The eigen-sequences of a mask with the basis of E_A, at least one vector.

    It ends, as an eigen-sequence of degree j has values on a window that are an eigenvector for p^-j of one matrix.
    """
    each: list[tuple[tuple[Vector, ...], ...]] = []
    while True:
        j = len(each)
        system = equations(arity, start, matrices, j)
        kernel = nullspace(system)
        m = matrices[0].nrows()
        leading = [_leading_in(u, kernel, m) for u in constants]
        if None in leading:
            functional = _functional([y[-m:] for y in kernel], constants)
            target = (*(Fraction(0),) * (m * j), *functional)
            weights = solution(system.transpose(), target)
            assert weights is not None, "the functional vanishes on the kernel"
            return EigenSequences(tuple(each), weights, functional)
        each.append(tuple(y for y in leading if y is not None))


def equations(arity: int, start: int, matrices: Sequence[fmpq_mat], j: int) -> fmpq_mat:
    """The equations of degree j, pm(j+1) rows: by ε, t and component; the unknowns are c_0, …, c_j in order."""
    p, m = arity, matrices[0].nrows()
    zero = identity(m) * 0
    rows: list[list[fmpq]] = []
    for epsilon in range(p):
        moments = [zero] * (j + 1)
        for i, a in enumerate(matrices, start):
            if i % p == epsilon:
                beta = i // p
                moments = [moment + a * (-beta) ** n for n, moment in enumerate(moments)]
        for t in range(j + 1):
            blocks = []
            for l in range(j + 1):
                scaled = to_fmpq(Fraction(p) ** (t - j) * epsilon ** (l - t)) if l >= t else fmpq(0)
                block = (moments[l - t] - identity(m) * scaled) * comb(l, t) if l >= t else zero
                blocks.append(block.tolist())
            rows += [[x for block in blocks for x in block[row]] for row in range(m)]
    return fmpq_mat(rows)


def _leading_in(u: Vector, kernel: Sequence[Vector], m: int) -> tuple[Vector, ...] | None:
    """The coefficients of a combination of the kernel with the leading coefficient u; None without one."""
    if not kernel:
        return None
    weights = solution(matrix([y[-m:] for y in kernel]).transpose(), u)
    if weights is None:
        return None
    total = (matrix([weights]) * matrix(kernel)).entries()
    coefficients = [to_fraction(x) for x in total]
    return tuple(tuple(coefficients[i : i + m]) for i in range(0, len(coefficients), m))


def _functional(leads: Sequence[Vector], constants: Sequence[Vector]) -> Vector:
    """A functional that vanishes on the leading coefficients and not on all of E_A."""
    m = len(constants[0])
    rows = [lead for lead in leads if any(lead)]
    free = nullspace(matrix(rows)) if rows else tuple(tuple(Fraction(int(i == k)) for i in range(m)) for k in range(m))
    return next(g for g in free if any(sum(x * y for x, y in zip(g, u, strict=True)) for u in constants))
