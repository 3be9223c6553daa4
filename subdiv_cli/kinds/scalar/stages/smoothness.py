"""SD302: the largest n for which φ, and with it every limit function, is proved C^n.

Theorem (Dyn 1992, Theorem 3.4): if (1/p)S_(n+1) contracts, φ and every limit function are C^n. For an unstable mask the
contraction is that of the reduced mask, whose φ0 is as smooth as φ (SD403); the limit functions Σ f_α φ(·-α) are so as
well, where S converges (SD201). Hypotheses: those of SD301, checked there.

Refuted: φ is not continuous, where no C^0 is in reach for the stable reduced mask (SD303's theorem for m = 0).

Where S converges (SD201) φ is continuous, whatever the norms of the reduced mask say.

Witness: `order`, n, and `by`, the code of the finding that proves it; refuted: the obstacle as in SD303.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.obstacles import obstacle_to, who_is_stable
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED, integer, text
from subdiv_cli.model import Finding, Rule, Smoothness, Verdict
from subdiv_cli.model import findings as questions

RULE = rules.SMOOTHNESS

_QUESTION = "how smooth is φ?"


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped(_QUESTION, NOT_NORMALISED),)
    reduced = numbers.reduced
    proved = [finding for finding in facts.all(rules.CONTRACTIVITY) if finding.verdict is Verdict.PROVED]
    converges = facts.verdict(rules.CONVERGENCE)
    if not proved and converges is Verdict.PROVED:
        statement = "φ and every limit function are continuous, because S converges"
        return (_proved(statement, 0, rules.CONVERGENCE),)
    if proved:
        order = integer(proved[-1], "nu") - 1
        scope = "φ and every limit function are" if converges is Verdict.PROVED else "φ is"
        mask = " for the reduced scheme" if reduced is not numbers else ""
        statement = f"{scope} C^{order}: {text(proved[-1], 'condition')}{mask}"
        if converges is Verdict.REFUTED:
            statement += ", but S does not converge"
            if reduced is numbers:
                raise ContradictionError("a stable φ is continuous and S does not converge")
        return (_proved(statement, order, rules.CONTRACTIVITY),)
    if (obstacle := obstacle_to(reduced, 0)) is not None:
        return (RULE.refuted(f"φ is not continuous: {who_is_stable(numbers)}, and {obstacle[0]}", obstacle[1]),)
    return (RULE.undecided(_QUESTION, "the norms do not prove that φ is continuous"),)


def _proved(statement: str, order: int, by: Rule) -> Finding:
    answers = {questions.SMOOTHNESS: Smoothness(order)}
    return RULE.proved(statement, {"order": order, "by": by.code}, answers=answers)
