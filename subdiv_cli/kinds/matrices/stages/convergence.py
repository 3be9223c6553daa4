"""Stages on convergence and on the components of the curve (SD810 to SD813)."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import rounded_up, sized
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import ContradictionError, Facts, asking
from subdiv_cli.kinds.matrices.numbers.matrices import MatrixNumbers
from subdiv_cli.kinds.matrices.rules import COMPONENTS, CONVERGENCE, SIGN_PATTERNS, WELL_DEFINED
from subdiv_cli.kinds.matrices.witnesses import (
    ComponentsProof,
    PolygonConvergenceWitness,
    SignPatternsWitness,
    SpaceData,
    WellDefinedWitness,
)
from subdiv_cli.kinds.radius import enclosed, put_power, shown
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.formulas import point
from subdiv_cli.model.formulas import product as product_text
from subdiv_cli.model.proofs import RadiusProof

_LONGEST_CYCLE = 200
"""The most letters of a product that refutes."""
_PATTERNS_QUESTION = "do products of the matrices get a positive column?"


@asking((SIGN_PATTERNS, _PATTERNS_QUESTION))
def sign_patterns(numbers: MatrixNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD812: whether products of stochastic matrices get a positive column, by their sign patterns.

    Theorem (Micchelli & Prautzsch 1989, Theorem 2.1, Corollaries 2.3 and 2.4; numbers/patterns.py): stochastic matrices
    converge iff for some k all products of k of them have a positive column. Hypothesis, no entry is negative: checked;
    there is a finding only where it holds.

    Witness: proved, `length`, k; `by`, `2.3`, `2.4` or `graph`, with `steps`. Refuted: `word`, w: no power of
    A_(w_ℓ) ⋯ A_(w_1) has a positive column.
    """
    if not numbers.is_stochastic:
        return ()
    known = numbers.patterns
    if known is None:
        return (SIGN_PATTERNS.undecided(_PATTERNS_QUESTION, "there are too many sign patterns for this effort"),)
    if known.length is None and len(known.cycle) > _LONGEST_CYCLE:
        return (SIGN_PATTERNS.undecided(_PATTERNS_QUESTION, "the product of a cycle of patterns is too long"),)
    if known.length is None:
        why = f"no power of {product_text(known.cycle, 'A')} has one"
        statement = f"products do not get a positive column: {why}"
        return (SIGN_PATTERNS.refuted(statement, {"word": known.cycle}, why=why),)
    matrices = "every matrix has" if known.length == 1 else f"all products of {known.length} matrices have"
    by = "the longest path of sign patterns without one" if known.corollary is None else f"Corollary {known.corollary}"
    witness: SignPatternsWitness = {"length": known.length, "by": known.corollary or "graph", "steps": known.steps}
    return (SIGN_PATTERNS.proved(f"{matrices} a positive column, by {by}", witness, why=f"by {by}"),)


_CONVERGENCE_QUESTION = "do all polygons converge?"


@asking((CONVERGENCE, _CONVERGENCE_QUESTION))
def convergence(numbers: MatrixNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD811: whether all control polygons converge.

    Theorem (numbers/curve.py, theorem 1): iff JSR(B | e^⊥) < 1, the joint spectral radius of the transposes on the
    vectors whose entries sum to 0. Of stochastic matrices also by SD812. Hypothesis, rows sum to 1: the reader's.

    Witness: `by`, SD811 or SD812; `length` and `bound`, or `length` and `root`: JSR^length is at most the bound, or is
    the root; or `word`, w, of a product B_(w_ℓ) ⋯ B_(w_1) that has an eigenvalue of modulus 1 or more there. `proof`:
    that of the radius.

    Raises ContradictionError where the two theorems disagree.
    """
    radius, verdict = numbers.decay, facts.verdict(SIGN_PATTERNS)
    if radius is not None and radius.is_below(Fraction(1)):
        if verdict is Verdict.REFUTED:
            raise ContradictionError("polygons converge, and products get no positive column")
        witness: PolygonConvergenceWitness = {"by": CONVERGENCE.code}
        put_power(witness, radius)
        return (_converges(witness, f"their differences decay, {_size(radius)} < 1", radius.proof),)
    if (word := _growing(numbers)) is not None:
        if verdict is Verdict.PROVED:
            raise ContradictionError("polygons do not converge, and products get a positive column")
        why = f"{product_text(word, 'B')} keeps their differences from decaying"
        return (_diverges({"by": CONVERGENCE.code, "word": word}, why),)
    if verdict is Verdict.PROVED:
        return (_converges({"by": SIGN_PATTERNS.code}, "products of stochastic matrices get a positive column"),)
    if verdict is Verdict.REFUTED:
        word = facts.witness(SIGN_PATTERNS)["word"]
        return (_diverges({"by": SIGN_PATTERNS.code, "word": word}, facts[SIGN_PATTERNS].why or ""),)
    reason = "the effort ended before the decay of differences was known"
    if radius is not None:
        reason = "no bound of the decay of differences below 1 is proved, and no product is known that keeps it above"
    return (CONVERGENCE.undecided(_CONVERGENCE_QUESTION, reason),)


def _converges(witness: PolygonConvergenceWitness, why: str, proof: RadiusProof | None = None) -> Finding:
    return CONVERGENCE.proved(f"all polygons converge: {why}", witness, proof=proof, why=why)


def _diverges(witness: PolygonConvergenceWitness, why: str) -> Finding:
    return CONVERGENCE.refuted(f"not all polygons converge: {why}", witness, why=why)


def _growing(numbers: MatrixNumbers) -> tuple[int, ...] | None:
    """The word of a product with an eigenvalue of modulus 1 or more on e^⊥; None where none is known."""
    word = None if numbers.decay is None else numbers.decay.word
    if word is None or WordProduct.of_word(numbers.differences, word).compare(Fraction(1)) < 0:
        return None
    return word


def _size(radius: Radius) -> str:
    """The radius on e^⊥ as text: `JSR = 1/2`, or a bound."""
    if radius.exact is not None:
        return f"JSR = {shown(radius)}"
    return f"JSR ≤ {rounded_up(enclosed(radius).upper or 0.0)}" if radius.upper[1] else "JSR = 0"


_WELL_DEFINED_QUESTION = "is there one curve?"


@asking((WELL_DEFINED, _WELL_DEFINED_QUESTION))
def well_defined(numbers: MatrixNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD813: whether the limits of all pieces are one curve ψ, which is continuous then.

    Theorem (Micchelli & Prautzsch 1989, Theorem 3.1; numbers/curve.py, theorem 2): iff B_j f_0 = B_(j-1) f_(p-1) for
    0 < j < p, f_i = B_i f_i with entries that sum to 1. Hypothesis, convergence (SD811): checked.

    Witness: `left`, f_0, and `right`, f_(p-1); refuted: `joint`, the first j where they do not meet.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (WELL_DEFINED.skipped(_WELL_DEFINED_QUESTION, "it is not proved that all polygons converge"),)
    left, right = numbers.ends
    witness: WellDefinedWitness = {"left": left, "right": right}
    if (joint := numbers.misfit) is None:
        ends = (
            f"from ψ(0) = {point(left, sized)} to ψ(1) = {point(right, sized)}"
            if numbers.n <= 6
            else "which is continuous"
        )
        return (WELL_DEFINED.proved(f"the pieces meet in one curve, {ends}", witness),)
    why = f"at x = {Fraction(joint, numbers.p)} piece {joint - 1} ends elsewhere than piece {joint} begins"
    witness["joint"] = joint
    return (WELL_DEFINED.refuted(f"the pieces do not meet in one curve: {why}", witness, why=why),)


_COMPONENTS_QUESTION = "which polynomials are components of the curve?"


@asking((COMPONENTS, _COMPONENTS_QUESTION))
def components(numbers: MatrixNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD810: the dimension of the space Ψ of components c·ψ, and the degree of the polynomials in it.

    Theorem (Micchelli & Prautzsch 1989, Corollaries 4.2 and 6.2, Theorems 7.1 to 7.3; numbers/components.py): dim Ψ is
    that of the smallest invariant space with ψ(0); with a polynomial Ψ has all of lower degree; x^δ is a component iff
    a linear system is solvable. Hypothesis, the curve is well defined (SD813): checked.

    Witness: `degree`, d, and `dimension`, m. `proof`: `words` whose B_w ψ(0) span the space; a basis of its
    `annihilator`; the `polygons` u_0, …, u_d with u_δ·ψ(x) = x^δ; `weights` of a relation of the points of a grid, of a
    `level`, that x^(d+1) does not satisfy; none where m = d + 1.
    """
    if (reason := _no_curve(facts)) is not None:
        return (COMPONENTS.skipped(_COMPONENTS_QUESTION, reason),)
    curve = numbers.curve
    m, d = curve.span.dimension, curve.components.degree
    relation = None if m == d + 1 else numbers.relation
    if m > d + 1 and relation is None:
        return (COMPONENTS.undecided(_COMPONENTS_QUESTION, "no relation of points is known that excludes more"),)
    proof: ComponentsProof = {
        "words": tuple(word for _, word in curve.span.origins),
        "annihilator": curve.annihilator,
        "polygons": curve.components.polygons,
        "level": 0 if relation is None else relation.level,
        "weights": () if relation is None else relation.weights,
    }
    what = "the constants" if d == 0 else f"the polynomials of degree {d}"
    several = f"{m} independent components" + (f" of {numbers.n}" if m < numbers.n else "")
    statement = f"the curve has {several}: {what} and no others are among them"
    if m == d + 1:
        statement = f"the curve has {several}: they span the polynomials of degree {d}"
    answers = {questions.POLYNOMIALS: d}
    return (COMPONENTS.proved(statement, {"degree": d, "dimension": m}, proof=proof, answers=answers),)


def _no_curve(facts: Facts) -> str | None:
    """The reason why there is no curve to ask of; None where there is one."""
    if facts.verdict(WELL_DEFINED) is Verdict.PROVED:
        return None
    if facts.verdict(WELL_DEFINED) is Verdict.REFUTED:
        return "the curve is not well defined"
    return "it is not proved that all polygons converge"


def family_data(numbers: MatrixNumbers) -> SpaceData:
    """The space V of the curve, as certificates have it."""
    space = numbers.curve.annihilated
    assert space is not None
    return {"basis": rows_of(space.basis), "matrices": tuple(rows_of(m) for m in space.matrices)}
