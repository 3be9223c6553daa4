"""Functions of two variables to be drawn: exact values made into a grid of doubles, each the nearest one."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from subdiv_cli.model.anatomy import Surface

Rows = tuple[tuple[float, ...], ...]


class Relief(NamedTuple):
    """Heights z over the points (x, y), all three rows by columns; neighbours in the arrays are so in the plane."""

    title: str
    x: Rows
    y: Rows
    z: Rows


def relief(surface: Surface, title: str) -> Relief:
    """All values that are not zero, and a ring of zeros around."""
    columns = list(zip(*surface.values, strict=True))
    first, second = (range(min(column) - 1, max(column) + 2) for column in columns)
    across, up = surface.unit
    x = tuple(tuple(float(across[0] * i + across[1] * j) for i in first) for j in second)
    y = tuple(tuple(float(up[0] * i + up[1] * j) for i in first) for j in second)
    z = tuple(tuple(float(surface.values.get((i, j), 0)) for i in first) for j in second)
    return Relief(title, x, y, z)


def extent(*sides: Rows) -> list[tuple[float, float]]:
    """The smallest and the largest entry of each."""
    return [(min(map(min, rows)), max(map(max, rows))) for rows in sides]


def sampled(surface: Surface, columns: int, rows: int) -> tuple[list[list[float]], list[tuple[float, float]]]:
    """Values in the cells of a raster of a box around the surface, the uppermost row first; and the box.

    Each is that of the grid point next to the middle of the cell.
    """
    (a, b), (c, d) = ((float(x) for x in row) for row in surface.unit)
    determinant = a * d - b * c
    corners = [(a * i + b * j, c * i + d * j) for i, j in surface.values]
    rings = abs(a) + abs(b), abs(c) + abs(d)
    box = [(min(side) - ring, max(side) + ring) for side, ring in zip(zip(*corners, strict=True), rings, strict=True)]
    (left, right), (low, high) = box
    values = {alpha: float(x) for alpha, x in surface.values.items()}
    raster = [[0.0] * columns for _ in range(rows)]
    for row, column in product(range(rows), range(columns)):
        x = left + (right - left) * (column + 0.5) / columns
        y = high - (high - low) * (row + 0.5) / rows
        alpha = round((d * x - b * y) / determinant), round((a * y - c * x) / determinant)
        raster[row][column] = values.get(alpha, 0.0)
    return raster, box


def ratio(box: Sequence[tuple[float, float]]) -> float:
    """Height by width; 1 where there is no width."""
    (left, right), (low, high) = box
    return (high - low) / (right - left) if right > left and high > low else 1.0
