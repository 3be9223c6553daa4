"""Functions of two variables drawn by matplotlib: shaded surfaces, or maps of contours."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import ceil, floor, log10
from typing import Any

from subdiv_cli.plot.figure import saved
from subdiv_cli.plot.relief import Relief

STYLES = ("surface", "contour")
_BANDS = 20
_MAP = "viridis"
_VIEW = {"elev": 34, "azim": -58}
_SIZES = {"surface": (8, 6.4), "contour": (7, 5.6)}
_HEIGHT = 0.6
"""The height of a surface, by the longer side of its support."""


def reliefs(panels: Sequence[Relief], form: str, style: str) -> bytes:
    """The bytes of the panels one above another, as `figure.picture` has them. Raises MissingExtraError."""

    def paint(figure: Any) -> None:
        for place, panel in enumerate(panels, 1):
            if style == "surface":
                _surface(figure.add_subplot(len(panels), 1, place, projection="3d"), panel)
            else:
                _contour(figure, figure.add_subplot(len(panels), 1, place), panel)

    width, height = _SIZES[style]
    return saved(paint, (width, height * len(panels)), form)


def _surface(axes: Any, panel: Relief) -> None:
    """Draw a surface lit from the left; an SVG or PDF has it as an image, as there are thousands of facets."""
    import matplotlib as mpl
    import numpy as np
    from matplotlib.colors import LightSource

    x, y, z = panel.x, panel.y, np.array(panel.z)
    wide, deep = x[-1] - x[0], y[-1] - y[0]
    tall = _HEIGHT * max(wide, deep)
    steps = {"dx": x[1] - x[0], "dy": y[1] - y[0], "vert_exag": tall / np.ptp(z)}
    colours = LightSource(azdeg=225, altdeg=45).shade(z, mpl.colormaps[_MAP], blend_mode="soft", **steps)
    plain = {"linewidth": 0, "antialiased": False, "shade": False, "rasterized": True}
    axes.plot_surface(*np.meshgrid(x, y), z, facecolors=colours, rstride=1, cstride=1, **plain)
    axes.set_box_aspect((wide, deep, tall), zoom=1.05)
    axes.view_init(**_VIEW)
    _named(axes, panel)


def _contour(figure: Any, axes: Any, panel: Relief) -> None:
    levels = _levels(min(map(min, panel.z)), max(map(max, panel.z)))
    filled = axes.contourf(panel.x, panel.y, panel.z, levels, cmap=_MAP)
    axes.contour(panel.x, panel.y, panel.z, levels, colors="black", linewidths=0.4, alpha=0.6)
    axes.set_aspect("equal")
    bands = [(a + b) / 2 for a, b in pairwise(levels)]
    zero = min(range(len(bands)), key=lambda i: abs(bands[i]))
    figure.colorbar(filled, ax=axes, ticks=bands[zero % 2 :: 2])
    _named(axes, panel)


def _named(axes: Any, panel: Relief) -> None:
    axes.set_title(panel.title)
    axes.set_xlabel("x")
    axes.set_ylabel("y")


def _levels(low: float, high: float) -> list[float]:
    """The levels of contours, odd multiples of half a round step: none is zero, which φ is all around its support."""
    unit = 10.0 ** floor(log10((high - low) / _BANDS))
    step = next(unit * times for times in (1, 2, 2.5, 5, 10) if unit * times * _BANDS >= high - low)
    return [(i + 0.5) * step for i in range(floor(low / step - 0.5), ceil(high / step + 0.5))]
