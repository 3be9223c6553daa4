"""The report as JSON, version 1: a contract. Keys are added, never changed; the same results give the same bytes."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import subdiv_cli
from subdiv_cli.model import INFINITY, Data, Exponent, Finding, Interval, Judgement, Problem, Result, Smoothness
from subdiv_cli.model.closed import rational, spelled
from subdiv_cli.model.properties import PROPERTIES, Property
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import finite
from subdiv_cli.report.words import actual, summary

_PLACE = "results of subdiv"
"""What stands for the results while the rest of the report is spelled."""
_LONG = 10**4000
"""The integers from which on they are written as strings: Python does not print them as numbers."""


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The report as JSON; `look` does not change how it looks. ASCII only where a letter is not valid Unicode."""
    return document((as_data(result, look) for result in results), summary(results), look)


def document(results: Iterator[Mapping[str, Any]], counts: Mapping[str, int], look: Look) -> Iterator[str]:
    """The report of results that are JSON data already, a piece for each: parts of a run that are merged."""
    report: dict[str, Any] = {
        "format": "subdiv-report",
        "version": 1,
        "tool": {"name": "subdiv", "version": subdiv_cli.__version__},
        "summary": counts,
        "results": [_PLACE] if counts["files"] else [],
    }
    if look.shard is not None:
        report["shard"] = {"index": look.shard[0], "count": look.shard[1]}
    if look.missing:
        report["missing"] = list(look.missing)
    if look.interrupted:
        report["interrupted"] = True
    head, _, tail = _spelled(report).partition(json.dumps(_PLACE))
    yield head
    for number, result in enumerate(results):
        yield (",\n    " if number else "") + _spelled(result).replace("\n", "\n    ")  # no string has a line break
    yield tail + "\n"


def _spelled(data: Mapping[str, Any]) -> str:
    return valid(json.dumps(data, ensure_ascii=False, indent=2, allow_nan=False))


def valid(text: str) -> str:
    """JSON text that has bytes: a lone surrogate (a file name that is not UTF-8) has none, its escape has."""
    return text if text.isascii() else "".join(map(_scalar, text))


def _scalar(letter: str) -> str:
    return f"\\u{ord(letter):04x}" if "\ud800" <= letter <= "\udfff" else letter


def as_data(result: Result, look: Look) -> dict[str, Any]:
    """One result as JSON data."""
    return {
        "file": result.file,
        "name": result.name,
        "kind": result.kind,
        "parameters": plain(result.parameters),
        "status": result.status,
        "stopped": result.stopped,
        "errors": [as_error(problem) for problem in result.problems],
        "facts": plain(result.facts),
        **{row.key: of_property(result, row) for row in sorted(PROPERTIES, key=lambda row: row.form != "order")},
        "expectations": [_expectation(result, judged) for judged in result.expectations],
        "findings": [_finding(finding) for finding in look.shown(result.findings)],
        "certificate": result.certificate,
        "reference": result.reference,
        "refinable_function": _smoothness(result.refinable),
        "hints": list(result.hints),
        "derivatives": _derivatives(result),
        "regressions": None if result.regressions is None else [worse.message for worse in result.regressions],
    }


def of_property(result: Result, row: Property) -> Any:
    """A property of a result as JSON data."""
    given: Any = getattr(result, row.key)
    match row.form:
        case "verdict":
            return {"verdict": given.value}
        case "smoothness":
            return _smoothness(given)
        case "exponent":
            return _exponent(given, attained=row.key == "holder")
        case "order" | "degree" | "dimension":
            return given


def _derivatives(result: Result) -> list[dict[str, Any]] | None:
    """The exponents of the derivatives that a Hermite scheme converges to: that of the limit less their orders."""
    if result.derivatives is None:
        return None
    holder = result.holder or Exponent()
    orders = range(1, result.derivatives + 1)
    return [{"order": j, "holder": _exponent(holder.of_derivative(j), attained=True)} for j in orders]


def _smoothness(smooth: Smoothness) -> dict[str, Any]:
    return {"order": "infinity" if smooth.order == INFINITY else smooth.order, "sharp": smooth.sharp}


def as_error(problem: Problem) -> dict[str, Any]:
    """A problem as JSON data."""
    return {
        "code": problem.code,
        "message": problem.message,
        "key": problem.key,
        "line": problem.line,
        "column": problem.column,
        "help": problem.help,
    }


def _exponent(exponent: Exponent | None, *, attained: bool) -> dict[str, Any] | None:
    if exponent is None:
        return None
    shown: dict[str, Any] = {
        "lower": finite(exponent.lower),
        "upper": finite(exponent.upper),
        "exact": None if exponent.exact is None else spelled(exponent.exact),
    }
    if attained:
        shown |= {"attained": exponent.attained, "estimate": exponent.estimate}
    return {**shown, "digits": exponent.digits}


def _expectation(result: Result, judged: Judgement) -> dict[str, Any]:
    expectation = judged.expectation
    return {
        "key": expectation.key,
        "expected": expectation.text,
        "verdict": judged.verdict.value,
        "found": actual(result, expectation),
        "line": judged.line,
    }


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "code": finding.code,
        "name": finding.name,
        "verdict": finding.verdict.value,
        "statement": finding.statement,
        "value": as_value(finding.value),
        "source": finding.source,
        "reason": finding.reason,
        "why": finding.why,
        "witness": plain(finding.witness),
        "claims": list(finding.claims),
    }


def as_value(value: Interval | None) -> dict[str, Any] | None:
    """A number with its enclosure as JSON data."""
    if value is None:
        return None
    return {"exact": value.exact, "lower": finite(value.lower), "upper": finite(value.upper)}


def plain(data: Data) -> Any:
    """Exact data as JSON has it: a Fraction as the string `p/q`, a tuple as a list."""
    if isinstance(data, Mapping):
        return {key: plain(value) for key, value in data.items()}
    if isinstance(data, tuple | list):
        return [plain(value) for value in data]
    if isinstance(data, Fraction) or (isinstance(data, int) and abs(data) >= _LONG):
        return rational(data)
    return data
