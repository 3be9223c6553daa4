"""Drawings of curves in letters: dots of Braille, two by four to a cell, or stars where there is ASCII only."""

from __future__ import annotations

from collections.abc import Sequence

from subdiv_cli.plot.sampled import Line

_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""The bits of the eight dots of a Braille cell, by row and column."""
_BLANK = 0x2800
MARGIN = 10
"""The columns for the numbers beside the picture."""


def draw(lines: Sequence[Line], *, width: int = 80, height: int = 16, unicode: bool = True) -> list[str]:
    """The rows of one picture of all lines, at most so many columns and rows, an axis of numbers around it."""
    columns, rows = max(width - MARGIN - 3, 8), max(height, 4)
    xs, ys = [x for line in lines for x in line.x], [y for line in lines for y in line.y]
    left, right, low, high = *_range(xs), *_range(ys)
    across, down = (2, 4) if unicode else (1, 2)
    canvas = _Canvas(columns * across, rows * down)
    for line in lines:
        places = [
            ((x - left) / (right - left) * (canvas.width - 1), (high - y) / (high - low) * (canvas.height - 1))
            for x, y in zip(line.x, line.y, strict=True)
        ]
        canvas.trace(places)
    cells = canvas.braille() if unicode else canvas.ascii()
    return framed(cells, (left, right), (low, high), columns, unicode)


def _range(values: Sequence[float]) -> tuple[float, float]:
    low, high = min(values, default=0.0), max(values, default=1.0)
    return (low, high) if high > low else (low - 0.5, high + 0.5)


def framed(
    cells: list[str], across: tuple[float, float], up: tuple[float, float], columns: int, unicode: bool
) -> list[str]:
    """The rows of the picture with the numbers of its corners."""
    bar, corner, rule = ("│", "└", "─") if unicode else ("|", "+", "-")
    numbers = {0: f"{up[1]:.4g}", len(cells) - 1: f"{up[0]:.4g}"}
    rows = [f"{numbers.get(i, ''):>{MARGIN}} {bar}{row}".rstrip() for i, row in enumerate(cells)]
    left, right = f"{across[0]:.4g}", f"{across[1]:.4g}"
    rows.append(" " * (MARGIN + 1) + corner + rule * columns)
    rows.append(" " * (MARGIN + 2) + left + right.rjust(max(columns - len(left), len(right) + 1)))
    return rows


class _Canvas:
    """A grid of dots, the first row on top."""

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self.dots: set[tuple[int, int]] = set()

    def trace(self, places: Sequence[tuple[float, float]]) -> None:
        """Draw a polygon through these places, with as many dots as its longer side needs."""
        for (x, y), (u, v) in zip(places, places[1:] or places, strict=False):
            steps = max(round(max(abs(u - x), abs(v - y))), 1)
            for i in range(steps + 1):
                self.dots.add((round(x + (u - x) * i / steps), round(y + (v - y) * i / steps)))

    def braille(self) -> list[str]:
        rows = []
        for top in range(0, self.height, 4):
            row = ""
            for left in range(0, self.width, 2):
                bits = sum(_DOTS[j][i] for j in range(4) for i in range(2) if (left + i, top + j) in self.dots)
                row += chr(_BLANK + bits) if bits else " "
            rows.append(row)
        return rows

    def ascii(self) -> list[str]:
        """The rows in ASCII: `'` for a dot in the upper half of a cell, `.` in the lower one, `:` for both."""
        rows = []
        for top in range(0, self.height, 2):
            halves = (((x, top) in self.dots, (x, top + 1) in self.dots) for x in range(self.width))
            rows.append(
                "".join({(False, False): " ", (True, False): "'", (False, True): "."}.get(h, ":") for h in halves)
            )
        return rows
