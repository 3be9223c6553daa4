"""The strict reading of JSON values as integers, rationals, polynomials. Whatever is not as specified is rejected."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache, partial
from itertools import pairwise
from math import lcm
from typing import Any

from subdiv_cli.checker.matrices import RationalFamily, family
from subdiv_cli.checker.numerals import (
    MAX_DIGITS,
    OversizedError,
    UnreadableError,
    demand,
    demand_few,
    fraction,
    long_integer,
    rational,
    shown,
)
from subdiv_cli.checker.polynomials import Polynomial, over_common_denominator

Reader = Callable[[Any], Any]
"""A function that returns what a JSON value means, or raises an UnreadableError."""
Fields = Mapping[str, str | Reader]
"""The keys of an object, all of them obligatory, and the readers of their values, given by name or as functions."""

MAX_BYTES = 64 << 20
MAX_LENGTH = 4_000
"""Coefficients of a polynomial, letters of a word, members of a list."""
MAX_INTEGER = 1_000_000
"""The size of a degree, or of a coefficient in a combination of columns."""
MAX_START = 4_000_000
"""The size of the first exponent of a polynomial: symbols stand up to two lengths beyond the mask."""
MAX_NATURAL = 10_000
"""The largest order, level, letter, number of a mask or of a claim."""
MAX_ORDER = 120
"""The largest order of a matrix."""
MAX_LETTERS = 64
"""The most matrices of a family."""
MAX_FAMILY = 1 << 30
"""Bits of all entries of a family over their common denominator, at least."""
MAX_INDEX = 1_000_000
"""A coordinate of an index in Z^s."""
MAX_DIMENSION = 4
MAX_VERTICES = 20_000
"""The most vertices of a polytope, without reflections."""
MAX_ENTRY = 10**12
"""The largest member of a flat list: its numbers are numerators of weights, vertices and letters."""
MAX_DEGREE = 200
"""The largest degree of the polynomial of a root."""

_RANGES = {
    "natural": (0, MAX_NATURAL),
    "length": (1, 1000),
    "integer": (-MAX_INTEGER, MAX_INTEGER),
    "start": (-MAX_START, MAX_START),
    "sign": (-1, 1),
    "bits": (0, 4096),
    "weight_bits": (0, 39),
    "vertex": (0, 4 * MAX_VERTICES - 1),
    "work": (0, 10**9),
}


class Rejected(Exception):  # noqa: N818 (an answer, not an error)
    """Raised where a certificate does not verify; the message says why."""


class Exhausted(Rejected):
    """Raised where a certificate needs more work than the checker does: true or not, it is not read to the end."""


def require(condition: bool, why: str) -> None:
    """Raise Rejected, with this reason, unless the condition holds."""
    if not condition:
        raise Rejected(why)


def require_few(condition: bool, why: str) -> None:
    """Raise Exhausted, with this reason, unless the condition holds: there may be only so much of something."""
    if not condition:
        raise Exhausted(why)


def read_object(value: object, fields: Fields, what: str) -> dict[str, Any]:
    """The values of an object that has exactly these keys. Raises Rejected for any other value."""
    try:
        return _object_of(value, fields)
    except UnreadableError as error:
        raise _refusal(error, what) from None


def read(kind: str, value: object, what: str) -> Any:
    """The value read by one of the readers below. Raises Rejected where it is not as specified."""
    try:
        return reader(kind)(value)
    except UnreadableError as error:
        raise _refusal(error, what) from None


def _refusal(error: UnreadableError, what: str) -> Rejected:
    return (Exhausted if isinstance(error, OversizedError) else Rejected)(f"{error.place}{what} {error.why}")


def _object_of(value: object, fields: Fields) -> dict[str, Any]:
    if type(value) is not dict:
        raise UnreadableError("is not an object")
    if value.keys() != fields.keys():
        for key in value:
            demand(key in fields, f"has the unknown key {shown(key)}")
        raise UnreadableError(f"has no key '{min(fields.keys() - value.keys())}'")
    result = dict(value)
    try:
        for key, kind in fields.items():
            if kind != "any":
                result[key] = reader(kind)(value[key])
    except UnreadableError as error:
        raise error.within(f"'{key}' of ") from None
    return result


def record(fields: Fields) -> Reader:
    """A reader of an object that has exactly these keys."""
    return partial(_object_of, fields=fields)


def several(kind: str | Reader, most: int = MAX_LENGTH) -> Reader:
    """A reader of a list of no more than so many members."""
    return partial(_members, reader(kind), most)


@cache
def reader(kind: str | Reader) -> Reader:
    """The reader of this name; one that ends in [] reads a list."""
    if not isinstance(kind, str):
        return kind
    if kind in _RANGES:
        return partial(_integer, *_RANGES[kind])
    if kind.endswith("[]") and kind not in _READERS:
        return several(kind.removesuffix("[]"))
    return _READERS[kind]


def _members(read_member: Reader, most: int, value: object, of: str = "a member of ") -> tuple[Any, ...]:
    members = _list(value, most)
    try:
        return tuple(map(read_member, members))
    except UnreadableError as error:
        raise error.within(of) from None


def _list(value: object, most: int) -> list[Any]:
    if type(value) is not list:
        raise UnreadableError("is not a list")
    demand_few(len(value) <= most, "is too long")
    return value


def _integer(least: int, greatest: int, value: object) -> int:
    if type(value) is not int:
        raise UnreadableError("is not an integer")
    demand(least <= value <= greatest, "is out of range")
    return value


def _boolean(value: object) -> bool:
    if type(value) is not bool:
        raise UnreadableError("is not a boolean")
    return value


def _polynomial(value: object) -> Polynomial:
    fields = _object_of(value, {"start": "start", "coefficients": "any"})
    pairs = _members(rational, MAX_LENGTH, fields["coefficients"], "a coefficient of ")
    f = over_common_denominator(fields["start"], pairs, most_bits=MAX_DIGITS * 10 // 3)
    if f is None:
        raise OversizedError("has a common denominator that is too large")
    return f


def _family(value: object) -> RationalFamily:
    """Square matrices of one order, rows of rationals, over one common denominator."""
    matrices = _members(_rows, MAX_LETTERS, value, "a matrix of ")
    demand(len(matrices) > 0, "is empty")
    order, common = len(matrices[0]), 1
    demand(all(len(rows) == order for rows in matrices), "has matrices of two orders")
    for rows in matrices:
        for row in rows:
            for _, q in row:
                common = lcm(common, q)
                demand_few(common.bit_length() <= MAX_DIGITS * 10 // 3, "has a common denominator that is too large")
    bits = len(matrices) * order**2 * common.bit_length()
    demand_few(bits <= MAX_FAMILY, "has a common denominator that is too large")
    return family([[[p * (common // q) for p, q in row] for row in rows] for rows in matrices], common)


def _rows(value: object) -> tuple[tuple[tuple[int, int], ...], ...]:
    rows = _members(partial(_members, rational, MAX_ORDER, of="an entry of "), MAX_ORDER, value, "a row of ")
    demand(len(rows) > 0, "is empty")
    demand(all(len(row) == len(rows) for row in rows), "has a row of another length")
    return rows


def _matrix(value: object) -> RationalFamily:
    return _family([value])


def _root(value: object) -> tuple[int, ...]:
    """The coefficients of an integer polynomial, the constant one first."""
    return _members(partial(long_integer, MAX_DIGITS), MAX_DEGREE + 1, value)


def _index(value: object) -> tuple[int, ...]:
    """An index of Z^s; the rule knows which s."""
    return _members(partial(_integer, -MAX_INDEX, MAX_INDEX), MAX_DIMENSION, value, "a coordinate of ")


def _term(value: object) -> tuple[tuple[int, ...], Fraction]:
    pair = _list(value, 2)
    demand(len(pair) == 2, "is not a pair of an index and a coefficient")
    return _index(pair[0]), fraction(pair[1])


def _terms(value: object) -> tuple[tuple[tuple[int, ...], Fraction], ...]:
    """The pairs of an index and its coefficient, not zero, in lexicographic order: in one way only."""
    terms = _members(_term, MAX_LENGTH, value, "a term of ")
    demand(len(terms) > 0, "is empty")
    demand(all(coefficient for _, coefficient in terms), "has a coefficient that is zero")
    demand(all(x < y for (x, _), (y, _) in pairwise(terms)), "has indices that do not increase")
    common = 1
    for _, coefficient in terms:
        common = lcm(common, coefficient.denominator)
        demand_few(common.bit_length() <= MAX_DIGITS * 10 // 3, "has a common denominator that is too large")
    return terms


def _flat(value: object) -> list[int]:
    """A list of integers whose meaning their rule knows."""
    members: list[int] = _list(value, 2 * MAX_VERTICES)
    demand(set(map(type, members)) <= {int}, "has a member that is not an integer")
    demand(not members or -MAX_ENTRY <= min(members) <= max(members) <= MAX_ENTRY, "has a member that is too large")
    return members


_READERS: Mapping[str, Reader] = {
    "any": lambda value: value,
    "boolean": _boolean,
    "rational": fraction,
    "polynomial": _polynomial,
    "family": _family,
    "matrix": _matrix,
    "root": _root,
    "flat": _flat,
    "flat[]": several(_flat, MAX_VERTICES * MAX_ORDER),
    "index": _index,
    "term": _term,
    "terms": _terms,
}
