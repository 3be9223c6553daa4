"""Notices of what did not pass: the formats that annotate files or count failures are renderings of this list."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, NamedTuple

from subdiv_cli.model import Judgement, Problem, Result, Verdict
from subdiv_cli.model.findings import answering
from subdiv_cli.model.properties import BY_KEY
from subdiv_cli.report import words
from subdiv_cli.report.look import Look

Level = Literal["error", "warning", "note"]

NOT_FILES = ("-", "--mask", "")


class Notice(NamedTuple):
    """A notice about a mask: an error fails it, a warning leaves it undecided, a note does neither."""

    level: Level
    code: str
    """A finding code, or `expect-` and the property where no code is about it alone."""
    title: str
    message: str
    line: int | None = None
    column: int | None = None


def notices(result: Result, look: Look) -> Iterator[Notice]:
    """The notices of everything that keeps a mask from passing, then those of what a reader should know besides."""
    for problem in result.problems:
        yield _problem(problem)
    if result.status != "invalid":
        yield from _gate(result, look)
    if result.stopped:
        message = f"stopped by the {result.stopped}: another run may find more"
        yield Notice("note", _code(result, "convergent"), "stopped", message)
    for hint in result.hints:
        yield Notice("note", _code(result, "convergent"), "hint", hint)


def _gate(result: Result, look: Look) -> Iterator[Notice]:
    """The notices against the baseline where there is one, else against what is expected of the mask."""
    if result.regressions is not None:
        for worse in result.regressions:
            yield Notice("error", worse.code, "worse than the baseline", worse.message)
        return
    for judged in result.expectations:
        if judged.verdict is not Verdict.PROVED:
            yield _missed(result, judged, look)
    if not result.expectations and result.status != "passed":
        level: Level = "error" if result.status == "failed" else _open(look)
        yield Notice(level, _code(result, "convergent"), "convergence", words.explained(words.headline(result)))


def _problem(problem: Problem) -> Notice:
    message = problem.message + (f" ({problem.help})" if problem.help else "")
    where = f"{problem.key}: " if problem.key else ""
    return Notice("error", problem.code, problem.code, where + message, problem.line, problem.column)


def _missed(result: Result, judged: Judgement, look: Look) -> Notice:
    """The notice of an expectation that is not proved."""
    level: Level = "error" if judged.verdict is Verdict.REFUTED else _open(look)
    key = judged.expectation.key
    message = words.judged(result, judged, judged.verdict.value)
    return Notice(level, _code(result, key), words.expected(judged.expectation), message, judged.line)


def _code(result: Result, key: str) -> str:
    """The code of the finding that an expectation is about; where there is none, one made of the key."""
    finding = answering(result.findings, BY_KEY[key].question)
    return f"expect-{key}" if finding is None else finding.code


def _open(look: Look) -> Level:
    return "note" if look.allow_undecided else "warning"


def is_file(result: Result) -> bool:
    """Whether the result is about a file that a reader can open: standard input and --mask are none."""
    return result.file not in NOT_FILES
