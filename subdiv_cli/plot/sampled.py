"""Lines to be drawn: exact values made into doubles, each the nearest one."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.model.blocks import Curve, Polygon


class Line(NamedTuple):
    """A polygon in the plane, with its name."""

    label: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    polygon: bool = False
    """Whether it is a control polygon, whose vertices are drawn as well."""


class Panel(NamedTuple):
    """The lines on one pair of axes."""

    title: str
    lines: tuple[Line, ...]
    plane: bool = False
    """Whether it is about curves in the plane: both axes with the same unit."""


def graph(curve: Curve, label: str) -> Line:
    """The graph of a function on its support: 0 at the ends, the values between."""
    unit = Fraction(1, curve.arity**curve.level)
    first, last = curve.support
    points = [(float(first), 0.0)] if first < curve.start * unit else []
    points += [(float((curve.start + i) * unit), float(y)) for i, y in enumerate(curve.values)]
    if last > (curve.start + len(curve.values) - 1) * unit:
        points.append((float(last), 0.0))
    return line(label, points)


def line(label: str, points: Sequence[tuple[float, float]], *, polygon: bool = False) -> Line:
    """The line through these points, with its name."""
    return Line(label, tuple(x for x, _ in points), tuple(y for _, y in points), polygon)


def plane(polygon: Polygon, label: str) -> Line:
    """The line of a polygon, a control polygon under its own name; a closed one returns to its first vertex."""
    points = [(float(u), float(v)) for u, v in zip(polygon.x, polygon.y, strict=True)]
    points += points[:1] if polygon.closed else []
    return line(polygon.control or label, points, polygon=polygon.control is not None)
