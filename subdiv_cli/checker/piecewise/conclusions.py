"""Rules on convergence, smoothness and exponents, from the sides and from A on spaces of functionals. See FORMAT.md."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.piecewise.masks import masks_of
from subdiv_cli.checker.piecewise.sides import SideStatements, StatedRate
from subdiv_cli.checker.piecewise.spaces import require_sums
from subdiv_cli.checker.radius.families import UPPER
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import fraction_bits

_LOWER = ("radius-lower", "radius")
_SIDES = ("left", "right")


class _Growth(NamedTuple):
    """The spectral radius on the space of an order, or a bound of it."""

    order: int
    decay: StatedRate
    vanishes: bool = False
    """Whether A is nilpotent there: then it is so for all larger orders."""


def _growth(c: Claim, *properties: str) -> _Growth:
    """The radius that the next claims bound: a radius and its family, or `vanishing`."""
    used = c.use(*properties, "vanishing").statement
    if used["property"] == "vanishing":
        return _Growth(used["order"], StatedRate(1, Fraction(0), Fraction(0)), vanishes=True)
    order = c.use("family", family=used["family"]).statement["order"]
    if used["property"] == "radius":
        return _Growth(order, StatedRate(used["length"], used["low"], used["high"], used["polynomial"]))
    return _Growth(order, StatedRate(used["length"], used["bound"], used["bound"]))


def _near_zero(c: Claim, *properties: str) -> _Growth:
    growth = _growth(c, *properties)
    require(growth.order > 0, "the family is not on what annihilates polynomials")
    return growth


def _sides(c: Claim) -> list[SideStatements]:
    return [c.use("side", side=name).result for name in _SIDES]


def converges(c: Claim) -> None:
    """S converges: so do both masks, all rows sum to 1, and A is below 1 on the rows that sum to 0 (theorem 1)."""
    masks = masks_of(c)
    c.count(len(masks.special) + len(masks.left.numerators) + len(masks.right.numerators), masks.bits)
    for each in _sides(c):
        require(each.says("convergent", holds=True), "a side is not known to converge")
    growth = _growth(c, *UPPER)
    require(growth.order == 0, "the family is not on rows that sum to 0")
    require_sums(masks)
    require(growth.decay.high < 1, "the radius is not small enough")


def side_diverges(c: Claim) -> None:
    """S does not converge: the mask of a side does not (theorem 1)."""
    c.count(1)
    require(c.use("side").result.says("convergent", holds=False), "the side is not known to diverge")


def row_diverges(c: Claim) -> None:
    """S does not converge: a special row does not sum to 1, so that all limits would be 0 at 0 (theorem 1)."""
    masks, i = masks_of(c), c.witness["row"]
    c.count(1 + sum(map(len, masks.special.values())), masks.bits)
    require(i in masks.special, "there is no such special row")
    require(sum(masks.special[i].values()) != 1, "the row sums to 1")


def expands(c: Claim) -> None:
    """S does not converge: A has an eigenvalue of modulus 1 or more on the rows that sum to 0 (theorem 1)."""
    c.count(1)
    growth = _growth(c, *_LOWER)
    require(growth.order == 0, "the family is not on rows that sum to 0")
    require(growth.decay.low >= 1, "the radius is not large enough")


def continuous(c: Claim) -> None:
    """All limits are C^0: S converges."""
    c.count(1)
    c.use("convergent", holds=True)


def smooth(c: Claim) -> None:
    """All limits are C^n: S converges, the limits of both masks are C^n, and ρ_k < p^-n with k > n (theorem 3)."""
    n = c.statement["order"]
    c.count(1)
    c.use("convergent", holds=True)
    require(all(each.smooth >= n for each in _sides(c)), "a side is not known to be so smooth")
    growth = _near_zero(c, *UPPER)
    require(growth.vanishes or growth.order > n, "the order of the family is too small")
    require(_scaled(c, growth.decay.high, n * growth.decay.length) < 1, "the radius is not small enough")


def side_not_smooth(c: Claim) -> None:
    """Not all limits are C^n: S converges, and those of the mask of a side are not (theorem 3)."""
    n = c.statement["order"]
    c.count(1)
    c.use("convergent", holds=True)
    excluded = c.use("side").result.not_smooth
    require(excluded is not None and excluded <= n, "the side is not known to be less smooth")


def zero_not_smooth(c: Claim) -> None:
    """Not all limits are C^n: S converges, and ρ_k >= p^-n with k > n, or ρ_k > p^-k with k <= n (theorem 3)."""
    n = c.statement["order"]
    c.count(1)
    c.use("convergent", holds=True)
    growth = _near_zero(c, *_LOWER)
    scaled = _scaled(c, growth.decay.low, min(n, growth.order) * growth.decay.length)
    require(scaled >= 1 if n < growth.order else scaled > 1, "the radius is not large enough")


def holder_lower(c: Claim) -> None:
    """α >= -log_p(x)/ℓ: so are those of both masks and that at 0, which is at least min(k, -log_p ρ_k) (theorem 3)."""
    c.count(1)
    length, bound = c.statement["length"], c.statement["bound"]
    require(bound > 0, "the bound is not positive")
    c.use("convergent", holds=True)
    _require_below(c, [(each.below(), "a side") for each in _sides(c)], StatedRate(length, bound, bound))
    _require_below(c, [(_of_growth(c, _near_zero(c, *UPPER)), "0")], StatedRate(length, bound, bound))


def side_above(c: Claim) -> None:
    """α <= -log_p(x)/ℓ, as that of the mask of a side is (theorem 3)."""
    length, bound = c.statement["length"], c.statement["bound"]
    c.count(1)
    require(bound > 0, "the bound is not positive")
    c.use("convergent", holds=True)
    known = c.use("side").result.above()
    require(any((each.length, each.low) == (length, bound) for each in known), "the side states another bound")


def zero_above(c: Claim) -> None:
    """α <= -log_p(x)/ℓ: ρ_k^ℓ >= x > p^-kℓ (theorem 3); and so is the exponent at 0 alone (theorem 2)."""
    c.count(1)
    c.use("convergent", holds=True)
    growth = _near_zero(c, *_LOWER)
    require((growth.decay.length, growth.decay.low) == (c.statement["length"], c.statement["bound"]), "it is another")
    _require_reached(c, growth)


def holder_root(c: Claim) -> None:
    """α = -log_p(Λ)/ℓ is that of one side, or at 0 with Λ > p^-kℓ, and the other two are not smaller (theorem 3)."""
    c.count(1)
    s, by = c.statement, c.witness["by"]
    c.use("convergent", holds=True)
    own = StatedRate(s["length"], s["low"], s["high"], s["polynomial"])
    left, right = _sides(c)
    growth = _near_zero(c, *UPPER)
    bounds = {"left": left.below(), "right": right.below(), "zero": _of_growth(c, growth)}
    require(by in bounds, "there is no such part")
    if by == "zero":
        require(own == growth.decay, "the radius at 0 is another")
        _require_reached(c, growth)
    else:
        require(own in (left if by == "left" else right).exact(), "the exponent of the side is another")
    _require_below(c, [(each, name) for name, each in bounds.items() if name != by], own)


def zero_root(c: Claim) -> None:
    """The exponent at 0 alone is -log_p(Λ)/ℓ, Λ = ρ_k^ℓ > p^-kℓ (theorem 2)."""
    c.count(1)
    s = c.statement
    c.use("convergent", holds=True)
    growth = _near_zero(c, "radius")
    require(growth.decay == StatedRate(s["length"], s["low"], s["high"], s["polynomial"]), "the radius is another")
    _require_reached(c, growth)


def zero_lower(c: Claim) -> None:
    """The exponent at 0 alone is at least -log_p(x)/ℓ, ρ_k^ℓ <= x and p^-kℓ <= x (theorem 2)."""
    c.count(1)
    bound = StatedRate(c.statement["length"], c.statement["bound"], c.statement["bound"])
    require(bound.low > 0, "the bound is not positive")
    c.use("convergent", holds=True)
    _require_below(c, [(_of_growth(c, _near_zero(c, *UPPER)), "0")], bound)


def zero_polynomial(c: Claim) -> None:
    """All limits are polynomials near 0: A is nilpotent on 𝓕_k, k > 0 (theorem 2)."""
    c.count(1)
    c.use("convergent", holds=True)
    require(c.use("vanishing").statement["order"] > 0, "the space is not on what annihilates polynomials")


def _of_growth(c: Claim, growth: _Growth) -> list[StatedRate]:
    """What bounds the exponent at 0 from below: of ρ_k and p^-k the larger one."""
    if growth.vanishes:
        return [growth.decay]
    least = Fraction(1, c.p**growth.order)
    return [StatedRate(1, least, least) if _at_most(c, growth.decay, StatedRate(1, least, least)) else growth.decay]


def _require_reached(c: Claim, growth: _Growth) -> None:
    scaled = _scaled(c, growth.decay.low, growth.order * growth.decay.length)
    require(scaled > 1, "the exponent is not below the order of the space")


def _require_below(c: Claim, bounds: Iterable[tuple[list[StatedRate], str]], own: StatedRate) -> None:
    """Check that one decay of each list is at most this one: an exponent of each part is not smaller."""
    for known, name in bounds:
        require(any(_at_most(c, each, own) or _is_same(each, own) for each in known), f"that at {name} may be smaller")


def _is_same(a: StatedRate, b: StatedRate) -> bool:
    return a.polynomial is not None and a == b


def _at_most(c: Claim, a: StatedRate, b: StatedRate) -> bool:
    """Whether a^(1/ℓ) <= b^(1/ℓ') from the bounds of both."""
    c.spend(1, fraction_bits(a.high) * b.length + fraction_bits(b.low) * a.length)
    return bool(a.high**b.length <= b.low**a.length)


def _scaled(c: Claim, x: Fraction, exponent: int) -> Fraction:
    """The number x p^exponent."""
    c.spend(1, fraction_bits(x) + exponent * c.p.bit_length())
    return Fraction(x * c.p**exponent)
