"""SD102: the sum-rule order k, the largest k for which (1+z+…+z^(p-1))^k divides a(z).

An identity of polynomials: a = (1+…+z^(p-1))^k q, and q leaves a remainder by one more factor. The sum rules speak of
masks with a(1) = p only: checked.

Witness: `order`; `cofactor_start` and `cofactor`, the coefficients of q; `remainder`, those of the failing division.
"""

from __future__ import annotations

from subdiv_cli.exact.text import laurent
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED
from subdiv_cli.model import Data, Finding
from subdiv_cli.model import findings as questions

RULE = rules.SUM_RULES

_LONGEST_COFACTOR = 7


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    if not numbers.is_normalised:
        return (RULE.skipped("which sum rules hold?", NOT_NORMALISED),)
    p, k = numbers.p, numbers.order
    cofactor, remainder = numbers.sum_rules[1:]
    witness: dict[str, Data] = {
        "order": k,
        "cofactor_start": cofactor.low,
        "cofactor": cofactor.coefficients(),
        "remainder": remainder.coefficients(),
    }
    answers = {questions.SUM_RULES: k}
    factor = "1+z" if p == 2 else "1+z+z^2" if p == 3 else f"1+…+z^{p - 1}"
    if k == 0:
        return (RULE.refuted(f"no sum rule holds: {factor} does not divide a(z)", witness, answers=answers),)
    short = len(cofactor.coefficients()) <= _LONGEST_COFACTOR
    quotient = laurent(cofactor) if short else f"a polynomial of degree {cofactor.degree}"
    power = f"^{k}" if k > 1 else ""
    statement = f"sum rules of order {k}, not {k + 1}: a(z) = ({factor}){power} q(z), q(z) = {quotient}"
    return (RULE.proved(statement, witness, answers=answers),)
