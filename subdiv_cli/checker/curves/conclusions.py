"""The rules that compose claims on curves: smoothness and the Hölder exponent. See FORMAT.md.

ψ is the curve, n the order of the matrices, d the degree of its polynomial components, V what annihilates them, ρ the
joint spectral radius of the B_i on V. Derivatives of order 0 fit, as the curve is well defined. ψ is C^n iff ρ < p^-n
and the derivatives of order δ <= min(n, d) fit; α is the least of -log_p ρ and the orders δ <= d with p^-δ > ρ that do
not fit.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.checker.core import Claim, Proved
from subdiv_cli.checker.curves.components import decay, on_curve
from subdiv_cli.checker.curves.convergence import LOWER, bound_below
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import fraction_bits, isolated_root


def continuous(c: Claim) -> None:
    """ψ is C^0: it is well defined."""
    c.count(1)
    c.use("well-defined", holds=True)


def polynomial_curve(c: Claim) -> None:
    """ψ is a polynomial of degree d: the d + 1 powers of x span its components."""
    d = c.statement["degree"]
    c.count(1)
    c.use("polynomials", degree=d, dimension=d + 1)


def smooth(c: Claim) -> None:
    """ψ is C^n: ρ < p^-n, and the derivatives of order up to min(n, d) fit."""
    n = c.statement["order"]
    used, length, bound = decay(c)
    last = min(n, used.statement["degree"])
    c.count(1 + last)
    require(_scaled(c, bound, n * length) < 1, "the radius is not small enough")
    for order in range(1, last + 1):
        c.use("derivative", order=order, holds=True)


def not_smooth(c: Claim) -> None:
    """ψ is not C^n: ρ >= p^-n."""
    c.count(1)
    used = _growth(c)
    require(_scaled(c, bound_below(used), c.statement["order"] * used["length"]) >= 1, "the radius is not large enough")


def corner(c: Claim) -> None:
    """ψ is not C^n: derivatives of an order δ <= n do not fit, δ > 0."""
    c.count(1)
    order = c.use("derivative", holds=False).statement["order"]
    require(order <= c.statement["order"], f"the derivatives that do not fit are of order {order}")


def holder_lower(c: Claim) -> None:
    """α >= -log_p(x)/ℓ, x > 0: ρ <= x^(1/ℓ), and the derivatives of each order δ <= d with p^-δ > x^(1/ℓ) fit."""
    s = c.statement
    used, length, bound = decay(c)
    c.count(1 + used.statement["degree"])
    require(s["bound"] > 0, "the bound is not positive")
    c.spend(1, fraction_bits(bound) * s["length"] + fraction_bits(s["bound"]) * length)
    require(bound ** s["length"] <= s["bound"] ** length, "the radius may be larger")
    _fit_above(c, used, s["bound"], s["length"])


def holder_upper(c: Claim) -> None:
    """α <= -log_p(y)/ℓ, y > 0: ρ^ℓ >= y."""
    c.count(1)
    used = _growth(c)
    same = (used["length"], bound_below(used)) == (c.statement["length"], c.statement["bound"])
    require(same, "the radius has another length or bound")


def holder_root(c: Claim) -> None:
    """α = -log_p(Λ)/ℓ: ρ^ℓ = Λ, and the derivatives of each order δ <= d with p^-δ > ρ fit."""
    s = c.statement
    used = c.use("polynomials")
    c.count(1 + used.statement["degree"])
    root = {key: s[key] for key in ("length", "polynomial", "low", "high")}
    radius = c.use("radius", "bounded", **root).statement
    on_curve(c, used, radius["family"])
    _fit_above(c, used, isolated_root(c).low, s["length"])


def holder_value(c: Claim) -> None:
    """α = δ: the derivatives of order δ > 0 do not fit, for which p^-δ > ρ, and those of smaller orders fit."""
    value = c.statement["value"]
    c.count(1 + value)
    c.use("derivative", order=value, holds=False)
    for order in range(1, value):
        c.use("derivative", order=order, holds=True)


def _growth(c: Claim) -> dict[str, Fraction]:
    """The claim that bounds ρ from below."""
    used = c.use("polynomials")
    radius = c.use(*LOWER).statement
    on_curve(c, used, radius["family"])
    require(bound_below(radius) > 0, "the bound is not positive")
    return radius


def _fit_above(c: Claim, used: Proved, x: Fraction, length: int) -> None:
    """Check that the derivatives of each order δ, 0 < δ <= d, with p^-δ > x^(1/length) fit."""
    order = 1
    while order <= used.statement["degree"] and _scaled(c, x, order * length) < 1:
        c.use("derivative", order=order, holds=True)
        order += 1


def _scaled(c: Claim, x: Fraction, exponent: int) -> Fraction:
    """The number x p^exponent."""
    c.spend(1, fraction_bits(x) + exponent * c.p.bit_length())
    return Fraction(x * c.p**exponent)
