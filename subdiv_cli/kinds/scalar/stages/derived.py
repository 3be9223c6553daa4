"""SD105: the derived schemes S_1, …, S_k.

Theorem (Dyn 1992, Proposition 3.1 and (3.17), for any arity p): with sum rules of order k there are schemes
S_ν, ν <= k, with d^ν S f = S_ν d^ν f for the divided differences d^ν = p^(νj) Δ^ν at level j; their symbols are
p^ν a(z) (z^(p-1)/(1+z+…+z^(p-1)))^ν. Division decides which of them exist.

Witness: `starts` and `masks`, the derived masks for ν = 1, …, k.
"""

from __future__ import annotations

from subdiv_cli.exact.text import laurent
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED, derived_names
from subdiv_cli.model import Data, Finding

RULE = rules.DERIVED_SCHEMES

_LONGEST_MASK = 6


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped("which derived schemes are there?", NOT_NORMALISED),)
    k = numbers.order
    if k == 0:
        return (RULE.refuted("there is no derived scheme: the first sum rule fails", {"starts": (), "masks": ()}),)
    masks = [numbers.difference(nu).scale(numbers.p**nu) for nu in range(1, k + 1)]
    witness: dict[str, Data] = {"starts": tuple(m.low for m in masks), "masks": tuple(m.coefficients() for m in masks)}
    shown = f"; S_{k} has the symbol {laurent(masks[-1])}" if masks[-1].degree < _LONGEST_MASK else ""
    exist = f"{derived_names(k)} exist{'s' if k == 1 else ''}"
    return (RULE.proved(f"{exist}, S_{k + 1} does not{shown}", witness),)
