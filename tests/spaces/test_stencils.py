"""Limit-stencil spaces: published exponents and dimensions, and the identities that the theorems rest on."""

import math
from fractions import Fraction

import numpy as np
import pytest
from flint import fmpq_mat
from hypothesis import given, settings
from hypothesis import strategies as st
from matrix_masks import (
    DGHM,
    DOUBLE_KNOT_CUBIC,
    HERMITE_CUBIC,
    blocked,
    box_spline,
    diagonal,
    merrien,
    scalar,
    spaces,
)

from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.radius import joint_spectral_radius
from subdiv_cli.model import Effort
from subdiv_cli.spaces.closure import invariant_space
from subdiv_cli.spaces.lattice import indices_of_degree
from subdiv_cli.spaces.stencils import difference

FOUR_POINT = ("-1/16", 0, "9/16", 1, "9/16", 0, "-1/16")
SIX_POINT = [Fraction(x, 256) for x in (3, 0, -25, 0, 150, 256, 150, 0, -25, 0, 3)]
CHAIKIN, CUBIC = ("1/4", "3/4", "3/4", "1/4"), ("1/8", "1/2", "3/4", "1/2", "1/8")
HAT, FLAT = ("1/2", 1, "1/2"), ("1/2",) * 4
DYING_HAT = {index: [[Fraction(3, 4) * Fraction(x)]] for index, ((x,),) in scalar(HAT).items()}
TWICE = ((2, 0), (0, 2))
ZWART_POWELL = ((1, 0), (0, 1), (1, 1), (1, -1))
QUINCUNX = {index: [["1/4"]] for index in ((1, 0), (-1, 0), (0, 1), (0, -1))} | {(0, 0): [[1]]}


def radius(space):
    return joint_spectral_radius(Family(space.matrices), Effort())


def exponent(found, k):
    """-log_λ of the radius on V_k(w), which is asked to be exact, and the dimension of V_k(w)."""
    lattice, space = found.operators.lattice, found.differences(k).space
    known = radius(space)
    assert known.exact is not None
    return -known.ceiling / math.log2(lattice.index ** (1 / lattice.dimension)), space.dimension


@pytest.mark.parametrize(
    ("mask", "k", "alpha", "dimension"),
    [
        (HERMITE_CUBIC, 3, 2, 3),
        (DOUBLE_KNOT_CUBIC, 4, 2, 2),
        (DGHM, 2, 1, 3),
        (merrien("-1/8", -1), 3, 2, 2),
        (merrien("-1/8", "1/2"), 3, math.log2(8 / 3), 3),
        (merrien("-1/8", 0), 3, 2, 3),
        (merrien("-1/8", "1/4"), 3, math.log2(16 / 5), 3),
        (merrien("-1/8", -2), 3, 2, 3),
        (merrien("-1/8", "-5/2"), 3, math.log2(8 / 3), 3),
        (merrien("-1/10", "-1/2"), 3, 1.564819774, 4),
        (merrien("-1/16", "-1/2"), 3, 1.276321031, 4),
        (merrien("-1/4", "-1/2"), 3, 1.246275106, 4),
        (scalar(CUBIC), 4, 3, 1),
        (scalar(SIX_POINT), 6, math.log2(64 / 9), 5),
        (scalar(FLAT), 2, 1, 1),
        (scalar([Fraction(x, 4) for x in (1, 1, 2, 2, 1, 1)]), 3, 2, 1),
        (diagonal(scalar(FOUR_POINT), scalar(FOUR_POINT)), 4, 2, 6),
        (diagonal(scalar(CUBIC), DYING_HAT), 4, 3, 1),
    ],
)
def test_masks_on_the_line(mask, k, alpha, dimension):
    """KINDS section 2, of which the dimensions are those of the least V_k(w)."""
    found, of = exponent(spaces(mask), k)
    assert found == pytest.approx(alpha, abs=1e-9)
    assert of == dimension


@pytest.mark.parametrize(
    ("mask", "dilation", "k", "alpha", "dimension"),
    [
        (box_spline(*ZWART_POWELL), TWICE, 3, 2, 8),
        (box_spline(*ZWART_POWELL * 2), TWICE, 6, 5, 18),
        (box_spline(*((1, 0), (0, 1), (1, 1)) * 2), TWICE, 4, 3, 13),
        (QUINCUNX, ((1, 1), (1, -1)), 3, 2 - 2 * math.log2((1 + math.sqrt(5)) / 2), 18),
    ],
)
def test_masks_in_the_plane(mask, dilation, k, alpha, dimension):
    """Box splines, the unstable ones of Zwart & Powell and of the 4-8 scheme too, and the quincunx scheme."""
    found, of = exponent(spaces(mask, dilation), k)
    assert found == pytest.approx(alpha, abs=1e-9)
    assert of == dimension


@pytest.mark.parametrize("size", [2, 3])
@pytest.mark.parametrize(
    ("coefficients", "alpha"), [(CHAIKIN, 2), (CUBIC, 3), (FOUR_POINT, 2), (SIX_POINT, math.log2(64 / 9)), (FLAT, 1)]
)
def test_blocking_changes_no_exponent(coefficients, alpha, size):
    found = spaces(blocked(coefficients, -len(coefficients) // 2, size))
    assert found.constants.nrows() == 1
    assert exponent(found, math.floor(alpha) + 1)[0] == pytest.approx(alpha, abs=1e-9)


def test_the_radius_decides_convergence():
    converges = {"hat": scalar(HAT), "flat": scalar(FLAT), "hermite": HERMITE_CUBIC}
    diverges = {"haar": scalar([1, 1]), "in z^3": scalar([Fraction(x, 4) for x in (1, 0, 0, 3, 0, 0, 3, 0, 0, 1)])}
    assert all(radius(spaces(mask).decay.space).is_below(Fraction(1)) for mask in converges.values())
    assert not any(radius(spaces(mask).decay.space).is_below(Fraction(1)) for mask in diverges.values())


def test_a_triangular_scheme_diverges_though_every_matrix_has_the_constants():
    """tri(hat, 1-z, hat): the sums over both classes are I but for the corner, and the corner does not die out."""
    corner = {0: [[1]], 1: [[-1]]}
    hat = scalar(HAT, -1)
    mask = {
        i: [[hat.get(i, [[0]])[0][0], corner.get(i, [[0]])[0][0]], [0, hat.get(i, [[0]])[0][0]]]
        for i in sorted({*hat, *corner})
    }
    found = spaces(mask)
    assert found.constants.nrows() == 1
    assert not radius(found.decay.space).is_below(Fraction(1))


@pytest.mark.parametrize("mask", [HERMITE_CUBIC, DOUBLE_KNOT_CUBIC, DGHM, diagonal(scalar(CUBIC), scalar(HAT))])
def test_limit_stencils_are_fixed_and_dual_to_the_constants(mask):
    found = spaces(mask)
    window = found.operators.window
    operator = found.operators.on(window)[0]
    r, m = found.constants.nrows(), found.operators.size
    for i, w in enumerate(found.stencils):
        row = fmpq_mat([[x for alpha in window for x in w.get(alpha, [0] * m)]])
        assert row * operator.transpose() == row
        total = fmpq_mat([[sum(column) for column in zip(*w.values(), strict=True)]])
        assert (total * found.constants.transpose()).entries() == [int(i == j) for j in range(r)]


small = st.fractions(min_value=-2, max_value=2, max_denominator=4)


@st.composite
def masks(draw):
    """A mask of m×m matrices on Z of arity 2 or 3, data, and a sequence."""
    m, p = draw(st.integers(1, 2)), draw(st.integers(2, 3))
    rows = st.lists(st.lists(small, min_size=m, max_size=m), min_size=m, max_size=m)
    mask = draw(st.dictionaries(st.integers(-4, 4), rows, min_size=1, max_size=4))
    vectors = st.dictionaries(st.integers(-3, 3), st.lists(small, min_size=m, max_size=m), min_size=1, max_size=3)
    return p, mask, draw(vectors), draw(vectors)


@settings(max_examples=60)
@given(masks())
def test_operators_answer_for_the_scheme(drawn):
    """(v * S c)(ε + p a) = (T_ε v * c)(a), with S as it is defined."""
    p, mask, v, c = drawn
    if not any(x for rows in mask.values() for row in rows for x in row):
        return
    found = spaces(mask, ((p,),)).operators
    (start,) = found.corner
    refined = {}
    for i, rows in mask.items():
        for j, x in c.items():
            old = refined.get(i + p * j, [Fraction(0)] * len(x))
            refined[i + p * j] = [
                y + sum(a * b for a, b in zip(row, x, strict=True)) for y, row in zip(old, rows, strict=True)
            ]

    def paired(left, right, at):
        return sum(a * b for j, x in right.items() if at - j in left for a, b in zip(left[at - j], x, strict=True))

    window = found.closed_window((i,) for i in v)
    m = found.size
    column = fmpq_mat([[x] for (i,) in window for x in map(to_fmpq, v.get(i, [Fraction(0)] * m))])
    for epsilon, operator in enumerate(found.on(window)):
        image = (operator * column).entries()
        moved = {i: [Fraction(int(x.p), int(x.q)) for x in image[m * k : m * k + m]] for k, (i,) in enumerate(window)}
        for a in range(-8, 9):
            assert paired(v, refined, start + epsilon + p * a) == paired(moved, c, a)


@pytest.mark.parametrize("mask", [HERMITE_CUBIC, DGHM, merrien("-1/10", "-1/2"), scalar(FOUR_POINT), scalar(FLAT)])
def test_differences_of_the_limit_decay_as_the_radius_says(mask):
    """Floats: the largest words of length 10 on V_2(w) against the exact radius."""
    found = spaces(mask)
    space = found.differences(2).space
    rows = [np.array([[float(x) for x in row] for row in m.tolist()]) for m in space.matrices]
    products, norms = [np.eye(space.dimension)], []
    for _ in range(12):
        products = [m @ product for m in rows for product in products]
        norms.append(max(np.linalg.norm(product, 2) for product in products))
    assert (norms[11] / norms[5]) ** (1 / 6) == pytest.approx(2 ** radius(space).ceiling, rel=0.2)


def test_transients_are_left_to_the_tree():
    """M e_1 = e_2, M e_2 = e_2 / 2: e_1 is replaced by its image, and the space is a line."""
    m = fmpq_mat([[0, 0], [1, fmpq_mat([[1]])[0, 0] / 2]])
    space = invariant_space([m], fmpq_mat([[1, 0]]))
    assert (space.tree, space.dimension, space.origins) == ((False, True), 1, ((0, ()),))
    assert (space.leaves * space.basis).tolist() == [[0, 1]]


def test_a_nilpotent_family_has_the_space_0():
    space = invariant_space([fmpq_mat([[0, 1], [0, 0]])], fmpq_mat([[0, 1]]))
    assert (space.dimension, space.origins) == (0, ())


def beside(hat, block, arity):
    """A scheme on a line beside one that dies out: its matrices A_0, …, A_(arity-1) are all the block."""
    n = block.nrows()
    zero, entries = [0] * n, [[Fraction(int(x.p), int(x.q)) for x in row] for row in block.tolist()]
    mask = {i: [[x[0][0], *zero]] + [[0, *zero] for _ in range(n)] for i, x in hat.items()}
    for i in range(arity):
        top = mask.get(i, [[0, *zero]])[0]
        mask[i] = [top, *([0, *row] for row in entries)]
    return mask


def test_a_tree_of_many_images_gives_way_to_the_vectors_themselves():
    """A dying block with 9 steps to 0 has 7^9 images in arity 7: the space keeps its transients."""
    steps = fmpq_mat(9, 9, [int(j == i + 1) for i in range(9) for j in range(9)])
    hat = scalar([Fraction(x, 7) for x in (1, 2, 3, 4, 5, 6, 7, 6, 5, 4, 3, 2, 1)])
    space = spaces(beside(hat, steps, 7), ((7,),)).decay.space
    assert all(space.tree)
    assert radius(space).is_below(Fraction(1))


def test_a_denominator_may_be_a_modulus_of_the_search():
    block = fmpq_mat([[1]]) / (2**61 - 1)
    found = spaces(beside(scalar(HAT), block, 2))
    assert radius(found.decay.space).is_below(Fraction(1))
    assert exponent(found, 2)[0] == pytest.approx(1, abs=1e-9)


def integers(rows, columns, most):
    """A strategy for matrices of small integers."""
    return st.lists(
        st.lists(st.integers(-most, most), min_size=columns, max_size=columns), min_size=rows, max_size=rows
    )


FAMILIES = st.integers(2, 4).flatmap(
    lambda n: st.tuples(st.lists(integers(n, n, 1), min_size=1, max_size=2), integers(2, n, 2))
)


@settings(max_examples=40)
@given(FAMILIES)
def test_the_space_is_invariant_and_spanned_by_its_words(drawn):
    matrices, vectors = [fmpq_mat(m) for m in drawn[0]], fmpq_mat(drawn[1])
    space = invariant_space(matrices, vectors)
    basis = space.basis
    for m, on_basis in zip(matrices, space.matrices, strict=True):
        assert m * basis.transpose() == basis.transpose() * on_basis
    if space.dimension:
        words = []
        for leaf, word in space.origins:
            column = fmpq_mat([[x] for x in space.leaves.tolist()[leaf]])
            for letter in word:
                column = space.matrices[letter] * column
            words.append(column.entries())
        assert fmpq_mat(words).rank() == space.dimension


@pytest.mark.parametrize("mu", [*indices_of_degree(2, 3), (4,)])
def test_differences_annihilate_polynomials_of_lower_degree(mu):
    v = difference(mu)
    for total in range(sum(mu)):
        for power in indices_of_degree(len(mu), total):
            assert not sum(x * math.prod(i**e for i, e in zip(alpha, power, strict=True)) for alpha, x in v.items())
