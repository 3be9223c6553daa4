"""The Hölder exponent α from a joint spectral radius, and whether it is attained. φ, p, k, D as in `conclusions`.

Attained: with n the largest integer below α, n >= 0, the n-th derivative of φ has the Hölder exponent α - n itself.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import fraction_bits, root_of


def holder_root(c: Claim) -> None:
    """α = -log_p(Λ)/ℓ: JSR(D)^ℓ = Λ, and φ is stable, possibly reduced."""
    c.count(1)
    root = {key: c.statement[key] for key in ("length", "polynomial", "low", "high")}
    used = c.use("radius", "bounded", **root).statement
    family = c.use("family", family=used["family"]).statement
    c.use("sum-rules", mask=family["mask"], order=family["nu"])
    c.use("stable", mask=family["mask"], holds=True)
    c.use_reductions(family["mask"])


def attained_bounded(c: Claim) -> None:
    """p^(αL) ‖S_(Δ^ν)^L‖ is bounded, and so differences of order ν of φ are O(h^α).

    With ν = k and α no integer that is its Hölder class; with ν = α it says that the derivative of order ν - 1 is
    Lipschitz.
    """
    c.count(1)
    bounded = c.use("bounded").statement
    used = c.use("family", "holder", "holder-root").statement
    integer = used["property"] != "family"
    family = c.use("family", family=bounded["family"]).statement if integer else used
    require(family["family"] == bounded["family"], "it uses family with another family")
    k = c.use("sum-rules", mask=family["mask"]).statement["order"]
    c.use("stable", mask=family["mask"], holds=True)
    c.use_reductions(family["mask"])
    nu, length = family["nu"], bounded["length"]
    if integer:
        exponent = _power(c, Fraction(1, c.p), nu)
        require(_is_exponent(c, used, exponent), "the exponent is not ν")
        require(root_of(bounded).rational == _power(c, exponent, length), "the radius is not p^-ν")
    else:
        require(nu == k, "the differences are not of the order of the sum rules")
        require(_between_integers(c, bounded["low"], bounded["high"], length, k), "the exponent may be an integer")


def attained_norm(c: Claim) -> None:
    """The same, from one norm that is p^(-αL) or less: α = ν and ‖((1/p)S_ν)^L‖∞ <= p^-L, or ‖D^L‖∞ = p^(-αL)."""
    c.count(1)
    norm = c.use("norm").statement
    used = c.use("holder", "holder-root").statement
    k = c.use("sum-rules", mask=norm["mask"]).statement["order"]
    c.use_reductions(norm["mask"])
    nu, level, x = norm["nu"], norm["level"], norm["norm"]
    if _is_exponent(c, used, _power(c, Fraction(1, c.p), nu)):
        require(x * _power(c, Fraction(c.p), level) <= 1, "the norm is more than p^-L")
        return
    require(nu == k, "the exponent is not ν, and the differences are not of the order of the sum rules")
    require(used["property"] == "holder", "the exponent is not ν, and not given by the norm")
    scaled = x / _power(c, Fraction(c.p), (k - 1) * level)
    require((used["level"], used["norm"]) == (level, scaled), "the exponent is not that of the norm")
    require(_between_integers(c, scaled, scaled, level, k), "the exponent is an integer or negative")


def not_attained(c: Claim) -> None:
    """p^(αL) ‖S_(Δ^ν)^L‖ is not bounded, ν >= α > 0, φ stable: differences of order ν of φ are not O(h^α)."""
    c.count(1)
    defective = c.use("defective").statement
    family = c.use("family", family=defective["family"]).statement
    used = c.use("holder", "holder-root").statement
    c.use("stable", mask=family["mask"], holds=True)
    c.use_reductions(family["mask"])
    value, length = defective["value"], defective["length"]
    x, level = _rational_exponent(used)
    require(_power(c, value, level) == _power(c, x, length), "the value is not that of the exponent")
    require(x < 1, "the exponent is not positive")
    require(_power(c, Fraction(1, c.p), family["nu"] * level) <= x, "the exponent is larger than ν")


def _rational_exponent(holder: Statement) -> tuple[Fraction, int]:
    """x and L with α = -log_p(x)/L."""
    if holder["property"] == "holder":
        return holder["norm"], holder["level"]
    exact = root_of(holder).rational
    require(exact is not None, "the exponent is not one of a rational number")
    return exact or Fraction(0), holder["length"]


def _is_exponent(c: Claim, holder: Statement, y: Fraction) -> bool:
    """Whether α = -log_p(y), of a claim on α."""
    x, level = (holder["norm"], holder["level"]) if holder["property"] == "holder" else (None, holder["length"])
    if x is None:
        x = root_of(holder).rational
    return x is not None and level > 0 and bool(x == _power(c, y, level))


def _between_integers(c: Claim, low: Fraction, high: Fraction, length: int, k: int) -> bool:
    """Whether p^(-(n+1)ℓ) < low and high < p^(-nℓ) for some n, 0 <= n < k; α <= k always."""
    if high >= 1:
        return False
    step = _power(c, Fraction(c.p), length)
    n, bits = 0, fraction_bits(low) + fraction_bits(high)
    while high * step < 1 and n < k:
        c.spend(1, bits + n * fraction_bits(step))
        n, low, high = n + 1, low * step, high * step
    return low * step > 1 and high < 1


def _power(c: Claim, x: Fraction, exponent: int) -> Fraction:
    c.spend(1, fraction_bits(x) * exponent)
    return Fraction(x**exponent)
