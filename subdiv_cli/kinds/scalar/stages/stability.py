"""Stages on the translates of φ: independence, stability, and what an unstable mask is reduced to (SD401 to SD403)."""

from __future__ import annotations

from itertools import groupby

from flint import fmpq_poly

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.text import laurent
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.stability import ReductionStep
from subdiv_cli.kinds.scalar.rules import INDEPENDENCE, REDUCTION, STABILITY
from subdiv_cli.kinds.scalar.stages.wording import NOT_NORMALISED
from subdiv_cli.kinds.scalar.witnesses import ReductionWitness, StabilityWitness
from subdiv_cli.model import Finding, Verdict

_INDEPENDENCE_QUESTION = "are the integer translates of φ linearly independent?"
_STABILITY_QUESTION = "are the integer translates of φ stable?"


@asking((INDEPENDENCE, _INDEPENDENCE_QUESTION))
def independence(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD401: whether the integer translates of the refinable function φ are linearly independent.

    Theorem (Jia & Wang 1993 for p = 2, Zhou 1996 for any arity): for a finite mask with a(1) = p, so that the refinable
    distribution φ with ∫φ = 1 exists, the translates are linearly independent iff (i) the polyphase components a_0, …,
    a_(p-1) have no common zero in C∖{0}, and (ii) there is no cycle. For a rational mask a cycle is an n > 1 coprime to
    p for which Φ_n(z^p)/Φ_n(z) divides a(z). Hypothesis a(1) = p: checked.

    Witness, proved: `largest_n`, up to which cycles were looked for (the degree of the factor rules out larger ones);
    the Bezout cofactors of the components are in SD402. Refuted: `gcd`, or `cycle`, the n.
    """
    return (_independence(numbers),)


def _independence(numbers: ScalarNumbers) -> Finding:
    p = numbers.p
    if not numbers.is_normalised:
        return INDEPENDENCE.skipped(_INDEPENDENCE_QUESTION, NOT_NORMALISED)
    g = numbers.polyphase_gcd
    dependent = "the translates of φ are linearly dependent"
    if g.degree > 0:
        why = f"{laurent(g)} divides all polyphase components"
        return INDEPENDENCE.refuted(f"{dependent}: {why}", {"gcd": g.coefficients()}, why=why)
    if (n := numbers.cycle) is not None:
        why = f"Φ_{n}(z^{p})/Φ_{n}(z) divides a(z), a cycle of roots of unity of order {n}"
        return INDEPENDENCE.refuted(f"{dependent}: {why}", {"cycle": n}, why=why)
    largest = 10 * (numbers.scheme.degree // (p - 1))
    why = "the polyphase components are coprime and a(z) has no cycle of roots of unity"
    return INDEPENDENCE.proved(f"the translates of φ are linearly independent: {why}", {"largest_n": largest}, why=why)


@asking((STABILITY, _STABILITY_QUESTION))
def stability(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD402: whether the integer translates of φ are stable.

    That is, the Fourier transform of φ has no 2π-periodic zero on the real line; for a bounded φ this means c‖f‖∞ <= ‖Σ
    f_α φ(·-α)‖∞ for some c > 0 and all bounded f. For a φ that is a distribution it is the former.

    Theorem (Jia & Wang 1993 for p = 2, Zhou 1996 for any arity): stable iff (i) the polyphase components have no common
    zero on |z| = 1, and (ii) there is no cycle (SD401). Linear independence implies it. Hypothesis a(1) = p: checked. A
    common zero on the circle is decided exactly: an irreducible factor of the gcd has one only if it is reciprocal, and
    then its roots are told apart from their mirror images.

    Witness, proved: `gcd` of the polyphase components, `starts` and `cofactors` (see below). Refuted: `circle_factor`,
    lowest coefficient first, or `cycle`.
    """
    return (_stability(numbers, facts),)


def _stability(numbers: ScalarNumbers, facts: Facts) -> Finding:
    independent = facts.verdict(INDEPENDENCE)
    if independent is Verdict.SKIPPED:
        return STABILITY.skipped(_STABILITY_QUESTION, facts[INDEPENDENCE].reason or "")
    if independent is Verdict.PROVED:
        why = "its integer translates are linearly independent"
        return STABILITY.proved(f"φ is stable: {why}", stability_witness(numbers), why=why)
    g = numbers.polyphase_gcd
    if numbers.circle_factors:
        factor = numbers.circle_factors[0]
        shown = laurent(Laurent(0, fmpq_poly(factor)))
        why = f"the polyphase components share zeros of {shown} on |z| = 1"
        witness: StabilityWitness = {"circle_factor": tuple(int(c) for c in factor)}
        return STABILITY.refuted(f"φ is not stable: {why}", witness, why=why)
    if (n := numbers.cycle) is not None:
        why = f"a(z) has a cycle of roots of unity of order {n}"
        return STABILITY.refuted(f"φ is not stable: {why}", {"cycle": n}, why=why)
    why = f"the common factor {laurent(g)} of the polyphase components has no zero on |z| = 1, and a(z) has no cycle"
    return STABILITY.proved(f"φ is stable: {why}", stability_witness(numbers), why=why)


def stability_witness(numbers: ScalarNumbers) -> StabilityWitness:
    """The witness of stability: `gcd` of the polyphase components, monic, and `starts` and `cofactors` u_r.

    The u_r are Laurent polynomials with Σ_r u_r a_r = gcd; they are left out where they cost more than the effort.
    """
    witness: StabilityWitness = {"gcd": numbers.polyphase_gcd.coefficients()}
    if (cofactors := numbers.bezout_cofactors) is not None:
        witness["starts"] = tuple(u.low for u in cofactors)
        witness["cofactors"] = tuple(u.coefficients() for u in cofactors)
    return witness


@asking()
def reduced_mask(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD403: an unstable mask reduced to a stable one.

    Theorem: let g be the gcd of the polyphase components, or g = Φ_n for a cycle of n-th roots of unity (SD402). Then
    a0(z) = a(z) g(z)/g(z^p) is a mask with φ = Σ_j g_j φ0(·-j)/g(1): the right side solves the refinement equation of
    a, and g(1) ≠ 0 because a(1) = p. As 1/g is a power series, φ0 is a locally finite combination of translates of φ,
    so both are equally smooth. Each step lowers the degree by (p-1) deg g; the last φ0 is stable by SD402's test.
    Hypothesis a(1) = p: checked.

    Smoothness, exponents and their refutations are then decided on the reduced mask; convergence is judged on S itself.

    Witness: `factors`, the g of each step; `cycles`, the n of each step or None; `starts` and `masks`, the mask after
    each step; of the last one `order`, `cofactor_start` and `cofactor` as in SD102, and `stable`, what proves it
    stable, as in SD402.
    """
    steps = numbers.reduction
    if not steps:
        return ()
    reduced = steps[-1].symbol
    runs = [(text, len(list(reduced_mask))) for text, reduced_mask in groupby(_text(step, numbers.p) for step in steps)]
    how = ", then ".join(text + (f", {count} times" if count > 1 else "") for text, count in runs)
    statement = (
        f"φ is as smooth as the stable φ0 of the reduced scheme S0 with symbol a0(z) = {laurent(reduced)}, {how}"
    )
    order, cofactor = numbers.reduced.sum_rules[:2]
    witness: ReductionWitness = {
        "factors": tuple(step.factor.coefficients() for step in steps),
        "cycles": tuple(step.cycle for step in steps),
        "starts": tuple(step.symbol.low for step in steps),
        "masks": tuple(step.symbol.coefficients() for step in steps),
        "order": order,
        "cofactor_start": cofactor.low,
        "cofactor": cofactor.coefficients(),
        "stable": stability_witness(numbers.reduced),
    }
    return (REDUCTION.proved(statement, witness),)


def _text(step: ReductionStep, p: int) -> str:
    if step.cycle is not None:
        return f"by g = Φ_{step.cycle} in a(z) g(z)/g(z^{p})"
    return f"by g = {laurent(step.factor)} in a(z) g(z)/g(z^{p})"
