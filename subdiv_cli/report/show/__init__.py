"""The formats of `subdiv show`: `text`, `markdown` and `latex` set the sections of a portrait, `json` has its data.

A format's module is imported when it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING

from subdiv_cli.model import Result
from subdiv_cli.report.look import Look

if TYPE_CHECKING:
    from subdiv_cli.model.blocks import Portrait
    from subdiv_cli.report.blocks import Draw

Show = Callable[[Result, "Portrait", "Draw", Look], str]
"""A function from the result, the portrait, what draws a picture with letters, and the look to the page."""

FORMATS = ("text", "json", "markdown", "latex")


def renderer(name: str) -> Show:
    """The function that renders a format. Raises KeyError for one that does not exist."""
    if name not in FORMATS:
        raise KeyError(name)
    render: Show = import_module(f"subdiv_cli.report.show.{name}").render
    return render
