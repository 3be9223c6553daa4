"""Closed forms as real numbers: rational enclosures and exact order, standard library only.

Logarithms are those of `decimal`, correctly rounded; the error that is added to each is some ten digits larger than
all roundings together.
"""

from __future__ import annotations

from decimal import Context, Decimal, localcontext
from fractions import Fraction
from functools import lru_cache
from math import lcm

from subdiv_cli.model.closed import INFINITY, ClosedForm, Root, RootLog

_BITS = 272
_DIGITS = {False: 40, True: 90}
"""The digits of logarithms, at first and refined."""
_SPARE = 15
"""The digits that roundings cannot reach."""


@lru_cache(maxsize=256)
def enclosure(x: ClosedForm, *, refined: bool = False) -> tuple[Fraction, Fraction]:
    """The bounds lower <= x <= upper, to some 20 digits; `refined`, to 70. Raises OverflowError at infinity."""
    if isinstance(x, Fraction):
        return x, x
    if isinstance(x, float):
        raise OverflowError("infinity has no bounds")
    if isinstance(x, RootLog):
        low, high = _narrowed(x.root) if refined else (x.root.low, x.root.high)
        value, error = _exponent(1 / low, x.base, x.divisor, refined)
        return value - error - 2 * (high - low) / low / x.divisor, value + error  # ln base > 1/2
    value, error = _exponent(x.argument, x.base, x.divisor, refined)
    return value - error, value + error


def _exponent(x: Fraction, base: int, divisor: int, refined: bool) -> tuple[Fraction, Fraction]:
    """The number log_base(x) / divisor, and how far that may be off."""
    (y, e), (s, f) = _logarithm(x, refined), _logarithm(Fraction(base), refined)
    with localcontext(Context(prec=_DIGITS[refined])):
        return Fraction(y / s / divisor), Fraction(4 * (e + abs(y) * f))


def compare(a: ClosedForm, b: ClosedForm) -> int | None:
    """The sign of a - b; None where 256 bits do not tell, as with equal numbers that are not written alike."""
    if a == b or _are_one(a, b):
        return 0
    if INFINITY in (a, b):
        return 1 if a == INFINITY else -1
    for refined in (False, True):
        (low, high), (lower, upper) = enclosure(a, refined=refined), enclosure(b, refined=refined)
        if low > upper or high < lower:
            return 1 if low > upper else -1
    return None


def _are_one(a: ClosedForm, b: ClosedForm) -> bool:
    """Whether both are of the only root of one polynomial in the larger of two intervals."""
    if not isinstance(a, RootLog) or not isinstance(b, RootLog):
        return False
    if (a.base, a.divisor, a.root.coefficients) != (b.base, b.divisor, b.root.coefficients):
        return False
    (low, high), (lower, upper) = a.root[1:], b.root[1:]
    return low <= lower <= upper <= high or lower <= low <= high <= upper


@lru_cache(maxsize=256)
def _logarithm(x: Fraction, refined: bool) -> tuple[Decimal, Decimal]:
    """The logarithm ln x, and how far that may be off, for x > 0 of any size: x = m 2^e with m of 272 bits, cut."""
    e = x.numerator.bit_length() - x.denominator.bit_length() - _BITS
    m = (x.numerator << max(0, -e)) // (x.denominator << max(0, e))
    digits = _DIGITS[refined]
    with localcontext(Context(prec=digits)):
        return Decimal(m).ln() + e * _logarithm_of_2(digits), (1 + abs(e)) * Decimal(10) ** (_SPARE - digits)


@lru_cache
def _logarithm_of_2(digits: int) -> Decimal:
    return Context(prec=digits).ln(Decimal(2))


def _narrowed(root: Root) -> tuple[Fraction, Fraction]:
    """The enclosure of a root, a simple one, narrowed to 256 bits by quadratic interval refinement (Abbott 2006).

    The secant says in which of 2^n equal parts the root should lie. Where it does, n is doubled; otherwise what the
    signs leave is kept, and n is halved. All in integers: the ends over v, the values times v^degree.
    """
    f, v, n = root.coefficients, lcm(root.low.denominator, root.high.denominator), 1
    low, high = int(root.low * v), int(root.high * v)
    at_low, at_high = _value(f, low, v), _value(f, high, v)
    while high - low << 256 > abs(high):
        if not at_low or not at_high:
            low = high = high if at_low else low
            break
        part = high - low
        shift = n * (len(f) - 1)
        v, low, high, at_low, at_high = v << n, low << n, high << n, at_low << shift, at_high << shift
        left = low + part * min((at_low << n) // (at_low - at_high), (1 << n) - 1)
        right = left + part
        at_left, at_right = _value(f, left, v), _value(f, right, v)
        if (at_left > 0) != (at_low > 0):
            high, at_high, n = left, at_left, max(1, n // 2)
        elif (at_right > 0) == (at_low > 0) and at_right:
            low, at_low, n = right, at_right, max(1, n // 2)
        else:
            low, at_low, high, at_high, n = left, at_left, right, at_right, 2 * n
    return Fraction(low, v), Fraction(high, v)


def _value(coefficients: tuple[int, ...], u: int, v: int) -> int:
    """The integer v^degree times the polynomial at u/v."""
    total, power = 0, 1
    for c in reversed(coefficients):
        total = total * u + c * power
        power *= v
    return total
