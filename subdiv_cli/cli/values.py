"""Quantities on the command line: how much work, how long."""

from __future__ import annotations

import math

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
