"""SD104: the reproduction degree, the largest r with S^∞ q = q for all q in π_r sampled at the right parameters.

Theorem (Conti & Hormann 2011): with τ = a'(1)/p, the scheme reproduces π_r iff it generates π_r and
a^(j)(1) = p·τ(τ-1)…(τ-j+1) for j = 0, …, r. The samples belong to the parameters i + τ/(p-1). An identity of the mask.

Witness: `degree`; `shift`, τ; `defects`, a^(j)(1) - p·Π_(i<j)(τ-i) for j = 0, …, generation degree.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.quantities.polynomials import parameter_shift, reproduction_defects
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.stage import Facts


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    p, generation = numbers.p, numbers.order - 1
    tau = parameter_shift(numbers.symbol, p)
    defects = reproduction_defects(numbers.symbol, p, generation)
    degree = next((j for j, defect in enumerate(defects) if defect), len(defects)) - 1
    if degree < 0:
        statement = "S does not even reproduce constants"
    else:
        statement = f"S reproduces the polynomials of degree {degree} with parameter shift τ = {number(tau)}"
        statement += (
            f", not {degree + 1}: it generates degree {generation} only"
            if degree == generation
            else f", not {degree + 1}: a^({degree + 1})(1) is off by {number(defects[degree + 1])}"
        )
    return (
        Finding(
            code="SD104",
            name="reproduction-degree",
            verdict=Verdict.PROVED if degree >= 0 else Verdict.REFUTED,
            statement=statement,
            source="Conti & Hormann 2011",
            witness={"degree": degree, "shift": tau, "defects": defects},
        ),
    )
