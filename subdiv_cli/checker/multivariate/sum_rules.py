"""Coset sums, sum rules of total degree, and what S does to polynomials: masks on Z^s. See FORMAT.md.

a is the mask, M the dilation, m = |det M|, t the number of terms.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import product
from math import comb, factorial, prod

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.multivariate.lattice import Index, monomials, over_one, power
from subdiv_cli.checker.multivariate.masks import SparseMask, mask_of
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import fraction_bits

INDEX_BITS = 21
"""The bits of an index and its sign."""
POWER_BITS = 42
"""The bits of a coordinate of M j - δ with its sign, and of a binomial coefficient, for each degree."""


def coset_sums(c: Claim) -> None:
    """Whether Σ_β a_(γ+Mβ) = 1 for every γ."""
    a = mask_of(c)
    c.count(len(a.terms) + a.dilation.cosets, a.bits)
    holds = all(sum(value for _, value in group) == a.denominator for group in a.by_coset())
    require(holds == c.statement["holds"], "the coset sums are " + ("all 1" if holds else "not all 1"))


def total_sum_rules(c: Claim) -> None:
    """Σ_β a_(γ+Mβ) (γ+Mβ)^μ is the same for all γ, |μ| < k, and 1 for μ = 0; that is not so for k + 1."""
    a, k = mask_of(c), c.statement["order"]
    s = a.dilation.dimension
    c.count((len(a.terms) + a.dilation.cosets) * comb(k + s, s), a.bits + INDEX_BITS * k)
    known: list[dict[Index, dict[Index, int]]] = [{(): dict(group)} for group in a.by_coset()]

    def holds(mu: Index) -> bool:
        sums = {_folded(sums, mu).get((), 0) for sums in known}
        return len(sums) == 1 and (any(mu) or sums == {a.denominator})

    for degree in range(k):
        for mu in monomials(s, degree):
            require(holds(mu), f"the sum rules fail for the monomial {mu}")
    require(not all(holds(mu) for mu in monomials(s, k)), "the sum rules hold of a higher order")


def _folded(known: dict[Index, dict[Index, int]], mu: Index) -> dict[Index, int]:
    """The sums Σ x_α α^μ over the last variables, as many as μ has, by the indices in the others; known ones once."""
    if mu not in known:
        known[mu] = folded = dict[Index, int]()
        for (*others, last), value in _folded(known, mu[1:]).items():
            folded[tuple(others)] = folded.get(tuple(others), 0) + value * last ** mu[0]
    return known[mu]


def generation(c: Claim) -> None:
    """S maps the polynomials of degree k - 1 to such, and those of degree k not to polynomials."""
    k = c.use("total-sum-rules").statement["order"]
    c.count(1)
    require(c.statement["degree"] == k - 1, f"the sum rules are of order {k}")


def reproduction(c: Claim) -> None:
    """The largest r with sum rules of order r + 1 and Σ a_α α^μ = m τ^μ for |μ| <= r; then τ = (1/m) Σ a_α α."""
    a, r = mask_of(c), c.statement["degree"]
    k = c.use("total-sum-rules").statement["order"]
    require(0 <= r < k, f"the sum rules are of order {k}")
    s, last = a.dilation.dimension, min(r + 1, k - 1)
    c.count(len(a.terms) * comb(last + s, s), a.bits * (last + 1) + INDEX_BITS * last)
    total = a.dilation.cosets * a.denominator
    tau = [_moment(a, mu) for mu in monomials(s, 1)][::-1]

    def holds(mu: Index) -> bool:
        return bool(_moment(a, mu) * total ** (sum(mu) - 1) == power(tau, mu))

    for degree in range(1, r + 1):
        for mu in monomials(s, degree):
            require(holds(mu), f"the polynomials of degree {degree} are not reproduced")
    require(r == k - 1 or not all(holds(mu) for mu in monomials(s, r + 1)), "a higher degree is reproduced")


def _moment(a: SparseMask, mu: Index) -> int:
    """The numerator of Σ a_α α^μ."""
    return sum(value * power(index, mu) for index, value in a.terms.items())


def quasi_interpolation(c: Claim) -> None:
    """S^∞ Q f = f for all f ∈ π_d, with Q f = Σ q_μ D^μ f, and Q f(α) = Σ_j t_j f(α+j) on π_d.

    The stencil is the operator: Σ_j t_j j^μ = μ! q_μ, q_0 = 1. With g = f(M^-1 ·), by the sum rules of order > d,
    (S Q f)(α) = (1/m) Σ_δ Σ_j a_δ t_j g(α + Mj - δ), which is (Q g)(α) iff Σ_δ Σ_j a_δ t_j (Mj-δ)^μ = m Σ_j t_j j^μ.
    """
    a, d = mask_of(c), c.statement["degree"]
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
        moment = q.get(mu, Fraction(0)) * prod(map(factorial, mu))
        require(Fraction(own[mu], denominator) == moment, f"the stencil is not the operator at {mu}")
    moved = _moments(((a.dilation.image(j), x) for j, x in t.items()), powers)
    mask = _moments(((tuple(-i for i in delta), x) for delta, x in a.terms.items()), powers)
    total = a.dilation.cosets * a.denominator
    for mu in powers:
        require(_of_product(moved, mask, mu) == total * own[mu], f"S Q is not Q after the dilation at {mu}")


def _moments(terms: Iterable[tuple[Index, int]], powers: Iterable[Index]) -> dict[Index, int]:
    """The moments Σ_j x_j j^μ for each μ."""
    kept = list(terms)
    return {mu: sum(x * power(j, mu) for j, x in kept) for mu in powers}


def _of_product(f: Mapping[Index, int], g: Mapping[Index, int], mu: Index) -> int:
    """The moment Σ_i Σ_j x_i y_j (i + j)^μ, by the moments of x and of y."""
    total = 0
    for nu in product(*(range(i + 1) for i in mu)):
        rest = tuple(i - j for i, j in zip(mu, nu, strict=True))
        total += prod(map(comb, mu, nu)) * f[nu] * g[rest]
    return total
