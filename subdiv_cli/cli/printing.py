"""Reports on stdout and in files, errors on stderr."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence

from subdiv_cli.cli.outputs import Output
from subdiv_cli.cli.streams import UnwritableError, emit, look_of
from subdiv_cli.model import Problem, Result
from subdiv_cli.report import FOR_PEOPLE, renderer
from subdiv_cli.report.look import UNWRAPPED, Look


def complain(problems: Iterable[Problem]) -> None:
    """Problems on stderr; wrapped only on a terminal, so that a message can be grepped elsewhere."""
    from subdiv_cli.report.problems import render

    settings = {} if sys.stderr.isatty() else {"width": UNWRAPPED}
    if text := render(problems, look_of(sys.stderr, **settings)):
        emit(text + "\n", sys.stderr)


def report(results: Sequence[Result], form: str, look: Look) -> bool:
    """The report on stdout, and whether that could be written; the text format has the errors on stderr, and first."""
    if form == "text":
        complain(problem for result in results for problem in result.problems)
    return put(renderer(form)(results, look._replace(problems=False)), form)


def put(text: str, form: str) -> bool:
    """A text in some format on stdout, and whether that could be written."""
    try:
        emit(text, sys.stdout, encoding=None if form in FOR_PEOPLE else "utf-8")
    except UnwritableError as error:
        error.show()
        return False
    return True


def write(results: Sequence[Result], outputs: Sequence[Output], form: str, look: Look) -> bool:
    """The report in every file asked for; whether all could be written."""
    from subdiv_cli.catalog.files import write_whole

    written = True
    for output in outputs:
        try:
            write_whole(output.file, renderer(output.format or form)(results, look))
        except OSError as error:
            emit(f"error: {output.file} cannot be written: {error.strerror or error}\n", sys.stderr)
            written = False
    return written


def look_for_files(look: Look) -> Look:
    """The look of a report in a file: what was asked to be seen, on paper of its own."""
    plain = Look()
    return look._replace(width=plain.width, unicode=plain.unicode, colour=plain.colour, problems=plain.problems)
