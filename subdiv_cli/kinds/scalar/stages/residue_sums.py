"""SD101: does S reproduce constants?

Theorem (Dyn 1992, Proposition 2.1, for any arity p): a scheme that converges uniformly, to a limit that is not zero for
some data, has Σ_β a_(γ+pβ) = 1 for every residue class γ mod p. No hypothesis. Equivalent: a(1) = p and a(ζ) = 0 at
every other p-th root of unity ζ.

Witness: `sums`, the p class sums.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Finding

RULE = rules.RESIDUE_SUMS


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    p, sums = numbers.p, numbers.residue_sums
    if all(s == 1 for s in sums):
        return (RULE.proved(f"each of the {p} residue classes of the mask sums to 1", {"sums": sums}),)
    listed = ", ".join(f"Σ a_({gamma}+{p}β) = {number(s)}" for gamma, s in enumerate(sums))
    return (RULE.refuted(f"the residue classes must sum to 1 each, but {listed}", {"sums": sums}),)
