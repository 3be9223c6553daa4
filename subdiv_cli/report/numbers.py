"""Numbers in a report: exact first, then the digits that are certain and no others."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from subdiv_cli.model import Data, Exponent, Interval
from subdiv_cli.model.closed import is_brief, rational, spelled
from subdiv_cli.model.formulas import is_plain

PLACES = 10
"""The most decimal places, where a number is not known exactly."""
LONGEST = 160
"""The most characters of a closed form that is still read with profit."""


def finite(bound: float | None) -> float | None:
    """The bound, or None where it is infinite."""
    return bound if bound is not None and math.isfinite(bound) else None


def decimal(value: Fraction, places: int, *, up: bool) -> str:
    """The nearest decimal with so many places that is not below (`up`) or not above the value."""
    scaled = value * 10**places
    digits = math.ceil(scaled) if up else math.floor(scaled)
    sign, text = "-" if digits < 0 else "", rational(abs(digits)).rjust(places + 1, "0")
    return sign + (f"{text[:-places]}.{text[-places:]}" if places else text)


def bound(value: Fraction, places: int, *, up: bool) -> str:
    """A bound as a decimal, rounded outward but never onto an integer, for which it may need more places.

    Integers are thresholds: α ≤ 1.9999 rules out C^2, and α ≤ 2 does not.
    """
    while value.denominator > 1 and (math.ceil if up else math.floor)(value * 10**places) % 10**places == 0:
        places += 1
    return _strip(decimal(value, places, up=up))


def digits(lower: float, upper: float) -> str:
    """The certain digits of a number in [lower, upper]. Raises ValueError where lower is larger than upper.

    `2` or `1.5` where both bounds are that number; `2.8300749985…` where all the digits shown are digits of the
    number (cut, not rounded); otherwise `1.99 .. 2.01`, an interval that contains the given one.
    """
    low, high = Fraction(lower), Fraction(upper)
    if low > high:
        raise ValueError(f"no number is at least {lower} and at most {upper}")
    if low == high and not (low * 10**PLACES).denominator > 1:
        return _strip(decimal(low, PLACES, up=False))
    wanted = worth(lower, upper)
    for places in (wanted, wanted - 1, wanted - 2):
        if places > 0 and low * high > 0:
            cut = decimal(low, places, up=low < 0)
            same = cut == decimal(high, places, up=low < 0)
            if same and (not _is_whole(cut) or Fraction(cut) == (high if low < 0 else low)):
                return cut + "…"
    return f"{bound(low, wanted, up=False)} .. {bound(high, wanted, up=True)}"


def at_least(lower: float, places: int = 6) -> str:
    """A lower bound as text, rounded down: `≥ 1.833915`."""
    return f"≥ {bound(Fraction(lower), places, up=False)}"


def at_most(upper: float, places: int = 6) -> str:
    """An upper bound as text, rounded up: `≤ 2.000001`."""
    return f"≤ {bound(Fraction(upper), places, up=True)}"


def enclosed(lower: float | None, upper: float | None, closed: str | None = None) -> str | None:
    """An exact number with its digits, or an interval, or a bound, as text; None where nothing is known.

    A brief closed form stands before its digits, `log2(64/9) = 2.8300749985…`, and any other behind them.
    """
    lower, upper = finite(lower), finite(upper)
    if lower is not None and upper is not None:
        shown = digits(lower, upper)
        if closed is None or closed == shown:
            return shown
        if _is_rational(closed) and _terminates(closed):
            return closed
        if is_brief(closed):
            return f"{closed} {'∈' if ' .. ' in shown else '='} {shown}"
        return f"{shown}, exactly {closed}" if " .. " in shown else f"{shown} = {closed}"
    if closed is not None:
        return closed
    if lower is not None:
        return at_least(lower)
    return None if upper is None else at_most(upper)


def interval(value: Interval | Exponent, *, brief: bool = False) -> str | None:
    """An interval or an exponent as text; a closed form that takes lines is left to its digits.

    `brief`: one that is not read at a glance is, too.
    """
    closed = value.exact if value.exact is None or isinstance(value.exact, str) else spelled(value.exact)
    fits = closed is not None and (is_brief(closed) if brief else len(closed) <= LONGEST)
    return enclosed(value.lower, value.upper, closed if fits or value.lower is None or value.upper is None else None)


def data(value: Data) -> str:
    """A fact or a witness as text, whatever its shape."""
    if value is None:
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    if isinstance(value, int | Fraction):
        return rational(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key}: {data(item)}" for key, item in value.items()) + "}"
    return "(" + ", ".join(map(data, value)) + ")"


def worth(lower: float, upper: float) -> int:
    """The number of decimal places that an interval is worth: three digits of its length, and never too many."""
    spread, places = Fraction(upper) - Fraction(lower), 1
    while places < PLACES and spread * 10**places < 100:
        places += 1
    return places


def _is_whole(text: str) -> bool:
    return not text.partition(".")[2].strip("0")


def _strip(text: str) -> str:
    return text.rstrip("0").rstrip(".") if "." in text else text


def _is_rational(text: str) -> bool:
    return text.removeprefix("-").replace("/", "", 1).isdecimal()


def _terminates(text: str) -> bool:
    """Whether a rational needs no digits beside it: an integer, or a short decimal such as 3/2."""
    return (Fraction(text) * 1000).denominator == 1 and is_plain(Fraction(text))
