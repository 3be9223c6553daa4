"""Square integer matrices: sections of a subdivision operator, characteristic polynomials, the Schur-Cohn test."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from operator import mul

from subdiv_cli.checker.polynomials import Polynomial

Matrix = list[list[int]]


def section(f: Polynomial, p: int, offset: int, order: int) -> Matrix:
    """The numerators f_(offset+i-pj), 0 <= i, j < order."""
    return [[f.at(offset + i - p * j) for j in range(order)] for i in range(order)]


def multiply(a: Matrix, b: Matrix) -> Matrix:
    columns = list(zip(*b, strict=True))
    return [[sum(map(mul, row, column)) for column in columns] for row in a]


def characteristic_polynomial(a: Matrix) -> list[int]:
    """det(z - A), lowest power first, without divisions (Samuelson & Berkowitz).

    With A_r = [[A_(r-1), s], [t, x]] the one of A_r is that of A_(r-1) times z - x - Σ_(i>=0) t A_(r-1)^i s z^(-i-1),
    its polynomial part.
    """
    f = [1]
    for r in range(len(a)):
        block, s, t = [row[:r] for row in a[:r]], [row[r] for row in a[:r]], a[r][:r]
        series = [1, -a[r][r]]
        for _ in range(r):
            series.append(-sum(map(mul, t, s)))
            s = [sum(map(mul, row, s)) for row in block]
        f = [sum(series[i - j] * f[j] for j in range(min(i, r) + 1)) for i in range(r + 2)]
    return f[::-1]


def roots_lie_inside(f: Sequence[int], radius: Fraction) -> bool:
    """Whether all zeros of f, of degree exactly len(f) - 1, lie in |z| < radius.

    Schur, Cohn, Fujiwara: iff for g(z) = f(radius z) the matrix below is positive definite.
    """
    u, v, n = radius.numerator, radius.denominator, len(f) - 1
    g = [c * u**i * v ** (n - i) for i, c in enumerate(f)]
    b = [[0] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            b[i][j] = b[j][i] = (b[i - 1][j - 1] if j else 0) + g[n - i] * g[n - j] - g[i] * g[j]
    return is_positive_definite(b)


def is_positive_definite(b: Matrix) -> bool:
    """Whether all leading minors of a symmetric matrix, the pivots of Bareiss's elimination, are positive."""
    rows, previous = [list(row) for row in b], 1
    for k in range(len(rows)):
        pivot = rows[k][k]
        if pivot <= 0:
            return False
        for i in range(k + 1, len(rows)):
            factor = rows[i][k]
            rows[i] = [(pivot * x - factor * y) // previous for x, y in zip(rows[i], rows[k], strict=True)]
        previous = pivot
    return True
