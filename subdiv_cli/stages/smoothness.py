"""SD302: the largest n for which all limit functions are proved C^n.

Theorem (Dyn 1992, Theorem 3.4): if (1/p)S_(n+1) contracts, every limit function is C^n, and the schemes S_(n-1), …, S_0
converge. Hypotheses: SD301 at ν = n+1, which checks the sum rules. No stability is needed.

Witness: `order`, n, and `level`, that of the contraction.
"""

from __future__ import annotations

from subdiv_cli.model import Finding, Verdict
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.stage import Facts, integer, power, scaled, verdict


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    converges = verdict(facts, "SD201")
    if converges is not Verdict.PROVED:
        return (
            Finding(
                code="SD302",
                name="smoothness",
                verdict=Verdict.SKIPPED,
                statement="how smooth are the limit functions?",
                source="Dyn 1992, Theorem 3.4",
                reason="S diverges" if converges is Verdict.REFUTED else "convergence is not decided",
            ),
        )
    last = [finding for finding in facts["SD301"] if finding.verdict is Verdict.PROVED][-1]
    order, level = integer(last, "nu") - 1, integer(last, "level")
    return (
        Finding(
            code="SD302",
            name="smoothness",
            verdict=Verdict.PROVED,
            statement=f"every limit function is C^{order}: {power(scaled(numbers.p, order + 1), level)} < 1",
            source="Dyn 1992, Theorem 3.4",
            witness={"order": order, "level": level},
        ),
    )
