"""SD301: for ν = 1, …, k, does (1/p)S_ν contract?

Theorem (Dyn 1992, 3.2 and 3.4, for any arity p): with sum rules of order ν, ‖((1/p)S_ν)^L‖∞ < 1 for some L iff S_(ν-1)
converges uniformly, and then φ and every limit function are C^(ν-1). Hypotheses a(1) = p and the sum rules: checked,
they are what k says. Norms decide upward.

Refuted without norms: the joint spectral radius of (1/p)S_ν is max(1/p, p^(ν-1) ρ) with ρ that of D = S_(Δ^k), the last
difference scheme, so a product Π of ℓ transition matrices of D with an eigenvalue |λ| >= p^(-(ν-1)ℓ) excludes every L.

No stability is needed for either: the finding speaks of S_ν. For an unstable mask the schemes S_ν are those of the
reduced mask (SD403), and what they prove holds for φ.

Witness, proved: `nu`, `level`, `norm` and the `norms` of levels 1 to `level`. Refuted: `nu`, `word` (its matrices are
multiplied from right to left), `eigenvalue` as minimal polynomial (lowest coefficient first) and isolating box.
Undecided: `nu` and the `norms` computed.
"""

from __future__ import annotations

from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, number
from subdiv_cli.model import Finding
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.obstacles import product_obstacle
from subdiv_cli.stages.stage import Facts, Rule, power, scaled, series

RULE = Rule("SD301", "contractivity", "Dyn 1992, Theorems 3.2 and 3.4")


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    return tuple(contraction(numbers.reduced, nu) for nu in range(1, numbers.reduced.order + 1))


def contraction(numbers: ScalarNumbers, nu: int) -> Finding:
    """Whether (1/p)S_ν contracts, for the mask of these numbers and 1 <= ν <= k."""
    operator = scaled(numbers.p, nu)
    if (obstacle := product_obstacle(numbers, nu - 1)) is not None:
        text, witness = obstacle
        return RULE.refuted(f"{operator} does not contract: {text}", {"nu": nu, **witness})
    norms = numbers.norms(nu)
    level = next((level for level, norm in enumerate(norms, 1) if norm < 1), None)
    if level is None:
        lowest = f"the lowest is {number(min(norms))}" if norms else "not one was computed"
        reason = f"the norms up to level {len(norms)} are not below 1 ({lowest}); a higher effort computes more"
        return RULE.undecided(f"does {operator} contract?", reason, {"nu": nu, "norms": norms})
    norms = norms[:level]
    statement = f"{power(operator, level)} = {number(norms[-1])} < 1, so φ is C^{nu - 1}"
    if level > 1:
        rate = certain(ball(norms[-1]) ** (ball(1) / level), 4)
        statement += f" (norms from L = 1: {series(norms, number)}; rate {rate})"
    witness = {"nu": nu, "level": level, "norm": norms[-1], "norms": norms}
    return RULE.proved(statement, witness, interval(norms[-1]))
