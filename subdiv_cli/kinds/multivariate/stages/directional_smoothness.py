"""SD607: C^1 by directional factors.

Theorem (Dyn 1992, Corollary 7.9, for M = cI): let the coset sums be 1, a(z) = q(z) Π_(i<=s+1) G_i(z), G_i(z) = 1 +
z^θ_i + … + z^((c-1)θ_i), any s of the directions with determinant ±1. If the schemes of all a_ij = c a/(G_i G_j),
i < j, contract, ‖S_(a_ij)^L‖∞ < 1 for some L each, S converges uniformly and φ is C^1. Hypotheses: all checked.
Sufficient.

Why: ∇_i ∇_j S = (1/c) S_(a_ij) ∇_i ∇_j, and the (1-z^θ_i)(1-z^θ_j), i < j, generate all polynomials that vanish at 1 to
order 2: any s+1 such directions are ±θ_1 ± … ± θ_s = 0 with one more, so u_i² is among the products modulo order 3, and
elsewhere some product is not 0. So ρ_2 < 1/c, and the sum rules are of order 2.

There is a finding only where the mask has such factors and all quotients contract within the effort, and φ is neither
a box spline (SD603) nor a tensor product (SD609).

Witness: `directions`, pairs; `levels`, `norms`. `proof`: `quotients`, a/(G_i G_j).
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import Data, Finding

RULE = rules.DIRECTIONAL_SMOOTHNESS


def run(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    found = None if numbers.box is not None or numbers.parts else numbers.pair_contractions
    if found is None:
        return ()
    parts = [
        f"‖S_({', '.join(map(str, first))})({', '.join(map(str, second))})"
        + (f"^{c.level}" if c.level > 1 else "")
        + f"‖∞ = {number(c.norm)}"
        for c in found
        for first, second in [c.directions]
    ]
    witness: dict[str, Data] = {
        "directions": tuple(c.directions for c in found),
        "levels": tuple(c.level for c in found),
        "norms": tuple(c.norm for c in found),
    }
    proof: dict[str, Data] = {
        "quotients": tuple(tuple((alpha, x) for alpha, x in sorted(c.quotient.items())) for c in found)
    }
    statement = (
        f"φ is C^1: the schemes of {len(found)} quotients by two directional factors contract: {', '.join(parts)}"
    )
    return (RULE.proved(statement, witness, proof=proof),)
