"""SD303: with φ proved C^n, is C^(n+1) refuted?

Theorem (Cavaretta, Dahmen & Micchelli 1991; Dyn 1992, 5.3 for interpolatory schemes): for stable φ, φ ∈ C^m iff
α > m, where α = -log_p ρ and ρ is the joint spectral radius of the transition matrices of D = S_(Δ^k). So C^m is
refuted by m >= k, because α <= k always, and by a product of ℓ matrices with an eigenvalue |λ| >= p^(-mℓ). φ is itself
the limit function of the data δ, so a refutation for φ is one for the scheme. Hypothesis, stability: an unstable mask
is reduced first (SD403), and the numbers are those of the stable reduced mask.

Witness: `order`, n+1, and either `sum_rule_order`, k, or the product (see obstacles.py).
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.obstacles import obstacle_to, who_is_stable
from subdiv_cli.kinds.scalar.stages.stage import integer
from subdiv_cli.model import Finding, Verdict

RULE = rules.NEXT_SMOOTHNESS


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if facts.verdict(rules.SMOOTHNESS) is not Verdict.PROVED:
        return (RULE.skipped("is φ smoother than proved?", "no smoothness of φ is proved"),)
    reduced, proved = numbers.reduced, integer(facts[rules.SMOOTHNESS], "order")
    if obstacle_to(reduced, proved) is not None:
        raise ContradictionError(f"C^{proved} is proved and refuted")
    obstacle = obstacle_to(reduced, proved + 1)
    if obstacle is None:
        reason = "no norm proves it and no short product of transition matrices excludes it; a higher effort may decide"
        return (RULE.undecided(f"is φ C^{proved + 1}?", reason),)
    statement = f"φ is not C^{proved + 1}: {who_is_stable(numbers)}, and {obstacle[0]}"
    return (RULE.refuted(statement, {"order": proved + 1, **obstacle[1]}),)
