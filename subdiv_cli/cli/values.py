"""Quantities on the command line: how much work, how long, how close, in how many processes, which part."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable
from contextlib import suppress
from fractions import Fraction
from typing import TypeVar

import click

T = TypeVar("T")

MOST_JOBS = 1024
MOST_SHARDS = 1_000_000


class Quantity(click.ParamType[T]):
    """A type of values that are parsed from their spelling, or refused with a message."""

    def __init__(self, name: str, parse: Callable[[str], T | None], wanted: str) -> None:
        self.name, self._parse, self._wanted = name, parse, wanted

    def convert(self, value: str | T, param: click.Parameter | None, ctx: click.Context | None) -> T:
        """The parsed value; a number out of a file of settings is parsed as it would be spelled."""
        if not isinstance(value, str | int | float):
            return value
        if (parsed := self._parse(str(value))) is None:
            self.fail(f"{value!r} is {self._wanted}", param, ctx)
        return parsed


def _whole(text: str) -> int | None:
    """The positive whole number that a text spells, else None."""
    number = int(text) if re.fullmatch(r"\s*\+?[0-9]{1,18}\s*", text) else 0
    return number if number > 0 else None


def _index(text: str) -> tuple[int, ...] | None:
    """The index of a mask that a text spells: an integer, or one for each variable, -1,-1; else None."""
    spelled = re.fullmatch(r"\s*[+-]?[0-9]{1,9}\s*(,\s*[+-]?[0-9]{1,9}\s*){0,3}", text)
    return tuple(map(int, text.split(","))) if spelled else None


def _seconds(text: str) -> float | None:
    """The positive, finite number of seconds that a text spells, else None."""
    with suppress(ValueError):
        if (number := float(text)) > 0 and math.isfinite(number):
            return number
    return None


def _tolerance(text: str) -> Fraction | None:
    """The positive number that a text spells, exactly: 1e-3, 0.001, 1/1000; else None."""
    spelled = re.fullmatch(r"[0-9]{1,50}(/[0-9]{1,50}|(\.[0-9]{1,50})?([eE][+-]?[0-9]{1,3})?)", text)
    number = Fraction(text) if spelled and not re.search(r"/0+$", text) else Fraction(0)
    return number if number > 0 else None


def _spacing(text: str) -> tuple[Fraction, Fraction] | None:
    """The pair of positive numbers that `a,b` spells, exactly; else None."""
    left, _, right = (_tolerance(part.strip()) for part in text.partition(","))
    return None if left is None or right is None else (left, right)


def _jobs(text: str) -> int | None:
    """The positive whole number that a text spells; `auto` is the cores that this process may use; else None."""
    if text == "auto":
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    number = _whole(text)
    return None if number is None or number > MOST_JOBS else number


def _shard(text: str) -> tuple[int, int] | None:
    """The pair (i, n) that `i/n` spells, 1 <= i <= n; else None."""
    index, _, count = text.partition("/")
    i, n = _whole(index) or 0, _whole(count) or 0
    return (i, n) if 1 <= i <= n <= MOST_SHARDS else None


WHOLE = Quantity("number", _whole, "not a positive whole number")
INDEX = Quantity("index", _index, "not an index: an integer, or in several variables -1,-1")
SECONDS = Quantity("seconds", _seconds, "not a positive number of seconds")
TOLERANCE = Quantity("tolerance", _tolerance, "not a positive number; write 1e-3 or 1/1000")
SPACING = Quantity("a,b", _spacing, "not two positive numbers: write 1,2 or 1,1/2")
JOBS = Quantity("number", _jobs, f"neither auto nor a number from 1 to {MOST_JOBS}")
SHARD = Quantity("i/n", _shard, "no part: write 1/4, 2/4, …")
