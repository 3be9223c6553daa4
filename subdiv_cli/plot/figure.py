"""Curves drawn by matplotlib into SVG, PNG or PDF: the same input gives the same bytes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from io import BytesIO
from typing import Any

from subdiv_cli.plot.sampled import Panel

SUFFIXES = (".svg", ".png", ".pdf")
INSTALL = "pip install 'subdiv-cli[plot]'"
_METADATA: dict[str, dict[str, Any]] = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {"Software": None}}


class MissingExtraError(ImportError):
    """Raised where matplotlib is not installed; INSTALL is the mend."""


def picture(panels: Sequence[Panel], form: str) -> bytes:
    """The bytes of the panels one above another. `form` is svg, png or pdf. Raises MissingExtraError."""

    def paint(figure: Any) -> None:
        for place, panel in enumerate(panels, 1):
            _panel(figure.add_subplot(len(panels), 1, place), panel)

    tall = 5.0 if any(panel.plane for panel in panels) else 2.4
    return saved(paint, (8, tall * len(panels)), form)


def saved(paint: Callable[[Any], None], size: tuple[float, float], form: str) -> bytes:
    """The bytes of a figure of so many inches that `paint` draws on. Raises MissingExtraError."""
    try:
        import matplotlib as mpl
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingExtraError(str(error)) from None
    with mpl.rc_context({"svg.hashsalt": "subdiv", "svg.fonttype": "path", "axes.grid": True, "grid.alpha": 0.3}):
        figure = Figure(figsize=size, layout="constrained")
        paint(figure)
        buffer = BytesIO()
        figure.savefig(buffer, format=form, metadata=_METADATA[form], dpi=150)
    return buffer.getvalue()


def _panel(axes: Any, panel: Panel) -> None:
    polygons = [line for line in panel.lines if line.polygon]
    for line in panel.lines:
        if line.polygon:
            grey = f"{0.75 - 0.5 * polygons.index(line) / len(polygons):.3f}"
            axes.plot(line.x, line.y, "o-", color=grey, linewidth=0.8, markersize=3, label=line.label)
        else:
            axes.plot(line.x, line.y, linewidth=1.4, label=line.label)
    axes.set_title(panel.title)
    if panel.plane:
        axes.set_aspect("equal", "datalim")
    if len(panel.lines) > 1:
        axes.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1))
