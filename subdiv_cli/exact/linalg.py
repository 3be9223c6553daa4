"""Rational matrices: what python-flint's `fmpq_mat` leaves out."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from flint import fmpq_mat, fmpq_poly, fmpz_mat

from subdiv_cli.exact.rationals import to_fmpq, to_fraction

Vector = tuple[Fraction, ...]
Combination = dict[int, Fraction]
"""Number of a column -> its weight, not zero."""


def matrix(rows: Sequence[Sequence[Fraction | int]]) -> fmpq_mat:
    """The m×n matrix with these m rows of n rationals; m, n >= 1."""
    return fmpq_mat([[to_fmpq(x) for x in row] for row in rows])


def rows_of(a: fmpq_mat) -> tuple[Vector, ...]:
    """The m rows of an m×n matrix as tuples of n fractions."""
    return tuple(tuple(to_fraction(x) for x in row) for row in a.table())


def identity(n: int) -> fmpq_mat:
    """The n×n identity matrix."""
    return fmpq_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])


def nullspace(a: fmpq_mat) -> tuple[Vector, ...]:
    """A basis of {x : a x = 0} for an m×n matrix a, a vector of n fractions for each free column.

    It is read off the reduced row echelon form.
    """
    echelon, rank = a.rref()
    columns = a.ncols()
    pivots = [next(j for j in range(columns) if echelon[i, j]) for i in range(rank)]
    basis = []
    for free in (j for j in range(columns) if j not in pivots):
        x = [Fraction(0)] * columns
        x[free] = Fraction(1)
        for i, pivot in enumerate(pivots):
            x[pivot] = -to_fraction(echelon[i, free])
        basis.append(tuple(x))
    return tuple(basis)


def combinations(
    columns: Sequence[Sequence[int]], targets: Sequence[Sequence[Fraction]], basis: Sequence[int]
) -> tuple[Combination, ...] | None:
    """Each target as a combination of the columns with the numbers in `basis`; None where these are dependent.

    Targets and columns have d coordinates, and `basis` has d numbers; the answer has one combination for each target.
    """
    square = matrix([columns[i] for i in basis]).transpose()
    try:
        weights = square.solve(matrix(targets).transpose()).transpose()
    except ZeroDivisionError:
        return None
    return tuple({i: to_fraction(x) for i, x in zip(basis, row, strict=True) if x} for row in weights.tolist())


def reduced(rows: fmpq_mat) -> fmpq_mat:
    """A k×n matrix of k independent rows replaced by a short basis of the integer vectors that they span over Q.

    With H the Hermite normal form of the transpose, whose columns are a lattice's, H^(-T) times the rows spans all of
    them; then lattice reduction (Lenstra, Lenstra & Lovász 1982), and before as well: on long entries H takes minutes.
    """
    scaled = fmpz_mat([fmpq_mat([row]).numer_denom()[0].tolist()[0] for row in rows.rref()[0].tolist()]).lll()
    triangle = fmpz_mat(scaled.transpose().hnf().tolist()[: rows.nrows()])
    return fmpq_mat((fmpq_mat(triangle.transpose()).inv() * scaled).numer_denom()[0].lll())


def eigenvectors(a: fmpq_mat, eigenvalue: Fraction | int) -> tuple[Vector, ...]:
    """A basis of the right eigenspace of a rational eigenvalue of an n×n matrix, vectors of n fractions.

    It is empty where the number is no eigenvalue. Transpose the matrix for left eigenvectors.
    """
    return nullspace(a - identity(a.nrows()) * to_fmpq(eigenvalue))


def at_matrix(f: fmpq_poly, a: fmpq_mat) -> fmpq_mat:
    """The n×n matrix f(a), by Horner's rule."""
    unit = identity(a.nrows())
    total = unit * 0
    for c in reversed(list(f)):
        total = total * a + unit * c
    return total


def minimal_polynomial(a: fmpq_mat) -> fmpq_poly:
    """The monic f of least degree with f(a) = 0 for an n×n matrix a.

    It is the characteristic polynomial with no factor more than is needed. `fmpq_mat.minpoly` is not used: where
    denominators were longer than 64 bits, it was seen to be wrong (FLINT 3.6).
    """
    f = a.charpoly()
    for factor, multiplicity in f.numer().factor()[1]:
        for _ in range(multiplicity - 1):
            smaller = f / fmpq_poly(factor)
            if any(at_matrix(smaller, a).entries()):
                break
            f = smaller
    return f / f[f.degree()]


def infinity_norm(a: fmpq_mat) -> Fraction:
    """The maximum absolute row sum of a matrix, its operator norm for the maximum norm."""
    return max(sum((abs(x) for x in row), Fraction(0)) for row in rows_of(a))


def solution(a: fmpq_mat, b: Sequence[Fraction]) -> Vector | None:
    """An x with a x = b for an m×n matrix a, n fractions whose free ones are 0; None where there is none."""
    rows, columns = a.nrows(), a.ncols()
    entries = [[*row, to_fmpq(right)] for row, right in zip(a.table(), b, strict=True)]
    echelon, rank = fmpq_mat(entries).rref()
    x = [Fraction(0)] * columns
    for i in range(min(rank, rows)):
        pivot = next(j for j in range(columns + 1) if echelon[i, j])
        if pivot == columns:
            return None
        x[pivot] = to_fraction(echelon[i, columns])
    return tuple(x)
