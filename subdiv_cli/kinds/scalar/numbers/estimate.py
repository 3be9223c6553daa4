"""The Hölder exponent as norms suggest it, extrapolated: an estimate, on which no verdict depends.

With N_L = ‖D^L‖∞, -log_p(N_L)/L tends to the exponent like 1/L; the slopes (log N_(L+ℓ) - log N_L)/ℓ, ℓ the length of a
product that attains the radius or is thought to, like a power of L or faster. Aitken's Δ² takes them further, once or
twice, and the decimals in which the last three values agree are worth showing.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import islice, pairwise
from typing import Any

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Effort

_LEVELS = 32
_DIGITS = 50
_MOST_PLACES = 12
_AGREEING = 3
_WORK = 20_000
"""The work for the norms of an estimate, whatever the effort: where that is small an estimate is wanted most."""


def estimated_exponent(numbers: ScalarNumbers, lower: float | None, upper: float | None) -> str | None:
    """The Hölder exponent as norms suggest it, as text, where it is only known to be between wider bounds.

    `numbers` are those of the reduced mask. None where it is known better, or where the estimate contradicts bounds.
    """
    product = numbers.product
    if lower is None or upper is None or numbers.effort.struck:
        return None
    period = 1 if product is None else len(product.word)
    extrapolated = extrapolated_exponent(numbers.difference(numbers.order), numbers.p, period, Effort(_WORK))
    if extrapolated is None:
        return None
    value, places = extrapolated
    low, high, unit = Fraction(lower), Fraction(upper), Fraction(1, 10**places)
    worth = high - low > unit and low - unit <= Fraction(value) <= high + unit
    return f"{value:.{places}f}" if worth else None


def extrapolated_exponent(d: Laurent, p: int, period: int, effort: Effort) -> tuple[float, int] | None:
    """An estimate of the exponent for the scheme with symbol d ≠ 0, and how many decimals of it norms agree in.

    None where the effort does not suffice for enough levels, or not one decimal is worth showing.
    """
    from mpmath import mp, mpf  # type: ignore[import-untyped]

    norms = list(islice(power_norms(d, p, effort), _LEVELS))
    with mp.workdps(_DIGITS):
        logs = [mp.log(mpf(norm.numerator) / norm.denominator, p) for norm in norms if norm]
        slopes = [(a - b) / period for a, b in zip(logs, logs[period:], strict=False)]
        once = _accelerated(slopes)
        tried = [(_gap(x), x[-1]) for x in (slopes, once, _accelerated(once)) if len(x) >= _AGREEING]
        if not tried:
            return None
        gap, value = min(tried)
        places = _MOST_PLACES if gap < mpf(10) ** -_MOST_PLACES else int(-mp.log10(gap))
        return (float(value), places) if places >= 1 else None


def _gap(x: Sequence[Any]) -> Any:
    """The largest distance of the last values from each other."""
    return max(x[-_AGREEING:]) - min(x[-_AGREEING:])


def _accelerated(x: Sequence[Any]) -> list[Any]:
    """The sequence x_(n+2) - (Δx_(n+1))²/Δ²x_n (Aitken), and x_(n+2) itself where the sequence stands still."""
    steps = [b - a for a, b in pairwise(x)]
    return [last - (b * b / (b - a) if b != a else 0) for (a, b), last in zip(pairwise(steps), x[2:], strict=True)]
