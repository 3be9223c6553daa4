"""A line per finding, to grep in: `file: SD201 convergence proved: statement`, `file:3:19: error[SD003] message`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from subdiv_cli.model import Finding, Problem, Result, Verdict
from subdiv_cli.report.letters import letters
from subdiv_cli.report.look import Look
from subdiv_cli.report.words import asked, finding, footer


def render(results: Sequence[Result], look: Look) -> str:
    """The lines of all results; nothing is wrapped. Below verbosity 0 only those that did not pass."""
    lines: list[str] = []
    for result in results:
        if look.verbosity >= 0 or result.status != "passed":
            lines += _lines(result)
    if look.verbosity >= 0 and len(results) != 1:
        lines.append(footer(results, allow_undecided=look.allow_undecided))
    return "".join(letters(line, look.unicode) + "\n" for line in lines)


def _lines(result: Result) -> Iterator[str]:
    for problem in result.problems:
        yield problem_line(problem, result.file)
    for found in result.findings:
        yield f"{result.file}: {_finding(found)}"
    for judged in result.expectations:
        yield f"{result.file}: expected {asked(judged.expectation)} {judged.verdict.value}"
    if result.stopped:
        yield f"{result.file}: stopped by the {result.stopped}"
    if not result.problems and finding(result, "SD201") is None and not result.expectations:
        yield f"{result.file}: {result.status}"


def _finding(found: Finding) -> str:
    text = f"{found.code} {found.name} {found.verdict.value}: {found.statement}"
    asks = found.verdict in (Verdict.UNDECIDED, Verdict.SKIPPED)
    return f"{text} ({found.reason})" if asks and found.reason else text


def problem_line(problem: Problem, file: str) -> str:
    """`file:3:19: error[SD003] message (help)`, as much of the place as is known."""
    place = ":".join(str(part) for part in (problem.file or file, problem.line, problem.column) if part is not None)
    return f"{place}: error[{problem.code}] {problem.message}" + (f" ({problem.help})" if problem.help else "")
