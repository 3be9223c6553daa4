"""Functions of two variables to be drawn: exact values made into a grid of doubles, each the nearest one."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from subdiv_cli.model.blocks import Heights

Rows = tuple[tuple[float, ...], ...]


class Relief(NamedTuple):
    """A relief: heights over a rectangle."""

    title: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    z: Rows
    """The heights, a row for each y."""


def relief(heights: Heights, title: str) -> Relief:
    """The relief of the values and zeros around them.

    Where their grid is not rectangular, the values next to the points of one that is.
    """
    across, up = heights.unit
    if across[1] or up[0]:
        side = max(round(len(heights.values) ** 0.5), 2)
        raster, ((left, right), (low, high)) = sampled(heights, side, side)
        middles = [(i + 0.5) / side for i in range(side)]
        x = tuple(left + (right - left) * t for t in middles)
        return Relief(title, x, tuple(low + (high - low) * t for t in middles), tuple(map(tuple, reversed(raster))))
    columns = list(zip(*heights.values, strict=True))
    first, second = (range(min(column) - 1, max(column) + 2) for column in columns)
    first, second = (way[:: -1 if unit < 0 else 1] for way, unit in ((first, across[0]), (second, up[1])))
    z = tuple(tuple(float(heights.values.get((i, j), 0)) for i in first) for j in second)
    return Relief(title, tuple(float(across[0] * i) for i in first), tuple(float(up[1] * j) for j in second), z)


def sampled(heights: Heights, columns: int, rows: int) -> tuple[list[list[float]], list[tuple[float, float]]]:
    """The rows × columns of values in a raster of a box around the function, the uppermost row first; and the box.

    Each is that of the grid point next to the middle of the cell.
    """
    (a, b), (c, d) = ((float(x) for x in row) for row in heights.unit)
    determinant = a * d - b * c
    corners = [(a * i + b * j, c * i + d * j) for i, j in heights.values]
    rings = abs(a) + abs(b), abs(c) + abs(d)
    box = [(min(side) - ring, max(side) + ring) for side, ring in zip(zip(*corners, strict=True), rings, strict=True)]
    (left, right), (low, high) = box
    values = {alpha: float(x) for alpha, x in heights.values.items()}
    raster = [[0.0] * columns for _ in range(rows)]
    for row, column in product(range(rows), range(columns)):
        x = left + (right - left) * (column + 0.5) / columns
        y = high - (high - low) * (row + 0.5) / rows
        alpha = round((d * x - b * y) / determinant), round((a * y - c * x) / determinant)
        raster[row][column] = values.get(alpha, 0.0)
    return raster, box


def ratio(box: Sequence[tuple[float, float]]) -> float:
    """The height of a box by its width; 1 where there is no width."""
    (left, right), (low, high) = box
    return (high - low) / (right - left) if right > left and high > low else 1.0
