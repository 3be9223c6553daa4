"""Panels made of blocks of one or several masks: what stands on the same axes, and its title."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from subdiv_cli.model.blocks import Curve, Heights, Picture, Polygon
from subdiv_cli.model.closed import rational
from subdiv_cli.model.formulas import derivative
from subdiv_cli.plot.heights import draw_heights
from subdiv_cli.plot.sampled import Line, Panel, graph, plane
from subdiv_cli.plot.terminal import draw

_TALL, _TALLER = 18, 28
"""The rows of lines and of a map in letters."""


class Drawn(NamedTuple):
    """A mask and the blocks of its picture."""

    title: str
    """The title where it stands alone."""
    label: str
    """The name among the lines of a panel."""
    blocks: tuple[Picture, ...]


class Map(NamedTuple):
    """A map: a function of two variables, with its title."""

    title: str
    heights: Heights


def panels(masks: Sequence[Drawn]) -> list[Panel | Map]:
    """A panel for each function and derivative, a line in it for each mask that has it; one for all polygons; maps."""
    alone = masks[0].title if len(masks) == 1 else None
    functions: dict[str, list[Line]] = {}
    polygons: list[Line] = []
    maps: list[Panel | Map] = []
    for mask in masks:
        for block in mask.blocks:
            if isinstance(block, Curve):
                names = (block.label or mask.label,) if alone is not None else (mask.label, block.label)
                label = ", ".join(filter(None, names))
                functions.setdefault(derivative(block.name, block.order), []).append(graph(block, label))
            elif isinstance(block, Polygon):
                polygons.append(plane(block, mask.label))
            elif isinstance(block, Heights):
                where = f"φ(x, y, {', '.join(map(rational, block.at))})" if block.at else "φ"
                maps.append(Map(f"{where} — {mask.title}", block))
    panels: list[Panel | Map] = [
        Panel(f"{name} — {alone}" if alone else name, tuple(lines)) for name, lines in functions.items()
    ]
    if polygons:
        panels.append(Panel(alone or "limit curves", tuple(polygons), plane=True))
    return panels + maps


def rows(panel: Panel | Map, *, width: int, unicode: bool, height: int | None = None) -> list[str]:
    """The lines of the panel in letters, without its title; several lines in one are not told apart by colour."""
    if isinstance(panel, Map):
        return draw_heights(panel.heights, width=width, height=height or _TALLER, unicode=unicode)
    lines = panel.lines
    if len(lines) > 1:
        lines = tuple(line for line in lines if not line.polygon) or lines
    return draw(lines, width=width, height=height or _TALL, unicode=unicode)


def figure(panels: Sequence[Panel | Map], form: str, style: str) -> bytes:
    """The bytes of the panels one above another. `form` is svg, png or pdf, `style` of maps surface or contour.

    Raises MissingExtraError without matplotlib.
    """
    from subdiv_cli.plot.figure import picture
    from subdiv_cli.plot.relief import relief
    from subdiv_cli.plot.reliefs import reliefs

    maps = [relief(panel.heights, panel.title) for panel in panels if isinstance(panel, Map)]
    if maps:
        return reliefs(maps, form, style)
    return picture([panel for panel in panels if isinstance(panel, Panel)], form)
