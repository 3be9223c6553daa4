"""The rules that compute with a mask on Z^s: coset sums, sum rules of total degree. See MULTIVARIATE.md.

a is the mask, M the dilation, m = |det M|, t the number of terms.
"""

from __future__ import annotations

from math import comb

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.lattice import Index, LatticeMask, monomials, power
from subdiv_cli.checker.reading import require

INDEX_BITS = 15
"""Of an index and its sign."""


def coset_sums(c: Claim) -> None:
    """Whether Σ_β a_(γ+Mβ) = 1 for every γ."""
    a = c.lattice()
    c.count(len(a.terms) + a.dilation.cosets, a.bits)
    holds = all(sum(value for _, value in group) == a.denominator for group in a.by_coset())
    require(holds == c.statement["holds"], "the coset sums are " + ("all 1" if holds else "not all 1"))


def total_sum_rules(c: Claim) -> None:
    """Σ_β a_(γ+Mβ) (γ+Mβ)^μ is the same for all γ, |μ| < k, and 1 for μ = 0; that is not so for k + 1."""
    a, k = c.lattice(), c.statement["order"]
    s = a.dilation.dimension
    c.count((len(a.terms) + a.dilation.cosets) * comb(k + s, s), a.bits + INDEX_BITS * k)
    groups = a.by_coset()

    def holds(mu: Index) -> bool:
        sums = {sum(value * power(index, mu) for index, value in group) for group in groups}
        return len(sums) == 1 and (any(mu) or sums == {a.denominator})

    for degree in range(k):
        for mu in monomials(s, degree):
            require(holds(mu), f"the sum rules fail for the monomial {mu}")
    require(not all(holds(mu) for mu in monomials(s, k)), "the sum rules hold of a higher order")


def generation(c: Claim) -> None:
    """S maps the polynomials of degree k - 1 to such, and those of degree k not to polynomials."""
    k = c.use("total-sum-rules").statement["order"]
    c.count(1)
    require(c.statement["degree"] == k - 1, f"the sum rules are of order {k}")


def reproduction(c: Claim) -> None:
    """The largest r with sum rules of order r + 1 and Σ a_α α^μ = m τ^μ for |μ| <= r; then τ = (1/m) Σ a_α α."""
    a, r = c.lattice(), c.statement["degree"]
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


def _moment(a: LatticeMask, mu: Index) -> int:
    """The numerator of Σ a_α α^μ."""
    return sum(value * power(index, mu) for index, value in a.terms.items())


def interpolatory_stable(c: Claim) -> None:
    """a_0 = 1 and a_(Mα) = 0 otherwise, and S converges: φ(α) = δ_α, so |c_α| <= ‖Σ c_β φ(· - β)‖∞."""
    a = c.lattice()
    c.count(len(a.terms), a.bits)
    c.use("convergent", holds=True)
    zero = (0,) * a.dilation.dimension
    require(a.terms.get(zero) == a.denominator, "a_0 is not 1")
    others = (index for index in a.terms if index != zero and not any(a.dilation.residue(index)))
    require(next(others, None) is None, "another coefficient at an index in M Z^s is not zero")
