"""Masks of matrices on Z, for tests: index -> rows of rationals as text."""

from fractions import Fraction

from flint import fmpq, fmpq_mat

from subdiv_cli.spaces.lattice import Lattice
from subdiv_cli.spaces.stencils import StencilSpaces
from subdiv_cli.spaces.transition import TransitionOperators

HERMITE_CUBIC = {
    -1: [["1/2", "-1/8"], ["3/4", "-1/8"]],
    0: [["1", "0"], ["0", "1/2"]],
    1: [["1/2", "1/8"], ["-3/4", "-1/8"]],
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


def box_spline(*directions):
    """The mask on Z^2 of the box spline of these directions, with the dilation 2I."""
    terms = {(0, 0): Fraction(4, 2 ** len(directions))}
    for x, y in directions:
        moved = {(i + x, j + y): value for (i, j), value in terms.items()}
        terms = {index: terms.get(index, 0) + moved.get(index, 0) for index in {**terms, **moved}}
    return {index: [[value]] for index, value in terms.items()}


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
