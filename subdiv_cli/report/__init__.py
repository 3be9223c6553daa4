"""Output formats, one file each: results in, the pieces of a text out, so that many masks need little memory.

`json` is a contract (schema.json), `jsonl` its lines; `junit`, `sarif`, `github` and `markdown` are for CI servers and
show what `notices` lists; `html` is a page of `cards` with curves by `svg`. `concise` is for grep; `text` is for
people: `words` says it, `marks` has the signs of verdicts, `reasons` the rows of the table, `numbers` prints only
certain digits, `letters` finds ASCII for the mathematics where it must, `page` gathers the lines in columns and
`findings` leaves out what says the same again. `blocks` and `grids` set what kinds hand over (stencils, formulas,
matrices), of which the pages of `show` consist. `problems` shows what is wrong with a file. `look` is all that a format
knows beside the results. A format's module is imported when it is asked for. `jsr` and `sweep` render no results.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from subdiv_cli.model import Result
from subdiv_cli.report.look import Look

Render = Callable[[Sequence[Result], Look], str]
Pieces = Callable[[Sequence[Result], Look], Iterator[str]]

FORMATS = {
    "text": "subdiv_cli.report.text",
    "concise": "subdiv_cli.report.concise",
    "json": "subdiv_cli.report.json",
    "jsonl": "subdiv_cli.report.jsonl",
    "junit": "subdiv_cli.report.junit",
    "sarif": "subdiv_cli.report.sarif",
    "github": "subdiv_cli.report.github",
    "markdown": "subdiv_cli.report.markdown",
    "html": "subdiv_cli.report.html",
}
"""The module whose `pieces` makes each format."""

SUFFIXES = {
    ".json": "json", ".jsonl": "jsonl", ".ndjson": "jsonl", ".xml": "junit", ".sarif": "sarif", ".md": "markdown",
    ".markdown": "markdown", ".html": "html", ".htm": "html",
}  # fmt: skip
"""The format of each file suffix; .txt and .log stand for none, as two of the formats are text."""

FOR_PEOPLE = ("text", "concise")
"""The formats in letters that the console can print; the others are UTF-8 wherever they go."""


def renderer(name: str) -> Render:
    """The function that renders a format as one text. Raises KeyError for one that does not exist."""
    pieces = streamer(name)
    return lambda results, look: "".join(pieces(results, look))


def streamer(name: str) -> Pieces:
    """The function that renders a format piece by piece. Raises KeyError for one that does not exist."""
    from importlib import import_module

    pieces: Pieces = import_module(FORMATS[name]).pieces
    return pieces
