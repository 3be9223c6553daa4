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
    """S converges: some ‖S_(Δ^ν)^L‖∞ < 1 (Dyn 1992, Theorem 3.2, for ν = 1; FORMAT.md for larger ν), or JSR < 1.

    Or s > 1/2 and φ is stable: it is continuous then.
    """
    c.count(1)
    used = c.use("norm", "sobolev", *UPPER).statement
    if used["property"] == "norm":
        require(used["mask"] == 0, "it uses norm with another mask")
        contracts(c, used, 1)
    elif used["property"] == "sobolev":
        c.use("stable", mask=0, holds=True)
        require(c.p * used["high"] < 1, "the Sobolev exponent is not large enough")
    else:
        c.use("family", family=used["family"], mask=0)
        require(bound_of(used) < 1, "the radius is not small enough")


def diverges(c: Claim) -> None:
    """S diverges: a residue sum is not 1, a product has an eigenvalue |λ| >= 1, or an A_ε has one besides simple 1.

    Or φ is not continuous.
    """
    c.count(1)
    used = c.use("residue-sums", "product", "eigen-condition", "not-smooth").statement
    if used["property"] == "eigen-condition":
        require(used["nu"] == 0 and not used["holds"], "the eigen-condition for ν = 0 is not refuted")
        return
    if used["property"] == "not-smooth":
        require(used["order"] == 0, "φ may be continuous")
        return
    require(used["mask"] == 0, "it uses a claim on another mask")
    if used["property"] == "product":
        require(used["radius"] >= 1, "the radius is below 1")
    else:
        require(set(used["sums"]) != {1}, "the residue sums are 1")


def smooth(c: Claim) -> None:
    """φ is C^n: some ‖S_(Δ^ν)^L‖∞ < p^(-nL) or JSR(S_(Δ^ν)) < p^-n, ν > n, for the mask or one that it reduces to.

    Or s > n + 1/2.
    """
    n = c.statement["order"]
    c.count(1)
    used = c.use("norm", "sobolev", *UPPER).statement
    if used["property"] == "sobolev":
        require(c.p * used["high"] * power(c, Fraction(c.p), 2 * n) < 1, "the Sobolev exponent is not large enough")
    else:
        use_reductions(c, _contracting(c, used, n))


def contraction(c: Claim, n: int) -> int:
    """The mask whose (1/p)S_(n+1) contracts, by the norm or by the radius that is used next: its S_n converges."""
    return _contracting(c, c.use("norm", *UPPER).statement, n)


def _contracting(c: Claim, used: Statement, n: int) -> int:
    if used["property"] == "norm":
        contracts(c, used, n + 1)
        return int(used["mask"])
    family = c.use("family", family=used["family"]).statement
    require(family["nu"] > n, f"the family is not one of S_(Δ^{n + 1}) or a later one")
    small = bound_of(used) * power(c, Fraction(c.p), n * used["length"]) < 1
    require(small, "the radius is not small enough")
    return int(family["mask"])


def not_smooth(c: Claim) -> None:
    """φ is not C^j: stable, possibly reduced, with k <= j or an eigenvalue |λ| >= p^(-jℓ) of a product of length ℓ.

    Or s <= j, by a claim on s that needs a stable φ.
    """
    j = c.statement["order"]
    c.count(1)
    first = c.use("stable", "sobolev").statement
    if first["property"] == "sobolev":
        require(first["low"] * power(c, Fraction(c.p), 2 * j) >= 1, "the Sobolev exponent is too large")
        return
    require(first["holds"], "it uses stable with another holds")
    used = c.use("sum-rules", "product", mask=first["mask"]).statement
    if used["property"] == "sum-rules":
        require(used["order"] <= j, f"the sum rules are of order {used['order']}")
    else:
        require(used["radius"] * power(c, Fraction(c.p), j * len(used["word"])) >= 1, "the radius is too small")
    use_reductions(c, first["mask"])


def holder_lower(c: Claim) -> None:
    """α >= -log_p(x)/L: x = ‖S_(Δ^ν)^L‖∞ = ‖((1/p)S_ν)^L‖∞ / p^((ν-1)L), or JSR(S_(Δ^ν))^L <= x, 1 <= ν <= k.

    Or α >= s - 1/2: L = 2 and x = p λ.
    """
    c.count(1)
    used = c.use("norm", "sobolev", *UPPER).statement
    if used["property"] == "sobolev":
        _require_bound(c, "level", "norm", (2, c.p * used["high"]))
        return
    if used["property"] == "norm":
        scaled = used["norm"] / power(c, Fraction(c.p), (used["nu"] - 1) * used["level"])
        bound, of = (used["level"], scaled), used
    else:
        bound, of = (used["length"], bound_of(used)), c.use("family", family=used["family"]).statement
    require(of["nu"] >= 1, "it is not on differences")
    c.use("sum-rules", mask=of["mask"])
    _require_bound(c, "level", "norm", bound)
    use_reductions(c, of["mask"])


def _require_bound(c: Claim, length: str, bound: str, known: tuple[int, Fraction]) -> None:
    require(known == (c.statement[length], c.statement[bound]), f"{length} or {bound} is another")
    require(known[1] > 0, "the bound is not positive")


def holder_upper(c: Claim) -> None:
    """α <= -log_p(x)/ℓ: φ is stable, possibly reduced; x is the radius of a product of length ℓ, or p^-k and ℓ = 1.

    Or α <= s: ℓ = 2 and x = λ, of a claim on s that needs a stable φ.
    """
    c.count(1)
    first = c.use("stable", "sobolev").statement
    if first["property"] == "sobolev":
        _require_bound(c, "length", "radius", (2, first["low"]))
        return
    require(first["holds"], "it uses stable with another holds")
    used = c.use("product", "sum-rules", mask=first["mask"]).statement
    if used["property"] == "product":
        bound = (len(used["word"]), used["radius"])
    else:
        bound = (1, 1 / power(c, Fraction(c.p), used["order"]))
    _require_bound(c, "length", "radius", bound)
    use_reductions(c, first["mask"])


def sobolev_at_least(c: Claim) -> None:
    """s >= -log_p(x)/L, as α is not below it: s >= α."""
    c.count(1)
    used = c.use("holder-lower", "holder-root", "holder").statement
    known = (used["length"], used["high"]) if used["property"] == "holder-root" else (used["level"], used["norm"])
    _require_bound(c, "length", "bound", known)


def sobolev_at_most(c: Claim) -> None:
    """s <= -log_p(x)/L, for stable φ: α + 1/2 is not above it, or k is not, L = 1 and x = p^-k."""
    c.count(1)
    used = c.use("holder-upper", "holder-root", "holder", "stable").statement
    if used["property"] == "stable":
        require(used["holds"], "φ is not stable")
        order = c.use("sum-rules", mask=used["mask"]).statement["order"]
        _require_bound(c, "length", "bound", (1, 1 / power(c, Fraction(c.p), order)))
        use_reductions(c, used["mask"])
        return
    names = {"holder-upper": ("length", "radius"), "holder-root": ("length", "low"), "holder": ("level", "norm")}
    length, radius = (used[name] for name in names[used["property"]])
    _require_bound(c, "length", "bound", (2 * length, radius**2 / power(c, Fraction(c.p), length)))


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
