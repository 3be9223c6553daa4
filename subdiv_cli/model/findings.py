"""Findings: a verdict with its theorem and numbers, the questions it answers, and the rule that it follows.

A question has a name and belongs to no kind of scheme: results are gathered, expectations judged and tables filled by
question. A rule is a row of a kind's table: what all findings of one code share.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from fractions import Fraction
from math import inf, nextafter
from typing import Any, Generic, NamedTuple, NoReturn, TypeVar, cast

from subdiv_cli.model.closed import ClosedForm, plus

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


DECIDED = (Verdict.PROVED, Verdict.REFUTED)
"""The verdicts that rest on a theorem."""


class Interval(NamedTuple):
    """An enclosure of a real number: lower <= x <= upper, certified doubles rounded outward; None is unknown."""

    lower: float | None = None
    upper: float | None = None
    exact: str | None = None
    """The number itself as text, where it is known: a rational or a closed form."""


class Smoothness(NamedTuple):
    """A smoothness: `order` is the largest n with C^n proved, None where not even continuity is.

    It is INFINITY for polynomials, and then sharp.
    """

    order: int | float | None = None
    sharp: bool = False
    """Whether C^(order+1) is refuted; without an order, whether continuity is."""


class Exponent(NamedTuple):
    """A Hölder or Sobolev exponent of the refinable function: certified outward doubles, exact where it is known."""

    lower: float | None = None
    upper: float | None = None
    exact: ClosedForm | None = None
    attained: bool | None = None
    digits: str | None = None
    """The decimals of an exact irrational exponent, all certain: `2.83007…`."""
    estimate: str | None = None
    """An estimate of an exponent that is only enclosed, extrapolated from norms: it proves nothing."""

    def of_derivative(self, n: int) -> Exponent:
        """The exponent of the n-th derivative of functions that have this one, which is less by n; bounds outward."""
        return Exponent(
            lower=None if self.lower is None else outward(Fraction(self.lower) - n, -inf),
            upper=None if self.upper is None else outward(Fraction(self.upper) - n, inf),
            exact=self.exact if self.exact is None or isinstance(self.exact, float) else plus(self.exact, -n),
            attained=self.attained,
            digits=None if self.digits is None else _digits_less(self.digits, n),
        )


def _digits_less(digits: str, n: int) -> str | None:
    """The decimals `2.83007…` of a positive number less n, where that is positive; None for powers of ten."""
    whole, point, rest = digits.partition(".")
    return None if "e" in digits or int(whole) < n else f"{int(whole) - n}{point}{rest}"


def outward(x: Fraction, towards: float) -> float:
    """The double next to x in a direction, x itself where it is one. Raises OverflowError beyond all doubles."""
    nearest = float(x)
    return nearest if (nearest >= x if towards > 0 else nearest <= x) else nextafter(nearest, towards)


class Question(NamedTuple):
    """A question about a scheme."""

    name: str
    of: int | None = None
    """The valence, or the order of the derivative, that it is about; None where it is about the scheme."""


SUMS = Question("sums")
"""Does every coset (residue class) of the mask sum to 1? Answered by a verdict."""
SUM_RULES = Question("sum_rules")
"""The order of the sum rules: an integer, 0 without any; None where it makes no sense."""
GENERATION = Question("generation")
"""The degree of the polynomials that are generated, None without sum rules."""
REPRODUCTION = Question("reproduction")
"""The degree of the polynomials that are reproduced, None without sum rules."""
EIGEN_CONDITION = Question("eigen_condition")
"""Have the refinement matrices the spectra of a convergent scheme? Answered by a verdict."""
CONVERGENCE = Question("convergence")
"""Does the scheme converge? Answered by a verdict."""
SMOOTHNESS = Question("smoothness")
"""How smooth is φ? Answered by a `Smoothness`."""
NEXT_SMOOTHNESS = Question("next_smoothness")
"""Is φ smoother than that? Answered by a verdict, REFUTED where it is excluded."""
HOLDER_LOWER = Question("holder_lower")
"""The Hölder exponent from below, exactly where it is known: an `Exponent`."""
HOLDER_UPPER = Question("holder_upper")
"""The Hölder exponent from above: an `Exponent`."""
HOLDER_ATTAINED = Question("holder_attained")
"""Is the Hölder exponent attained? Answered by a verdict."""
SOBOLEV = Question("sobolev")
"""The Sobolev exponent: an `Exponent`."""
INDEPENDENCE = Question("independence")
"""Are the integer translates of φ linearly independent? Answered by a verdict."""
STABILITY = Question("stability")
"""Are the integer translates of φ stable? Answered by a verdict."""
DIMENSION = Question("dimension")
"""The dimension of the space E_A of constants of a mask of matrices: an integer."""
WELL_DEFINED = Question("well_defined")
"""Do the ends of the pieces meet, so that there is one curve? Answered by a verdict."""
POLYNOMIALS = Question("polynomials")
"""The degree of the polynomials among the components of the curve; None where there is no curve."""
SPECTRAL = Question("spectral")
"""Has a Hermite scheme the spectral condition, up to the order of its derivatives? Answered by a verdict."""
DERIVATIVES = Question("derivatives")
"""The number of derivatives of the limit that a Hermite scheme converges to, beside the limit itself: an integer."""
HOLDER_AT_ZERO = Question("holder_at_zero")
"""The exponent at 0 alone of a scheme that changes its rules there: an `Exponent`."""
QUASI_INTERPOLATION = Question("quasi_interpolation")
"""The operator Q with S^∞ Q = 1 on the polynomials that are generated. Answered by a verdict."""

_EXPONENTS = frozenset(question.name for question in (HOLDER_LOWER, HOLDER_UPPER, HOLDER_AT_ZERO, SOBOLEV))
_DEGREES = frozenset(q.name for q in (SUM_RULES, GENERATION, REPRODUCTION, DIMENSION, POLYNOMIALS, DERIVATIVES))

Answer = Verdict | int | Smoothness | Exponent | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """A finding: one theorem applied to a scheme, with its verdict."""

    code: str
    """The code, SDnnn; `subdiv explain` has a page for it."""
    name: str
    """The code in words, for instance `residue-sums`."""
    verdict: Verdict
    statement: str
    """The statement that was decided, with its numbers; for UNDECIDED and SKIPPED the question."""
    source: str
    """The paper and the theorem."""
    answers: tuple[tuple[Question, Answer], ...] = ()
    """The questions that it answers; a second proof of the same, and a member of a series, answer none."""
    reason: str | None = None
    """The reason why it is undecided or skipped."""
    why: str | None = None
    """The part of the statement that says why, for those who have said what; None where it says only what."""
    value: Interval | None = None
    witness: Mapping[str, Data] = field(default_factory=dict)
    """Data from which the verdict can be rechecked without a search; the stage's docstring explains the keys."""
    proof: Mapping[str, Data] = field(default_factory=dict)
    """Further data for the certificate, too long for reports: the polytope of a joint spectral radius."""
    closed: ClosedForm | None = None
    """The number that the finding is about, where it is known exactly."""
    claims: tuple[int, ...] = ()
    """The claims of the certificate that state the same, checked independently."""
    otherwise: tuple[Finding, ...] = field(default=(), repr=False)
    """Findings of the rule that prove no more, by other routes: the first that can be certified, where this cannot."""


def best_of(findings: Sequence[Finding]) -> Finding:
    """The first of several findings of a rule, the strongest one, with the others as what is proved otherwise."""
    return replace(findings[0], otherwise=tuple(findings[1:]))


TOO_DEAR = "its proof asks more work of the checker than it does"
UNWRITTEN = "its proof costs too much to write down; a higher --effort may do it"
OUT_OF_TIME = "the time budget ended before its proof was checked"
UNCERTIFIED = (TOO_DEAR, UNWRITTEN, OUT_OF_TIME)
"""The reasons of a finding that would be decided, had it a place in the certificate."""


Form = TypeVar("Form", bound=Mapping[str, object])
"""A TypedDict: the form that the witnesses of a rule have, or the further data of a certificate."""


def _in_form(data: Mapping[str, Data], form: type[Form], code: str) -> Form:
    required, optional = (vars(form)[f"__{keys}_keys__"] for keys in ("required", "optional"))
    if not required <= data.keys() <= required | optional:
        raise ValueError(f"the data of {code} are no {form.__name__}: they have the keys {', '.join(data)}")
    return cast(Form, data)


def proof_of(finding: Finding, form: type[Form]) -> Form:
    """The further data of a finding in their form. Raises ValueError where they have other keys."""
    return _in_form(finding.proof, form, finding.code)


def uncertified(finding: Finding, reason: str) -> Finding:
    """A decided finding as an undecided one: no verified claim says it, so it is not claimed."""
    return replace(
        finding,
        verdict=Verdict.UNDECIDED,
        statement=f"not certified: {finding.statement}",
        answers=tuple((each, _following(each, Verdict.UNDECIDED, None, None)) for each, _ in finding.answers),
        reason=reason,
        why=None,
        value=None,
        witness={},
        proof={},
        closed=None,
        otherwise=(),
    )


def answering(findings: Iterable[Finding], *questions: Question) -> Finding | None:
    """The finding that answers the first of these questions that is answered at all; None where none is."""
    answers = {question: finding for finding in findings for question, _ in finding.answers}
    return next((answers[question] for question in questions if question in answers), None)


Answers = Mapping[Question, Answer]
Further = Mapping[str, object]
"""Further data for the certificate, a TypedDict."""


class Rule(NamedTuple, Generic[Form]):
    """A row of a kind's table of codes: what its findings share, and the four verdicts they can have."""

    code: str
    name: str
    source: str
    witness: type[Form]
    """The form of the witnesses, a TypedDict: stages write it, and claims read it by `witness_of`."""
    answers: tuple[Question, ...] = ()
    proves: frozenset[str] = frozenset()
    """The properties that claims of its decided findings state."""
    holds: bool = False
    """Whether such a claim has a field `holds` that distinguishes proved from refuted."""
    radius: bool = False
    """Whether the value of its findings is a joint spectral radius."""

    def proved(
        self,
        statement: str,
        witness: Form,
        value: Interval | None = None,
        closed: ClosedForm | None = None,
        proof: Further | None = None,
        answers: Answers | None = None,
        why: str | None = None,
    ) -> Finding:
        """A finding that is proved; `answers` are those that follow neither from the verdict nor from the value."""
        return self._finding(Verdict.PROVED, statement, None, witness, value, closed, proof, answers, why)

    def refuted(
        self,
        statement: str,
        witness: Form,
        answers: Answers | None = None,
        why: str | None = None,
        proof: Further | None = None,
    ) -> Finding:
        """A finding that is refuted."""
        return self._finding(Verdict.REFUTED, statement, None, witness, proof=proof, answers=answers, why=why)

    def undecided(self, question: str, reason: str, witness: Form | None = None) -> Finding:
        """A finding that could not be decided: the question, and why."""
        return self._finding(Verdict.UNDECIDED, question, reason, witness)

    def skipped(self, question: str, reason: str) -> Finding:
        """A finding of a question that makes no sense for the scheme, and why."""
        return self._finding(Verdict.SKIPPED, question, reason)

    def form(self, data: Mapping[str, Data]) -> Form:
        """Plain data as a witness of this rule. Raises ValueError where they have other keys."""
        return _in_form(data, self.witness, self.code)

    def witness_of(self, finding: Finding) -> Form:
        """The witness of a finding of this rule. Raises ValueError where it has other keys."""
        return self.form(finding.witness)

    def _finding(
        self,
        verdict: Verdict,
        statement: str,
        reason: str | None,
        witness: Form | None = None,
        value: Interval | None = None,
        closed: ClosedForm | None = None,
        proof: Further | None = None,
        answers: Answers | None = None,
        why: str | None = None,
    ) -> Finding:
        following = {question: _following(question, verdict, value, closed) for question in self.answers}
        data, further = (cast(Mapping[str, Data], each or {}) for each in (witness, proof))
        return Finding(
            code=self.code, name=self.name, verdict=verdict, statement=statement, source=self.source,
            answers=tuple((following | dict(answers or {})).items()), reason=reason, why=why, value=value, witness=data,
            proof=further, closed=closed,
        )  # fmt: skip


def _following(question: Question, verdict: Verdict, value: Interval | None, closed: ClosedForm | None) -> Answer:
    """The answer to a question that follows from the verdict and the value of a finding."""
    if question.name in _EXPONENTS:
        value = value or Interval()
        return None if verdict is Verdict.SKIPPED else Exponent(value.lower, value.upper, closed)
    if question.name in _DEGREES:
        return None
    if question.name == SMOOTHNESS.name:
        return Smoothness(sharp=verdict is Verdict.REFUTED)
    return verdict


def row(
    code: str,
    name: str,
    source: str,
    witness: type[Form],
    answers: Question | tuple[Question, ...] = (),
    proves: str = "",
    holds: bool = False,
    radius: bool = False,
) -> Rule[Form]:
    """The rule of a row, with the form of its witnesses.

    `answers` is one question or several, `proves` the properties, separated by blanks.
    """
    several = (answers,) if isinstance(answers, Question) else answers
    return Rule(code, name, source, witness, several, frozenset(proves.split()), holds, radius)


def table(names: Mapping[str, object]) -> Mapping[str, Rule[Any]]:
    """The rows among the names of a module, by their codes. Raises ValueError for a code that stands twice."""
    rows = [value for value in names.values() if isinstance(value, Rule)]
    by_code = {rule.code: rule for rule in rows}
    if len(by_code) < len(rows):
        raise ValueError("a code stands twice")
    return by_code
