"""SD312: the Hölder exponent from above.

Theorem (Cavaretta, Dahmen & Micchelli 1991; Rioul 1992): for stable φ the exponent α = -log_p JSR(D), D = S_(Δ^k), is
the best one. For any product of ℓ transition matrices of D with an eigenvalue λ, α <= -(1/ℓ) log_p |λ|; and α <= k
always. Hypotheses: k >= 1, checked; stability: an unstable mask is reduced to a stable one first, whose exponent is
that of φ (SD403).

Witness: `difference_order`, k of the (reduced) mask, the product (see obstacles.py) and `radius`, a rational lower
bound of |λ| from which the bound is computed (|λ| itself where it is rational or where SD311 proves that α is the
number of this product); k alone where it is the better bound.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.closed import exponent, readable
from subdiv_cli.exact.enclosures import interval
from subdiv_cli.exact.text import modulus, rounded_up
from subdiv_cli.jsr.products import radius_bound
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.estimate import estimated_exponent
from subdiv_cli.kinds.scalar.numbers.exponents import exponent_bound
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.obstacles import product_text, product_witness
from subdiv_cli.kinds.scalar.stages.stage import NOT_NORMALISED, last_difference
from subdiv_cli.model import Data, Exponent, Finding, Interval
from subdiv_cli.model import findings as questions

RULE = rules.HOLDER_UPPER

_QUESTION = "how regular is φ at most?"


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    numbers = numbers.reduced
    k, product = numbers.order, numbers.product
    if k == 0:
        return (RULE.skipped(_QUESTION, "no sum rule holds" if numbers.is_normalised else NOT_NORMALISED),)
    witness: dict[str, Data] = {"difference_order": k}
    bound = None if product is None else exponent_bound(product, numbers.p)
    if product is None or bound is None or bound.upper is None or bound.upper > k:
        statement = f"α ≤ {k}, the sum-rule order"
        return (_proved(numbers, facts, statement, witness, interval(Fraction(k)).upper),)
    shown = bound.exact or _exact(numbers) or rounded_up(bound.upper)
    size = modulus(product.eigenvalue)
    statement = (
        f"α ≤ {shown}: {product_text(product)} of {last_difference(numbers)} has an eigenvalue of modulus {size}"
    )
    witness |= {**product_witness(product), "radius": radius_bound(product)}
    return (_proved(numbers, facts, statement, witness, bound.upper),)


def _proved(
    numbers: ScalarNumbers, facts: Facts, statement: str, witness: dict[str, Data], upper: float | None
) -> Finding:
    """With an estimate beside it, where the exponent is only enclosed."""
    below = facts[rules.HOLDER_LOWER]
    lower = below.value.lower if below.value is not None and below.closed is None else None
    estimate = estimated_exponent(numbers, lower, upper)
    answer = Exponent(upper=upper, estimate=estimate)
    return RULE.proved(statement, witness, Interval(upper=upper), answers={questions.HOLDER_UPPER: answer})


def _exact(numbers: ScalarNumbers) -> str | None:
    """The bound in closed form, where the product attains a radius that is known exactly and the text is not long."""
    radius = numbers.radius
    return None if radius is None or radius.exact is None else readable(exponent(numbers.p, *radius.exact))
