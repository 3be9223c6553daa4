"""SD302: the largest n for which φ, and with it every limit function, is proved C^n.

Theorem (Dyn 1992, Theorem 3.4): if (1/p)S_(n+1) contracts, φ and every limit function are C^n. For an unstable mask the
contraction is that of the reduced mask, whose φ0 is as smooth as φ (SD403); the limit functions Σ f_α φ(·-α) are so as
well, where S converges (SD201). Hypotheses: those of SD301, checked there.

Refuted: φ is not continuous, where no C^0 is in reach for the stable reduced mask (SD303's theorem for m = 0).

Witness: `order`, n, and `level`, that of the contraction; refuted: the obstacle as in SD303.
"""

from __future__ import annotations

from subdiv_cli.model import Finding, Verdict
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.obstacles import product_obstacle, sum_rule_obstacle
from subdiv_cli.stages.stage import ContradictionError, Facts, Rule, integer, power, scaled, verdict

RULE = Rule("SD302", "smoothness", "Dyn 1992, Theorem 3.4")

_QUESTION = "how smooth is φ?"


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped(_QUESTION, "a(1) is not the arity: there is no φ with integral 1"),)
    reduced = numbers.reduced
    proved = [finding for finding in facts.get("SD301", ()) if finding.verdict is Verdict.PROVED]
    converges = verdict(facts, "SD201")
    if proved:
        order, level = integer(proved[-1], "nu") - 1, integer(proved[-1], "level")
        norm = f"{power(scaled(numbers.p, order + 1), level)} < 1"
        scope = "φ and every limit function are" if converges is Verdict.PROVED else "φ is"
        statement = f"{scope} C^{order}: {norm}" + (" for the reduced mask" if reduced is not numbers else "")
        if converges is Verdict.REFUTED:
            statement += ", but S diverges"
            if reduced is numbers:
                raise ContradictionError("a stable φ is continuous and S diverges")
        return (RULE.proved(statement, {"order": order, "level": level}),)
    obstacle = sum_rule_obstacle(reduced, 0) or product_obstacle(reduced, 0)
    if obstacle is not None:
        return (RULE.refuted(f"φ is not continuous: {obstacle[0]}", obstacle[1]),)
    return (RULE.undecided(_QUESTION, "the norms do not prove that φ is continuous"),)
