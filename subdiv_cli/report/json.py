"""The report as JSON, version 1: a contract. Keys are added, never changed; the same results give the same bytes."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import subdiv_cli
from subdiv_cli.model import Data, Exponent, Finding, Interval, Judgement, Problem, Result
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import exact, finite
from subdiv_cli.report.words import found, summary

_LONG = 10**4000
"""Integers from here on are written as strings: Python does not print them as numbers."""


def render(results: Sequence[Result], look: Look) -> str:
    """The report; how it is to look is of no matter here. ASCII only where a letter is not valid Unicode."""
    report = {
        "format": "subdiv-report",
        "version": 1,
        "tool": {"name": "subdiv", "version": subdiv_cli.__version__},
        "summary": summary(results),
        "results": [_result(result) for result in results],
    }
    return strictly_unicode(json.dumps(report, ensure_ascii=False, indent=2, allow_nan=False) + "\n")


def strictly_unicode(text: str) -> str:
    """The text without lone surrogates."""
    return text if text.isascii() else "".join(map(_scalar, text))


def _scalar(letter: str) -> str:
    """A lone surrogate (a file name that is not UTF-8) has no bytes; its escape has."""
    return f"\\u{ord(letter):04x}" if "\ud800" <= letter <= "\udfff" else letter


def _result(result: Result) -> dict[str, Any]:
    return {
        "file": result.file,
        "name": result.name,
        "kind": result.kind,
        "parameters": plain(result.parameters),
        "status": result.status,
        "stopped": result.stopped,
        "errors": [_error(problem) for problem in result.problems],
        "facts": plain(result.facts),
        "sum_rule_order": result.sum_rule_order,
        "convergent": {"verdict": result.convergent.value},
        "smoothness": {"order": result.smoothness.order, "sharp": result.smoothness.sharp},
        "holder": _exponent(result.holder, attained=True),
        "sobolev": _exponent(result.sobolev, attained=False),
        "stable": {"verdict": result.stable.value},
        "linearly_independent": {"verdict": result.linearly_independent.value},
        "generation": result.generation,
        "reproduction": result.reproduction,
        "expectations": [_expectation(result, judged) for judged in result.expectations],
        "findings": [_finding(finding) for finding in result.findings],
        "certificate": result.certificate,
        "reference": result.reference,
        "refinable_function": {"order": result.refinable.order, "sharp": result.refinable.sharp},
        "hints": list(result.hints),
    }


def _error(problem: Problem) -> dict[str, Any]:
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
        "exact": None if exponent.exact is None else str(exponent.exact),
    }
    return {**shown, "attained": exponent.attained} if attained else shown


def _expectation(result: Result, judged: Judgement) -> dict[str, Any]:
    expectation = judged.expectation
    return {
        "key": expectation.key,
        "expected": expectation.text,
        "verdict": judged.verdict.value,
        "found": found(result, expectation),
    }


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "code": finding.code,
        "name": finding.name,
        "verdict": finding.verdict.value,
        "statement": finding.statement,
        "value": _value(finding.value),
        "source": finding.source,
        "reason": finding.reason,
        "witness": plain(finding.witness),
        "claims": list(finding.claims),
    }


def _value(value: Interval | None) -> dict[str, Any] | None:
    if value is None:
        return None
    return {"exact": value.exact, "lower": finite(value.lower), "upper": finite(value.upper)}


def plain(data: Data) -> Any:
    """Exact data as JSON has it: a Fraction is the string `p/q`, a tuple a list."""
    if isinstance(data, Mapping):
        return {key: plain(value) for key, value in data.items()}
    if isinstance(data, tuple | list):
        return [plain(value) for value in data]
    if isinstance(data, Fraction) or (isinstance(data, int) and abs(data) >= _LONG):
        return exact(data)
    return data


def document(result: Result) -> dict[str, Any]:
    """One result, as it stands in `results`."""
    return _result(result)
