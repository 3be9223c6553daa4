"""Outward doubles never lie inward, and decide() ends."""

import math
from fractions import Fraction

import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.exact.enclosures import bounds, decide, interval, lower_double, upper_double
from subdiv_cli.model import Log, logarithm

rationals = st.one_of(
    st.fractions(),
    st.builds(lambda m, e: Fraction(m) * Fraction(2) ** e, st.integers(-(10**20), 10**20), st.integers(-1200, 900)),
)


@given(rationals)
def test_doubles_are_outward_and_next_to_each_other(x):
    low, high = lower_double(x), upper_double(x)
    assert Fraction(low) <= x <= Fraction(high)
    assert low == high or math.nextafter(low, math.inf) == high


def test_beyond_the_doubles():
    huge = Fraction(10) ** 400
    assert (lower_double(huge), upper_double(huge)) == (math.nextafter(math.inf, 0), math.inf)
    assert (lower_double(-huge), upper_double(-huge)) == (-math.inf, -math.nextafter(math.inf, 0))
    assert interval(huge).upper is None
    assert str(interval(Fraction(0)).lower) == str(interval(Fraction(0)).upper) == "0.0"


@given(rationals)
def test_a_ball_is_enclosed(x):
    with ctx.workprec(40):
        ball = arb(x.numerator) / arb(x.denominator)
        low, high = bounds(ball)
        enclosure = interval(ball)
    assert low <= x <= high
    assert enclosure.lower is None or Fraction(enclosure.lower) <= x
    assert enclosure.upper is None or x <= Fraction(enclosure.upper)


def test_an_infinite_ball_is_refused():
    with pytest.raises(ValueError, match="not finite"):
        bounds(arb(1) / arb(0))


def test_decide_raises_the_precision():
    seen = []

    def ask():
        seen.append(ctx.prec)
        return True if ctx.prec >= 256 else None

    assert decide(ask) is True
    assert seen == [64, 128, 256]


@given(st.integers(2, 9), st.fractions(min_value=Fraction(1, 50), max_value=50).filter(bool), st.integers(1, 4))
def test_closed_forms_are_canonical_and_enclosed(base, argument, divisor):
    x = logarithm(base, argument, divisor)
    true = math.log(argument) / math.log(base) / divisor
    box = closed_interval(x)
    assert box.lower is not None
    assert box.upper is not None
    assert box.lower - 1e-12 <= true <= box.upper + 1e-12
    assert logarithm(base**2, argument**6, 3 * divisor) == x
    if isinstance(x, Log):
        assert logarithm(x.base, x.argument, x.divisor) == x


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ((2, Fraction(8)), "3"),
        ((4, Fraction(2)), "1/2"),
        ((2, Fraction(1, 4), 3), "-2/3"),
        ((2, Fraction(9), 2), "log2(3)"),
        ((2, Fraction(64, 9)), "log2(64/9)"),
        ((4, Fraction(32, 3)), "log2(32/3)/2"),
        ((2, Fraction(8, 27), 6), "log2(2/3)/2"),
        ((6, Fraction(36)), "2"),
        ((6, Fraction(4, 9)), "log6(4/9)"),
    ],
)
def test_closed_forms_as_text(arguments, text):
    assert str(logarithm(*arguments)) == text
