"""SD614: the Hölder exponent from below. SD615: from above.

Theorems. For isotropic M, λ = |det M|^(1/s), k the order of the sum rules (Jia 1998; Han 2003): α >= -log_λ ρ_k, and
for stable φ they are equal. A product of ℓ operators with an eigenvalue of modulus r bounds ρ_k^ℓ >= r. Box splines
(SD603): α = d - 1 exactly, d >= 2. Hypotheses: M isotropic, checked; stability (SD616) from above.

Where no bound of ρ_k is known, ρ_k² <= m Λ of the mean squares (SD617): α >= s - dimension/2.

Witness: `by`, SD603, SD605 or SD617; `length` and `root`, or `length` and `bound`, as SD605 has them; from above
`length` and `radius`, a rational lower bound of ρ_k^length.
"""

from __future__ import annotations

from fractions import Fraction

from flint import ctx

from subdiv_cli.exact.closed import closed_interval, readable
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import rounded_down, rounded_up
from subdiv_cli.jsr.products import radius_bound
from subdiv_cli.jsr.result import root_data
from subdiv_cli.model import Data, Finding, Interval, Verdict, logarithm, unpowered
from subdiv_cli.quantities.multivariate import MultivariateNumbers
from subdiv_cli.stages.joint_radius import shown
from subdiv_cli.stages.multivariate.rule import (
    ANISOTROPIC,
    Facts,
    growth_proof,
    not_spanning,
    spanning,
    surface_exponent,
)
from subdiv_cli.stages.stage import Rule, product_name, verdict

BELOW = Rule("SD614", "surface-holder-lower", "Jia 1998; Han 2003; de Boor, Höllig & Riemenschneider 1993, I.36")
ABOVE = Rule("SD615", "surface-holder-upper", "Jia 1998; Han 2003; de Boor, Höllig & Riemenschneider 1993, I.36")

_BELOW, _ABOVE = "how regular are the limit functions at least?", "how regular is φ at most?"


def run(numbers: MultivariateNumbers, facts: Facts) -> tuple[Finding, ...]:
    if numbers.box is not None:
        return _of_box_spline(numbers.box.depth)
    reason = None if numbers.lattice.is_isotropic else ANISOTROPIC
    reason = reason if numbers.order else "no sum rule holds"
    if reason is not None:
        return (BELOW.skipped(_BELOW, reason), ABOVE.skipped(_ABOVE, reason))
    if numbers.radius is None:
        none = "no bound of the decay of differences is known"
        return (_in_the_mean(numbers) or BELOW.undecided(_BELOW, none), ABOVE.undecided(_ABOVE, none))
    stably = verdict(facts, "SD616") is Verdict.PROVED
    return (_below(numbers, stably), _above(numbers, stably))


def _of_box_spline(depth: int) -> tuple[Finding, ...]:
    if depth < 2:
        reason = "φ is a box spline that is not continuous"
        return (BELOW.skipped(_BELOW, reason), ABOVE.skipped(_ABOVE, reason))
    alpha = Fraction(depth - 1)
    witness: dict[str, Data] = {"by": "SD603", "value": alpha}
    below, above = f"α ≥ {alpha}: {spanning(depth - 1)}", f"α ≤ {alpha}: {not_spanning(depth)}"
    return (BELOW.proved(below, witness, interval(alpha), alpha), ABOVE.proved(above, witness, interval(alpha), alpha))


def _below(numbers: MultivariateNumbers, stable: bool) -> Finding:
    radius, m, s, k = numbers.radius, numbers.lattice.index, numbers.dimension, numbers.order
    assert radius is not None
    witness: dict[str, Data] = {"by": "SD605", "length": radius.upper[0]}
    if radius.exact is not None and (exact := surface_exponent(m, s, *radius.exact)) is not None:
        value = closed_interval(exact)
        text = readable(exact) or f"{rounded_down(value.lower or 0.0)}…"
        witness["root"] = root_data(radius.exact[1])
        if stable:
            return BELOW.proved(f"α = {text}, as φ is stable and ρ_{k} = {shown(radius)}", witness, value, exact)
        return BELOW.proved(f"α ≥ {text}, as ρ_{k} = {shown(radius)}", witness, Interval(lower=value.lower))
    length, bound = radius.upper
    lower = _exponent(numbers, length, bound)
    statement = f"α ≥ {rounded_down(lower)}, from the bound of ρ_{k}"
    return BELOW.proved(statement, {**witness, "bound": bound}, Interval(lower=lower))


def _in_the_mean(numbers: MultivariateNumbers) -> Finding | None:
    """α >= s - dimension/2, for the bound of s that SD617 has."""
    bound = numbers.mean_decay
    if bound is None:
        return None
    lower = _exponent(numbers, 2, bound)
    witness: dict[str, Data] = {"by": "SD617", "length": 2, "bound": bound}
    statement = f"α ≥ {rounded_down(lower)}, from the mean squares of differences of order {numbers.order}"
    return BELOW.proved(statement, witness, Interval(lower=lower), proof=growth_proof(numbers))


def _exponent(numbers: MultivariateNumbers, length: int, bound: Fraction) -> float:
    """-log_λ(bound)/length, rounded down."""
    with ctx.workprec(128):
        lower = interval(-ball(bound).log() * numbers.dimension / ball(numbers.lattice.index).log() / length).lower
    assert lower is not None
    return lower


def _above(numbers: MultivariateNumbers, stable: bool) -> Finding:
    product, m, s, k = numbers.product, numbers.lattice.index, numbers.dimension, numbers.order
    if not stable:
        return ABOVE.undecided(_ABOVE, "it is not proved that φ is stable")
    if product is None:
        return ABOVE.undecided(_ABOVE, "no product is known that bounds ρ_k from below")
    bound, length = radius_bound(product), len(product.word)
    base, divisor = unpowered(m, length)
    upper = closed_interval(logarithm(base, (1 / bound) ** s, divisor)).upper
    witness: dict[str, Data] = {"by": "SD605", "word": product.word, "length": length, "radius": bound}
    exact = numbers.radius.exact if numbers.radius is not None else None
    closed = surface_exponent(m, s, *exact) if exact is not None else None
    text = (readable(closed) if closed is not None else None) or rounded_up(upper or 0.0)
    statement = f"α ≤ {text}: φ is stable, and {product_name(product.word)} bounds ρ_{k} from below"
    return ABOVE.proved(statement, witness, Interval(upper=upper))
