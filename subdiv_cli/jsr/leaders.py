"""Leading eigenvectors of products, exactly: what an invariant polytope grows from.

All leaders of a polytope have words of one length ℓ and eigenvalues of one modulus. With g the minimal polynomial of
the product Π and μ an eigenvalue, the vector h(Π) e_j, h(z) = (g(z) - g(μ))/(z - μ), is an eigenvector: (Π - μ) times
it is g(Π) e_j - g(μ) e_j = 0. A complex μ stands for its conjugate too, the matrices being real.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm
from typing import Any, NamedTuple

from flint import acb, acb_mat, arb, arb_mat, ctx, fmpq_mat

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated, negated, roots, squared_modulus
from subdiv_cli.exact.enclosures import ball
from subdiv_cli.exact.linalg import minimal_polynomial
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.jsr.family import Candidate, Family
from subdiv_cli.model import Look, Root, no_clock

MOST_LEADERS = 16
_LONGEST = 200
"""The most letters of a common power of all words."""
LONGEST_PRODUCT = 1 << 18
"""The most bits of the entries of a product whose eigenvalues are computed exactly."""

Ball = Any
"""An arb or an acb, alike throughout one family: the stubs of their unions do not add up."""
Balls = Any
"""An arb_mat or an acb_mat."""


class Leader(NamedTuple):
    """A leader: the vector scale · h(Π) w of the candidate's product Π."""

    candidate: Candidate
    eigenvalue: AlgebraicNumber
    annihilator: tuple[Fraction, ...]
    """The coefficients of g, the constant one first."""
    start: tuple[int, ...]
    """The vector w, a unit vector where the eigenspace has one dimension."""
    scale: Fraction


class Leaders(NamedTuple):
    """The leaders of one polytope, at least one; all eigenvalues are real, or none is."""

    length: int
    """The common length ℓ of all words."""
    each: tuple[Leader, ...]
    has_both_signs: bool
    """Whether some product has the eigenvalue that they share, and its negative too, which is left out."""

    @property
    def is_real(self) -> bool:
        """Whether the eigenvalues are real."""
        return self.each[0].eigenvalue.is_real

    def sigma(self) -> arb:
        """The number σ = |μ|^(1/ℓ) in a ball at the current precision: the joint spectral radius is at least that."""
        return self.each[0].eigenvalue.modulus() ** (arb(1) / self.length)

    def root(self) -> tuple[int, Root] | None:
        """The pair (n, Λ) with Λ = |μ|^(n/ℓ): n = ℓ, or n = 2ℓ where μ is complex; None for too many conjugates."""
        number = self.each[0].eigenvalue
        if number.is_real:
            return self.length, isolated(number if number.region.real > 0 else negated(number))
        square = squared_modulus(number)
        return None if square is None else (2 * self.length, isolated(square))


def leaders(
    family: Family, candidates: Sequence[Candidate], *, squared: bool = False, look: Look = no_clock
) -> Leaders | None:
    """The leaders of candidates with equally large eigenvalues; None where all their products are nilpotent.

    They are raised to powers of one length. All share one eigenvalue up to sign, a real one where there is one as large
    as the first: real vertices may be ties. Candidates that do not have it are left out.

    `squared`: where both signs are eigenvalues of one product, all products are squared, so that there is one
    eigenspace of both.

    Raises what `look` raises.
    """
    length = lcm(*(len(candidate.word) for candidate in candidates))
    if not _is_affordable(family, length):
        candidates, length = candidates[:1], len(candidates[0].word)
    leading = _of_length(family, candidates, length, look)
    if squared and leading is not None and leading.has_both_signs and _is_affordable(family, 2 * length):
        return _of_length(family, candidates, 2 * length, look)
    return leading


def _is_affordable(family: Family, length: int) -> bool:
    return length <= _LONGEST and length * family.bits <= LONGEST_PRODUCT


def _of_length(family: Family, candidates: Sequence[Candidate], length: int, look: Look) -> Leaders | None:
    powers = [candidate.power(length // len(candidate.word), family.letters) for candidate in candidates]
    products = [family.candidate(power) for power in powers]
    spectra = [_leading_eigenvalues(product, look) for product in products]
    shared = _shared(spectra)
    if shared is None:
        return None
    each: list[Leader] = []
    both = False
    for power, product, spectrum in zip(powers, products, spectra, strict=True):
        look()
        alike = [x for x in spectrum if _same(x, shared) or (shared.is_real and _same(x, negated(shared)))]
        if alike:
            each += _eigenvectors(product, power, max(alike, key=_preference))
        both = both or len(alike) > 1
    return Leaders(length, tuple(each[:MOST_LEADERS]), both) if each else None


def _leading_eigenvalues(product: fmpq_mat, look: Look) -> list[AlgebraicNumber]:
    """The eigenvalues ≠ 0 of the largest modulus, as balls see it; of complex pairs those in the upper half plane."""
    look()
    spectrum = [number for number, _ in roots(product.charpoly()) if not number.region.imag < 0]
    top = spectrum[0].region.__abs__()
    return [number for number in spectrum if number.region.__abs__().overlaps(top) and number.rational != 0]


def _shared(spectra: Sequence[Sequence[AlgebraicNumber]]) -> AlgebraicNumber | None:
    """The best of those eigenvalues that 256 bits do not separate from the first in modulus; None without any."""
    every = [number for spectrum in spectra for number in spectrum]
    with ctx.workprec(256):
        return max((x for x in every if x.modulus().overlaps(every[0].modulus())), key=_preference, default=None)


def _preference(number: AlgebraicNumber) -> tuple[bool, bool]:
    """A key that sorts positive eigenvalues before others and complex ones last."""
    return number.is_real, bool(number.region.real > 0)


def _same(x: AlgebraicNumber, y: AlgebraicNumber) -> bool:
    """Whether two algebraic numbers are equal: roots of one polynomial, in isolating balls that overlap."""
    return x.minimal_polynomial == y.minimal_polynomial and x.region.overlaps(y.region)


def _eigenvectors(product: fmpq_mat, candidate: Candidate, eigenvalue: AlgebraicNumber) -> list[Leader]:
    """A basis of the eigenspace among the columns of h(Π), the longest ones first."""
    annihilator = tuple(to_fraction(c) for c in minimal_polynomial(product))
    with ctx.workprec(256):
        columns = _eigenvector_columns(product, annihilator, eigenvalue)
        lengths = [max(abs(x).mid() for x in column) for column in columns]
        chosen: list[int] = []
        for j in sorted(range(len(columns)), key=lambda j: lengths[j], reverse=True):
            if lengths[j] > 0 and _independent([columns[k] for k in (*chosen, j)]):
                chosen.append(j)
        units = {j: tuple(int(i == j) for i in range(len(columns))) for j in chosen}
        return [Leader(candidate, eigenvalue, annihilator, units[j], _normalising(columns[j])) for j in chosen]


def _normalising(column: Sequence[Ball]) -> Fraction:
    """A power of two that makes the largest entry about 1."""
    largest = max(abs(x).mid() for x in column)
    mantissa, exponent = largest.man_exp()
    return Fraction(2) ** -(int(exponent) + int(mantissa).bit_length())


def _independent(columns: Sequence[Sequence[Ball]]) -> bool:
    """Whether balls prove that columns are linearly independent: a Gram determinant is certainly not zero."""
    scaled = [[x / max(abs(y).mid() for y in column) for x in column] for column in columns]
    gram = [[_inner(a, b) for b in scaled] for a in scaled]
    return not acb_mat(gram).det().contains(0)


def _inner(a: Sequence[Ball], b: Sequence[Ball]) -> acb:
    return sum((acb(x) * acb(y).conjugate() for x, y in zip(a, b, strict=True)), acb(0))


def _eigenvector_columns(
    product: fmpq_mat, annihilator: Sequence[Fraction], eigenvalue: AlgebraicNumber
) -> list[list[Ball]]:
    """The N columns of the N×N matrix h(Π), as lists of balls."""
    n = product.nrows()
    total = _applied(product, annihilator, eigenvalue, [[int(i == j) for j in range(n)] for i in range(n)])
    return [list(column) for column in zip(*total.table(), strict=True)]


def _applied(
    product: fmpq_mat, annihilator: Sequence[Fraction], eigenvalue: AlgebraicNumber, start: list[list[int]]
) -> Balls:
    """The N×k matrix h(Π) `start`, by Horner's rule: h = Σ_i b_i z^i with b_(d-1) = g_d, b_(i-1) = g_i + μ b_i."""
    mu = eigenvalue.enclosure()
    number = mu.real if eigenvalue.is_real else mu
    kind: Any = arb_mat if eigenvalue.is_real else acb_mat
    b = [number * 0 + ball(annihilator[-1])]
    for c in reversed(annihilator[1:-1]):
        b.append(ball(c) + number * b[-1])
    matrix, unit = kind(product), kind(start)
    total = unit * b[0]
    for coefficient in b[1:]:
        total = matrix * total + unit * coefficient
    return total


def eigenvectors(family: Family, leader: Leader) -> list[list[Ball]]:
    """The N columns of the leader's matrix h(Π), as lists of balls at the current precision."""
    return _eigenvector_columns(family.candidate(leader.candidate), leader.annihilator, leader.eigenvalue)


def vector(family: Family, leader: Leader) -> Balls:
    """The leader's vector, an N×1 matrix of balls at the current precision."""
    start = [[x] for x in leader.start]
    total = _applied(family.candidate(leader.candidate), leader.annihilator, leader.eigenvalue, start)
    return total * ball(leader.scale)
