"""N. Dyn, Subdivision schemes in CAGD, 1992: sections 3 to 5, with the slips of its examples mended."""

from fractions import Fraction

import pytest
from support import answer, b_spline, corner_cutting, deslauriers_dubuc, findings, four_point, scheme, six_point

from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Effort, Verdict

F = Fraction


def norms(mask, nu, levels):
    """‖((1/p)S_ν)^L‖∞ for L = 1, …, levels, whether below 1 or not."""
    from subdiv_cli.kinds.scalar.numbers.norms import power_norms

    symbol = ScalarNumbers(mask, Effort()).difference(nu).scale(mask.arity ** (nu - 1))
    stream = power_norms(symbol, mask.arity, Effort(10**6))
    return [next(stream) for _ in range(levels)]


# --- corner cutting, section 3 example 1 and section 4 example 1 ---

CUTS = [
    tuple(map(Fraction, pair.split()))
    for pair in (
        "3/4 1/4",
        "2/3 1/3",
        "4/5 1/10",
        "1/2 0",
        "1 1/2",
        "1 0",
        "1/4 1/3",
        "5/4 1/4",
        "9/10 2/5",
        "7/8 3/8",
    )
]


@pytest.mark.parametrize(("r", "s"), CUTS)
def test_corner_cutting_norm_of_half_s1(r, s):
    assert norms(corner_cutting(r, s), 1, 1) == [max(abs(r - s), abs(s) + abs(1 - r))]


@pytest.mark.parametrize(("r", "s"), CUTS)
def test_corner_cutting_converges_where_the_norm_is_below_one(r, s):
    level_one = max(abs(r - s), abs(s) + abs(1 - r)) < 1
    result = answer(corner_cutting(r, s))
    if level_one:
        assert result.convergent is Verdict.PROVED
    if 0 <= s < r <= 1:
        # the paper claims all of these; (1, 0) is Haar and diverges
        assert result.convergent is (Verdict.REFUTED if (r, s) == (1, 0) else Verdict.PROVED)


@pytest.mark.parametrize("s", [F(1, 10), F(1, 5), F(1, 4), F(2, 5)])
def test_corner_cutting_is_c1_exactly_on_the_line(s):
    r = s + F(1, 2)
    assert norms(corner_cutting(r, s), 2, 1) == [max(2 * s, 1 - 2 * s)]
    result = answer(corner_cutting(r, s))
    assert (result.smoothness.order, result.smoothness.sharp) == (1, True)
    assert result.holder is not None
    if s == F(1, 4):
        assert str(result.holder.exact) == "2"
    else:
        assert str(result.holder.exact) == f"log2({1 / max(s, F(1, 2) - s)})"


@pytest.mark.parametrize(("r", "s"), [(1, F(1, 2)), (F(1, 2), 0)])
def test_the_ends_of_the_line_are_the_hat_function(r, s):
    """The paper claims C^1 here too."""
    result = answer(corner_cutting(r, s))
    assert (result.smoothness.order, result.smoothness.sharp) == (0, True)


@pytest.mark.parametrize(("r", "s"), [(F(2, 3), F(1, 3)), (F(4, 5), F(1, 10)), (F(1, 4), F(1, 3))])
def test_corner_cutting_off_the_line_is_not_c1(r, s):
    result = answer(corner_cutting(r, s))
    assert (result.smoothness.order, result.smoothness.sharp) == (0, True)


@pytest.mark.parametrize(("r", "s"), [(F(3, 4), F(1, 4)), (F(2, 3), F(1, 3)), (F(4, 5), F(1, 10))])
def test_corner_cutting_limit_stencil(r, s):
    """Printed as (1-r, s, 0): the roles are the other way round, as v A_0 = v shows."""
    (condition,) = findings(answer(corner_cutting(r, s)), "SD202")
    one = 1 - (r - s)
    assert condition.witness["stencil"] == (s / one, (1 - r) / one, 0)
    assert condition.witness["stencil_start"] == 0


# --- B-splines, section 3 example 2 ---


@pytest.mark.parametrize("degree", range(1, 9))
def test_b_splines_are_c_m_minus_1_and_no_smoother(degree):
    mask = b_spline(degree)
    assert norms(mask, degree, 1) == [F(1, 2)]
    result = answer(mask)
    assert (result.smoothness.order, result.smoothness.sharp) == (degree - 1, True)
    assert result.holder is not None
    assert result.holder.exact == degree
    assert (result.generation, result.reproduction) == (degree, min(1, degree))


@pytest.mark.parametrize("arity", [3, 4, 5, 7])
@pytest.mark.parametrize("degree", [1, 2, 3, 4])
def test_b_splines_of_other_arities(arity, degree):
    result = answer(b_spline(degree, arity))
    assert (result.smoothness.order, result.smoothness.sharp) == (degree - 1, True)
    assert result.holder is not None
    assert result.holder.exact == degree


def test_haar_diverges():
    result = answer(b_spline(0))
    assert result.convergent is Verdict.REFUTED
    assert result.smoothness.order is None


def test_chaikin():
    mask = b_spline(2)
    assert norms(mask, 2, 1) == [F(1, 2)]
    assert norms(mask, 3, 4) == [1, 1, 1, 1]


# --- the four-point scheme, section 3 example 3 and section 4 example 2 ---


@pytest.mark.parametrize("w", ["1/16", "1/10", "-1/8", "1/5", "0", "3/10", "-9/20"])
def test_four_point_norm_of_half_s1(w):
    assert norms(four_point(w), 1, 1) == [F(1, 2) + 2 * abs(F(w))]


def test_four_point_level_two_at_one_tenth():
    """(3.24): max of 3w/2 + 3w² + |1/4 - w/2 + w²| and w(1/2 - w) + |1/4 + w/2 - w²| + 2w²; ½S_2 by hand."""
    w = F(1, 10)
    first = w * (F(1, 2) + w) + abs(F(1, 4) + w * w - w / 2) + w * (1 + w) + w * w
    second = w * abs(w - F(1, 2)) + abs(F(1, 4) + w / 2 - w * w) + 2 * w * w
    assert norms(four_point(w), 1, 2)[1] == max(first, second) == F(39, 100)
    assert norms(four_point(w), 2, 2) == [1, F(3, 5)]


@pytest.mark.parametrize(
    ("w", "below"),
    [("-74/200", True), ("-76/200", False), ("3256/10000", True), ("3257/10000", False), ("-3/8", False)],
)
def test_four_point_level_two_range_of_convergence(w, below):
    """-3/8 < w < (-1+√13)/8 = 0.32569…"""
    assert (norms(four_point(w), 1, 2)[1] < 1) is below


@pytest.mark.parametrize(("w", "below"), [("1/1000", True), ("0", False), ("154/1000", True), ("155/1000", False)])
def test_four_point_level_two_range_of_c1(w, below):
    """0 < w < (-1+√5)/8 = 0.15450…"""
    assert (norms(four_point(w), 2, 2)[1] < 1) is below


def test_four_point_at_one_sixteenth():
    result = answer(four_point("1/16"))
    assert (result.smoothness.order, result.smoothness.sharp) == (1, True)
    assert norms(four_point("1/16"), 3, 6) == [1] * 6
    assert result.holder is not None
    assert result.holder.exact == 2
    assert (result.generation, result.reproduction) == (3, 3)


@pytest.mark.parametrize("w", ["1/2", "-1/2", "3/4", "-3/4", "2"])
def test_four_point_diverges_from_one_half_on(w):
    assert answer(four_point(w)).convergent is Verdict.REFUTED


@pytest.mark.parametrize("w", ["2/5", "-2/5"])
def test_four_point_converges_beyond_level_two(w):
    """The paper reports |w| < 1/2 from computations; higher levels prove more of it."""
    assert answer(four_point(w), work=400_000).convergent is Verdict.PROVED


@pytest.mark.parametrize("w", ["-1/16", "0", "1/5", "1/4", "-1/4", "193/1000"])
def test_four_point_is_not_c1_outside(w):
    """C^1 iff 0 < w < w*, 32w*³ + 4w* = 1."""
    result = answer(four_point(w))
    assert result.smoothness.order == 0
    assert result.smoothness.sharp


def test_four_point_eigenvalues():
    """The matrices of ½S_1 have ½, 2w, (1±√(1-16w))/4; A_0 has 1 and these, and the end coefficient -w."""
    numbers = ScalarNumbers(four_point("1/32"), Effort())
    assert numbers.spectra is not None
    polynomials = {tuple(map(int, root.minimal_polynomial)) for root, _ in numbers.spectra[0]}
    assert polynomials == {(-1, 1), (-1, 2), (-1, 16), (1, 32), (1, -16, 32)}


# --- the six-point scheme, section 3 example 4 ---


@pytest.mark.parametrize(
    ("theta", "below"), [("1/1000", True), ("1/50", True), ("27/1000", True), ("1/36", False), ("0", False)]
)
def test_six_point_level_two(theta, below):
    """‖(½S_3)²‖∞ < 1 for 0 < θ < 1/36; the paper states 0 < θ < 0.02."""
    assert (norms(six_point(theta), 3, 2)[1] < 1) is below


@pytest.mark.parametrize("theta", ["1/1000", "1/100", "1/50"])
def test_six_point_is_c2(theta):
    order = answer(six_point(theta)).smoothness.order
    assert order is not None
    assert order >= 2


def test_six_point_exponent_from_both_sides():
    """α = 2.58342222 at θ = 1/100, attained by T_0."""
    holder = answer(six_point("1/100")).holder
    assert holder is not None
    assert holder.lower is not None
    assert holder.upper is not None
    assert 2.58342222 <= holder.lower <= holder.upper < 2.58342223
    assert str(holder.exact) == "-log2(root(40000*x^3-5900*x^2-225*x+16, 0.166844, 0.166845))"


@pytest.mark.parametrize(
    ("w", "alpha", "word"),
    [
        ("1/32", "1.22844669", (0,)),
        ("1/10", "1.58370536", (0, 1)),
        ("3/20", "1.22285569", (0, 1)),
        ("19/100", "1.01266190", (0, 1)),
    ],
)
def test_four_point_exponents_and_the_products_that_attain_them(w, alpha, word):
    """To eight decimals; at w = 19/100 norms do not show that the scheme is C^1."""
    result = answer(four_point(w))
    assert result.holder is not None
    assert result.holder.exact is not None
    assert str(result.holder.lower).startswith(alpha[:-1])
    assert abs(result.holder.lower - float(alpha)) < 2e-8
    assert result.holder.upper - result.holder.lower < 1e-12
    assert findings(result, "SD310")[0].witness["word"] == word
    assert (result.smoothness.order, result.smoothness.sharp) == (1, True)


def test_the_four_point_scheme_is_c1_just_below_its_irrational_end():
    """C^1 iff 0 < w < w*, 32w*³ + 4w* = 1, w* = 0.19273…: proved at 0.192, refuted at 0.193."""
    for w, order in (("24/125", 1), ("193/1000", 0)):
        smoothness = answer(four_point(w)).smoothness
        assert (smoothness.order, smoothness.sharp) == (order, True)


# --- interpolatory schemes, section 5 ---


@pytest.mark.parametrize(
    ("points", "order", "alpha"),
    [
        (4, 1, 2),
        (6, 2, 2.8300749985),
        (8, 3, 3.55113053),
        (10, 4, 4.19357343),
        (12, 4, 4.77674818),
        (14, 5, 5.31732061),
        (16, 5, 5.82944335),
    ],
)
def test_deslauriers_dubuc(points, order, alpha):
    mask = deslauriers_dubuc(points)
    result = answer(mask)
    assert (result.smoothness.order, result.smoothness.sharp) == (order, True)
    assert (result.generation, result.reproduction) == (points - 1, points - 1)
    assert result.facts["interpolatory"] is True
    assert result.holder is not None
    assert result.holder.lower is not None
    assert result.holder.upper is not None
    assert result.holder.exact is not None
    assert alpha - 1e-8 <= result.holder.lower <= result.holder.upper <= alpha + 1e-8
    assert result.holder.attained is (points != 4)


def test_six_point_deslauriers_dubuc_is_the_six_point_scheme():
    assert deslauriers_dubuc(6) == six_point("3/256")


def test_the_dual_four_point_scheme_has_a_closed_form():
    result = answer(scheme([-5, -7, 35, 105, 105, 35, -7, -5], start=-4, over=128))
    assert result.holder is not None
    assert str(result.holder.exact) == "log2(64/9)"
    assert (result.smoothness.order, result.smoothness.sharp) == (2, True)
