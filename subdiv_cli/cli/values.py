"""Quantities on the command line: how much work, how long, how close, in how many processes, which part."""

from __future__ import annotations

import math
import os
import re
from fractions import Fraction

import click

MOST_JOBS = 1024
MOST_SHARDS = 1_000_000


class WholeType(click.ParamType[int]):
    """A positive whole number."""

    name = "number"

    def convert(self, value: str | int, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """Parse."""
        try:
            number = int(value)
        except ValueError:
            number = 0
        if number < 1:
            self.fail(f"{value!r} is not a positive whole number", param, ctx)
        return number


class IndexType(click.ParamType[tuple[int, ...]]):
    """An index of a mask: an integer, or one for each variable, -1,-1."""

    name = "index"

    _SPELLING = re.compile(r"\s*[+-]?[0-9]{1,9}\s*(,\s*[+-]?[0-9]{1,9}\s*){0,3}")

    def convert(
        self, value: str | tuple[int, ...], param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[int, ...]:
        """Parse."""
        if isinstance(value, tuple):
            return value
        if not self._SPELLING.fullmatch(value):
            self.fail(f"{value!r} is not an index: an integer, or in several variables -1,-1", param, ctx)
        return tuple(map(int, value.split(",")))


class SecondsType(click.ParamType[float]):
    """A positive, finite number of seconds."""

    name = "seconds"

    def convert(self, value: str | float, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Parse."""
        try:
            number = float(value)
        except ValueError:
            number = 0.0
        if not (number > 0 and math.isfinite(number)):
            self.fail(f"{value!r} is not a positive number of seconds", param, ctx)
        return number


class ToleranceType(click.ParamType[Fraction]):
    """A positive number, exactly as it is spelled: 1e-3, 0.001, 1/1000."""

    name = "tolerance"

    _SPELLING = re.compile(r"[0-9]{1,50}(/[0-9]{1,50}|(\.[0-9]{1,50})?([eE][+-]?[0-9]{1,3})?)")

    def convert(self, value: str | Fraction, param: click.Parameter | None, ctx: click.Context | None) -> Fraction:
        """Parse."""
        if isinstance(value, Fraction):
            return value
        number = Fraction(0)
        if self._SPELLING.fullmatch(value) and not re.search(r"/0+$", value):
            number = Fraction(value)
        if number <= 0:
            self.fail(f"{value!r} is not a positive number; write 1e-3 or 1/1000", param, ctx)
        return number


class JobsType(click.ParamType[int]):
    """A positive whole number, or `auto`: the cores that this process may use."""

    name = "number"

    def convert(self, value: str | int, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """Parse."""
        if value == "auto":
            return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
        try:
            number = int(value)
        except ValueError:
            number = 0
        if not 1 <= number <= MOST_JOBS:
            self.fail(f"{value!r} is neither auto nor a number from 1 to {MOST_JOBS}", param, ctx)
        return number


class ShardType(click.ParamType[tuple[int, int]]):
    """`i/n` with 1 <= i <= n."""

    name = "i/n"

    def convert(
        self, value: str | tuple[int, int], param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[int, int]:
        """Parse."""
        if isinstance(value, tuple):
            return value
        index, count = _whole(value.partition("/")[0]), _whole(value.partition("/")[2])
        if not 1 <= index <= count <= MOST_SHARDS:
            self.fail(f"{value!r} is no part: write 1/4, 2/4, …", param, ctx)
        return index, count


def _whole(text: str) -> int:
    """A number in plain digits; 0 for anything else."""
    return int(text) if text.isascii() and text.isdigit() and len(text) < 10 else 0
