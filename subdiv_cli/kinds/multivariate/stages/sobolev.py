"""SD617: the Sobolev exponent of φ, s = sup {t : φ ∈ H^t}.

Theorems. For isotropic M, λ = |det M|^(1/dimension), k >= 1 the order of the sum rules, and Λ the growth of the mean
squares of the differences of order k (numbers/mean_squares.py): s >= -log_λ(Λ)/2, and for stable φ they are equal
(Jia 1999; Han 2003). A smaller order than that of the sum rules would give too little where Λ = λ^-2k. Box splines
(SD603): s = d - 1/2 exactly, whatever their stability. Tensor products (SD609): the least one of a factor. Always s -
dimension/2 <= α <= s, α the Hölder exponent. Hypotheses: M isotropic, the order, that the mask is no box spline:
checked; stability (SD616), for equality.

Witness: `by`, SD603 and `value`; or SD609, as SD614 has it; or SD602, the order of the differences, with `polynomial`,
that of Λ, integers, lowest power first; `low` and `high`, which enclose Λ and no other zero of it; `holds`, whether s
is equal to the bound. `proof`: these, and the `cofactor` that makes the polynomial annihilate the sequences.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb, ctx

from subdiv_cli.exact.closed import closed_ball, closed_interval, readable
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, number, rounded_down
from subdiv_cli.kinds.kind import Facts, Part
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.stages import tensor_products
from subdiv_cli.kinds.multivariate.stages.rule import ANISOTROPIC, growth_proof, surface_exponent
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth
from subdiv_cli.model import Data, Finding, Interval, Root, Verdict
from subdiv_cli.model import findings as questions

RULE = rules.SOBOLEV

_QUESTION = "how regular is φ in L2?"


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if numbers.box is not None:
        return (_of_box_spline(numbers.box.depth),)
    if numbers.parts:
        return (_least_of(numbers.parts),)
    reason = None if numbers.lattice.is_isotropic else ANISOTROPIC
    reason = reason if numbers.order else "no sum rule holds"
    if reason is not None:
        return (RULE.skipped(_QUESTION, reason),)
    found = numbers.mean_squares
    if found is None:
        return (RULE.undecided(_QUESTION, "the operator on correlations is too large for this effort"),)
    if found.growth is None:
        return (RULE.undecided(_QUESTION, "the growth of the mean squares is a multiple zero of its polynomial"),)
    return (_found(numbers, found.growth, facts.verdict(rules.STABILITY) is Verdict.PROVED),)


def _of_box_spline(depth: int) -> Finding:
    s = depth - Fraction(1, 2)
    statement = f"s = {s}: {depth} directions must go until the others do not span"
    return RULE.proved(statement, {"by": rules.BOX_SPLINE.code, "value": s}, interval(s), s)


def _least_of(parts: tuple[Part, ...]) -> Finding:
    found = tensor_products.least(parts, questions.SOBOLEV)
    if found is None:
        return RULE.undecided(_QUESTION, "the exponents of the factors are not seen to be positive, or not compared")
    part, witness = found.part.finding(questions.SOBOLEV), tensor_products.least_witness(found)
    value = part.value or Interval()
    if not found.is_exact:
        statement = f"s ≥ {rounded_down(value.lower or 0.0)}, the least exponent of a factor: {found.part.name}"
        return RULE.proved(statement, witness, Interval(lower=value.lower))
    closed = part.closed
    assert closed is not None
    text = readable(closed) or certain(lambda: closed_ball(closed))
    return RULE.proved(f"s = {text}, the least exponent of a factor: {found.part.name}", witness, value, part.closed)


def _found(numbers: MultivariateNumbers, growth: Growth, stable: bool) -> Finding:
    m, dimension, k = numbers.lattice.index, numbers.dimension, numbers.order
    root = Root(tuple(int(c) for c in growth.radius.minimal_polynomial), growth.low, growth.high)
    witness: dict[str, Data] = {
        "by": rules.SUM_RULES.code,
        "polynomial": root.coefficients,
        "low": growth.low,
        "high": growth.high,
        "holds": stable,
    }

    def exponent() -> arb:
        return -growth.ball().log() * dimension / ball(m).log() / 2

    closed = surface_exponent(m, dimension, 2, root)
    rational = growth.radius.rational
    shown = (readable(closed) if closed is not None and rational is not None else None) or certain(exponent)
    size = certain(growth.ball) if rational is None else number(rational)
    if closed is not None:
        value = closed_interval(closed)
    else:
        with ctx.workprec(128):
            value = interval(exponent())
    why = f"the mean squares of differences of order {k} grow like Λ^L, Λ = {size}"
    if stable:
        return RULE.proved(f"s = {shown}: φ is stable, and {why}", witness, value, closed, growth_proof(numbers))
    return RULE.proved(f"s ≥ {shown}: {why}", witness, Interval(lower=value.lower), proof=growth_proof(numbers))
