"""The rules that compose earlier claims, one function each: convergence, smoothness and the Hölder exponent α.

φ is that of mask 0; p, a, k as in `symbols`, D = S_(Δ^k).
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.radius.families import UPPER, bound_of
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.scalar.masks import use_reductions


def converges(c: Claim) -> None:
    """S converges: some ‖S_(Δ^ν)^L‖∞ < 1 (Dyn 1992, Theorem 3.2, for ν = 1; FORMAT.md for larger ν), or JSR < 1."""
    c.count(1)
    used = c.use("norm", *UPPER).statement
    if used["property"] == "norm":
        require(used["mask"] == 0, "it uses norm with another mask")
        contracts(c, used, 1)
    else:
        c.use("family", family=used["family"], mask=0)
        require(bound_of(used) < 1, "the radius is not small enough")


def diverges(c: Claim) -> None:
    """S diverges: a residue sum is not 1, a product has an eigenvalue |λ| >= 1, or an A_ε has one besides simple 1."""
    c.count(1)
    used = c.use("residue-sums", "product", "eigen-condition").statement
    if used["property"] == "eigen-condition":
        require(used["nu"] == 0 and not used["holds"], "the eigen-condition for ν = 0 is not refuted")
        return
    require(used["mask"] == 0, "it uses a claim on another mask")
    if used["property"] == "product":
        require(used["radius"] >= 1, "the radius is below 1")
    else:
        require(set(used["sums"]) != {1}, "the residue sums are 1")


def smooth(c: Claim) -> None:
    """φ is C^n: some ‖S_(Δ^ν)^L‖∞ < p^(-nL) or JSR(S_(Δ^ν)) < p^-n, ν > n, for the mask or one that it reduces to."""
    c.count(1)
    use_reductions(c, contraction(c, c.statement["order"]))


def contraction(c: Claim, n: int) -> int:
    """The mask whose (1/p)S_(n+1) contracts, by the norm or by the radius that is used next: its S_n converges."""
    used = c.use("norm", *UPPER).statement
    if used["property"] == "norm":
        contracts(c, used, n + 1)
        return int(used["mask"])
    family = c.use("family", family=used["family"]).statement
    require(family["nu"] > n, f"the family is not one of S_(Δ^{n + 1}) or a later one")
    small = bound_of(used) * power(c, Fraction(c.p), n * used["length"]) < 1
    require(small, "the radius is not small enough")
    return int(family["mask"])


def not_smooth(c: Claim) -> None:
    """φ is not C^j: stable, possibly reduced, with k <= j or an eigenvalue |λ| >= p^(-jℓ) of a product of length ℓ."""
    j = c.statement["order"]
    c.count(1)
    mask = c.use("stable", holds=True).statement["mask"]
    used = c.use("sum-rules", "product", mask=mask).statement
    if used["property"] == "sum-rules":
        require(used["order"] <= j, f"the sum rules are of order {used['order']}")
    else:
        require(used["radius"] * power(c, Fraction(c.p), j * len(used["word"])) >= 1, "the radius is too small")
    use_reductions(c, mask)


def holder_lower(c: Claim) -> None:
    """α >= -log_p(x)/L with x = ‖D^L‖∞ = ‖((1/p)S_k)^L‖∞ / p^((k-1)L), or JSR(D)^L <= x."""
    level = c.statement["level"]
    c.count(1)
    used = c.use("norm", *UPPER).statement
    if used["property"] != "norm":
        _holder_lower_by_radius(c, used)
        return
    require(used["level"] == level, "it uses norm with another level")
    k = c.use("sum-rules", mask=used["mask"], order=used["nu"]).statement["order"]
    scaled = used["norm"] / power(c, Fraction(c.p), (k - 1) * level)
    require(c.statement["norm"] == scaled, "the norm of D^L is another")
    use_reductions(c, used["mask"])


def _holder_lower_by_radius(c: Claim, used: Statement) -> None:
    level, x = c.statement["level"], c.statement["norm"]
    require((used["length"], bound_of(used)) == (level, x), "the radius has another length or bound")
    require(x > 0, "the bound is not positive")
    family = c.use("family", family=used["family"]).statement
    c.use("sum-rules", mask=family["mask"], order=family["nu"])
    use_reductions(c, family["mask"])


def holder_upper(c: Claim) -> None:
    """α <= -log_p(x)/ℓ: φ is stable, possibly reduced; x is the radius of a product of length ℓ, or p^-k and ℓ = 1."""
    c.count(1)
    mask = c.use("stable", holds=True).statement["mask"]
    used = c.use("product", "sum-rules", mask=mask).statement
    if used["property"] == "product":
        bound = (len(used["word"]), used["radius"])
    else:
        bound = (1, 1 / power(c, Fraction(c.p), used["order"]))
    require(bound == (c.statement["length"], c.statement["radius"]), "length or radius is another")
    use_reductions(c, mask)


def holder_exact(c: Claim) -> None:
    """α = -log_p(x)/L: bounded by x and L from below, and from above by y and ℓ with y^L >= x^ℓ."""
    level, x = c.statement["level"], c.statement["norm"]
    c.count(1)
    c.use("holder-lower", level=level, norm=x)
    upper = c.use("holder-upper").statement
    fits = power(c, upper["radius"], level) >= power(c, x, upper["length"])
    require(fits, "the bounds do not meet")


def contracts(c: Claim, norm: Statement, nu: int) -> None:
    """Check that (1/p)S_ν contracts, from ‖S_(Δ^ν')^L‖ < p^(-(ν-1)L), ν' >= ν; the norm is of p^((ν'-1)L) S_(Δ^ν')^L.

    The joint spectral radius of S_(Δ^ν) is the largest of p^-ν, …, p^(1-ν') and that of S_(Δ^ν').
    """
    require(norm["nu"] >= nu, f"the norm is not one of S_{nu} or a later one")
    bound = power(c, Fraction(c.p), (norm["nu"] - nu) * norm["level"])
    require(norm["norm"] < bound, "the norm is not small enough")


def power(c: Claim, x: Fraction, exponent: int) -> Fraction:
    """The power x^exponent, whose work is counted."""
    c.count(1, (x.numerator.bit_length() + x.denominator.bit_length()) * exponent)
    return Fraction(x**exponent)
