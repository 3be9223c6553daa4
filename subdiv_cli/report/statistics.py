"""The statistics of a run: how many masks did not pass for which reason, the most frequent first."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from subdiv_cli.model import Result
from subdiv_cli.report import words
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import Notice, notices
from subdiv_cli.report.page import Page, paint

_TITLES = ("masks", "code", "property", "verdict", "reason")


class Cause(NamedTuple):
    """A reason why masks did not pass."""

    code: str
    property: str
    """The property that is expected; empty for an error in a file."""
    verdict: str
    """The outcome: refuted, undecided, invalid, or worse than the baseline."""
    reason: str
    """The reason why it is undecided."""


def as_text(results: Sequence[Result], look: Look) -> str:
    """A table of the reasons, and the counts of the masks."""
    page = Page(look)
    rows = [[page.cell(str(count)), *map(page.cell, cause)] for cause, count in _counted(results, look)]
    if rows:
        page.table(_TITLES, rows)
        page.blank()
    page.put(words.footer(results, allow_undecided=look.allow_undecided), "head")
    return paint(page.lines, colour=look.colour)


def as_json(results: Sequence[Result], look: Look) -> str:
    """The same as JSON."""
    shown = [{"masks": count, **cause._asdict()} for cause, count in _counted(results, look)]
    report = {"format": "subdiv-statistics", "version": 1, "summary": words.summary(results), "statistics": shown}
    return json.dumps(report, ensure_ascii=False, indent=2) + "\n"


def _counted(results: Sequence[Result], look: Look) -> list[tuple[Cause, int]]:
    """The reasons, each with the number of its masks."""
    counts = Counter[Cause]()
    for result in results:
        counts.update(dict.fromkeys(_causes(result, look), 1))
    return sorted(counts.items(), key=lambda item: (-item[1], item[0]))


def _causes(result: Result, look: Look) -> Iterator[Cause]:
    for notice in notices(result, look):
        if notice.level != "note":
            yield _cause(result, notice)


def _cause(result: Result, notice: Notice) -> Cause:
    if result.status == "invalid":
        return Cause(notice.code, "", "invalid", "")
    if result.regressions is not None:
        return Cause(notice.code, "baseline", "worse", "")
    key, verdict = notice.title.split(" ")[0], "refuted" if notice.level == "error" else "undecided"
    reasons = (finding.reason for finding in result.findings if finding.code == notice.code and finding.reason)
    return Cause(notice.code, key, verdict, next(reasons, "") if verdict == "undecided" else "")
