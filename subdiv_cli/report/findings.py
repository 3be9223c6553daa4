"""The findings of the text report: each with its why and source; repetitions are printed once.

Findings skipped for the same reason are one block, and of a long series with one code only its ends are shown.
`-v` shows every one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from subdiv_cli.model import Finding, Result, Verdict
from subdiv_cli.report import marks
from subdiv_cli.report.numbers import data
from subdiv_cli.report.page import INDENT, Cell, Page, led, stacked

NARROW = 60
"""The columns below which findings are indented less."""
LONG = 6
"""The longest series that is shown in full."""
ENDS = 2
"""The number of findings that are shown at either end of a run of equal verdicts."""

Block = Finding | list[Finding] | int
"""One finding, several skipped for one reason, or the number of those left out."""


def show(page: Page, result: Result, findings: Sequence[Finding]) -> None:
    """Put all findings on a mask on the page, in their order."""
    for block in findings if page.look.verbosity > 0 else blocks(findings):
        page.blank()
        if isinstance(block, int):
            page.put(f"… {block} more; -v shows them", "quiet", indent=_indent(page))
        elif isinstance(block, list):
            _skipped(page, block)
        else:
            _finding(page, block, marks.of_finding(result, block))


def blocks(findings: Sequence[Finding]) -> Iterator[Block]:
    """The findings without repetition; a block of skipped ones stands where the first of them stands."""
    reasons: set[str] = set()
    for _, run in groupby(findings, lambda finding: finding.code):
        members = list(run)
        if len(members) > LONG:
            for _, equal in groupby(members, lambda finding: finding.verdict):
                yield from _ends(list(equal))
            continue
        for finding in members:
            alike = _alike(finding, findings)
            if len(alike) < 2:
                yield finding
            elif finding.reason and finding.reason not in reasons:
                reasons.add(finding.reason)
                yield alike


def _ends(run: list[Finding]) -> Iterator[Block]:
    hidden = len(run) - 2 * ENDS
    if hidden < 2:
        yield from run
        return
    yield from run[:ENDS]
    yield hidden
    yield from run[-ENDS:]


def _alike(finding: Finding, findings: Sequence[Finding]) -> list[Finding]:
    """All findings that were skipped for the reason of this one; empty where it was not skipped, or has no reason."""
    if finding.verdict is not Verdict.SKIPPED or not finding.reason:
        return []
    return [other for other in findings if other.verdict is Verdict.SKIPPED and other.reason == finding.reason]


def _indent(page: Page) -> int:
    return INDENT + (2 if page.look.width < NARROW else 13)


def _skipped(page: Page, findings: Sequence[Finding]) -> None:
    """Put several findings skipped for the same reason on the page: their codes and the reason."""
    indent = _indent(page)
    codes = dict.fromkeys(finding.code for finding in findings)
    mark = marks.of_verdict(Verdict.SKIPPED)
    lead = [(" " * INDENT, ""), (page.say(mark.text).ljust(indent - INDENT - 1), mark.role), (" ", "")]
    page.lines += led(lead, page.say(f"{', '.join(codes)}: {findings[0].reason}"), page.look.width, hanging=indent)


def _finding(page: Page, finding: Finding, mark: marks.Shown) -> None:
    indent, role = _indent(page), mark.role
    verdict = page.say(mark.text).ljust(indent - INDENT)
    title = f"{finding.code} {page.say(finding.name)}"
    if page.look.width >= NARROW:
        page.lines.append([(" " * INDENT, ""), (verdict, role), (title, "code")])
    else:
        page.lines += stacked(("", ""), [[Cell(verdict, role), Cell(title, "code")]], page.look.width - INDENT, INDENT)
    page.put(finding.statement, indent=indent, hanging=2)
    if finding.reason:
        page.put(f"because {finding.reason}", indent=indent, hanging=2)
    if page.look.verbosity > 1:
        for key, value in finding.witness.items():
            page.put(f"{key}: {data(value)}", indent=indent, hanging=2)
    page.put(finding.source, "quiet", indent=indent, hanging=2)
