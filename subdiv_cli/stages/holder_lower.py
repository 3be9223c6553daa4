"""SD311: the Hölder exponent from below.

Theorem (Dyn 1992, section 3; Rioul 1992): with D = S_(Δ^k), k the sum-rule order, α = -log_p JSR(D) is at least
-(1/L) log_p ‖D^L‖∞ for every L. If α > 0 all limit functions are in C^(α-ε) for every ε > 0; if α <= 0 it is the
exponent of a distribution. Hypothesis k >= 1: checked. No stability is needed from below; an unstable mask is reduced
first (SD403), which can only raise the bound.

Where a product of ℓ matrices of D has an eigenvalue with |λ|^(1/ℓ) = ‖D^L‖∞^(1/L), compared exactly, the joint spectral
radius is that number and α is known in closed form.

Witness: `difference_order`, k of the (reduced) mask; `level`; `norm`, ‖D^L‖∞ there; where α is
exact the closing product (see obstacles.py).
"""

from __future__ import annotations

from flint import ctx

from subdiv_cli.exact.enclosures import ball, closed_interval, interval
from subdiv_cli.exact.text import is_short, number, rounded_down
from subdiv_cli.model import Data, Finding, Interval, logarithm
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.obstacles import product_text, product_witness
from subdiv_cli.stages.stage import NOT_NORMALISED, Facts, Rule, last_difference, power

RULE = Rule("SD311", "holder-lower", "Dyn 1992, section 3; Rioul 1992")

_QUESTION = "how regular are the limit functions at least?"


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    numbers = numbers.reduced
    k, p = numbers.order, numbers.p
    if k == 0:
        return (RULE.skipped(_QUESTION, "no sum rule holds" if numbers.is_normalised else NOT_NORMALISED),)
    scaled_norms = numbers.norms(k)
    if not scaled_norms:
        return (
            RULE.undecided(
                _QUESTION, f"the {'time budget' if numbers.effort.struck else 'effort'} ended before the first norm"
            ),
        )
    norms = [norm / p ** ((k - 1) * level) for level, norm in enumerate(scaled_norms, 1)]
    with ctx.workprec(128):
        values = [interval(-ball(norm).log() / ball(p).log() / level) for level, norm in enumerate(norms, 1)]
    best = max(range(len(norms)), key=lambda i: (_lower(values[i]), -i))
    level, norm, product = best + 1, norms[best], numbers.best_product
    proof = f"{power(last_difference(numbers), level)} = {number(norm)}"
    witness: dict[str, Data] = {"difference_order": k, "level": level, "norm": norm}
    if product is not None and numbers.closes(k, level, scaled_norms[best]):
        exact = logarithm(p, 1 / norm, level)
        shown = str(exact) if is_short(norm) else rounded_down(_lower(values[best])) + "…"
        statement = f"α = {shown}: {proof}, and {product_text(product)} attains it"
        return (RULE.proved(statement, {**witness, **product_witness(product)}, closed_interval(exact)),)
    statement = f"α ≥ {rounded_down(_lower(values[best]))}: {proof}"
    return (RULE.proved(statement, witness, Interval(lower=values[best].lower)),)


def _lower(value: Interval) -> float:
    if value.lower is None:
        raise ArithmeticError("a logarithm beyond the doubles")
    return value.lower
