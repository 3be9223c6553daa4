"""Masks of matrices on Z, for tests: index -> rows of rationals as text."""

import math
from fractions import Fraction

from flint import fmpq, fmpq_mat

from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.spaces.lattice import Lattice
from subdiv_cli.spaces.stencils import StencilSpaces
from subdiv_cli.spaces.transition import TransitionOperators

HERMITE_CUBIC = {
    -1: [["1/2", "-1/8"], ["3/4", "-1/8"]],
    0: [["1", "0"], ["0", "1/2"]],
    1: [["1/2", "1/8"], ["-3/4", "-1/8"]],
}
HERMITE_QUINTIC = {
    -1: [["1/2", "-5/32", "1/64"], ["15/16", "-7/32", "1/64"], ["0", "3/8", "-1/16"]],
    0: [["1", "0", "0"], ["0", "1/2", "0"], ["0", "0", "1/4"]],
    1: [["1/2", "5/32", "1/64"], ["-15/16", "-7/32", "-1/64"], ["0", "-3/8", "-1/16"]],
}
DOUBLE_KNOT_CUBIC = {
    0: [["1/4", "0"], ["5/8", "1/8"]],
    1: [["3/4", "1/4"], ["1/4", "3/4"]],
    2: [["1/8", "5/8"], ["0", "1/4"]],
}
DGHM = {
    0: [["3/5", "-1/10"], ["4/5", "-3/10"]],
    1: [["3/5", "9/10"], ["0", "1"]],
    2: [["0", "9/10"], ["0", "-3/10"]],
    3: [["0", "-1/10"], ["0", "0"]],
}


def merrien(lam, mu):
    """Merrien's family of Hermite schemes with two components."""
    lam, mu = Fraction(lam), Fraction(mu)
    return {
        -1: [["1/2", lam], [(1 - mu) / 2, mu / 4]],
        0: [["1", "0"], ["0", "1/2"]],
        1: [["1/2", -lam], [-(1 - mu) / 2, mu / 4]],
    }


def hermite_interpolation(components, arity=2):
    """Interpolation of jets by polynomials of degree 2·components - 1 on every interval, by Hermite's equations."""
    d, n = components, 2 * components
    jet = lambda i, x, k: Fraction(math.perm(i, k)) * Fraction(x) ** (i - k) if i >= k else Fraction(0)  # noqa: E731
    ends = fmpq_mat([[_rational(jet(i, x, k)) for i in range(n)] for x in (0, 1) for k in range(d)]).inv()
    mask = {0: [[Fraction(int(k == l), arity**k) for l in range(d)] for k in range(d)]}
    for r in range(1, arity):
        values = fmpq_mat([[_rational(jet(i, Fraction(r, arity), k) / arity**k) for i in range(n)] for k in range(d)])
        rows = [[Fraction(int(x.p), int(x.q)) for x in row] for row in (values * ends).tolist()]
        mask[r], mask[r - arity] = [row[:d] for row in rows], [row[d:] for row in rows]
    return mask


def de_rham(mask):
    """The de Rham transform of a binary Hermite mask: A_i = D^-1 (A∘A)_(2i+1), A∘A that of two steps."""
    twice = {}
    for i, a in mask.items():
        for j, b in mask.items():
            found, k = times(a, b), i + 2 * j
            old = twice.get(k, [[0] * len(a)] * len(a))
            twice[k] = [[x + y for x, y in zip(r, s, strict=True)] for r, s in zip(old, found, strict=True)]
    return {(k - 1) // 2: [[2**j * x for x in row] for j, row in enumerate(a)] for k, a in twice.items() if k % 2}


def smoothed_jets(mask):
    """Procedure 40 of Moosmüller & Dyn for functions and their derivatives, formula (43)."""
    a11, a12, a21, a22 = ({i: Fraction(a[r][c]) for i, a in mask.items()} for r in (0, 1) for c in (0, 1))
    zeta = 1 + sum(a12.values()) / (2 - sum(a22.values()))
    z = lambda **powers: {-int(k[1:]): Fraction(x) for k, x in powers.items()}  # noqa: E731, d2=x is x z^-2
    square, half, rest = zeta**2, z(d0=Fraction(1, 2)), 1 - zeta
    c11 = product(half, z(d1=1, d0=1), sum_of(
        product(a12, z(d3=zeta - square, d2=square, d1=square - 1, d0=-square - zeta)),
        product(a11, z(d1=zeta * rest, d0=square)),
        product(a22, z(d2=zeta * -rest, d0=(zeta + 1) * rest)),
        product(a21, z(d0=square - zeta)),
    ))  # fmt: skip
    numerator = product(half, sum_of(
        product(a12, z(d3=rest**2, d2=zeta * rest, d1=zeta * rest, d0=square)),
        product(a22, z(d2=-(rest**2), d0=rest**2 - rest)),
        product(a11, z(d1=rest**2, d0=rest - rest**2)),
        product(a21, z(d0=-(rest**2))),
    ))  # fmt: skip
    c12, total = {}, Fraction(0)
    for i in range(max(numerator), min(numerator) - 1, -1):  # divided by z^-1 - 1
        total -= numerator.get(i, 0)
        c12[i] = total
    assert total == 0
    c21 = product(half, z(d2=1, d0=-1), sum_of(
        product(a12, z(d3=-square, d2=zeta + square, d1=zeta + square, d0=-((zeta + 1) ** 2))),
        product(a11, z(d1=-square, d0=zeta + square)),
        product(a22, z(d2=square, d0=-square - zeta)),
        product(a21, z(d0=square)),
    ))  # fmt: skip
    c22 = product(half, sum_of(
        product(a12, z(d3=square - zeta, d2=1 - square, d1=-square, d0=square + zeta)),
        product(a11, z(d1=-zeta * rest, d0=rest * (1 + zeta))),
        product(a22, z(d2=zeta * rest, d0=square)),
        product(a21, z(d0=zeta - square)),
    ))  # fmt: skip
    support = sorted({i for f in (c11, c12, c21, c22) for i, x in f.items() if x})
    return {i: [[c11.get(i, 0), c12.get(i, 0)], [c21.get(i, 0), c22.get(i, 0)]] for i in support}


def product(*factors):
    """The product of Laurent polynomials, exponent -> coefficient."""
    total = {0: Fraction(1)}
    for f in factors:
        found = {}
        for i, x in total.items():
            for j, y in f.items():
                found[i + j] = found.get(i + j, 0) + x * y
        total = found
    return total


def sum_of(*terms):
    """The sum of Laurent polynomials."""
    return {i: sum(f.get(i, 0) for f in terms) for i in {i for f in terms for i in f}}


UNSEEN = {
    0: [["1/4", 0], ["1/16", 0]],
    1: [["1/4", 0], ["1/16", 0]],
    2: [["1/2", 0], ["1/8", 0]],
    3: [["1/2", 0], ["1/8", 0]],
    4: [["1/4", 0], [0, 0]],
    5: [["1/4", 0], [0, 0]],
    6: [[0, 0], ["-1/8", 0]],
    7: [[0, 0], ["-1/8", 0]],
    8: [[0, 0], ["-1/16", 0]],
    9: [[0, 0], ["-1/16", 0]],
}
"""φ of the mask (1,1,2,2,1,1)/4, which is not stable, with the derivative as a difference of its limit stencil."""


def scalar(coefficients, start=0):
    """A scalar mask on Z."""
    return {start + i: [[x]] for i, x in enumerate(coefficients)}


def diagonal(*masks):
    """The mask of schemes that do not see each other, of scalar masks."""
    support = sorted({i for mask in masks for i in mask})
    rows = range(len(masks))
    return {i: [[masks[r].get(i, [[0]])[0][0] if r == c else 0 for c in rows] for r in rows] for i in support}


def blocked(coefficients, start, size):
    """The scalar mask that acts on blocks of `size` neighbours: entry (r, c) of A_i is a_(r + size i - 2 c)."""
    a = {start + i: Fraction(x) for i, x in enumerate(coefficients)}
    low, high = min(a) - size, max(a) + 2 * size
    return {
        i: [[a.get(r + size * i - 2 * c, 0) for c in range(size)] for r in range(size)]
        for i in range(low // size - 1, high // size + 2)
        if any(a.get(r + size * i - 2 * c, 0) for c in range(size) for r in range(size))
    }


def spline(degree, multiplicity, arity=2):
    """The mask of splines with a knot of this multiplicity at every integer, by blossoms (Ramshaw; de Boor).

    The control points of index k are those numbered multiplicity·k + r, r = 0, …: point i is the blossom of the spline
    at the knots t_(i+1), …, t_(i+degree).
    """

    def knot(i, fineness=1):
        return Fraction(i // multiplicity, fineness)

    def blossom(piece, arguments, one):
        """The weight of control point `one` in the blossom of the piece on [t_piece, t_(piece+1)]."""
        points = {j: Fraction(j == one) for j in range(piece - degree, piece + 1)}
        for r, u in enumerate(arguments, 1):
            for j in range(piece, piece - degree + r - 1, -1):
                low, high = knot(j), knot(j + degree + 1 - r)
                points[j] = ((high - u) * points[j - 1] + (u - low) * points[j]) / (high - low)
        return points[piece]

    mask = {}
    for i in range(-3 * arity, 3 * arity + degree * arity):
        for r in range(multiplicity):
            fine = multiplicity * i + r
            inside = next(l for l in range(fine, fine + degree + 1) if knot(l) != knot(l + 1))
            piece = multiplicity * (inside // multiplicity // arity) + multiplicity - 1
            arguments = [knot(fine + k, arity) for k in range(1, degree + 1)]
            for s in range(multiplicity):
                weight = blossom(piece, arguments, s) if piece - degree <= s <= piece else Fraction(0)
                mask.setdefault(i, [[Fraction(0)] * multiplicity for _ in range(multiplicity)])[r][s] = weight
    return {i: rows for i, rows in mask.items() if any(map(any, rows))}


def times(a, b):
    """The product of two matrices by rows."""
    return [
        [sum(Fraction(x) * Fraction(y) for x, y in zip(row, column, strict=True)) for column in zip(*b, strict=True)]
        for row in a
    ]


def conjugated(mask, change, inverse):
    """The mask R^-1 A_i R."""
    return {i: times(inverse, times(rows, change)) for i, rows in mask.items()}


def smoothed(mask, change, inverse):
    """Procedure 23 of Moosmüller & Dyn for 2×2 matrices with E_A of dimension 1; R has it in its first column."""
    bar, zero = conjugated(mask, change, inverse), [[Fraction(0)] * 2] * 2
    at = lambda i, r, c: bar.get(i, zero)[r][c]  # noqa: E731
    low, high = min(bar) - 2, max(bar)
    found, quotient = {}, Fraction(0)
    for i in range(high, low - 1, -1):
        # (z^-1 - 1) q = A_12 says q_(i+1) - q_i = A_12 at i
        quotient -= at(i, 0, 1)
        rows = [[at(i + 1, 0, 0) + at(i, 0, 0), quotient], [at(i + 2, 1, 0) - at(i, 1, 0), at(i, 1, 1)]]
        found[i] = [[x / 2 for x in row] for row in rows]
    assert quotient == 0
    return conjugated({i: a for i, a in found.items() if any(map(any, a))}, inverse, change)


def box_spline(*directions):
    """The mask on Z^2 of the box spline of these directions, with the dilation 2I."""
    terms = {(0, 0): Fraction(4, 2 ** len(directions))}
    for x, y in directions:
        moved = {(i + x, j + y): value for (i, j), value in terms.items()}
        terms = {index: terms.get(index, 0) + moved.get(index, 0) for index in {**terms, **moved}}
    return {index: [[value]] for index, value in terms.items()}


def scheme(mask, arity=2, kind="vector"):
    """The scheme of a mask, of vectors or of jets."""
    m, low, high = len(next(iter(mask.values()))), min(mask), max(mask)
    rows = [mask.get(i, [[0] * m] * m) for i in range(low, high + 1)]
    coefficients = tuple(tuple(tuple(map(Fraction, row)) for row in matrix) for matrix in rows)
    return VectorScheme(arity=arity, start=low, coefficients=coefficients, kind=kind)


def spaces(mask, dilation=((2,),)):
    """The limit-stencil spaces of a mask."""
    terms = {
        index if isinstance(index, tuple) else (index,): fmpq_mat([[_rational(x) for x in row] for row in rows])
        for index, rows in mask.items()
    }
    return StencilSpaces(TransitionOperators(Lattice(dilation), terms))


def _rational(x):
    x = Fraction(x)
    return fmpq(x.numerator, x.denominator)
