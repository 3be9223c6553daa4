"""The Sobolev exponent against routes that share nothing with it: subdivision in floats, the unfolded matrix, laws."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from support import answer, b_spline, deslauriers_dubuc, findings, four_point, scheme, six_point

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.kinds.scalar.numbers.operators import symbol
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.sobolev import mean_square_growth, transfer_matrix
from subdiv_cli.model import Effort, Log, Verdict


def floats(coefficients):
    return np.array([float(c) for c in coefficients])


def growth_of_differences(mask, k, levels):
    """p^-L Σ |Δ^k S^L δ|² for L = 0, …, levels - 1, by subdividing δ in floats and taking differences at the end."""
    p, a, data, sizes, late = mask.arity, floats(mask.coefficients), np.array([1.0]), [], k
    if k > 6:  # differences at the end lose all digits: subdivide Δ^k δ instead
        data, late = np.diff(np.pad(data, k), k), 0
        a = floats(ScalarNumbers(mask, Effort()).difference(k).coefficients())
    for level in range(levels):
        differences = np.diff(np.pad(data, late), late)
        sizes.append(float((differences**2).sum()) / p**level)
        spread = np.zeros((len(data) - 1) * p + 1)
        spread[::p] = data
        data = np.convolve(spread, a)
    return sizes


def unfolded_radius(mask, k):
    """The spectral radius of (1/p) b_(pi-j) on all of -K, …, K, with numpy."""
    d = floats(ScalarNumbers(mask, Effort()).difference(k).coefficients())
    p, n = mask.arity, len(d) - 1
    b = {t - n: x for t, x in enumerate(np.convolve(d, d[::-1]))}
    reach = n // (p - 1) + 1  # one more than needed
    places = range(-reach, reach + 1)
    return max(abs(np.linalg.eigvals([[b.get(p * i - j, 0.0) / p for j in places] for i in places])))


def exponent(lam, p):
    return -math.log(lam, p) / 2


MASKS = {
    "b-spline": b_spline(3),
    "four-point": four_point("1/16"),
    "four-point, rough": four_point("19/100"),
    "four-point, negative": four_point("-1/4"),
    "six-point": six_point("1/64"),
    "interpolatory, 12 points": deslauriers_dubuc(12),
    "lopsided": scheme(["1/4", "2/3", "3/4", "1/3"], start=-2),
    "ternary": scheme([-4, -7, 0, 34, 76, 99, 76, 34, 0, -7, -4], arity=3, over=99),
    "quaternary": scheme([-5, -8, -7, 0, 35, 72, 105, 128, 105, 72, 35, 0, -7, -8, -5], arity=4, over=128),
    "divergent": scheme([-2, 1, 6, 1, -2], over=2),
    "many zeros": scheme([2, 2, 0, -1, -1, 0, 0, 1, 1], over=2),
    "a gap": scheme([1, 1, 0, 0, 0, 0, 0, 0, -1, -1, 1, 1], over=1),
}


@pytest.mark.parametrize("name", MASKS)
def test_subdivision_in_floats_grows_at_that_rate(name):
    """Δ^k S^L δ = D^L Δ^k δ: another start than e_0, so that what it cancels would show."""
    mask = MASKS[name]
    numbers = ScalarNumbers(mask, Effort())
    assert not numbers.reduction
    k, p = numbers.order, numbers.p
    lam = float(mean_square_growth(numbers.difference(k), p).radius.enclosure().real.mid())
    sizes = growth_of_differences(mask, k, {2: 15, 3: 9, 4: 7}[p])
    rate = (sizes[-1] / sizes[-5]) ** (1 / 4)
    assert rate == pytest.approx(lam, rel=0.02)
    assert unfolded_radius(mask, k) == pytest.approx(lam, rel=1e-7)


SMALL = st.fractions(min_value=-3, max_value=3, max_denominator=6)


@given(st.integers(2, 4), st.integers(1, 3), st.lists(SMALL, min_size=1, max_size=5), st.booleans())
def test_random_masks(p, k, cofactor, gapped):
    """Certified doubles around the exponent of the unfolded matrix, for any mask; the reduced one where unstable."""
    q = Laurent.from_coefficients(0, cofactor)
    q = q.inflate(3) if gapped else q
    assume(q.degree >= 0 and q(1) != 0)
    for _ in range(k):
        q = q * smoothing_factor(p)
    a = q.scale(Fraction(p) / q(1))
    result = answer(scheme(a.coefficients(), start=a.low, arity=p), work=1000)
    (found,) = findings(result, "SD321")
    assert found.verdict in (Verdict.PROVED, Verdict.UNDECIDED)
    if found.verdict is Verdict.UNDECIDED:
        return
    assert found.claims
    numbers = ScalarNumbers(scheme(a.coefficients(), start=a.low, arity=p), Effort()).reduced
    s = exponent(unfolded_radius(numbers.scheme, numbers.order), p)
    assert result.sobolev.lower - 1e-6 <= s <= result.sobolev.upper + 1e-6
    assert result.sobolev.upper - result.sobolev.lower < 1e-12
    assert s <= numbers.order + 1e-9
    # s - 1/2 <= α <= s, with the certified bounds of α
    if result.holder is not None and result.holder.lower is not None:
        assert result.holder.lower <= result.sobolev.upper
    if result.holder is not None and result.holder.upper is not None:
        assert result.sobolev.lower - 0.5 <= result.holder.upper


@pytest.mark.parametrize("arity", [2, 3, 5])
@pytest.mark.parametrize("degree", range(6))
def test_b_splines(arity, degree):
    result = answer(b_spline(degree, arity))
    assert result.sobolev.exact == degree + Fraction(1, 2)
    assert result.sobolev.lower == result.sobolev.upper == degree + 0.5


def test_the_chain_of_exponents():
    """s - 1/2 <= α <= s: an equality on the left for B-splines, strict on both sides for the four-point scheme."""
    for mask in MASKS.values():
        result = answer(mask)
        assert result.holder.lower <= result.sobolev.upper
        assert result.sobolev.lower - 0.5 <= result.holder.upper
    result = answer(four_point("1/16"))
    assert result.sobolev.lower - 0.5 < 1.95
    assert result.sobolev.lower > 2.4


def test_closed_forms():
    quaternary = answer(MASKS["quaternary"])
    assert quaternary.sobolev.exact == Log(base=2, argument=Fraction(32768, 97), divisor=4)
    (found,) = findings(answer(four_point("1/16")), "SD321")
    assert found.value.exact == "-log2(root(2048*x^2-40*x-1, 0.0339244, 0.0339245))/2"
    assert "2.4407654450" in found.statement


def test_one_more_smoothing_factor_raises_the_exponent_by_one():
    for mask in MASKS.values():
        p = mask.arity
        smoothed = symbol(mask) * smoothing_factor(p).scale(Fraction(1, p))
        before, after = answer(mask).sobolev, answer(scheme(smoothed.coefficients(), arity=p)).sobolev
        assert after.lower == pytest.approx(before.lower + 1, abs=1e-12)


def test_shift_and_reversal_change_nothing():
    for mask in MASKS.values():
        moved = scheme(mask.coefficients[::-1], start=17, arity=mask.arity)
        assert answer(moved).sobolev == answer(mask).sobolev


@pytest.mark.parametrize("factor", [[1, 1], [1, 1, 1], [5, -6, 5], [1, 0, 1]])
def test_an_unstable_mask_has_the_exponent_of_its_stable_part(factor):
    """a(z) g(z²)/g(z) for a with the factor g: φ becomes a combination of translates of the old one."""
    base = Laurent.from_coefficients(0, [Fraction(c, 4) for c in (1, 3, 3, 1)])
    g = Laurent.from_coefficients(0, factor)
    a = base * g
    a = a.scale(2 / a(1))
    quotient, remainder = (a * g.inflate(2)).divide(g)
    assert not remainder.poly
    twisted = answer(scheme(quotient.coefficients()))
    assert twisted.stable is Verdict.REFUTED
    plain = answer(scheme(a.coefficients()))
    assert twisted.sobolev.lower == pytest.approx(plain.sobolev.lower, abs=1e-12)


def test_the_largest_order_is_needed():
    """With one factor less the cofactor has a zero at -1 and λ is too large: the formula would say 1 for the hat."""
    hat = Laurent.from_coefficients(0, [Fraction(1, 2), Fraction(1, 2)])
    lam = mean_square_growth_of(hat)
    assert exponent(lam, 2) == pytest.approx(1)


def mean_square_growth_of(d):
    rows = transfer_matrix(d, 2).table()
    return max(abs(np.linalg.eigvals([[float(int(x.p)) / int(x.q) for x in row] for row in rows])))


def test_no_sum_rule_no_exponent():
    for mask in (scheme([2, 2, 2], over=3), scheme([1, 1], over=2)):
        result = answer(mask)
        assert result.sobolev is None
        assert findings(result, "SD321")[0].verdict is Verdict.SKIPPED


def test_a_small_effort_leaves_it_to_the_hölder_exponent():
    result = answer(deslauriers_dubuc(16), work=100)
    assert result.sobolev.exact is None
    assert result.sobolev.lower <= answer(deslauriers_dubuc(16)).sobolev.lower <= result.sobolev.upper
    assert findings(result, "SD321")[0].witness["by"] == "SD311"
