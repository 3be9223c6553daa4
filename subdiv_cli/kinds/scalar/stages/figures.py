"""Exponents in figures, beside what is proved of them: many certain digits, or an estimate that says it is one."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.closed import closed_ball
from subdiv_cli.exact.text import certain
from subdiv_cli.kinds.scalar.numbers.estimate import extrapolated_exponent
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import ClosedForm, Effort

_DIGITS = 40
_WORK = 20_000
"""For the norms of an estimate, whatever the effort: where it is small an estimate is wanted most."""


def digits(x: ClosedForm) -> str | None:
    """Decimals of an irrational exponent, all of them certain; None for a rational one."""
    return None if isinstance(x, Fraction) else certain(lambda: closed_ball(x), _DIGITS)


def estimate(numbers: ScalarNumbers, lower: float | None, upper: float | None) -> str | None:
    """What norms say of the Hölder exponent of φ, where it is only known to be between bounds wider than that.

    None where it is known better, or where the estimate contradicts the bounds.
    """
    numbers = numbers.reduced
    product = numbers.product
    if lower is None or upper is None or numbers.order < 1 or numbers.effort.struck:
        return None
    period = 1 if product is None else len(product.word)
    found = extrapolated_exponent(numbers.difference(numbers.order), numbers.p, period, Effort(_WORK))
    if found is None:
        return None
    value, places = found
    low, high, unit = Fraction(lower), Fraction(upper), Fraction(1, 10**places)
    worth = high - low > unit and low - unit <= Fraction(value) <= high + unit
    return f"{value:.{places}f}" if worth else None
