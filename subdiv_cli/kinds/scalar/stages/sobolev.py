"""SD321: the Sobolev exponent of φ, s = sup {t : φ ∈ H^t}, exactly.

Theorem (Eirola 1992, Villemoes 1992, Cohen & Daubechies 1996; Jia 1999 for any arity): let φ be stable, k the largest
order of sum rules, D = S_(Δ^k), and λ the spectral radius of the transfer matrix of the autocorrelation of D (see
numbers/sobolev.py). Then s = -log_p(λ)/2. With a = p (σ/p)^k q and F the matrix of the autocorrelation of q this is
s = k - 1/2 - log_p(ρ(F))/2.

Why: |φ̂(ξ)| is at most C (1+|ξ|)^-k Π|q(ξ/p^j)|, whose mean squares over the shells p^(L-1) π <= |ξ| <= p^L π the powers
of F give; this direction needs no stability. Conversely stability gives a compact set of representatives mod 2π on
which |φ̂| >= c, and ∇^k over the step p^-L is at least as large as the powers of F; and a stable φ in H^k has sum rules
of order k+1. So k must be the largest order: a smaller one gives less.

Hypotheses: a(1) = p and k >= 1, checked; that k is the largest order is what it is computed as; stability: an unstable
mask is reduced to a stable one first (SD403), whose φ0 is as smooth as φ, locally, and so in H^t as well.
Always s - 1/2 <= α <= s <= k, α the Hölder exponent.

Witness: `difference_order`, k of the (reduced) mask; `polynomial`, that of λ, integers, lowest power first; `low` and
`high`, which enclose λ and no other zero of it; `cofactor`, what is left of the characteristic polynomial. Where G is
too large for that, by the Hölder exponent: `by`, SD311, with `length` and `bound` as there, or SD312 alone; `word` and
`radius` of a product, as SD312 has them, or `sum_rule_order`, k.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from flint import arb, ctx

from subdiv_cli.exact.closed import exponent, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, rounded_down, rounded_up, valued
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth
from subdiv_cli.kinds.scalar.rules import HOLDER_LOWER, HOLDER_UPPER, SOBOLEV
from subdiv_cli.kinds.scalar.stages.decay import logarithmic
from subdiv_cli.kinds.scalar.stages.wording import last_difference, no_sum_rule
from subdiv_cli.kinds.scalar.witnesses import SobolevWitness
from subdiv_cli.model import ClosedForm, Finding, Interval, Root, Verdict
from subdiv_cli.model.closed import spelled
from subdiv_cli.model.findings import best_of
from subdiv_cli.model.proofs import upper_bound

RULE = SOBOLEV

_QUESTION = "how regular is φ in L2?"


@asking((RULE, _QUESTION))
def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    """SD321: the Sobolev exponent of φ; see the theorem above."""
    numbers = numbers.reduced
    if numbers.order == 0:
        return (RULE.skipped(_QUESTION, no_sum_rule(numbers)),)
    exactly = [] if numbers.growth is None else [_exactly(numbers, numbers.growth)]
    findings = [*exactly, *_between(numbers, facts)]
    if not findings:
        return (RULE.undecided(_QUESTION, "the transfer matrix is too large for this effort"),)
    return (best_of(findings),)


def _exactly(numbers: ScalarNumbers, growth: Growth) -> Finding:
    k, p = numbers.order, numbers.p
    root = Root(tuple(int(c) for c in growth.radius.minimal_polynomial), growth.low, growth.high)
    exact = exponent(p, 2, root)
    witness: SobolevWitness = {
        "difference_order": k,
        "polynomial": root.coefficients,
        "low": growth.low,
        "high": growth.high,
        "cofactor": growth.cofactor_coefficients(),
    }
    rational = growth.radius.rational
    shown = certain(lambda: _exponent(growth, p)) if rational is None else worded(exact)
    size = certain(growth.ball) if rational is None else valued(rational)
    why = f"the transfer matrix of {last_difference(numbers)} has the spectral radius {size}"
    return RULE.proved(f"s = {shown}: {why}", witness, _value(growth, p, exact), exact, why=why)


def _between(numbers: ScalarNumbers, facts: Facts) -> Iterator[Finding]:
    """The findings α <= s <= α + 1/2 and s <= k by bounds of α that do not rest on s, the best one first."""
    below, above = (_apart(facts.find(rule)) for rule in (HOLDER_LOWER, HOLDER_UPPER))
    most = sorted((_at_most(numbers, upper) for upper in above), key=lambda bound: bound[0])
    why = "by the Hölder exponent"
    for lower in below:
        known = HOLDER_LOWER.witness_of(lower)
        length, bound = known["length"], upper_bound(known)
        low = logarithmic(numbers.p, length, bound).lower
        for high, of_upper in most:
            witness: SobolevWitness = {"by": HOLDER_LOWER.code, "length": length, "bound": bound, **of_upper}
            statement = f"{rounded_down(low or 0.0)} ≤ s ≤ {rounded_up(high)}, {why}"
            yield RULE.proved(statement, witness, Interval(low, high), why=why)
    if not below:
        for high, of_upper in most:
            at_most: SobolevWitness = {"by": HOLDER_UPPER.code, **of_upper}
            reason = why if "word" in of_upper else "the sum-rule order"
            yield RULE.proved(f"s ≤ {rounded_up(high)}, {reason}", at_most, Interval(upper=high), why=reason)


def _apart(finding: Finding | None) -> list[Finding]:
    """The findings of a rule that are proved, the best one first, but for those by s."""
    several = [] if finding is None or finding.verdict is not Verdict.PROVED else [finding, *finding.otherwise]
    return [each for each in several if each.witness.get("by") != SOBOLEV.code]


def _at_most(numbers: ScalarNumbers, upper: Finding) -> tuple[float, SobolevWitness]:
    """The bound α + 1/2 for the α of a product, or k, from above, with what a claim needs of it."""
    witness = HOLDER_UPPER.witness_of(upper)
    if "word" not in witness:
        return float(numbers.order), {"sum_rule_order": numbers.order}
    word, radius = witness["word"], witness["radius"]
    high = logarithmic(numbers.p, 2 * len(word), radius**2 / numbers.p ** len(word)).upper
    assert high is not None
    return high, {"word": word, "radius": radius}


def _exponent(growth: Growth, p: int) -> arb:
    return -growth.ball().log() / ball(p).log() / 2


def _value(growth: Growth, p: int, exact: ClosedForm) -> Interval:
    """Outward doubles around -log_p(λ)/2, from the enclosure of λ, and its closed form where that can be read."""
    if isinstance(exact, Fraction):
        return interval(exact)
    with ctx.workprec(128):
        return interval(_exponent(growth, p), spelled(exact))
