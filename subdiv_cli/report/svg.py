"""A curve as an inline SVG: numbers in, a picture out, nothing else needed."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from subdiv_cli.model.blocks import Curve

WIDTH, HEIGHT = 480, 220
LEFT, RIGHT, TOP, BOTTOM = 34, 8, 10, 22
MOST_TICKS = 9

Points = Sequence[tuple[float, float]]


def curve(values: Curve, title: str) -> str:
    """The SVG of a polyline over its axes, with the integers below it and the ends of its range beside it."""
    step = values.arity**values.level
    points = [((values.start + i) / step, float(y)) for i, y in enumerate(values.values)]
    (left, right), (low, high) = _range(points)

    def x(value: float) -> float:
        return LEFT + (value - left) / (right - left) * (WIDTH - LEFT - RIGHT)

    def y(value: float) -> float:
        return HEIGHT - BOTTOM - (value - low) / (high - low) * (HEIGHT - TOP - BOTTOM)

    line = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in points)
    parts = [
        f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{escape(title)}"><title>{escape(title)}</title>',
        f'<line class="axis" x1="{LEFT}" y1="{y(0):.1f}" x2="{WIDTH - RIGHT}" y2="{y(0):.1f}"/>',
        *(_tick_below(x(at), at) for at in _ticks(left, right)),
        *(_tick_beside(y(value), value) for value in _values(low, high)),
        f'<polyline class="phi" points="{line}"/></svg>',
    ]
    return "".join(parts)


def _range(points: Points) -> tuple[tuple[float, float], tuple[float, float]]:
    """The ranges of x and of y, neither empty, the latter with zero in it."""
    left, right = points[0][0], points[-1][0]
    heights = [value for _, value in points]
    low, high = min(0.0, *heights), max(0.0, *heights)
    return (left, right if right > left else left + 1), (low, high if high > low else low + 1)


def _ticks(left: float, right: float) -> range:
    """The integers to be marked, not too many."""
    first, last = -int(-left // 1), int(right // 1)
    return range(first, last + 1, max(1, -(-(last - first) // MOST_TICKS)))


def _values(low: float, high: float) -> list[float]:
    """The values to be marked: zero and the ends of the range, those that do not stand upon each other."""
    room = (high - low) / 10
    return [0.0, *(value for value in (low, high) if abs(value) > room)]


def _tick_below(x: float, at: int) -> str:
    mark = f'<line class="axis" x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{HEIGHT - BOTTOM}"/>'
    return f'{mark}<text x="{x:.1f}" y="{HEIGHT - 6}" text-anchor="middle">{_number(at)}</text>'


def _tick_beside(y: float, value: float) -> str:
    return f'<text x="{LEFT - 5}" y="{y + 4:.1f}" text-anchor="end">{_number(value)}</text>'


def _number(value: float) -> str:
    """A number with three digits, and a minus sign that is one."""
    return f"{value:.3g}".replace("-", "−")
