"""The rules on the distance of control polygons from the limit (Dyn 1992, 3.3 and 4.7). See FORMAT.md."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.polynomials import Polynomial, add, times, times_sigma
from subdiv_cli.checker.reading import Rejected, require
from subdiv_cli.checker.scalar.conclusions import power

MAX_ORDER = 200


def error_bound(c: Claim) -> None:
    """‖S_ν^∞ g - S_ν^k g‖∞ <= C μ^⌊k/L⌋ ‖Δg‖∞ for all g and k, S_ν^k g the polygon with its vertices at i p^-k.

    S_ν - U = e(Δ·) with U the linear spline and E the norm of e; the terms of Σ_(i>=k) E ‖((1/p)S_(ν+1))^i‖ are at most
    E M μ^⌊i/L⌋, M the largest norm below L. So C = E L/(1-μ) M. Raises Rejected where the sum rules have no quotient.
    """
    nu, level, p = c.statement["nu"], c.statement["level"], c.p
    used = c.use("sum-rules", mask=0)
    k, q = used.statement["order"], used.result
    require(nu < k, f"the sum rules are of order {k}")
    require(level > 0, "the level is not positive")
    if q is None:
        raise Rejected("there is no quotient")
    norms = [c.use("norm", mask=0, nu=nu + 1, level=i).statement["norm"] for i in range(1, level + 1)]
    mu = norms[-1]
    require(c.statement["norm"] == mu < 1, "the norm is another, or not below 1")
    first = q.start + (p - 1) * nu
    last = first + q.length - 1 + (k - nu) * (p - 1)
    c.count((max(last, p - 1) - min(first, 1 - p) + 1) * (k + 1) * p, q.bits + nu * p.bit_length())
    symbol = times(times_sigma(q, p, k - nu), p**nu, shift=(p - 1) * nu)
    c.count(1, sum(x.denominator.bit_length() for x in norms) + symbol.bits)
    largest = max([Fraction(1), *norms[:-1]])
    constant = _distance(symbol, p) * level / (1 - mu) * largest
    require(c.statement["constant"] == constant, "the constant is another")


def _distance(symbol: Polynomial, p: int) -> Fraction:
    """The norm E, the largest class sum of |e|, with symbol - z^-(p-1) σ²/p = (1-z^p) z^-p e.

    By running sums of each class.
    """
    spline = times_sigma(Polynomial(1 - p, (1,), p), p, 2)
    d = add(symbol, times(spline, -1))
    largest = 0
    for r in range(p):
        running, total = 0, 0
        for x in d.numerators[r::p]:
            running += x
            total += abs(running)
        require(running == 0, "the symbol does not map constants to themselves")
        largest = max(largest, total)
    return Fraction(largest, d.denominator)


def levels(c: Claim) -> None:
    """‖S^∞ f - S^k f‖∞ <= t ‖Δf‖∞ for this k and all f: C μ^⌊k/L⌋ <= t."""
    bound = c.use("error-bound", nu=0).statement
    c.count(1)
    steps = c.statement["levels"] // bound["level"]
    reached = bound["constant"] * power(c, bound["norm"], steps) <= c.statement["tolerance"]
    require(reached, "the bound is not that small at this level")


def hermite_bound(c: Claim) -> None:
    """‖S^∞ f - Q^k‖∞ <= H p^-(νk) ‖Δ^ν f‖∞, Q^k the Hermite interpolant of degree ν-1 of S^∞ f at i p^-k, ν even.

    On an interval of length h it is off by h^ν/(2^ν ν!) ‖f^(ν)‖ at most, and f^(ν) = S_ν^∞ Δ^ν f; for every j
    ‖S_ν^∞‖ <= ‖S_ν^j‖ + 2 C μ^⌊j/L⌋ by the error bound of S_ν, as ‖Δg‖ <= 2 ‖g‖.
    """
    nu = c.statement["order"]
    require(nu > 0 and nu % 2 == 0 and nu <= MAX_ORDER, "the order is not even and positive")
    bound: Statement = c.use("error-bound", nu=nu).statement
    used = c.use("norm", mask=0, nu=nu).statement
    j = used["level"]
    c.count(1)
    size = used["norm"] * power(c, Fraction(c.p), j)
    size += 2 * bound["constant"] * power(c, bound["norm"], j // bound["level"])
    require(c.statement["constant"] == size / (2**nu * factorial(nu)), "the constant is another")
