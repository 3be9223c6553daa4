"""The rules that compose claims on masks of matrices: convergence, smoothness, the Hölder exponent. See FORMAT.md.

Families of order 0 are those of sequences that die out, of order k > 0 those of the k-th differences of limit stencils;
ρ is the joint spectral radius of a family.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.radius.families import UPPER, bound_of
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import fraction_bits

LOWER = ("radius-lower", "radius", "bounded")
_ROOT = ("length", "polynomial", "low", "high")


def converges(c: Claim) -> None:
    """S converges uniformly: E_A ≠ 0, and ρ < 1 for the sequences that die out (theorem 1)."""
    c.count(1)
    used = c.use(*UPPER).statement
    c.use("family", family=used["family"], order=0)
    require(bound_of(used) < 1, "the radius is not small enough")


def diverges(c: Claim) -> None:
    """S diverges: E_A = 0, or ρ >= 1 on a space of sequences that would have to die out (theorem 1)."""
    c.count(1)
    used = c.use("constants", *LOWER).statement
    if used["property"] == "constants":
        require(used["dimension"] == 0, "there are constants")
        return
    c.use("family", family=used["family"], order=0)
    require(bound_below(used) >= 1, "the radius is not large enough")


def continuous(c: Claim) -> None:
    """All limits are C^0: S converges."""
    c.count(1)
    c.use("convergent", holds=True)
    require(c.statement["order"] == 0, "the order is not 0")


def smooth(c: Claim) -> None:
    """All limits are C^n: ρ < p^-n for k-th differences, k > n (theorem 3)."""
    n = c.statement["order"]
    c.count(1)
    c.use("convergent", holds=True)
    used = c.use(*UPPER).statement
    require(_order(c, used) > n, "the differences are not of a higher order")
    require(scaled(c, bound_of(used), n * used["length"]) < 1, "the radius is not small enough")


def not_smooth(c: Claim) -> None:
    """Not all limits are C^n: ρ >= p^-n for k-th differences, k > n; or k <= n and ρ > p^-k (theorem 3)."""
    n = c.statement["order"]
    c.count(1)
    c.use("convergent", holds=True)
    used = c.use(*LOWER).statement
    k, bound = _order(c, used), bound_below(used)
    x = scaled(c, bound, min(n, k) * used["length"])
    require(x >= 1 if n < k else x > 1, "the radius is not large enough")


def holder_lower(c: Claim) -> None:
    """α >= -log_p(x)/ℓ: ρ^ℓ <= x, p^-kℓ <= x < 1 for k-th differences (theorem 3)."""
    c.count(1)
    c.use("convergent", holds=True)
    used = c.use(*UPPER).statement
    k, s = _order(c, used), c.statement
    require(used["length"] == s["length"] and bound_of(used) <= s["bound"], "the radius has another length or bound")
    require(scaled(c, s["bound"], k * s["length"]) >= 1, f"the differences tell only that α is at least {k}")


def holder_upper(c: Claim) -> None:
    """α <= -log_p(y)/ℓ: ρ^ℓ >= y > p^-kℓ for k-th differences (theorem 3)."""
    c.count(1)
    c.use("convergent", holds=True)
    used = c.use(*LOWER).statement
    k, s = _order(c, used), c.statement
    require(used["length"] == s["length"] and bound_below(used) == s["bound"], "the radius has another bound")
    require(scaled(c, s["bound"], k * s["length"]) > 1, f"the differences do not tell an exponent below {k}")


def holder_root(c: Claim) -> None:
    """α = -log_p(Λ)/ℓ: ρ^ℓ = Λ > p^-kℓ for k-th differences (theorem 3)."""
    c.count(1)
    c.use("convergent", holds=True)
    used = c.use("radius", "bounded", **{key: c.statement[key] for key in _ROOT}).statement
    require(scaled(c, used["low"], _order(c, used) * used["length"]) > 1, "the exponent is not seen to be below k")


def attained(c: Claim) -> None:
    """α is attained: products are O(ρ^L), ρ = p^-α, for k-th differences, k > α no integer, or k = α (theorem 4)."""
    c.count(1)
    used = c.use("bounded").statement
    k, exponent = _order(c, used), c.use("holder-root").statement
    power = _integer(c, exponent, k)
    if power is None:
        same = {key: used[key] for key in _ROOT} == {key: exponent[key] for key in _ROOT}
        require(same or _same_power(c, used, exponent), "the radius is another")
        return
    require(power == k, "α is an integer, and not the order of the differences")
    require(_is_power(c, used, k), "the radius is not p^-k")


def not_attained(c: Claim) -> None:
    """α is not attained: products grow like L p^-αL, for k-th differences, k > α no integer, or k = α (theorem 4)."""
    c.count(1)
    used = c.use("defective").statement
    k, exponent = _order(c, used), c.use("holder-root").statement
    power = _integer(c, exponent, k)
    if power is not None:
        require(power == k, "α is an integer, and not the order of the differences")
        require(scaled(c, used["value"], k * used["length"]) == 1, "the products do not grow like that")
        return
    grown = {"polynomial": (-used["value"].numerator, used["value"].denominator), "length": used["length"]}
    require(_same_power(c, grown, exponent), "the products do not grow like that")


def _integer(c: Claim, exponent: Statement, k: int) -> int | None:
    """The number α = -log_p(Λ)/ℓ where it is an integer, at most k; None where it is none, below k.

    Λ = p^-αℓ is rational then: where the polynomial is of a higher degree, its interval must hold no power of p.
    """
    root, low, high = _rational(exponent), exponent["low"], exponent["high"]
    for n in range(k + 1):
        x = Fraction(1, c.p ** (n * exponent["length"]))
        if root == x:
            return n
        require(root is not None or not low <= x <= high, "the root is not seen to be no power of p")
    require(scaled(c, low, k * exponent["length"]) > 1, "the exponent is not below the order of the differences")
    return None


def _same_power(c: Claim, one: Statement, other: Statement) -> bool:
    """Whether Λ^(1/ℓ) are the same number, of rational roots."""
    x, y = _rational(one), _rational(other)
    if x is None or y is None:
        return False
    c.spend(1, fraction_bits(x) * other["length"] + fraction_bits(y) * one["length"])
    return bool(x ** other["length"] == y ** one["length"])


def _is_power(c: Claim, radius: Statement, k: int) -> bool:
    root = _rational(radius)
    return root is not None and scaled(c, root, k * radius["length"]) == 1


def _rational(root: Statement) -> Fraction | None:
    """The root where its polynomial is of degree 1."""
    f = root["polynomial"]
    return Fraction(-f[0], f[1]) if len(f) == 2 else None


def _order(c: Claim, used: Statement) -> int:
    """The order k > 0 of the differences that a family belongs to; that claim is used next."""
    k: int = c.use("family", family=used["family"]).statement["order"]
    require(k > 0, "the family is not that of differences of limit stencils")
    return k


def bound_below(s: Statement) -> Fraction:
    """The bound y with JSR^length >= y, of a claim that bounds a radius from below."""
    bound: Fraction = s["bound" if s["property"] == "radius-lower" else "low"]
    return bound


def scaled(c: Claim, x: Fraction, exponent: int) -> Fraction:
    """The number x p^exponent."""
    c.spend(1, fraction_bits(x) + exponent * c.p.bit_length())
    return x * Fraction(c.p) ** exponent
