"""Exponents in closed form: -log_p of a joint spectral radius, as balls, as outward doubles, and as text."""

from __future__ import annotations

import math
from fractions import Fraction

from flint import arb, ctx, fmpz_poly

from subdiv_cli.exact.algebraic import isolated, isolating_interval, number_of, only_root, same_powers
from subdiv_cli.exact.enclosures import ball, decide, interval
from subdiv_cli.exact.text import certain, decimal, polynomial
from subdiv_cli.model import ClosedForm, Interval, Root, RootLog, logarithm, unpowered
from subdiv_cli.model.closed import is_brief, root_log_text, spelled

_LONGEST = 160
"""The most characters of a closed form that is still read with profit."""
_DIGITS = 40
_SIGNIFICANT = 5
_PRECISION = 256


def exponent(p: int, length: int, root: Root) -> ClosedForm:
    """The closed form of -log_p(Λ)/length for a root Λ > 0 of an irreducible polynomial, without roots if possible.

    A power of Λ is rational iff the polynomial is c x^n - a: if Λ^n = q with the smallest n, |N(Λ)|^n = q^d for the
    degree d <= n of Λ, so Λ^d = |N(Λ)| is rational and d = n.
    """
    first, *between, last = root.coefficients
    if not any(between):
        return logarithm(p, Fraction(abs(last), abs(first)), length * (len(between) + 1))
    base, divisor = unpowered(p, length)
    return RootLog(base, root, divisor, root_log_text(base, *_parts_of_text(root), divisor))


def root_text(root: Root) -> str:
    """A root as text, with decimals that isolate it among the real roots: `root(32*x^3+4*x-1, 0.19273, 0.19274)`."""
    return f"root({', '.join(_parts_of_text(root))})"


def _parts_of_text(root: Root) -> tuple[str, str, str]:
    low, high = isolating_interval(number_of(root), _SIGNIFICANT)
    places = max(1, *(_places(x) for x in (low, high)))
    return polynomial(fmpz_poly(list(root.coefficients))), decimal(low, places), decimal(high, places)


def _places(x: Fraction) -> int:
    """The number of decimals that write a rational whose denominator divides a power of ten."""
    twos = (x.denominator & -x.denominator).bit_length() - 1
    fives, rest = 0, x.denominator >> twos
    while rest > 1:
        fives, rest = fives + 1, rest // 5
    return max(twos, fives)


def closed_ball(x: ClosedForm) -> arb:
    """A ball around a closed form, at the current precision."""
    if isinstance(x, Fraction | float):
        return ball(x) if isinstance(x, Fraction) else arb(x)
    if isinstance(x, RootLog):
        return -number_of(x.root).enclosure().real.log() / ball(x.base).log() / x.divisor
    return ball(x.argument).log() / ball(x.base).log() / x.divisor


def closed_interval(x: ClosedForm) -> Interval:
    """Outward doubles around a closed form, and its text where expectations can read that."""
    if isinstance(x, Fraction | float):
        return interval(x) if isinstance(x, Fraction) else Interval(exact=spelled(x))
    with ctx.workprec(128):
        return interval(closed_ball(x), spelled(x))


def worded(x: ClosedForm) -> str:
    """A closed form in a sentence: `log2(64/9)`; one that is not brief behind its digits, `1.4407654450… = -log2(…)`.

    One that is too long to be read with profit is its digits alone.
    """
    text = spelled(x)
    if text is not None and is_brief(text):
        return text
    figures = certain(lambda: closed_ball(x))
    return figures if text is None or len(text) > _LONGEST else f"{figures} = {text}"


def compare(x: ClosedForm, y: ClosedForm) -> int | None:
    """The sign of x - y, exactly; None where 256 bits do not separate them and their equality is not decided.

    Logarithms to one base (as all are of one scheme) are decided up to the size of polynomials: a rational or the
    logarithm of a rational never equals that of a Λ without rational powers, canonical logarithms of rationals are
    equal iff they are alike, and log(Λ)/d = log(M)/e iff Λ^e = M^d.
    """
    x, y = _canonical(x), _canonical(y)
    if x == y:
        return 0
    with ctx.workprec(_PRECISION):
        if (sign := _sign(x, y)) is not None:
            return sign
    if isinstance(x, Fraction | float) or isinstance(y, Fraction | float):
        return decide(lambda: _sign(x, y))
    if x.base != y.base:
        return None
    if isinstance(x, RootLog) and isinstance(y, RootLog):
        common = math.gcd(x.divisor, y.divisor)
        equal = same_powers(number_of(x.root), y.divisor // common, number_of(y.root), x.divisor // common)
        if equal is not False:
            return 0 if equal else None
    return decide(lambda: _sign(x, y))


def _sign(x: ClosedForm, y: ClosedForm) -> int | None:
    a, b = closed_ball(x), closed_ball(y)
    return 1 if a > b else -1 if a < b else None


def _canonical(x: ClosedForm) -> ClosedForm:
    """The same number over the minimal polynomial of its root, or without a root."""
    if not isinstance(x, RootLog):
        return x
    number = only_root(x.root)
    if (rational := number.rational) is not None:
        return logarithm(x.base, 1 / rational, x.divisor)
    return exponent(x.base, x.divisor, isolated(number))


def digits(x: ClosedForm) -> str | None:
    """Decimals of an irrational number, all of them certain; None for a rational one."""
    return None if isinstance(x, Fraction | float) else certain(lambda: closed_ball(x), _DIGITS)
