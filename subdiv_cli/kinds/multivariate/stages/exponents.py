"""Stages on the Hölder and the Sobolev exponent (SD614, SD615, SD617)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import inf

from flint import arb, ctx

from subdiv_cli.exact.closed import closed_interval, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, rounded_down, rounded_up, valued
from subdiv_cli.jsr.products import radius_bound
from subdiv_cli.kinds.kind import Facts, Part, asking
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.rules import (
    BOX_SPLINE,
    CONVERGENCE,
    DIFFERENCE_RADIUS,
    DIRECTIONAL_NORMS,
    DIRECTIONAL_SMOOTHNESS,
    HOLDER_LOWER,
    HOLDER_UPPER,
    MATRIX_NORMS,
    SOBOLEV,
    STABILITY,
    SUM_RULES,
    TENSOR_PRODUCT,
)
from subdiv_cli.kinds.multivariate.stages import products, stencils
from subdiv_cli.kinds.multivariate.stages.wording import (
    ANISOTROPIC,
    exponent_above,
    growth_proof,
    largest_norm,
    multivariate_exponent,
    not_spanning,
    spanning,
)
from subdiv_cli.kinds.multivariate.witnesses import (
    MultivariateHolderLowerWitness,
    MultivariateHolderUpperWitness,
    MultivariateSobolevWitness,
)
from subdiv_cli.kinds.radius import shown
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.model import Finding, Interval, Root, Verdict, exact_root
from subdiv_cli.model import findings as questions
from subdiv_cli.model.findings import best_of
from subdiv_cli.model.proofs import root_data, upper_bound

_BELOW, _ABOVE = "how regular are the limit functions at least?", "how regular is φ at most?"


@asking((HOLDER_LOWER, _BELOW), (HOLDER_UPPER, _ABOVE))
def holder(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD614: the Hölder exponent from below. SD615: from above. Each is the best bound of all that are proved.

    Theorems. For isotropic M, λ = |det M|^(1/s), k the order of the sum rules (Jia 1998; Han 2003): α >= -log_λ ρ_k,
    and for stable φ they are equal. A product of ℓ operators with an eigenvalue of modulus r bounds ρ_k^ℓ >= r. Box
    splines (SD603): α = d - 1 exactly. Hypotheses: M isotropic, checked; stability (SD616) from above.

    Further bounds from below: ρ_k <= ρ_j for j <= k, and ρ_j is bounded by a matrix scheme of differences (SD606); ρ_1
    by directional norms (SD604) and ρ_2 by those of pairs (SD607); ρ_k² <= m Λ by the mean squares (SD617): α >= s -
    dimension/2; and α >= 0 where S converges (SD611). From above, for stable φ: α <= k; ρ_k² >= Λ, so α is at most the
    Sobolev exponent.

    Without stability, where S converges: α = -log_λ ρ_k(w) as soon as this is below k, by SD621.

    Tensor products (SD609): the least exponent of a factor, M isotropic or not.

    Witness: `by`, the code of the finding that gives it (SD602 for k); of a tensor product `variables` of the factor,
    and from below `between`, a number that its exponent is not above, nor those of factors with other masks below;
    otherwise `length` and `root`, or `length` and `bound`, as SD605 has them; from above `length` and `radius`, a lower
    bound of ρ_k^length, with the `word` of a product.
    """
    if numbers.box is not None:
        return _holder_of_box_spline(numbers.box.depth)
    if numbers.parts:
        return (_least_holder(numbers.parts), _least_above(numbers.parts))
    reason = None if numbers.lattice.is_isotropic else ANISOTROPIC
    reason = reason if numbers.order else "no sum rule holds"
    if reason is not None:
        return (HOLDER_LOWER.skipped(_BELOW, reason), HOLDER_UPPER.skipped(_ABOVE, reason))
    stably = facts.verdict(STABILITY) is Verdict.PROVED
    below = [*_exactly(numbers, stably), *_bounds_below(numbers, facts)]
    if by_stencil := [*stencils.holder_below(numbers, facts)]:
        below = sorted([*by_stencil, *below], key=lambda each: (each.closed is None, -_lower_of(each)))
    above = [*_bounds_above(numbers)] if stably else []
    above = sorted([*stencils.holder_above(numbers, facts, below[0] if below else None), *above], key=_upper_of)
    none, unstable = "no bound of the decay of differences is known", "it is not proved that φ is stable"
    return (
        best_of(below) if below else HOLDER_LOWER.undecided(_BELOW, none),
        best_of(above) if above else HOLDER_UPPER.undecided(_ABOVE, unstable if numbers.radius else none),
    )


def _lower_of(finding: Finding) -> float:
    return -inf if finding.value is None or finding.value.lower is None else finding.value.lower


def _upper_of(finding: Finding) -> float:
    return inf if finding.value is None or finding.value.upper is None else finding.value.upper


def _holder_of_box_spline(depth: int) -> tuple[Finding, ...]:
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


def _exactly(numbers: MultivariateNumbers, stable: bool) -> Iterator[Finding]:
    """The finding by ρ_k itself, where that is known and has an exponent in closed form."""
    radius, m, s, k = numbers.radius, numbers.lattice.index, numbers.dimension, numbers.order
    if radius is None or radius.exact is None or (exact := multivariate_exponent(m, s, *radius.exact)) is None:
        return
    witness: MultivariateHolderLowerWitness = {
        "by": DIFFERENCE_RADIUS.code,
        "length": radius.upper[0],
        "root": root_data(radius.exact[1]),
    }
    value, why = closed_interval(exact), f"ρ_{k} = {shown(radius)}"
    if stable:
        why = f"φ is stable and {why}"
        yield HOLDER_LOWER.proved(f"α = {worded(exact)}, as {why}", witness, value, exact, why=why)
    else:
        yield HOLDER_LOWER.proved(f"α ≥ {worded(exact)}, as {why}", witness, Interval(lower=value.lower), why=why)


def _bounds_below(numbers: MultivariateNumbers, facts: Facts) -> list[Finding]:
    """The findings by all bounds that are known, the best one first."""
    bounds = [
        (_exponent(numbers, length, bound), by, length, bound, why)
        for by, length, bound, why in _decays(numbers, facts)
    ]
    return [
        HOLDER_LOWER.proved(
            f"α ≥ {rounded_down(lower)}, {why}",
            {"by": by, "length": length, "bound": bound},
            Interval(lower=lower),
            proof=growth_proof(numbers) if by == SOBOLEV.code else None,
            why=why,
        )
        for lower, by, length, bound, why in sorted(bounds, key=lambda each: -each[0])
    ]


def _decays(numbers: MultivariateNumbers, facts: Facts) -> Iterator[tuple[str, int, Fraction, str]]:
    """The bounds ρ_k^length <= x with the code of the finding that has them, and its cause in words."""
    k, radius, mean = numbers.order, numbers.radius, numbers.mean_decay
    if radius is not None:
        length, bound = radius.upper if radius.exact is None else (radius.exact[0], radius.exact[1].high)
        yield DIFFERENCE_RADIUS.code, length, bound, f"from the bound of ρ_{k}"
    for finding in facts.all(MATRIX_NORMS):
        norms = MATRIX_NORMS.witness_of(finding)
        yield MATRIX_NORMS.code, norms["level"], norms["norm"], "from a matrix scheme of differences"
    if mean is not None:
        yield SOBOLEV.code, 2, mean, f"from the mean squares of differences of order {k}"
    c, cause = exact_root(numbers.lattice.index, numbers.dimension) or 1, "from the norms of quotients by factors in"
    for finding in facts.all(DIRECTIONAL_NORMS):
        norm = largest_norm(DIRECTIONAL_NORMS.witness_of(finding), 1)
        yield DIRECTIONAL_NORMS.code, *norm, f"{cause} one direction"
    for finding in facts.all(DIRECTIONAL_SMOOTHNESS):
        norm = largest_norm(DIRECTIONAL_SMOOTHNESS.witness_of(finding), c)
        yield DIRECTIONAL_SMOOTHNESS.code, *norm, f"{cause} two directions"
    if facts.verdict(CONVERGENCE) is Verdict.PROVED:
        yield CONVERGENCE.code, 1, Fraction(1), "as S converges"


def _exponent(numbers: MultivariateNumbers, length: int, bound: Fraction) -> float:
    """The exponent -log_λ(bound)/length, rounded down."""
    with ctx.workprec(128):
        lower = interval(-ball(bound).log() * numbers.dimension / ball(numbers.lattice.index).log() / length).lower
    assert lower is not None
    return lower


def _bounds_above(numbers: MultivariateNumbers) -> Iterator[Finding]:
    """The findings by all bounds that are known, for stable φ."""
    product, m, s, k = numbers.product, numbers.lattice.index, numbers.dimension, numbers.order
    if product is not None:
        bound, length = radius_bound(product), len(product.word)
        of_product: MultivariateHolderUpperWitness = {
            "by": DIFFERENCE_RADIUS.code,
            "word": product.word,
            "length": length,
            "radius": bound,
        }
        exact = numbers.radius.exact if numbers.radius is not None else None
        closed = multivariate_exponent(m, s, *exact) if exact is not None else None
        upper = exponent_above(m, s, length, bound)
        text = rounded_up(upper) if closed is None else worded(closed)
        why = f"φ is stable, and {product_name(product.word)} bounds ρ_{k} from below"
        yield HOLDER_UPPER.proved(f"α ≤ {text}: {why}", of_product, Interval(upper=upper), why=why)
        if exact is not None:
            alone: MultivariateHolderUpperWitness = {**of_product, "by": HOLDER_UPPER.code}
            yield HOLDER_UPPER.proved(f"α ≤ {rounded_up(upper)}: {why}", alone, Interval(upper=upper), why=why)
    why = f"φ is stable, and the sum rules are of order {k}"
    witness: MultivariateHolderUpperWitness = {"by": SUM_RULES.code, "length": s, "radius": Fraction(1, m**k)}
    yield HOLDER_UPPER.proved(f"α ≤ {k}: {why}", witness, Interval(upper=float(k)), why=why)
    growth = None if numbers.mean_squares is None else numbers.mean_squares.growth
    if growth is not None:
        upper, why = exponent_above(m, s, 2, growth.low), "φ is stable, and that bounds its Sobolev exponent"
        mean: MultivariateHolderUpperWitness = {"by": SOBOLEV.code, "length": 2, "radius": growth.low}
        statement = f"α ≤ {rounded_up(upper)}: {why}"
        yield HOLDER_UPPER.proved(statement, mean, Interval(upper=upper), proof=growth_proof(numbers), why=why)


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

    Where that is no equality, α <= s and s <= α + dimension/2, and s <= k for stable φ, by bounds of SD614 and SD615.

    Witness: `by`, SD603 and `value`; or SD609, as SD614 has it, and `variables_above` of a factor that bounds s
    from above; or SD614, with the places, `below` and `above`, of the bounds among those that are known; or SD602, the
    order of the differences, with `polynomial`, that of Λ, integers, lowest power first; `low` and `high`, which
    enclose Λ and no other zero of it; `holds`, whether s is equal to the bound, and `above` where another bounds it
    from above. `proof`: these, and the `cofactor` that makes the polynomial annihilate the sequences.
    """
    if numbers.box is not None:
        return (_sobolev_of_box_spline(numbers.box.depth),)
    if numbers.parts:
        return (_least_sobolev(numbers.parts),)
    reason = None if numbers.lattice.is_isotropic else ANISOTROPIC
    reason = reason if numbers.order else "no sum rule holds"
    if reason is not None:
        return (SOBOLEV.skipped(_SOBOLEV_QUESTION, reason),)
    known = numbers.mean_squares
    stably = facts.verdict(STABILITY) is Verdict.PROVED
    findings = [*_between(numbers, facts)]
    if known is not None and known.growth is not None:
        by_growth = _of_mean_squares(numbers, known.growth, stably)
        findings = [by_growth, *findings] if stably else _by_both(by_growth, findings)
    if findings:
        return (best_of(findings),)
    large = "the operator on correlations is too large for this effort"
    multiple = "the growth of the mean squares is a multiple zero of its polynomial"
    return (SOBOLEV.undecided(_SOBOLEV_QUESTION, large if known is None else multiple),)


def _between(numbers: MultivariateNumbers, facts: Facts) -> Iterator[Finding]:
    """The findings α <= s <= α + dimension/2 (for stable φ), by bounds of α not by s, the best one first."""
    m, d, why = numbers.lattice.index, numbers.dimension, "by the Hölder exponent"
    most = []
    for j, upper in _apart(facts.find(HOLDER_UPPER)):
        above = HOLDER_UPPER.witness_of(upper)
        length, bound = above["length"], above["radius"]
        if above["by"] != SUM_RULES.code:
            length, bound = 2 * length, bound**2 / m**length
        most.append((exponent_above(m, d, length, bound), j))
    for i, lower in _apart(facts.find(HOLDER_LOWER)):
        below = HOLDER_LOWER.witness_of(lower)
        low = _exponent(numbers, below["length"], upper_bound(below))
        witness: MultivariateSobolevWitness = {"by": HOLDER_LOWER.code, "below": i}
        for high, j in sorted(most):
            statement = f"{rounded_down(low)} ≤ s ≤ {rounded_up(high)}, {why}"
            yield SOBOLEV.proved(statement, {**witness, "above": j}, Interval(low, high), why=why)
        yield SOBOLEV.proved(f"s ≥ {rounded_down(low)}, {why}", witness, Interval(lower=low), why=why)


def _by_both(by_growth: Finding, between: list[Finding]) -> list[Finding]:
    """The findings on s where mean squares bound it from below only, with the best bounds first."""
    if not between or _lower_of(between[0]) >= _lower_of(by_growth):
        return [*between, by_growth]
    witness = SOBOLEV.witness_of(between[0])
    if "above" not in witness or between[0].value is None or between[0].value.upper is None:
        return [by_growth, *between]
    high, why = between[0].value.upper, f"{by_growth.why}; from above by the Hölder exponent"
    both: MultivariateSobolevWitness = {**SOBOLEV.witness_of(by_growth), "above": witness["above"]}
    value = Interval(_lower_of(by_growth), high)
    statement = f"{rounded_down(_lower_of(by_growth))} ≤ s ≤ {rounded_up(high)}: {why}"
    return [SOBOLEV.proved(statement, both, value, proof=by_growth.proof, why=why), *between]


def _apart(finding: Finding | None) -> list[tuple[int, Finding]]:
    """The findings of a rule that are proved, the best one first, with their places, but for those by s."""
    several = [] if finding is None or finding.verdict is not Verdict.PROVED else [finding, *finding.otherwise]
    return [(i, each) for i, each in enumerate(several) if each.witness["by"] != SOBOLEV.code]


def _sobolev_of_box_spline(depth: int) -> Finding:
    s = depth - Fraction(1, 2)
    why = f"{depth} directions must go until the others do not span"
    return SOBOLEV.proved(f"s = {s}: {why}", {"by": BOX_SPLINE.code, "value": s}, interval(s), s, why=why)


def _least_sobolev(parts: tuple[Part, ...]) -> Finding:
    least, most = products.least(parts, questions.SOBOLEV), products.least_upper(parts, questions.SOBOLEV)
    if least is None and most is None:
        return SOBOLEV.undecided(_SOBOLEV_QUESTION, products.NOT_LEAST)
    witness: MultivariateSobolevWitness = {"by": TENSOR_PRODUCT.code}
    lower = upper = None
    bounds, reasons = [], []
    if least is not None:
        finding, why = least.part.finding(questions.SOBOLEV), f"the least exponent of a factor: {least.part.name}"
        value = finding.value or Interval()
        products.put_least(witness, least)
        if least.is_exact:
            return SOBOLEV.proved(f"s = {_shown(finding)}, {why}", witness, value, finding.closed, why=why)
        lower = value.lower
        bounds.append(f"s ≥ {rounded_down(lower or 0.0)}, {why}")
        reasons.append(why)
    if most is not None:
        why = f"an exponent of a factor: {most.name}"
        witness["variables_above"] = most.variables
        upper = (most.finding(questions.SOBOLEV).value or Interval()).upper
        bounds.append(f"s ≤ {rounded_up(upper or 0.0)}, {why}")
        reasons.append(why)
    return SOBOLEV.proved("; ".join(bounds), witness, Interval(lower, upper), why="; ".join(reasons))


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
