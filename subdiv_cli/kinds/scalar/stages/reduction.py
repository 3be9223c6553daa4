"""SD403: an unstable mask reduced to a stable one.

Theorem: let g be the gcd of the polyphase components, or g = Φ_n for a cycle of n-th roots of unity (SD402). Then
a0(z) = a(z) g(z)/g(z^p) is a mask with φ = Σ_j g_j φ0(·-j)/g(1): the right side solves the refinement equation of a,
and g(1) ≠ 0 because a(1) = p. As 1/g is a power series, φ0 is a locally finite combination of translates of φ, so both
are equally smooth. Each step lowers the degree by (p-1) deg g; the last φ0 is stable by SD402's test. Hypothesis
a(1) = p: checked.

Smoothness, exponents and their refutations are then decided on the reduced mask; convergence is judged on S itself.

Witness: `factors`, the g of each step; `cycles`, the n of each step or None; `starts` and `masks`, the mask after each
step; of the last one `order`, `cofactor_start` and `cofactor` as in SD102, and `stable`, what proves it stable, as
in SD402.
"""

from __future__ import annotations

from itertools import groupby

from subdiv_cli.exact.text import laurent
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.reduction import Step
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.stability import stability_witness
from subdiv_cli.model import Data, Finding

RULE = rules.REDUCTION


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    steps = numbers.reduction
    if not steps:
        return ()
    reduced = steps[-1].symbol
    runs = [(text, len(list(run))) for text, run in groupby(_text(step, numbers.p) for step in steps)]
    how = ", then ".join(text + (f", {count} times" if count > 1 else "") for text, count in runs)
    statement = (
        f"φ is as smooth as the stable φ0 of the reduced scheme S0 with symbol a0(z) = {laurent(reduced)}, {how}"
    )
    order, cofactor = numbers.reduced.sum_rules[:2]
    witness: dict[str, Data] = {
        "factors": tuple(step.factor.coefficients() for step in steps),
        "cycles": tuple(step.cycle for step in steps),
        "starts": tuple(step.symbol.low for step in steps),
        "masks": tuple(step.symbol.coefficients() for step in steps),
        "order": order,
        "cofactor_start": cofactor.low,
        "cofactor": cofactor.coefficients(),
        "stable": dict(stability_witness(numbers.reduced)),
    }
    return (RULE.proved(statement, witness),)


def _text(step: Step, p: int) -> str:
    if step.cycle is not None:
        return f"by g = Φ_{step.cycle} in a(z) g(z)/g(z^{p})"
    return f"by g = {laurent(step.factor)} in a(z) g(z)/g(z^{p})"
