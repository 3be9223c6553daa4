"""Square integer matrices: sections of a subdivision operator, characteristic polynomials, the Schur-Cohn test."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd
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
    """Whether all zeros of f, of degree exactly len(f) - 1, lie in |z| < radius (Schur & Cohn).

    For g(z) = f(radius z) of degree n with the reverse g* and |g_0| < |g_n|, h = (g_n g - g_0 g*)/z has degree n-1. A
    zero of g on the circle is one of g* and h; without any, g and z h have equally many inside (Rouché, |g*| = |g|).
    """
    u, v, n = radius.numerator, radius.denominator, len(f) - 1
    g = [c * u**i * v ** (n - i) for i, c in enumerate(f)]
    if sum(g) * g[-1] <= 0 or (sum(g[::-2]) - sum(g[-2::-2])) * g[-1] <= 0:
        return False  # at 1 or -1 it has not the sign that it has beyond: a real zero lies there or further out
    while len(g) > 1:
        low, top = g[0], g[-1]
        if abs(low) >= abs(top):
            return False
        g = [top * x - low * y for x, y in zip(g[1:], g[-2::-1], strict=True)]
        common = gcd(*g)
        g = [c // common for c in g]
    return True
