"""All bounds of the joint spectral radii of difference schemes that a report proves, for exponents and smoothness.

ρ_ν = JSR(S_(Δ^ν)), 1 <= ν <= k. As ρ_ν = max(p^-ν, ρ_(ν+1)) for ν < k, α = -log_p ρ_k >= -log_p ρ_ν. And with λ, the
growth of the mean squares of D = S_(Δ^k) (SD321), λ <= ρ_k² <= p λ: of the products of L matrices, applied to a
vector, λ^L is the mean of the squares, which is at most the largest and at least p^-L times that.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from flint import ctx

from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.rules import CONTRACTIVITY, CONVERGENCE, JOINT_RADIUS, SOBOLEV
from subdiv_cli.kinds.scalar.stages.wording import last_difference, power, scaled
from subdiv_cli.kinds.scalar.witnesses import ContractivityWitness, ConvergenceWitness
from subdiv_cli.model import Interval, Rule, Verdict


class Decay(NamedTuple):
    """A bound ρ_ν^length <= bound, for differences of order ν of a mask; so α >= -log_p(bound)/length."""

    by: Rule[Any]
    """The rule of the finding that proves it."""
    numbers: ScalarNumbers
    nu: int
    length: int
    bound: Fraction
    shown: str
    """What is bounded, as text."""

    @property
    def exponent(self) -> Interval:
        """The exponent -log_p(bound)/length, in outward doubles."""
        return logarithmic(self.numbers.p, self.length, self.bound)

    def proves(self, n: int) -> bool:
        """Whether φ is C^n by it: ρ_ν < p^-n for an order ν > n, which the number itself says where it is small."""
        return bool(self.bound * self.numbers.p ** (n * self.length) < 1)

    @property
    def order(self) -> int | None:
        """The largest n with C^n by it, None without any."""
        return max((n for n in range(self.nu) if self.proves(n)), default=None)


def logarithmic(p: int, length: int, bound: Fraction) -> Interval:
    """The exponent -log_p(bound)/length in outward doubles. Raises ArithmeticError where it is no double."""
    with ctx.workprec(128):
        value = interval(-ball(bound).log() / ball(p).log() / length)
    if value.lower is None or value.upper is None:
        raise ArithmeticError("a logarithm beyond the doubles")
    return value


def decays(numbers: ScalarNumbers, facts: Facts) -> list[Decay]:
    """All bounds of one mask, the best one first; ties in the order of radii, norms, and mean squares."""
    reduced = numbers.reduced
    each = [reduced] if reduced is numbers else [reduced, numbers]
    bounds = [_by_radius(one) for one in each]
    for finding in facts.all(CONTRACTIVITY):
        if finding.verdict is Verdict.PROVED:
            bounds.append(_by_norm(reduced, CONTRACTIVITY, CONTRACTIVITY.witness_of(finding)))
    if reduced is not numbers and facts.verdict(CONVERGENCE) is Verdict.PROVED:
        bounds.append(_by_norm(numbers, CONVERGENCE, facts.witness(CONVERGENCE)))
    bounds.append(mean_decay(reduced))
    return sorted((each for each in bounds if each is not None), key=lambda decay: -(decay.exponent.lower or 0.0))


def _by_radius(numbers: ScalarNumbers) -> Decay | None:
    radius = numbers.radius
    if radius is None:
        return None
    length, bound = radius.upper if radius.exact is None else (radius.exact[0], radius.exact[1].high)
    return Decay(JOINT_RADIUS, numbers, numbers.order, length, bound, f"ρ({last_difference(numbers)})")


def _by_norm(numbers: ScalarNumbers, by: Rule[Any], witness: ContractivityWitness | ConvergenceWitness) -> Decay | None:
    if "norm" not in witness:
        return None
    nu, level = witness["nu"], witness["level"]
    bound = witness["norm"] / numbers.p ** ((nu - 1) * level)
    return Decay(by, numbers, nu, level, bound, power(scaled(numbers, nu), level))


def mean_decay(numbers: ScalarNumbers) -> Decay | None:
    """The bound ρ_k² <= p λ of a stable mask; None where λ is not known."""
    growth = numbers.growth
    if growth is None:
        return None
    shown = f"the spectral radius of the transfer matrix of {last_difference(numbers)}"
    return Decay(SOBOLEV, numbers, numbers.order, 2, numbers.p * growth.high, shown)
