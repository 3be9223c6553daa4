"""SD301: for ν = 1, …, k, does (1/p)S_ν contract?

Theorem (Dyn 1992, 3.2 and 3.4, for any arity p): with sum rules of order ν, ‖((1/p)S_ν)^L‖∞ < 1 for some L iff S_(ν-1)
converges uniformly, and then φ and every limit function are C^(ν-1). Hypotheses a(1) = p and the sum rules: checked,
they are what k says. Norms decide upward; where those of (1/p)S_ν stay above 1, the joint spectral radius ρ of
D = S_(Δ^k), the last difference scheme, decides (SD310): that of (1/p)S_ν is max(1/p, p^(ν-1) ρ).

Refuted without norms: by the same formula a product Π of ℓ transition matrices of D with an eigenvalue
|λ| >= p^(-(ν-1)ℓ) excludes every L.

No stability is needed for either: the finding speaks of S_ν. For an unstable mask the schemes S_ν are those of the
reduced mask (SD403), and what they prove holds for φ.

Witness, proved: `nu`; `condition`, the inequality as text; `level`, `norm` and `norms`, those of ((1/p)S_ν)^L for L =
1 to `level`, or `radius_of`, the name (S or S0) of the SD310 finding that decides. Refuted: `nu` and the product (see
obstacles.py). Undecided: `nu` and the `norms` computed.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, number, rounded_up
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.joint_radius import enclosed, shown
from subdiv_cli.kinds.scalar.stages.obstacles import product_obstacle, threshold
from subdiv_cli.kinds.scalar.stages.stage import last_difference, power, scaled, series
from subdiv_cli.model import Data, Finding

RULE = rules.CONTRACTIVITY


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    return tuple(contraction(numbers.reduced, nu) for nu in range(1, numbers.reduced.order + 1))


def contraction(numbers: ScalarNumbers, nu: int) -> Finding:
    """Whether (1/p)S_ν contracts, for the mask of these numbers and 1 <= ν <= k."""
    operator = scaled(numbers, nu)
    if (obstacle := product_obstacle(numbers, nu - 1)) is not None:
        text, witness = obstacle
        return RULE.refuted(f"{operator} does not contract: {text}", {"nu": nu, **witness})
    norms = numbers.norms(nu)
    if norms and norms[-1] < 1:
        return _by_norm(numbers, nu, norms)
    if numbers.radius is not None and numbers.radius.is_below(Fraction(1, numbers.p ** (nu - 1))):
        return _by_radius(numbers, nu)
    lowest = f"the lowest is {number(min(norms))}" if norms else "not one was computed"
    more = "the time budget ended" if numbers.effort.struck else "a higher effort computes more"
    reason = f"the norms up to level {len(norms)} are not below 1 ({lowest}); {more}"
    return RULE.undecided(f"does {operator} contract?", reason, {"nu": nu, "norms": norms})


def _by_norm(numbers: ScalarNumbers, nu: int, norms: tuple[Fraction, ...]) -> Finding:
    level, norm = len(norms), norms[-1]
    condition = f"{power(scaled(numbers, nu), level)} = {number(norm)} < 1"
    statement = f"{condition}, so φ is C^{nu - 1}"
    if level > 1:
        rate = certain(lambda: ball(norm) ** (ball(1) / level), 4)
        statement += f" (norms from L = 1: {series(norms, number)}; rate {rate})"
    witness: dict[str, Data] = {
        "nu": nu,
        "level": level,
        "norm": norm,
        "norms": norms,
        "condition": condition,
    }
    return RULE.proved(statement, witness, interval(norm))


def _by_radius(numbers: ScalarNumbers, nu: int) -> Finding:
    radius, limit = numbers.radius, threshold(numbers.p, nu - 1)
    assert radius is not None
    name = f"ρ({last_difference(numbers)})"
    condition = f"{name} = {shown(radius)} < {limit}" if radius.exact else f"{name} ≤ {_bound(radius)} < {limit}"
    witness: dict[str, Data] = {"nu": nu, "radius_of": numbers.name, "condition": condition}
    return RULE.proved(f"{scaled(numbers, nu)} contracts, as {condition}, so φ is C^{nu - 1}", witness)


def _bound(radius: Radius) -> str:
    return rounded_up(enclosed(radius).upper or 0.0, 12)
