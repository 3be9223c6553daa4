"""The report as JUnit XML, which CI servers read: a test suite for each mask, a test case for each expectation.

A refuted expectation is a failure, and an undecided one too, unless undecided is allowed: then it is skipped. An
invalid mask is an error. A mask without expectations has the one test case `convergent`. A mask is analysed once for
all its expectations, so each has an equal part of its time; a merged report has no times.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple
from xml.etree import ElementTree as Xml

from subdiv_cli.model import Result, Verdict
from subdiv_cli.report import words
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import notices

_NEXT = "\n  "
"""What stands before each suite."""
_COUNTED = ("failure", "error", "skipped")


class Case(NamedTuple):
    """A test case: its name, and where it was not passed the outcome and the reason."""

    name: str
    outcome: str | None = None
    """The outcome: failure, error or skipped; None where it passed."""
    kind: str = ""
    message: str = ""


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The XML document. But for its times the same results give the same bytes."""
    totals = Counter[str | None]()
    for result in results:
        totals.update(case.outcome for case in _cases(result, look))
    counts = {"tests": totals.total(), "failures": totals["failure"], "errors": totals["error"]}
    root = Xml.Element("testsuites", {"name": "subdiv", **{key: str(count) for key, count in counts.items()}})
    root.text = _NEXT if results else None
    head, end, tail = Xml.tostring(root, encoding="unicode").partition("</")
    yield f'<?xml version="1.0" encoding="UTF-8"?>\n{head.removesuffix(_NEXT)}'
    for result in results:
        suite = _suite(result, list(_cases(result, look)))
        Xml.indent(suite, level=1)
        yield _NEXT + Xml.tostring(suite, encoding="unicode")
    yield f"\n{end}{tail}\n" if results else "\n"


def _suite(result: Result, cases: Sequence[Case]) -> Xml.Element:
    counts = {kind: sum(case.outcome == kind for case in cases) for kind in _COUNTED}
    shown = {
        "name": clean(words.name(result)),
        "tests": str(len(cases)),
        "failures": str(counts["failure"]),
        "errors": str(counts["error"]),
        "skipped": str(counts["skipped"]),
    }
    suite = Xml.Element("testsuite", {**shown, **_time(result.seconds)})
    share = None if result.seconds is None else result.seconds / len(cases)
    for case in cases:
        named = {"classname": clean(words.place(result) or "mask"), "name": clean(case.name)}
        node = Xml.SubElement(suite, "testcase", {**named, **_time(share)})
        if case.outcome is not None:
            shown = {"message": clean(case.message)}
            why = Xml.SubElement(node, case.outcome, {"type": case.kind, **shown} if case.kind else shown)
            why.text = clean(case.message)
    suite_out = Xml.SubElement(suite, "system-out")
    suite_out.text = clean(words.headline(result))
    return suite


def _time(seconds: float | None) -> dict[str, str]:
    return {} if seconds is None else {"time": f"{seconds:.3f}"}


def _cases(result: Result, look: Look) -> Iterator[Case]:
    if result.status == "invalid":
        for notice in notices(result, look):
            place = "" if notice.line is None else f" (line {notice.line})"
            yield Case("mask file", "error", notice.code, notice.message + place)
        return
    if result.regressions is not None:
        worse = "; ".join(regression.message for regression in result.regressions)
        yield (
            Case("no worse than the baseline", "failure", "baseline", worse)
            if worse
            else Case("no worse than the baseline")
        )
        return
    for judged in result.expectations:
        name = words.expected(judged.expectation)
        if judged.verdict is Verdict.PROVED:
            yield Case(name)
        else:
            yield _missed(name, judged.verdict, words.judged(result, judged, judged.verdict.value), look)
    if not result.expectations:
        passed = result.convergent is Verdict.PROVED
        why = words.explained(words.headline(result))
        yield Case("convergent") if passed else _missed("convergent", result.convergent, why, look)


def _missed(name: str, verdict: Verdict, message: str, look: Look) -> Case:
    if verdict is not Verdict.REFUTED and look.allow_undecided:
        return Case(name, "skipped", "", message)
    return Case(name, "failure", verdict.value, message)
