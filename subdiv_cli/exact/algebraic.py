"""Algebraic numbers: a minimal polynomial and an isolating region; moduli compared with rationals exactly."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import acb, arb, fmpq, fmpq_poly, fmpz_poly

from subdiv_cli.exact.enclosures import ball, bounds, decide
from subdiv_cli.exact.rationals import to_fraction


class AlgebraicNumber(NamedTuple):
    """The one root of the irreducible, primitive `minimal_polynomial` that lies in the ball `region`."""

    minimal_polynomial: fmpz_poly
    region: acb

    @property
    def rational(self) -> Fraction | None:
        """The number itself where it is rational."""
        f = self.minimal_polynomial
        return to_fraction(fmpq(-f[0], f[1])) if f.degree() == 1 else None

    @property
    def is_real(self) -> bool:
        """FLINT isolates real roots with an imaginary part that is exactly zero."""
        return self.region.imag.is_zero()

    def enclosure(self) -> acb:
        """A ball around the number, of about the current precision or better."""
        if (r := self.rational) is not None:
            return acb(ball(r))

        def ask() -> acb | None:
            candidates = [z for z in isolated_roots(self.minimal_polynomial) if z.overlaps(self.region)]
            return candidates[0] if len(candidates) == 1 else None

        return ask() or decide(ask)

    def modulus(self) -> arb:
        """A ball around |λ|."""
        return self.enclosure().__abs__()

    def compare_modulus(self, r: Fraction) -> int:
        """The sign of |λ| - r, exactly. Needs r >= 0.

        A root of an irreducible f lies on |z| = r only if f is a multiple of z^n f(r²/z); then z -> r²/z̄ permutes the
        roots, and λ is on the circle iff it is its own image. Otherwise some precision separates |λ| from r.
        """
        if (exact := self.rational) is not None:
            return (abs(exact) > r) - (abs(exact) < r)
        if (sign := _separated(self.region, r)) is not None:
            return sign
        f = self.minimal_polynomial
        reciprocal = is_reciprocal(f, r)

        def ask() -> int | None:
            everything = isolated_roots(f)
            candidates = [z for z in everything if z.overlaps(self.region)]
            if len(candidates) != 1:
                return None
            (z,) = candidates
            if (sign := _separated(z, r)) is not None:
                return sign
            if reciprocal:
                mirror = acb(ball(r) * ball(r)) / z.conjugate()
                if mirror.is_finite() and [root is z for root in everything if root.overlaps(mirror)] == [True]:
                    return 0
            return None

        return decide(ask)

    def box(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """Rational bounds of the isolating region: real part from, to; imaginary part from, to."""
        return (*bounds(self.region.real), *bounds(self.region.imag))


def _separated(z: acb, r: Fraction) -> int | None:
    """The sign of |z| - r where the ball is off the circle |z| = r."""
    modulus, radius = z.__abs__(), ball(r)
    return -1 if modulus < radius else 1 if modulus > radius else None


def isolated_roots(f: fmpz_poly) -> list[acb]:
    """Disjoint balls around all roots of a squarefree f of positive degree, at about the current precision."""
    return [root for root, _ in _pairs(f)]


def _pairs(f: fmpz_poly) -> Sequence[tuple[acb, int]]:
    return f.complex_roots()  # type: ignore[return-value]  # the stub says list[acb]; pairs come


def is_reciprocal(f: fmpz_poly, r: Fraction) -> bool:
    """Whether f(z) is a multiple of z^n f(r²/z), n the degree of f. Needs f(0) ≠ 0 for a True."""
    c = [int(x) for x in f]
    n = len(c) - 1
    if r == 0 or c[0] == 0:
        return False
    u, v = r.numerator**2, r.denominator**2
    mirrored = [c[n - j] * u ** (n - j) * v**j for j in range(n + 1)]
    return all(mirrored[j] * c[0] == mirrored[0] * c[j] for j in range(n + 1))


def meets_circle(f: fmpz_poly, r: Fraction) -> bool:
    """Whether an irreducible f has a root on |z| = r, exactly. Needs r > 0."""
    if f.degree() == 1:
        return abs(to_fraction(fmpq(-f[0], f[1]))) == r
    return is_reciprocal(f, r) and any(root.compare_modulus(r) == 0 for root, _ in roots(fmpq_poly(f)))


def roots(f: fmpq_poly) -> tuple[tuple[AlgebraicNumber, int], ...]:
    """All complex roots with multiplicities, by falling modulus as balls of double precision see it. Needs f ≠ 0."""
    found = []
    for factor, multiplicity in f.numer().factor()[1]:
        found += [(AlgebraicNumber(factor, z), multiplicity) for z in isolated_roots(factor)]
    return tuple(sorted(found, key=lambda pair: -float(pair[0].region.__abs__().mid())))
