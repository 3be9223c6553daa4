"""The mask of a plain mask file, read with the standard library alone: literal numbers and nothing to expand."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

_LITERAL = re.compile(r"[+-]?[0-9]{1,1000}(/[0-9]{1,1000}|\.[0-9]{1,1000})?")
_INDEX = re.compile(r"(0|-?[1-9][0-9]{0,8})(,(0|-?[1-9][0-9]{0,8})){1,3}")
_MAX_DEPTH = 4
"""Of nested coefficients: a mask has no more variables."""

Index = tuple[int, ...]


class Mask(NamedTuple):
    """A scalar mask without zeros at its ends: two of them are equal iff they are the same mask."""

    arity: int
    start: int
    coefficients: tuple[Fraction, ...]


class LatticeMask(NamedTuple):
    """A mask on Z^s, sorted and without zeros: two of them are equal iff they are the same mask."""

    dilation: tuple[Index, ...]
    terms: tuple[tuple[Index, Fraction], ...]


def mask(arity: int, start: int, coefficients: list[Fraction]) -> Mask:
    support = [i for i, c in enumerate(coefficients) if c] or [0]
    return Mask(arity, start + support[0], tuple(coefficients[support[0] : support[-1] + 1]))


def plain_mask(text: str) -> Mask | LatticeMask | None:
    """The mask of a file whose coefficients are literal numbers: 3, 0.25, "-1/16".

    None for every other file, readable or not: it has parameters in use, a symbol, another kind, or a mistake.
    """
    try:
        document = tomllib.loads(text, parse_float=str)
        table, kind = document.get("mask"), document.get("kind", "scalar")
        if type(table) is not dict:
            return None
        return _scalar(table) if kind == "scalar" else _lattice(table) if kind == "multivariate" else None
    except (ValueError, ZeroDivisionError, RecursionError):
        return None


def mask_of(about: Mapping[str, Any]) -> Mask | LatticeMask | None:
    """The mask of a certificate, from what stands there under `mask`; None for a family of matrices."""
    if about["kind"] == "scalar":
        return mask(about["arity"], about["start"], [Fraction(c) for c in about["coefficients"]])
    if about["kind"] == "multivariate":
        terms = tuple((tuple(index), Fraction(c)) for index, c in about["terms"])
        return LatticeMask(tuple(map(tuple, about["dilation"])), terms)
    return None


def certified_mask(text: str) -> Mask | LatticeMask | None:
    """The mask that a verified certificate is about, from its text."""
    return mask_of(json.loads(text)["mask"])


def _scalar(table: Mapping[str, Any]) -> Mask | None:
    if not {"start", "coefficients"} <= table.keys() <= {"arity", "start", "coefficients"}:
        return None
    arity, start, entries = table.get("arity", 2), table["start"], table["coefficients"]
    if type(arity) is not int or type(start) is not int or type(entries) is not list or not entries:
        return None
    return mask(arity, start, [_number(x) for x in entries])


def _lattice(table: Mapping[str, Any]) -> LatticeMask | None:
    """`terms = {"0,1" = 1}`, or `start` and `coefficients` nested as deep as there are variables."""
    keys = table.keys() - {"dilation"}
    if keys == {"terms"} and type(table["terms"]) is dict:
        if not all(_INDEX.fullmatch(key) for key in table["terms"]):
            return None
        terms = {tuple(map(int, key.split(","))): _number(x) for key, x in table["terms"].items()}
    elif keys == {"start", "coefficients"} and _is_index(table["start"]):
        terms = dict(_entries(table["coefficients"], tuple(table["start"])))
    else:
        return None
    s = len(next(iter(terms), ()))
    dilation = table.get("dilation", 2)
    if type(dilation) is int:
        dilation = [[dilation if i == j else 0 for j in range(s)] for i in range(s)]
    square = type(dilation) is list and len(dilation) == s >= 2 and all(_is_index(x) and len(x) == s for x in dilation)
    if not square or any(len(index) != s for index in terms):
        return None
    return LatticeMask(tuple(map(tuple, dilation)), tuple(sorted((x, c) for x, c in terms.items() if c)))


def _is_index(value: object) -> bool:
    return type(value) is list and 2 <= len(value) <= _MAX_DEPTH and all(type(i) is int for i in value)


def _entries(nested: object, start: Index) -> Iterator[tuple[Index, Fraction]]:
    """a_(start + (i, j, …)) = nested[i][j]…; ValueError where lists side by side are not of one length."""
    if not start:
        yield (), _number(nested)
        return
    if type(nested) is not list or not nested:
        raise ValueError("not nested as deep as there are variables")
    if len(start) > 1 and len({len(member) if type(member) is list else -1 for member in nested}) != 1:
        raise ValueError("lists of different lengths")
    for i, member in enumerate(nested, start[0]):
        for rest, value in _entries(member, start[1:]):
            yield (i, *rest), value


def _number(x: object) -> Fraction:
    """ValueError for what is no literal number."""
    if type(x) is int or (type(x) is str and _LITERAL.fullmatch(x)):
        return Fraction(x)
    raise ValueError("no literal number")
