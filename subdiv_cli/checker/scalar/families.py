"""Rules on joint spectral radii of a scalar mask: the families of S_(Δ^ν), and the Hölder exponent α by their radius.

φ, p, k, q, D as in `symbols` and `conclusions`. Attained: with n the largest integer below α, n >= 0, the n-th
derivative of φ has the Hölder exponent α - n itself.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.polynomials import (
    Polynomial,
    count_zeros,
    greatest_common_divisor,
    multiply,
    on_circle,
    polynomial,
    remainder,
    times_sigma,
    value,
)
from subdiv_cli.checker.reading import MAX_ORDER, Rejected, require
from subdiv_cli.checker.roots import fraction_bits, isolated_root, root_of
from subdiv_cli.checker.scalar.masks import symbol_of, use_reductions


def transition(c: Claim) -> None:
    """The new family is that of the transition matrices of S_(Δ^ν), symbol σ^(k-ν) q = a/σ^ν.

    Raises Rejected where the sum rules have no quotient.
    """
    nu, p = c.statement["nu"], c.p
    symbol_of(c)
    used = c.use("sum-rules", mask=c.statement["mask"])
    k, q = used.statement["order"], used.result
    require(1 <= nu <= k, f"the sum rules are of order {k}")
    if q is None:
        raise Rejected("there is no quotient")
    degree = q.length - 1 + (k - nu) * (p - 1)
    order = max(1, -(-degree // (p - 1)))
    require(order <= MAX_ORDER, f"the matrices are of order {order}")
    c.count(p * order**2 + order * (k - nu + 1) * p, q.bits)
    d = times_sigma(q, p, k - nu)
    first = d.start + (p - 1) * (order - 1)
    sections = [matrices.section(d, p, first + epsilon, order) for epsilon in range(p)]
    c.introduce(c.statement["family"], RationalFamily(sections, d.denominator))


def positive_symbol(c: Claim) -> None:
    """JSR = ρ(C) = ρ(G) = Λ, C[i][j] the coefficient of z^(i-pj) in q_c(z) = z^-h q(z) >= 0 on |z| = 1.

    Π_(j<L) q_c(z^(p^j)) >= 0 there, so its coefficient at 0, (C^L)_00, is its largest, and ‖D^L‖∞ is at most a constant
    times it; the rows of C^L are rows of D^L. G is C on symmetric sequences, so (C^L)_00 = (G^L)_00 and ρ(G) <= ρ(C).
    Σ (G^L)_00 x^L has coefficients >= 0, so by Pringsheim's theorem its first pole, 1/ρ(G), is positive, and ρ(G) is
    the largest real root of f = det(z - G). Where all its roots of modulus Λ are simple, G^L is at most a constant
    times Λ^L. Raises Rejected where the sum rules have no quotient, or the length is not 1.
    """
    m, low, _ = isolated_root(c)
    family = c.use("family", family=c.statement["family"]).statement
    used = c.use("sum-rules", mask=family["mask"], order=family["nu"])
    q, p = used.result, c.p
    if q is None or c.statement["length"] != 1:
        raise Rejected("there is no quotient, or the length is not 1")
    require(q.length % 2 == 1, "the symbol is not of even degree")
    require(q.numerators == q.numerators[::-1], "the symbol is not its own reverse")
    h = q.length // 2
    order = h // (p - 1) + 1
    c.count(h**3 + order**4 + order**3, (order.bit_length() + 2) * q.bits)
    _positive_on_circle(c, q, h)
    on_symmetric = matrices.symmetric_section(q.numerators[h:], p, order)
    f = [x * q.denominator**k for k, x in enumerate(matrices.characteristic_polynomial(on_symmetric))]
    bits = max(map(abs, f)).bit_length() + max(map(abs, m)).bit_length()
    c.spend(order**3, order * bits + order * fraction_bits(low))
    require(not remainder(f, m), "the root's polynomial does not divide the characteristic one")
    beyond = 2 + max(abs(x) // f[-1] for x in f)  # Cauchy: no root is as large
    require(count_zeros(f, low, beyond) == 1, "the root is not the largest real one")
    if c.statement["property"] == "bounded":
        multiple = greatest_common_divisor(f, [k * x for k, x in enumerate(f)][1:])
        require(matrices.roots_lie_inside(multiple, low), "a root that may be as large is not simple")


def _positive_on_circle(c: Claim, q: Polynomial, h: int) -> None:
    """Check that q_c(z) = H(z + 1/z) with H(y) = (y+2)^e s(y)² r(y), r > 0 on [-2, 2]."""
    s, r, e = c.witness["squares"], c.witness["rest"], c.witness["power"]
    require(min(s.start, r.start) >= 0, "a factor has negative powers")
    require(s.length <= h + 1 and r.length <= h + 1, "a factor is of too high a degree")
    require(e <= h, "the power is too large")
    c.spend(h**3, q.bits + 2 * s.bits + r.bits)
    product = multiply(multiply(s, s), r)
    for _ in range(e):
        product = multiply(product, polynomial(0, [2, 1], 1))
    require(product == polynomial(0, on_circle(q.numerators), q.denominator), "the factors have another product")
    rest = [0] * r.start + list(r.numerators)
    c.spend(h**3, h * r.bits)
    require(value(rest, 2) > 0 and count_zeros(rest, -2, 2) == 0, "the rest is not positive")


def holder_root(c: Claim) -> None:
    """α = -log_p(Λ)/ℓ: JSR(D)^ℓ = Λ, and φ is stable, possibly reduced."""
    c.count(1)
    root = {key: c.statement[key] for key in ("length", "polynomial", "low", "high")}
    used = c.use("radius", "bounded", **root).statement
    family = c.use("family", family=used["family"]).statement
    c.use("sum-rules", mask=family["mask"], order=family["nu"])
    c.use("stable", mask=family["mask"], holds=True)
    use_reductions(c, family["mask"])


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
    use_reductions(c, family["mask"])
    nu, length = family["nu"], bounded["length"]
    if integer:
        exponent = _power(c, Fraction(1, c.p), nu)
        require(_is_exponent(c, used, exponent), "the exponent is not ν")
        require(root_of(bounded).rational == _power(c, exponent, length), "the radius is not p^-ν")
    else:
        require(nu == k, "the differences are not of the order of the sum rules")
        require(_between_integers(c, bounded["low"], bounded["high"], length, k), "the exponent may be an integer")


def attained_norm(c: Claim) -> None:
    """p^(αL) ‖S_(Δ^ν)^L‖ is bounded, by one norm: α = ν and ‖((1/p)S_ν)^L‖∞ <= p^-L, or ‖D^L‖∞ = p^(-αL)."""
    c.count(1)
    norm = c.use("norm").statement
    used = c.use("holder", "holder-root").statement
    k = c.use("sum-rules", mask=norm["mask"]).statement["order"]
    use_reductions(c, norm["mask"])
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
    use_reductions(c, family["mask"])
    value, length = defective["value"], defective["length"]
    x, level = _rational_exponent(used)
    require(_power(c, value, level) == _power(c, x, length), "the value is not that of the exponent")
    require(x < 1, "the exponent is not positive")
    require(_power(c, Fraction(1, c.p), family["nu"] * level) <= x, "the exponent is larger than ν")


def _rational_exponent(holder: Statement) -> tuple[Fraction, int]:
    """The numbers x and L of α = -log_p(x)/L."""
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
