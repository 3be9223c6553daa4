"""The report as workflow commands, which GitHub shows as annotations of files.

`::error file=…,line=…,title=…::message`. What passed is not annotated; the last line counts the masks.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from subdiv_cli.model import Result
from subdiv_cli.report import words
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import Notice, is_file, notices

_COMMANDS = {"error": "error", "warning": "warning", "note": "notice"}


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The annotations of all results."""
    lines = [line for result in results for line in _lines(result, look)]
    lines += [f"::warning title=missing::{_message(file)} of the baseline was not checked" for file in look.missing]
    lines.append(words.footer(results, allow_undecided=look.allow_undecided))
    yield from (line + "\n" for line in lines)


def _lines(result: Result, look: Look) -> Iterator[str]:
    for notice in notices(result, look):
        properties = {"title": f"{words.name(result)}: {notice.title}", **_place(result, notice)}
        shown = ",".join(f"{key}={_property(value)}" for key, value in properties.items())
        yield f"::{_COMMANDS[notice.level]} {shown}::{_message(notice.message)} [{notice.code}]"


def _place(result: Result, notice: Notice) -> dict[str, str]:
    """The properties of the place of a notice: a file has a first line at least."""
    if not is_file(result):
        return {}
    place = {"file": result.file, "line": str(notice.line or 1)}
    return place if notice.column is None else {**place, "col": str(notice.column)}


def _message(text: str) -> str:
    return clean(text).replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    """A text as a property, where a colon and a comma would end it."""
    return _message(text).replace(":", "%3A").replace(",", "%2C")
