"""The picture of a sweep: exponents and norms over the parameter, each with its certified band."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from subdiv_cli.model import Interval
from subdiv_cli.model.formulas import product
from subdiv_cli.model.sweep import Column, Row, Sweep, changes, enclosed
from subdiv_cli.plot.figure import saved

_SIZE = (8.0, 3.6)
_MOST_LABELS = 12
"""The most changes of the product that are labelled; more would stand upon each other."""
_LETTERS = {"holder": "α", "sobolev": "s"}


class Point(NamedTuple):
    """The number at one value of the parameter: bounds, nan where there is none, and whether they are one number."""

    x: float
    lower: float
    upper: float
    exact: bool


class Band(NamedTuple):
    """A column over the parameter, and where the maximizing product changes."""

    title: str
    points: tuple[Point, ...]
    """Points by rising x."""
    marks: tuple[tuple[float, float, str], ...] = ()
    """Between which values of the parameter the product changes, and into what."""


def picture(sweep: Sweep, form: str) -> bytes:
    """The bytes of a panel for each exponent and norm, one below another. `form` is svg, png or pdf.

    Raises MissingExtraError without matplotlib.
    """
    drawn = list(bands(sweep))

    def paint(figure: Any) -> None:
        for place, band in enumerate(drawn, 1):
            axes = figure.add_subplot(len(drawn), 1, place)
            _paint(axes, band)
            axes.set_xlabel(sweep.parameter)

    return saved(paint, (_SIZE[0], _SIZE[1] * len(drawn)), form)


def is_drawn(column: Column) -> bool:
    """Whether a column has numbers to be drawn: exponents or norms."""
    return column.about is None or column.about.form == "exponent"


def bands(sweep: Sweep) -> Iterator[Band]:
    """The bands of all columns that are drawn; the changes of the product belong to Hölder exponents."""
    rows = sorted(sweep.rows, key=lambda row: row.value)
    for column in filter(is_drawn, sweep.columns):
        points = tuple(point for row in rows if (point := _point(row, column)) is not None)
        marks = tuple(_marks(rows)) if column.name == "holder" else ()
        yield Band(f"{_LETTERS.get(column.name, column.title)} — {sweep.title}", points, marks)


def _point(row: Row, column: Column) -> Point | None:
    """The point of a row; None where the parameter is beyond all doubles."""
    x = enclosed(row.value)
    if x.lower is None:
        return None
    if column.about is None:
        norm = row.norms.get(column.name)
        known = Interval() if norm is None else enclosed(norm)
        return Point(x.lower, *_ends(known.lower, known.upper), exact=norm is not None)
    exponent = getattr(row.result, column.name)
    if exponent is None:
        return Point(x.lower, math.nan, math.nan, exact=False)
    return Point(x.lower, *_ends(exponent.lower, exponent.upper), exact=exponent.exact is not None)


def _ends(lower: float | None, upper: float | None) -> tuple[float, float]:
    """The bounds as they are drawn: nan for none, or an infinite one."""
    return tuple(math.nan if x is None or math.isinf(x) else x for x in (lower, upper))  # type: ignore[return-value]


def _marks(rows: Sequence[Row]) -> Iterator[tuple[float, float, str]]:
    for row, other in changes(rows):
        low, high = enclosed(row.value).lower, enclosed(other.value).lower
        if low is not None and high is not None and row.product and other.product:
            yield low, high, f"{product(row.product, 'T')} → {product(other.product, 'T')}"


def _paint(axes: Any, band: Band) -> None:
    x = [point.x for point in band.points]
    lower, upper = [point.lower for point in band.points], [point.upper for point in band.points]
    enclosed_only = [point for point in band.points if not point.exact and not math.isnan(point.lower + point.upper)]
    filled = axes.fill_between(x, lower, upper, alpha=0.3, label="lower to upper bound" if enclosed_only else None)
    filled.set_gid("band")
    exact = [point.lower if point.exact else math.nan for point in band.points]
    (line,) = axes.plot(x, exact, "o-", color="C0", linewidth=0.7, markersize=2.5, label="exact")
    line.set_gid("exact")
    for bound, marker in (("lower", "^"), ("upper", "v")):
        ends = [(p.x, y) for p in band.points if not p.exact and not math.isnan(y := getattr(p, bound))]
        if ends:
            axes.plot(*zip(*ends, strict=True), marker, color="C1", markersize=3, label=f"{bound} bound")
    for number, (left, right, label) in enumerate(band.marks):
        span = axes.axvspan(left, right, color="0.5", alpha=0.3, linewidth=1)
        span.set_gid(f"change-{number}")
        if len(band.marks) <= _MOST_LABELS:
            axes.annotate(
                label, ((left + right) / 2, 0.98), xycoords=("data", "axes fraction"), rotation=90, fontsize="x-small",
                ha="right", va="top", color="0.25",
            )  # fmt: skip
    axes.set_title(band.title)
    axes.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1))
