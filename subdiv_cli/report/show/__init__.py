"""`subdiv show` in its formats: `content` says once what there is to say, `text`, `markdown` and `latex` set it.

`json` has the same as data. A format's module is imported when it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import import_module

from subdiv_cli.model import Result
from subdiv_cli.model.blocks import Anatomy
from subdiv_cli.report.look import Look

Show = Callable[[Result, Anatomy, Sequence[str], Look], str]
"""The result, the mask taken apart, the lines of a picture of φ, and the place it goes to -> the page."""

FORMATS = ("text", "json", "markdown", "latex")


def renderer(name: str) -> Show:
    """The function that renders a format. Raises KeyError for one that does not exist."""
    if name not in FORMATS:
        raise KeyError(name)
    render: Show = import_module(f"subdiv_cli.report.show.{name}").render
    return render
