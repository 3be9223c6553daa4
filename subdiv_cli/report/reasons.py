"""The rows of the table of properties: what is decided of each, the deciding reason, and the findings that prove it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from subdiv_cli.model import Exponent, Finding, Judgement, Result, Verdict
from subdiv_cli.model.findings import HOLDER_ATTAINED, answering
from subdiv_cli.model.properties import BY_KEY, PROPERTIES, Property
from subdiv_cli.report import marks, words
from subdiv_cli.report.numbers import at_least, at_most, finite, interval, worth


class PropertyRow(NamedTuple):
    """A row: a property, or one thing that makes it sharp."""

    title: str
    mark: marks.Shown | None
    """The verdict; None where only a number is known."""
    value: str
    why: str
    """The reason why it has the value or the verdict, or why that is not decided."""
    codes: str

    @property
    def text(self) -> str:
        """The value, and why."""
        return ": ".join(filter(None, (self.value, self.why)))

    @property
    def sentence(self) -> str:
        """Why, with the verdict unless that is proved: `C^2 refuted: φ is stable, and C^2 needs … (SD303)`."""
        verdict = "" if self.mark is None or self.mark.name == Verdict.PROVED.value else f" {self.mark.word}"
        return f"{self.title}{verdict}: {self.why} ({self.codes})"


def of_result(result: Result) -> list[PropertyRow]:
    """The rows of all properties; a reason why several are skipped stands in the first of theirs only."""
    return list(_once(reason for row in PROPERTIES for reason in of_property(result, row)))


def of_missed(result: Result, judged: Judgement) -> Iterator[PropertyRow]:
    """The rows that say why an expectation is not proved: of an order that is too low, those on the next one."""
    row, wanted = BY_KEY[judged.expectation.key], judged.expectation.lower
    rows = list(_of_holder(result, row) if row.key == "holder" else of_property(result, row))
    order = result.refinable.order
    if row.form == "smoothness" and len(rows) > 1 and order is not None:
        exceeded = judged.verdict is Verdict.REFUTED and isinstance(wanted, int) and order > wanted
        rows = rows[:1] if exceeded else rows[1:]
    yield from (each for each in rows if each.why)


def of_property(result: Result, row: Property) -> Iterator[PropertyRow]:
    """The rows of a property: what is proved of it and why, then by what it is sharp."""
    if row.key == "holder":
        yield from _of_holder(result, row)
        yield from _attained(result)
        return
    finding = answering(result.findings, row.question, *row.instead)
    beyond = (answering(result.findings, question) for question in row.more)
    sharp = next((other for other in beyond if other is not None and other.verdict is not Verdict.SKIPPED), None)
    order = result.refinable.order
    if row.form == "smoothness" and sharp is not None and order is not None:
        phi = "" if result.smoothness.order is not None else "φ: "
        yield from _reason(result, row.title, f"{phi}C^{order}", finding)
        yield from _reason(result, f"C^{order + 1}", None, sharp)
        return
    verdict = getattr(result, row.key) if row.form == "verdict" else None
    yield from _reason(result, row.title, words.value(result, row), finding, verdict=verdict)


def _of_holder(result: Result, row: Property) -> Iterator[PropertyRow]:
    """The row of an exact exponent, or one for each bound."""
    exponent = result.holder or Exponent()
    below, above = (answering(result.findings, question) for question in (row.question, *row.more))
    if exponent.exact is not None:
        shown = words.labelled(interval(exponent) or "", exponent)
        yield from _reason(result, row.title, shown, below, above)
    else:
        lower, upper = finite(exponent.lower), finite(exponent.upper)
        places = worth(lower, upper) if lower is not None and upper is not None else 6
        least = None if lower is None else at_least(lower, places)
        most = None if upper is None else words.labelled(at_most(upper, places), exponent)
        yield from _reason(result, "Hölder, lower", least, below)
        yield from _reason(result, "Hölder, upper", most, above)


def _attained(result: Result) -> Iterator[PropertyRow]:
    attained = answering(result.findings, HOLDER_ATTAINED)
    if attained is not None and attained.verdict is not Verdict.SKIPPED:
        yield from _reason(result, "attained", None, attained)


def _reason(
    result: Result, title: str, value: str | None, *findings: Finding | None, verdict: Verdict | None = None
) -> Iterator[PropertyRow]:
    """The row of what findings say, the first of which decides; none where there is nothing to say."""
    present = [each for each in findings if each is not None]
    if verdict is None and present:
        verdict = present[0].verdict
    if not present and value is None and verdict in (None, Verdict.SKIPPED):
        return
    mark = None if verdict is None else marks.of_verdict(verdict)
    if present and verdict is Verdict.REFUTED:
        mark = marks.of_finding(result, present[0])
    why = "; ".join(dict.fromkeys(why for each in present if (why := _why(each, value)) is not None))
    yield PropertyRow(title, mark, value or "", why, ", ".join(each.code for each in present))


def _why(finding: Finding, value: str | None) -> str | None:
    """Why a finding is as it is; its whole statement where it has no reason and the row no value."""
    if finding.verdict in (Verdict.SKIPPED, Verdict.UNDECIDED):
        return None if value is not None else finding.reason
    return finding.why if finding.why is not None or value is not None else finding.statement


def _once(rows: Iterable[PropertyRow]) -> Iterator[PropertyRow]:
    reasons: set[str] = set()
    for row in rows:
        skipped = row.mark is not None and row.mark.name == Verdict.SKIPPED.value
        yield row._replace(why="") if skipped and row.why in reasons else row
        reasons |= {row.why} if skipped else set()
