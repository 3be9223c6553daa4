"""Digits: what is printed contains what is certified."""

import math
from fractions import Fraction

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from subdiv_cli.model import Exponent, Interval, Log
from subdiv_cli.model.closed import rational
from subdiv_cli.report.numbers import at_least, at_most, data, digits, enclosed, interval

doubles = st.floats(-1e6, 1e6) | st.floats(-4, 4) | st.integers(-8, 8).map(float)


def printed(text):
    """The closed interval a text stands for."""
    if " .. " in text:
        low, high = text.split(" .. ")
        return Fraction(low), Fraction(high)
    if text.endswith("…"):
        value = Fraction(text[:-1])
        step = Fraction(1, 10 ** len(text[:-1].partition(".")[2]))
        return (value - step, value) if text.startswith("-") else (value, value + step)
    return Fraction(text), Fraction(text)


@given(doubles, st.floats(0, 1) | st.floats(0, 1e-9) | st.just(0.0))
@example(1.9999999999999998, 4e-16)
@example(-1e-12, 2e-12)
@example(2.8300749985575996, 1e-15)
def test_the_printed_interval_contains_the_given_one(lower, spread):
    upper = lower + spread
    assume(lower <= upper)
    low, high = printed(digits(lower, upper))
    assert low <= Fraction(lower)
    assert Fraction(upper) <= high
    assert high - low <= (Fraction(upper) - Fraction(lower)) * Fraction(103, 100) + Fraction(11, 10**9)


@given(doubles, st.integers(0, 10))
def test_bounds_are_rounded_outward(bound, places):
    assert 0 <= Fraction(bound) - Fraction(at_least(bound, places)[2:]) < Fraction(1, 10**places)
    assert 0 <= Fraction(at_most(bound, places)[2:]) - Fraction(bound) < Fraction(1, 10**places)


@given(st.floats(-8, 8), st.integers(0, 10))
@example(1.9999999999999998, 3)
@example(2.0000000000000004, 3)
@example(-1e-300, 3)
def test_no_bound_is_rounded_onto_an_integer(bound, places):
    for text in (at_least(bound, places), at_most(bound, places)):
        value = Fraction(text[2:])
        assert value.denominator > 1 or value == Fraction(bound)


@given(st.integers(-4, 4), st.floats(1e-15, 0.5), st.floats(1e-15, 0.5))
def test_no_end_of_an_interval_is_rounded_onto_an_integer(whole, below, above):
    assume(whole - below < whole < whole + above)
    for lower, upper in ((whole - 0.7, whole - below), (whole + above, whole + 0.7)):
        low, high = printed(digits(lower, upper))
        assert high < whole if upper < whole else low > whole


@pytest.mark.parametrize(
    ("lower", "upper", "shown"),
    [
        (2.0, 2.0, "2"),
        (-1.5, -1.5, "-1.5"),
        (0.0, 0.0, "0"),
        (2.83007494, 2.83007496, "2.8300749399 .. 2.8300749601"),
        (2.83007411, 2.83007419, "2.8300741099 .. 2.83007419"),
        (2.8300749985575, 2.8300749985576, "2.8300749985…"),
        (-2.8300749985576, -2.8300749985575, "-2.8300749985…"),
        (2.125, 2.12500000001, "2.1250000000…"),
        (2.8300749985575996, 2.8300749985576, "2.8300749985…"),
        (1.99, 2.0, "1.9899 .. 2"),
        (1.9999999, 2.0000001, "1.999999899 .. 2.0000001"),
        (1.654, 1.999871, "1.653 .. 1.9999"),
        (1.00004, 1.5, "1.00004 .. 1.5"),
        (2.00000000000001, 2.00000000000002, "2.00000000000001 .. 2.0000000001"),
        (2.0, 2.00000000000002, "2.0000000000…"),
        (1.75, 1.8125, "1.75 .. 1.8125"),
        (-0.25, 0.5, "-0.25 .. 0.5"),
        (9.5, 10.5, "9.5 .. 10.5"),
    ],
)
def test_digits(lower, upper, shown):
    assert digits(lower, upper) == shown


def test_an_empty_interval_is_an_error():
    with pytest.raises(ValueError, match="no number"):
        digits(2.0, 1.0)


ROOT = "-log2(root(128*x^2-10*x-1, 0.135697, 0.135698))/2"


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (Exponent(), None),
        (Exponent(lower=math.inf), None),
        (Exponent(lower=1.5), "≥ 1.5"),
        (Exponent(upper=1.5), "≤ 1.5"),
        (Exponent(exact=Fraction(2)), "2"),
        (Exponent(lower=1.5, upper=1.5, exact=Fraction(3, 2)), "3/2"),
        (Interval(lower=0.3333333333333333, upper=0.3333333333333334, exact="1/3"), "1/3 = 0.3333333333…"),
        (
            Exponent(lower=2.8300749985575996, upper=2.8300749985576, exact=Log(base=2, argument=Fraction(64, 9))),
            "log2(64/9) = 2.8300749985…",
        ),
        (Interval(lower=1.0, upper=1.5, exact="log2(x)"), "log2(x) ∈ 1 .. 1.5"),
        (
            Interval(lower=1.4407654450703504, upper=1.4407654450703506, exact=ROOT),
            f"1.4407654450… = {ROOT}",
        ),
        (Interval(lower=1.0, upper=1.5, exact=ROOT), f"1 .. 1.5, exactly {ROOT}"),
        (Interval(lower=154320986.375, upper=154320986.375, exact="1234567891/8"), "1234567891/8 = 154320986.375"),
    ],
)
def test_exact_first_then_digits(value, shown):
    assert interval(value) == shown


def test_enclosed_says_nothing_of_nothing():
    assert enclosed(None, math.inf) is None


@given(st.integers(-(10**30), 10**30), st.integers(1, 10**30))
def test_exact_is_str(p, q):
    assert rational(Fraction(p, q)) == str(Fraction(p, q))


def test_exact_of_any_length():
    assert rational(-(10**5000)) == "-1" + "0" * 5000
    assert rational(Fraction(1, 10**5000)) == "1/1" + "0" * 5000


def test_data():
    shown = data({"sums": (Fraction(1, 2), 1), "word": (), "shift": None, "even": True, "text": "a", "odd": False})
    assert shown == "{sums: (1/2, 1), word: (), shift: none, even: yes, text: a, odd: no}"
