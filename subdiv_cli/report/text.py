"""The report for people: the verdict in words, one table, the expectations, then each finding with its why and source.

One mask has the full report; several have a line each, then the full report of those that did not pass.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from subdiv_cli.model import Exponent, Finding, Judgement, Result, Verdict
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import answering
from subdiv_cli.model.properties import PROPERTIES, Property
from subdiv_cli.report import findings, words
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import at_least, at_most, finite, worth
from subdiv_cli.report.page import INDENT, Cell, Page, joined, paint


class PropertyRow(NamedTuple):
    """A row of the table: a property, whether it has it, its value or why there is none, the codes that prove it."""

    title: Cell
    verdict: Cell
    value: Cell
    proof: Cell


TITLES = ("property", "verdict", "value", "proof")


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The text of the report on these masks, in this order."""
    page = _TextReport(look)
    if look.verbosity < 0:
        yield from page.failures(results)
    elif len(results) == 1:
        page.full(results[0])
        page.closing(results[0])
    else:
        yield from page.overview(results)
    yield paint(page.lines, colour=look.colour)


class _TextReport(Page):
    """The page of the report, with a method for each of its parts."""

    # several masks

    def failures(self, results: Sequence[Result]) -> Iterator[str]:
        """Put nothing but what did not pass; the text of each mask."""
        failing = False
        for result in results:
            if result.status == "passed" or (self.look.allow_undecided and result.status == "undecided"):
                continue
            failing = True
            yield self.take()
            self.headline(result)
            self.notes(result)
            self.problems(result)
            for worse in result.regressions or ():
                self.put(f"worse than the baseline: {worse.message}", "bad", indent=INDENT, hanging=INDENT)
            for judged in result.expectations if result.regressions is None else ():
                if judged.verdict is not Verdict.PROVED:
                    self.missed(result, judged)
        if failing and len(results) > 1:
            self.put(words.footer(results, allow_undecided=self.look.allow_undecided), "head")

    def missed(self, result: Result, judged: Judgement) -> None:
        """Put an expectation that was not proved, in a line."""
        text = words.judged(result, judged, words.mark(judged.verdict))
        self.put(text, words.ROLES[judged.verdict], indent=INDENT, hanging=INDENT)

    def overview(self, results: Sequence[Result]) -> Iterator[str]:
        """Put a line for each mask, then in full those that did not pass (or all, with -v), then the counts.

        The text of each mask as soon as it is put.
        """
        if results:
            self.table(("status", "mask", "convergence", "smoothness", "Hölder exponent"), list(map(self.row, results)))
        for result in results:
            if result.status == "invalid" and not self.look.problems:
                continue  # the table has said it
            if self.look.verbosity > 0 or result.status != "passed":
                self.blank()
                self.full(result)
                self.closing(result, indent=INDENT)
                yield self.take()
        self.blank()
        self.put(words.footer(results, allow_undecided=self.look.allow_undecided), "head")

    def row(self, result: Result) -> list[Cell]:
        status = self.cell(f"{words.STATUS_MARKS[result.status]} {result.status}", words.STATUS_ROLES[result.status])
        label = self.cell(words.name(result))
        if result.status == "invalid":
            return [status, label, self.cell(words.errors(result)), self.cell(None), self.cell(None)]
        role = words.ROLES[result.convergent]
        verdict = self.cell(words.convergence(result), role)
        return [
            status,
            label,
            verdict,
            self.cell(words.smoothness_or_that_of_phi(result)),
            self.cell(words.holder(result)),
        ]

    # one mask

    def full(self, result: Result) -> None:
        """Put everything about one mask."""
        self.headline(result)
        self.about(result)
        self.problems(result)
        if result.status == "invalid":
            return
        rows = [row for row in self.properties(result) if row]
        if rows:
            self.blank()
            self.table(TITLES, list(_once(rows)))
        for line in words.figures(result, digits=self.look.verbosity > 0):
            self.put(line, "quiet", indent=INDENT, hanging=2)
        self.expectations(result)
        self.stencils(result)
        findings.show(self, self.look.shown(result.findings))

    def headline(self, result: Result) -> None:
        sign, role = words.STATUS_MARKS[result.status], words.STATUS_ROLES[result.status]
        self.put(f"{sign} {words.name(result)}: {words.headline(result)}", role, hanging=2)

    def about(self, result: Result) -> None:
        """Put file, kind, parameters, reference, then the facts."""
        items = [result.file] if result.name and result.file else []
        if result.kind:
            items.append(result.kind)
        items += [f"{name} = {rational(value)}" for name, value in result.parameters.items()]
        if result.reference:
            items.append(result.reference)
        separator = " · " if self.look.unicode else "; "
        for row in (items, words.facts(result)):
            self.lines += joined([self.say(i) for i in row], separator, self.look.width, indent=INDENT, role="quiet")
        self.notes(result)

    def notes(self, result: Result) -> None:
        """Put what a reader of the verdict must know besides: the run was stopped, the mask may be meant otherwise."""
        if result.stopped:
            self.put(f"stopped by the {result.stopped}: another run may find more or less", "open", indent=INDENT)
        for hint in result.hints:
            self.put(f"hint: {hint}", "open", indent=INDENT, hanging=6)

    def problems(self, result: Result) -> None:
        if not (self.look.problems and result.problems):
            return
        from subdiv_cli.report.problems import problem_lines

        for problem in result.problems:
            self.blank()
            self.lines += problem_lines(problem, self.look)

    def properties(self, result: Result) -> list[PropertyRow | None]:
        """The rows of the table; None for a property nothing is known of and no question was about."""
        return [row for each in PROPERTIES for row in self.rows_of(result, each)]

    def rows_of(self, result: Result, row: Property) -> list[PropertyRow | None]:
        """The row of a property; of an exponent that is only enclosed one for each bound, both with the same places."""
        exponent = result.holder or Exponent()
        if row.key != "holder" or exponent.exact is not None:
            return [self.property(result, row)]
        lower, upper = finite(exponent.lower), finite(exponent.upper)
        places = worth(lower, upper) if lower is not None and upper is not None else 6
        below = None if lower is None else at_least(lower, places)
        above = None if upper is None else words.labelled(at_most(upper, places), exponent)
        findings = [answering(result.findings, question) for question in (row.question, *row.more)]
        return [
            self.line(title, found.verdict if found else None, value, found)
            for title, value, found in zip(("Hölder, lower", "Hölder, upper"), (below, above), findings, strict=True)
        ]

    def property(self, result: Result, row: Property) -> PropertyRow | None:
        """The row of a property: proved by one finding, and shown to be sharp by others."""
        found = answering(result.findings, row.question, *row.instead)
        verdict = getattr(result, row.key) if row.form == "verdict" else found.verdict if found else None
        also = (answering(result.findings, question) for question in row.more)
        wanted = Verdict.REFUTED if row.form == "smoothness" else Verdict.PROVED
        sharp = [other for other in also if other is not None and other.verdict is wanted]
        return self.line(row.title, verdict, words.value(result, row), found, *sharp)

    def line(
        self, title: str, verdict: Verdict | None, value: str | None, found: Finding | None, *also: Finding
    ) -> PropertyRow | None:
        """The cells of title, verdict, value or reason, and codes of the findings; None where there is none of them."""
        if found is None and value is None and verdict in (None, Verdict.SKIPPED):
            return None
        if value is None and found is not None and verdict in (Verdict.SKIPPED, Verdict.UNDECIDED):
            value = found.reason
        shown = ("", "text") if verdict is None else (words.mark(verdict), words.ROLES[verdict])
        codes = ", ".join(each.code for each in (found, *also) if each is not None)
        return PropertyRow(self.cell(title), self.cell(*shown), self.cell(value), self.cell(codes, "quiet"))

    def expectations(self, result: Result) -> None:
        """Put the expectations of the mask, each judged; where it was not proved, with what holds instead."""
        if not result.expectations:
            return
        found = [words.found_instead(result, judged) for judged in result.expectations]
        rows = []
        for judged, instead in zip(result.expectations, found, strict=True):
            shown = self.cell(words.mark(judged.verdict), words.ROLES[judged.verdict])
            rows.append([self.cell(words.asked(judged.expectation)), shown, self.cell(instead)])
        self.blank()
        header = ("expected", "verdict", "found") if any(found) else ("expected", "verdict")
        self.table(header, [row[: len(header)] for row in rows])

    def stencils(self, result: Result) -> None:
        """Put the sections that have grids of numbers, with -v."""
        if self.look.verbosity < 1 or not result.sections:
            return
        from subdiv_cli.report.blocks import has_grids, put

        for section in result.sections:
            if has_grids(section):
                self.blank()
                put(self, section.blocks, result)

    def closing(self, result: Result, *, indent: int = 0) -> None:
        """Put the reason for the exit code."""
        if result.status == "invalid":
            return
        role = words.STATUS_ROLES[result.status]
        sentence = words.verdict_sentence(result, allow_undecided=self.look.allow_undecided)
        self.blank()
        self.put(f"{words.STATUS_MARKS[result.status]} {sentence}", role, indent=indent, hanging=2)
        if result.certificate is not None:
            self.unbroken(f"proof: {result.certificate}", indent=indent)


def _once(rows: Sequence[PropertyRow]) -> Iterator[PropertyRow]:
    """Keep the reason why properties were skipped in the first of theirs only."""
    told: set[str] = set()
    for row in rows:
        reason = row.value.text if row.verdict.role == words.ROLES[Verdict.SKIPPED] else ""
        yield row._replace(value=Cell("")) if reason and reason in told else row
        told.add(reason)
