"""The problems of a file as text: where, what, and how to mend it, with the line and a caret under the place.

An example:

    error[SD003] TOML has no fractions
      --> masks/four_point.toml:3:19 in mask.coefficients[0]
      |
    3 | coefficients = [-1/16, 0, "9/16"]
      |                   ^
      = help: write exact coefficients as strings: "-1/16"
      = more: subdiv explain SD003
"""

from __future__ import annotations

from collections.abc import Iterable

from subdiv_cli.model import Problem
from subdiv_cli.report.letters import letters, width
from subdiv_cli.report.look import Look
from subdiv_cli.report.page import Line, led, paint

SNIPPET = 100
"""The most columns of a source line that are shown."""


def render(problems: Iterable[Problem], look: Look) -> str:
    """The text of the problems one after another, an empty line between them."""
    lines: list[Line] = []
    for problem in problems:
        lines += [[], *problem_lines(problem, look)] if lines else problem_lines(problem, look)
    return paint(lines, colour=look.colour)


def problem_lines(problem: Problem, look: Look) -> list[Line]:
    """The lines of one problem."""
    number = "" if problem.line is None else str(problem.line)
    margin = " " * max(len(number), 1)
    lines = _first(problem, look)
    where = place(problem)
    if where:
        lines += _noted(f"{margin} --> ", letters(where, look.unicode), look)
    if number and problem.source is not None and problem.source.strip():
        room = min(look.width, SNIPPET) - len(margin) - 3
        source, caret = excerpt(problem.source, problem.column, room, unicode=look.unicode)
        lines.append([(f"{margin} |", "quiet")])
        lines.append([(f"{number} | ", "quiet"), (source, "text")])
        if caret is not None:
            lines.append([(f"{margin} | ", "quiet"), (" " * caret, ""), ("^", "bad")])
    if problem.help:
        lines += _noted(f"{margin} = help: ", letters(problem.help, look.unicode), look)
    return lines + _noted(f"{margin} = more: ", f"subdiv explain {problem.code}", look)


def place(problem: Problem) -> str:
    """The place of a problem, as much of it as is known: `file:3:19 in mask.arity`; of an option `-p:1:5`."""
    parts = [problem.file or problem.key or ""]
    if problem.line is not None:
        parts.append(str(problem.line))
        if problem.column is not None:
            parts.append(str(problem.column))
    where = ":".join(parts)
    return f"{where} in {problem.key}" if problem.file and problem.key else where


def _first(problem: Problem, look: Look) -> list[Line]:
    lead = [(f"error[{problem.code}]", "bad"), (" ", "")]
    return led(lead, letters(problem.message, look.unicode), look.width, role="head", hanging=2)


def _noted(lead: str, text: str, look: Look) -> list[Line]:
    """The lines of a note, its later ones under its first where there is room for that."""
    hanging = len(lead) if len(lead) < look.width // 3 else 4
    return led([(lead, "quiet")], text, look.width, hanging=hanging)


def excerpt(source: str, column: int | None, room: int, *, unicode: bool = True) -> tuple[str, int | None]:
    """A source line in at most `room` columns, cut around the caret where it is longer, and the caret's place in it.

    `column` is 1-based in characters, like everywhere; the place is 0-based in terminal columns.
    """
    pieces = [letters(c, unicode) if c != "\t" else "    " for c in source.rstrip("\r\n")]
    at = len(pieces) if column is None else min(column - 1, len(pieces))
    before = "".join(pieces[:at])
    if width("".join(pieces)) < room or (width("".join(pieces)) == room and at < len(pieces)):
        return "".join(pieces).rstrip(), None if column is None else width(before)
    dots = "…" if unicode else "..."
    room = max(room - 2 * len(dots), 1)
    start, end = _window(pieces, 0 if column is None else at, room)
    left, right = dots if start else "", dots if end < len(pieces) else ""
    shown = f"{left}{''.join(pieces[start:end])}{right}"
    return shown, None if column is None else width(left + "".join(pieces[start:at]))


def _window(pieces: list[str], at: int, room: int) -> tuple[int, int]:
    """The stretch of pieces around `at` that fits, the caret in its middle where the line goes on at both ends."""
    start = end = at
    used = 0
    while True:
        grown = False
        for left in (True, False):
            if not (start > 0 if left else end < len(pieces)):
                continue
            size = width(pieces[start - 1] if left else pieces[end])
            if used + size > room:
                return start, end
            used, grown = used + size, True
            start, end = (start - 1, end) if left else (start, end + 1)
        if not grown:
            return start, end
