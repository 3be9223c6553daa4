"""Stages on convergence and smoothness (SD201, SD301 to SD303)."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, number, rounded_up
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.rules import (
    CONTRACTIVITY,
    CONVERGENCE,
    EIGEN_CONDITION,
    JOINT_RADIUS,
    NEXT_SMOOTHNESS,
    RESIDUE_SUMS,
    SMOOTHNESS,
    SOBOLEV,
)
from subdiv_cli.kinds.scalar.stages.decay import decays, mean_decay
from subdiv_cli.kinds.scalar.stages.joint_radius import (
    enclosed,
    obstacle_to,
    obstacles_to,
    product_obstacle,
    shown,
    threshold,
    who_is_stable,
)
from subdiv_cli.kinds.scalar.stages.wording import NOT_NORMALISED, integer, last_difference, power, scaled, series, text
from subdiv_cli.model import Data, Finding, Smoothness, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import Witness, best_of


def contractivity(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD301: for ν = 1, …, k, whether (1/p)S_ν contracts.

    Theorem (Dyn 1992, 3.2 and 3.4, for any arity p): with sum rules of order ν, ‖((1/p)S_ν)^L‖∞ < 1 for some L iff
    S_(ν-1) converges uniformly, and then φ and every limit function are C^(ν-1). Hypotheses a(1) = p and the sum rules:
    checked, they are what k says. Norms decide upward; where those of (1/p)S_ν stay above 1, the joint spectral radius
    ρ of D = S_(Δ^k), the last difference scheme, decides (SD310): that of (1/p)S_ν is max(1/p, p^(ν-1) ρ).

    Refuted without norms: by the same formula a product Π of ℓ transition matrices of D with an eigenvalue |λ| >=
    p^(-(ν-1)ℓ) excludes every L.

    No stability is needed for either: the finding speaks of S_ν. For an unstable mask the schemes S_ν are those of the
    reduced mask (SD403), and what they prove holds for φ.

    Witness, proved: `nu`; `condition`, the inequality as text; `level`, `norm` and `norms`, those of ((1/p)S_ν)^L for L
    = 1 to `level`, or `radius_of`, the name (S or S0) of the SD310 finding that decides. Refuted: `nu` and the product
    (see obstacles.py). Undecided: `nu` and the `norms` computed.
    """
    return tuple(contraction(numbers.reduced, nu) for nu in range(1, numbers.reduced.order + 1))


def contraction(numbers: ScalarNumbers, nu: int) -> Finding:
    """Whether (1/p)S_ν contracts, for the mask of these numbers and 1 <= ν <= k."""
    operator = scaled(numbers, nu)
    if (obstacle := product_obstacle(numbers, nu - 1)) is not None:
        text, witness = obstacle
        return CONTRACTIVITY.refuted(f"{operator} does not contract: {text}", {"nu": nu, **witness})
    norms = numbers.norms(nu)
    if norms and norms[-1] < 1:
        return _by_norm(numbers, nu, norms)
    if numbers.radius is not None and numbers.radius.is_below(Fraction(1, numbers.p ** (nu - 1))):
        return _by_radius(numbers, nu)
    lowest = f"the lowest is {number(min(norms))}" if norms else "not one was computed"
    more = "the time budget ended" if numbers.effort.struck else "a higher effort computes more"
    reason = f"the norms up to level {len(norms)} are not below 1 ({lowest}); {more}"
    return CONTRACTIVITY.undecided(f"does {operator} contract?", reason, {"nu": nu, "norms": norms})


def _by_norm(numbers: ScalarNumbers, nu: int, norms: tuple[Fraction, ...]) -> Finding:
    level, norm = len(norms), norms[-1]
    condition = f"{power(scaled(numbers, nu), level)} = {number(norm)} < 1"
    statement = f"{condition}, so φ is C^{nu - 1}"
    if level > 1:
        rate = certain(lambda: ball(norm) ** (ball(1) / level), 4)
        statement += f" (norms from L = 1: {series(norms, number)}; rate {rate})"
    witness: dict[str, Data] = {
        "nu": nu,
        "level": level,
        "norm": norm,
        "norms": norms,
        "condition": condition,
    }
    return CONTRACTIVITY.proved(statement, witness, interval(norm))


def _by_radius(numbers: ScalarNumbers, nu: int) -> Finding:
    radius, limit = numbers.radius, threshold(numbers.p, nu - 1)
    assert radius is not None
    name = f"ρ({last_difference(numbers)})"
    condition = f"{name} = {shown(radius)} < {limit}" if radius.exact else f"{name} ≤ {_bound(radius)} < {limit}"
    witness: dict[str, Data] = {"nu": nu, "radius_of": numbers.name, "condition": condition}
    return CONTRACTIVITY.proved(f"{scaled(numbers, nu)} contracts, as {condition}, so φ is C^{nu - 1}", witness)


def _bound(radius: Radius) -> str:
    return rounded_up(enclosed(radius).upper or 0.0, 12)


def convergence(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD201: whether S converges uniformly, to a limit that is not zero for some data (Dyn 1992, section 2).

    Theorem (Dyn 1992, Theorem 3.2, for any arity p): S converges uniformly iff its residue sums are 1 and
    ‖((1/p)S_1)^L‖∞ < 1 for some L. Both directions need no stability, and the mask judged is S's own, never a reduced
    one.

    Proved by the contraction of (1/p)S_ν at any ν <= k: it makes S_(ν-1), …, S_0 converge (Theorem 3.4), and the
    residue sums are among its hypotheses. Or, where the translates of φ are stable, by a Sobolev exponent (SD321) above
    1/2: φ is continuous then. Refuted by the residue sums (SD101), by a product of transition matrices that keeps
    (1/p)S_1 from contracting, by the eigen-condition (SD202), or because φ is not continuous (SD302).

    Witness: `by`, the code of the condition that decides, with its witness.

    Raises ContradictionError where S converges by one finding and not by another.
    """
    first = [contraction(numbers, 1)] if numbers.order else []
    conditions = (*facts.all(RESIDUE_SUMS), *first, *facts.all(EIGEN_CONDITION))
    against = next((finding for finding in conditions if finding.verdict is Verdict.REFUTED), None)
    found = [finding for each in first for finding in _convergent_by(each)]
    is_stable = numbers.reduced is numbers
    if against is None and (is_stable or not found):
        later = (contraction(numbers, nu) for nu in range(2, numbers.order + 1))
        found += [finding for each in later for finding in _convergent_by(each)]
    if is_stable and numbers.order and (mean := mean_decay(numbers)) is not None and mean.proves(0):
        found.append(CONVERGENCE.proved("S converges uniformly: φ is stable, and s > 1/2", {"by": SOBOLEV.code}))
    if against is not None and found:
        raise ContradictionError(f"S converges by {found[0].witness['by']} and does not by {against.code}")
    if found:
        return (best_of(found),)
    if against is not None:
        limit = " to a non-zero limit" if against.code == RESIDUE_SUMS.code else ""
        return (CONVERGENCE.refuted(f"S does not converge uniformly{limit}", _witness(against), why=against.statement),)
    if (obstacle := obstacle_to(numbers.reduced, 0)) is not None:
        why = f"φ is not continuous, as {who_is_stable(numbers)}, and {obstacle[0]}"
        witness: Witness = {"by": SMOOTHNESS.code, "order": 0}
        return (CONVERGENCE.refuted("S does not converge uniformly", witness, why=why),)
    return (CONVERGENCE.undecided("does S converge uniformly?", first[0].reason or ""),)


def _convergent_by(by: Finding) -> tuple[Finding, ...]:
    """The finding that S converges, by a contraction that is proved; none by another."""
    if by.verdict is not Verdict.PROVED:
        return ()
    statement = f"S converges uniformly: the residue sums are 1 and {text(by, 'condition')}"
    return (CONVERGENCE.proved(statement, _witness(by)),)


def _witness(by: Finding) -> Witness:
    return {"by": by.code, **by.witness}


_SMOOTHNESS_QUESTION = "how smooth is φ?"


def smoothness(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD302: the largest n for which φ, and with it every limit function, is proved C^n.

    Theorem (Dyn 1992, Theorem 3.4): if (1/p)S_(n+1) contracts, φ and every limit function are C^n. For an unstable mask
    the contraction is that of the reduced mask, whose φ0 is as smooth as φ (SD403); the limit functions Σ f_α φ(·-α)
    are so as well, where S converges (SD201). Hypotheses: those of SD301, checked there.

    Or by a bound of a joint spectral radius (SD310), or a Sobolev exponent (SD321) above n + 1/2, where they give more.

    Refuted: φ is not continuous, where no C^0 is in reach for the stable reduced mask (SD303's theorem for m = 0).

    Where S converges (SD201) φ is continuous, whatever the norms of the reduced mask say.

    Witness: `order`, n, and `by`, the code of the finding that proves it; refuted: the obstacle as in SD303.

    Raises ContradictionError where a stable φ is continuous and S does not converge.
    """
    if not numbers.is_normalised:
        return (SMOOTHNESS.skipped(_SMOOTHNESS_QUESTION, NOT_NORMALISED),)
    reduced, converges = numbers.reduced, facts.verdict(CONVERGENCE)
    scope = "φ and every limit function are" if converges is Verdict.PROVED else "φ is"
    but = ", but S does not converge" if converges is Verdict.REFUTED else ""
    found = []
    for finding in facts.all(CONTRACTIVITY):
        if finding.verdict is Verdict.PROVED:
            order, mask = integer(finding, "nu") - 1, " for the reduced scheme" if reduced is not numbers else ""
            statement = f"{scope} C^{order}: {text(finding, 'condition')}{mask}{but}"
            found.append(_proved(statement, order, {"by": CONTRACTIVITY.code}))
    for decay in decays(numbers, facts):
        if decay.by in (JOINT_RADIUS, SOBOLEV) and (n := decay.order) is not None:
            why = f"s > {n} + 1/2" if decay.by is SOBOLEV else f"{decay.shown} < {threshold(numbers.p, n)}"
            found.append(_proved(f"{scope} C^{n}: {why}{but}", n, {"by": decay.by.code, **decay.witness}))
    if converges is Verdict.PROVED:
        statement = "φ and every limit function are continuous, because S converges"
        found.append(_proved(statement, 0, {"by": CONVERGENCE.code}))
    if found:
        if converges is Verdict.REFUTED and reduced is numbers:
            raise ContradictionError("a stable φ is continuous and S does not converge")
        return (best_of(sorted(found, key=lambda each: -integer(each, "order"))),)
    if (obstacle := obstacle_to(reduced, 0)) is not None:
        return (SMOOTHNESS.refuted(f"φ is not continuous: {who_is_stable(numbers)}, and {obstacle[0]}", obstacle[1]),)
    return (SMOOTHNESS.undecided(_SMOOTHNESS_QUESTION, "the norms do not prove that φ is continuous"),)


def _proved(statement: str, order: int, witness: Witness) -> Finding:
    answers = {questions.SMOOTHNESS: Smoothness(order)}
    return SMOOTHNESS.proved(statement, {"order": order, **witness}, answers=answers)


def next_smoothness(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD303: whether C^(n+1) is refuted for a φ that is proved C^n.

    Theorem (Cavaretta, Dahmen & Micchelli 1991; Dyn 1992, 5.3 for interpolatory schemes): for stable φ, φ ∈ C^m iff α >
    m, where α = -log_p ρ and ρ is the joint spectral radius of the transition matrices of D = S_(Δ^k). So C^m is
    refuted by m >= k, because α <= k always, by a product of ℓ matrices with an eigenvalue |λ| >= p^(-mℓ), and by a
    Sobolev exponent s <= m (SD321), because α <= s. φ is itself the limit function of the data δ, so a refutation for φ
    is one for the scheme. Hypothesis, stability: an unstable mask is reduced first (SD403), and the numbers are those
    of the stable reduced mask.

    Witness: `order`, n+1, and either `sum_rule_order`, k, or the product (see obstacles.py), or `by`, SD321.

    Raises ContradictionError where C^(n+1) is proved and refuted.
    """
    if facts.verdict(SMOOTHNESS) is not Verdict.PROVED:
        return (NEXT_SMOOTHNESS.skipped("is φ smoother than proved?", "no smoothness of φ is proved"),)
    reduced, proved = numbers.reduced, integer(facts[SMOOTHNESS], "order")
    if obstacle_to(reduced, proved) is not None:
        raise ContradictionError(f"C^{proved} is proved and refuted")
    found = [
        NEXT_SMOOTHNESS.refuted(
            f"φ is not C^{proved + 1}: {who_is_stable(numbers)}, and {why}", {"order": proved + 1, **witness}
        )
        for why, witness in obstacles_to(reduced, proved + 1)
    ]
    if not found:
        reason = "no norm proves it and no short product of transition matrices excludes it; a higher effort may decide"
        return (NEXT_SMOOTHNESS.undecided(f"is φ C^{proved + 1}?", reason),)
    return (best_of(found),)
