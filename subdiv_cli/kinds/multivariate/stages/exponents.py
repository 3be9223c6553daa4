"""Stages on the Hölder and the Sobolev exponent (SD614, SD615, SD617)."""

from __future__ import annotations

from fractions import Fraction

from flint import arb, ctx

from subdiv_cli.exact.closed import closed_interval, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, rounded_down, rounded_up, valued
from subdiv_cli.jsr.products import radius_bound
from subdiv_cli.kinds.kind import Facts, Part, asking
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.rules import (
    BOX_SPLINE,
    DIFFERENCE_RADIUS,
    HOLDER_LOWER,
    HOLDER_UPPER,
    SOBOLEV,
    STABILITY,
    SUM_RULES,
    TENSOR_PRODUCT,
)
from subdiv_cli.kinds.multivariate.stages import products
from subdiv_cli.kinds.multivariate.stages.wording import (
    ANISOTROPIC,
    growth_proof,
    multivariate_exponent,
    not_spanning,
    spanning,
)
from subdiv_cli.kinds.multivariate.witnesses import (
    MultivariateHolderLowerWitness,
    MultivariateHolderUpperWitness,
    MultivariateSobolevWitness,
)
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth
from subdiv_cli.kinds.scalar.stages.joint_radius import shown
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.model import Finding, Interval, Root, Verdict, logarithm, unpowered
from subdiv_cli.model import findings as questions
from subdiv_cli.model.proofs import root_data

_BELOW, _ABOVE = "how regular are the limit functions at least?", "how regular is φ at most?"


@asking((HOLDER_LOWER, _BELOW), (HOLDER_UPPER, _ABOVE))
def holder(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD614: the Hölder exponent from below. SD615: from above.

    Theorems. For isotropic M, λ = |det M|^(1/s), k the order of the sum rules (Jia 1998; Han 2003): α >= -log_λ ρ_k,
    and for stable φ they are equal. A product of ℓ operators with an eigenvalue of modulus r bounds ρ_k^ℓ >= r. Box
    splines (SD603): α = d - 1 exactly, d >= 2. Hypotheses: M isotropic, checked; stability (SD616) from above.

    Where no bound of ρ_k is known, ρ_k² <= m Λ of the mean squares (SD617): α >= s - dimension/2.

    Tensor products (SD609): the least exponent of a factor, M isotropic or not.

    Witness: `by`, SD603, SD605, SD609 or SD617; of a tensor product `variables` of the factor, and from below
    `between`, a number that its exponent is not above, nor those of factors with other masks below; otherwise `length`
    and `root`, or `length` and `bound`, as SD605 has them; from above `length` and `radius`, a rational lower bound of
    ρ_k^length.
    """
    if numbers.box is not None:
        return _holder_of_box_spline(numbers.box.depth)
    if numbers.parts:
        return (_least_holder(numbers.parts), _least_above(numbers.parts))
    reason = None if numbers.lattice.is_isotropic else ANISOTROPIC
    reason = reason if numbers.order else "no sum rule holds"
    if reason is not None:
        return (HOLDER_LOWER.skipped(_BELOW, reason), HOLDER_UPPER.skipped(_ABOVE, reason))
    if numbers.radius is None:
        none = "no bound of the decay of differences is known"
        return (
            _in_the_mean(numbers) or HOLDER_LOWER.undecided(_BELOW, none),
            HOLDER_UPPER.undecided(_ABOVE, none),
        )
    stably = facts.verdict(STABILITY) is Verdict.PROVED
    return (_below(numbers, stably), _above(numbers, stably))


def _holder_of_box_spline(depth: int) -> tuple[Finding, ...]:
    if depth < 2:
        reason = "φ is a box spline that is not continuous"
        return (HOLDER_LOWER.skipped(_BELOW, reason), HOLDER_UPPER.skipped(_ABOVE, reason))
    alpha = Fraction(depth - 1)
    below, above = spanning(depth - 1), not_spanning(depth)
    return (
        HOLDER_LOWER.proved(
            f"α ≥ {alpha}: {below}", {"by": BOX_SPLINE.code, "value": alpha}, interval(alpha), alpha, why=below
        ),
        HOLDER_UPPER.proved(
            f"α ≤ {alpha}: {above}", {"by": BOX_SPLINE.code, "value": alpha}, interval(alpha), alpha, why=above
        ),
    )


def _least_holder(parts: tuple[Part, ...]) -> Finding:
    least = products.least(parts, questions.HOLDER_LOWER)
    if least is None:
        return HOLDER_LOWER.undecided(_BELOW, products.NOT_LEAST)
    finding, exact = least.part.finding(questions.HOLDER_LOWER), least.is_exact
    value = finding.value or Interval()
    text = _shown(finding) if exact else rounded_down(value.lower or 0.0)
    why = f"the least exponent of a factor: {least.part.name}"
    witness: MultivariateHolderLowerWitness = {"by": TENSOR_PRODUCT.code}
    products.put_least(witness, least)
    return HOLDER_LOWER.proved(
        f"α {'=' if exact else '≥'} {text}, {why}",
        witness,
        value if exact else Interval(lower=value.lower),
        finding.closed,
        why=why,
    )


def _least_above(parts: tuple[Part, ...]) -> Finding:
    part = products.least_upper(parts, questions.HOLDER_UPPER)
    if part is None:
        return HOLDER_UPPER.undecided(_ABOVE, "no bound is known for a factor")
    above = part.finding(questions.HOLDER_UPPER).value
    assert above is not None
    exact = part.finding(questions.HOLDER_LOWER)
    text = _shown(exact) if exact.closed is not None else rounded_up(above.upper or 0.0)
    why = f"an exponent of a factor: {part.name}"
    return HOLDER_UPPER.proved(
        f"α ≤ {text}, {why}",
        {"by": TENSOR_PRODUCT.code, "variables": part.variables},
        Interval(upper=above.upper),
        why=why,
    )


def _shown(finding: Finding) -> str:
    assert finding.closed is not None
    return worded(finding.closed)


def _below(numbers: MultivariateNumbers, stable: bool) -> Finding:
    radius, m, s, k = numbers.radius, numbers.lattice.index, numbers.dimension, numbers.order
    assert radius is not None
    witness: MultivariateHolderLowerWitness = {"by": DIFFERENCE_RADIUS.code, "length": radius.upper[0]}
    if radius.exact is not None and (exact := multivariate_exponent(m, s, *radius.exact)) is not None:
        value = closed_interval(exact)
        witness["root"] = root_data(radius.exact[1])
        why = f"ρ_{k} = {shown(radius)}"
        if stable:
            why = f"φ is stable and {why}"
            return HOLDER_LOWER.proved(f"α = {worded(exact)}, as {why}", witness, value, exact, why=why)
        return HOLDER_LOWER.proved(f"α ≥ {worded(exact)}, as {why}", witness, Interval(lower=value.lower), why=why)
    length, bound = radius.upper
    lower = _exponent(numbers, length, bound)
    why = f"from the bound of ρ_{k}"
    statement = f"α ≥ {rounded_down(lower)}, {why}"
    return HOLDER_LOWER.proved(statement, {**witness, "bound": bound}, Interval(lower=lower), why=why)


def _in_the_mean(numbers: MultivariateNumbers) -> Finding | None:
    """The finding α >= s - dimension/2, for the bound of s that SD617 has; None where it has none."""
    bound = numbers.mean_decay
    if bound is None:
        return None
    lower = _exponent(numbers, 2, bound)
    witness: MultivariateHolderLowerWitness = {"by": SOBOLEV.code, "length": 2, "bound": bound}
    why = f"from the mean squares of differences of order {numbers.order}"
    statement = f"α ≥ {rounded_down(lower)}, {why}"
    return HOLDER_LOWER.proved(statement, witness, Interval(lower=lower), proof=growth_proof(numbers), why=why)


def _exponent(numbers: MultivariateNumbers, length: int, bound: Fraction) -> float:
    """The exponent -log_λ(bound)/length, rounded down."""
    with ctx.workprec(128):
        lower = interval(-ball(bound).log() * numbers.dimension / ball(numbers.lattice.index).log() / length).lower
    assert lower is not None
    return lower


def _above(numbers: MultivariateNumbers, stable: bool) -> Finding:
    product, m, s, k = numbers.product, numbers.lattice.index, numbers.dimension, numbers.order
    if not stable:
        return HOLDER_UPPER.undecided(_ABOVE, "it is not proved that φ is stable")
    if product is None:
        return HOLDER_UPPER.undecided(_ABOVE, "no product is known that bounds ρ_k from below")
    bound, length = radius_bound(product), len(product.word)
    base, divisor = unpowered(m, length)
    upper = closed_interval(logarithm(base, (1 / bound) ** s, divisor)).upper
    witness: MultivariateHolderUpperWitness = {
        "by": DIFFERENCE_RADIUS.code,
        "word": product.word,
        "length": length,
        "radius": bound,
    }
    exact = numbers.radius.exact if numbers.radius is not None else None
    closed = multivariate_exponent(m, s, *exact) if exact is not None else None
    text = rounded_up(upper or 0.0) if closed is None else worded(closed)
    why = f"φ is stable, and {product_name(product.word)} bounds ρ_{k} from below"
    return HOLDER_UPPER.proved(f"α ≤ {text}: {why}", witness, Interval(upper=upper), why=why)


_SOBOLEV_QUESTION = "how regular is φ in L2?"


@asking((SOBOLEV, _SOBOLEV_QUESTION))
def sobolev(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD617: the Sobolev exponent of φ, s = sup {t : φ ∈ H^t}.

    Theorems. For isotropic M, λ = |det M|^(1/dimension), k >= 1 the order of the sum rules, and Λ the growth of the
    mean squares of the differences of order k (numbers/mean_squares.py): s >= -log_λ(Λ)/2, and for stable φ they are
    equal (Jia 1999; Han 2003). A smaller order than that of the sum rules would give too little where Λ = λ^-2k. Box
    splines (SD603): s = d - 1/2 exactly, whatever their stability. Tensor products (SD609): the least one of a factor.
    Always s - dimension/2 <= α <= s, α the Hölder exponent. Hypotheses: M isotropic, the order, that the mask is no box
    spline: checked; stability (SD616), for equality.

    Witness: `by`, SD603 and `value`; or SD609, as SD614 has it; or SD602, the order of the differences, with
    `polynomial`, that of Λ, integers, lowest power first; `low` and `high`, which enclose Λ and no other zero of it;
    `holds`, whether s is equal to the bound. `proof`: these, and the `cofactor` that makes the polynomial annihilate
    the sequences.
    """
    if numbers.box is not None:
        return (_sobolev_of_box_spline(numbers.box.depth),)
    if numbers.parts:
        return (_least_sobolev(numbers.parts),)
    reason = None if numbers.lattice.is_isotropic else ANISOTROPIC
    reason = reason if numbers.order else "no sum rule holds"
    if reason is not None:
        return (SOBOLEV.skipped(_SOBOLEV_QUESTION, reason),)
    means = numbers.mean_squares
    if means is None:
        return (SOBOLEV.undecided(_SOBOLEV_QUESTION, "the operator on correlations is too large for this effort"),)
    if means.growth is None:
        return (
            SOBOLEV.undecided(_SOBOLEV_QUESTION, "the growth of the mean squares is a multiple zero of its polynomial"),
        )
    return (_of_mean_squares(numbers, means.growth, facts.verdict(STABILITY) is Verdict.PROVED),)


def _sobolev_of_box_spline(depth: int) -> Finding:
    s = depth - Fraction(1, 2)
    why = f"{depth} directions must go until the others do not span"
    return SOBOLEV.proved(f"s = {s}: {why}", {"by": BOX_SPLINE.code, "value": s}, interval(s), s, why=why)


def _least_sobolev(parts: tuple[Part, ...]) -> Finding:
    least = products.least(parts, questions.SOBOLEV)
    if least is None:
        return SOBOLEV.undecided(_SOBOLEV_QUESTION, products.NOT_LEAST)
    finding = least.part.finding(questions.SOBOLEV)
    value, why = finding.value or Interval(), f"the least exponent of a factor: {least.part.name}"
    witness: MultivariateSobolevWitness = {"by": TENSOR_PRODUCT.code}
    products.put_least(witness, least)
    if not least.is_exact:
        statement = f"s ≥ {rounded_down(value.lower or 0.0)}, {why}"
        return SOBOLEV.proved(statement, witness, Interval(lower=value.lower), why=why)
    return SOBOLEV.proved(f"s = {_shown(finding)}, {why}", witness, value, finding.closed, why=why)


def _of_mean_squares(numbers: MultivariateNumbers, growth: Growth, stable: bool) -> Finding:
    m, dimension, k = numbers.lattice.index, numbers.dimension, numbers.order
    root = Root(tuple(int(c) for c in growth.radius.minimal_polynomial), growth.low, growth.high)
    witness: MultivariateSobolevWitness = {
        "by": SUM_RULES.code,
        "polynomial": root.coefficients,
        "low": growth.low,
        "high": growth.high,
        "holds": stable,
    }

    def exponent() -> arb:
        return -growth.ball().log() * dimension / ball(m).log() / 2

    closed = multivariate_exponent(m, dimension, 2, root)
    rational = growth.radius.rational
    shown = certain(exponent) if closed is None or rational is None else worded(closed)
    size = certain(growth.ball) if rational is None else valued(rational)
    if closed is not None:
        value = closed_interval(closed)
    else:
        with ctx.workprec(128):
            value = interval(exponent())
    why = f"the mean squares of differences of order {k} grow like Λ^L, Λ = {size}"
    if stable:
        why = f"φ is stable, and {why}"
        return SOBOLEV.proved(f"s = {shown}: {why}", witness, value, closed, growth_proof(numbers), why=why)
    below = Interval(lower=value.lower)
    return SOBOLEV.proved(f"s ≥ {shown}: {why}", witness, below, proof=growth_proof(numbers), why=why)
