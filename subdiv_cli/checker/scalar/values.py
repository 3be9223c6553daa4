"""The rules on φ at the integers, and on the operator Q that inverts S^∞ on polynomials. See FORMAT.md."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.polynomials import Polynomial, components, multiply, times
from subdiv_cli.checker.reading import require, require_few
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.scalar.conclusions import contraction
from subdiv_cli.checker.scalar.masks import symbols_of, use_reductions

MAX_ORDER = 200
"""The highest order of a derivative, and power of an index."""


def values(c: Claim) -> None:
    """φ^(j)(i) = h_i for all integers i.

    For a mask whose S_j converges: φ^(j) = Σ_k a_k p^j φ^(j)(p·-k) gives h_i = p^j Σ_k a_(pi-k) h_k, and the w_β =
    h_(-β) are a functional with <w, S f> = p^-j <w, f>. Where Σ h_i (-i)^l is 0 for l < j and j! for l = j, <w, f> =
    <v, Δ^j f> with Σ v = 1 and <v, S_j g> = <v, g>, so <v, g> = S_j^∞ g(0). For mask 0 through the reductions:
    φ = Σ_l g_l φ'(·-l)/g(1).
    """
    j, p = c.statement["order"], c.p
    h: Polynomial = c.statement["values"]
    own: Polynomial = c.witness.get("values", h)
    mask = contraction(c, j)
    factors = use_reductions(c, mask)
    a = symbols_of(c)[mask]
    require_few(j <= MAX_ORDER, "the order is too large")
    require(0 < own.length <= a.length, "there are too many values, or none")
    index = max(abs(own.start), abs(own.start + own.length)).bit_length()
    work = a.length * own.length + (j + 1) * own.length + (a.length + h.length) ** 2
    c.count(work, a.bits + own.bits + j * (index + p.bit_length()))
    require(
        components(multiply(a, own), p)[0] == times(own, 1, p**j), "the values do not satisfy the refinement equation"
    )
    for power in range(j + 1):
        moment = sum(x * (-i) ** power for i, x in enumerate(own.numerators, own.start))
        expected = factorial(j) * own.denominator if power == j else 0
        require(moment == expected, f"their moment of order {power} is another")
    for g in factors:
        require(own.length + g.length <= a.length + h.length, "the values and the factors do not fit")
        c.count(work, own.bits + g.bits)
        total = sum(g.numerators)
        own = times(multiply(own, g), g.denominator if total > 0 else -g.denominator, abs(total))
    require(own == h, "the values are others")


def quasi_interpolation(c: Claim) -> None:
    """S^∞ Q f = f for all f ∈ π_m, with Q f = Σ q_i D^i f, and Q f(i) = Σ_j t_j f(i+j) on π_m.

    S maps π_m to itself, as the sum rules are of order m+1 at least, and S^∞ f = Σ m_i/i! D^i f there with the moments
    m_i = Σ_β φ(-β) β^i. So the power series Σ m_i/i! x^i and Σ q_i x^i must have the product 1 up to x^m.
    """
    m, q, t = c.statement["degree"], c.statement["operator"], c.statement["stencil"]
    c.use("convergent", holds=True)
    h: Polynomial = c.use("values", order=0).statement["values"]
    k = c.use("sum-rules", mask=0).statement["order"]
    require(m < k, f"the sum rules are of order {k}")
    require(len(q) == m + 1 <= MAX_ORDER, "there are not m + 1 coefficients, or too many")
    index = max(abs(h.start) + h.length, abs(t.start) + t.length).bit_length()
    bits = h.bits + t.bits + m * (index + m.bit_length()) + max(fraction_bits(x) for x in q)
    c.count((m + 2) * (h.length + t.length + m + 2), bits)
    moments = [
        Fraction(sum(x * (-i) ** l for i, x in enumerate(h.numerators, h.start)), h.denominator) for l in range(m + 1)
    ]
    for l in range(m + 1):
        product = sum((moments[l - i] / factorial(l - i) * q[i] for i in range(l + 1)), Fraction(0))
        require(product == (l == 0), f"the operator does not invert the moments at degree {l}")
        moment = Fraction(sum(x * i**l for i, x in enumerate(t.numerators, t.start)), t.denominator)
        require(moment == factorial(l) * q[l], f"the stencil is not the operator at degree {l}")
