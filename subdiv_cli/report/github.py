"""The report as workflow commands, which GitHub shows as annotations of files.

`::error file=…,line=…,title=…::message`. What passed is not annotated; the last line counts the masks. GitHub shows
only the first ten errors, warnings and notices of a step: where there are more, those of one mask are joined, and where
these are still more, those of one code, the most frequent first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from subdiv_cli.model import Result
from subdiv_cli.report import words
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import Notice, is_file, notices

_COMMANDS = {"error": "error", "warning": "warning", "note": "notice"}
SHOWN = 10
"""The annotations of a level that GitHub shows."""
MOST_LINES = 20
"""The most lines of an annotation."""


class Annotation(NamedTuple):
    """A notice about a mask, as a line of the log may have it."""

    file: str
    name: str
    notice: Notice
    place: dict[str, str]

    @property
    def message(self) -> str:
        """The message with the code."""
        return f"{self.notice.message} [{self.notice.code}]"


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The annotations of all results, errors first."""
    by_level: dict[str, list[Annotation]] = {level: [] for level in _COMMANDS}
    for result in results:
        for notice in notices(result, look):
            by_level[notice.level].append(Annotation(result.file, words.name(result), notice, _place(result, notice)))
    for level, several in by_level.items():
        for group in _groups(several):
            title, lines = _joined(group)
            rest = [f"and {len(lines) - MOST_LINES} more"] if len(lines) > MOST_LINES else []
            message = "\n".join(lines[:MOST_LINES] + rest)
            shown = ",".join(f"{key}={_property(text)}" for key, text in {"title": title, **group[0].place}.items())
            yield f"::{_COMMANDS[level]} {shown}::{_escaped(message)}\n"
            if rest:  # in the log they can be unfolded
                yield f"::group::{rest[0]}\n{''.join(map(_plain, lines[MOST_LINES:]))}::endgroup::\n"
    yield from (
        f"::warning title=missing::{_escaped(clean(file))} of the baseline was not checked\n" for file in look.missing
    )
    yield words.footer(results, allow_undecided=look.allow_undecided) + "\n"


def _groups(several: Sequence[Annotation]) -> list[list[Annotation]]:
    """The annotations one by one where GitHub shows all, else those of a mask together, else those of a code."""
    if len(several) <= SHOWN:
        return [[annotation] for annotation in several]
    masks = _by(several, lambda annotation: annotation.file)
    if len(masks) <= SHOWN:
        return masks
    return sorted(_by(several, lambda annotation: annotation.notice.code), key=len, reverse=True)


def _by(several: Sequence[Annotation], key: Callable[[Annotation], str]) -> list[list[Annotation]]:
    groups: dict[str, list[Annotation]] = {}
    for annotation in several:
        groups.setdefault(key(annotation), []).append(annotation)
    return list(groups.values())


def _joined(group: Sequence[Annotation]) -> tuple[str, list[str]]:
    """The title and the lines of a group."""
    first, count = group[0], len({annotation.file for annotation in group})
    if len(group) == 1:
        title, lines = f"{first.name}: {first.notice.title}", [first.message]
    elif count == 1:
        title, lines = f"{first.name}: {len(group)} reasons", [annotation.message for annotation in group]
    else:
        title, lines = f"{count} masks: {first.notice.code}", [f"{each.file}: {each.message}" for each in group]
    return title, list(map(clean, lines))


def _place(result: Result, notice: Notice) -> dict[str, str]:
    """The properties of the place of a notice: a file has a first line at least."""
    if not is_file(result):
        return {}
    place = {"file": result.file, "line": str(notice.line or 1)}
    return place if notice.column is None else {**place, "col": str(notice.column)}


def _plain(line: str) -> str:
    """A line of the log in which no command begins."""
    return f"- {line.replace('##[', '## [')}\n"


def _escaped(text: str) -> str:
    """A message in one line, its breaks escaped."""
    return text.replace("%", "%25").replace("\n", "%0A")


def _property(text: str) -> str:
    """A text as a property, where a colon and a comma would end it."""
    return _escaped(clean(text)).replace(":", "%3A").replace(",", "%2C")
