"""Stages on convergence and smoothness (SD201, SD301 to SD303)."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, rounded_up, sized, valued
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import ContradictionError, Facts, asking
from subdiv_cli.kinds.radius import enclosed, shown
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
    Obstacle,
    obstacle_to,
    obstacles_to,
    product_obstacle,
    put_product,
    threshold,
    who_is_stable,
)
from subdiv_cli.kinds.scalar.stages.wording import NOT_NORMALISED, last_difference, power, scaled, series
from subdiv_cli.kinds.scalar.witnesses import (
    ContractivityWitness,
    ConvergenceWitness,
    NextSmoothnessWitness,
    SmoothnessWitness,
)
from subdiv_cli.model import Finding, Smoothness, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import best_of


@asking()
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
        witness: ContractivityWitness = {"nu": nu}
        put_product(witness, obstacle[1])
        return CONTRACTIVITY.refuted(f"{operator} does not contract: {obstacle[0]}", witness)
    norms = numbers.norms(nu)
    if norms and norms[-1] < 1:
        return _by_norm(numbers, nu, norms)
    if numbers.radius is not None and numbers.radius.is_below(Fraction(1, numbers.p ** (nu - 1))):
        return _by_radius(numbers, nu)
    lowest = f"the lowest is {valued(min(norms))}" if norms else "not one was computed"
    reason = f"the norms up to level {len(norms)} are not below 1 ({lowest}); a higher effort computes more"
    return CONTRACTIVITY.undecided(f"does {operator} contract?", reason, {"nu": nu, "norms": norms})


def _by_norm(numbers: ScalarNumbers, nu: int, norms: tuple[Fraction, ...]) -> Finding:
    level, norm = len(norms), norms[-1]
    condition = f"{power(scaled(numbers, nu), level)} = {valued(norm)} < 1"
    statement = f"{condition}, so φ is C^{nu - 1}"
    if level > 1:
        rate = certain(lambda: ball(norm) ** (ball(1) / level), 4)
        statement += f" (norms from L = 1: {series(norms, sized)}; rate {rate})"
    witness: ContractivityWitness = {
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
    witness: ContractivityWitness = {"nu": nu, "radius_of": numbers.name, "condition": condition}
    return CONTRACTIVITY.proved(f"{scaled(numbers, nu)} contracts, as {condition}, so φ is C^{nu - 1}", witness)


def _bound(radius: Radius) -> str:
    return rounded_up(enclosed(radius).upper or 0.0, 12)


_CONVERGENCE_QUESTION = "does S converge uniformly?"


@asking((CONVERGENCE, _CONVERGENCE_QUESTION))
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
    proofs = [finding for each in first for finding in _convergent_by(each)]
    is_stable = numbers.reduced is numbers
    if against is None and (is_stable or not proofs):
        later = (contraction(numbers, nu) for nu in range(2, numbers.order + 1))
        proofs += [finding for each in later for finding in _convergent_by(each)]
    if is_stable and numbers.order and (mean := mean_decay(numbers)) is not None and mean.proves(0):
        why = "φ is stable, and s > 1/2"
        proofs.append(CONVERGENCE.proved(f"S converges uniformly: {why}", {"by": SOBOLEV.code}, why=why))
    if against is not None and proofs:
        by = CONVERGENCE.witness_of(proofs[0])["by"]
        raise ContradictionError(f"S converges by {by} and does not by {against.code}")
    if proofs:
        return (best_of(proofs),)
    if against is not None:
        limit = " to a non-zero limit" if against.code == RESIDUE_SUMS.code else ""
        statement = f"S does not converge uniformly{limit}: {against.statement}"
        return (CONVERGENCE.refuted(statement, _witness(against), why=against.statement),)
    if (obstacle := obstacle_to(numbers.reduced, 0)) is not None:
        why = f"φ is not continuous, as {who_is_stable(numbers)}, and {obstacle.text}"
        return (CONVERGENCE.refuted(f"S does not converge uniformly: {why}", {"by": SMOOTHNESS.code}, why=why),)
    return (CONVERGENCE.undecided(_CONVERGENCE_QUESTION, first[0].reason or ""),)


def _convergent_by(by: Finding) -> tuple[Finding, ...]:
    """The finding that S converges, by a contraction that is proved; none by another."""
    if by.verdict is not Verdict.PROVED:
        return ()
    why = f"the residue sums are 1 and {CONTRACTIVITY.witness_of(by)['condition']}"
    return (CONVERGENCE.proved(f"S converges uniformly: {why}", _witness(by), why=why),)


def _witness(by: Finding) -> ConvergenceWitness:
    return CONVERGENCE.form({"by": by.code, **by.witness})


_SMOOTHNESS_QUESTION = "how smooth is φ?"


@asking((SMOOTHNESS, _SMOOTHNESS_QUESTION))
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
    mask = " for the reduced scheme" if reduced is not numbers else ""
    but = ", but S does not converge" if converges is Verdict.REFUTED else ""
    proofs = []
    for finding in facts.all(CONTRACTIVITY):
        if finding.verdict is Verdict.PROVED:
            contracts = CONTRACTIVITY.witness_of(finding)
            n, why = contracts["nu"] - 1, f"{contracts['condition']}{mask}{but}"
            proofs.append((n, _proved(f"{scope} C^{n}: ", why, {"order": n, "by": CONTRACTIVITY.code})))
    for decay in decays(numbers, facts):
        if decay.by in (JOINT_RADIUS, SOBOLEV) and (order := decay.order) is not None:
            size = f"s > {order} + 1/2" if decay.by is SOBOLEV else f"{decay.shown} < {threshold(numbers.p, order)}"
            by_decay: SmoothnessWitness = {"order": order, "by": decay.by.code}
            if decay.by is JOINT_RADIUS:
                by_decay["radius_of"] = decay.numbers.name
            proofs.append((order, _proved(f"{scope} C^{order}: ", size + but, by_decay)))
    if converges is Verdict.PROVED:
        what = "φ and every limit function are continuous, because "
        proofs.append((0, _proved(what, "S converges", {"order": 0, "by": CONVERGENCE.code})))
    if proofs:
        if converges is Verdict.REFUTED and reduced is numbers:
            raise ContradictionError("a stable φ is continuous and S does not converge")
        return (best_of([finding for _, finding in sorted(proofs, key=lambda pair: -pair[0])]),)
    if (obstacle := obstacle_to(reduced, 0)) is not None:
        witness: SmoothnessWitness = {}
        obstacle.put_into(witness)
        why = f"{who_is_stable(numbers)}, and {obstacle.text}"
        return (SMOOTHNESS.refuted(f"φ is not continuous: {why}", witness, why=why),)
    return (SMOOTHNESS.undecided(_SMOOTHNESS_QUESTION, "the norms do not prove that φ is continuous"),)


def _proved(what: str, why: str, witness: SmoothnessWitness) -> Finding:
    answers = {questions.SMOOTHNESS: Smoothness(witness["order"])}
    return SMOOTHNESS.proved(what + why, witness, answers=answers, why=why)


_NEXT_SMOOTHNESS_QUESTION = "is φ smoother than proved?"


@asking((NEXT_SMOOTHNESS, _NEXT_SMOOTHNESS_QUESTION))
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
        return (NEXT_SMOOTHNESS.skipped(_NEXT_SMOOTHNESS_QUESTION, "no smoothness of φ is proved"),)
    reduced, proved = numbers.reduced, facts.witness(SMOOTHNESS)["order"]
    if obstacle_to(reduced, proved) is not None:
        raise ContradictionError(f"C^{proved} is proved and refuted")
    obstacles = [_not_smoother(numbers, proved + 1, obstacle) for obstacle in obstacles_to(reduced, proved + 1)]
    if not obstacles:
        reason = "no norm proves it and no short product of transition matrices excludes it; a higher effort may decide"
        return (NEXT_SMOOTHNESS.undecided(f"is φ C^{proved + 1}?", reason),)
    return (best_of(obstacles),)


def _not_smoother(numbers: ScalarNumbers, m: int, obstacle: Obstacle) -> Finding:
    why = f"{who_is_stable(numbers)}, and {obstacle.text}"
    witness: NextSmoothnessWitness = {"order": m}
    obstacle.put_into(witness)
    return NEXT_SMOOTHNESS.refuted(f"φ is not C^{m}: {why}", witness, why=why)
