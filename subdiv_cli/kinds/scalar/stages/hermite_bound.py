"""SD512: how close the Hermite interpolant of the limit at i p^-k is to the limit.

Theorem (Dyn 1992, Proposition 4.7, for any arity p): let S_ν converge, ν = 2m. The piecewise polynomial Q^k of degree
ν-1 that has the values and derivatives of S^∞ f up to order m-1 at the points i p^-k satisfies
‖S^∞ f - Q^k‖∞ <= H p^-(νk) ‖Δ^ν f‖∞. Here H = B/(2^ν ν!), from the error of Hermite interpolation on an interval of
length p^-k and ‖(S^∞ f)^(ν)‖∞ = ‖S_ν^∞ Δ^ν f‖∞ <= B ‖Δ^ν f‖∞; B = ‖S_ν^j‖∞ + 2 C μ^⌊j/L⌋ by the bound of SD511 for S_ν.
The data of Q^k are known exactly (SD502). Hypotheses: S converges (SD201), and a norm of ((1/p)S_(ν+1))^L below 1,
which makes S_ν converge: checked; ν is the largest even order for which there is one.

Witness: `order`, ν; `norms` of ((1/p)S_(ν+1))^1, …, ^L; `derived_constant`, C; `level`, j, and `norm`, that of
((1/p)S_ν)^j; `constant`, H.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.error_bounds import hermite_bound
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import integer
from subdiv_cli.model import Data, Finding, Verdict

RULE = rules.HERMITE_BOUND

_QUESTION = "how close to the limit is its Hermite interpolant?"


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    smooth = facts.verdict(rules.SMOOTHNESS) is Verdict.PROVED and facts.verdict(rules.CONVERGENCE) is Verdict.PROVED
    order = min(integer(facts[rules.SMOOTHNESS], "order"), numbers.order - 1) if smooth else 0
    for nu in range(order - order % 2, 0, -2):
        found = hermite_bound(numbers, nu)
        if found is not None:
            break
    else:
        return (RULE.skipped(_QUESTION, "S_2 is not proved to converge"),)
    witness: dict[str, Data] = {
        "order": nu,
        "norms": found.bound.norms,
        "derived_constant": found.bound.constant,
        "level": found.level,
        "norm": found.norm,
        "constant": found.constant,
    }
    bound = f"{number(found.constant)} · {numbers.p}^(-{nu}k) ‖Δ^{nu} f‖∞"
    statement = f"‖S^∞ f - Q^k‖∞ ≤ {bound} for the Hermite interpolant Q^k of degree {nu - 1} at i/{numbers.p}^k"
    return (RULE.proved(statement, witness),)
