"""SD103: the generation degree, the largest m with S π_m = π_m.

It is the sum-rule order minus one (Levin 2003, section 2), an identity of the mask: no hypothesis on convergence. For
an unstable refinable function the integer translates may span more polynomials than that.

Witness: `degree`, -1 where not even constants are generated.
"""

from __future__ import annotations

from subdiv_cli.model import Finding, Verdict
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.stage import Facts


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    degree = numbers.order - 1
    return (
        Finding(
            code="SD103",
            name="generation-degree",
            verdict=Verdict.PROVED if degree >= 0 else Verdict.REFUTED,
            statement=f"S generates the polynomials of degree {degree} and no higher"
            if degree >= 0
            else "S does not even generate constants",
            source="Levin 2003, section 2",
            witness={"degree": degree},
        ),
    )
