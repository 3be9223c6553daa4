"""Algebraic numbers: a minimal polynomial and an isolating region; moduli compared with rationals exactly."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from flint import acb, arb, ctx, fmpq, fmpq_mat, fmpq_poly, fmpz_poly

from subdiv_cli.exact.enclosures import ball, bounds, decide
from subdiv_cli.exact.rationals import to_fmpq, to_fraction
from subdiv_cli.model import Root


class AlgebraicNumber(NamedTuple):
    """The one root of the irreducible, primitive `minimal_polynomial` that lies in the ball `region`."""

    minimal_polynomial: fmpz_poly
    region: acb

    @property
    def rational(self) -> Fraction | None:
        """The number as a fraction where it is rational, else None."""
        f = self.minimal_polynomial
        return to_fraction(fmpq(-f[0], f[1])) if f.degree() == 1 else None

    @property
    def is_real(self) -> bool:
        """Whether the number is real: FLINT isolates real roots with an imaginary part that is exactly zero."""
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


def negated(x: AlgebraicNumber) -> AlgebraicNumber:
    """The algebraic number -x, with its own minimal polynomial."""
    f = fmpz_poly([c if i % 2 == 0 else -c for i, c in enumerate(x.minimal_polynomial)])
    return AlgebraicNumber(f if f[f.degree()] > 0 else -f, -x.region)


MOST_CONJUGATES = 12
"""The largest degree in `squared_modulus`, which works with polynomials of half the square of it."""


def squared_modulus(x: AlgebraicNumber) -> AlgebraicNumber | None:
    """The number |x|² for an x that is not real; None where x has more than MOST_CONJUGATES conjugates.

    Its minimal polynomial divides the polynomial of all products of two conjugates of x.
    """
    f = x.minimal_polynomial
    if f.degree() > MOST_CONJUGATES:
        return None
    factors = [g for g, _ in _products_of_pairs(fmpq_poly(f)).numer().factor()[1]]

    def ask() -> AlgebraicNumber | None:
        square = x.modulus() ** 2
        matching = [(g, z) for g in factors for z in isolated_roots(g) if z.overlaps(acb(square))]
        return AlgebraicNumber(*matching[0]) if len(matching) == 1 else None

    return decide(ask)


def _products_of_pairs(f: fmpq_poly) -> fmpq_poly:
    """The monic polynomial whose roots are all products x_i x_j, i < j, of roots of f.

    By Newton's identities: with the power sums p_k of the x_i, those of the products are (p_k² - p_(2k)) / 2.
    """
    n = f.degree()
    count = n * (n - 1) // 2
    lead = f[n]
    e = [fmpq(1)] + [(-1) ** i * f[n - i] / lead for i in range(1, n + 1)]
    sums = _power_sums(e, 2 * count)
    pairs = [(sums[k] ** 2 - sums[2 * k]) / 2 if k else fmpq(count) for k in range(count + 1)]
    elementary = [fmpq(1)]
    for k in range(1, count + 1):
        total = sum(((-1) ** (i - 1) * elementary[k - i] * pairs[i] for i in range(1, k + 1)), fmpq(0))
        elementary.append(total / k)
    return fmpq_poly([(-1) ** (count - i) * elementary[count - i] for i in range(count + 1)])


def _power_sums(e: Sequence[fmpq], count: int) -> list[fmpq]:
    """The power sums p_0, …, p_count of n numbers with the elementary symmetric functions e_0, …, e_n."""
    n = len(e) - 1
    sums = [fmpq(n)]
    for k in range(1, count + 1):
        total = sum(((-1) ** (i - 1) * e[i] * sums[k - i] for i in range(1, min(k - 1, n) + 1)), fmpq(0))
        sums.append(total + ((-1) ** (k - 1) * k * e[k] if k <= n else 0))
    return sums


def isolating_interval(x: AlgebraicNumber, digits: int) -> tuple[Fraction, Fraction]:
    """Two decimals around a real irrational x that isolate it among the real roots of its minimal polynomial.

    They have so many significant digits or more, and both have the sign of x.
    """

    def ask() -> tuple[Fraction, Fraction] | None:
        nonlocal digits
        real = [z.real for z in isolated_roots(x.minimal_polynomial) if z.imag.is_zero()]
        mine = [z for z in real if z.overlaps(x.region.real)]
        if len(mine) != 1:
            return None
        low, high = bounds(mine[0])
        places = digits - math.floor(float(abs(mine[0]).log().mid()) / math.log(10))
        unit = Fraction(10) ** -places
        low, high = low // unit * unit, -(-high // unit) * unit
        others = (z for z in real if z is not mine[0])
        if high - low > 3 * unit or low * high <= 0:
            return None
        if all(z < ball(low) or z > ball(high) for z in others):
            return low, high
        digits *= 2
        return None

    return decide(ask)


_DIGITS = 30
"""Significant digits of the interval of an irrational `Root`."""


def isolated(x: AlgebraicNumber) -> Root:
    """A real algebraic number as plain data: its minimal polynomial and rational bounds, equal where it is rational."""
    exact = x.rational
    low, high = (exact, exact) if exact is not None else isolating_interval(x, _DIGITS)
    return Root(tuple(int(c) for c in x.minimal_polynomial), low, high)


def number_of(root: Root) -> AlgebraicNumber:
    """The algebraic number of a `Root` whose polynomial is irreducible."""
    ends = (root.low.numerator, root.low.denominator, root.high.numerator, root.high.denominator)
    with ctx.workprec(128 + 2 * max(x.bit_length() for x in ends)):
        region = ball(root.low).union(ball(root.high))
    return AlgebraicNumber(fmpz_poly(list(root.coefficients)), acb(region))


def only_root(root: Root) -> AlgebraicNumber:
    """The algebraic number of a `Root` whose polynomial, irreducible or not, has one root in [low, high].

    Raises ValueError where no factor changes its sign between the bounds.
    """
    low, high = to_fmpq(root.low), to_fmpq(root.high)
    for f, _ in fmpz_poly(list(root.coefficients)).factor()[1]:
        if f.degree() == 1 and low <= fmpq(-f[0], f[1]) <= high:
            return AlgebraicNumber(f, acb(ball(to_fraction(fmpq(-f[0], f[1])))))
        if f.degree() > 1 and fmpq_poly(f)(low) * fmpq_poly(f)(high) < 0:
            return AlgebraicNumber(f, _only_between(f, root.low, root.high))
    raise ValueError("no root between the bounds")


def _only_between(f: fmpz_poly, low: Fraction, high: Fraction) -> acb:
    def ask() -> acb | None:
        real = [z for z in isolated_roots(f) if z.imag.is_zero()]
        inside = [z for z in real if not z.real < ball(low) and not z.real > ball(high)]
        return inside[0] if len(inside) == 1 else None

    return decide(ask)


_LARGEST_POWER = 4_000_000
"""The largest degree² · exponent · bits of a polynomial whose roots are raised to a power."""


def same_powers(x: AlgebraicNumber, m: int, y: AlgebraicNumber, n: int) -> bool | None:
    """Whether x^m = y^n, for real x, y > 0; None where the polynomials would be too large."""
    f, g = _of_power(x.minimal_polynomial, m), _of_power(y.minimal_polynomial, n)
    if f is None or g is None:
        return None
    if f != g:
        return False

    def ask() -> bool | None:
        powers = [x.enclosure().real ** m, y.enclosure().real ** n]
        places = [[i for i, z in enumerate(isolated_roots(f)) if z.overlaps(acb(power))] for power in powers]
        return places[0] == places[1] if [len(each) for each in places] == [1, 1] else None

    return decide(ask)


def power(x: AlgebraicNumber, n: int) -> AlgebraicNumber | None:
    """The number x^n for a real x > 0; None where its polynomial would be too large."""
    f = _of_power(x.minimal_polynomial, n)
    if f is None:
        return None

    def ask() -> AlgebraicNumber | None:
        near = [z for z in isolated_roots(f) if z.overlaps(acb(x.enclosure().real ** n))]
        return AlgebraicNumber(f, near[0]) if len(near) == 1 else None

    return decide(ask)


def _of_power(f: fmpz_poly, m: int) -> fmpz_poly | None:
    """The minimal polynomial of the m-th power of a root of an irreducible f; None where it would be too large.

    The characteristic polynomial of the m-th power of f's companion matrix is a power of it.
    """
    if m == 1:
        return f
    if f.degree() ** 2 * m * f.height_bits() > _LARGEST_POWER:
        return None
    n = f.degree()
    rows = [[fmpq(int(j == i + 1)) for j in range(n)] for i in range(n - 1)]
    companion = fmpq_mat([*rows, [fmpq(-f[j], f[n]) for j in range(n)]])
    return (companion**m).charpoly().numer().factor()[1][0][0]


def _separated(z: acb, r: Fraction) -> int | None:
    """The sign of |z| - r where the ball z is off the circle |z| = r, else None."""
    modulus, radius = z.__abs__(), ball(r)
    return -1 if modulus < radius else 1 if modulus > radius else None


def isolated_roots(f: fmpz_poly) -> list[acb]:
    """Disjoint balls around all roots of a squarefree f of positive degree, at about the current precision."""
    return _isolated(tuple(int(c) for c in f), ctx.prec)


@lru_cache(maxsize=16)
def _isolated(coefficients: tuple[int, ...], precision: int) -> list[acb]:
    """The isolated roots of the polynomial with these coefficients; `precision` must be the current one.

    Remembered, since each root of a polynomial in turn asks for all of them.
    """
    return [root for root, _ in _pairs(fmpz_poly(list(coefficients)))]


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
    numbers = []
    for factor, multiplicity in f.numer().factor()[1]:
        numbers += [(AlgebraicNumber(factor, z), multiplicity) for z in isolated_roots(factor)]
    return tuple(sorted(numbers, key=lambda pair: pair[0].region.__abs__().mid(), reverse=True))
