"""SD311: the Hölder exponent from below.

Theorem (Dyn 1992, section 3; Rioul 1992): with D = S_(Δ^k), k the sum-rule order, and ρ its joint spectral radius, α
= -log_p ρ. If α > 0 all limit functions are in C^(α-ε) for every ε > 0; if α <= 0 it is the exponent of a
distribution. Hypothesis k >= 1: checked. No stability is needed from below; an unstable mask is reduced first
(SD403), which can only raise the bound. What is known of ρ is what SD310 proves: ρ^n = Λ, so that α = -log_p(Λ)/n, or
ρ^n <= x, so that α >= -log_p(x)/n.

Witness: `difference_order`, k of the (reduced) mask; `radius_of`, S or S0; `length`, n; `bound`, x, or `root`, Λ
(polynomial, the lowest power first, low, high).
"""

from __future__ import annotations

from flint import ctx

from subdiv_cli.exact.closed import closed_interval, exponent, readable
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import rounded_down
from subdiv_cli.jsr.result import root_data
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.joint_radius import shown
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED, last_difference
from subdiv_cli.model import Data, Finding, Interval

RULE = rules.HOLDER_LOWER

_QUESTION = "how regular are the limit functions at least?"


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    numbers = numbers.reduced
    k, p, radius = numbers.order, numbers.p, numbers.radius
    if k == 0:
        return (RULE.skipped(_QUESTION, "no sum rule holds" if numbers.is_normalised else NOT_NORMALISED),)
    if radius is None:
        ended = "time budget" if numbers.effort.struck else "effort"
        return (RULE.undecided(_QUESTION, f"the {ended} ended before a bound of the joint spectral radius"),)
    witness: dict[str, Data] = {"difference_order": k, "radius_of": numbers.name, "length": radius.upper[0]}
    name = f"ρ({last_difference(numbers)})"
    if radius.exact is not None:
        exact = exponent(p, *radius.exact)
        value = closed_interval(exact)
        text = readable(exact) or f"{rounded_down(value.lower or 0.0)}…"
        statement = f"α = {text}, as {name} = {shown(radius)}"
        return (RULE.proved(statement, {**witness, "root": root_data(radius.exact[1])}, value, exact),)
    length, bound = radius.upper
    with ctx.workprec(128):
        lower = interval(-ball(bound).log() / ball(p).log() / length).lower
    if lower is None:
        raise ArithmeticError("a logarithm beyond the doubles")
    statement = f"α ≥ {rounded_down(lower)}, from the bound of {name}"
    return (RULE.proved(statement, {**witness, "bound": bound}, Interval(lower=lower)),)
