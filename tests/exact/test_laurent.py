"""Laurent polynomials: canonical form, exact division, polyphase components, evaluation."""

from fractions import Fraction

import pytest
from flint import fmpq_poly
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.exact.laurent import Laurent, smoothing_factor

rationals = st.fractions(min_value=-9, max_value=9, max_denominator=12)
polynomials = st.builds(Laurent.from_coefficients, st.integers(-6, 6), st.lists(rationals, max_size=9))
nonzero = polynomials.filter(lambda a: a.degree >= 0)


def test_canonical_form_strips_zeros_at_both_ends():
    a = Laurent.from_coefficients(-2, [0, 0, 1, 0, 3, 0])
    assert (a.low, a.coefficients()) == (0, (1, 0, 3))
    assert Laurent.from_coefficients(5, [0, 0]) == Laurent(0, fmpq_poly())


@given(polynomials, nonzero)
def test_division_leaves_a_remainder_of_lower_degree(a, b):
    quotient, remainder = a.divide(b)
    assert quotient * b + remainder == a
    assert remainder.degree < b.degree or remainder.degree == -1


@given(polynomials, nonzero)
def test_division_of_a_product_is_exact(a, b):
    assert (a * b).divide(b) == (a, Laurent(0, fmpq_poly()))


@given(polynomials, st.integers(2, 5))
def test_components_make_up_the_polynomial(a, p):
    total = Laurent(0, fmpq_poly())
    for r, component in enumerate(a.components(p)):
        total = total + component.inflate(p).shift(r)
    assert total == a


@given(polynomials, polynomials, rationals.filter(bool))
def test_evaluation_is_a_homomorphism(a, b, x):
    assert (a * b)(x) == a(x) * b(x)
    assert (a - b)(x) == a(x) - b(x)
    assert a.reversed()(x) == a(1 / x)


@given(polynomials, st.integers(0, 4))
def test_derivatives_at_one(a, j):
    def derivative(terms):
        return [(e - 1, c * e) for e, c in terms]

    terms = [(a.low + i, c) for i, c in enumerate(a.coefficients())]
    for _ in range(j):
        terms = derivative(terms)
    assert a.derivatives_at_one(j + 1)[j] == sum((c for _, c in terms), Fraction(0))


def test_smoothing_factor():
    assert smoothing_factor(3).coefficients() == (1, 1, 1)


def test_division_by_zero_is_an_error():
    with pytest.raises(ZeroDivisionError):
        smoothing_factor(2).divide(Laurent(0, fmpq_poly()))
