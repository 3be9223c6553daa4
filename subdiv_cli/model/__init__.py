"""The data that the parts of subdiv exchange: frozen, standard library only.

A stage answers a question about a scheme with a `Finding`: a `Verdict`, a statement with the numbers in it, a witness
from which anyone can recheck it without a search, and the theorem. The findings of one mask, its facts and its judged
expectations make a `Result`; a report renders results and nothing else. What is wrong with a file is a `Problem`.

Small values are named tuples, which take a tenth of the time to define that a frozen dataclass takes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Literal, NamedTuple, TypeVar

from subdiv_cli.model import watch
from subdiv_cli.model.closed import INFINITY as INFINITY
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

T = TypeVar("T")
UNKNOWN = Smoothness()


@dataclass(frozen=True, slots=True, kw_only=True)
class Expectation:
    """A condition on a mask: `key` equals `lower` (and upper == lower), is at least it (upper None), or between."""

    key: str
    """The name of the property, one of `properties.EXPECTED`."""
    text: str
    """The condition as the file spells it: `true`, `1`, `>= 1.99`, `1.99 .. 2.01`."""
    lower: bool | int | ClosedForm
    """A bool for verdicts, an int for smoothness and degrees, a closed form for exponents and infinite smoothness."""
    upper: bool | int | ClosedForm | None = None


class Judgement(NamedTuple):
    """An expectation with its verdict."""

    expectation: Expectation
    verdict: Verdict
    line: int | None = None
    """The 1-based line of the mask file that states it; looked up only where it is not proved."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """A reason why a file or an option is not usable: where, what, and how to mend it."""

    code: str
    """The code, SD0nn."""
    message: str
    """The problem in one line: what is wrong and what was expected."""
    help: str | None = None
    """The mend in one line."""
    file: str | None = None
    key: str | None = None
    """The key path, for instance `mask.coefficients[3]`."""
    line: int | None = None
    """The 1-based line, like `column`: the first character that cannot stand there. Both None where unknown."""
    column: int | None = None
    source: str | None = None
    """The text of that line."""


Status = Literal["passed", "failed", "undecided", "invalid"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Result:
    """The result of one mask: verdicts, numbers, findings and expectations; the JSON contract is a rendering of it."""

    file: str
    status: Status
    name: str | None = None
    kind: str | None = None
    parameters: Mapping[str, Fraction] = field(default_factory=dict)
    varied: tuple[str, ...] = ()
    """The parameters that have several values in this run, so that file and name alone do not tell results apart."""
    reference: str | None = None
    stopped: Literal["budget"] | None = None
    problems: tuple[Problem, ...] = ()
    facts: Mapping[str, Data] = field(default_factory=dict)
    hints: tuple[str, ...] = ()
    """The sentences on what the author of the mask may have meant; no verdict depends on them."""
    sum_rule_order: int | None = None
    convergent: Verdict = Verdict.SKIPPED
    smoothness: Smoothness = UNKNOWN
    """The smoothness of the limit functions: no order where S does not converge."""
    refinable: Smoothness = UNKNOWN
    """The smoothness of the refinable function φ, also where S diverges."""
    holder: Exponent | None = None
    sobolev: Exponent | None = None
    stable: Verdict = Verdict.SKIPPED
    linearly_independent: Verdict = Verdict.SKIPPED
    generation: int | None = None
    reproduction: int | None = None
    dimension: int | None = None
    """The dimension of the space of constants of a mask of matrices."""
    well_defined: Verdict = Verdict.SKIPPED
    polynomials: int | None = None
    spectral: Verdict = Verdict.SKIPPED
    derivatives: int | None = None
    """The number of derivatives of the limit that a Hermite scheme converges to, beside the limit itself."""
    holder_at_zero: Exponent | None = None
    """The exponent at 0 alone of a piecewise scheme."""
    expectations: tuple[Judgement, ...] = ()
    findings: tuple[Finding, ...] = ()
    certificate: str | None = None
    """The file to which the certificate was written."""
    regressions: tuple[Problem, ...] | None = None
    """The regressions from the baseline, which then decide the status; None where the baseline has no such mask."""
    sections: tuple[Section, ...] = ()
    """The stencils and pictures, made only for a format that shows them."""
    seconds: float | None = field(default=None, compare=False)
    """The seconds that it took here and now, from the cache too; None where that is not known."""


DEFAULT_EFFORT = 20_000


SEARCH, LEAST = 0.6, 0.3
"""The share of the seconds that is for the search, and the least share for the checker, also after a long step."""
HALF = 0.5
"""The share of the time left that one long step may take: what is asked after it has the other half."""


class ClockStruckError(Exception):
    """Raised in the middle of a long step when the time of the search is over: what it asked is undecided."""


Look = Callable[[], None]
"""A look at a clock. Raises ClockStruckError when it strikes."""


def no_clock() -> None:
    """Nothing: what looks at this clock has all the time."""


class Effort:
    """A bound of the work on one question: a deterministic count, and a clock as a safety net.

    The count is of elementary exact numbers: coefficients of an iterated symbol, entries of a matrix product. The
    findings of a run depend on it alone unless the clock strikes; then `struck` is True and the result says so.
    """

    def __init__(self, work: int = DEFAULT_EFFORT, seconds: float | None = None) -> None:
        self.work = work
        self.struck = False
        """Whether the clock has cut something off."""
        now = time.monotonic()
        self._ends = None if seconds is None else now + SEARCH * seconds
        self._seconds, self._last = seconds, now + (seconds or 0)
        self._over = False
        self._whole: Effort | None = None

    def limited(self, work: int, share: float = 1) -> Effort:
        """An effort of at most so much work, for one part of a question, in this share of the time that is left."""
        part = Effort(min(work, self.work))
        part._whole = self
        if share < 1 and (left := self._left()) is not None:
            part._ends = time.monotonic() + share * left
        return part

    def _left(self) -> float | None:
        """The seconds that are left for the search; None without a clock."""
        ends = [self._ends - time.monotonic()] if self._ends is not None else []
        ends += [left] if self._whole is not None and (left := self._whole._left()) is not None else []
        return min(ends, default=None)

    def allows(self, work: int) -> bool:
        """Whether a question that has cost `work` so far, its next step included, may take that step."""
        if self._whole is None:
            watch.look()
        if self._ends is not None and not self._over and time.monotonic() > self._ends:
            self._over = True
            self.strike()
        return not self._over and work <= self.work and (self._whole is None or self._whole.allows(work))

    def strike(self) -> None:
        """Note that the clock has cut something off."""
        self.struck = True
        if self._whole is not None:
            self._whole.strike()

    def look(self) -> None:
        """Look at the clock, in a long step whose work has another bound. Raises ClockStruckError when it strikes."""
        if not self.allows(0):
            raise ClockStruckError

    def in_time(self, make: Callable[[], T]) -> T | None:
        """What the function returns; None where the clock strikes in it."""
        try:
            return make()
        except ClockStruckError:
            return None

    def seconds_left(self) -> float | None:
        """The seconds that the checker has: what is left of all, at least the least share; None without a clock."""
        return None if self._seconds is None else max(LEAST * self._seconds, self._last - time.monotonic())

    def time_to_check(self) -> Callable[[], bool]:
        """Whether the checker has time left: a function to ask; its seconds begin when it is asked first."""
        ends: list[float] = []

        def goes_on() -> bool:
            if not ends and (seconds := self.seconds_left()) is not None:
                ends.append(time.monotonic() + seconds)
            return not ends or time.monotonic() <= ends[0]

        return goes_on


UNHURRIED = Effort()
"""An effort without a clock."""
