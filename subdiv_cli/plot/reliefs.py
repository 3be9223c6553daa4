"""Functions of two variables drawn by matplotlib: a shaded surface over its contours, or a map of contours."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from subdiv_cli.plot.figure import saved
from subdiv_cli.plot.relief import Relief, extent

STYLES = ("surface", "contour")
_BANDS = 12
_MAP = "viridis"
_VIEW = {"elev": 32, "azim": -58}
_FLOOR = 0.55
"""How far below the surface its contours lie, by its height."""


def reliefs(panels: Sequence[Relief], form: str, style: str) -> bytes:
    """The panels one above another, as `figure.picture` has them. Raises MissingExtraError."""

    def paint(figure: Any) -> None:
        for place, panel in enumerate(panels, 1):
            if style == "surface":
                _surface(figure.add_subplot(len(panels), 1, place, projection="3d"), panel)
            else:
                _contour(figure, figure.add_subplot(len(panels), 1, place), panel)

    return saved(paint, (8, (6.4 if style == "surface" else 5.6) * len(panels)), form)


def _surface(axes: Any, panel: Relief) -> None:
    x, y, z = _arrays(panel)
    (left, right), (front, back), (low, high) = extent(panel.x, panel.y, panel.z)
    floor = low - _FLOOR * (high - low)
    axes.contour(x, y, z, _levels(low, high), zdir="z", offset=floor, cmap=_MAP, linewidths=0.8)
    axes.plot_surface(x, y, z, cmap=_MAP, rstride=1, cstride=1, linewidth=0, antialiased=False, rasterized=True)
    axes.set_zlim(floor, high)
    wide, deep = right - left, back - front
    axes.set_box_aspect((wide, deep, 0.75 * max(wide, deep)))
    axes.view_init(**_VIEW)
    axes.set_zticks([tick for tick in axes.get_zticks() if low <= tick <= high])
    _named(axes, panel)


def _contour(figure: Any, axes: Any, panel: Relief) -> None:
    x, y, z = _arrays(panel)
    _, _, (low, high) = extent(panel.x, panel.y, panel.z)
    levels = _levels(low, high)
    filled = axes.contourf(x, y, z, levels, cmap=_MAP, extend="both")
    axes.contour(x, y, z, levels, colors="black", linewidths=0.4, alpha=0.6)
    axes.set_aspect("equal")
    figure.colorbar(filled, ax=axes)
    _named(axes, panel)


def _named(axes: Any, panel: Relief) -> None:
    axes.set_title(panel.title)
    axes.set_xlabel("x")
    axes.set_ylabel("y")


def _arrays(panel: Relief) -> tuple[Any, Any, Any]:
    import numpy as np

    return np.array(panel.x), np.array(panel.y), np.array(panel.z)


def _levels(low: float, high: float) -> list[float]:
    """Inside the range, not its ends; zero is none of them, as φ is zero on all of the plane around."""
    step = (high - low) / (_BANDS + 1)
    levels = [low + step * i for i in range(1, _BANDS + 1)]
    return [level for level in levels if abs(level) > step / 8]
