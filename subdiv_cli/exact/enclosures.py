"""Enclosures of real numbers: balls made into outward doubles, and decisions at rising precision.

A comparison of balls is True only where it is certain, so after it comes another comparison, never an `else`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import TypeVar

from flint import arb, ctx

from subdiv_cli.exact.rationals import to_fmpq, whole
from subdiv_cli.model import Interval

Answer = TypeVar("Answer")

_FIRST_PRECISION = 64
_LAST_PRECISION = 1 << 20


def decide(ask: Callable[[], Answer | None]) -> Answer:
    """The first answer of `ask` that is not None, at 64, 128, 256, … bits.

    For questions that are known to have an answer at some precision, because equality was excluded exactly before.
    Raises ArithmeticError after 2^20 bits: a sign that it was not.
    """
    precision = _FIRST_PRECISION
    while precision <= _LAST_PRECISION:
        with ctx.workprec(precision):
            answer = ask()
        if answer is not None:
            return answer
        precision *= 2
    raise ArithmeticError(f"not decided at {_LAST_PRECISION} bits")


def ball(x: Fraction | int) -> arb:
    """A ball around a rational, at the current precision."""
    return arb(to_fmpq(x))


def _exact(x: arb) -> Fraction:
    """A ball of radius 0 as the dyadic rational it is."""
    mantissa, exponent = x.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def bounds(x: arb) -> tuple[Fraction, Fraction]:
    """Rational lower and upper bounds of a finite ball. Raises ValueError for one that is not finite."""
    if not x.is_finite():
        raise ValueError("the ball is not finite")
    return _exact(x.lower()), _exact(x.upper())


def lower_double(x: Fraction) -> float:
    """The largest double <= x; -inf below all of them."""
    try:
        nearest = float(x)
    except OverflowError:
        nearest = math.inf if x > 0 else -math.inf
    if nearest == math.inf:
        return math.nextafter(math.inf, 0.0)
    return nearest if nearest == -math.inf or Fraction(nearest) <= x else math.nextafter(nearest, -math.inf)


def upper_double(x: Fraction) -> float:
    """The smallest double >= x; inf above all of them."""
    return 0.0 - lower_double(-x)


def interval(x: arb | Fraction, exact: str | None = None) -> Interval:
    """Outward doubles around a ball or a rational, which then is `exact` too."""
    low, high = (x, x) if isinstance(x, Fraction) else bounds(x)
    if exact is None and isinstance(x, Fraction):
        exact = whole(x)
    doubles = lower_double(low), upper_double(high)
    lower, upper = (d if math.isfinite(d) else None for d in doubles)
    return Interval(lower=lower, upper=upper, exact=exact)
