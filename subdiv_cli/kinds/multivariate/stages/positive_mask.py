"""SD608: a positive mask on a box.

Theorem (Dyn 1992, Theorem 6.4, for M = cI): let the coset sums be 1, let the support be all indices of a box
Π[l_i, u_i], the coefficients there positive, and u_i - l_i >= c for each i. Then S converges uniformly. Hypotheses: all
checked. Dyn asks for l < 0 < u with c = 2: a shift of the mask by e shifts S^k f by (c^k - 1)/(c - 1) e, its limit by
e/(c - 1), so only the sides of the box matter, and u_i - l_i >= 2 allows such a shift. With a side c - 1 nothing is
said: Haar's mask, all ones on c indices, is positive.

Witness: `lowest`, `highest`, the corners.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import Finding

RULE = rules.POSITIVE_MASK


def run(numbers: MultivariateNumbers, _: Facts) -> tuple[Finding, ...]:
    if set(numbers.sums) != {Fraction(1)} or not numbers.is_positive_on_a_box:
        return ()
    lowest, highest = numbers.scheme.bounds()
    size = " by ".join(str(high - low + 1) for low, high in zip(lowest, highest, strict=True))
    statement = f"S converges uniformly: the mask is positive on a full box, {size} coefficients"
    return (RULE.proved(statement, {"lowest": lowest, "highest": highest}),)
