"""Strict reading: JSON text to integers, rationals, polynomials. Whatever is not exactly as specified is rejected."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from math import gcd
from typing import Any

from subdiv_cli.checker.polynomials import Polynomial, over_common_denominator

MAX_BYTES = 64 << 20
MAX_DIGITS = 20_000
"""Decimal digits of a number, and of the common denominator of a polynomial."""
MAX_LENGTH = 4_000
"""Coefficients of a polynomial, letters of a word, members of a list."""
MAX_INTEGER = 1_000_000
"""An index or an exponent."""
MAX_NATURAL = 10_000
"""An order, a level, a letter, the number of a mask or of a claim."""

_RANGES = {"natural": (0, MAX_NATURAL), "integer": (-MAX_INTEGER, MAX_INTEGER), "work": (0, 10**9)}
_RATIONAL = re.compile(r"-?([0-9]+)(?:/([0-9]+))?")

Fields = Mapping[str, str]
"""The keys of an object, all of them obligatory, and the kind of each value."""


class Rejected(Exception):  # noqa: N818 (an answer, not an error)
    """Why a certificate does not verify."""


def require(condition: bool, why: str) -> None:
    if not condition:
        raise Rejected(why)


def parse(text: str) -> object:
    """JSON without floats, constants, long integers and duplicate keys."""
    require(len(text) <= MAX_BYTES, "the file is too large")
    try:
        return json.loads(
            text, object_pairs_hook=_object, parse_int=_small, parse_float=_no_float, parse_constant=_no_float
        )
    except ValueError as error:
        raise Rejected(f"not JSON: {error}"[:200]) from None
    except RecursionError:
        raise Rejected("nested too deeply") from None


def shown(value: object) -> str:
    """Untrusted text in a message: short and ASCII."""
    return ascii(value[:40] if isinstance(value, str) else type(value).__name__)


def read_object(value: object, fields: Fields, what: str) -> dict[str, Any]:
    """The values of an object that has exactly these keys."""
    if type(value) is not dict:
        raise Rejected(f"{what} is not an object")
    if value.keys() != fields.keys():
        for key in value:
            require(key in fields, f"{what} has the unknown key {shown(key)}")
        raise Rejected(f"{what} has no key '{min(fields.keys() - value.keys())}'")
    return {
        key: value[key] if kind == "any" else read(kind, value[key], f"'{key}' of {what}")
        for key, kind in fields.items()
    }


def read(kind: str, value: object, what: str) -> Any:
    """A value of one of the kinds below; a kind that ends in [] is a list."""
    if (reader := _READERS.get(kind)) is not None:
        return reader(value, what)
    if kind in _RANGES:
        return _integer(*_RANGES[kind], value, what)
    if type(value) is not list:
        raise Rejected(f"{what} is not a list")
    require(len(value) <= MAX_LENGTH, f"{what} is too long")
    member, what = kind.removesuffix("[]"), f"a member of {what}"
    return tuple(read(member, x, what) for x in value)


def _integer(least: int, greatest: int, value: object, what: str) -> int:
    if type(value) is not int:
        raise Rejected(f"{what} is not an integer")
    require(least <= value <= greatest, f"{what} is out of range")
    return value


def _boolean(value: object, what: str) -> bool:
    if type(value) is not bool:
        raise Rejected(f"{what} is not a boolean")
    return value


def _fraction(value: object, what: str) -> Fraction:
    return Fraction(*_rational(value, what))


def _polynomial(value: object, what: str) -> Polynomial:
    fields = read_object(value, {"start": "integer", "coefficients": "any"}, what)
    coefficients = fields["coefficients"]
    if type(coefficients) is not list:
        raise Rejected(f"the coefficients of {what} are not a list")
    require(len(coefficients) <= MAX_LENGTH, f"{what} is too long")
    coefficient = f"a coefficient of {what}"
    pairs = [_rational(c, coefficient) for c in coefficients]
    f = over_common_denominator(fields["start"], pairs, most_bits=MAX_DIGITS * 10 // 3)
    if f is None:
        raise Rejected(f"the common denominator of {what} is too large")
    return f


def _rational(value: object, what: str) -> tuple[int, int]:
    """`"p/q"` or `"p"` in lowest terms as (p, q), q > 0."""
    if type(value) is not str:
        raise Rejected(f'{what} is not a string "p/q"')
    require(len(value) <= 2 * MAX_DIGITS + 2, f"{what} has too many digits")
    match = _RATIONAL.fullmatch(value)
    if match is None:
        raise Rejected(f"{what} is not a rational: {shown(value)}")
    digits, below = match[1], match[2] or "1"
    require(max(len(digits), len(below)) <= MAX_DIGITS, f"{what} has too many digits")
    p, q = _decimal(digits), _decimal(below)
    canonical = (digits[0] != "0" or value == "0") and below[0] != "0" and match[2] != "1" and gcd(p, q) == 1
    require(canonical, f"{what} is not in lowest terms")
    return (-p if value[0] == "-" else p), q


def _decimal(digits: str) -> int:
    """In pieces, because Python refuses to read long integers at once."""
    value = 0
    for i in range(0, len(digits), 600):
        piece = digits[i : i + 600]
        value = value * 10 ** len(piece) + int(piece)
    return value


_READERS: Mapping[str, Callable[[object, str], Any]] = {
    "any": lambda value, _: value,
    "boolean": _boolean,
    "rational": _fraction,
    "polynomial": _polynomial,
}


def _object(pairs: list[tuple[str, object]]) -> dict[str, object]:
    result = dict(pairs)
    require(len(result) == len(pairs), "an object has a key twice")
    return result


def _small(digits: str) -> int:
    require(len(digits) <= 12 and digits != "-0", "an integer is too long")
    return int(digits)


def _no_float(digits: str) -> int:
    raise Rejected(f"{shown(digits)} is not an exact number")
