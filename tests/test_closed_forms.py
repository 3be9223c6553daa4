"""Closed forms as numbers: the standard library's enclosures against FLINT's balls, and their order."""

from fractions import Fraction

import pytest
from flint import ctx
from hypothesis import given
from hypothesis import strategies as st
from support import answer, four_point

from subdiv_cli.exact.closed import closed_ball, exponent
from subdiv_cli.exact.enclosures import bounds
from subdiv_cli.maskfile.closed import read_closed_form
from subdiv_cli.model import Log, Root, RootLog, logarithm
from subdiv_cli.model.order import compare, enclosure

GOLDEN = Root((-1, -1, 1), Fraction(1618, 1000), Fraction(1619, 1000))
SILVER = Root((-1, 2, 1), Fraction(2, 5), Fraction(1, 2))
FALLING = Root((1, -3, 1), Fraction(38, 100), Fraction(39, 100))
"""1/golden², where the polynomial falls."""
positive = st.fractions(min_value=Fraction(1, 10**40), max_value=10**40).filter(bool)
logarithms = st.builds(logarithm, st.integers(2, 1024), positive, st.integers(1, 256))
roots = st.builds(exponent, st.integers(2, 7), st.integers(1, 9), st.sampled_from([GOLDEN, SILVER, FALLING]))
numbers = st.one_of(logarithms, roots, st.fractions(max_denominator=10**9))


@given(numbers, st.booleans())
def test_an_enclosure_contains_the_number(x, refined):
    """As FLINT knows it, to 600 bits; and it is as narrow as it says."""
    low, high = enclosure(x, refined=refined)
    with ctx.workprec(600):
        lower, upper = bounds(closed_ball(x))
    assert low <= upper
    assert lower <= high
    if refined:
        assert high - low <= Fraction(1, 10**60) * max(1, abs(low))


@pytest.mark.parametrize("digits", [1, 5000])
def test_numbers_of_any_size(digits):
    x = Log(2, Fraction(3 ** (2 * digits), 5**digits))
    low, high = enclosure(x)
    assert low <= high <= low + Fraction(1, 10**18)
    assert low / digits < Fraction(848, 1000) < high / digits + Fraction(1, 1000)


@given(numbers, numbers)
def test_order(x, y):
    sign = compare(x, y)
    assert compare(y, x) == (None if sign is None else -sign)
    if x == y:
        assert sign == 0
    with ctx.workprec(600):
        a, b = closed_ball(x), closed_ball(y)
        assert sign is None or not (a < b if sign >= 0 else a > b)


def test_what_is_told_apart_and_what_is_not():
    """Two expectations next to a number that only bisection of its root tells apart; one that is beyond 256 bits."""
    x = exponent(2, 1, GOLDEN)
    low, high = enclosure(x, refined=True)
    assert high - low < Fraction(1, 10**60)
    assert compare(x, low - Fraction(1, 10**50)) == 1
    assert compare(x, high + Fraction(1, 10**50)) == -1
    assert compare(x, (low + high) / 2) is None
    assert compare(x, x) == 0


@pytest.mark.parametrize(
    ("coefficients", "low", "high", "exact"),
    [
        ((-2, 1), 2, 5, Fraction(-1)),
        ((-5, 1), 2, 5, logarithm(2, Fraction(1, 5))),
        ((-3, 2), 1, 2, logarithm(2, Fraction(2, 3))),
        ((-1, *[0] * 29, 2), Fraction(1, 100), 3, Fraction(1, 30)),
    ],
    ids=["low end", "high end", "middle", "flat"],
)
def test_refinement_keeps_a_root_wherever_it_lies(coefficients, low, high, exact):
    """At an end of its interval or of a part, and where the secant misses it for long."""
    root = Root(coefficients, Fraction(low), Fraction(high))
    low, high = enclosure(RootLog(2, root, 1, ""), refined=True)
    lower, upper = enclosure(exact, refined=True)
    assert max(low, lower) <= min(high, upper)
    assert high - low < Fraction(1, 10**60)


def test_an_exact_number_is_spelled_in_full():
    """However long its coefficients are: reports promise a closed form that can be read again."""
    w = Fraction(123456789012345678901234567, 2 * 10**27)
    exact = answer(four_point(w)).holder.exact
    again = read_closed_form(str(exact))
    assert again._replace(root=exact.root) == exact
    assert again.root.coefficients == exact.root.coefficients
    assert again.root.low <= exact.root.low <= exact.root.high <= again.root.high


def test_one_root_in_two_intervals():
    """As an expectation and a certificate write it: equal where one interval holds the other, else not told."""
    x = exponent(2, 1, GOLDEN)
    wide = x._replace(root=GOLDEN._replace(low=Fraction(1), high=Fraction(2)), text="")
    other = x._replace(root=GOLDEN._replace(low=Fraction(1617, 1000), high=Fraction(16185, 10000)), text="")
    assert compare(x, wide) == compare(wide, x) == 0
    assert compare(x, other) is None
    assert compare(x, wide._replace(divisor=2)) == -1
