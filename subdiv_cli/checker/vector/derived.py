"""The rules on derived schemes: (∂A)(z) = p diag(z^-1 - 1, 1) R^-1 A(z) R diag(z^-p - 1, 1)^-1. See FORMAT.md."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import Matrix
from subdiv_cli.checker.polynomials import Polynomial, add, multiply, polynomial, spread
from subdiv_cli.checker.reading import MAX_LENGTH, Rejected, require, require_few
from subdiv_cli.checker.vector.masks import MatrixMask, mask_of, matrix_mask
from subdiv_cli.checker.vector.sequences import check_constants


def derived(c: Claim) -> MatrixMask:
    """Δ_r S_Ā = (1/p) S_B Δ_r for Ā_i = R^-1 A_i R: B, the n-th derived mask, A the one before or that of the document.

    Δ_r = diag(Δ I_r, I), and the first r columns of R are a basis of E_A. Raises Rejected where it is not so.
    """
    n = c.statement["order"]
    require(n >= 1, "the order is not positive")
    return derived_from(c, mask_of(c) if n == 1 else c.use("derived", order=n - 1).result)


def derived_from(c: Claim, a: MatrixMask) -> MatrixMask:
    """The mask B of a claim, derived from A. Raises Rejected where it is another."""
    r = c.witness["dimension"]
    b = matrix_mask(a.arity, c.witness["start"], c.witness["coefficients"])
    transformation, m, p = c.witness["transformation"], a.size, a.arity
    require(b.size == m == transformation.order and 1 <= r <= m, "the sizes do not fit")
    length = len(a.matrices) + len(b.matrices) + p + 2
    c.count(length * 4 * m**3 + (a.entries + p * m * m) * (r + 1), a.bits + b.bits + (m + 2) * transformation.bits)
    columns = list(zip(*transformation.matrices[0], strict=True))
    check_constants(a, r, [tuple(map(Fraction, column)) for column in columns[:r]])
    if (inverted := matrices.inverse(transformation.matrices[0])) is None:
        raise Rejected("the transformation is singular")
    inverse, determinant = inverted
    moved = {
        i: matrices.multiply(inverse, matrices.multiply(x, transformation.matrices[0]))
        for i, x in enumerate(a.matrices, a.start)
    }
    other = dict(enumerate(b.matrices, b.start))
    zero = [[0] * m for _ in range(m)]
    for i in range(min(a.start - 1, b.start - p), max(a.start + len(a.matrices), b.start + len(b.matrices)) + 1):
        left = _rows(moved.get(i, zero), moved.get(i + 1, zero), r)
        right = _columns(other.get(i, zero), other.get(i + p, zero), r)
        scale, factor = p * b.denominator, a.denominator * determinant
        same = [[scale * x for x in row] for row in left] == [[factor * x for x in row] for row in right]
        require(same, f"the derived mask is another at the index {i}")
    return b


def _rows(here: Matrix, after: Matrix, r: int) -> Matrix:
    """The coefficient of diag(z^-1 - 1, 1) times a symbol."""
    return [
        [y - x for x, y in zip(row, following, strict=True)] if k < r else row
        for k, (row, following) in enumerate(zip(here, after, strict=True))
    ]


def _columns(here: Matrix, after: Matrix, r: int) -> Matrix:
    """The coefficient of a symbol times diag(z^-p - 1, 1)."""
    return [
        [y - x if k < r else x for k, (x, y) in enumerate(zip(row, following, strict=True))]
        for row, following in zip(here, after, strict=True)
    ]


def derived_norm(c: Claim) -> None:
    """‖((1/p) S_B)^L‖∞ = x for the n-th derived mask B, the largest sum of moduli of a row's entries in one class."""
    level, b = c.statement["level"], c.use("derived", order=c.statement["order"]).result
    require(level >= 1, "the level is not positive")
    require_few(b.arity**level <= MAX_LENGTH, "the level is too high")
    m, p, length = b.size, b.arity, (len(b.matrices) - 1) * (b.arity**level - 1) // (b.arity - 1) + 1
    c.count(2 * m**3 * len(b.matrices) * length + m * m * length, level * (b.bits + length.bit_length()))
    symbol = [[_entry(b, i, j) for j in range(m)] for i in range(m)]
    power = symbol
    for _ in range(level - 1):  # B(z) B(z^p) B(z^(p²)) …, from the right
        spaced = [[spread(f, p) for f in row] for row in power]
        columns = list(zip(*spaced, strict=True))
        power = [[_sum(row, column) for column in columns] for row in symbol]
    rows = [list(zip(*(_magnitudes(f, p**level) for f in row), strict=True)) for row in power]
    norm = max(sum(entries) for row in rows for entries in row) / p**level
    require(norm == c.statement["norm"], "it is another number")


def _entry(b: MatrixMask, i: int, j: int) -> Polynomial:
    return polynomial(b.start, [matrix[i][j] for matrix in b.matrices], b.denominator)


def _sum(row: list[Polynomial], column: tuple[Polynomial, ...]) -> Polynomial:
    total = polynomial(0, [], 1)
    for f, g in zip(row, column, strict=True):
        total = add(total, multiply(f, g))
    return total


def _magnitudes(f: Polynomial, step: int) -> list[Fraction]:
    """For each class of exponents modulo the step the sum of the moduli of the coefficients."""
    sums = [0] * step
    for exponent, x in enumerate(f.numerators, f.start):
        sums[exponent % step] += abs(x)
    return [Fraction(x, f.denominator) for x in sums]


def derived_smooth(c: Claim) -> None:
    """S converges, to limits in C^(n-1): (1/p) S_B contracts for the n-th derived mask B (theorems 9 and 11)."""
    c.count(1)
    used = c.use("derived-norm").statement
    require(used["order"] == c.statement["order"] + 1, f"the norm is that of derived scheme {used['order']}")
    require(used["norm"] < 1, "the norm is not below 1")
