"""The stage on limit stencils (SD621), and what follows from it: smoothness and exponents without stability."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from flint import ctx

from subdiv_cli.exact.closed import closed_interval, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import rounded_down, rounded_up, valued
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.stencil_growth import StencilGrowth
from subdiv_cli.kinds.multivariate.rules import (
    CONVERGENCE,
    DIFFERENCE_RADIUS,
    HOLDER_LOWER,
    HOLDER_UPPER,
    STABILITY,
    STENCIL_RADIUS,
)
from subdiv_cli.kinds.multivariate.stages.wording import exponent_above, multivariate_exponent, threshold
from subdiv_cli.kinds.multivariate.witnesses import (
    MultivariateHolderLowerWitness,
    MultivariateHolderUpperWitness,
    StencilRadiusProof,
    StencilSpaceProof,
    SurfaceStencilWitness,
)
from subdiv_cli.kinds.radius import enclosed, put_radius, shown
from subdiv_cli.kinds.scalar.stages.wording import product_name
from subdiv_cli.model import Finding, Interval, Verdict
from subdiv_cli.model.proofs import root_data

_QUESTION = "how fast do differences of φ decay?"


@asking((STENCIL_RADIUS, _QUESTION))
def stencil_radius(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD621: ρ_k(w), the joint spectral radius of the transition operators T_ε on V_k(w), w the limit stencil.

    V_k(w) is the smallest space that holds the differences ∇^μ w, |μ| = k, and is mapped into itself by the T_ε, up to
    what dies out: their images are the differences of order k of φ (numbers/stencil_growth.py, with the theorem). So it
    decides smoothness and the Hölder exponent whether φ is stable or not. k is the order of the sum rules, or a larger
    one where φ is smoother, so that the exponent is below k. Found and proved as SD310 says.

    Hypotheses, that S converges (SD611) and that M is isotropic: checked. There is a finding only where nothing else
    decides: φ is no box spline (SD603), no tensor product (SD609), and not seen to be stable (SD616), or ρ_k of SD605
    is not known.

    Witness: `order`, k; `dimension` of V_k(w); `stencil`, w; `method`; `word` of a product, as numbers of coset
    representatives; `length` and `bound`, or `length` and `root`. Where a product keeps the radius at what ρ_k of SD605
    leaves for the exponent, that is enough: `word`, `length` and `least`, the spectral radius of its product. `proof`:
    the space and the radius.
    """
    if numbers.box is not None or numbers.parts or not numbers.lattice.is_isotropic:
        return ()
    stably = facts.verdict(STABILITY) is Verdict.PROVED
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED or (stably and numbers.radius is not None):
        return ()
    if (growth := numbers.stencil_growth) is None:
        return (STENCIL_RADIUS.undecided(_QUESTION, "the space of differences of φ is too large, or not bounded"),)
    k, radius, dimension = growth.order, growth.radius, growth.on.space.dimension
    witness: SurfaceStencilWitness = {"order": k, "dimension": dimension, "stencil": growth.stencil}
    proof: StencilRadiusProof = {"space": _space_proof(growth)}
    on = f"on V_{k}(w) of dimension {dimension}"
    if radius is None:
        assert growth.word is not None
        witness |= {"word": growth.word, "length": len(growth.word), "least": growth.least}
        statement = f"{product_name(growth.word)} keeps ρ_{k}(w)^{len(growth.word)} ≥ {valued(growth.least)} {on}"
        return (STENCIL_RADIUS.proved(statement, witness, proof=proof),)
    witness["method"], proof["radius"] = radius.method, radius.proof
    put_radius(witness, radius)
    value = enclosed(radius)
    size = f"≤ {rounded_up(value.upper or 0.0, 12)}" if radius.exact is None else f"= {shown(radius)}"
    attains = f", attained by {product_name(radius.word)}" if radius.exact is not None and radius.word else ""
    return (STENCIL_RADIUS.proved(f"ρ_{k}(w) {size} {on}{attains}", witness, value, proof=proof),)


def _space_proof(growth: StencilGrowth) -> StencilSpaceProof:
    """The space as certificates have it, on the indices where some row of its basis is not 0."""
    window, space = growth.on
    rows = [[int(x) for x in row] for row in rows_of(space.basis)]
    used = [j for j in range(len(window)) if any(row[j] for row in rows)]
    return {
        "cosets": growth.cosets,
        "window": tuple(window[j] for j in used),
        "basis": tuple(tuple(row[j] for j in used) for row in rows),
        "matrices": tuple(rows_of(m) for m in space.matrices),
        "tree": tuple(map(int, space.tree)),
        "breadth": len(window),
        "leaves": rows_of(space.leaves),
        "words": tuple((leaf, *word) for leaf, word in space.origins),
    }


def known(numbers: MultivariateNumbers, facts: Facts) -> StencilGrowth | None:
    """The growth on V_k(w), where SD621 has found it."""
    return numbers.stencil_growth if facts.verdict(STENCIL_RADIUS) is Verdict.PROVED else None


def smooth(numbers: MultivariateNumbers, facts: Facts) -> tuple[int, str] | None:
    """The largest n > 0, n < k, for which ρ_k(w) < λ^-n proves C^n, and the reason in words; None without one."""
    if (growth := known(numbers, facts)) is None or growth.radius is None:
        return None
    length, bound = growth.radius.upper
    orders = [n for n in range(1, growth.order) if _scaled(numbers, bound, n * length) < 1]
    return (max(orders), f"ρ_{growth.order}(w) < {threshold(numbers, max(orders))}") if orders else None


def obstacle(numbers: MultivariateNumbers, facts: Facts, n: int) -> str | None:
    """The reason in words why φ is not C^n: a product keeps ρ_k(w) >= λ^-n, or > λ^-k for n >= k; None without one."""
    growth = known(numbers, facts)
    if growth is None or growth.word is None:
        return None
    k, compared = growth.order, _compared(numbers, growth, min(n, growth.order))
    if compared > 0 or (compared == 0 and n < k):
        sign = "≥" if n < k else ">"
        return f"{product_name(growth.word)} keeps ρ_{k}(w) {sign} {threshold(numbers, min(n, k))}"
    return None


def _compared(numbers: MultivariateNumbers, growth: StencilGrowth, n: int) -> int:
    """The sign of r - λ^-nℓ, r the radius of the product, of length ℓ: by its s-th power, since λ^s = m."""
    assert growth.word is not None
    if growth.radius is None:  # the radius is rational, and known
        x = _scaled(numbers, growth.least, n * len(growth.word))
        return (x > 1) - (x < 1)
    power = WordProduct.of_word(growth.on.space.matrices, growth.word * numbers.dimension)
    return power.eigenvalue.compare_modulus(Fraction(1, numbers.lattice.index ** (n * len(growth.word))))


def _scaled(numbers: MultivariateNumbers, bound: Fraction, exponent: int) -> Fraction:
    """The number (x λ^exponent)^s, which compares with 1 as x λ^exponent does for x >= 0."""
    return Fraction(bound**numbers.dimension * numbers.lattice.index**exponent)


def holder_below(numbers: MultivariateNumbers, facts: Facts) -> Iterator[Finding]:
    """The finding SD614 by ρ_k(w), where that is known: α itself where ρ_k(w) > λ^-k is, else a bound.

    Where a product keeps ρ_k(w) at what ρ_k of SD605 leaves, α is that of SD605.
    """
    if (growth := known(numbers, facts)) is None:
        return
    radius, k, m, s = growth.radius, growth.order, numbers.lattice.index, numbers.dimension
    by, why = STENCIL_RADIUS.code, f"ρ_{k}(w)"
    if radius is None:
        assert numbers.radius is not None
        assert growth.word is not None
        radius, by = numbers.radius, DIFFERENCE_RADIUS.code
        why = f"{product_name(growth.word)} keeps ρ_{k}(w) at ρ_{numbers.order}"
    if radius.exact is not None:
        length, root = radius.exact
        exact = multivariate_exponent(m, s, length, root)
        if exact is not None and _scaled(numbers, root.low, k * length) > 1:
            why = f"{why} = {shown(radius)}"
            of_root: MultivariateHolderLowerWitness = {"by": by, "length": length, "root": root_data(root)}
            value = closed_interval(exact)
            yield HOLDER_LOWER.proved(f"α = {worded(exact)}, as {why}", of_root, value, exact, why=why)
            return
    length, bound = radius.upper
    if _scaled(numbers, bound, k * length) < 1:
        length, bound = s, Fraction(1, m**k)
    with ctx.workprec(128):
        lower = interval(-ball(bound).log() * s / ball(m).log() / length).lower
    why = f"from the bound of ρ_{k}(w)"
    witness: MultivariateHolderLowerWitness = {"by": STENCIL_RADIUS.code, "length": length, "bound": bound}
    statement = f"α ≥ {rounded_down(lower or 0.0)}, {why}"
    yield HOLDER_LOWER.proved(statement, witness, Interval(lower=lower), why=why)


def holder_above(numbers: MultivariateNumbers, facts: Facts, below: Finding | None) -> Iterator[Finding]:
    """The finding SD615 by a product that keeps ρ_k(w) above λ^-k, in the words of α itself where SD614 has it."""
    growth = known(numbers, facts)
    if growth is None or growth.word is None:
        return
    m, s, k, length = numbers.lattice.index, numbers.dimension, growth.order, len(growth.word)
    if _scaled(numbers, growth.least, k * length) <= 1:
        return
    upper = exponent_above(m, s, length, growth.least)
    text = rounded_up(upper) if below is None or below.closed is None else worded(below.closed)
    why = f"{product_name(growth.word)} bounds ρ_{k}(w) from below"
    witness: MultivariateHolderUpperWitness = {
        "by": STENCIL_RADIUS.code,
        "word": growth.word,
        "length": length,
        "radius": growth.least,
    }
    yield HOLDER_UPPER.proved(f"α ≤ {text}: {why}", witness, Interval(upper=upper), why=why)
