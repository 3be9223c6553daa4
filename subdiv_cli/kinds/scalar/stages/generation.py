"""SD103: the generation degree, the largest m with S π_m = π_m.

It is the sum-rule order minus one (Levin 2003, section 2), an identity of the mask: no hypothesis on convergence. For
an unstable refinable function the integer translates may span more polynomials than that.

Witness: `degree`, where there is one.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED
from subdiv_cli.model import Finding
from subdiv_cli.model import findings as questions

RULE = rules.GENERATION


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped("which polynomials are generated?", NOT_NORMALISED),)
    degree = numbers.order - 1
    if degree < 0:
        return (RULE.refuted("S does not even generate constants", {}),)
    statement = f"S generates the polynomials of degree {degree} and no higher"
    return (RULE.proved(statement, {"degree": degree}, answers={questions.GENERATION: degree}),)
