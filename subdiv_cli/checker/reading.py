"""Strict reading: JSON text to integers, rationals, polynomials. Whatever is not exactly as specified is rejected."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
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
MAX_ORDER = 64
"""Of a matrix; as many letters has a family."""
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
_RATIONAL = re.compile(r"-?([0-9]+)(?:/([0-9]+))?")
_DIGITS = re.compile(r"0|-?[1-9][0-9]*")


class Rejected(Exception):  # noqa: N818 (an answer, not an error)
    """Why a certificate does not verify."""


class Exhausted(Rejected):
    """It asks more than the checker does: true or not, it is not looked at to the end."""


def require(condition: bool, why: str) -> None:
    if not condition:
        raise Rejected(why)


def require_few(condition: bool, why: str) -> None:
    """Of something that there may be only so much of."""
    if not condition:
        raise Exhausted(why)


def parse(text: str) -> object:
    """JSON without floats, constants, long integers and duplicate keys."""
    require_few(len(text) <= MAX_BYTES, "the file is too large")
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
    if kind in _OBJECTS:
        return read_object(value, _OBJECTS[kind], what)
    value = _list(value, _LENGTHS.get(kind, MAX_LENGTH), what)
    member, what = kind.removesuffix("[]"), f"a member of {what}"
    return tuple(read(member, x, what) for x in value)


def _list(value: object, most: int, what: str) -> list[Any]:
    if type(value) is not list:
        raise Rejected(f"{what} is not a list")
    require_few(len(value) <= most, f"{what} is too long")
    return value


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
    coefficients = _list(fields["coefficients"], MAX_LENGTH, f"the coefficients of {what}")
    coefficient = f"a coefficient of {what}"
    pairs = [_rational(c, coefficient) for c in coefficients]
    f = over_common_denominator(fields["start"], pairs, most_bits=MAX_DIGITS * 10 // 3)
    if f is None:
        raise Exhausted(f"the common denominator of {what} is too large")
    return f


def _family(value: object, what: str) -> Family:
    """Square matrices of one order, rows of rationals, over one common denominator."""
    matrices = _list(value, MAX_ORDER, what)
    require(len(matrices) > 0, f"{what} is empty")
    order = len(_list(matrices[0], MAX_ORDER, f"a matrix of {what}"))
    require(order > 0, f"a matrix of {what} is empty")
    pairs, common = [], 1
    for matrix in matrices:
        require(len(_list(matrix, MAX_ORDER, f"a matrix of {what}")) == order, f"{what} has matrices of two orders")
        for row in matrix:
            require(len(_list(row, MAX_ORDER, f"a row of {what}")) == order, f"{what} has a row of another length")
            pairs.append([_rational(x, f"an entry of {what}") for x in row])
            for _, q in pairs[-1]:
                common = lcm(common, q)
                require_few(
                    common.bit_length() <= MAX_DIGITS * 10 // 3, f"the common denominator of {what} is too large"
                )
    rows = [[p * (common // q) for p, q in row] for row in pairs]
    return family([rows[i : i + order] for i in range(0, len(rows), order)], common)


def _matrix(value: object, what: str) -> Family:
    return _family([value], what)


def _root(value: object, what: str) -> tuple[int, ...]:
    """The coefficients of an integer polynomial, the constant one first."""
    members = _list(value, MAX_DEGREE + 1, what)
    return tuple(_digits(c, MAX_DIGITS, f"a member of {what}") for c in members)


def _element(value: object, what: str) -> list[Fraction]:
    """A number, or a polynomial in Λ, the constant first."""
    if type(value) is not list:
        return [_fraction(value, what)]
    return [_fraction(x, f"a member of {what}") for x in _list(value, MAX_DEGREE, what)]


def _coordinates(value: object, what: str) -> list[int]:
    members = _list(value, MAX_ORDER, what)
    return [_digits(x, MAX_COORDINATE, f"a coordinate of {what}") for x in members]


def _digits(value: object, most: int, what: str) -> int:
    """`"n"`, an integer without leading zeros."""
    if type(value) is not str:
        raise Rejected(f"{what} is not a string of digits")
    require_few(len(value) <= most + 1, f"{what} has too many digits")
    digits = value.lstrip("-")
    require(len(digits) <= most and _DIGITS.fullmatch(value) is not None, f"{what} is not an integer: {shown(value)}")
    return -_decimal(digits) if value[0] == "-" else _decimal(digits)


def _flat(value: object, what: str) -> list[int]:
    """Integers in a row whose meaning their rule knows."""
    members: list[int] = _list(value, 2 * MAX_VERTICES, what)
    require(set(map(type, members)) <= {int}, f"a member of {what} is not an integer")
    require(not members or -MAX_ENTRY <= min(members) <= max(members) <= MAX_ENTRY, f"a member of {what} is too large")
    return members


def _rational(value: object, what: str) -> tuple[int, int]:
    """`"p/q"` or `"p"` in lowest terms as (p, q), q > 0."""
    if type(value) is not str:
        raise Rejected(f'{what} is not a string "p/q"')
    require_few(len(value) <= 2 * MAX_DIGITS + 2, f"{what} has too many digits")
    match = _RATIONAL.fullmatch(value)
    if match is None:
        raise Rejected(f"{what} is not a rational: {shown(value)}")
    digits, below = match[1], match[2] or "1"
    require_few(max(len(digits), len(below)) <= MAX_DIGITS, f"{what} has too many digits")
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
    "family": _family,
    "matrix": _matrix,
    "element": _element,
    "root": _root,
    "vertices": _coordinates,
    "flat": _flat,
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
