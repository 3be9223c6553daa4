"""The run of `check`: results come from the catalog, each is held to the gate and kept for the report."""

from __future__ import annotations

import sys
from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import click

from subdiv_cli.catalog.spool import Spool
from subdiv_cli.cli.options import CheckOptions
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import complain, emit, put
from subdiv_cli.model import Problem, Result
from subdiv_cli.model.findings import UNCERTIFIED
from subdiv_cli.report import renderer
from subdiv_cli.report.look import Look

if TYPE_CHECKING:
    from subdiv_cli.catalog.baseline import Baseline
    from subdiv_cli.catalog.task import Done
    from subdiv_cli.maskfile import MaskFile


class Run:
    """A run: its results so far, and how it ended."""

    def __init__(self, options: CheckOptions, look: Look) -> None:
        self.options, self.look = options, look
        self.results = Spool[Result]()
        self.problems: list[Problem] = []
        self.interrupted = False
        self.ended = False
        """Whether --maxfail has ended the run before all masks were checked."""
        self.printed = True
        self.forms = {options.form, *(output.format or options.form for output in options.outputs)}
        self.baseline = _baseline(options.baseline)
        self.unproved: list[str] = []
        """What certificates that were asked for leave out, a sentence for each mask."""
        self.unwritten: dict[str, str] = {}
        """The reason why the certificate of a file could not be written."""
        self._failing = 0
        self._trouble: str | None = None
        self._progress = Progress()

    def go(self, targets: list[str | MaskFile] | Result, arguments: Mapping[str, Any]) -> None:
        """Check all targets; afterwards the results are there, and what is streamed is written."""
        stream = self._checked(targets, arguments)
        with self._progress.watching():
            try:
                for result in stream:
                    self._take(result)
                    if self._failing == self.options.maxfail:
                        stream.close()
            except KeyboardInterrupt:
                self.interrupted = True
                self._take_rest(stream)
        left = self._progress.total - len(self.results)
        if self._failing == self.options.maxfail and left > 0 and not self.interrupted:
            self.ended = True
            count = f"{left} mask{'' if left == 1 else 's'}"
            emit(f"stopped by --maxfail {self.options.maxfail}: {count} not checked\n", sys.stderr)
        if self._trouble is not None:
            emit(f"note: results cannot be kept in the cache: {self._trouble}\n", sys.stderr)
        if self.options.verbose:
            self._progress.tell()

    def missing(self) -> tuple[str, ...]:
        """The masks of the baseline that a whole run has not."""
        partial = self.interrupted or self.ended or self.options.shard is not None
        return () if self.baseline is None or partial else self.baseline.missing()

    def _take_rest(self, stream: Generator[Result, None, None]) -> None:
        """Take the results that were done and waiting for their turn when Ctrl-C came.

        There are none if the stream knew of it and has ended.
        """
        with suppress(KeyboardInterrupt, StopIteration):
            self._take(stream.throw(KeyboardInterrupt()))
            for result in stream:
                self._take(result)

    def _checked(
        self, targets: list[str | MaskFile] | Result, arguments: Mapping[str, Any]
    ) -> Generator[Result, None, None]:
        """The results in order."""
        if isinstance(targets, Result):
            yield targets
            return
        from subdiv_cli.catalog import ClusterError
        from subdiv_cli.catalog.run import check_all

        try:
            yield from check_all(targets, **arguments, **self._listeners())
        except ClusterError as error:
            raise click.ClickException(str(error)) from None
        except OSError as error:
            raise click.ClickException(f"certificates cannot be written: {error}") from None

    def _listeners(self) -> dict[str, Any]:
        listeners: dict[str, Any] = {"on_total": self._progress.begin, "on_done": self._hear}
        if self.options.certificates is not None:
            listeners["on_unwritten"] = self.unwritten.setdefault
        if self.options.verbose:
            listeners["on_skipped"] = _tell_skipped
        if "html" in self.forms or ("text" in self.forms and self.options.verbosity > 0):
            listeners["sections"] = True
        return listeners

    def _hear(self, done: Done) -> None:
        self._progress.step(done)
        self._trouble = self._trouble or done.trouble

    def _take(self, result: Result) -> None:
        """Hold a result to the baseline, write it where lines are streamed, and keep what the report will need."""
        if self.baseline is not None:
            result = self.baseline.judge(result)
        if self.options.form == "jsonl" and not self.options.statistics:
            self._progress.close()
            self.printed &= put(renderer("jsonl")([result], self.look), encoding="utf-8")
        if self.options.certificates is not None and result.status != "invalid" and result.file not in self.unwritten:
            self.unproved += _left_out(result)
        self.problems += result.problems
        allowed = result.status == "undecided" and self.options.allow_undecided
        self._failing += result.status != "passed" and not allowed
        self.results.append(result)


def _left_out(result: Result) -> Iterator[str]:
    """What the certificate of a mask does not prove, and why."""
    if result.certificate is None:
        yield f"there is no certificate of {result.file}: nothing is proved of it"
        return
    for reason in UNCERTIFIED:
        codes = dict.fromkeys(finding.code for finding in result.findings if finding.reason == reason)
        if codes:
            yield f"{result.certificate} leaves out {', '.join(codes)}: {reason}"


def _tell_skipped(skipped: int, left_out: int) -> None:
    if skipped:
        emit(f"skipped {skipped} TOML file{'' if skipped == 1 else 's'} without kind or mask\n", sys.stderr)
    if left_out:
        emit(f"left out {left_out} that git ignores, or exclude has a pattern for\n", sys.stderr)


def _baseline(file: str | None) -> Baseline | None:
    if file is None:
        return None
    from subdiv_cli.catalog.baseline import Baseline
    from subdiv_cli.catalog.reports import ReportError, read_report

    try:
        return Baseline(read_report(file).results)
    except ReportError as error:
        raise click.exceptions.Exit(complain([error.problem])) from None


def tell_missing(missing: Sequence[str]) -> None:
    """Write which masks of the baseline were not checked."""
    if missing:
        shown = ", ".join(missing[:10]) + (f" and {len(missing) - 10} more" if len(missing) > 10 else "")
        count = f"{len(missing)} mask{'' if len(missing) == 1 else 's'}"
        emit(f"note: {count} of the baseline not checked: {shown}\n", sys.stderr)
