"""Images on the boundary of a polytope, decided exactly in the number field of the leaders' eigenvalue.

Vertices without their powers of σ are vectors X of polynomials in γ: γ = |μ| where the leaders' eigenvalues μ are real,
γ = μ where they are complex. Leaders come first, then M X. A tie M_i v_u / σ = Σ_k c_k v_k with rational weights c_k
(turned by powers of the phase of γ, where γ is complex) is the identity M_i X_u = Σ_k c_k γ^(e_k) X_k with
depth(u) + 1 - depth(k) = ℓ e_k, which is decided modulo the minimal polynomial of γ. Where γ is real, weights in Q(γ)
are found as well, by linear equations; and where σ is in Q(γ), depths need not differ by multiples of ℓ.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from flint import arb, fmpq, fmpq_mat, fmpq_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, negated
from subdiv_cli.exact.enclosures import ball
from subdiv_cli.exact.field import root_in_field, solve
from subdiv_cli.exact.rationals import to_fmpq, to_fraction
from subdiv_cli.jsr.body import Polytope
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.leaders import Leader, Leaders

_LARGEST_DENOMINATOR = 64
_NEGLIGIBLE = 1e-7
_LARGEST_SYSTEM = 80
"""The most coordinates times the degree of γ, for equations in Q(γ)."""
_LONGEST = 2048
"""The most bits of the coefficients of the minimal polynomial of γ for such equations."""
_NEARLY = 1 - 1e-9
_VARIABLE = fmpq_poly([0, 1])
_MOST_DEPTH = 60
"""The largest depth of a vertex in a tie; beyond it the numbers of an identity grow too long."""

Vector = list[fmpq_poly]


Weight = Fraction | fmpq_poly
"""A weight: a rational number, or a polynomial in γ."""


class Tie(NamedTuple):
    """An identity M_letter v / σ = Σ weight · vertex with Σ |weight| <= 1; in a monotone body <= will do for =."""

    vertex: int
    letter: int
    weights: tuple[tuple[int, Weight], ...]
    """Pairs of a vertex number, as in certificates, and a weight."""
    by_sigma: bool = False
    """Whether powers of σ, as a polynomial in γ, were used."""


class _Term(NamedTuple):
    vertex: int
    weight: Fraction
    exponent: int
    """The exponent e_k."""


Smaller = Callable[[int, int, Sequence[tuple[int, arb]], int], bool]
"""Whether a coordinate of M_letter v / σ is proved to be smaller than that of Σ weight · vertex, and that suffices."""


class Ties:
    """The exact vertices of one polytope, each computed once, on first use."""

    def __init__(self, family: Family, leaders: Leaders, body: Polytope, smaller: Smaller) -> None:
        self._family, self._leaders, self._body, self._smaller = family, leaders, body, smaller
        first = leaders.each[0].eigenvalue
        self._gamma = negated(first) if first.is_real and first.region.real < 0 else first
        self._modulus = fmpq_poly(self._gamma.minimal_polynomial)
        self._bits = self._gamma.minimal_polynomial.height_bits()
        self._vectors: dict[int, Vector] = {}

    def tie(self, vertex: int, letter: int, weights: dict[int, complex]) -> Tie | None:
        """The tie that float weights (by vertex number) suggest, if it holds."""
        terms = self._terms(vertex, weights)
        if terms and sum(abs(term.weight) for term in terms) <= 1 and self._holds(vertex, letter, terms):
            return Tie(vertex, letter, tuple((term.vertex, term.weight) for term in terms))
        return self._solved(vertex, letter, weights) if self._gamma.is_real else None

    def _solved(self, vertex: int, letter: int, weights: dict[int, complex]) -> Tie | None:
        """The tie with the same vertices and weights in Q(γ): the only solution of linear equations, if it is one.

        In a monotone body the equations are those of coordinates that are not certainly smaller.
        """
        given = {k: weight.real for k, weight in weights.items() if abs(weight) > _NEGLIGIBLE}
        used = [vertex, *given]
        depths = [self._body.depths[vertex] + 1, *(self._body.depths[k % self._body.size] for k in given)]
        step = self._leaders.length if len({depth % self._leaders.length for depth in depths}) == 1 else 1
        base = _VARIABLE if step > 1 or self._leaders.length == 1 else self._sigma
        large = self._modulus.degree() * self._family.order > _LARGEST_SYSTEM or self._bits > _LONGEST
        if base is None or large or max(depths) > _MOST_DEPTH or not all(map(self._is_exact, used)):
            return None
        least = min((depths[0] - depth) // step for depth in depths)
        powers = [self._power((depths[0] - depth) // step - least, base) for depth in depths]
        left = self._times(powers[0], self._applied(letter, self._vector(vertex)))
        columns = [self._times(power, self._vector(k)) for power, k in zip(powers[1:], given, strict=True)]
        rounded = [(k, arb(weight * _NEARLY)) for k, weight in given.items()]
        tight = [i for i in range(len(left)) if not self._smaller(vertex, letter, rounded, i)]
        solution = solve([[column[i] for i in tight] for column in columns], [left[i] for i in tight], self._modulus)
        if solution is None:
            return None
        balls = [self._at(c) for c in solution]
        signs = [1 if c > 0 else -1 if c < 0 else 0 for c in balls]
        excess = sum((c * sign for c, sign in zip(solution, signs, strict=True)), fmpq_poly([-1])) % self._modulus
        bounded = all(signs) and (not excess or bool(self._at(excess) < 0))
        loose = set(range(len(left))) - set(tight)
        exact = list(zip(given, balls, strict=True))
        if not bounded or not all(self._smaller(vertex, letter, exact, i) for i in loose):
            return None
        return Tie(vertex, letter, tuple(zip(given, solution, strict=True)), step == 1 and self._leaders.length > 1)

    def _at(self, x: fmpq_poly) -> arb:
        """The value of a polynomial at γ, by Horner's rule."""
        gamma, total = self._gamma.enclosure().real, arb(0)
        for c in reversed(list(x)):
            total = total * gamma + arb(c)
        return total

    @cached_property
    def _sigma(self) -> fmpq_poly | None:
        """The number σ = γ^(1/ℓ) as a polynomial in γ; None where it is not in Q(γ)."""
        return root_in_field(self._gamma, self._leaders.length)

    @property
    def sigma(self) -> tuple[Fraction, ...]:
        """The coefficients of σ as a polynomial in γ, which ties by powers of σ need."""
        return () if self._sigma is None else coefficients(self._sigma)

    def is_zero(self, leader: int, coordinate: int) -> bool:
        """Whether a coordinate of a leader is exactly zero."""
        return not self._vector(leader)[coordinate]

    def _terms(self, vertex: int, weights: dict[int, complex]) -> list[_Term]:
        """The terms of the identity with these weights; none where a depth does not fit or a vertex is not exact."""
        depth, phase, terms = self._body.depths[vertex] + 1, self._phase(), []
        if depth > _MOST_DEPTH or not self._is_exact(vertex):
            return []
        for k, weight in weights.items():
            if abs(weight) <= _NEGLIGIBLE:
                continue
            exponent, rest = divmod(depth - self._body.depths[k % self._body.size], self._leaders.length)
            turned = weight * cmath.exp(-1j * exponent * phase)
            if rest or not self._is_exact(k) or abs(turned.imag) > _NEGLIGIBLE:
                return []
            terms.append(_Term(k, Fraction(turned.real).limit_denominator(_LARGEST_DENOMINATOR), exponent))
        return terms

    def _is_exact(self, number: int) -> bool:
        """Whether a vertex descends from a leader and is no conjugate."""
        copy, u = divmod(number, self._body.size)
        return not self._body.descends_from_extra(u) and not (self._body.complex and copy % 2)

    def _phase(self) -> float:
        if self._gamma.is_real:
            return 0.0
        region = self._gamma.region
        return cmath.phase(complex(float(region.real.mid()), float(region.imag.mid())))

    def _holds(self, vertex: int, letter: int, terms: Sequence[_Term]) -> bool:
        """Whether the identity holds; in a monotone body coordinates that are certainly smaller may differ."""
        left, right = self._sides(vertex, letter, terms)
        unequal = [i for i, (x, y) in enumerate(zip(left, right, strict=True)) if x != y]
        weights = [(term.vertex, ball(term.weight)) for term in terms]
        return all(self._smaller(vertex, letter, weights, i) for i in unequal)

    def _sides(self, vertex: int, letter: int, terms: Sequence[_Term]) -> tuple[Vector, Vector]:
        """The two sides of the identity, vectors of N polynomials, times γ^E, E the largest -e_k that is positive."""
        lift = max(0, *(-term.exponent for term in terms))
        left = self._times(self._power(lift), self._applied(letter, self._vector(vertex)))
        right = [fmpq_poly()] * self._family.order
        for term in terms:
            turned = self._times(self._power(lift + term.exponent) * to_fmpq(term.weight), self._vector(term.vertex))
            right = [x + y for x, y in zip(right, turned, strict=True)]
        return left, right

    def _vector(self, number: int) -> Vector:
        """The exact form X of a vertex, N polynomials in γ; numbers from `size` on are reflections."""
        if number >= self._body.size:
            return self._vector(number % self._body.size)[::-1]
        if number not in self._vectors:
            parent = self._body.parents[number]
            if parent is None:
                self._vectors[number] = self._leader(self._leaders.each[number])
            else:
                self._vectors[number] = self._applied(parent[1], self._vector(parent[0]))
        return self._vectors[number]

    def _applied(self, letter: int, vector: Vector) -> Vector:
        rows = self._family.matrices[letter].table()
        return [sum((x * c for c, x in zip(row, vector, strict=True) if c), fmpq_poly()) for row in rows]

    def _times(self, scalar: fmpq_poly, vector: Vector) -> Vector:
        return [(scalar * x) % self._modulus for x in vector]

    def _power(self, exponent: int, base: fmpq_poly = _VARIABLE) -> fmpq_poly:
        power = fmpq_poly([1])
        for _ in range(exponent):
            power = (power * base) % self._modulus
        return power

    def _leader(self, leader: Leader) -> Vector:
        """The vector scale · h(Π) e_j of N polynomials, h = Σ_i b_i z^i with b_i polynomials in γ."""
        n, sign = self._family.order, 1 if _is_gamma(leader.eigenvalue, self._gamma) else -1
        b = [fmpq_poly([to_fmpq(leader.annihilator[-1])])]
        for c in reversed(leader.annihilator[1:-1]):
            b.append((b[-1] * fmpq_poly([0, sign]) + to_fmpq(c)) % self._modulus)
        power = fmpq_mat(n, 1, list(leader.start))
        product, total = self._family.candidate(leader.candidate), [fmpq_poly()] * n
        for coefficient in reversed(b):
            entries: list[fmpq] = [x * to_fmpq(leader.scale) for x in power.entries()]
            total = [x + coefficient * y for x, y in zip(total, entries, strict=True)]
            power = product * power
        return total


def _is_gamma(x: AlgebraicNumber, gamma: AlgebraicNumber) -> bool:
    """Whether x, known to be ±γ, is γ."""
    return x.minimal_polynomial == gamma.minimal_polynomial and x.region.overlaps(gamma.region)


def coefficients(x: fmpq_poly) -> tuple[Fraction, ...]:
    """The coefficients of a polynomial, the constant one first; at least one."""
    return tuple(to_fraction(c) for c in x) or (Fraction(0),)
