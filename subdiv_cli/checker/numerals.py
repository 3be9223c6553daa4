"""Numbers and digits in strings, read strictly: integers of any length and rationals in lowest terms."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache
from math import gcd
from typing import Self

MAX_DIGITS = 20_000
"""The most decimal digits of a number, and of the common denominator of a polynomial."""
_SHORT = 40
"""The most characters of a number that is kept once it is read."""
_RATIONAL = re.compile(r"-?([0-9]+)(?:/([0-9]+))?")
_DIGITS = re.compile(r"0|-?[1-9][0-9]*")


def shown(value: object) -> str:
    """Untrusted text in the form that messages show it: short and ASCII."""
    return ascii(value[:40] if isinstance(value, str) else type(value).__name__)


class UnreadableError(Exception):
    """Raised for a value that is not as specified, with the places on the way out to it, innermost first."""

    def __init__(self, why: str, place: str = "") -> None:
        self.why, self.place = why, place

    def within(self, place: str) -> Self:
        """The same error with one more place on the way out."""
        return type(self)(self.why, self.place + place)


class OversizedError(UnreadableError):
    """Raised for a value as specified that is longer than what is read."""


def demand(condition: bool, why: str) -> None:
    """Raise UnreadableError, with this reason, unless the condition holds."""
    if not condition:
        raise UnreadableError(why)


def demand_few(condition: bool, why: str) -> None:
    """Raise OversizedError, with this reason, unless the condition holds: there may be only so much of something."""
    if not condition:
        raise OversizedError(why)


def rational(value: object) -> tuple[int, int]:
    """The rational that `"p/q"` or `"p"` in lowest terms spells, as (p, q), q > 0. Raises UnreadableError else."""
    if type(value) is str and len(value) <= _SHORT:
        return _short_ratio(value)
    return _ratio(value)


def _ratio(value: object) -> tuple[int, int]:
    if type(value) is not str:
        raise UnreadableError('is not a string "p/q"')
    demand_few(len(value) <= 2 * MAX_DIGITS + 2, "has too many digits")
    match = _RATIONAL.fullmatch(value)
    if match is None:
        raise UnreadableError(f"is not a rational: {shown(value)}")
    digits, below = match[1], match[2] or "1"
    demand_few(max(len(digits), len(below)) <= MAX_DIGITS, "has too many digits")
    p, q = _decimal(digits), _decimal(below)
    canonical = (digits[0] != "0" or value == "0") and below[0] != "0" and match[2] != "1" and gcd(p, q) == 1
    demand(canonical, "is not in lowest terms")
    return (-p if value[0] == "-" else p), q


_short_ratio = lru_cache(4096)(_ratio)
"""The ratio of a short number, remembered, since short numbers come again and again."""
_short_fraction = lru_cache(4096)(lambda text: Fraction(*_ratio(text)))


def _decimal(digits: str) -> int:
    """The integer with these digits, read in pieces, because Python refuses to read long integers at once."""
    value = 0
    for i in range(0, len(digits), 600):
        piece = digits[i : i + 600]
        value = value * 10 ** len(piece) + int(piece)
    return value


def fraction(value: object) -> Fraction:
    """The fraction that `"p/q"` or `"p"` in lowest terms spells. Raises UnreadableError for others."""
    if type(value) is str and len(value) <= _SHORT:
        return _short_fraction(value)
    return Fraction(*_ratio(value))


def long_integer(most: int, value: object) -> int:
    """The integer that `"n"` spells without leading zeros. Raises UnreadableError for others."""
    if type(value) is not str:
        raise UnreadableError("is not a string of digits")
    demand_few(len(value) <= most + 1, "has too many digits")
    digits = value.lstrip("-")
    demand(len(digits) <= most and _DIGITS.fullmatch(value) is not None, f"is not an integer: {shown(value)}")
    return -_decimal(digits) if value[0] == "-" else _decimal(digits)
