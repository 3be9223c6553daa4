"""Moduli of algebraic numbers against rationals: decided, with equality, whatever precision it takes."""

from fractions import Fraction

import pytest
from flint import fmpq_poly, fmpz, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.exact.algebraic import is_reciprocal, roots


def signs(coefficients, r):
    """The signs of |λ| - r for the roots λ of a polynomial, lowest coefficient first, by falling modulus."""
    return [root.compare_modulus(Fraction(r)) for root, m in roots(fmpq_poly(coefficients)) for _ in range(m)]


@pytest.mark.parametrize(
    ("coefficients", "r", "expected"),
    [
        ([-1, 4], "1/4", [0]),
        ([1, 4], "1/4", [0]),
        ([-1, 4], "1/3", [-1]),
        ([1, 1, 1], 1, [0, 0]),
        ([5, -6, 5], 1, [0, 0]),  # (3±4i)/5: on the circle and no root of unity
        ([4, 2, 1], 2, [0, 0]),
        ([-2, 0, 1], "3/2", [-1, -1]),
        ([-2, 0, 1], "7/5", [1, 1]),
        ([1, -3, 1], 1, [1, -1]),  # reciprocal with no root on the circle
        ([1, 1, -1, 1, 1], 1, [1, 0, 0, -1]),  # Salem type: two on the circle, a pair off it
        ([1, 0, 1, 1], 1, [1, -1, -1]),
        ([0, 0, 1, 2], "1/2", [0, -1, -1]),
        ([1, 2, 1], 1, [0, 0]),
    ],
)
def test_position_of_roots(coefficients, r, expected):
    assert signs(coefficients, r) == expected


@pytest.mark.parametrize("sign", [-1, 1])
def test_a_root_closer_to_the_circle_than_any_double(sign):
    """x² + c² with c = 1/4 ± 10^-60: sixty-four bits see it on the circle, the answer is not guessed."""
    c = Fraction(1, 4) + sign * Fraction(1, 10**60)
    f = fmpq_poly([fmpz(c.numerator**2), fmpz(0), fmpz(c.denominator**2)])
    assert [root.compare_modulus(Fraction(1, 4)) for root, _ in roots(f)] == [sign, sign]
    assert [root.compare_modulus(c) for root, _ in roots(f)] == [0, 0]


@given(st.integers(1, 12), st.integers(2, 12), st.integers(-30, 30))
def test_roots_forced_onto_the_circle(u, v, b):
    """v²x² + bx + u² with b² < 4u²v² has both roots on |x| = u/v."""
    if b * b >= 4 * u * u * v * v:
        return
    assert set(signs([u * u, b, v * v], Fraction(u, v))) == {0}


@given(st.lists(st.integers(-5, 5), min_size=3, max_size=8).filter(lambda c: c[0] and c[-1]))
def test_signs_count_like_the_product_of_the_roots(coefficients):
    """With r² = |product of roots|^(2/n) all roots cannot lie strictly on one side of |z| = r."""
    n = len(coefficients) - 1
    constant = Fraction(abs(coefficients[0]), abs(coefficients[-1]))
    for r in (Fraction(1, 2), Fraction(1), Fraction(2)):
        found = signs(coefficients, r)
        assert len(found) == n
        if all(sign == -1 for sign in found):
            assert constant < r**n
        if all(sign == 1 for sign in found):
            assert constant > r**n
        if all(sign == 0 for sign in found):
            assert constant == r**n


def test_reciprocal_test_needs_the_right_radius():
    assert is_reciprocal(fmpz_poly([4, 2, 1]), Fraction(2))
    assert not is_reciprocal(fmpz_poly([4, 2, 1]), Fraction(1))
    assert not is_reciprocal(fmpz_poly([0, 1]), Fraction(0))
