"""Exact numbers as text, for statements: exact where short, else digits that are all certain."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import arb, ctx, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, is_reciprocal
from subdiv_cli.exact.enclosures import bounds
from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.rationals import whole
from subdiv_cli.model import formulas
from subdiv_cli.model.closed import spelled_terms
from subdiv_cli.model.formulas import is_short as is_short
from subdiv_cli.model.formulas import number as number
from subdiv_cli.model.formulas import sized as sized
from subdiv_cli.model.formulas import truncated as truncated
from subdiv_cli.model.formulas import valued as valued


def rounded_down(x: float, digits: int = 6) -> str:
    """A decimal as text that is not above x, and above every integer that x is above."""
    below = Fraction(Fraction(x) * 10**digits // 1, 10**digits)
    return (
        rounded_down(x, 2 * digits) if below.denominator == 1 and below < x and digits < 50 else decimal(below, digits)
    )


def rounded_up(x: float, digits: int = 6) -> str:
    """A decimal as text that is not below x, and below every integer that x is below."""
    above = Fraction(-(-Fraction(x) * 10**digits // 1), 10**digits)
    return rounded_up(x, 2 * digits) if above.denominator == 1 and above > x and digits < 50 else decimal(above, digits)


def certain(x: Callable[[], arb], digits: int = 10) -> str:
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
    """A polynomial as text, every coefficient in full: `81*x^2-27*x+1`."""
    return spelled_terms([(i, int(c)) for i, c in enumerate(f)][::-1], variable, "*", whole) or "0"


def laurent(a: Laurent) -> str:
    """A Laurent polynomial as text, by rising exponent: `-1/16 z^-3 + 9/16 z^-1 + 1`."""
    return formulas.laurent(a.low, a.coefficients())


def decimal(x: Fraction, places: int) -> str:
    """A rational with a denominator dividing 10^places, written out."""
    digits = whole(abs(x.numerator * 10**places // x.denominator)).rjust(places + 1, "0")
    return ("-" if x < 0 else "") + f"{digits[:-places]}.{digits[-places:]}"


def eigenvalue(x: AlgebraicNumber) -> str:
    """An eigenvalue as text: `1/2`, `0.8535533905…`, or `a pair of modulus 0.7071067811…` for conjugate ones."""
    if (exact := x.rational) is not None:
        return number(exact)
    return certain(lambda: x.enclosure().real) if x.is_real else f"a pair of modulus {modulus(x)}"


def modulus(x: AlgebraicNumber) -> str:
    """The modulus |λ| as text: exact where it is a simple rational, else its first digits."""
    if (exact := x.rational) is not None:
        return valued(abs(exact))
    simple = Fraction(float(x.region.__abs__().mid())).limit_denominator(1000)
    if simple and is_reciprocal(x.minimal_polynomial, simple) and x.compare_modulus(simple) == 0:
        return number(simple)
    return certain(x.modulus)
