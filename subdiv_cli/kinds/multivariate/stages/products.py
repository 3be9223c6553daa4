"""Stages on masks that are products: box splines and tensor products (SD603, SD609)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts, Part, asking
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.rules import BOX_SPLINE, TENSOR_PRODUCT
from subdiv_cli.kinds.multivariate.witnesses import (
    BoxSplineWitness,
    ExponentWitness,
    MultivariateConvergenceWitness,
    MultivariateStabilityWitness,
    TensorProductWitness,
)
from subdiv_cli.kinds.scalar.stages.wording import series
from subdiv_cli.model import Finding, Question, Rule, Verdict
from subdiv_cli.spaces.lattice import Index


@asking()
def box_spline(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD603: whether φ is a box spline.

    Theorem: see numbers/box_spline.py. The factorisation is of the mask of S itself, or of a power S^r whose dilation
    is a multiple of I; it is exact, and the directions are found without a search. Hypothesis, the coset sums add up to
    |det M|: checked. There is a finding only where φ is one.

    Witness: `directions` with `multiplicities`; `power`, r; `scale`, c with M^r = c I; `shift`; `depth`, the least
    number of directions whose removal leaves a set that does not span; `unimodular`, whether all determinants are -1, 0
    or 1.
    """
    box = numbers.box
    if box is None:
        return ()
    count = box.multiplicities
    of = "" if box.power == 1 else f"; recognised in S^{box.power}, whose dilation is {box.scale}I"
    statement = f"φ is the box spline of {len(box.directions)} directions: {_listed(count)}{of}"
    witness: BoxSplineWitness = {
        "directions": tuple(count),
        "multiplicities": tuple(count.values()),
        "power": box.power,
        "scale": box.scale,
        "shift": box.shift,
        "depth": box.depth,
        "unimodular": box.is_unimodular,
    }
    return (BOX_SPLINE.proved(statement, witness),)


def _listed(count: Mapping[Index, int]) -> str:
    """The directions as text: `(0, 1), (1, 0), each twice`, or `(0, 1), (1, 0) 3 times`."""
    times = {n: "twice" if n == 2 else f"{n} times" for n in count.values()}
    if len(times) == 1 and 1 not in times and len(count) > 1:
        return f"{', '.join(map(str, count))}, each {times[min(times)]}"
    return ", ".join(f"{xi}" + (f" {times[n]}" if n > 1 else "") for xi, n in count.items())


_LEAST_SPARE = Fraction(1, 1000)
"""Exponents that are nearer to each other than four times this, and not rational, are not compared."""


@asking()
def tensor_product(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD609: whether the mask is a tensor product, and what follows for φ from its factors.

    Theorem (Dyn 1992, Proposition 6.3; FORMAT.md): let M be block diagonal and a(z) the product of masks in the
    variables of the blocks, of sums |det M_j|. Then φ is the product of the φ_j. S converges uniformly iff all factors
    do; then φ is stable iff all φ_j are. φ is C^n iff all φ_j are; its Hölder and its Sobolev exponent are the least
    ones of the factors where these are positive, and never larger. M need not be isotropic. Hypotheses: checked.
    Coefficients that do not add up to |det M| and box splines (SD603) are not asked. There is a finding only where
    there are factors; then they alone decide.

    Witness: `parts`, the numbers of the variables, from 0, of each factor.
    """
    if not numbers.parts:
        return ()
    factors = "; ".join(f"in {part.name} {_mask(part)}" for part in numbers.parts)
    witness: TensorProductWitness = {"parts": tuple(part.variables for part in numbers.parts)}
    return (TENSOR_PRODUCT.proved(f"φ is a tensor product of {len(numbers.parts)} factors: {factors}", witness),)


def _mask(part: Part) -> str:
    scheme = part.scheme
    if scheme.kind == "scalar":
        arity = "" if scheme.arity == 2 else f" of arity {scheme.arity}"
        return f"the mask {series(scheme.coefficients, number)} from {scheme.start}{arity}"
    return f"a mask of {len(scheme.terms)} coefficients"


def of_all(parts: tuple[Part, ...], question: Question) -> tuple[Verdict, Part]:
    """The verdict PROVED where all are, else REFUTED where one is, with it; UNDECIDED with one that is not proved."""
    verdicts = [(part.finding(question).verdict, part) for part in parts]
    for wanted in (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.SKIPPED):
        for verdict, part in verdicts:
            if verdict is wanted:
                return (Verdict.REFUTED if wanted is Verdict.REFUTED else Verdict.UNDECIDED), part
    return Verdict.PROVED, parts[0]


def follows(
    rule: Rule[MultivariateConvergenceWitness] | Rule[MultivariateStabilityWitness],
    open_question: str,
    parts: tuple[Part, ...],
    question: Question,
    yes: str,
    no: str,
    have: str,
    lacks: str,
) -> Finding:
    """The finding of a property that φ has iff all factors have it.

    `have` says why it has it; `lacks`, with a place for the name of a factor, why not.
    """
    verdict, part = of_all(parts, question)
    if verdict is Verdict.PROVED:
        return rule.proved(f"{yes}: {have}", {"by": TENSOR_PRODUCT.code}, why=have)
    if verdict is Verdict.REFUTED:
        why = lacks.format(part.name)
        return rule.refuted(f"{no}: {why}", {"by": TENSOR_PRODUCT.code}, why=why)
    return rule.undecided(open_question, f"it is not decided for the factor in {part.name}")


class Least(NamedTuple):
    """The factor with the least exponent, as far as it is bounded from below."""

    part: Part
    is_exact: bool
    """Whether it is the exponent of φ, and its finding has it in closed form."""
    between: Fraction | None
    """A number that the exponents of factors with other masks are not below, and that of this one not above."""


def least(parts: tuple[Part, ...], question: Question) -> Least | None:
    """The factor of least exponent, by the bounds from below; None where an exponent is not seen to be positive."""
    lower = [_low(part.finding(question)) for part in parts]
    if any(x is None or x <= 0 for x in lower):
        return None
    for part in sorted(parts, key=lambda each: _low(each.finding(question)) or 0):
        others = [other.finding(question) for other in parts if other.scheme != part.scheme]
        if not others:
            return Least(part, part.finding(question).closed is not None, None)
        if (between := _between(part.finding(question), others)) is not None:
            return Least(part, part.finding(question).closed is not None, between)
    return None


NOT_LEAST = "the exponents of the factors are not seen to be positive, or not compared"
"""Why no exponent of a factor is known to be that of φ."""


def put_least(witness: ExponentWitness, factor: Least) -> None:
    """Write the least factor into a witness, as SD614 and SD617 have it."""
    witness["variables"] = factor.part.variables
    if factor.between is not None:
        witness["between"] = factor.between


def _between(finding: Finding, others: list[Finding]) -> Fraction | None:
    """The simplest number from what the finding proves from below to what others do."""
    high = min(x for other in others if (x := _low(other)) is not None)
    if isinstance(finding.closed, Fraction):
        return _simplest(finding.closed, high) if finding.closed <= high else None
    value = finding.value if finding.closed is None else closed_interval(finding.closed)
    if value is None or (low := value.lower if finding.closed is None else value.upper) is None:
        return None
    spare = (high - Fraction(low)) / 4  # statements enclose the numbers less tightly
    return _simplest(Fraction(low) + spare, high - spare) if spare > _LEAST_SPARE else None


def _low(finding: Finding) -> Fraction | None:
    """The lower bound of an exponent that a finding proves; None where it proves none."""
    if isinstance(finding.closed, Fraction):
        return finding.closed
    return _fraction(finding.value.lower) if finding.value is not None else None


def _fraction(x: float | None) -> Fraction | None:
    return None if x is None else Fraction(x)


def _simplest(low: Fraction, high: Fraction) -> Fraction:
    """The fraction of the least denominator in [low, high], 0 < low (Stern & Brocot)."""
    whole = -(-low.numerator // low.denominator)
    if whole <= high:
        return Fraction(whole)
    rest = _simplest(1 / (high - whole + 1), 1 / (low - whole + 1))
    return whole - 1 + 1 / rest


def least_upper(parts: tuple[Part, ...], question: Question) -> Part | None:
    """The factor whose exponent has the least upper bound that is proved."""
    known: Iterator[tuple[float, Part]] = (
        (value.upper, part)
        for part in parts
        if part.finding(question).verdict is Verdict.PROVED
        and (value := part.finding(question).value) is not None
        and value.upper is not None
    )
    return min(known, key=lambda pair: pair[0], default=(0.0, None))[1]
