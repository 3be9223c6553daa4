"""Exponents in closed form: -log_p of a joint spectral radius, as balls, as outward doubles, and as text."""

from __future__ import annotations

import math
from fractions import Fraction

from flint import arb, ctx, fmpz_poly

from subdiv_cli.exact.algebraic import isolated_roots, number_of
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import decimal, polynomial
from subdiv_cli.model import ClosedForm, Interval, Log, Root, RootLog, logarithm, unpowered

_LONGEST = 160
"""Characters of a closed form that is still read with profit."""
_SIGNIFICANT = 5


def exponent(p: int, length: int, root: Root) -> ClosedForm:
    """-log_p(Λ)/length for a root Λ > 0 of an irreducible polynomial: rational where it can be."""
    if len(root.coefficients) == 2:
        return logarithm(p, 1 / Fraction(-root.coefficients[0], root.coefficients[1]), length)
    base, divisor = unpowered(p, length)
    text = f"-log{base}({root_text(root)})" + (f"/{divisor}" if divisor > 1 else "")
    return RootLog(base, root, divisor, text)


def root_text(root: Root) -> str:
    """`root(32*x^3+4*x-1, 0.19273, 0.19274)`: decimals that isolate it among the real roots."""
    f = fmpz_poly(list(root.coefficients))
    others = [z.real for z in isolated_roots(f) if z.imag.is_zero()]
    others = [z for z in others if not z.overlaps(number_of(root).region.real)]
    places = max(1, _SIGNIFICANT - math.floor(math.log10(root.low.numerator) - math.log10(root.low.denominator)))
    while True:
        unit = Fraction(1, 10**places)
        low, high = root.low // unit * unit, -(-root.high // unit) * unit
        if all(z < ball(low) or z > ball(high) for z in others):
            return f"root({polynomial(f)}, {decimal(low, places)}, {decimal(high, places)})"
        places += _SIGNIFICANT


def closed_ball(x: ClosedForm) -> arb:
    """A ball around a closed form, at the current precision."""
    if isinstance(x, Fraction):
        return ball(x)
    if isinstance(x, RootLog):
        return -number_of(x.root).enclosure().real.log() / ball(x.base).log() / x.divisor
    return ball(x.argument).log() / ball(x.base).log() / x.divisor


def closed_interval(x: ClosedForm) -> Interval:
    """Outward doubles around a closed form, and its text where that is not too long to read."""
    if isinstance(x, Fraction):
        return interval(x)
    with ctx.workprec(128):
        return interval(closed_ball(x), str(x) if is_readable(x) else None)


def is_readable(x: ClosedForm) -> bool:
    """Whether its text is short enough for a report."""
    if isinstance(x, RootLog):
        return len(x.text) <= _LONGEST
    parts = (x.argument if isinstance(x, Log) else x).as_integer_ratio()
    return max(part.bit_length() for part in parts) <= 1024
