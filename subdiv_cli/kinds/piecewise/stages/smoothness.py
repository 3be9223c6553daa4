"""Stages on smoothness in the geometric parameter: at 0 alone, and everywhere (SD824 to SD828)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from flint import ctx

from subdiv_cli.exact.closed import closed_interval, exponent, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import number, rounded_down, rounded_up
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.piecewise.numbers.piecewise import FunctionalGrowth, PiecewiseNumbers
from subdiv_cli.kinds.piecewise.numbers.sides import DecayRate
from subdiv_cli.kinds.piecewise.rules import (
    AT_ZERO,
    CONVERGENCE,
    HOLDER_LOWER,
    HOLDER_UPPER,
    NEXT_SMOOTHNESS,
    SMOOTHNESS,
)
from subdiv_cli.kinds.piecewise.stages.near_zero import DIVERGES
from subdiv_cli.kinds.piecewise.witnesses import AtZeroWitness, PiecewiseHolderWitness
from subdiv_cli.model import INFINITY, Finding, Interval, Smoothness, Verdict
from subdiv_cli.model import findings as questions
from subdiv_cli.model.proofs import root_data

_AT_ZERO_QUESTION = "how regular are the limits at 0 alone?"


@asking((AT_ZERO, _AT_ZERO_QUESTION))
def at_zero(numbers: PiecewiseNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD824: the exponent at 0 alone, the largest α with all limits a polynomial plus O(|x|^(α-ε)) at 0.

    Theorem 2 of numbers/functionals.py: α = -log_p ρ_k, the spectral radius of A on 𝓕_k, for a k with ρ_k > p^-k;
    limits are polynomials near 0 where ρ_k = 0. Both sides may be less smooth than that. 𝓕_k, the combinations of the
    functionals of the limit near 0 that annihilate π_(k-1) in the geometric parameter, is computed exactly, with all
    that spans it. Hypothesis, convergence (SD823): checked.

    Witness: `order`, k, and `dimension` of the recurrent part of 𝓕_k; `length` and `root`, ρ_k^length, or `bound` from
    above and `below`.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (AT_ZERO.skipped(_AT_ZERO_QUESTION, DIVERGES),)
    growth, p = numbers.growth, numbers.p
    witness: AtZeroWitness = {"order": growth.order, "dimension": growth.dimension}
    if growth.spectrum is None:
        return (AT_ZERO.proved("limits are polynomials near 0", witness, closed_interval(INFINITY), INFINITY),)
    below, above = growth.below(p), growth.above(p)
    radius = f"of S on 𝓕_{growth.order}, of dimension {growth.dimension}"
    if above is not None and above.polynomial is not None:
        closed = exponent(p, above.length, above.root)
        witness |= {"length": above.length, "root": root_data(above.root)}
        rho = f"{number(above.low)} is the" if (above.low, above.length) == (above.high, 1) else "by the"
        statement = f"α = {worded(closed)} at 0 alone: {rho} spectral radius {radius}"
        return (AT_ZERO.proved(statement, witness, closed_interval(closed), closed),)
    witness |= {"length": below.length, "bound": below.high}
    value = Interval(lower=_value(p, below).lower)
    if above is not None:
        witness["below"] = above.low
        value = Interval(value.lower, _value(p, above).upper)
    ends = f"α ≥ {rounded_down(value.lower or 0.0)}"
    ends += "" if above is None else f", ≤ {rounded_up(value.upper or 0.0)}"
    return (AT_ZERO.proved(f"{ends} at 0 alone, by the spectral radius {radius}", witness, value),)


def _value(p: int, decay: DecayRate) -> Interval:
    """The exponent of a rational decay in outward doubles."""
    with ctx.workprec(128):
        return interval(-ball(decay.high).log() / ball(p).log() / decay.length)


_SMOOTHNESS_QUESTION = "how smooth are the limits?"


@asking((SMOOTHNESS, _SMOOTHNESS_QUESTION))
def smoothness(numbers: PiecewiseNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD825: the largest n for which all limits are proved C^n in the geometric parameter. SD826: not C^(n+1).

    Theorem 3 of numbers/functionals.py: all limits are C^n iff those of both masks are and ρ_k < p^-n for a k > n; for
    n >= k it is excluded by ρ_k > p^-k. Hypotheses, convergence (SD823) and what the masks have (SD820): checked.

    Witness: `order`; SD826: `order`, and `by`, `left`, `right` or `zero`, what excludes it.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (SMOOTHNESS.skipped(_SMOOTHNESS_QUESTION, DIVERGES),)
    growth = _known(numbers, facts)
    orders = {name: side.smooth for name, side in numbers.sides}
    n = min(orders.values())
    if growth is None:
        n = 0
    else:
        while n and not is_smooth(growth, numbers.p, n):
            n -= 1
    why = "S converges" if not n else "both masks are, and so it is at 0"
    proved = SMOOTHNESS.proved(
        f"all limits are C^{n}: {why}", {"order": n}, answers={questions.SMOOTHNESS: Smoothness(n)}, why=why
    )
    by = next(_excluding(numbers, growth, n + 1), None)
    if by is None:
        return (proved, NEXT_SMOOTHNESS.undecided(f"are all limits C^{n + 1}?", "nothing is known that excludes it"))
    name, why = by
    statement = f"not all limits are C^{n + 1}: {why}"
    return (proved, NEXT_SMOOTHNESS.refuted(statement, {"order": n + 1, "by": name}, why=why))


def _known(numbers: PiecewiseNumbers, facts: Facts) -> FunctionalGrowth | None:
    return numbers.growth if facts.verdict(AT_ZERO) is Verdict.PROVED else None


def _excluding(numbers: PiecewiseNumbers, growth: FunctionalGrowth | None, n: int) -> Iterator[tuple[str, str]]:
    """What excludes C^n, with the reason in words."""
    if growth is not None and _excludes(growth, numbers.p, n):
        yield "zero", f"at 0 the spectral radius is {'≥' if n < growth.order else '>'} {numbers.p}^-{n}"
    for name, side in numbers.sides:
        if side.not_smooth is not None and side.not_smooth <= n:
            yield name, f"the {name} mask is not"


def is_smooth(growth: FunctionalGrowth, p: int, n: int) -> bool:
    """Whether ρ_k < p^-n, n < k, is seen; where A has no eigenvalue on 𝓕_k but 0 it has none for larger k."""
    fits = n < growth.order or growth.spectrum is None
    return fits and growth.upper.high * p ** (n * growth.upper.length) < 1


def _excludes(growth: FunctionalGrowth, p: int, n: int) -> bool:
    """Whether ρ_k >= p^-n, n < k, or ρ_k > p^-k, is seen."""
    if n >= growth.order or growth.spectrum is None:
        return growth.above(p) is not None
    return growth.spectrum.compare(Fraction(1, p**n)) >= 0


_BELOW, _ABOVE = "how regular are the limits at least?", "how regular are the limits at most?"


@asking((HOLDER_LOWER, _BELOW), (HOLDER_UPPER, _ABOVE))
def holder(numbers: PiecewiseNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD827: the Hölder exponent of the limits from below. SD828: from above.

    Theorem 3 of numbers/functionals.py: α = min(α_left, α_right, -log_p ρ_k), as soon as this is below k; each of the
    three bounds α from above. Hypotheses, convergence (SD823), and exponents of the masks that their certificates state
    (SD820): checked.

    Witness: `by`, `left`, `right` or `zero`; `length`, with `root` where α is known, else with `bound`.
    """
    if facts.verdict(CONVERGENCE) is not Verdict.PROVED:
        return (HOLDER_LOWER.skipped(_BELOW, DIVERGES), HOLDER_UPPER.skipped(_ABOVE, DIVERGES))
    growth = _known(numbers, facts)
    exact = next(_exact(numbers, growth), None)
    if exact is not None:
        name, decay = exact
        closed = exponent(numbers.p, decay.length, decay.root)
        witness: PiecewiseHolderWitness = {"by": name, "length": decay.length, "root": root_data(decay.root)}
        why = "it is that at 0" if name == "zero" else f"it is that of the {name} mask"
        value = closed_interval(closed)
        return (
            HOLDER_LOWER.proved(f"α = {worded(closed)}: {why}", witness, value, closed, why=why),
            HOLDER_UPPER.proved(f"α ≤ {worded(closed)}: {why}", witness, value, closed, why=why),
        )
    return (_lower(numbers, growth), _upper(numbers, growth))


def _bounds(numbers: PiecewiseNumbers, growth: FunctionalGrowth | None) -> dict[str, DecayRate | None]:
    """What bounds the three exponents from below."""
    zero = None if growth is None else growth.below(numbers.p)
    return {**{name: side.below for name, side in numbers.sides}, "zero": zero}


def _exact(numbers: PiecewiseNumbers, growth: FunctionalGrowth | None) -> Iterator[tuple[str, DecayRate]]:
    """The exponent of one of the three that is known, and seen to be the least."""
    bounds = _bounds(numbers, growth)
    candidates = {name: side.exact for name, side in numbers.sides}
    candidates["zero"] = None if growth is None else growth.above(numbers.p)
    for name, decay in candidates.items():
        if decay is None or decay.polynomial is None:
            continue
        others = [bound for other, bound in bounds.items() if other != name]
        if all(b is not None and (b.is_same(decay) or b.at_most(decay.low, decay.length)) for b in others):
            yield name, decay


def _lower(numbers: PiecewiseNumbers, growth: FunctionalGrowth | None) -> Finding:
    bounds = _bounds(numbers, growth)
    for name, decay in bounds.items():
        if decay is not None and all(b is not None and b.at_most(decay.high, decay.length) for b in bounds.values()):
            lower = _value(numbers.p, decay).lower
            witness: PiecewiseHolderWitness = {"by": name, "length": decay.length, "bound": decay.high}
            return HOLDER_LOWER.proved(f"α ≥ {rounded_down(lower or 0.0)}", witness, Interval(lower=lower))
    return HOLDER_LOWER.undecided(_BELOW, "it is not known of both masks and at 0")


def _upper(numbers: PiecewiseNumbers, growth: FunctionalGrowth | None) -> Finding:
    results = {name: side.above for name, side in numbers.sides}
    results["zero"] = None if growth is None else growth.above(numbers.p)
    bounds = {
        name: DecayRate(decay.length, decay.low, decay.low) for name, decay in results.items() if decay is not None
    }
    for name, decay in bounds.items():
        if all(other.at_most(decay.low, decay.length) for other in bounds.values()):
            upper = _value(numbers.p, decay).upper
            witness: PiecewiseHolderWitness = {"by": name, "length": decay.length, "bound": decay.low}
            return HOLDER_UPPER.proved(f"α ≤ {rounded_up(upper or 0.0)}", witness, Interval(upper=upper))
    return HOLDER_UPPER.undecided(_ABOVE, "no bound is known")
