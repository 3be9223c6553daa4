"""Quantities on the command line: how much work, how long, how close."""

from __future__ import annotations

import math
import re
from fractions import Fraction

import click


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
