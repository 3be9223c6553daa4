"""The concise report: a line per finding, for grep.

`file: SD201 convergence proved: statement`, `file:3:19: error[SD003] message`. After the findings the expectations:
`file: expected smoothness = 3: refuted, found C^2, not C^3`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from subdiv_cli.model import Finding, Judgement, Problem, Result, Verdict
from subdiv_cli.model.findings import CONVERGENCE, answering
from subdiv_cli.report import words
from subdiv_cli.report.letters import letters
from subdiv_cli.report.look import Look


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The lines of all results; nothing is wrapped. Below verbosity 0 only what did not pass, and no findings."""
    for result in results:
        allowed = look.allow_undecided and result.status == "undecided"
        if look.verbosity >= 0:
            yield _text(_lines(result, look), look)
        elif result.status != "passed" and not allowed:
            yield _text(_missed(result), look)
    if look.verbosity >= 0 and len(results) != 1:
        yield _text([words.footer(results, allow_undecided=look.allow_undecided)], look)


def _text(lines: Iterable[str], look: Look) -> str:
    return "".join(letters(line, look.unicode) + "\n" for line in lines)


def _lines(result: Result, look: Look) -> Iterator[str]:
    yield from _problems(result)
    for finding in look.shown(result.findings):
        yield f"{words.place(result)}: {_finding(finding)}"
    yield from _judged(result, result.expectations)
    yield from _regressions(result)
    yield from _notes(result)
    if not result.problems and answering(result.findings, CONVERGENCE) is None and not result.expectations:
        yield f"{words.place(result)}: {result.status}"


def _missed(result: Result) -> Iterator[str]:
    """The lines that tell why a mask did not pass."""
    yield from _problems(result)
    if result.regressions is not None:
        yield from _regressions(result)
    else:
        yield from _judged(result, (judged for judged in result.expectations if judged.verdict is not Verdict.PROVED))
    if not result.problems and not result.expectations:
        yield f"{words.place(result)}: {words.verdict_sentence(result)}"
    yield from _notes(result)


def _problems(result: Result) -> Iterator[str]:
    for problem in result.problems:
        yield problem_line(problem, words.place(result))


def _regressions(result: Result) -> Iterator[str]:
    for worse in result.regressions or ():
        yield f"{words.place(result)}: worse than the baseline: {worse.message}"


def _judged(result: Result, judgements: Iterable[Judgement]) -> Iterator[str]:
    for judged in judgements:
        yield f"{words.place(result)}: {words.judged(result, judged, judged.verdict.value)}"


def _notes(result: Result) -> Iterator[str]:
    if result.stopped:
        yield f"{words.place(result)}: stopped by the {result.stopped}"
    for hint in result.hints:
        yield f"{words.place(result)}: hint: {hint}"


def _finding(finding: Finding) -> str:
    text = f"{finding.code} {finding.name} {finding.verdict.value}: {finding.statement}"
    asks = finding.verdict in (Verdict.UNDECIDED, Verdict.SKIPPED)
    return f"{text} ({finding.reason})" if asks and finding.reason else text


def problem_line(problem: Problem, file: str) -> str:
    """The line of a problem, as much of the place as is known: `file:3:19: error[SD003] message (help)`."""
    place = ":".join(str(part) for part in (problem.file or file, problem.line, problem.column) if part is not None)
    return f"{place}: error[{problem.code}] {problem.message}" + (f" ({problem.help})" if problem.help else "")
