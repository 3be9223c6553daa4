"""The polyphase gcd and cycles of roots of unity, which decide linear independence and stability of translates.

An unstable mask reduced to a stable one with the same smoothness of the refinable function.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import gcd
from typing import NamedTuple

from flint import fmpq, fmpq_poly, fmpz_poly

from subdiv_cli.exact.algebraic import meets_circle
from subdiv_cli.exact.laurent import Laurent


def polyphase_gcd(a: Laurent, p: int) -> Laurent:
    """The gcd(a_0, …, a_(p-1)) of the polyphase components, monic from exponent 0."""
    g = fmpz_poly()
    for component in a.components(p):
        g = g.gcd(component.poly.numer())
    return monic(g)


def bezout_cofactors(a: Laurent, p: int) -> tuple[Laurent, ...]:
    """The p cofactors u_r with Σ_r u_r a_r = gcd(a_0, …, a_(p-1)), a_r the polyphase components."""
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
    """The numbers n > 1 coprime to p for which Φ_n(z^p)/Φ_n(z) = Π_(d|p, d>1) Φ_(nd)(z) divides a.

    The quotient has degree (p-1)φ(n), which bounds φ(n); and φ(n) >= n/10 for every n below the product of the primes
    up to 250, far beyond any mask.
    """
    bound = a.degree // (p - 1)
    totients = _totients(10 * bound)
    for n in range(2, len(totients)):
        if gcd(n, p) == 1 and totients[n] <= bound and not a.divide(cycle_factor(n, p))[1].poly:
            yield n


def cycle_factor(n: int, p: int) -> Laurent:
    """The polynomial Φ_n(z^p)/Φ_n(z) for n coprime to p."""
    phi = fmpz_poly.cyclotomic(n)
    return Laurent(0, fmpq_poly(phi.inflate(p)) / fmpq_poly(phi))


def _totients(last: int) -> list[int]:
    """The values φ(0), …, φ(last) of Euler's function by a sieve; φ(0) is set to 0."""
    phi = list(range(last + 1))
    for q in range(2, last + 1):
        if phi[q] == q:
            for multiple in range(q, last + 1, q):
                phi[multiple] -= phi[multiple] // q
    return phi


def monic(f: fmpz_poly) -> Laurent:
    """An integer polynomial with a non-zero constant term, divided by its leading coefficient."""
    return Laurent(0, fmpq_poly(f) / fmpq(f.leading_coefficient()))


class ReductionStep(NamedTuple):
    """One step a0(z) = a(z) g(z)/g(z^p) of a reduction, an exact division; φ = Σ_j g_j φ0(·-j) / g(1)."""

    factor: Laurent
    """The factor g: the gcd of the polyphase components, or Φ_n for a cycle."""
    cycle: int | None
    """The number n where g = Φ_n, else None."""
    symbol: Laurent
    """The symbol a0 after the step."""


def reduction(a: Laurent, p: int) -> tuple[ReductionStep, ...]:
    """The steps from a symbol with a(1) = p to one with a stable refinable function; none where it is stable.

    Where all polyphase components vanish at a point of |z| = 1, g is their gcd; where a has a cycle of n-th roots of
    unity, g = Φ_n. In both cases g(z^p) divides a(z) g(z), g(1) ≠ 0 because a(1) = p, and 1/g is a power series, so
    that φ and φ0 are finite or locally finite combinations of each other's translates: equally smooth. The degree
    falls by (p-1) deg g in each step, so the steps end; the sum-rule order does not fall. ArithmeticError would mean
    that a step is not exact.
    """
    steps: list[ReductionStep] = []
    while (unstable := _unstable_factor(a, p)) is not None:
        g, cycle = unstable
        a, remainder = (a * g).divide(g.inflate(p))
        if remainder.poly or g(1) == 0:
            raise ArithmeticError("an inexact reduction step")
        steps.append(ReductionStep(g, cycle, a))
    return tuple(steps)


def _unstable_factor(a: Laurent, p: int) -> tuple[Laurent, int | None] | None:
    g = polyphase_gcd(a, p)
    if circle_factors(g):
        return g, None
    n = next(cycles(a, p), None)
    return None if n is None else (monic(fmpz_poly.cyclotomic(n)), n)
