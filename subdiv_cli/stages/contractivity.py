"""SD301: for ν = 1, …, k, does (1/p)S_ν contract?

Theorem (Dyn 1992, 3.2 and 3.4, for any arity p): with sum rules of order ν, ‖((1/p)S_ν)^L‖∞ < 1 for some L iff S_(ν-1)
converges uniformly, and then φ and every limit function are C^(ν-1). Hypotheses a(1) = p and the sum rules: checked,
they are what k says. Norms decide upward; where those of (1/p)S_ν stay above 1, the norms of D = S_(Δ^k), the last
difference scheme, may decide: ‖D^L‖∞ < p^(-(ν-1)L) makes the joint spectral radius of (1/p)S_ν less than 1, because it
is max(1/p, p^(ν-1) ρ) with ρ that of D.

Refuted without norms: by the same formula a product Π of ℓ transition matrices of D with an eigenvalue
|λ| >= p^(-(ν-1)ℓ) excludes every L.

No stability is needed for either: the finding speaks of S_ν. For an unstable mask the schemes S_ν are those of the
reduced mask (SD403), and what they prove holds for φ.

Witness, proved: `nu`; `level` and `norm`, that of ((1/p)S_μ)^level with μ = `norm_of`, below p^((μ-ν) level); where
μ = ν the `norms` of levels 1 to `level`; `condition`, the inequality as text. Refuted: `nu` and the product (see
obstacles.py). Undecided: `nu` and the `norms` computed.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.text import certain, number
from subdiv_cli.model import Data, Finding
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.obstacles import product_obstacle, threshold
from subdiv_cli.stages.stage import Facts, Rule, last_difference, power, scaled, series

RULE = Rule("SD301", "contractivity", "Dyn 1992, Theorems 3.2 and 3.4")


def run(numbers: ScalarNumbers, _: Facts) -> tuple[Finding, ...]:
    return tuple(contraction(numbers.reduced, nu) for nu in range(1, numbers.reduced.order + 1))


def contraction(numbers: ScalarNumbers, nu: int) -> Finding:
    """Whether (1/p)S_ν contracts, for the mask of these numbers and 1 <= ν <= k."""
    operator = scaled(numbers, nu)
    if (obstacle := product_obstacle(numbers, nu - 1)) is not None:
        text, witness = obstacle
        return RULE.refuted(f"{operator} does not contract: {text}", {"nu": nu, **witness})
    norms = numbers.norms(nu)
    if (level := _first_below(norms, 1)) is not None:
        return _by_own_norm(numbers, nu, norms[:level])
    if (level := _first_below(numbers.norms(numbers.order), numbers.p ** (numbers.order - nu))) is not None:
        return _by_last_difference(numbers, nu, level)
    lowest = f"the lowest is {number(min(norms))}" if norms else "not one was computed"
    more = "the time budget ended" if numbers.effort.struck else "a higher effort computes more"
    reason = f"the norms up to level {len(norms)} are not below 1 ({lowest}); {more}"
    return RULE.undecided(f"does {operator} contract?", reason, {"nu": nu, "norms": norms})


def _first_below(norms: Sequence[Fraction], bound: int) -> int | None:
    """The first L with norm_L < bound^L."""
    return next((level for level, norm in enumerate(norms, 1) if norm < bound**level), None)


def _by_own_norm(numbers: ScalarNumbers, nu: int, norms: tuple[Fraction, ...]) -> Finding:
    level, norm = len(norms), norms[-1]
    condition = f"{power(scaled(numbers, nu), level)} = {number(norm)} < 1"
    statement = f"{condition}, so φ is C^{nu - 1}"
    if level > 1:
        rate = certain(lambda: ball(norm) ** (ball(1) / level), 4)
        statement += f" (norms from L = 1: {series(norms, number)}; rate {rate})"
    witness: dict[str, Data] = {
        "nu": nu,
        "norm_of": nu,
        "level": level,
        "norm": norm,
        "norms": norms,
        "condition": condition,
    }
    return RULE.proved(statement, witness, interval(norm))


def _by_last_difference(numbers: ScalarNumbers, nu: int, level: int) -> Finding:
    k, p = numbers.order, numbers.p
    scaled_norm = numbers.norms(k)[level - 1]
    norm = scaled_norm / p ** ((k - 1) * level)
    condition = f"{power(last_difference(numbers), level)} = {number(norm)} < {threshold(p, (nu - 1) * level)}"
    statement = f"{scaled(numbers, nu)} contracts, as {condition}, so φ is C^{nu - 1}"
    witness: dict[str, Data] = {"nu": nu, "norm_of": k, "level": level, "norm": scaled_norm, "condition": condition}
    return RULE.proved(statement, witness, interval(norm))
