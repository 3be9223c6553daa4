"""SD505: how smooth the limits of an interpolatory scheme can be at most.

Theorem (Dyn 1992, Theorem 5.1, for any arity p): an interpolatory scheme, a_(pα) = δ_(α,0), has C^ν limits only if it
reproduces π_ν. With the sum rules of order k and no higher it reproduces π_(k-1) and no more: a polynomial sequence
that S maps to one interpolates its limit. So no C^k. Hypothesis, the scheme is interpolatory: checked; other schemes
have no such finding. As the translates of φ are independent, φ(α) = δ_(α,0), this is what SD303 says with the sum rules
alone.

Witness: `order`, k.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.facts import interpolation_shift
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Finding

RULE = rules.INTERPOLATORY_ORDER


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    k = numbers.order
    if interpolation_shift(numbers.scheme) != 0 or not numbers.is_normalised or numbers.reduced is not numbers or not k:
        return ()
    statement = f"S is interpolatory and reproduces polynomials of degree {k - 1} only, so φ is not C^{k}"
    return (RULE.proved(statement, {"order": k}),)
