"""Moosmüller & Dyn 2018, Increasing the smoothness of vector and Hermite subdivision schemes, sections 2 and 4."""

import math
from dataclasses import replace
from fractions import Fraction

import pytest
from flint import fmpq, fmpq_mat
from matrix_masks import (
    DGHM,
    DOUBLE_KNOT_CUBIC,
    HERMITE_CUBIC,
    blocked,
    diagonal,
    merrien,
    scalar,
    scheme,
    smoothed,
    spline,
)
from support import b_spline

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.kinds.smoothing import smoothing_steps
from subdiv_cli.kinds.vector.numbers.derived import canonical_transformation
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers
from subdiv_cli.model import Effort, Smoothness, Verdict
from subdiv_cli.model.closed import spelled
from subdiv_cli.pipeline import check

FOUR_POINT = ("-1/16", 0, "9/16", 1, "9/16", 0, "-1/16")
SIX_POINT = [Fraction(x, 256) for x in (3, 0, -25, 0, 150, 256, 150, 0, -25, 0, 3)]
CHAIKIN, CUBIC, FLAT = ("1/4", "3/4", "3/4", "1/4"), ("1/8", "1/2", "3/4", "1/2", "1/8"), ("1/2",) * 4
FOUR_POINT_3_20 = ("-3/20", 0, "13/20", 1, "13/20", 0, "-3/20")


def answer(mask, arity=2):
    return check(scheme(mask, arity), (), Effort()).result


def columns(mask):
    """The second column of the canonical transformation, by its first entry."""
    numbers = VectorNumbers(scheme(mask), Effort())
    found, r = canonical_transformation(2, dict(enumerate(numbers.matrices, numbers.scheme.start)))
    assert r == 1
    ratio = found[1, 1] / found[0, 1]
    return Fraction(int(ratio.p), int(ratio.q)), [[Fraction(int(x.p), int(x.q)) for x in row] for row in found.tolist()]


def once_smoother(mask):
    """Procedure 23."""
    _, change = columns(mask)
    (a, b), (c, d) = change
    det = a * d - b * c
    return smoothed(mask, change, [[d / det, -b / det], [-c / det, a / det]])


def test_example_27_is_the_scheme_of_splines_with_double_knots():
    """(24): B(z) = ((2+6z+z^2, 2z+5z^2), (5+2z, 1+6z+2z^2)) / 8."""
    eighths = {i: [[8 * Fraction(x) for x in row] for row in a] for i, a in DOUBLE_KNOT_CUBIC.items()}
    assert eighths == {0: [[2, 0], [5, 1]], 1: [[6, 2], [2, 6]], 2: [[1, 5], [0, 2]]}
    assert spline(3, 2) == {i: [[Fraction(x) for x in row] for row in a] for i, a in DOUBLE_KNOT_CUBIC.items()}


def test_example_27_spectra():
    """(25): B(1) has the eigenvalues 2 and 1/4, for (1, 1) and (-1, 1)."""
    numbers = VectorNumbers(scheme(DOUBLE_KNOT_CUBIC), Effort())
    assert numbers.constants == ((1, 1),)
    assert [(Fraction(str(x)), n) for x, n in (numbers.mean * 2).charpoly().roots()] == [(2, 1), (Fraction(1, 4), 1)]


def test_example_27_smoothed():
    """32 A_11 = 4z^2+19z+15+4z^-1-2z^-2: the paper has z^-1 for z in one entry of the step before."""
    found = once_smoother(DOUBLE_KNOT_CUBIC)
    assert {i: 32 * a[0][0] for i, a in found.items()} == {2: 4, 1: 19, 0: 15, -1: 4, -2: -2}


def step(mask, *, inverse=False):
    """What `subdiv smooth` makes of a scheme."""
    return smoothing_steps(mask, 1, inverse=inverse)[0].scheme


def test_example_7():
    """The smoothing operator leads from splines of one degree to those of the next: (1+z)/2 z^-1 times the symbol."""
    for degree in range(4):
        spline_of = b_spline(degree)
        assert step(spline_of) == replace(b_spline(degree + 1), start=-1)
        assert step(step(spline_of), inverse=True) == spline_of


@pytest.mark.parametrize("mask", [DOUBLE_KNOT_CUBIC, DGHM, spline(4, 2), blocked(FOUR_POINT, -3, 2)])
def test_procedure_23_is_what_smooth_does(mask):
    """Three times over: (14) by entries, in coordinates of a canonical transformation; the support of corollary 25."""
    for _ in range(3):
        smooth = once_smoother(mask)
        assert step(scheme(mask)) == scheme(smooth)
        assert min(mask) - 2 <= min(smooth)
        assert max(smooth) <= max(mask)
        mask = smooth


def test_example_27_in_the_catalog():
    """The shipped masks are what `smooth` makes of the double-knot cubics, coefficient for coefficient."""
    names = ("double_knot_cubic", "double_knot_cubic_smoothed", "double_knot_cubic_smoothed_twice")
    one, two, three = (read_path(masks_directory() / "vector" / f"{name}.toml").scheme() for name in names)
    assert one == scheme(DOUBLE_KNOT_CUBIC)
    assert [smooth.scheme for smooth in smoothing_steps(one, 2)] == [two, three]


def test_corollary_26_on_example_27():
    """(27): A(1) has the eigenvalues 2 and 1/8, for (1, 1) and (-2, 3)."""
    mean = VectorNumbers(step(scheme(DOUBLE_KNOT_CUBIC)), Effort()).mean * 2
    assert [(Fraction(str(x)), n) for x, n in mean.charpoly().roots()] == [(2, 1), (Fraction(1, 8), 1)]
    assert mean * fmpq_mat([[1, -2], [1, 3]]) == fmpq_mat([[2, fmpq(-1, 4)], [2, fmpq(3, 8)]])


def test_the_derived_scheme_leads_back_where_one_transformation_serves_both():
    """(16): I ∂ A = A for A = I B, and ∂ I B = B if the canonical transformation of I B is that of B."""
    b = scheme(DOUBLE_KNOT_CUBIC)
    a = step(b)
    assert step(step(a, inverse=True)) == a
    assert step(a, inverse=True) != b  # the columns are (1, -3/2) and (1, -1)
    two = scheme(diagonal(scalar(FOUR_POINT, -3), scalar(CHAIKIN)))
    assert step(step(two), inverse=True) == two


def test_example_27_gains_one_order_each_time():
    """C^1, C^2, C^3, C^4; the second canonical columns are (1,-1), (1,-3/2), (1,-11/9)."""
    mask, ratios = DOUBLE_KNOT_CUBIC, []
    for alpha in (2, 3, 4, 5):
        result = answer(mask)
        assert (result.smoothness, result.holder.exact) == (Smoothness(alpha - 1, True), alpha)
        ratios.append(columns(mask)[0])
        mask = once_smoother(mask)
    assert ratios[:3] == [-1, Fraction(-3, 2), Fraction(-11, 9)]


@pytest.mark.parametrize("name", ["double-knot cubic", "DGHM"])
def test_procedure_23_raises_the_exponent_by_one(name):
    mask = {"double-knot cubic": DOUBLE_KNOT_CUBIC, "DGHM": DGHM}[name]
    assert answer(once_smoother(mask)).holder.exact == answer(mask).holder.exact + 1


@pytest.mark.parametrize(
    ("mask", "derivations", "level", "norm"),
    [(DOUBLE_KNOT_CUBIC, 2, 3, "31/32"), (HERMITE_CUBIC, 2, 3, "31/32"), (DGHM, 1, 4, "20851/30000")],
)
def test_theorems_9_and_11(mask, derivations, level, norm):
    """The last derived scheme that contracts proves the order that the exact route has."""
    result = answer(mask)
    (found,) = [finding for finding in result.findings if finding.code == "SD713"]
    assert found.verdict is Verdict.PROVED
    assert (found.witness["derivations"], found.witness["level"], found.witness["norm"]) == (
        derivations, level, Fraction(norm),
    )  # fmt: skip
    assert found.witness["order"] == result.smoothness.order


def test_theorem_19_and_corollary_20():
    hat, jordan = scalar(("1/2", 1, "1/2"), -1), {}
    for i, ((x,),) in hat.items():
        jordan[i] = [[x, x], [0, x]]
    (found,) = [finding for finding in answer(jordan).findings if finding.code == "SD703"]
    assert found.verdict is Verdict.REFUTED
    assert answer(jordan).convergent is Verdict.REFUTED


def test_the_identity_as_mean_does_not_suffice():
    """Theorem 19 is necessary only: tri(hat, 1-z, hat) has M_A = 1 and E_A of dimension 1, and diverges."""
    mask = {-1: [["1/2", 0], [0, "1/2"]], 0: [[1, 1], [0, 1]], 1: [["1/2", -1], [0, "1/2"]]}
    result = answer(mask)
    assert (result.dimension, result.convergent) == (1, Verdict.REFUTED)


TABLE = [
    ("double-knot cubic", DOUBLE_KNOT_CUBIC, "2", 1),
    ("DGHM", DGHM, "1", 0),
    ("cubic Hermite", HERMITE_CUBIC, "2", 1),
    ("Merrien -1/8, 1/2", merrien("-1/8", "1/2"), "log2(8/3)", 1),
    ("Merrien -1/8, 0", merrien("-1/8", 0), "2", 1),
    ("Merrien -1/8, 1/4", merrien("-1/8", "1/4"), "log2(16/5)", 1),
    ("Merrien -1/8, -2", merrien("-1/8", -2), "2", 1),
    ("Merrien -1/8, -5/2", merrien("-1/8", "-5/2"), "log2(8/3)", 1),
    ("two four-point schemes", diagonal(scalar(FOUR_POINT), scalar(FOUR_POINT)), "2", 1),
    ("Chaikin by 2", blocked(CHAIKIN, -1, 2), "2", 1),
    ("Chaikin by 3", blocked(CHAIKIN, -1, 3), "2", 1),
    ("cubic by 2", blocked(CUBIC, -2, 2), "3", 2),
    ("cubic by 3", blocked(CUBIC, -2, 3), "3", 2),
    ("four-point by 2", blocked(FOUR_POINT, -3, 2), "2", 1),
    ("four-point by 3", blocked(FOUR_POINT, -3, 3), "2", 1),
    ("six-point by 2", blocked(SIX_POINT, -5, 2), "log2(64/9)", 2),
    ("six-point by 3", blocked(SIX_POINT, -5, 3), "log2(64/9)", 2),
    ("(1,1,1,1)/2 by 2", blocked(FLAT, 0, 2), "1", 0),
    ("(1,1,1,1)/2 by 3", blocked(FLAT, 0, 3), "1", 0),
]
"""Exponents of published schemes, and the scalar ones of blocks."""


@pytest.mark.parametrize(("mask", "alpha", "order"), [row[1:] for row in TABLE], ids=[row[0] for row in TABLE])
def test_published_exponents(mask, alpha, order):
    result = answer(mask)
    assert spelled(result.holder.exact) == alpha
    assert result.smoothness == Smoothness(order, True)


@pytest.mark.parametrize(
    ("lam", "mu", "alpha"),
    [("-1/10", "-1/2", "1.564819774"), ("-1/16", "-1/2", "1.276321031"), ("-1/4", "-1/2", "1.246275106")],
)
def test_merrien_schemes_with_algebraic_exponents(lam, mu, alpha):
    found = answer(merrien(lam, mu)).holder
    assert found.exact is not None
    assert round(Fraction(found.digits.rstrip("…")), 9) == Fraction(alpha)


@pytest.mark.parametrize("size", [2, 3])
def test_the_four_point_scheme_with_3_20_in_blocks(size):
    """The exponent of the scalar scheme, 1.2228557…, whose product has two letters."""
    found = answer(blocked(FOUR_POINT_3_20, -3, size)).holder
    assert found.exact is not None
    assert found.digits.startswith("1.22285")


@pytest.mark.parametrize(
    ("degree", "multiplicity"), [(d, m) for d in range(1, 6) for m in range(1, 4) if m <= d], ids=str
)
def test_splines_with_multiple_knots(degree, multiplicity):
    """Knots of multiplicity m in splines of degree d leave C^(d-m) and no more: α = d - m + 1."""
    result = answer(spline(degree, multiplicity))
    assert result.holder.exact == degree - multiplicity + 1
    assert result.smoothness == Smoothness(degree - multiplicity, True)
    assert (result.generation, result.dimension) == (degree, 1)


def test_a_ternary_scheme_of_splines():
    result = answer(spline(3, 2, 3), 3)
    assert (result.holder.exact, result.smoothness, result.generation) == (2, Smoothness(1, True), 3)


def test_what_dies_out_may_be_invisible_or_not():
    """A cubic spline beside a hat times 3/4 has α = 3; fed by it, log2(4/3), whatever the rest does."""
    dying = {-1: "3/8", 0: "3/4", 1: "3/8"}
    cubic = dict(zip(range(-2, 3), CUBIC, strict=True))
    beside = {i: [[cubic[i], 0], [0, dying.get(i, 0)]] for i in cubic}
    fed = {i: [[cubic[i], "1/4" if i == 0 else 0], [0, dying.get(i, 0)]] for i in cubic}
    assert answer(beside).holder.exact == 3
    found = answer(fed).holder
    assert spelled(found.exact) == "log2(4/3)"
    assert math.isclose(found.lower, math.log2(4 / 3))
