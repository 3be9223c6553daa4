"""Drawings of a function of two variables in letters: the darker the higher, and a sign of its own below zero."""

from __future__ import annotations

from subdiv_cli.model.blocks import Heights
from subdiv_cli.plot.relief import ratio, sampled
from subdiv_cli.plot.terminal import MARGIN, framed

_SHADES = {True: "·░▒▓█", False: ".:+*#"}
_BELOW = "-"
_FLAT = 100
"""A value below the top divided by this is left blank."""
_TALL = 2
"""The height of a letter by its width, about."""


def draw_heights(heights: Heights, *, width: int = 80, height: int = 30, unicode: bool = True) -> list[str]:
    """The lines of a map at most so many columns wide and about so many rows high, axes in one unit, with a key."""
    columns, rows = max(width - MARGIN - 3, 8), max(height, 4)
    _, box = sampled(heights, 1, 1)
    tall = ratio(box) / _TALL
    if columns * tall > rows:
        columns = max(round(rows / tall), 8)
    rows = max(round(columns * tall), 4)
    raster, box = sampled(heights, columns, rows)
    top, shades = max(map(float, heights.values.values())), _SHADES[unicode]
    cells = ["".join(_letter(z, top, shades) for z in row) for row in raster]
    return [*framed(cells, box[0], box[1], columns, unicode), *_key(heights, top, shades, width)]


def _letter(z: float, top: float, shades: str) -> str:
    if abs(z) < top / _FLAT:
        return " "
    return _BELOW if z < 0 else shades[min(int(z / top * len(shades)), len(shades) - 1)]


def _key(heights: Heights, top: float, shades: str, width: int) -> list[str]:
    """The lines that explain the letters, in as many rows as it takes."""
    low = min(map(float, heights.values.values()))
    parts = [f"{_BELOW} {low:.3g} to 0"] if low < 0 else []
    parts += [f"{shade} to {top * (i + 1) / len(shades):.3g}" for i, shade in enumerate(shades)]
    rows = [""]
    for part in parts:
        longer = f"{rows[-1]}   {part}" if rows[-1] else part
        if rows[-1] and len(longer) + 2 > width:
            rows.append(part)
        else:
            rows[-1] = longer
    return [f"  {row}" for row in rows]
