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
`high`, which enclose λ and no other zero of it; `cofactor`, what is left of the characteristic polynomial.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb, ctx

from subdiv_cli.exact.closed import exponent, worded
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, valued
from subdiv_cli.kinds.kind import Facts, asking
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth, mean_square_growth, transfer_order
from subdiv_cli.kinds.scalar.rules import SOBOLEV
from subdiv_cli.kinds.scalar.stages.wording import last_difference, no_sum_rule
from subdiv_cli.kinds.scalar.witnesses import SobolevWitness
from subdiv_cli.model import ClosedForm, Finding, Interval, Root
from subdiv_cli.model.closed import spelled

RULE = SOBOLEV

_QUESTION = "how regular is φ in L2?"


@asking((RULE, _QUESTION))
def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    """SD321: the Sobolev exponent of φ; see the theorem above."""
    numbers = numbers.reduced
    k, p = numbers.order, numbers.p
    if k == 0:
        return (RULE.skipped(_QUESTION, no_sum_rule(numbers)),)
    d = numbers.difference(k)
    if not numbers.effort.allows(transfer_order(d.degree, p) ** 3 * numbers.weight**2 // 4):
        return (RULE.undecided(_QUESTION, "the transfer matrix is too large for this effort"),)
    growth = mean_square_growth(d, p)
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
    return (RULE.proved(f"s = {shown}: {why}", witness, _value(growth, p, exact), exact, why=why),)


def _exponent(growth: Growth, p: int) -> arb:
    return -growth.ball().log() / ball(p).log() / 2


def _value(growth: Growth, p: int, exact: ClosedForm) -> Interval:
    """Outward doubles around -log_p(λ)/2, from the enclosure of λ, and its closed form where that can be read."""
    if isinstance(exact, Fraction):
        return interval(exact)
    with ctx.workprec(128):
        return interval(_exponent(growth, p), spelled(exact))
