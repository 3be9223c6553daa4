"""The mask of a plain mask file, read with the standard library alone: literal numbers and nothing to expand."""

from __future__ import annotations

import json
import re
import tomllib
from fractions import Fraction
from typing import NamedTuple

_LITERAL = re.compile(r"[+-]?[0-9]{1,1000}(/[0-9]{1,1000}|\.[0-9]{1,1000})?")


class Mask(NamedTuple):
    """A scalar mask without zeros at its ends: two of them are equal iff they are the same mask."""

    arity: int
    start: int
    coefficients: tuple[Fraction, ...]


def mask(arity: int, start: int, coefficients: list[Fraction]) -> Mask:
    support = [i for i, c in enumerate(coefficients) if c] or [0]
    return Mask(arity, start + support[0], tuple(coefficients[support[0] : support[-1] + 1]))


def plain_mask(text: str) -> Mask | None:
    """The mask of a file whose coefficients are literal numbers: 3, 0.25, "-1/16".

    None for every other file, readable or not: it has parameters in use, a symbol, another kind, or a mistake.
    """
    try:
        document = tomllib.loads(text, parse_float=str)
    except (ValueError, RecursionError):
        return None
    table = document.get("mask")
    if document.get("kind", "scalar") != "scalar" or type(table) is not dict:
        return None
    if not {"start", "coefficients"} <= table.keys() <= {"arity", "start", "coefficients"}:
        return None
    arity, start, entries = table.get("arity", 2), table["start"], table["coefficients"]
    if type(arity) is not int or type(start) is not int or type(entries) is not list or not entries:
        return None
    if not all(type(x) is int or (type(x) is str and _LITERAL.fullmatch(x)) for x in entries):
        return None
    try:
        return mask(arity, start, [Fraction(x) for x in entries])
    except ZeroDivisionError:
        return None


def certified_mask(text: str) -> Mask:
    """The mask that a verified certificate is about, from its text."""
    about = json.loads(text)["mask"]
    return mask(about["arity"], about["start"], [Fraction(c) for c in about["coefficients"]])
