"""SD303: with C^n proved, is C^(n+1) refuted?

Theorem (Cavaretta, Dahmen & Micchelli 1991; Dyn 1992, 5.3 for interpolatory schemes): for stable φ, φ ∈ C^m iff
α > m, where α = -log_p ρ and ρ is the joint spectral radius of the transition matrices of D = S_(Δ^k). So C^m is
refuted by m >= k, because α <= k always (the matrices of D have Σ_ε T_ε e = p^(1-k) e), and by a product of ℓ matrices
with an eigenvalue |λ| >= p^(-mℓ). Hypothesis, stability (SD402): it must be proved, else the finding is undecided.

Witness: `order`, n+1, and either `sum_rule_order`, k, or the product as in SD301.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.model import Data, Finding, Verdict
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.contractivity import excess, product_witness
from subdiv_cli.stages.stage import ContradictionError, Facts, integer, verdict


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if verdict(facts, "SD302") is not Verdict.PROVED:
        reason = facts["SD302"][0].reason
        return (_finding(Verdict.SKIPPED, "are the limit functions smoother than proved?", {}, reason),)
    proved = integer(facts["SD302"][0], "order")
    obstacle = _obstacle(numbers, proved + 1)
    stable = verdict(facts, "SD402") is Verdict.PROVED
    if stable and _obstacle(numbers, proved) is not None:
        raise ContradictionError(f"C^{proved} is proved by SD302 and refuted by SD303")
    if obstacle is None:
        reason = "no norm proves it and no short product of transition matrices excludes it; a higher effort may decide"
        return (_finding(Verdict.UNDECIDED, f"are the limit functions C^{proved + 1}?", {}, reason),)
    if not stable:
        reason = f"φ is not proved stable, and without stability this is no obstacle: {obstacle[0]}"
        return (_finding(Verdict.UNDECIDED, f"are the limit functions C^{proved + 1}?", {}, reason),)
    statement = f"not every limit function is C^{proved + 1}: φ is stable, and {obstacle[0]}"
    return (_finding(Verdict.REFUTED, statement, {"order": proved + 1, **obstacle[1]}),)


def _obstacle(numbers: ScalarNumbers, order: int) -> tuple[str, dict[str, Data]] | None:
    """Why a stable φ is not C^order, as text and witness; None where nothing is known against it."""
    k, product = numbers.order, numbers.best_product
    if order >= k:
        return f"C^{order} needs sum rules of order {order + 1}, but a(z) has order {k}", {"sum_rule_order": k}
    if product is not None and product.compare(Fraction(1, numbers.p**order)) >= 0:
        return excess(product, numbers, order), product_witness(product)
    return None


def _finding(answer: Verdict, statement: str, witness: dict[str, Data], reason: str | None = None) -> Finding:
    return Finding(
        code="SD303",
        name="next-smoothness",
        verdict=answer,
        statement=statement,
        source="Cavaretta, Dahmen & Micchelli 1991; Dyn 1992, Theorem 5.3",
        reason=reason,
        witness=witness,
    )
