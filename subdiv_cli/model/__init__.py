"""What the parts of subdiv say to each other: frozen data, standard library only.

A stage answers a question about a scheme with a `Finding`: a `Verdict`, a statement with the numbers in it, a witness
from which anyone can recheck it without a search, and the theorem. The findings of one mask, its facts and its judged
expectations make a `Result`; a report renders results and nothing else. What is wrong with a file is a `Problem`.
Small values are named tuples, which take a tenth of the time to define that a frozen dataclass takes.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Literal, NamedTuple

from subdiv_cli.model.closed import ClosedForm as ClosedForm
from subdiv_cli.model.closed import Log as Log
from subdiv_cli.model.closed import LogForm as LogForm
from subdiv_cli.model.closed import Root as Root
from subdiv_cli.model.closed import RootLog as RootLog
from subdiv_cli.model.closed import exact_root as exact_root
from subdiv_cli.model.closed import logarithm as logarithm
from subdiv_cli.model.closed import unpowered as unpowered
from subdiv_cli.model.findings import DECIDED as DECIDED
from subdiv_cli.model.findings import Answer as Answer
from subdiv_cli.model.findings import Data as Data
from subdiv_cli.model.findings import Exponent as Exponent
from subdiv_cli.model.findings import Finding as Finding
from subdiv_cli.model.findings import Interval as Interval
from subdiv_cli.model.findings import Question as Question
from subdiv_cli.model.findings import Rule as Rule
from subdiv_cli.model.findings import Smoothness as Smoothness
from subdiv_cli.model.findings import Verdict as Verdict

if TYPE_CHECKING:
    from subdiv_cli.model.blocks import Section

UNKNOWN = Smoothness()


@dataclass(frozen=True, slots=True, kw_only=True)
class Expectation:
    """What a mask is held to: `key` equals `lower` (and upper == lower), is at least it (upper None), or between."""

    key: str
    """One of `properties.EXPECTED`."""
    text: str
    """As the file spells it: `true`, `1`, `>= 1.99`, `1.99 .. 2.01`."""
    lower: bool | int | ClosedForm
    """bool for convergent and stable; int for smoothness, generation and reproduction; a closed form for exponents."""
    upper: bool | int | ClosedForm | None = None


class Judgement(NamedTuple):
    """An expectation and what became of it."""

    expectation: Expectation
    verdict: Verdict
    line: int | None = None
    """Where the mask file states it, 1-based; looked up only where it is not proved."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """Why a file or an option was not usable: where, what, and how to mend it."""

    code: str
    """SD0nn."""
    message: str
    """What is wrong and what was expected, in one line."""
    help: str | None = None
    """How to mend it, in one line."""
    file: str | None = None
    key: str | None = None
    """Key path, for instance `mask.coefficients[3]`."""
    line: int | None = None
    """1-based, like `column`: the first character that cannot stand there. Both None where unknown."""
    column: int | None = None
    source: str | None = None
    """The text of that line."""


Status = Literal["passed", "failed", "undecided", "invalid"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Result:
    """Everything that is said about one mask; the JSON contract is a rendering of it."""

    file: str
    status: Status
    name: str | None = None
    kind: str | None = None
    parameters: Mapping[str, Fraction] = field(default_factory=dict)
    reference: str | None = None
    stopped: Literal["budget"] | None = None
    problems: tuple[Problem, ...] = ()
    facts: Mapping[str, Data] = field(default_factory=dict)
    hints: tuple[str, ...] = ()
    """What the author of the mask may have meant; no verdict depends on them."""
    sum_rule_order: int | None = None
    convergent: Verdict = Verdict.SKIPPED
    smoothness: Smoothness = UNKNOWN
    """Of the limit functions: no order where S does not converge."""
    refinable: Smoothness = UNKNOWN
    """Of the refinable function φ, also where S diverges."""
    holder: Exponent | None = None
    sobolev: Exponent | None = None
    stable: Verdict = Verdict.SKIPPED
    linearly_independent: Verdict = Verdict.SKIPPED
    generation: int | None = None
    reproduction: int | None = None
    expectations: tuple[Judgement, ...] = ()
    findings: tuple[Finding, ...] = ()
    certificate: str | None = None
    """The file it was written to."""
    regressions: tuple[Problem, ...] | None = None
    """What is worse than in the baseline, which then decides the status; None where the baseline has no such mask."""
    sections: tuple[Section, ...] = ()
    """Stencils and pictures, made only for a format that shows them."""


DEFAULT_EFFORT = 20_000


class Effort:
    """How much work one question may cost: a deterministic count, and a clock as a safety net.

    The count is of elementary exact numbers: coefficients of an iterated symbol, entries of a matrix product. What a
    run finds depends on it alone unless the clock strikes; then `struck` is True and the result says so.
    """

    def __init__(self, work: int = DEFAULT_EFFORT, seconds: float | None = None) -> None:
        self.work = work
        self.struck = False
        self._deadline = None if seconds is None else time.monotonic() + seconds
        self._whole: Effort | None = None

    def limited(self, work: int) -> Effort:
        """At most so much of it, for one part of a question; the clock is the same."""
        part = Effort(min(work, self.work))
        part._whole = self
        return part

    def allows(self, work: int) -> bool:
        """Whether a question that has cost `work` so far, its next step included, may take that step."""
        if self._whole is not None:
            return work <= self.work and self._whole.allows(work)
        if self._deadline is not None and time.monotonic() > self._deadline:
            self.struck = True
        return not self.struck and work <= self.work
