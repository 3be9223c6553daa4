"""Random families of matrices with known curves, and what floats see of a curve: a route of its own, for attacks."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from subdiv_cli.kinds.matrices.scheme import MatrixFamily

Rows = list[list[Fraction]]


class Built(NamedTuple):
    """A family with what is known of it by construction."""

    scheme: MatrixFamily
    sort: str


def family(matrices) -> MatrixFamily:
    """The scheme of some matrices, lists of rows of numbers."""
    return MatrixFamily(tuple(tuple(tuple(map(Fraction, row)) for row in m) for m in matrices))


def times(a: Rows, b: Rows) -> Rows:
    return [
        [sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0)) for column in zip(*b, strict=True)]
        for row in a
    ]


def inverse(a: Rows) -> Rows | None:
    n = len(a)
    rows = [list(map(Fraction, row)) + [Fraction(i == j) for j in range(n)] for i, row in enumerate(a)]
    for k in range(n):
        pivot = next((i for i in range(k, n) if rows[i][k]), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k], strict=True)]
    return [row[n:] for row in rows]


def of_functions(rng: random.Random, maps: list[Rows]) -> MatrixFamily:
    """A scheme whose curve has the components g, g((y+i)/p) = maps[i] g(y), g_0 = 1, in random coordinates."""
    n = len(maps[0])
    while True:
        k = [[Fraction(rng.randint(-2, 2)) for _ in range(n)] for _ in range(n)]
        for j in range(n):
            k[-1][j] = int(j == 0) - sum((row[j] for row in k[:-1]), Fraction(0))
        if (back := inverse(k)) is not None:
            break
    operators = [times(k, times(m, back)) for m in maps]
    return family([list(zip(*b, strict=True)) for b in operators])


def binomial_rows(p: int, i: int, d: int) -> Rows:
    """The rows of (1, x, …, x^d) at x = (y+i)/p in powers of y."""
    row, rows = [Fraction(1)], []
    for _ in range(d + 1):
        rows.append(row + [Fraction(0)] * (d + 1 - len(row)))
        row = [Fraction(i, p) * a + Fraction(1, p) * b for a, b in zip([*row, 0], [0, *row], strict=True)]
    return rows


def structured(rng: random.Random) -> Built:
    """Polynomials of degree d, and functions h(x) = M_i h(px - i) + P_i(px - i) that vanish at 0 and 1.

    The P_i meet, with corners or smoothly, so that the curve is well defined.
    """
    p, d, r = rng.choice((2, 2, 3)), rng.randint(1, 4), rng.randint(1, 2)
    flat = rng.randint(0, d // 2)  # P vanishes to this order at 0 and 1 if it is one polynomial
    smooth = flat > 0 and rng.random() < 0.7
    values = [[Fraction(0), *(Fraction(rng.randint(-3, 3), 2) for _ in range(p - 1)), Fraction(0)] for _ in range(r)]
    size = rng.choice((Fraction(1, 2), Fraction(1, 3), Fraction(2, 3), Fraction(1, 5), Fraction(1, 9)))
    letters = [[[size * Fraction(rng.randint(-3, 3), 3 * r) for _ in range(r)] for _ in range(r)] for _ in range(p)]
    if rng.random() < 0.3:  # inside nothing but polynomials
        letters = [[[x * (j > i) for j, x in enumerate(row)] for i, row in enumerate(m)] for m in letters]
    maps = []
    for i in range(p):
        powers = binomial_rows(p, i, d)
        rows = [[*row, *[Fraction(0)] * r] for row in powers]
        for k in range(r):
            if smooth:  # x^flat (1-x)^flat at x = (y+i)/p
                q = [Fraction(0)] * (d + 1)
                one = [Fraction(1)]
                for _ in range(flat):
                    one = [a - b for a, b in zip([*one, 0], [0, *one], strict=True)]
                for j, c in enumerate(one):
                    q = [a + c * (k + 1) * b for a, b in zip(q, powers[j + flat], strict=True)]
            else:  # the line between two values at the joints
                q = [values[k][i], values[k][i + 1] - values[k][i], *[Fraction(0)] * (d - 1)]
            rows.append([*q, *letters[i][k]])
        maps.append(rows)
    scheme = of_functions(rng, maps)
    if rng.random() < 0.25:
        return Built(degenerate_part(rng, scheme), "degenerate")
    return Built(scheme, "structured")


def degenerate_part(rng: random.Random, scheme: MatrixFamily) -> MatrixFamily:
    """The scheme with one more control point, mixed into the others, that the curve does not see."""
    operators = [[list(column) for column in zip(*a, strict=True)] for a in scheme.matrices]
    n = len(operators[0])
    larger = []
    for b in operators:
        # the last coordinate shrinks; what it adds to the others sums to what is left of it
        share, more = Fraction(rng.randint(1, 3), 4), [Fraction(rng.randint(-1, 1), 3) for _ in range(n - 1)]
        more = [*more, 1 - share - sum(more)]
        larger.append([*([*row, x] for row, x in zip(b, more, strict=True)), [*[Fraction(0)] * n, share]])
    return family([list(zip(*b, strict=True)) for b in larger])


def segment(rng: random.Random) -> Built:
    """The segment of a mask (1+z)^k times a random cofactor."""
    k, c = rng.randint(1, 3), [Fraction(rng.randint(-2, 6), 8) for _ in range(rng.randint(1, 2))]
    mask = [*c, 1 - sum(c)]
    for _ in range(k):
        mask = [a + b for a, b in zip([*mask, 0], [0, *mask], strict=True)]
    mask = [x / 2 ** (k - 1) for x in mask]
    places = range(-(len(mask) - 2), 1)
    rows = [[mask[i - 2 * j] if 0 <= i - 2 * j < len(mask) else Fraction(0) for j in places] for i in (*places, 1)]
    return Built(family([rows[:-1], rows[1:]]), "segment")


def stochastic(rng: random.Random) -> Built:
    """Random rows of weights, many of them 0, and any ends."""
    n, p = rng.randint(2, 4), rng.choice((2, 2, 3))
    matrices = []
    for _ in range(p):
        rows = []
        for _ in range(n):
            weights = [rng.choice((0, 0, 1, 2)) for _ in range(n)]
            weights = weights if any(weights) else [int(j == 0) for j in range(n)]
            rows.append([Fraction(w, sum(weights)) for w in weights])
        matrices.append(rows)
    return Built(family(matrices), "stochastic")


def signed(rng: random.Random) -> Built:
    """Random rows that sum to 1, of any sign."""
    n, p = rng.randint(2, 4), rng.choice((2, 2, 3))
    matrices = []
    for _ in range(p):
        rows = [[Fraction(rng.randint(-2, 3), 4) for _ in range(n - 1)] for _ in range(n)]
        matrices.append([[*row, 1 - sum(row)] for row in rows])
    return Built(family(matrices), "signed")


def arrays(scheme: MatrixFamily) -> np.ndarray:
    """The B_i in doubles."""
    return np.array([[[float(x) for x in row] for row in m] for m in scheme.matrices]).transpose(0, 2, 1)


def growth(scheme: MatrixFamily, first: int, last: int) -> float:
    """How the largest difference of rows of products of A_i grows from one length to another: near JSR(B | e^⊥)."""
    a = arrays(scheme).transpose(0, 2, 1)
    n = a.shape[1]
    products, sizes = np.eye(n)[None], []
    for length in range(1, last + 1):
        products = np.einsum("pij,kjl->pkil", a, products).reshape(-1, n, n)
        if length in (first, last):
            sizes.append(float(np.abs(products[:, :, None] - products[:, None]).sum(axis=3).max()))
    return (sizes[1] / sizes[0]) ** (1 / (last - first)) if sizes[0] else 0.0


def points(scheme: MatrixFamily, level: int) -> np.ndarray:
    """The points ψ(j p^-level) by doubles, rows; at joints of pieces those of the piece on the right."""
    b = arrays(scheme)
    ends = []
    for letter in (b[0], b[-1]):
        system = np.vstack([letter - np.eye(len(letter)), np.ones(len(letter))])
        ends.append(np.linalg.lstsq(system, np.eye(len(letter) + 1)[-1], rcond=None)[0])
    found = ends[0][None]
    for _ in range(level):
        found = np.concatenate([found @ letter.T for letter in b])
    return np.vstack([found, ends[1]])


def gap(scheme: MatrixFamily) -> float:
    """How far the pieces are apart at the joints."""
    b, ends = arrays(scheme), points(scheme, 0)
    return max(float(np.abs(b[j] @ ends[0] - b[j - 1] @ ends[1]).max()) for j in range(1, len(b)))


_NOISE = 1e-9
"""The size of differences, as a share of the points, below which they may be roundings."""


def estimated(scheme: MatrixFamily, order: int, last: int) -> float:
    """The exponent as differences of an order show it, those across joints among them; inf where they vanish.

    From the last level and four before, or earlier ones where differences are no more than noise.
    """
    p, sizes = len(scheme.matrices), []
    for level in range(next(n for n in range(9) if p**n > 2 * order), last + 1):
        x = points(scheme, level)
        size = float(np.abs(np.diff(x, order, axis=0)).max())
        if size < _NOISE * np.abs(x).max():
            break
        sizes.append(size)
    if len(sizes) < 3:
        return float("inf")
    steps = min(4, len(sizes) - 1)
    return float(-np.log(sizes[-1] / sizes[-1 - steps]) / np.log(p) / steps)
