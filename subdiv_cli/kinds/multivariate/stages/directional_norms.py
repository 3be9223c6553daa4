"""SD604: directional difference schemes that contract.

Theorem (Dyn 1992, remark after Proposition 6.10, for any dilation c I): let a(z) = d_i(z) (1 + z^θ_i + … +
z^((c-1)θ_i)) for s directions with det(θ_1, …, θ_s) = ±1, and let the coset sums be 1. Then Δ_θ_i S = S_(d_i) Δ_θ_i,
and if ‖S_(d_i)^L‖∞ < 1 for each i and some L, S converges uniformly. Hypotheses: all checked. Sufficient only.

There is a finding only where the mask has such factors and they all contract within the effort, and where it is no
tensor product (SD609).

Witness: `directions`, `levels`, `norms`.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import Data, Finding

RULE = rules.DIRECTIONAL_NORMS


def run(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    found = None if numbers.parts else numbers.contractions
    if found is None:
        return ()
    parts = [
        f"‖S_({', '.join(map(str, c.direction))})" + (f"^{c.level}" if c.level > 1 else "") + f"‖∞ = {number(c.norm)}"
        for c in found
    ]
    witness: dict[str, Data] = {
        "directions": tuple(c.direction for c in found),
        "levels": tuple(c.level for c in found),
        "norms": tuple(c.norm for c in found),
    }
    proof: dict[str, Data] = {
        "quotients": tuple(tuple((alpha, x) for alpha, x in sorted(c.quotient.items())) for c in found)
    }
    statement = f"the difference schemes in {len(found)} directions contract: {', '.join(parts)}"
    return (RULE.proved(statement, witness, proof=proof),)
