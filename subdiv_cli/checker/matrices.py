"""Square integer matrices: sections of an operator, families, inverses, characteristic polynomials, Schur-Cohn."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from math import gcd
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker.polynomials import Polynomial

Matrix = list[list[int]]
PRIME = (1 << 61) - 1
"""A modulus: rows of integers that are independent modulo it are so over Q as well."""


class RationalFamily(NamedTuple):
    """A family of square matrices of one order, as numerators over one common denominator > 0."""

    matrices: list[Matrix]
    denominator: int

    @property
    def order(self) -> int:
        """The order N of the matrices."""
        return len(self.matrices[0])

    @property
    def bits(self) -> int:
        """The bits of the longest numerator and of the denominator together."""
        largest = max(max(map(abs, row)) for matrix in self.matrices for row in matrix)
        return largest.bit_length() + self.denominator.bit_length()

    def product(self, word: Sequence[int]) -> tuple[Matrix, int]:
        """The product M_(w_ℓ) … M_(w_1) as N×N numerators and their common denominator, in lowest terms."""
        total, denominator = self.matrices[word[0]], self.denominator ** len(word)
        for letter in word[1:]:
            total = multiply(self.matrices[letter], total)
        common = gcd(denominator, *(gcd(*row) for row in total))
        return [[x // common for x in row] for row in total], denominator // common

    def is_symmetric(self, sign: int) -> bool:
        """Whether M_(p-1-i) = sign J M_i J for all i, J the reversal of the coordinates."""
        pairs = zip(self.matrices, reversed(self.matrices), strict=True)
        return all(b == [[sign * x for x in reversed(row)] for row in reversed(a)] for a, b in pairs)


def family(matrices: list[Matrix], denominator: int) -> RationalFamily:
    """The family of these matrices over this denominator, in lowest terms."""
    common = gcd(denominator, *(gcd(*row) for matrix in matrices for row in matrix))
    return RationalFamily(
        [[[x // common for x in row] for row in matrix] for matrix in matrices], denominator // common
    )


def section(f: Polynomial, p: int, offset: int, order: int) -> Matrix:
    """The matrix of the numerators f_(offset+i-pj), 0 <= i, j < order."""
    return [[f.at(offset + i - p * j) for j in range(order)] for i in range(order)]


def symmetric_section(b: Sequence[int], p: int, order: int) -> Matrix:
    """The matrix of v -> Σ_j b_(i-pj) v_j on symmetric sequences v, b_(-i) = b_i.

    Its entries are b_(i-pj) + b_(i+pj), b_i for j = 0, for 0 <= i, j < order.
    """

    def at(i: int) -> int:
        return b[abs(i)] if abs(i) < len(b) else 0

    return [[at(i - p * j) + (at(i + p * j) if j else 0) for j in range(order)] for i in range(order)]


def multiply(a: Matrix, b: Matrix) -> Matrix:
    """The product of two integer matrices."""
    columns = list(zip(*b, strict=True))
    return [[sum(map(mul, row, column)) for column in columns] for row in a]


def transpose(a: Matrix) -> Matrix:
    """The transpose of a matrix."""
    return [list(row) for row in zip(*a, strict=True)]


def apply(a: Matrix, v: Sequence[int]) -> list[int]:
    """The product of an integer matrix and a vector."""
    return [sum(map(mul, row, v)) for row in a]


def inverse(a: Matrix) -> tuple[Matrix, int] | None:
    """The pair (b, d) with a^-1 = b/d, d ≠ 0; None for a singular matrix.

    Gauss and Jordan without fractions (Bareiss): after step k all entries are minors of order k + 1, up to sign, so the
    divisions are exact. The inverse is built in the columns that are done with.
    """
    a, n, before, rows = [list(row) for row in a], len(a), 1, list(range(len(a)))
    for k in range(n):
        pivot_row = next((i for i in range(k, n) if a[i][k]), None)
        if pivot_row is None:
            return None
        a[k], a[pivot_row] = a[pivot_row], a[k]
        rows[k], rows[pivot_row] = rows[pivot_row], rows[k]
        top = a[k]
        pivot = top[k]
        for i, row in enumerate(a):
            if i != k:
                f = row[k]
                a[i] = [(pivot * x - f * y) // before for x, y in zip(row, top, strict=True)]
                a[i][k] = -f
        top[k], before = before, pivot
    order = sorted(range(n), key=rows.__getitem__)  # interchanged rows are interchanged columns of the inverse
    return [[row[i] for i in order] for row in a], before


def minor_bits(a: Matrix) -> int:
    """The bits that no minor of a matrix has more of (Hadamard): the squares of its rows bound that of a minor."""
    return sum(sum(x * x for x in row).bit_length() for row in a) // 2 + 1


def inverse_norm(a: Matrix) -> Fraction | None:
    """The norm ‖a^-1‖₁, the largest absolute column sum; None for a singular matrix."""
    if (inverted := inverse(a)) is None:
        return None
    b, d = inverted
    return Fraction(max(sum(map(abs, column)) for column in zip(*b, strict=True)), abs(d))


def characteristic_polynomial(a: Matrix) -> list[int]:
    """The n + 1 coefficients of det(z - A), A an n×n matrix, lowest power first.

    Remembered, since the rules of one mask use the same matrices, or their mirror images.
    """
    rows = tuple(map(tuple, a))
    return list(_characteristic_polynomial(min(rows, tuple(row[::-1] for row in reversed(rows)))))


@lru_cache(8)
def _characteristic_polynomial(a: tuple[tuple[int, ...], ...]) -> list[int]:
    """The characteristic polynomial: for a block triangular matrix the product of those of its diagonal blocks."""
    f = [1]
    for block in _blocks(a):
        for part in _parts_by_symmetry([[a[i][j] for j in block] for i in block]):
            f = _product(f, _berkowitz(part))
    return f[::-1]


def _blocks(a: Sequence[Sequence[int]]) -> list[list[int]]:
    """The strongly connected components of the graph with an edge i -> j for each a_ij ≠ 0 (Warshall)."""
    reached = [sum(1 << j for j, x in enumerate(row) if x) | 1 << i for i, row in enumerate(a)]
    for k in range(len(a)):
        reached = [row | reached[k] if row >> k & 1 else row for row in reached]
    blocks: dict[int, list[int]] = {}
    for i, row in enumerate(reached):
        blocks.setdefault(row, []).append(i)  # the same indices are reached iff each reaches the other
    return list(blocks.values())


def _parts_by_symmetry(a: Matrix) -> list[Matrix]:
    """The matrices on symmetric and on antisymmetric vectors, for a matrix that is its own mirror image; else itself.

    Such a matrix maps the symmetric vectors to such ones, and the antisymmetric ones too. On the bases
    e_j + e_(n-1-j), with e_j alone in the middle, and e_j - e_(n-1-j) they are of half the order.
    """
    n = len(a)
    if any(row[::-1] != mirrored for row, mirrored in zip(a, reversed(a), strict=True)):
        return [a]
    half, middle = n // 2, n - n // 2
    symmetric = [[row[j] + row[-1 - j] for j in range(half)] + row[half:middle] for row in a[:middle]]
    return [symmetric, [[row[j] - row[-1 - j] for j in range(half)] for row in a[:half]]]


def _product(f: list[int], g: list[int]) -> list[int]:
    h = [0] * (len(f) + len(g) - 1)
    for i, x in enumerate(f):
        for j, y in enumerate(g, i):
            h[j] += x * y
    return h


def _berkowitz(a: Matrix) -> list[int]:
    """The characteristic polynomial, highest power first, without divisions (Samuelson & Berkowitz).

    With A_r = [[A_(r-1), s], [t, x]] the one of A_r is that of A_(r-1) times z - x - Σ_(i>=0) t A_(r-1)^i s z^(-i-1),
    its polynomial part.
    """
    f = [1]
    for r, last in enumerate(a):
        block, t, series = a[:r], last[:r], [1, -last[r]]
        s = [row[r] for row in block]
        while len(series) < r + 2:
            if not any(s) or not any(t):
                series += [0] * (r + 2 - len(series))
                break
            series.append(-sum(map(mul, t, s)))
            s = [sum(map(mul, row, s)) for row in block]
        f = [sum(map(mul, series[i::-1], f)) for i in range(r + 2)]
    return f


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


def dependent_rows(rows: Sequence[Sequence[int]]) -> list[int]:
    """The numbers of the rows of integers that depend, modulo the prime, on those before them."""
    reduced: list[tuple[int, list[int]]] = []
    dependent = []
    for i, row in enumerate(rows):
        rest = [x % PRIME for x in row]
        for pivot, other in reduced:
            if f := rest[pivot]:
                rest = [(x - f * y) % PRIME for x, y in zip(rest, other, strict=True)]
        if (pivot := next((j for j, x in enumerate(rest) if x), -1)) < 0:
            dependent.append(i)
            continue
        inverse = pow(rest[pivot], -1, PRIME)
        reduced.append((pivot, [inverse * x % PRIME for x in rest]))
    return dependent
