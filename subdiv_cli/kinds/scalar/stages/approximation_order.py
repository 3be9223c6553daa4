"""SD504: how fast smooth functions are approximated on finer and finer grids, with and without Q.

Theorem (Levin 2003, Theorem 2.7): where S converges and a local, bounded operator Q has S^∞ Q f = f for f ∈ π_m,
‖S^∞ Q_h f - f‖∞ = O(h^(m+1)) for every f with a bounded derivative of order m+1, Q_h at the step h. With Q of SD503 m
is the generation degree; with mere samples at i + τ/(p-1), which is such an operator too, it is the reproduction degree
(SD104). Hypotheses: those of SD503.

Witness: `with_q` and `without_q`, the orders.
"""

from __future__ import annotations

from subdiv_cli.exact.text import number
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.polynomials import parameter_shift
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.integer_values import unusable
from subdiv_cli.kinds.scalar.stages.stage import integer
from subdiv_cli.model import Finding, Verdict

RULE = rules.APPROXIMATION_ORDER


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if facts.verdict(rules.QUASI_INTERPOLATION) is not Verdict.PROVED:
        return (RULE.skipped("to which order are functions approximated?", unusable(facts) or "Q is not known"),)
    with_q, without_q = numbers.order, integer(facts[rules.REPRODUCTION], "degree") + 1
    shift = parameter_shift(numbers.symbol, numbers.p) / (numbers.p - 1)
    where = "the integers" if not shift else f"i {'+' if shift > 0 else '-'} {number(abs(shift))}"
    statement = f"S^∞ Q approximates smooth functions to order {with_q}"
    statement += f", and S^∞ of their samples at {where} to order {without_q}"
    return (RULE.proved(statement, {"with_q": with_q, "without_q": without_q}),)
