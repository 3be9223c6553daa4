"""The rule on the Sobolev exponent s of φ. See FORMAT.md.

q is the quotient of the sum-rules claim, n its degree, b(z) = q(z) q(1/z), and N_L = p^-L Σ_i |q^[L]_i|² with
q^[L](z) = Π_(j<L) q(z^(p^j)). For stable φ, s = -log_p(λ)/2 with λ = lim sup N_L^(1/L).
"""

from __future__ import annotations

from operator import mul

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.growth import count_growth, degree_of_annihilator, require_growth
from subdiv_cli.checker.matrices import Matrix
from subdiv_cli.checker.polynomials import Polynomial
from subdiv_cli.checker.reading import Rejected, require


def sobolev(c: Claim) -> None:
    """s = -log_p(λ)/2, λ the only zero of f in [x, y].

    N_L = (G^L e_0)_0 with G as in `_transfer`.
    """
    p = c.p
    mask = c.use("stable", holds=True).statement["mask"]
    q = c.use("sum-rules", mask=mask).result
    if q is None:
        raise Rejected("there is no quotient")
    require(c.masks[mask].length > q.length, "the sum rules are of order 0")
    c.use_reductions(mask)
    order = (q.length - 1) // (p - 1) + 1
    degree = degree_of_annihilator(c)
    require(degree <= order, "the polynomials are of higher degree than the matrix")
    step = 2 * q.bits + p.bit_length() + 2 * order.bit_length()
    count_growth(c, q.length**2 + 4 * order**3 + 20, order, step)
    matrix, first = _transfer(q, p, order), [1] + [0] * (order - 1)
    require_growth(c, lambda v: [sum(map(mul, row, v)) for row in matrix], first, p * q.denominator**2)


def _transfer(q: Polynomial, p: int, order: int) -> Matrix:
    """The numerators of G: b_(pi-j) + b_(pi+j) for j > 0, and b_(pi), over p times the denominator of b.

    That of f -> (1/p) Σ_j b_(pi-j) f_j on symmetric sequences over -(order-1), …, order-1, which it maps to such.
    """
    numerators = q.numerators
    b = [sum(map(mul, numerators, numerators[t:])) for t in range(len(numerators))]

    def at(t: int) -> int:
        return b[abs(t)] if abs(t) < len(b) else 0

    return [[at(p * i - j) + (at(p * i + j) if j else 0) for j in range(order)] for i in range(order)]
