"""Exact numbers as text, for statements: exact where short, else digits that are all certain."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import arb, ctx, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, is_reciprocal
from subdiv_cli.exact.enclosures import bounds
from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.rationals import whole
from subdiv_cli.model.closed import spelled_terms

_LONGEST_EXACT = 24
_DIGITS = 10
_LONGEST_BITS = 256
"""Python refuses to print huge integers and is slow at large ones: from here on only leading digits are shown."""


def number(x: Fraction) -> str:
    """`-7/16`; a rational with a long spelling as its first digits, `0.43843…`, cut and not rounded."""
    short = is_short(x) and len(str(x)) <= _LONGEST_EXACT
    return str(x) if short else truncated(x)


def is_short(x: Fraction) -> bool:
    """Whether x can be printed in full without thought."""
    return max(x.numerator.bit_length(), x.denominator.bit_length()) <= _LONGEST_BITS


def truncated(x: Fraction, digits: int = _DIGITS) -> str:
    """The decimal digits of x up to some place, followed by `…`; tiny and huge numbers with an exponent."""
    if x < 0:
        return "-" + truncated(-x, digits)
    exponent = 0
    if x and not Fraction(1, 10**4) <= x < 10**6:
        exponent = _decimal_exponent(x)
        x /= Fraction(10) ** exponent
    whole, decimals = divmod(x.numerator * 10**digits // x.denominator, 10**digits)
    return f"{whole}.{decimals:0{digits}d}…" + (f"e{exponent}" if exponent else "")


def _decimal_exponent(x: Fraction) -> int:
    """The e with 10^e <= x < 10^(e+1), x > 0: estimated from the bits, then put right."""
    exponent = (x.numerator.bit_length() - x.denominator.bit_length()) * 30103 // 100000
    while x < Fraction(10) ** exponent:
        exponent -= 1
    while x >= Fraction(10) ** (exponent + 1):
        exponent += 1
    return exponent


def rounded_down(x: float, digits: int = 6) -> str:
    """A decimal that is not above x, and above every integer that x is above."""
    below = Fraction(Fraction(x) * 10**digits // 1, 10**digits)
    return (
        rounded_down(x, 2 * digits) if below.denominator == 1 and below < x and digits < 50 else decimal(below, digits)
    )


def rounded_up(x: float, digits: int = 6) -> str:
    """A decimal that is not below x, and below every integer that x is below."""
    above = Fraction(-(-Fraction(x) * 10**digits // 1), 10**digits)
    return rounded_up(x, 2 * digits) if above.denominator == 1 and above > x and digits < 50 else decimal(above, digits)


def certain(x: Callable[[], arb], digits: int = _DIGITS) -> str:
    """The first digits of a real number, all of them certain; `x` gives a ball around it at the current precision.

    A number so close to a decimal that 256 bits do not separate them is shown as the double next to it, without `…`, or
    as this decimal where doubles do not reach.
    """
    precision = 64
    while precision <= 256:
        with ctx.workprec(precision):
            low, high = bounds(x())
        if truncated(low, digits) == truncated(high, digits):
            return truncated(low, digits)
        precision *= 2
    middle = (low + high) / 2
    try:
        return repr(float(middle))
    except OverflowError:
        return truncated(middle * (1 + Fraction(1, 10 ** (digits + 2))), digits).replace("…", "")


def polynomial(f: fmpz_poly, variable: str = "x") -> str:
    """`81*x^2-27*x+1`, every coefficient in full."""
    return spelled_terms([(i, int(c)) for i, c in enumerate(f)][::-1], variable, "*", whole) or "0"


def laurent(a: Laurent) -> str:
    """`-1/16 z^-3 + 9/16 z^-1 + 1`, by rising exponent."""
    return spelled_terms([(a.low + i, c) for i, c in enumerate(a.coefficients())], "z", " ", number, " ") or "0"


def decimal(x: Fraction, places: int) -> str:
    """A rational with a denominator dividing 10^places, written out."""
    digits = whole(abs(x.numerator * 10**places // x.denominator)).rjust(places + 1, "0")
    return ("-" if x < 0 else "") + f"{digits[:-places]}.{digits[-places:]}"


def eigenvalue(x: AlgebraicNumber) -> str:
    """For a list of eigenvalues: `1/2`, `0.8535533905…`, or `a pair of modulus 0.7071067811…` for conjugate ones."""
    if (exact := x.rational) is not None:
        return number(exact)
    return certain(lambda: x.enclosure().real) if x.is_real else f"a pair of modulus {modulus(x)}"


def modulus(x: AlgebraicNumber) -> str:
    """|λ|: exact where it is a simple rational, else its first digits."""
    if (exact := x.rational) is not None:
        return number(abs(exact))
    simple = Fraction(float(x.region.__abs__().mid())).limit_denominator(1000)
    if simple and is_reciprocal(x.minimal_polynomial, simple) and x.compare_modulus(simple) == 0:
        return number(simple)
    return certain(x.modulus)
