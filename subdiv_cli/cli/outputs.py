"""`-o FILE` and `-o FORMAT:FILE`."""

from __future__ import annotations

from typing import NamedTuple

import click

from subdiv_cli.report import FORMATS, SUFFIXES


class Output(NamedTuple):
    """A file a report is to be written to; `format` None is the one of --format."""

    file: str
    format: str | None = None


def _by_suffix(file: str) -> str | None:
    return next((form for suffix, form in SUFFIXES.items() if file.lower().endswith(suffix)), None)


class OutputType(click.ParamType[Output]):
    """`FILE` or `FORMAT:FILE`, a format being one of those in the registry; else guessed by the file's suffix."""

    name = "[format:]file"

    def convert(self, value: str | Output, param: click.Parameter | None, ctx: click.Context | None) -> Output:
        """Parse; fail where the file cannot be written, before any work is done."""
        if isinstance(value, Output):
            return value
        before, colon, after = value.partition(":")
        if colon and before in FORMATS:
            output = Output(file=after, format=before)
        else:
            output = Output(file=value, format=_by_suffix(value))
        if output.file in ("", "-"):
            self.fail(f"{value!r} names no file; what goes to stdout is chosen with --format", param, ctx)
        from subdiv_cli.cli.streams import why_not

        if (reason := why_not(output.file)) is not None:
            self.fail(f"{output.file!r} cannot be written: {reason}", param, ctx)
        return output
