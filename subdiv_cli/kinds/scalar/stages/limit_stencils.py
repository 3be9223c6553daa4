"""SD502: limit stencils, the limit and its derivatives at i/p^k from the data of level k.

Theorem (Dyn 1992, Corollaries 4.3 and 4.6, for any arity p): where S converges, S^∞ f⁰ = Σ f^k_α φ(p^k·-α), so
(S^∞ f⁰)^(j)(i p^-k) = p^(jk) Σ_β w_β f^k_(i+β) with w_β = φ^(j)(-β), for every j with φ ∈ C^j. Hypotheses: S converges
(SD201), checked; the values of φ^(j): SD501.

Witness: `starts` and `stencils`, for each j the first index and the weights.
"""

from __future__ import annotations

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_integers
from subdiv_cli.kinds.scalar.stages.integer_values import unusable
from subdiv_cli.model import Data, Finding
from subdiv_cli.model.formulas import stencil

RULE = rules.LIMIT_STENCILS

_QUESTION = "how is the limit read off the data of a level?"
_MOST_WEIGHTS = 7


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    if (why := unusable(facts)) is not None:
        return (RULE.skipped(_QUESTION, why),)
    values = facts[rules.INTEGER_VALUES].witness["values"]
    orders = len(values) if isinstance(values, tuple) else 0
    stencils = [at_integers(numbers, order).reversed() for order in range(orders)]
    witness: dict[str, Data] = {
        "starts": tuple(w.low for w in stencils),
        "stencils": tuple(w.coefficients() for w in stencils),
    }
    p = numbers.p
    statement = f"S^∞ f at i/{p}^k is {_text(stencils[0])} with f = f^k"
    if orders > 1:
        statement += f"; its derivative is {p}^k times {_text(stencils[1])}"
    if orders > 2:
        statement += f"; there are stencils for the derivatives up to order {orders - 1}"
    return (RULE.proved(statement, witness),)


def _text(w: Laurent) -> str:
    c = w.coefficients()
    if len(c) > _MOST_WEIGHTS:
        return f"a combination of f_(i{w.low:+d}), …, f_(i{w.low + len(c) - 1:+d})"
    return stencil(w.low, c, lambda index: f"f_({index})" if len(index) > 1 else f"f_{index}")
