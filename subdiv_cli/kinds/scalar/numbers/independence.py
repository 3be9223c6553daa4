"""What decides linear independence and stability of integer translates: polyphase gcd and cycles of roots of unity."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import gcd

from flint import fmpq, fmpq_poly, fmpz_poly

from subdiv_cli.exact.algebraic import meets_circle
from subdiv_cli.exact.laurent import Laurent


def polyphase_gcd(a: Laurent, p: int) -> Laurent:
    """gcd(a_0, …, a_(p-1)) of the polyphase components, monic from exponent 0."""
    g = fmpz_poly()
    for component in a.components(p):
        g = g.gcd(component.poly.numer())
    return monic(g)


def bezout_cofactors(a: Laurent, p: int) -> tuple[Laurent, ...]:
    """u_0, …, u_(p-1) with Σ_r u_r a_r = gcd(a_0, …, a_(p-1)), a_r the polyphase components."""
    components = a.components(p)
    g, cofactors = fmpq_poly(), [fmpq_poly()] * p
    for r, component in enumerate(components):
        if not component.poly:
            continue
        g, s, t = g.xgcd(component.poly)
        cofactors = [s * u for u in cofactors]
        cofactors[r] = t
    return tuple(Laurent(-c.low, u) for c, u in zip(components, cofactors, strict=True))


def circle_factors(g: Laurent) -> tuple[fmpz_poly, ...]:
    """The irreducible factors of g over Q that vanish somewhere on |z| = 1, decided exactly."""
    factors = (f for f, _ in g.poly.numer().factor()[1])
    return tuple(f for f in factors if meets_circle(f, Fraction(1)))


def cycles(a: Laurent, p: int) -> Iterator[int]:
    """The n > 1 coprime to p for which Φ_n(z^p)/Φ_n(z) = Π_(d|p, d>1) Φ_(nd)(z) divides a.

    The quotient has degree (p-1)φ(n), which bounds φ(n); and φ(n) >= n/10 for every n below the product of the primes
    up to 250, far beyond any mask.
    """
    bound = a.degree // (p - 1)
    totients = _totients(10 * bound)
    for n in range(2, len(totients)):
        if gcd(n, p) == 1 and totients[n] <= bound and not a.divide(cycle_factor(n, p))[1].poly:
            yield n


def cycle_factor(n: int, p: int) -> Laurent:
    """Φ_n(z^p)/Φ_n(z) for n coprime to p."""
    phi = fmpz_poly.cyclotomic(n)
    return Laurent(0, fmpq_poly(phi.inflate(p)) / fmpq_poly(phi))


def _totients(last: int) -> list[int]:
    """Euler's φ(0), …, φ(last) by a sieve; φ(0) is set to 0."""
    phi = list(range(last + 1))
    for q in range(2, last + 1):
        if phi[q] == q:
            for multiple in range(q, last + 1, q):
                phi[multiple] -= phi[multiple] // q
    return phi


def monic(f: fmpz_poly) -> Laurent:
    """An integer polynomial with a non-zero constant term, divided by its leading coefficient."""
    return Laurent(0, fmpq_poly(f) / fmpq(f.leading_coefficient()))
