"""The option -o, as `-o FILE` or `-o FORMAT:FILE`: the files of a report, and the way there."""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Iterable, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, NamedTuple

import click

from subdiv_cli.cli.streams import put, put_file, put_pieces, why_not
from subdiv_cli.model import Result
from subdiv_cli.report import FOR_PEOPLE, FORMATS, SUFFIXES
from subdiv_cli.report.look import Look

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

_FOREIGN = {
    ".yaml", ".yml", ".toml", ".xml", ".html", ".htm", ".md", ".markdown", ".rst", ".tex", ".csv", ".tsv", ".jsonl",
    ".ndjson", ".sarif", ".pdf", ".png", ".svg",
}  # fmt: skip
"""The suffixes that promise a format; a report in another one under such a name would be a surprise."""
_PREFIX = re.compile(r"([A-Za-z][\w.+-]+):", re.ASCII)
"""A word before a colon, which is meant as a format; a single letter is a drive."""


class Output(NamedTuple):
    """A file for a report; a `format` of None is that of --format."""

    file: str
    format: str | None = None


class OutputType(click.ParamType[Output]):
    """The type of `FILE` or `FORMAT:FILE`, a format being one in the registry; else guessed by the file's suffix."""

    name = "[format:]file"

    def convert(self, value: str | Output, param: click.Parameter | None, ctx: click.Context | None) -> Output:
        """The output that the text names; fails where the file cannot be written, before any work is done."""
        if isinstance(value, Output):
            return value
        prefix = _PREFIX.match(value)
        if prefix is None:
            output = Output(file=value, format=self._by_suffix(value, param, ctx))
        elif prefix[1] in FORMATS:
            output = Output(file=value[prefix.end() :], format=prefix[1])
        else:
            self.fail(f"no format {prefix[1]!r}; there are {_formats()}. A file of that name is ./{value}", param, ctx)
        if output.file in ("", "-"):
            self.fail(f"{value!r} names no file; what goes to stdout is chosen with --format", param, ctx)
        if (reason := why_not(output.file)) is not None:
            self.fail(f"{output.file!r} cannot be written: {reason}", param, ctx)
        return output

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        """The completion of a file, which the shell does."""
        return click.Path().shell_complete(ctx, param, incomplete)

    def _by_suffix(self, file: str, param: click.Parameter | None, ctx: click.Context | None) -> str | None:
        if (foreign := promised(file, SUFFIXES)) is not None:
            self.fail(f"no format {foreign}; there are {_formats()}. Say which, as in -o text:{file}", param, ctx)
        return SUFFIXES.get(PurePath(file).suffix.lower())


def promised(file: str, suffixes: Container[str]) -> str | None:
    """The suffix of a file if it promises a format that is not among these; None where it promises none."""
    suffix = PurePath(file).suffix.lower()
    return suffix if suffix in _FOREIGN and suffix not in suffixes else None


def _formats() -> str:
    return ", ".join(FORMATS)


def put_report(render: Callable[[str, Look], Iterable[str]], form: str, look: Look) -> bool:
    """Whether a report, rendered in a format for a look, could be written to stdout."""
    return put_pieces(render(form, look), encoding=None if form in FOR_PEOPLE else "utf-8")


def put_statistics(results: Sequence[Result], form: str, look: Look) -> bool:
    """Whether the statistics of a run could be written to stdout, as a table or as JSON."""
    from subdiv_cli.report import statistics

    if form == "json":
        return put(statistics.as_json(results, look), encoding="utf-8")
    return put(statistics.as_text(results, look))


def put_reports(render: Callable[[str, Look], Iterable[str]], form: str, look: Look, outputs: Sequence[Output]) -> bool:
    """Whether the report could be written to every file of -o, in a look of its own."""
    paper = Look()
    look = look._replace(width=paper.width, unicode=paper.unicode, colour=paper.colour, problems=paper.problems)
    written = [put_file(output.file, render(output.format or form, look)) for output in outputs]
    return all(written)
