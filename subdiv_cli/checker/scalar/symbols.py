"""The rules that compute with a scalar mask, one function each: its docstring is what it proves. See FORMAT.md.

a is the symbol of the mask in question, p the arity, σ(z) = 1 + z + … + z^(p-1), k the order of the sum rules,
q = a/σ^k, and n the degree of a.
"""

from __future__ import annotations

from fractions import Fraction
from math import gcd, isqrt

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.polynomials import (
    Polynomial,
    add,
    classes,
    components,
    divides,
    is_cycle,
    iterated_norm,
    multiply,
    polynomial,
    sigma_divides,
    slot_bits,
    spread,
    times,
    times_sigma,
    totients,
    vanishes_on_circle,
)
from subdiv_cli.checker.reading import Rejected, require, require_few
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.scalar.masks import symbol_of, symbols_of

MAX_LEVEL = 64
"""The highest level of a norm: a longer iterated symbol is too long anyway, unless the symbol is constant."""
MAX_PRODUCT = 5_000_000
"""The most coefficients of an iterated symbol."""
MAX_PACKED = 1 << 30
"""The most bits of all of them together."""


def residue_sums(c: Claim) -> None:
    """s_γ = Σ_β a_(γ+pβ), γ = 0, …, p-1."""
    a = symbol_of(c)
    c.count(a.length, a.bits)
    sums = tuple(Fraction(sum(numerators), a.denominator) for numerators in classes(a, c.p))
    require(c.statement["sums"] == sums, "the residue sums are others")


def sum_rules(c: Claim) -> Polynomial:
    """Sum rules of order k and no higher: a(1) = p, a = σ^k q, σ does not divide q; k = 0 where one of these fails."""
    a, q, k, p = symbol_of(c), c.witness["quotient"], c.statement["order"], c.p
    c.count(a.length * (k + 1) * p, a.bits + q.bits)
    require(q.length + k * (p - 1) == a.length, "mask and quotient do not differ by so many factors")
    require(times_sigma(q, p, k) == a, "the mask is not the quotient times so many factors 1 + … + z^(p-1)")
    if k:
        require(a.sum_is(p), "a(1) is not the arity")
    require(not (a.sum_is(p) and sigma_divides(q, p)), "the sum rules hold of a higher order")
    return Polynomial(*q)


def derived(c: Claim) -> None:
    """S_ν exists and has the symbol s = p^ν z^((p-1)ν) a/σ^ν."""
    a, nu, s, p = symbol_of(c), c.statement["nu"], c.statement["symbol"], c.p
    _order_at_least(c, nu)
    c.count(a.length * (nu + 1) * p, a.bits + s.bits)
    require(s.length + nu * (p - 1) == a.length, "mask and symbol do not differ by so many factors")
    require(times_sigma(s, p, nu) == times(a, p**nu, shift=(p - 1) * nu), "the symbol is another")


def generation(c: Claim) -> None:
    """S generates the polynomials of degree k-1 and no higher."""
    k = c.use("sum-rules", mask=0).statement["order"]
    c.count(1)
    require(c.statement["degree"] == k - 1, f"the sum rules are of order {k}")


def reproduction(c: Claim) -> None:
    """π_r is reproduced with shift τ = a'(1)/p, π_(r+1) is not: δ_0 = … = δ_r = 0, and r = k-1 or δ_(r+1) ≠ 0."""
    a, r, p = symbol_of(c), c.statement["degree"], c.p
    k = c.use("sum-rules", mask=0).statement["order"]
    require(-1 <= r < k, f"the sum rules are of order {k}")
    c.count(a.length * (r + 2) ** 2, a.bits + 22 * (r + 2))
    shift = Fraction(sum(x * i for i, x in enumerate(a.numerators, a.start)), p * a.denominator)
    falling, product = list(a.numerators), Fraction(p)
    for j in range(min(r + 2, k)):
        exact = Fraction(sum(falling), a.denominator) == product
        require(exact == (j <= r), f"a^({j})(1) is " + ("what" if exact else "not what") + f" degree {j} asks for")
        falling = [x * (i - j) for i, x in enumerate(falling, a.start)]
        product *= shift - j


def norm(c: Claim) -> None:
    """‖((1/p)S_ν)^L‖∞ = x, the largest absolute class sum mod p^L of Π_(j<L) c(z^(p^j)), c = p^(ν-1) a/σ^ν."""
    nu, level, p = c.statement["nu"], c.statement["level"], c.p
    q, k = _order_at_least(c, nu)
    require(1 <= level <= MAX_LEVEL, f"the level is not one of 1, …, {MAX_LEVEL}")
    degree = q.length - 1 + (k - nu) * (p - 1)
    length = degree * (p**level - 1) // (p - 1) + 1
    c.count((degree + 1) * length)
    require_few(length <= MAX_PRODUCT, "the iterated symbol is too long")
    symbol = times(times_sigma(q, p, k - nu), p ** (nu - 1))
    width = slot_bits(symbol, level)
    c.count((degree + 1) * length // 64, max(width, symbol.bits * level))
    require_few(length * width <= MAX_PACKED, "the numbers are too long")
    largest = Fraction(iterated_norm(symbol, p, level), symbol.denominator**level)
    require(c.statement["norm"] == largest, "the norm is another")


def product(c: Claim) -> None:
    """The product of the word's transition matrices of D has an eigenvalue |λ| >= x."""
    word, radius, p = c.statement["word"], c.statement["radius"], c.p
    q, _ = _order_at_least(c, 1)
    require(len(word) > 0 and max(word) < p, "a letter is not one of 0, …, p-1, or there is none")
    require(radius > 0, "the radius is not positive")
    order = max(1, -(-(q.length - 1) // (p - 1)))
    bits = len(word) * (q.bits + order.bit_length()) + fraction_bits(radius)
    c.count(len(word) * order**3 + order**4, (isqrt(order) + 1) * bits)  # numbers of the product times longer ones
    c.spend(4 * order**2, 2 * order * bits)
    first = q.start + (p - 1) * (order - 1)
    family = {epsilon: matrices.section(q, p, first + epsilon, order) for epsilon in set(word)}
    total = family[word[0]]
    for epsilon in word[1:]:
        total = matrices.multiply(family[epsilon], total)
    f = matrices.characteristic_polynomial(total)
    inside = matrices.roots_lie_inside(f, radius * q.denominator ** len(word))
    require(not inside, "all eigenvalues of the product are smaller")


def eigen_condition(c: Claim) -> None:
    """Whether each A_ε has the simple eigenvalues 1, 1/p, …, 1/p^ν and all its others in |z| < p^-ν."""
    a, nu, p = symbol_of(c), c.statement["nu"], c.p
    q, k = _order_at_least(c, nu + 1)
    first, last = (p - 1 - (a.start + a.length - 1)) // (p - 1), -(a.start // (p - 1))
    order = max(0, last - first + 1 - k)
    c.count(p * order**4, 2 * order * (q.bits + order.bit_length() + nu * p.bit_length()))
    d, radius = times(q, 1, shift=(p - 1) * k), Fraction(q.denominator, p**nu)
    holds = last - first + 1 > nu and all(
        matrices.roots_lie_inside(
            matrices.characteristic_polynomial(matrices.section(d, p, epsilon - (p - 1) * first, order)), radius
        )
        for epsilon in range(p)
    )
    require(holds == c.statement["holds"], f"the condition {'holds' if holds else 'fails'}")


def independent(c: Claim) -> None:
    """The translates of φ are linearly independent: Σ_r u_r a_r = 1, and a has no cycle."""
    a = symbol_of(c)
    c.count(20 * a.length**2, a.bits + _most_bits(c.witness["cofactors"]))
    require(a.sum_is(c.p), "a(1) is not the arity")
    require(_combination(c) == polynomial(0, [1], 1), "the components do not combine to 1")
    _no_cycle(a, c.p)


def dependent(c: Claim) -> None:
    """The translates of φ are not linearly independent: the components have a common factor, or a has a cycle."""
    a = symbol_of(c)
    c.count(a.length**2, a.bits)
    require(a.sum_is(c.p), "a(1) is not the arity")
    if "cycle" in c.witness:
        _has_cycle(a, c.witness["cycle"], c.p)
    else:
        _common_factor(c)


def stable(c: Claim) -> None:
    """The translates of φ are stable: independent, or Σ_r u_r a_r = g without zeros on |z| = 1, and a has no cycle."""
    a = symbol_of(c)
    if "gcd" not in c.witness:
        c.use("independent", mask=c.statement["mask"], holds=True)
        c.count(1)
        return
    g = c.witness["gcd"]
    c.count(20 * a.length**2 + a.length**3, a.bits + g.bits + _most_bits(c.witness["cofactors"]))
    require(a.sum_is(c.p), "a(1) is not the arity")
    require(0 < g.length <= a.length, "the common factor is zero or too long")
    require(_combination(c) == g, "the components do not combine to the common factor")
    c.count(g.length**3, g.length * g.bits)
    require(not vanishes_on_circle(g), "the common factor vanishes somewhere on |z| = 1")
    _no_cycle(a, c.p)


def unstable(c: Claim) -> None:
    """The translates of φ are not stable: a common factor of the components vanishes on |z| = 1, or a has a cycle."""
    a = symbol_of(c)
    c.count(a.length**3, a.bits)
    require(a.sum_is(c.p), "a(1) is not the arity")
    if "cycle" in c.witness:
        _has_cycle(a, c.witness["cycle"], c.p)
    else:
        factor = _common_factor(c)
        c.count(factor.length**3, factor.length * factor.bits)
        require(vanishes_on_circle(factor), "the factor vanishes nowhere on |z| = 1")


def reduction(c: Claim) -> Polynomial:
    """φ = Σ g_j φ'(·-j)/g(1), equally smooth, φ' that of a new mask a0 with a0(z) g(z^p) = a(z) g(z), g(1) ≠ 0."""
    a, g, a0 = symbol_of(c), c.witness["factor"], c.witness["mask"]
    c.count(a.length**2, a.bits + g.bits + a0.bits)
    require(c.statement["to"] == len(symbols_of(c)), f"the next mask is number {len(symbols_of(c))}")
    require(a.sum_is(c.p), "a(1) is not the arity")
    require(sum(g.numerators) != 0, "the factor vanishes at 1")
    require(a0.length > 0 and a0.length + (c.p - 1) * (g.length - 1) == a.length, "the degrees do not fit")
    require(multiply(a0, spread(g, c.p)) == multiply(a, g), "the factors do not divide out to the new mask")
    symbols_of(c).append(a0)
    return Polynomial(*g)


def _order_at_least(c: Claim, order: int) -> tuple[Polynomial, int]:
    """The pair (q, k) from the sum-rules claim that is used next; k >= order >= 1."""
    symbol_of(c)
    used = c.use("sum-rules", mask=c.statement.get("mask", 0))
    k = used.statement["order"]
    require(1 <= order <= k, f"the sum rules are of order {k}")
    if used.result is None:
        raise Rejected("there is no quotient")
    return used.result, k


def _combination(c: Claim) -> Polynomial:
    """The combination Σ_r u_r a_r of the polyphase components with the witness's cofactors."""
    a, cofactors = symbol_of(c), c.witness["cofactors"]
    require(len(cofactors) == c.p, "there are not p cofactors")
    require(all(u.length <= 2 * a.length for u in cofactors), "a cofactor is too long")
    total = polynomial(0, [], 1)
    for u, component in zip(cofactors, components(a, c.p), strict=True):
        product = multiply(u, component)
        require(abs(product.start) <= 4 * a.length, "a cofactor stands too far off")
        total = add(total, product)
    return total


def _common_factor(c: Claim) -> Polynomial:
    """The witness's factor, of degree >= 1, which divides all components."""
    a, factor = symbol_of(c), Polynomial(*c.witness["factor"])
    require(2 <= factor.length <= a.length, "the factor is constant or too long")
    c.count(a.length**2, a.bits + a.length * factor.bits)
    require(divides(factor, components(a, c.p)), "the factor does not divide all components")
    return factor


def _has_cycle(a: Polynomial, n: int, p: int) -> None:
    require(n > 1 and gcd(n, p) == 1, "n is not above 1 and coprime to p")
    require(n <= 10 * ((a.length - 1) // (p - 1)), "n is too large")
    require(is_cycle(a, n, p), f"there is no cycle of {n}-th roots of unity")


def _no_cycle(a: Polynomial, p: int) -> None:
    """Check that a has no cycle of any order n.

    The factor of a cycle has degree (p-1)φ(n), and φ(n) >= n/10 for all n below the product of the primes to 250.
    """
    most = (a.length - 1) // (p - 1)
    for n, totient in enumerate(totients(10 * most)):
        if n > 1 and totient <= most and gcd(n, p) == 1:
            require(not is_cycle(a, n, p), f"there is a cycle of {n}-th roots of unity")


def _most_bits(fs: tuple[Polynomial, ...]) -> int:
    return max((f.bits for f in fs), default=0)
