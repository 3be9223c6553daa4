"""Streams for output: the terminal or pipe there is, and files that are whole or not there at all.

Reports go to stdout and to files, errors to stderr.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from typing import IO, TextIO

import click

from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.model import Problem
from subdiv_cli.report.look import UNWRAPPED, Look

_NEEDED = "φαρνεΣ½‖∞≥≤−²·—…ö✓✗○─"
WIDEST = 120
"""The most columns of a report on a terminal, however wide that is."""


class UnwritableError(click.ClickException):
    """Raised where the result could not be written to stdout: the disk is full, the device is gone."""

    def __init__(self, error: OSError) -> None:
        super().__init__(f"the report cannot be written: {error.strerror or error}")

    def show(self, file: IO[str] | None = None) -> None:
        """Write one line to stderr."""
        emit(f"error: {self.message}\n", sys.stderr)


def look_of(stream: TextIO, **settings: int | bool) -> Look:
    """The look of a report on this stream; settings are passed on to Look."""
    width = columns(stream)
    chosen = {"width": width, "unicode": speaks_mathematics(stream), "colour": has_colour(stream), **settings}
    return Look(**chosen)  # type: ignore[arg-type]


def columns(stream: TextIO, elsewhere: int = Look().width) -> int:
    """The width: COLUMNS if it is set, else the terminal's up to a pleasant one; in pipes and files `elsewhere`."""
    with suppress(ValueError):
        if (width := int(os.environ.get("COLUMNS", ""))) > 0:
            return width
    with suppress(OSError, ValueError, AttributeError):
        if (seen := os.get_terminal_size(stream.fileno()).columns) > 0:
            return min(seen, WIDEST)
    return elsewhere


def speaks_mathematics(stream: TextIO) -> bool:
    """Whether the stream's encoding has the letters a report is written with."""
    try:
        _NEEDED.encode(stream.encoding or "ascii")
    except (UnicodeEncodeError, LookupError, AttributeError):
        return False
    return True


def has_colour(stream: TextIO) -> bool:
    """Whether colour is used: NO_COLOR wins, then FORCE_COLOR, then whether it is a terminal that can."""
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return stream.isatty() and os.environ.get("TERM") not in ("dumb", "unknown")


def emit(text: str, stream: TextIO, *, encoding: str | None = None) -> None:
    """Write a text; a letter that cannot be encoded as its escape. A reader that went away is no error.

    Raises UnwritableError where a result cannot be written; what stderr does not take is lost, there is nowhere else.
    """
    raw = text.encode(encoding or stream.encoding or "utf-8", "backslashreplace")
    try:
        stream.flush()
        buffer = getattr(stream, "buffer", None)
        if buffer is None:
            stream.write(raw.decode(encoding or stream.encoding or "utf-8"))
        else:
            buffer.write(raw)
        stream.flush()
    except BrokenPipeError:
        abandon(stream)
    except OSError as error:
        abandon(stream)
        if stream is not sys.stderr:
            raise UnwritableError(error) from None


def abandon(stream: TextIO) -> None:
    """Point a stream nobody reads at nothing, so that its last flush is quiet too."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def why_not(file: str) -> str | None:
    """The reason why a file cannot be written, as far as can be seen before the work is done; None without one."""
    from pathlib import Path

    path = Path(os.path.realpath(file))
    if path.is_dir():
        return "it is a directory"
    if not path.parent.is_dir():
        return f"there is no directory {path.parent}"
    if path.exists() and not path.is_file():
        return None
    return None if os.access(path.parent, os.W_OK) else f"the directory {path.parent} is not writable"


def put(text: str, *, encoding: str | None = None) -> bool:
    """Whether a result could be written to stdout; if not, the reason is written to stderr."""
    try:
        emit(text, sys.stdout, encoding=encoding)
    except UnwritableError as error:
        error.show()
        return False
    return True


def put_pieces(pieces: Iterable[str], *, encoding: str | None = None) -> bool:
    """Whether a result in pieces could be written to stdout, none before all are made; if not, why is on stderr."""
    from subdiv_cli.catalog.spool import Spool

    spool = Spool[str]()
    for piece in pieces:
        spool.append(piece)
    return all(put(piece, encoding=encoding) for piece in spool)


def put_file(file: str, content: str | bytes | Iterable[str]) -> bool:
    """Whether a result could be written to a file, whole or not at all; if not, the reason is written to stderr."""
    from subdiv_cli.catalog.files import write_whole

    try:
        write_whole(file, content)
    except OSError as error:
        emit(f"error: {file} cannot be written: {error.strerror or error}\n", sys.stderr)
        return False
    return True


def complain(problems: Iterable[Problem]) -> ExitCode:
    """The exit code 2, after problems are written to stderr; wrapped only on a terminal, for grep elsewhere."""
    from subdiv_cli.report.problems import render

    settings = {} if sys.stderr.isatty() else {"width": UNWRAPPED}
    if text := render(problems, look_of(sys.stderr, **settings)):
        emit(text + "\n", sys.stderr)
    return ExitCode.ERROR
