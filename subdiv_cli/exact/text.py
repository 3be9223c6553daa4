"""Exact numbers as text, for statements: exact where short, else digits that are all certain."""

from __future__ import annotations

from fractions import Fraction

from flint import arb, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated_roots
from subdiv_cli.exact.enclosures import ball, bounds
from subdiv_cli.exact.laurent import Laurent

_LONGEST_EXACT = 24
_DIGITS = 10


def number(x: Fraction) -> str:
    """`-7/16`; a rational with a long spelling as its first digits, `0.43843…`, cut and not rounded."""
    return str(x) if len(str(x)) <= _LONGEST_EXACT else truncated(x)


def truncated(x: Fraction, digits: int = _DIGITS) -> str:
    """The decimal digits of x up to some place, followed by `…`; tiny and huge numbers with an exponent."""
    if x < 0:
        return "-" + truncated(-x, digits)
    exponent = 0
    if x and not Fraction(1, 10**4) <= x < 10**6:
        exponent = len(str(x.numerator)) - len(str(x.denominator))
        exponent -= x < Fraction(10) ** exponent
        x /= Fraction(10) ** exponent
    whole, decimals = divmod(x.numerator * 10**digits // x.denominator, 10**digits)
    return f"{whole}.{decimals:0{digits}d}…" + (f"e{exponent}" if exponent else "")


def rounded_down(x: float, digits: int = 6) -> str:
    """A decimal that is not above x."""
    return _decimal(Fraction(Fraction(x) * 10**digits // 1, 10**digits), digits)


def rounded_up(x: float, digits: int = 6) -> str:
    """A decimal that is not below x."""
    return _decimal(Fraction(-(-Fraction(x) * 10**digits // 1), 10**digits), digits)


def certain(x: arb, digits: int = _DIGITS) -> str:
    """The digits on which both ends of a ball agree, at most some places."""
    low, high = bounds(x)
    while digits > 1 and truncated(low, digits) != truncated(high, digits):
        digits -= 1
    return truncated(low if abs(low) < abs(high) else high, digits)


def polynomial(f: fmpz_poly, variable: str = "x") -> str:
    """`81*x^2-27*x+1`."""
    return _terms([(i, Fraction(int(c))) for i, c in enumerate(f)][::-1], variable, "*") or "0"


def laurent(a: Laurent) -> str:
    """`-1/16 z^-3 + 9/16 z^-1 + 1`, by rising exponent."""
    return _terms([(a.low + i, c) for i, c in enumerate(a.coefficients())], "z", " ", " ") or "0"


def _terms(terms: list[tuple[int, Fraction]], variable: str, times: str, space: str = "") -> str:
    text = ""
    for exponent, c in terms:
        if not c:
            continue
        power = "" if exponent == 0 else variable if exponent == 1 else f"{variable}^{exponent}"
        size = "" if power and abs(c) == 1 else number(abs(c))
        sign = ("-" if c < 0 else "") if not text else f"{space}{'-' if c < 0 else '+'}{space}"
        text += sign + size + (times if size and power else "") + power
    return text


def root(x: AlgebraicNumber) -> str:
    """An algebraic number in the grammar of closed forms: a rational, or `root(x^2-x-1, 1.618, 1.6181)` for a real one.

    Raises ValueError for a number that is not real.
    """
    if (exact := x.rational) is not None:
        return str(exact)
    if not x.is_real:
        raise ValueError("not a real number")
    low, high, _, _ = x.box()
    real = [z for z in isolated_roots(x.minimal_polynomial) if z.imag.is_zero()]
    others = [z.real for z in real if not z.overlaps(x.region)]
    places = 4
    while True:
        unit = Fraction(1, 10**places)
        left, right = (low // unit) * unit, -((-high) // unit) * unit
        if all(z < ball(left) or z > ball(right) for z in others):
            return f"root({polynomial(x.minimal_polynomial)}, {_decimal(left, places)}, {_decimal(right, places)})"
        places *= 2


def _decimal(x: Fraction, places: int) -> str:
    """A rational with a denominator dividing 10^places, written out."""
    digits = f"{abs(x.numerator * 10**places // x.denominator):0{places + 1}d}"
    return ("-" if x < 0 else "") + f"{digits[:-places]}.{digits[-places:]}"


def eigenvalue(x: AlgebraicNumber) -> str:
    """For a list of eigenvalues: `1/2`, `0.8535533905…`, or the modulus `|0.7071067811…|` of a complex one."""
    if (exact := x.rational) is not None:
        return number(exact)
    return certain(x.region.real) if x.is_real else f"|{certain(x.region.__abs__())}|"
