"""Stages on the smoothness of the curve: inside its pieces, at the joints, and both together (SD814 to SD819)."""

from __future__ import annotations

from fractions import Fraction

from flint import ctx

from subdiv_cli.exact.closed import closed_interval, exponent, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import rounded_down, rounded_up
from subdiv_cli.jsr.products import radius_bound
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import ContradictionError, Facts, asking
from subdiv_cli.kinds.matrices.numbers.curve import Jet
from subdiv_cli.kinds.matrices.numbers.matrices import MatrixNumbers
from subdiv_cli.kinds.matrices.rules import (
    COMPONENTS,
    DIFFERENCE_RADIUS,
    HOLDER_LOWER,
    HOLDER_UPPER,
    JOINTS,
    NEXT_SMOOTHNESS,
    SMOOTHNESS,
    WELL_DEFINED,
)
from subdiv_cli.kinds.matrices.stages.convergence import family_data
from subdiv_cli.kinds.matrices.witnesses import (
    CurveHolderLowerWitness,
    CurveHolderUpperWitness,
    CurveNextSmoothnessWitness,
    CurveRadiusProof,
    CurveRadiusWitness,
    CurveSmoothnessWitness,
    JointsProof,
    JointsWitness,
)
from subdiv_cli.kinds.radius import enclosed, put_radius, shown
from subdiv_cli.model import INFINITY, Finding, Interval, Smoothness, Verdict, logarithm, unpowered
from subdiv_cli.model import findings as questions
from subdiv_cli.model.formulas import product as product_text
from subdiv_cli.model.proofs import root_data

_RADIUS_QUESTION = "how fast do differences decay inside the pieces?"


@asking((DIFFERENCE_RADIUS, _RADIUS_QUESTION))
def radius(numbers: MatrixNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD814: ρ, the joint spectral radius of the B_i on V, the vectors that annihilate the polynomial components.

    V = {v in span ψ : u_0·v = … = u_d·v = 0} is spanned by the differences of the curve, of any order above d
    (numbers/curve.py, the lemma). The radius is found and proved as SD310 says. Hypotheses, SD813 and SD810, and that
    the curve is no polynomial, for which V = 0: checked.

    Witness: `dimension` of V; `method`; `word` of a product that attains ρ or bounds it from below; `length` and
    `bound`, or `length` and `root`. `proof`: `basis` and `matrices` of V, `whole`, whether V is all of e^⊥, and the
    `radius`.
    """
    if (reason := _unasked(numbers, facts)) is not None:
        return (DIFFERENCE_RADIUS.skipped(_RADIUS_QUESTION, reason),)
    known = numbers.radius
    if known is None:
        return (DIFFERENCE_RADIUS.undecided(_RADIUS_QUESTION, "the effort ended before a bound"),)
    space = family_data(numbers)
    size = len(space["basis"])
    witness: CurveRadiusWitness = {"dimension": size, "method": known.method}
    put_radius(witness, known)
    value = enclosed(known)
    text = shown(known) if known.exact is not None else rounded_up(value.upper or 0.0, 12)
    relation = "=" if known.exact is not None or not known.upper[1] else "≤"
    statement = f"ρ {relation} {text} on V of dimension {size}"
    if known.word is not None and known.exact is not None:
        statement += f", attained by {product_text(known.word, 'B')}"
    proof: CurveRadiusProof = {**space, "whole": numbers.is_whole, "radius": known.proof}
    return (DIFFERENCE_RADIUS.proved(statement, witness, value, proof=proof),)


def _unasked(numbers: MatrixNumbers, facts: Facts) -> str | None:
    """The reason why smoothness is not a matter of V; None where it is."""
    if facts.verdict(WELL_DEFINED) is not Verdict.PROVED:
        return facts[COMPONENTS].reason
    if numbers.curve.annihilated is None:
        return "the curve is a polynomial"
    return None if facts.verdict(COMPONENTS) is Verdict.PROVED else "its polynomial components are not known"


def jets(numbers: MatrixNumbers) -> tuple[Jet, ...]:
    """The derivatives of order 1, 2, … <= d that a curve has one-sidedly, up to the first ones that do not fit."""
    radius = None if numbers.curve.annihilated is None else numbers.radius
    derivatives: list[Jet] = []
    for order in range(1, numbers.curve.components.degree + 1):
        if radius is None or not radius.is_below(Fraction(1, numbers.p**order)):
            break
        derivatives.append(numbers.curve.jet(order))
        if not derivatives[-1].fits:
            break
    return tuple(derivatives)


_JOINTS_QUESTION = "do derivatives fit at the joints?"


@asking((JOINTS, _JOINTS_QUESTION))
def joints(numbers: MatrixNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD815: whether the derivatives of the curve fit at the joints of its pieces.

    Theorem (Micchelli & Prautzsch 1989, Theorem 5.2 (a), at every step of the chain; numbers/curve.py, theorem 3): for
    δ <= d with p^-δ > ρ the curve has derivatives of order δ at both ends of a piece, eigenvectors of B_0 and B_(p-1)
    for p^-δ, and those of two neighbours fit iff B_j ψ^(δ)(0) = B_(j-1) ψ^(δ)(1). Hypotheses, a bound of ρ (SD814) and
    d (SD810): checked; there is a finding only where there is such a δ.

    Witness: `orders`, those asked, the last of which does not fit where it is refuted; `joint`, the first one there.
    `proof`: `left` and `right`, the derivatives of each order at 0 and at 1.
    """
    derivatives = jets(numbers) if facts.verdict(DIFFERENCE_RADIUS) is Verdict.PROVED else ()
    if not derivatives:
        return ()
    last = derivatives[-1]
    witness: JointsWitness = {"orders": tuple(jet.order for jet in derivatives)}
    proof: JointsProof = {"left": tuple(j.left for j in derivatives), "right": tuple(j.right for j in derivatives)}
    if last.joint is None:
        orders = "order 1" if last.order == 1 else f"order 1 to {last.order}"
        return (JOINTS.proved(f"derivatives of {orders} fit at the joints", witness, proof=proof),)
    at = Fraction(last.joint, numbers.p)
    what = f"the derivatives of order {last.order} do not fit at the joint x = {at}"
    witness["joint"] = last.joint
    return (JOINTS.refuted(what, witness, proof=proof),)


def _corner(facts: Facts) -> int | None:
    """The order of the derivatives that do not fit; None where all that are asked do."""
    return facts.witness(JOINTS)["orders"][-1] if facts.verdict(JOINTS) is Verdict.REFUTED else None


def _decay(numbers: MatrixNumbers, facts: Facts) -> Radius | None:
    """What is known of ρ; None where it, or whether derivatives fit, is not decided."""
    is_open = JOINTS in facts and facts.verdict(JOINTS) is Verdict.UNDECIDED
    return numbers.radius if facts.verdict(DIFFERENCE_RADIUS) is Verdict.PROVED and not is_open else None


_SMOOTHNESS_QUESTION = "how smooth is the curve on [0, 1]?"
_NEXT_QUESTION = "is the curve smoother than is proved?"


@asking((SMOOTHNESS, _SMOOTHNESS_QUESTION), (NEXT_SMOOTHNESS, _NEXT_QUESTION))
def smoothness(numbers: MatrixNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD816: the largest n for which the curve is proved C^n on [0, 1]. SD817: it is not C^(n+1).

    Theorem (numbers/curve.py, theorem 3; Micchelli & Prautzsch 1989, Theorem 5.2): iff ρ < p^-n (SD814) and the
    derivatives of orders δ <= min(n, d) fit at the joints (SD815). It is C^0 as it is well defined (SD813), and C^∞ iff
    it is a polynomial, that is iff dim Ψ = d + 1 (SD810). Of the curve of a polygon c, which is c·ψ: at least as smooth
    for every c, and no smoother but for those in a proper subspace.

    Witness: `order`; `by`, SD810 (a polynomial), SD813 (n = 0) or SD814; SD817: `by`, SD815, or SD814 with `word`.
    """
    if facts.verdict(WELL_DEFINED) is not Verdict.PROVED:
        return (SMOOTHNESS.skipped(_SMOOTHNESS_QUESTION, facts[COMPONENTS].reason or ""),)
    if numbers.curve.annihilated is None:
        d = numbers.curve.components.degree
        answers = {questions.SMOOTHNESS: Smoothness(INFINITY, sharp=True)}
        why = f"it is a polynomial of degree {d}"
        witness: CurveSmoothnessWitness = {"by": COMPONENTS.code, "degree": d}
        return (SMOOTHNESS.proved(f"the curve is C^∞ on [0, 1]: {why}", witness, answers=answers, why=why),)
    decay = _decay(numbers, facts)
    if decay is None:
        return (
            _proved(0, WELL_DEFINED.code, "its pieces meet"),
            NEXT_SMOOTHNESS.undecided("is the curve C^1?", _unknown(facts)),
        )
    corner, n = _corner(facts), 0
    while decay.is_below(Fraction(1, numbers.p ** (n + 1))) and n + 1 != corner:
        n += 1
    why = f"ρ < {_power(numbers.p, n)}" + (", and derivatives fit at the joints" if n else "")
    first = _proved(n, DIFFERENCE_RADIUS.code, why) if n else _proved(0, WELL_DEFINED.code, "its pieces meet")
    if corner == n + 1:
        return (first, _refuted({"order": n + 1, "by": JOINTS.code}, facts[JOINTS].statement))
    product = numbers.product
    if product is None or product.compare(Fraction(1, numbers.p ** (n + 1))) < 0:
        return (first, NEXT_SMOOTHNESS.undecided(f"is the curve C^{n + 1}?", "no product is known that excludes it"))
    why = f"{product_text(product.word, 'B')} keeps ρ ≥ {_power(numbers.p, n + 1)}"
    return (first, _refuted({"order": n + 1, "by": DIFFERENCE_RADIUS.code, "word": product.word}, why))


def _proved(n: int, by: str, why: str) -> Finding:
    answers = {questions.SMOOTHNESS: Smoothness(n)}
    statement = f"the curve is C^{n} on [0, 1]: {why}"
    return SMOOTHNESS.proved(statement, {"order": n, "by": by}, answers=answers, why=why)


def _refuted(witness: CurveNextSmoothnessWitness, why: str) -> Finding:
    return NEXT_SMOOTHNESS.refuted(f"the curve is not C^{witness['order']}: {why}", witness, why=why)


def _power(p: int, n: int) -> str:
    return f"{p}^-{n}" if n else "1"


def _unknown(facts: Facts) -> str:
    """The reason why neither ρ nor V nor the joints are of use."""
    findings = (facts.find(rule) for rule in (DIFFERENCE_RADIUS, COMPONENTS, JOINTS))
    return next(finding.reason for finding in findings if finding is not None and finding.reason is not None)


_BELOW, _ABOVE = "how regular is the curve at least?", "how regular is the curve at most?"


@asking((HOLDER_LOWER, _BELOW), (HOLDER_UPPER, _ABOVE))
def holder(numbers: MatrixNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD818: the Hölder exponent of the curve from below. SD819: from above.

    Theorem (numbers/curve.py, theorem 3): α = min(-log_p ρ, j), ρ of SD814 and j the order of the derivatives that do
    not fit at the joints (SD815), if there are such; of a polynomial it is infinite. The exponent is that of c·ψ for
    all control polygons c but those in a proper subspace, for which it may be larger.

    Witness: `by`, SD810; SD815 with `value`, j; or SD814 with `length` and `root`, or `length` and `bound`; from above
    SD815 with `value`, or SD814 with `word`, `length` and `radius`, a lower bound of ρ^length.

    Raises ContradictionError where a curve that is no polynomial has neither a positive ρ nor a corner.
    """
    if facts.verdict(WELL_DEFINED) is not Verdict.PROVED:
        reason = facts[COMPONENTS].reason or ""
        return (HOLDER_LOWER.skipped(_BELOW, reason), HOLDER_UPPER.skipped(_ABOVE, reason))
    if numbers.curve.annihilated is None:
        why = "the curve is a polynomial"
        value = closed_interval(INFINITY)
        return (HOLDER_LOWER.proved(f"α is infinite: {why}", {"by": COMPONENTS.code}, value, INFINITY, why=why),)
    decay = _decay(numbers, facts)
    if decay is None:
        return (HOLDER_LOWER.undecided(_BELOW, _unknown(facts)), HOLDER_UPPER.undecided(_ABOVE, _unknown(facts)))
    if (corner := _corner(facts)) is not None:
        exact, why = Fraction(corner), facts[JOINTS].statement
        below: CurveHolderLowerWitness = {"by": JOINTS.code, "value": corner}
        above: CurveHolderUpperWitness = {"by": JOINTS.code, "value": corner}
        return (
            HOLDER_LOWER.proved(f"α = {corner}: {why}", below, interval(exact), exact, why=why),
            HOLDER_UPPER.proved(f"α ≤ {corner}: {why}", above, interval(exact), exact, why=why),
        )
    if not decay.upper[1]:
        raise ContradictionError("a curve that is no polynomial has infinitely many derivatives")
    return (_below(numbers, decay), _above(numbers, decay))


def _below(numbers: MatrixNumbers, decay: Radius) -> Finding:
    witness: CurveHolderLowerWitness = {"by": DIFFERENCE_RADIUS.code, "length": decay.upper[0]}
    if decay.exact is not None:
        exact, why = exponent(numbers.p, *decay.exact), f"ρ = {shown(decay)}"
        witness["root"] = root_data(decay.exact[1])
        return HOLDER_LOWER.proved(f"α = {worded(exact)}, as {why}", witness, closed_interval(exact), exact, why=why)
    length, bound = decay.upper
    with ctx.workprec(128):
        lower = interval(-ball(bound).log() / ball(numbers.p).log() / length).lower
    assert lower is not None
    witness["bound"] = bound
    why = "from the bound of ρ"
    return HOLDER_LOWER.proved(f"α ≥ {rounded_down(lower)}, {why}", witness, Interval(lower=lower), why=why)


def _above(numbers: MatrixNumbers, decay: Radius) -> Finding:
    product = numbers.product
    if product is None or product.eigenvalue.rational == 0:
        return HOLDER_UPPER.undecided(_ABOVE, "no product is known that bounds ρ from below")
    bound, length = radius_bound(product), len(product.word)
    base, divisor = unpowered(numbers.p, length)
    upper = closed_interval(logarithm(base, 1 / bound, divisor)).upper
    text = rounded_up(upper or 0.0) if decay.exact is None else worded(exponent(numbers.p, *decay.exact))
    witness: CurveHolderUpperWitness = {
        "by": DIFFERENCE_RADIUS.code,
        "word": product.word,
        "length": length,
        "radius": bound,
    }
    why = f"{product_text(product.word, 'B')} bounds ρ from below"
    return HOLDER_UPPER.proved(f"α ≤ {text}: {why}", witness, Interval(upper=upper), why=why)
