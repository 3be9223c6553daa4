"""The report for people: the answer in words, a table of properties each with its reason, the expectations, the answer.

One mask takes one screen, and with -v every finding with its theorem and source. Several have a line each, and those
that did not pass the few lines that say why; with -v all have their full reports.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from subdiv_cli.model import Judgement, Result, Verdict
from subdiv_cli.model.closed import rational
from subdiv_cli.report import findings, marks, reasons, words
from subdiv_cli.report.look import Look
from subdiv_cli.report.page import INDENT, Cell, Page, joined, paint

TITLES = ("property", "verdict", "value, and why", "proof")
_EFFORT = "a higher --effort may decide what is undecided"


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
        """Put nothing but what did not pass; the text of each mask as soon as it is put."""
        yield from self.why(filter(self.is_failing, results))
        failing = any(map(self.is_failing, results))
        if failing and len(results) > 1:
            self.counts(results)

    def overview(self, results: Sequence[Result]) -> Iterator[str]:
        """Put a line for each mask, then why some did not pass (or all in full, with -v), then the counts.

        The text of each mask as soon as it is put.
        """
        if results:
            self.table(("status", "mask", "convergence", "smoothness", "Hölder exponent"), list(map(self.row, results)))
        if self.look.verbosity > 0:
            for result in results:
                if result.status != "invalid" or self.look.problems:  # else the table has said it
                    self.blank()
                    self.full(result)
                    self.closing(result, indent=INDENT)
                    yield self.take()
        else:
            statuses = ("passed", "invalid")
            yield from self.why(each for each in results if each.status not in statuses or self.tells(each))
        self.blank()
        self.counts(results)

    def tells(self, result: Result) -> bool:
        """Whether there is something to read of an invalid mask here."""
        return result.status == "invalid" and self.look.problems

    def is_failing(self, result: Result) -> bool:
        return result.status != "passed" and not (self.look.allow_undecided and result.status == "undecided")

    def why(self, results: Iterable[Result]) -> Iterator[str]:
        """Put the few lines that say why each of these masks did not pass, and what the symbols in them mean.

        The text of each mask as soon as it is put.
        """
        sentences: list[str] = []
        for result in results:
            if self.look.verbosity >= 0:
                self.blank()
            sentences += self.failure(result)
            yield self.take()
        if sentences and self.look.verbosity >= 0:
            self.blank()
        self.legend(sentences)

    def failure(self, result: Result) -> list[str]:
        """Put why a mask did not pass; returns the lines with symbols in them."""
        self.headline(result)
        self.items([*([result.file] if result.name else []), *_parameters(result)])
        self.notes(result)
        self.problems(result)
        self.regressions(result)
        missed = [judged for judged in result.expectations if judged.verdict is not Verdict.PROVED]
        sentences = [words.headline(result)]
        for judged in missed if result.regressions is None else ():
            self.missed(result, judged)
            for reason in reasons.of_missed(result, judged):
                if not any(reason.why in earlier for earlier in sentences):
                    self.put(reason.sentence, indent=2 * INDENT, hanging=INDENT)
                    sentences.append(reason.sentence)
        return sentences

    def regressions(self, result: Result) -> None:
        """Put what is worse than in the baseline, in a line each."""
        for worse in result.regressions or ():
            self.put(f"worse than the baseline: {worse.message}", "bad", indent=INDENT, hanging=INDENT)

    def missed(self, result: Result, judged: Judgement) -> None:
        """Put an expectation that was not proved, in a line."""
        mark = marks.of_verdict(judged.verdict)
        where = "" if judged.line is None else f" (line {judged.line})"
        self.put(words.judged(result, judged, mark.text) + where, mark.role, indent=INDENT, hanging=INDENT)

    def counts(self, results: Sequence[Result]) -> None:
        """Put the counts, and what may decide what is undecided."""
        if not self.look.allow_undecided and any(result.status == "undecided" for result in results):
            self.put(f"{_EFFORT}; --allow-undecided lets it pass", "quiet")
        self.put(words.footer(results, allow_undecided=self.look.allow_undecided), "head")

    def row(self, result: Result) -> list[Cell]:
        mark = marks.of_status(result.status)
        status = self.cell(mark.text, mark.role)
        label = self.cell(words.name(result))
        if result.status == "invalid":
            return [status, label, self.cell(words.errors(result)), self.cell(None), self.cell(None)]
        return [
            status,
            label,
            self.cell(words.convergence(result), marks.of_verdict(result.convergent).role),
            self.cell(words.smoothness_or_that_of_phi(result)),
            self.cell(words.holder(result)),
        ]

    # one mask

    def full(self, result: Result) -> None:
        """Put one mask on a screen; with -v, or where findings are selected, the findings too."""
        self.headline(result)
        self.about(result)
        self.problems(result)
        if result.status == "invalid":
            return
        if rows := reasons.of_result(result):
            self.blank()
            self.table(TITLES, [self.reason(row) for row in rows])
            self.legend(row.text for row in rows)
        for line in words.figures(result, digits=self.look.verbosity > 0):
            self.put(line, "quiet", indent=INDENT, hanging=2)
        self.expectations(result)
        self.stencils(result)
        if self.look.verbosity > 0 or self.look.select:
            findings.show(self, result, self.look.shown(result.findings))

    def reason(self, row: reasons.PropertyRow) -> list[Cell]:
        verdict = self.cell(None) if row.mark is None else self.cell(row.mark.text, row.mark.role)
        return [self.cell(row.title), verdict, self.cell(row.text), self.cell(row.codes, "quiet")]

    def headline(self, result: Result) -> None:
        mark = marks.of_status(result.status)
        self.put(f"{mark.sign} {words.name(result)}: {words.headline(result)}", mark.role, hanging=2)

    def about(self, result: Result) -> None:
        """Put file, kind, parameters, reference, then the facts."""
        about = [result.file if result.name else "", result.kind or "", *_parameters(result), result.reference or ""]
        self.items(filter(None, about))
        self.items(words.facts(result))
        self.notes(result)

    def items(self, items: Iterable[str]) -> None:
        """Put short texts in a row."""
        separator = " · " if self.look.unicode else "; "
        self.lines += joined([self.say(i) for i in items], separator, self.look.width, indent=INDENT, role="quiet")

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

    def legend(self, texts: Iterable[str]) -> None:
        """Put what the symbols in these texts mean."""
        if (meanings := words.legend(texts)) is not None:
            self.put(f"({meanings})", "quiet", indent=INDENT, hanging=1)

    def expectations(self, result: Result) -> None:
        """Put the expectations: those proved in a row, each other one in a line, with what holds instead.

        Where there is a baseline also what is worse.
        """
        if not result.expectations and not result.regressions:
            return
        self.blank()
        proved = [judged for judged in result.expectations if judged.verdict is Verdict.PROVED]
        if proved:
            self.items(
                f"{'expected and proved: ' if judged is proved[0] else ''}{words.expected_briefly(judged.expectation)}"
                for judged in proved
            )
        for judged in result.expectations:
            if judged.verdict is not Verdict.PROVED:
                self.missed(result, judged)
        self.regressions(result)

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
        """Put the answer once more, with the reason for the exit code."""
        if result.status == "invalid":
            return
        mark = marks.of_status(result.status)
        sentence = words.verdict_sentence(result, allow_undecided=self.look.allow_undecided)
        self.blank()
        if result.status == "undecided" and not self.look.allow_undecided:
            self.put(_EFFORT, "quiet", indent=indent + INDENT)
        self.put(f"{mark.sign} {sentence}", mark.role, indent=indent, hanging=2)
        if result.certificate is not None:
            self.unbroken(f"proof: {result.certificate}", indent=indent)


def _parameters(result: Result) -> list[str]:
    return [f"{name} = {rational(value)}" for name, value in result.parameters.items()]
