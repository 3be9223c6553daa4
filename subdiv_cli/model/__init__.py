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
from enum import Enum
from fractions import Fraction
from typing import Literal, NamedTuple, NoReturn

Data = None | bool | int | str | Fraction | tuple["Data", ...] | Mapping[str, "Data"]
"""Exact plain data, as facts and witnesses hold it. Floats are left out on purpose."""


class Verdict(Enum):
    """The answer to a question. Three of the four are not yes, so it refuses to be used as a bool."""

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"
    SKIPPED = "skipped"

    def __bool__(self) -> NoReturn:
        raise TypeError("a Verdict is not a bool: compare it with `is`")


class Log(NamedTuple):
    """The real number log_base(argument) / divisor, as closed forms print it."""

    base: int
    """At least 2."""
    argument: Fraction
    """Positive."""
    divisor: int = 1
    """At least 1."""

    def __str__(self) -> str:
        return f"log{self.base}({self.argument})" + (f"/{self.divisor}" if self.divisor > 1 else "")


class Root(NamedTuple):
    """A real algebraic number: the only real root of a polynomial in [low, high]."""

    coefficients: tuple[int, ...]
    """Of the polynomial, the lowest power first; degree at least 1."""
    low: Fraction
    high: Fraction


class RootLog(NamedTuple):
    """The real number -log_base(root) / divisor, root > 0 and irrational."""

    base: int
    root: Root
    divisor: int
    text: str
    """As reports spell it: `-log2(root(32*x^3+4*x-1, 0.1927, 0.1928))/2`."""

    def __str__(self) -> str:
        return self.text


LogForm = Fraction | Log
"""What an expectation can name: `2`, `log2(64/9)`."""
ClosedForm = LogForm | RootLog
"""An exponent known exactly: `2`, `log2(64/9)`, `log3(11)/2`, `-log2(root(x^2-x-1, 1.6180, 1.6181))`."""


def logarithm(base: int, argument: Fraction, divisor: int = 1) -> LogForm:
    """log_base(argument) / divisor in canonical form, so that equal numbers are equal objects.

    The base is no perfect power, argument and divisor share no root, and a rational value is a Fraction. Raises
    ValueError for base < 2, argument <= 0 or divisor < 1.
    """
    if base < 2 or argument <= 0 or divisor < 1:
        raise ValueError(f"no logarithm: base {base}, argument {argument}, divisor {divisor}")
    if argument == 1:
        return Fraction(0)
    base, divisor = unpowered(base, divisor)
    for d in (d for d in range(divisor, 1, -1) if divisor % d == 0):
        numerator = exact_root(argument.numerator, d)
        denominator = exact_root(argument.denominator, d) if numerator is not None else None
        if numerator is not None and denominator is not None:
            argument, divisor = Fraction(numerator, denominator), divisor // d
            break
    power = max(argument.numerator, argument.denominator)
    exponent = _exact_log(power, base)
    if exponent is not None and min(argument.numerator, argument.denominator) == 1:
        return Fraction(exponent if argument > 1 else -exponent, divisor)
    return Log(base=base, argument=argument, divisor=divisor)


def unpowered(base: int, divisor: int) -> tuple[int, int]:
    """(b, d) with log_base(x)/divisor = log_b(x)/d for all x, b no perfect power."""
    for e in range(base.bit_length(), 1, -1):
        if (root := exact_root(base, e)) is not None:
            return root, divisor * e
    return base, divisor


def exact_root(n: int, d: int) -> int | None:
    """The integer m >= 1 with m^d = n >= 1, by Newton's method from above."""
    root = 1 << -(-n.bit_length() // d)
    while (lower := ((d - 1) * root + n // root ** (d - 1)) // d) < root:
        root = lower
    return root if root**d == n else None


def _exact_log(n: int, base: int) -> int | None:
    """The integer e with base^e = n."""
    e = 0
    while n > 1 and n % base == 0:
        n, e = n // base, e + 1
    return e if n == 1 else None


class Interval(NamedTuple):
    """A real number enclosed: lower <= x <= upper, certified doubles rounded outward; None is unknown."""

    lower: float | None = None
    upper: float | None = None
    exact: str | None = None
    """The number itself as text, where it is known: a rational or a closed form."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """One question asked of a scheme, and its answer."""

    code: str
    """SDnnn; `subdiv explain` has a page for it."""
    name: str
    """The code in words, for instance `residue-sums`."""
    verdict: Verdict
    statement: str
    """What was decided, with its numbers; for UNDECIDED and SKIPPED what was asked."""
    source: str
    """Paper and theorem."""
    reason: str | None = None
    """Why it is undecided or skipped."""
    value: Interval | None = None
    witness: Mapping[str, Data] = field(default_factory=dict)
    """Enough to recheck the verdict without a search; the stage's docstring says what its keys mean."""
    proof: Mapping[str, Data] = field(default_factory=dict)
    """What the certificate needs besides, too long for reports: the polytope of a joint spectral radius."""
    closed: ClosedForm | None = None
    """The number that the finding is about, where it is known exactly."""
    claims: tuple[int, ...] = ()
    """The claims of the certificate that say the same, checked independently."""


class Smoothness(NamedTuple):
    """`order`: the largest n with C^n proved for all limit functions, None where convergence is not proved."""

    order: int | None = None
    sharp: bool = False
    """C^(order+1) is refuted."""


UNKNOWN = Smoothness()


class Exponent(NamedTuple):
    """A Hölder or Sobolev exponent of the refinable function: certified outward doubles, exact where it is known."""

    lower: float | None = None
    upper: float | None = None
    exact: ClosedForm | None = None
    attained: bool | None = None


ExpectationKey = Literal["convergent", "smoothness", "holder", "sobolev", "generation", "reproduction", "stable"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Expectation:
    """What a mask is held to: `key` equals `lower` (and upper == lower), is at least it (upper None), or between."""

    key: ExpectationKey
    text: str
    """As the file spells it: `true`, `1`, `>= 1.99`, `1.99 .. 2.01`."""
    lower: bool | int | LogForm
    """bool for convergent and stable; int for smoothness, generation and reproduction; a closed form for exponents."""
    upper: bool | int | LogForm | None = None


class Judgement(NamedTuple):
    """An expectation and what became of it."""

    expectation: Expectation
    verdict: Verdict
    line: int | None = None
    """Where the mask file states it, 1-based; looked up only where it is not proved."""


class Stencil(NamedTuple):
    """Σ_i weights[i] f_(first+i): what one new value takes of the data f."""

    first: int
    weights: tuple[Fraction, ...]


class Drawing(NamedTuple):
    """What a page draws of a mask: data for pictures, on which no verdict depends."""

    rules: tuple[Stencil, ...]
    """For ε = 0, …, p-1: (S f)_(pk+ε) from f_(k+first), …."""
    limit: Stencil | None = None
    """The limit stencil: S^∞f(k) from f_(k+first), …; None where convergence is not proved."""
    curve: tuple[tuple[float, float], ...] = ()
    """Points (x, φ(x)), x increasing; each is an exact value rounded once."""


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
    regressions: tuple[str, ...] | None = None
    """What is worse than in the baseline, which then decides the status; None where the baseline has no such mask."""
    drawing: Drawing | None = None
    """Made only for a format that draws it."""


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

    def allows(self, work: int) -> bool:
        """Whether a question that has cost `work` so far, its next step included, may take that step."""
        if self._deadline is not None and time.monotonic() > self._deadline:
            self.struck = True
        return not self.struck and work <= self.work
