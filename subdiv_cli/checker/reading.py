"""Strict reading: JSON text to integers, rationals, polynomials. Whatever is not exactly as specified is rejected."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache, lru_cache, partial
from itertools import pairwise
from math import gcd, lcm
from typing import Any

from subdiv_cli.checker.matrices import Family, family
from subdiv_cli.checker.polynomials import Polynomial, over_common_denominator

Fields = Mapping[str, str]
"""The keys of an object, all of them obligatory, and the kind of each value."""

MAX_BYTES = 64 << 20
MAX_DIGITS = 20_000
"""Decimal digits of a number, and of the common denominator of a polynomial."""
MAX_LENGTH = 4_000
"""Coefficients of a polynomial, letters of a word, members of a list."""
MAX_INTEGER = 1_000_000
"""An index or an exponent."""
MAX_NATURAL = 10_000
"""An order, a level, a letter, the number of a mask or of a claim."""
MAX_ORDER = 120
"""Of a matrix."""
MAX_LETTERS = 64
"""Of a family."""
MAX_FAMILY = 1 << 30
"""Bits of all entries of a family over their common denominator, at least."""
MAX_INDEX = 10_000
"""A coordinate of an index in Z^s."""
MAX_DIMENSION = 4
MAX_VERTICES = 20_000
"""Of a polytope, without reflections."""
MAX_ENTRY = 10**12
"""A member of a flat list: its numbers are numerators of weights, vertices and letters."""
MAX_COORDINATE = 40
"""Decimal digits of a coordinate."""
MAX_DEGREE = 200
"""Of the polynomial of a root."""

_RANGES = {
    "natural": (0, MAX_NATURAL),
    "length": (1, 1000),
    "integer": (-MAX_INTEGER, MAX_INTEGER),
    "sign": (-1, 1),
    "bits": (0, 4096),
    "weight_bits": (0, 39),
    "vertex": (0, 4 * MAX_VERTICES - 1),
    "work": (0, 10**9),
}
_OBJECTS: Mapping[str, Fields] = {
    "leader": {
        "word": "natural[]",
        "reflected": "boolean",
        "column": "natural",
        "scale": "rational",
        "annihilator": "rational[]",
        "sign": "sign",
    },
    "complex_leader": {
        "word": "natural[]",
        "reflected": "boolean",
        "column": "natural",
        "scale": "rational",
        "annihilator": "rational[]",
        "factor": "root",
        "center": "rational[]",
        "distance": "rational",
    },
    "tie": {"vertex": "vertex", "letter": "natural", "weights": "share[]"},
    "share": {"vertex": "vertex", "weight": "element"},
}
_LENGTHS = {"vertices[]": MAX_VERTICES, "tie[]": MAX_VERTICES, "flat[]": MAX_VERTICES * MAX_ORDER}
"""Of lists that may have more members than others."""
_SHORT = 40
"""Characters of a number that is kept once it is read."""
_RATIONAL = re.compile(r"-?([0-9]+)(?:/([0-9]+))?")
_DIGITS = re.compile(r"0|-?[1-9][0-9]*")


class Rejected(Exception):  # noqa: N818 (an answer, not an error)
    """Why a certificate does not verify."""


class Exhausted(Rejected):
    """It asks more than the checker does: true or not, it is not looked at to the end."""


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


class _UnreadableError(Exception):
    """A value that is not as specified; the places on the way out to it, innermost first, and what is wrong there."""

    def __init__(self, why: str, place: str = "") -> None:
        self.why, self.place = why, place


def _demand(condition: bool, why: str) -> None:
    if not condition:
        raise _UnreadableError(why)


def read_object(value: object, fields: Fields, what: str) -> dict[str, Any]:
    """The values of an object that has exactly these keys."""
    try:
        return _object_of(value, fields)
    except _UnreadableError as error:
        raise Rejected(f"{error.place}{what} {error.why}") from None


def read(kind: str, value: object, what: str) -> Any:
    """A value of one of the kinds below; a kind that ends in [] is a list."""
    try:
        return _reader(kind)(value)
    except _UnreadableError as error:
        raise Rejected(f"{error.place}{what} {error.why}") from None


def _object_of(value: object, fields: Fields) -> dict[str, Any]:
    if type(value) is not dict:
        raise _UnreadableError("is not an object")
    if value.keys() != fields.keys():
        for key in value:
            _demand(key in fields, f"has the unknown key {shown(key)}")
        raise _UnreadableError(f"has no key '{min(fields.keys() - value.keys())}'")
    result = dict(value)
    try:
        for key, kind in fields.items():
            if kind != "any":
                result[key] = _reader(kind)(value[key])
    except _UnreadableError as error:
        raise _UnreadableError(error.why, f"{error.place}'{key}' of ") from None
    return result


@cache
def _reader(kind: str) -> Callable[[Any], Any]:
    if (reader := _READERS.get(kind)) is not None:
        return reader
    if kind in _RANGES:
        return partial(_integer, *_RANGES[kind])
    if kind in _OBJECTS:
        return partial(_object_of, fields=_OBJECTS[kind])
    return partial(_members, _reader(kind.removesuffix("[]")), _LENGTHS.get(kind, MAX_LENGTH))


def _members(reader: Callable[[Any], Any], most: int, value: object, of: str = "a member of ") -> tuple[Any, ...]:
    members = _list(value, most)
    try:
        return tuple(map(reader, members))
    except _UnreadableError as error:
        raise _UnreadableError(error.why, error.place + of) from None


def _list(value: object, most: int) -> list[Any]:
    if type(value) is not list:
        raise _UnreadableError("is not a list")
    _demand(len(value) <= most, "is too long")
    return value


def _integer(least: int, greatest: int, value: object) -> int:
    if type(value) is not int:
        raise _UnreadableError("is not an integer")
    _demand(least <= value <= greatest, "is out of range")
    return value


def _boolean(value: object) -> bool:
    if type(value) is not bool:
        raise _UnreadableError("is not a boolean")
    return value


def _fraction(value: object) -> Fraction:
    if type(value) is str and len(value) <= _SHORT:
        return _short_fraction(value)
    return Fraction(*_ratio(value))


def _polynomial(value: object) -> Polynomial:
    fields = _object_of(value, {"start": "integer", "coefficients": "any"})
    pairs = _members(_rational, MAX_LENGTH, fields["coefficients"], "a coefficient of ")
    f = over_common_denominator(fields["start"], pairs, most_bits=MAX_DIGITS * 10 // 3)
    if f is None:
        raise _UnreadableError("has a common denominator that is too large")
    return f


def _family(value: object) -> Family:
    """Square matrices of one order, rows of rationals, over one common denominator."""
    matrices = _members(_rows, MAX_LETTERS, value, "a matrix of ")
    _demand(len(matrices) > 0, "is empty")
    order, common = len(matrices[0]), 1
    _demand(all(len(rows) == order for rows in matrices), "has matrices of two orders")
    for rows in matrices:
        for row in rows:
            for _, q in row:
                common = lcm(common, q)
                _demand(common.bit_length() <= MAX_DIGITS * 10 // 3, "has a common denominator that is too large")
    _demand(len(matrices) * order**2 * common.bit_length() <= MAX_FAMILY, "has a common denominator that is too large")
    return family([[[p * (common // q) for p, q in row] for row in rows] for rows in matrices], common)


def _rows(value: object) -> tuple[tuple[tuple[int, int], ...], ...]:
    rows = _members(partial(_members, _rational, MAX_ORDER, of="an entry of "), MAX_ORDER, value, "a row of ")
    _demand(len(rows) > 0, "is empty")
    _demand(all(len(row) == len(rows) for row in rows), "has a row of another length")
    return rows


def _matrix(value: object) -> Family:
    return _family([value])


def _root(value: object) -> tuple[int, ...]:
    """The coefficients of an integer polynomial, the constant one first."""
    return _members(partial(_digits, MAX_DIGITS), MAX_DEGREE + 1, value)


def _element(value: object) -> tuple[Fraction, ...]:
    """A number, or a polynomial in Λ, the constant first."""
    return _members(_fraction, MAX_DEGREE, value) if type(value) is list else (_fraction(value),)


def _coordinates(value: object) -> tuple[int, ...]:
    return _members(partial(_digits, MAX_COORDINATE), MAX_ORDER, value)


def _index(value: object) -> tuple[int, ...]:
    """Of Z^s; which s, the rule knows."""
    return _members(partial(_integer, -MAX_INDEX, MAX_INDEX), MAX_DIMENSION, value, "a coordinate of ")


def _term(value: object) -> tuple[tuple[int, ...], Fraction]:
    pair = _list(value, 2)
    _demand(len(pair) == 2, "is not a pair of an index and a coefficient")
    return _index(pair[0]), _fraction(pair[1])


def _terms(value: object) -> tuple[tuple[tuple[int, ...], Fraction], ...]:
    """Pairs of an index and its coefficient, not zero, in lexicographic order: in one way only."""
    terms = _members(_term, MAX_LENGTH, value, "a term of ")
    _demand(len(terms) > 0, "is empty")
    _demand(all(coefficient for _, coefficient in terms), "has a coefficient that is zero")
    _demand(all(x < y for (x, _), (y, _) in pairwise(terms)), "has indices that do not increase")
    common = 1
    for _, coefficient in terms:
        common = lcm(common, coefficient.denominator)
        _demand(common.bit_length() <= MAX_DIGITS * 10 // 3, "has a common denominator that is too large")
    return terms


def _digits(most: int, value: object) -> int:
    """`"n"`, an integer without leading zeros."""
    if type(value) is not str:
        raise _UnreadableError("is not a string of digits")
    _demand(len(value) <= most + 1, "has too many digits")
    digits = value.lstrip("-")
    _demand(len(digits) <= most and _DIGITS.fullmatch(value) is not None, f"is not an integer: {shown(value)}")
    return -_decimal(digits) if value[0] == "-" else _decimal(digits)


def _flat(value: object) -> list[int]:
    """Integers in a row whose meaning their rule knows."""
    members: list[int] = _list(value, 2 * MAX_VERTICES)
    _demand(set(map(type, members)) <= {int}, "has a member that is not an integer")
    _demand(not members or -MAX_ENTRY <= min(members) <= max(members) <= MAX_ENTRY, "has a member that is too large")
    return members


def _rational(value: object) -> tuple[int, int]:
    """`"p/q"` or `"p"` in lowest terms as (p, q), q > 0."""
    if type(value) is str and len(value) <= _SHORT:
        return _short_ratio(value)
    return _ratio(value)


def _ratio(value: object) -> tuple[int, int]:
    if type(value) is not str:
        raise _UnreadableError('is not a string "p/q"')
    _demand(len(value) <= 2 * MAX_DIGITS + 2, "has too many digits")
    match = _RATIONAL.fullmatch(value)
    if match is None:
        raise _UnreadableError(f"is not a rational: {shown(value)}")
    digits, below = match[1], match[2] or "1"
    _demand(max(len(digits), len(below)) <= MAX_DIGITS, "has too many digits")
    p, q = _decimal(digits), _decimal(below)
    canonical = (digits[0] != "0" or value == "0") and below[0] != "0" and match[2] != "1" and gcd(p, q) == 1
    _demand(canonical, "is not in lowest terms")
    return (-p if value[0] == "-" else p), q


_short_ratio = lru_cache(4096)(_ratio)
"""Short numbers come again and again."""
_short_fraction = lru_cache(4096)(lambda text: Fraction(*_ratio(text)))


def _decimal(digits: str) -> int:
    """In pieces, because Python refuses to read long integers at once."""
    value = 0
    for i in range(0, len(digits), 600):
        piece = digits[i : i + 600]
        value = value * 10 ** len(piece) + int(piece)
    return value


_READERS: Mapping[str, Callable[[Any], Any]] = {
    "any": lambda value: value,
    "boolean": _boolean,
    "rational": _fraction,
    "polynomial": _polynomial,
    "family": _family,
    "matrix": _matrix,
    "element": _element,
    "root": _root,
    "vertices": _coordinates,
    "flat": _flat,
    "index": _index,
    "terms": _terms,
}


def _object(pairs: list[tuple[str, object]]) -> dict[str, object]:
    result = dict(pairs)
    require(len(result) == len(pairs), "an object has a key twice")
    return result


def _small(digits: str) -> int:
    require(len(digits.lstrip("-")) <= 12 and digits != "-0", "an integer is too long")
    return int(digits)


def _no_float(digits: str) -> int:
    raise Rejected(f"{shown(digits)} is not an exact number")
