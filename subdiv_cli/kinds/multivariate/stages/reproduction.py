"""SD618: the reproduction degree, the largest r for which S reproduces the polynomials of total degree r.

Theorem (Levin 2003, section 2; Conti & Hormann 2011 and Charina & Conti 2013 for dilations cI; FORMAT.md for any
expanding M). Let τ = (1/m) Σ_α a_α α, componentwise, and σ = (M - I)^-1 τ. S maps p(· + σ) to p(M^-1 (· + σ)) on Z^s
for all p of degree <= r iff the sum rules hold of order r + 1 and Σ_α a_α α^μ = m τ^μ for |μ| <= r; no other σ does
for r >= 1. In derivatives of the symbol, D^μ a(1, …, 1) = m Π_j τ_j (τ_j - 1) … (τ_j - μ_j + 1). So interpolatory
masks reproduce what they generate. Hypotheses: none but sum rules, which are checked.

Witness: `degree`; `shift`, τ; `defect`, a μ of degree r + 1 with another sum where r is below the generation degree.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import Data, Finding
from subdiv_cli.model import findings as questions

RULE = rules.REPRODUCTION


def run(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    if not numbers.order:
        return (RULE.skipped("which polynomials are reproduced?", "no sum rule holds"),)
    degree, shift, defect = numbers.reproduction
    witness: dict[str, Data] = {"degree": degree, "shift": shift, **({} if defect is None else {"defect": defect})}
    if defect is None:
        why = f"it generates degree {degree} only"
    else:
        why = f"Σ a_α α^μ is not m τ^μ for μ = ({', '.join(map(str, defect))})"
    tau = ", ".join(map(number, shift))
    statement = f"S reproduces the polynomials of total degree {degree} with parameter shift τ = ({tau})"
    answers = {questions.REPRODUCTION: degree}
    return (RULE.proved(f"{statement}, not {degree + 1}: {why}", witness, answers=answers),)
