"""A. Levin, Polynomial generation and quasi-interpolation in stationary non-uniform subdivision, 2003: section 2."""

import math
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support import answer, b_spline, corner_cutting, deslauriers_dubuc, four_point, scheme, six_point

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.kinds.scalar.numbers.operators import apply
from subdiv_cli.kinds.scalar.numbers.polynomials import eigen_sequence, moments, operator, stencil
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_integers
from subdiv_cli.model import Effort

F = Fraction
CUBIC = scheme([1, 4, 6, 4, 1], start=-2, over=8)


def q_of(mask):
    numbers = ScalarNumbers(mask, Effort())
    m = moments(at_integers(numbers, 0), numbers.order)
    q = operator(m)
    return m, q, stencil(q, mask.coefficients == mask.coefficients[::-1])


def test_cubic_b_spline():
    """(17), (18): m = 1, 0, 1/3, 0; Q = f - f''/6 with the stencil (-1/6, 4/3, -1/6)."""
    m, q, t = q_of(CUBIC)
    assert m == (1, 0, F(1, 3), 0)
    assert q == (1, 0, F(-1, 6), 0)
    assert t == Laurent.from_coefficients(-1, [F(-1, 6), F(4, 3), F(-1, 6)])
    sequences = [eigen_sequence(q, i) for i in range(4)]
    assert sequences == [(1,), (0, 1), (F(-1, 3), 0, 1), (0, -1, 0, 1)]


def test_dual_schemes_have_an_even_stencil():
    """Chaikin: Q is f - f''/8 at the centre 1/2 of φ."""
    _, q, t = q_of(scheme([1, 3, 3, 1], start=-1, over=4))
    assert q == (1, F(1, 2), 0)  # exp(D/2)(1 - D²/8)
    assert t == Laurent.from_coefficients(-1, [F(-1, 8), F(5, 8), F(5, 8), F(-1, 8)])


@pytest.mark.parametrize("mask", [four_point("1/16"), six_point("1/100"), deslauriers_dubuc(8)])
def test_interpolatory_schemes_need_no_q(mask):
    _, q, t = q_of(mask)
    assert q == (1, *[0] * (len(q) - 1))
    assert t == Laurent.from_coefficients(0, [1])


MASKS = {
    "cubic": CUBIC,
    "quartic": scheme(b_spline(4).coefficients, start=-2),
    "corner cutting": corner_cutting("2/3", "1/6"),
    "ternary": scheme(b_spline(3, 3).coefficients, start=-2, arity=3),
    "quaternary": scheme(b_spline(2, 4).coefficients, start=1, arity=4),
    "dual": scheme([-5, -7, 35, 105, 105, 35, -7, -5], start=-4, over=128),
    "pseudo-spline": scheme([-3, -8, 12, 72, 110, 72, 12, -8, -3], start=-4, over=128),
    "lopsided": scheme(["1/8", "5/8", "7/8", "3/8"], start=-1),
}


@pytest.mark.parametrize("name", MASKS)
def test_s_q_is_q_sigma(name):
    """(9): S maps the samples of Q x^i to p^-i times them, indices included."""
    mask = MASKS[name]
    numbers, p = ScalarNumbers(mask, Effort()), mask.arity
    _, q, _ = q_of(mask)
    for degree in range(numbers.order):
        coefficients = eigen_sequence(q, degree)
        samples = {i: sum(c * F(i) ** j for j, c in enumerate(coefficients)) for i in range(-30, 31)}
        refined = apply(numbers.symbol, p, samples)
        for i in range(-20, 21):
            assert refined[i] == samples[i] / p**degree


@pytest.mark.parametrize("name", MASKS)
def test_the_stencil_is_the_operator_on_polynomials(name):
    _, q, t = q_of(MASKS[name])
    for degree in range(len(q)):
        coefficients = eigen_sequence(q, degree)
        for i in range(-2, 3):
            sampled = sum(c * F(i + t.low + j) ** degree for j, c in enumerate(t.coefficients()))
            assert sampled == sum(c * F(i) ** j for j, c in enumerate(coefficients))
    symmetric = MASKS[name].coefficients == MASKS[name].coefficients[::-1]
    if symmetric and (2 * q[1]).denominator == 1:  # φ is symmetric about an integer or a half
        assert t.coefficients() == t.coefficients()[::-1]


def errors(mask, with_q, levels):
    """sup |S^∞ Q_h cos - cos| on a grid for h = 1/2, 1/4, …; the limits by many levels of subdivision in floats."""
    numbers = ScalarNumbers(mask, Effort())
    a, p = np.array([float(c) for c in mask.coefficients]), mask.arity
    _, _, t = q_of(mask)
    weights = t if with_q else Laurent.from_coefficients(0, [1])
    stencil_ = {weights.low + j: float(c) for j, c in enumerate(weights.coefficients())}
    values = at_integers(numbers, 0)
    shift = 0.0 if with_q else float(numbers.symbol.derivatives_at_one(2)[1]) / p / (p - 1)
    found = []
    for level in range(1, levels + 1):
        h = 2.0**-level
        reach = range(-40, 41)
        data = np.array([sum(w * math.cos((i + j + shift) * h) for j, w in stencil_.items()) for i in reach])
        first = reach[0]
        for _ in range(3):
            spread = np.zeros((len(data) - 1) * p + 1)
            spread[::p] = data
            data, first = np.convolve(spread, a), p * first + mask.start
        limit = np.convolve(data, [float(c) for c in values.coefficients()])
        at = (first + values.low + np.arange(len(limit))) / p**3
        middle = abs(at) < 5
        found.append(float(abs(limit - np.cos(at * h))[middle].max()))
    return found


def test_cubic_quasi_interpolation_of_the_cosine():
    """Order 4: the error falls by 16 at each halving of the step; without Q by 4."""
    found = errors(CUBIC, with_q=True, levels=5)
    ratios = [a / b for a, b in pairwise(found)]
    assert ratios[-1] == pytest.approx(16, rel=0.02)
    plain = errors(CUBIC, with_q=False, levels=5)
    assert plain[-2] / plain[-1] == pytest.approx(4, rel=0.02)


@pytest.mark.parametrize(
    ("name", "order", "plain"), [("dual", 5, 4), ("pseudo-spline", 6, 4), ("corner cutting", 2, 2)]
)
def test_other_orders(name, order, plain):
    for with_q, expected in ((True, order), (False, plain)):
        found = errors(MASKS[name], with_q=with_q, levels=4)
        assert math.log2(found[-2] / found[-1]) >= expected - 0.15


@pytest.mark.parametrize("degree", range(1, 7))
def test_b_splines_reproduce_linear_polynomials_only(degree):
    result = answer(b_spline(degree))
    assert (result.generation, result.reproduction) == (degree, 1)


@given(st.lists(st.fractions(min_value=-2, max_value=2, max_denominator=5), min_size=1, max_size=6))
def test_the_operator_inverts_the_moments(rest):
    """As power series Σ m_i/i! x^i and Σ q_i x^i, m_0 = 1."""
    m = (F(1), *rest)
    q = operator(m)
    for degree in range(len(m)):
        product = sum(m[degree - i] / math.factorial(degree - i) * q[i] for i in range(degree + 1))
        assert product == (degree == 0)
