"""Closed forms as real numbers: rational enclosures and exact order, standard library only.

Logarithms are those of `decimal`, correctly rounded to 90 digits; the error that is added to each is some ten digits
larger than all roundings together.
"""

from __future__ import annotations

from decimal import Context, Decimal
from fractions import Fraction

from subdiv_cli.model import ClosedForm, Root, RootLog

_BITS = 272
_CONTEXT = Context(prec=90)
_ERROR = Fraction(1, 10**75)
_LN_2 = Fraction(_CONTEXT.ln(Decimal(2)))


def enclosure(x: ClosedForm, *, refined: bool = False) -> tuple[Fraction, Fraction]:
    """lower <= x <= upper, 70 digits apart or, for a logarithm of a root, as the root is enclosed.

    `refined` bisects that enclosure to 256 bits.
    """
    if isinstance(x, Fraction):
        return x, x
    if isinstance(x, RootLog):
        low, high = _bisected(x.root) if refined else (x.root.low, x.root.high)
        ends = -_logarithm(high)[1], -_logarithm(low)[0]
    else:
        ends = _logarithm(x.argument)
    scale = _logarithm(Fraction(x.base))
    quotients = [end / factor / x.divisor for end in ends for factor in scale]
    return min(quotients), max(quotients)


def compare(a: ClosedForm, b: ClosedForm) -> int | None:
    """The sign of a - b; None where 256 bits do not tell. Canonical forms are equal iff alike."""
    if a == b:
        return 0
    for refined in (False, True):
        (low, high), (lower, upper) = enclosure(a, refined=refined), enclosure(b, refined=refined)
        if low > upper or high < lower:
            return 1 if low > upper else -1
    return None


def _logarithm(x: Fraction) -> tuple[Fraction, Fraction]:
    """ln x enclosed, for x > 0 of any size: x = m 2^e with m of 272 bits, cut."""
    e = x.numerator.bit_length() - x.denominator.bit_length() - _BITS
    m = (x.numerator << max(0, -e)) // (x.denominator << max(0, e))
    value, error = Fraction(_CONTEXT.ln(Decimal(m))) + e * _LN_2, (1 + abs(e)) * _ERROR
    return value - error, value + error


def _bisected(root: Root) -> tuple[Fraction, Fraction]:
    """The enclosure of a root, a simple one, narrowed to 256 bits."""
    low, high = root.low, root.high
    rises = _sign(root.coefficients, high) > 0 or _sign(root.coefficients, low) < 0
    while (high - low) * (1 << 256) > high:
        middle = (low + high) / 2
        sign = _sign(root.coefficients, middle)
        if sign == 0:
            return middle, middle
        low, high = (low, middle) if (sign > 0) == rises else (middle, high)
    return low, high


def _sign(coefficients: tuple[int, ...], x: Fraction) -> int:
    """Of a polynomial at x, in integers."""
    u, v = x.as_integer_ratio()
    total, power = 0, 1
    for c in reversed(coefficients):
        total = total * u + c * power
        power *= v
    return (total > 0) - (total < 0)
