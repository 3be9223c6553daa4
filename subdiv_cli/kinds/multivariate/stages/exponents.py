"""Stages on the Hölder and the Sobolev exponent (SD614, SD615, SD617)."""

from __future__ import annotations

from fractions import Fraction

from flint import arb, ctx

from subdiv_cli.exact.closed import closed_ball, closed_interval, readable
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, number, rounded_down, rounded_up
from subdiv_cli.jsr.products import radius_bound
from subdiv_cli.jsr.result import root_data
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
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth
from subdiv_cli.kinds.scalar.stages.joint_radius import shown
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.model import Data, Finding, Interval, Root, Verdict, logarithm, unpowered
from subdiv_cli.model import findings as questions

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
    witness: dict[str, Data] = {"by": BOX_SPLINE.code, "value": alpha}
    below, above = f"α ≥ {alpha}: {spanning(depth - 1)}", f"α ≤ {alpha}: {not_spanning(depth)}"
    return (
        HOLDER_LOWER.proved(below, witness, interval(alpha), alpha),
        HOLDER_UPPER.proved(above, witness, interval(alpha), alpha),
    )


def _least_holder(parts: tuple[Part, ...]) -> Finding:
    found = products.least(parts, questions.HOLDER_LOWER)
    if found is None:
        return HOLDER_LOWER.undecided(_BELOW, products.NOT_LEAST)
    part, exact = found.part.finding(questions.HOLDER_LOWER), found.is_exact
    value = part.value or Interval()
    text = _shown(part) if exact else rounded_down(value.lower or 0.0)
    statement = f"α {'=' if exact else '≥'} {text}, the least exponent of a factor: {found.part.name}"
    return HOLDER_LOWER.proved(
        statement, products.least_witness(found), value if exact else Interval(lower=value.lower), part.closed
    )


def _least_above(parts: tuple[Part, ...]) -> Finding:
    part = products.least_upper(parts, questions.HOLDER_UPPER)
    if part is None:
        return HOLDER_UPPER.undecided(_ABOVE, "no bound is known for a factor")
    found = part.finding(questions.HOLDER_UPPER)
    assert found.value is not None
    exact = part.finding(questions.HOLDER_LOWER)
    text = _shown(exact) if exact.closed is not None else rounded_up(found.value.upper or 0.0)
    witness: dict[str, Data] = {"by": TENSOR_PRODUCT.code, "variables": part.variables}
    return HOLDER_UPPER.proved(
        f"α ≤ {text}, an exponent of a factor: {part.name}", witness, Interval(upper=found.value.upper)
    )


def _shown(found: Finding) -> str:
    assert found.closed is not None
    return readable(found.closed) or f"{rounded_down((found.value or Interval()).lower or 0.0)}…"


def _below(numbers: MultivariateNumbers, stable: bool) -> Finding:
    radius, m, s, k = numbers.radius, numbers.lattice.index, numbers.dimension, numbers.order
    assert radius is not None
    witness: dict[str, Data] = {"by": DIFFERENCE_RADIUS.code, "length": radius.upper[0]}
    if radius.exact is not None and (exact := multivariate_exponent(m, s, *radius.exact)) is not None:
        value = closed_interval(exact)
        text = readable(exact) or f"{rounded_down(value.lower or 0.0)}…"
        witness["root"] = root_data(radius.exact[1])
        if stable:
            return HOLDER_LOWER.proved(f"α = {text}, as φ is stable and ρ_{k} = {shown(radius)}", witness, value, exact)
        return HOLDER_LOWER.proved(f"α ≥ {text}, as ρ_{k} = {shown(radius)}", witness, Interval(lower=value.lower))
    length, bound = radius.upper
    lower = _exponent(numbers, length, bound)
    statement = f"α ≥ {rounded_down(lower)}, from the bound of ρ_{k}"
    return HOLDER_LOWER.proved(statement, {**witness, "bound": bound}, Interval(lower=lower))


def _in_the_mean(numbers: MultivariateNumbers) -> Finding | None:
    """The finding α >= s - dimension/2, for the bound of s that SD617 has; None where it has none."""
    bound = numbers.mean_decay
    if bound is None:
        return None
    lower = _exponent(numbers, 2, bound)
    witness: dict[str, Data] = {"by": SOBOLEV.code, "length": 2, "bound": bound}
    statement = f"α ≥ {rounded_down(lower)}, from the mean squares of differences of order {numbers.order}"
    return HOLDER_LOWER.proved(statement, witness, Interval(lower=lower), proof=growth_proof(numbers))


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
    witness: dict[str, Data] = {
        "by": DIFFERENCE_RADIUS.code,
        "word": product.word,
        "length": length,
        "radius": bound,
    }
    exact = numbers.radius.exact if numbers.radius is not None else None
    closed = multivariate_exponent(m, s, *exact) if exact is not None else None
    text = (readable(closed) if closed is not None else None) or rounded_up(upper or 0.0)
    statement = f"α ≤ {text}: φ is stable, and {product_name(product.word)} bounds ρ_{k} from below"
    return HOLDER_UPPER.proved(statement, witness, Interval(upper=upper))


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
    found = numbers.mean_squares
    if found is None:
        return (SOBOLEV.undecided(_SOBOLEV_QUESTION, "the operator on correlations is too large for this effort"),)
    if found.growth is None:
        return (
            SOBOLEV.undecided(_SOBOLEV_QUESTION, "the growth of the mean squares is a multiple zero of its polynomial"),
        )
    return (_found(numbers, found.growth, facts.verdict(STABILITY) is Verdict.PROVED),)


def _sobolev_of_box_spline(depth: int) -> Finding:
    s = depth - Fraction(1, 2)
    statement = f"s = {s}: {depth} directions must go until the others do not span"
    return SOBOLEV.proved(statement, {"by": BOX_SPLINE.code, "value": s}, interval(s), s)


def _least_sobolev(parts: tuple[Part, ...]) -> Finding:
    found = products.least(parts, questions.SOBOLEV)
    if found is None:
        return SOBOLEV.undecided(_SOBOLEV_QUESTION, products.NOT_LEAST)
    part, witness = found.part.finding(questions.SOBOLEV), products.least_witness(found)
    value = part.value or Interval()
    if not found.is_exact:
        statement = f"s ≥ {rounded_down(value.lower or 0.0)}, the least exponent of a factor: {found.part.name}"
        return SOBOLEV.proved(statement, witness, Interval(lower=value.lower))
    closed = part.closed
    assert closed is not None
    text = readable(closed) or certain(lambda: closed_ball(closed))
    return SOBOLEV.proved(f"s = {text}, the least exponent of a factor: {found.part.name}", witness, value, part.closed)


def _found(numbers: MultivariateNumbers, growth: Growth, stable: bool) -> Finding:
    m, dimension, k = numbers.lattice.index, numbers.dimension, numbers.order
    root = Root(tuple(int(c) for c in growth.radius.minimal_polynomial), growth.low, growth.high)
    witness: dict[str, Data] = {
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
    shown = (readable(closed) if closed is not None and rational is not None else None) or certain(exponent)
    size = certain(growth.ball) if rational is None else number(rational)
    if closed is not None:
        value = closed_interval(closed)
    else:
        with ctx.workprec(128):
            value = interval(exponent())
    why = f"the mean squares of differences of order {k} grow like Λ^L, Λ = {size}"
    if stable:
        return SOBOLEV.proved(f"s = {shown}: φ is stable, and {why}", witness, value, closed, growth_proof(numbers))
    return SOBOLEV.proved(f"s ≥ {shown}: {why}", witness, Interval(lower=value.lower), proof=growth_proof(numbers))
