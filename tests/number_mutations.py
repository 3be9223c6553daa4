"""Certificates with one number changed: the places of numbers in a claim, and other numbers for them."""

import re
from fractions import Fraction


def places(value, path=()):
    """The paths of all numbers and booleans in a claim, numbers as text too, without those in certificates inside."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key != "certificate":
                yield from places(inner, (*path, key))
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from places(inner, (*path, i))
    elif isinstance(value, bool | int) or (isinstance(value, str) and re.fullmatch(r"-?\d+(/\d+)?", value)):
        yield path


def changed(value):
    """Other values for a number or a boolean."""
    if isinstance(value, bool):
        return [not value]
    if isinstance(value, int):
        return [value + 1, value - 1]
    x = Fraction(value)
    return [str(x + 1), str(-x) if x else "1/2"]


def at(value, place):
    """What stands at a place."""
    for key in place:
        value = value[key]
    return value


def put(value, place, new):
    """Put another thing there."""
    at(value, place[:-1])[place[-1]] = new
