"""The protocol of a kind of scheme, and what is the same for every kind: running stages and gathering findings.

A kind is a folder with one light object, `KIND`, a `Kind`: what it declares it can do, what it does not declare it
cannot. A stage is a pure function `run(numbers, facts)`: it uses the numbers of the scheme, each computed once, and
the verdicts of earlier stages, and answers with findings.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import wraps
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, cast

from subdiv_cli.model import (
    INFINITY,
    Answer,
    ClockStruckError,
    Data,
    Effort,
    Exponent,
    Finding,
    Question,
    Result,
    Rule,
    Smoothness,
    Verdict,
    watch,
)
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import Form, answering

if TYPE_CHECKING:
    from subdiv_cli.certificate import Proofs
    from subdiv_cli.maskfile.entries import Table
    from subdiv_cli.maskfile.mask import Body
    from subdiv_cli.maskfile.problems import Collector
    from subdiv_cli.model.blocks import Drawing, Portrait, Section


class Scheme(Protocol):
    """A mask at the values of its parameters; `kind` is the name of its kind."""

    @property
    def kind(self) -> str:
        """The name of the kind, a key of `KINDS`."""


class ContradictionError(Exception):
    """Raised where two theorems disagree about one scheme: an error in this program, never in the input."""


class Facts:
    """The findings of the stages before, by rule; a rule may have several, one for each ν."""

    def __init__(self, findings: Iterable[Finding] = ()) -> None:
        self._by_code: dict[str, tuple[Finding, ...]] = {}
        self.add(findings)

    def add(self, findings: Iterable[Finding]) -> None:
        """Add the findings of a stage."""
        for finding in findings:
            self._by_code[finding.code] = (*self.all(finding.code), finding)

    def all(self, rule: Rule[Any] | str) -> tuple[Finding, ...]:
        """Every finding of a rule, given itself or by its code."""
        return self._by_code.get(rule if isinstance(rule, str) else rule.code, ())

    def find(self, rule: Rule[Any] | str) -> Finding | None:
        """The first finding of a rule, None without one."""
        return next(iter(self.all(rule)), None)

    def __getitem__(self, rule: Rule[Any] | str) -> Finding:
        """The first finding of a rule. Raises KeyError without one."""
        return self._by_code[rule if isinstance(rule, str) else rule.code][0]

    def __contains__(self, rule: Rule[Any] | str) -> bool:
        return bool(self.all(rule))

    def verdict(self, rule: Rule[Any]) -> Verdict:
        """The verdict of the first finding of a rule, UNDECIDED without one."""
        return self[rule].verdict if rule in self else Verdict.UNDECIDED

    def witness(self, rule: Rule[Form]) -> Form:
        """The witness of the first finding of a rule. Raises KeyError without one, ValueError where it has none."""
        return rule.witness_of(self[rule])

    def findings(self) -> tuple[Finding, ...]:
        """All findings, those of one rule together."""
        return tuple(finding for several in self._by_code.values() for finding in several)


Stage = Callable[[Any, Facts], tuple[Finding, ...]]
"""A stage: from the numbers of its kind, and the findings before, to its findings."""
TIME_ENDED = "the time budget ended"


def asking(*questions: tuple[Rule[Any], str]) -> Callable[[Stage], Stage]:
    """A decorator of a stage whose numbers have an `effort`: what the clock leaves undecided says so.

    Where it strikes in the middle, the stage finds that each of the rules leaves its question undecided.
    """

    def decorate(stage: Stage) -> Stage:
        @wraps(stage)
        def run(numbers: Any, facts: Facts) -> tuple[Finding, ...]:
            try:
                findings = stage(numbers, facts)
            except ClockStruckError:
                return tuple(rule.undecided(question, TIME_ENDED) for rule, question in questions)
            if not numbers.effort.struck:
                return findings
            return tuple(replace(f, reason=TIME_ENDED) if f.verdict is Verdict.UNDECIDED else f for f in findings)

        return run

    return decorate


def run_stages(numbers: Any, stages: Iterable[Stage]) -> tuple[Finding, ...]:
    """The findings of all stages on one scheme, in their order: each speaks of what earlier ones introduced."""
    facts = Facts()
    for stage in stages:
        watch.begin(stage.__module__.rpartition(".")[2].replace("_", " "))
        facts.add(stage(numbers, facts))
    return facts.findings()


class Analysis(NamedTuple):
    """The findings on a scheme, without what a file expects of it."""

    scheme: Any
    facts: Mapping[str, Data]
    """The facts that are seen without a theorem."""
    findings: tuple[Finding, ...]
    numbers: Any
    """The numbers of the scheme, each computed once: an object of its kind."""
    hints: tuple[str, ...] = ()
    """The sentences on what the author of the mask may have meant."""
    parts: tuple[Part, ...] = ()
    """The factors of a product."""


class Part(NamedTuple):
    """A factor of a product, with the findings of its own stages."""

    variables: tuple[int, ...]
    """The variables of the product that the factor has, rising, from 0."""
    analysis: Analysis

    @property
    def scheme(self) -> Any:
        """The factor itself."""
        return self.analysis.scheme

    def find(self, question: Question) -> Finding | None:
        """The finding that answers a question about the factor, None without one."""
        return answering(self.analysis.findings, question)

    def finding(self, question: Question) -> Finding:
        """The finding that answers a question about the factor. Raises KeyError where there is none."""
        finding = self.find(question)
        if finding is None:
            raise KeyError(question.name)
        return finding

    @property
    def name(self) -> str:
        """The names of the variables as text: `z1`, `(z2, z3)`."""
        names = ", ".join(f"z{i + 1}" for i in self.variables)
        return names if len(self.variables) == 1 else f"({names})"


def gather(findings: tuple[Finding, ...]) -> Result:
    """The answers of all findings as a result; file, kind, facts and expectations are the caller's to put in.

    Raises ContradictionError where a question is answered twice.
    """
    given: dict[Question, Answer] = {}
    for finding in findings:
        for question, answer in finding.answers:
            if question in given:
                raise ContradictionError(f"{finding.code} answers {question.name} again")
            given[question] = answer

    def verdict(question: Question) -> Verdict:
        return cast(Verdict, given.get(question, Verdict.SKIPPED))

    def degree(question: Question) -> int | None:
        return cast("int | None", given.get(question))

    refinable = cast(Smoothness, given.get(questions.SMOOTHNESS, Smoothness()))
    following = answering(findings, questions.NEXT_SMOOTHNESS)
    if refinable.order is not None and following is not None and following.verdict is Verdict.REFUTED:
        refinable = refinable._replace(sharp=following.witness.get("order", refinable.order + 1) == refinable.order + 1)
    convergent = verdict(questions.CONVERGENCE)
    sobolev = cast("Exponent | None", given.get(questions.SOBOLEV))
    at_zero = cast("Exponent | None", given.get(questions.HOLDER_AT_ZERO))
    return Result(
        file="",
        status="undecided",
        sum_rule_order=degree(questions.SUM_RULES),
        convergent=convergent,
        smoothness=refinable if convergent is Verdict.PROVED else Smoothness(),
        refinable=refinable,
        holder=_holder(given),
        sobolev=None if sobolev == Exponent() else sobolev,
        stable=verdict(questions.STABILITY),
        linearly_independent=verdict(questions.INDEPENDENCE),
        generation=degree(questions.GENERATION),
        reproduction=degree(questions.REPRODUCTION),
        dimension=degree(questions.DIMENSION),
        well_defined=verdict(questions.WELL_DEFINED),
        polynomials=degree(questions.POLYNOMIALS),
        spectral=verdict(questions.SPECTRAL),
        derivatives=degree(questions.DERIVATIVES),
        holder_at_zero=None if at_zero == Exponent() else at_zero,
        findings=findings,
    )


GATHERED = (
    "sum_rule_order", "convergent", "smoothness", "refinable", "holder", "sobolev", "stable", "linearly_independent",
    "generation", "reproduction", "dimension", "well_defined", "polynomials", "spectral", "derivatives",
    "holder_at_zero",
)  # fmt: skip
"""The fields of a result that its findings answer."""


def _holder(given: Mapping[Question, Answer]) -> Exponent | None:
    """The Hölder exponent: the lower bound is the exponent itself where it is exact and bounds it from above too."""
    below = cast("Exponent | None", given.get(questions.HOLDER_LOWER))
    above = cast("Exponent | None", given.get(questions.HOLDER_UPPER)) or Exponent()
    if below is None:
        return None
    if below.exact is None or (above.upper is None and below.exact != INFINITY):
        return above._replace(lower=below.lower)
    attained = {Verdict.PROVED: True, Verdict.REFUTED: False}
    return below._replace(attained=attained.get(cast(Verdict, given.get(questions.HOLDER_ATTAINED))))


Read = Callable[["Table", Collection[str], "Collector"], "Body | None"]
Analyse = Callable[[Any, Effort], Analysis]


class Portraits(NamedTuple):
    """The functions by which a kind takes a scheme apart, for `show`."""

    analyse: Callable[[Any, Effort, Fraction], Analysis]
    """The stages as in `Kind.analyse`, with those of `show`; the last argument is the tolerance of error bounds."""
    make: Callable[[Analysis, Result], Portrait]
    """The pages, from the analysis and the certified result."""
    options: frozenset[str] = frozenset()
    """The options of `show` that mean something for this kind."""


PICTURES = frozenset({"", ".svg", ".png", ".pdf"})
"""The suffixes of pictures in two dimensions: that of the terminal, which is empty, and those of files."""
Options = Mapping[str, Any]
"""The options of `plot`, by their names: `samples` always, None or nothing for others that are not given."""
Certify = Callable[[Effort], tuple[Analysis, Result]]
"""A function that runs all stages under an effort, and returns the analysis and the certified result."""


def late(place: str) -> Callable[..., Any]:
    """The function at `module:name`, imported when it is called: what a kind declares costs nothing until then."""
    module, _, name = place.partition(":")

    def call(*arguments: Any, **named: Any) -> Any:
        return getattr(import_module(module), name)(*arguments, **named)

    return call


class NotDrawnError(ValueError):
    """Raised for a picture that cannot be drawn; the message says why."""


class Drawings(NamedTuple):
    """A sort of pictures that a kind draws, for `plot`: the first one that takes the file and has what it needs."""

    name: str
    """The name in the plural, `curves`: only pictures of one name are drawn into one."""
    make: Callable[[Any, Effort, Options, Certify], Drawing]
    """Draws a scheme; the last argument analyses it, as often and under as much effort as is needed.

    Raises NotDrawnError.
    """
    suffixes: frozenset[str]
    """The suffixes of the files that it goes into; an empty one is the terminal."""
    options: frozenset[str] = frozenset()
    """The options of `plot` that mean something for it."""
    needs: frozenset[str] = frozenset()
    """The options among them that must be given."""
    points: Callable[[str], Any] | None = None
    """Reads the file of the option `points`, and returns the value of that option. Raises MaskFileError."""
    most: int | None = None
    """The most masks that are drawn into one picture."""


class NotSmoothedError(ValueError):
    """Raised where a procedure does not apply to a scheme; the message says which hypothesis fails."""


class SmoothingStep(NamedTuple):
    """A scheme that a procedure makes of another one."""

    scheme: Scheme
    orders: int
    """The orders that the limits gain, negative for derived schemes."""
    procedure: str
    """The procedure and its source, the same for all schemes of a kind: `procedure 23 of Moosmüller, Dyn 2018`."""
    details: str
    """The numbers of this step: `dim E_A = 1`."""
    exactly: bool = True
    """Whether the exponent changes by just these orders where both converge; else by no more."""


class Smoothing(NamedTuple):
    """The procedures by which a kind makes a scheme smoother, for `smooth`; both raise NotSmoothedError."""

    smoother: Callable[[Any], SmoothingStep]
    """A scheme whose limits are one order smoother."""
    derived: Callable[[Any], SmoothingStep]
    """The derived scheme, whose limits are derivatives."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """A kind of scheme: the functions that the rest of the program calls.

    Its functions are `late` ones, so that the object itself is light.
    """

    name: str
    keys: tuple[str, ...] = ("mask",)
    """The keys at the top of its files, besides those that all files have."""
    read: Read
    """Reads a mask: from a file's top table, the names of its parameters and a collector of problems to the body.

    None where the body is wrong, which is recorded.
    """
    read_family: Read | None = None
    """Reads the same files, and more, as families of matrices, for `subdiv jsr`."""
    body_of: Callable[[Any], Body]
    """The literal body of a scheme."""
    spell: Callable[[Any], list[str]]
    """The lines of the file that spell a body."""
    canonical: Callable[[Any], Mapping[str, Any]]
    """The scheme as certificates embed it. Raises ValueError for a number of more than 4300 digits."""
    rules: Callable[[], Mapping[str, Rule[Any]]]
    """The table of the codes of the kind."""
    analyse: Analyse | None = None
    """All stages under an effort."""
    proofs: Callable[[Analysis], Proofs] | None = None
    """The claims that prove an analysis."""
    base: Callable[[Mapping[str, Any], Sequence[int] | None], tuple[int, int]] | None = None
    """The pair (m, s) of a canonical mask, or of its factor in these variables: the base of exponents is λ, λ^s = m."""
    sections: Callable[[Any, Result], tuple[Section, ...]] | None = None
    """The sections of a report beside the findings: stencils, and φ where it is known."""
    portraits: Portraits | None = None
    drawings: tuple[Drawings, ...] | None = None
    smoothing: Smoothing | None = None
    norms: Callable[[Any, int, Effort], Iterator[Fraction] | None] | None = None
    """The norms ‖((1/p) S_ν)^L‖∞ of a scheme of arity p for L = 1, 2, …, to the end of the effort.

    None where there is no scheme S_ν of divided differences of order ν >= 1.
    """
