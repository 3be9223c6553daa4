"""The rule on the operator Q that inverts S^∞ on polynomials in several variables. See MULTIVARIATE.md."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import product
from math import comb, factorial, prod

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.lattice import Index, monomials, over_one, power
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import fraction_bits

POWER_BITS = 33
"""Of a coordinate of M j - δ with its sign, and of a binomial coefficient, for each degree."""


def surface_quasi_interpolation(c: Claim) -> None:
    """S^∞ Q f = f for all f ∈ π_d, with Q f = Σ q_μ D^μ f, and Q f(α) = Σ_j t_j f(α+j) on π_d.

    The stencil is the operator: Σ_j t_j j^μ = μ! q_μ, q_0 = 1. With g = f(M^-1 ·), by the sum rules of order > d,
    (S Q f)(α) = (1/m) Σ_δ Σ_j a_δ t_j g(α + Mj - δ), which is (Q g)(α) iff Σ_δ Σ_j a_δ t_j (Mj-δ)^μ = m Σ_j t_j j^μ.
    """
    a, d = c.lattice(), c.statement["degree"]
    pairs, weights = c.statement["operator"], c.statement["stencil"]
    c.use("convergent", holds=True)
    k = c.use("total-sum-rules").statement["order"]
    require(d < k, f"the sum rules are of order {k}")
    s = a.dilation.dimension
    require(all(len(j) == s for j, _ in (*pairs, *weights)), f"an index is not one of Z^{s}")
    require(all(min(mu) >= 0 and sum(mu) <= d for mu, _ in pairs), f"a derivative is not one of order 0, …, {d}")
    n, bits = comb(d + s, s), max(fraction_bits(x) for _, x in (*pairs, *weights))
    t, denominator = over_one(weights)
    bits += a.bits + denominator.bit_length() + POWER_BITS * (d + 1)
    c.count((len(a.terms) + 2 * len(t)) * n + n * n, bits)
    powers = [mu for degree in range(d + 1) for mu in monomials(s, degree)]
    q = dict(pairs)
    require(q.get((0,) * s) == 1, "the operator does not begin with f")
    own = _moments(t.items(), powers)
    for mu in powers:
        asked = q.get(mu, Fraction(0)) * prod(map(factorial, mu))
        require(Fraction(own[mu], denominator) == asked, f"the stencil is not the operator at {mu}")
    moved = _moments(((a.dilation.image(j), x) for j, x in t.items()), powers)
    mask = _moments(((tuple(-i for i in delta), x) for delta, x in a.terms.items()), powers)
    total = a.dilation.cosets * a.denominator
    for mu in powers:
        require(_of_product(moved, mask, mu) == total * own[mu], f"S Q is not Q after the dilation at {mu}")


def _moments(terms: Iterable[tuple[Index, int]], powers: Iterable[Index]) -> dict[Index, int]:
    """Σ_j x_j j^μ for each μ."""
    kept = list(terms)
    return {mu: sum(x * power(j, mu) for j, x in kept) for mu in powers}


def _of_product(f: Mapping[Index, int], g: Mapping[Index, int], mu: Index) -> int:
    """Σ_i Σ_j x_i y_j (i + j)^μ, by the moments of x and of y."""
    total = 0
    for nu in product(*(range(i + 1) for i in mu)):
        rest = tuple(i - j for i, j in zip(mu, nu, strict=True))
        total += prod(map(comb, mu, nu)) * f[nu] * g[rest]
    return total
