"""The rules that compose claims on masks on Z^s: convergence, smoothness, the Hölder exponent. See FORMAT.md.

m = |det M|, λ = m^(1/s), f the family of the differences of order k, ρ its joint spectral radius; sum rules of order k
hold. Whatever speaks of λ needs an isotropic M: ‖M^L‖ and ‖M^-L‖ are bounded by constants times λ^L and λ^-L.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.multivariate.masks import mask_of
from subdiv_cli.checker.radius.families import UPPER, bound_of
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import fraction_bits

LOWER = ("radius-lower", "radius", "bounded")
_DECAYS = (*UPPER, "sobolev-lower", "sobolev", "matrix-norm", "directional-decay")
"""What bounds ρ from above."""


def converges(c: Claim) -> None:
    """S converges iff ρ < 1 (Han & Jia 1998 for k = 1; M expanding, so differences of lower order decay as well)."""
    c.count(1)
    _, bound = _decay(c, c.use(*_DECAYS).statement)
    require(bound < 1, "the radius is not small enough")


def diverges(c: Claim) -> None:
    """S diverges: coset sums that are not all 1, or ρ >= 1, or φ is not continuous."""
    c.count(1)
    used = c.use("coset-sums", "not-smooth", *LOWER).statement
    if used["property"] == "coset-sums":
        require(not used["holds"], "the coset sums are 1")
        return
    if used["property"] == "not-smooth":
        require(used["order"] == 0, "φ may be continuous")
        return
    c.use("family", family=used["family"])
    require(_bound_below(used) >= 1, "the radius is not large enough")


def smooth(c: Claim) -> None:
    """φ is C^n: ρ < λ^-n for differences of an order k > n. It is C^0 for any M where S converges."""
    n = c.statement["order"]
    c.count(1)
    if n:
        _isotropic(c)
    used = c.use("convergent", *_DECAYS).statement
    if used["property"] == "convergent":
        require(used["holds"] and n == 0, "it is not that φ is continuous because S converges")
        return
    _isotropic(c)
    length, bound = _decay(c, used, n)
    require(_scaled(c, bound, n * length) < 1, "the radius is not small enough")


def not_smooth(c: Claim) -> None:
    """φ is not C^n: stable, and the sum rules are of order <= n, or ρ >= λ^-n for differences of an order k > n.

    Or s <= n, by a claim on s that needs a stable φ: then α <= n.
    """
    n = c.statement["order"]
    c.count(1)
    _isotropic(c)
    first = c.use("stable", "sobolev").statement
    if first["property"] == "sobolev":
        require(_scaled(c, first["low"], 2 * n) >= 1, "the Sobolev exponent is too large")
        return
    require(first["holds"], "it uses stable with another holds")
    used = c.use("total-sum-rules", *LOWER).statement
    if used["property"] == "total-sum-rules":
        require(used["order"] <= n, f"the sum rules are of order {used['order']}")
        return
    family = c.use("family", family=used["family"]).statement
    require(family["order"] > n, f"the differences are of order {family['order']}")
    bound = _bound_below(used)
    require(bound > 0 and _scaled(c, bound, n * used["length"]) >= 1, "the radius is not large enough")


def holder_lower(c: Claim) -> None:
    """α >= -log_λ(x)/ℓ: ρ^ℓ <= x. Or α >= 0, as S converges: then ρ < 1."""
    c.count(1)
    _isotropic(c)
    used = c.use("convergent", *_DECAYS).statement
    if used["property"] == "convergent":
        require(used["holds"], "S does not converge")
        _same(c, 1, Fraction(1))
    else:
        _same(c, *_decay(c, used))


def holder_upper(c: Claim) -> None:
    """α <= -log_λ(y)/ℓ: ρ^ℓ >= y, k the order of the sum rules, φ stable.

    Or α <= k: y = m^-k, ℓ = s. Or α at most the Sobolev exponent: y = Λ, ℓ = 2, by a claim that needs a stable φ.
    """
    c.count(1)
    _isotropic(c)
    used = c.use("total-sum-rules", "sobolev", *LOWER).statement
    if used["property"] == "sobolev":
        _same(c, 2, used["low"])
    elif used["property"] == "total-sum-rules":
        c.use("stable", holds=True)
        _same(c, *_of_sum_rules(c, used))
    else:
        _highest_differences(c, used)
        _same(c, used["length"], _bound_below(used))


def _of_sum_rules(c: Claim, used: Statement) -> tuple[int, Fraction]:
    """The pair (s, m^-k): exponents of stable φ are at most k = -log_λ(m^-k)/s."""
    dilation = mask_of(c).dilation
    c.spend(1, used["order"] * dilation.cosets.bit_length())
    return dilation.dimension, Fraction(1, dilation.cosets ** used["order"])


def sobolev_at_least(c: Claim) -> None:
    """σ >= -log_λ(x)/ℓ, as it is not below α."""
    c.count(1)
    _isotropic(c)
    used = c.use("holder-lower", "holder-root").statement
    _same(c, used["length"], used["bound" if used["property"] == "holder-lower" else "high"])


def sobolev_at_most(c: Claim) -> None:
    """σ <= -log_λ(x)/ℓ for stable φ: α + s/2 is not above it, as λ^s = m; or k is not, x = m^-k and ℓ = s."""
    c.count(1)
    _isotropic(c)
    used = c.use("holder-upper", "holder-root", "total-sum-rules").statement
    if used["property"] == "total-sum-rules":
        c.use("stable", holds=True)
        _same(c, *_of_sum_rules(c, used))
        return
    length, y = used["length"], used["bound" if used["property"] == "holder-upper" else "low"]
    m = mask_of(c).dilation.cosets
    c.spend(1, length * m.bit_length() + 2 * fraction_bits(y))
    _same(c, 2 * length, y**2 / m**length)


def holder_root(c: Claim) -> None:
    """α = -log_λ(Λ)/ℓ: ρ^ℓ = Λ, k the order of the sum rules, φ stable."""
    c.count(1)
    _isotropic(c)
    root = {key: c.statement[key] for key in ("length", "polynomial", "low", "high")}
    _highest_differences(c, c.use("radius", "bounded", **root).statement)


def _highest_differences(c: Claim, used: Statement) -> None:
    """Check that the family is that of differences of the order of the sum rules, and that φ is stable."""
    family = c.use("family", family=used["family"]).statement
    c.use("total-sum-rules", order=family["order"])
    c.use("stable", holds=True)


def _decay(c: Claim, used: Statement, n: int = 0) -> tuple[int, Fraction]:
    """The pair (ℓ, x) with ρ^ℓ <= x, for differences of an order above n: of a family, a norm, or mean squares.

    In the mean ‖T_w v‖² is at most the sum over all words w of one length, so ρ² <= m Λ; their order is that of the sum
    rules, and it is above n where m Λ < λ^-2n, as Λ >= λ^-2k.
    """
    if used["property"] in ("sobolev-lower", "sobolev"):
        return 2, mask_of(c).dilation.cosets * used["high"]
    by_norm = used["property"] in ("matrix-norm", "directional-decay")
    order = used["order"] if by_norm else c.use("family", family=used["family"]).statement["order"]
    require(order > n, f"the differences are of order {order}")
    return (used["level"], used["norm"]) if by_norm else (used["length"], bound_of(used))


def _same(c: Claim, length: int, bound: Fraction) -> None:
    stated = (c.statement["length"], c.statement["bound"])
    require((length, bound) == stated, "the radius has another length or bound")
    require(bound > 0, "the bound is not positive")


def _bound_below(s: Statement) -> Fraction:
    """The bound y with JSR^length >= y, of a claim that bounds a radius from below."""
    bound: Fraction = s["bound" if s["property"] == "radius-lower" else "low"]
    return bound


def _isotropic(c: Claim) -> None:
    require(mask_of(c).dilation.is_isotropic(), "the dilation is not seen to be isotropic")


def _scaled(c: Claim, x: Fraction, exponent: int) -> Fraction:
    """The number (x λ^exponent)^s, which is rational and compares with 1 as x λ^exponent does for x >= 0."""
    dilation = mask_of(c).dilation
    s, m = dilation.dimension, dilation.cosets
    c.spend(1, s * fraction_bits(x) + exponent * m.bit_length())
    return Fraction(x**s * m**exponent)
