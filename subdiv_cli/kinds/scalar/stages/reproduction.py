"""SD104: the reproduction degree, the largest r with S^∞ q = q for all q in π_r sampled at the right parameters.

Theorem (Conti & Hormann 2011): with τ = a'(1)/p, the scheme reproduces π_r iff it generates π_r and
a^(j)(1) = p·τ(τ-1)…(τ-j+1) for j = 0, …, r. The samples belong to the parameters i + τ/(p-1). An identity of the mask.

Witness: `degree`, where there is one; `shift`, τ; `defects`, a^(j)(1) - p·Π_(i<j)(τ-i) for j = 0, …, generation degree.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.polynomials import parameter_shift, reproduction_defects
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED
from subdiv_cli.model import Data, Finding
from subdiv_cli.model import findings as questions

RULE = rules.REPRODUCTION


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped("which polynomials are reproduced?", NOT_NORMALISED),)
    p, generation = numbers.p, numbers.order - 1
    tau = parameter_shift(numbers.symbol, p)
    defects = reproduction_defects(numbers.symbol, p, generation)
    degree = next((j for j, defect in enumerate(defects) if defect), len(defects)) - 1
    witness: dict[str, Data] = {"shift": tau, "defects": defects}
    if degree < 0:
        return (RULE.refuted("S does not even reproduce constants", witness),)
    witness = {"degree": degree, **witness}
    if degree == generation:
        why = f"it generates degree {generation} only"
    else:
        why = f"a^({degree + 1})(1) is off by {number(defects[degree + 1])}"
    statement = f"S reproduces the polynomials of degree {degree} with parameter shift τ = {number(tau)}"
    answers = {questions.REPRODUCTION: degree}
    return (RULE.proved(f"{statement}, not {degree + 1}: {why}", witness, answers=answers),)
