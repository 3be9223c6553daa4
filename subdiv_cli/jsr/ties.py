"""Images on the boundary of a polytope, decided exactly in the number field of the leaders' eigenvalue.

Vertices without their powers of σ are vectors X of polynomials in γ: γ = |μ| where the leaders' eigenvalues μ are real,
γ = μ where they are complex. Leaders come first, then M X. A tie M_i v_u / σ = Σ_k c_k v_k with rational weights c_k
(turned by powers of the phase of γ, where γ is complex) is the identity M_i X_u = Σ_k c_k γ^(e_k) X_k with
depth(u) + 1 - depth(k) = ℓ e_k, which is decided modulo the minimal polynomial of γ.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, negated
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.jsr.body import Body
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.leaders import Leader, Leaders

_LARGEST_DENOMINATOR = 64
_NEGLIGIBLE = 1e-7
_MOST_DEPTH = 60
"""Beyond it the numbers of an identity grow too long."""

Vector = list[fmpq_poly]


class Tie(NamedTuple):
    """M_letter v / σ = Σ weight · vertex, or <= it in every coordinate of a monotone body, and Σ |weight| <= 1."""

    vertex: int
    letter: int
    weights: tuple[tuple[int, Fraction], ...]
    """Vertex numbers as in certificates."""


class _Term(NamedTuple):
    vertex: int
    weight: Fraction
    exponent: int
    """e_k."""


Smaller = Callable[[int, int, Sequence[tuple[int, Fraction]], int], bool]
"""Whether a coordinate of M_letter v / σ is proved to be smaller than that of Σ weight · vertex, and that suffices."""


class Ties:
    """Exact vertices of one polytope, each computed once when it is asked for."""

    def __init__(self, family: Family, leaders: Leaders, body: Body, smaller: Smaller) -> None:
        self._family, self._leaders, self._body, self._smaller = family, leaders, body, smaller
        first = leaders.each[0].eigenvalue
        self._gamma = negated(first) if first.is_real and first.region.real < 0 else first
        self._modulus = fmpq_poly(self._gamma.minimal_polynomial)
        self._vectors: dict[int, Vector] = {}

    def tie(self, vertex: int, letter: int, weights: dict[int, complex]) -> Tie | None:
        """The tie that float weights (by vertex number) suggest, if it holds."""
        terms = self._terms(vertex, weights)
        if not terms or sum(abs(term.weight) for term in terms) > 1 or not self._holds(vertex, letter, terms):
            return None
        return Tie(vertex, letter, tuple((term.vertex, term.weight) for term in terms))

    def is_zero(self, leader: int, coordinate: int) -> bool:
        """Whether a coordinate of a leader is exactly zero."""
        return not self._vector(leader)[coordinate]

    def _terms(self, vertex: int, weights: dict[int, complex]) -> list[_Term]:
        """None at all where some depth does not fit, or a vertex has no exact form."""
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
        """The identity; in a monotone body coordinates that are certainly smaller may differ."""
        left, right = self._sides(vertex, letter, terms)
        unequal = [i for i, (x, y) in enumerate(zip(left, right, strict=True)) if x != y]
        weights = [(term.vertex, term.weight) for term in terms]
        return all(self._smaller(vertex, letter, weights, i) for i in unequal)

    def _sides(self, vertex: int, letter: int, terms: Sequence[_Term]) -> tuple[Vector, Vector]:
        """Both sides of the identity times γ^E, E the largest -e_k that is positive."""
        lift = max(0, *(-term.exponent for term in terms))
        left = self._times(self._power(lift), self._applied(letter, self._vector(vertex)))
        right = [fmpq_poly()] * self._family.order
        for term in terms:
            turned = self._times(self._power(lift + term.exponent) * to_fmpq(term.weight), self._vector(term.vertex))
            right = [x + y for x, y in zip(right, turned, strict=True)]
        return left, right

    def _vector(self, number: int) -> Vector:
        """X of an exact vertex; numbers from `size` on are reflections."""
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

    def _power(self, exponent: int) -> fmpq_poly:
        power = fmpq_poly([1])
        for _ in range(exponent):
            power = (power * fmpq_poly([0, 1])) % self._modulus
        return power

    def _leader(self, leader: Leader) -> Vector:
        """scale · h(Π) e_j, h = Σ_i b_i z^i with b_i polynomials in γ."""
        n, sign = self._family.order, 1 if _is_gamma(leader.eigenvalue, self._gamma) else -1
        b = [fmpq_poly([to_fmpq(leader.annihilator[-1])])]
        for c in reversed(leader.annihilator[1:-1]):
            b.append((b[-1] * fmpq_poly([0, sign]) + to_fmpq(c)) % self._modulus)
        power = fmpq_mat(n, 1, [int(i == leader.column) for i in range(n)])
        product, total = self._family.candidate(leader.candidate), [fmpq_poly()] * n
        for coefficient in reversed(b):
            entries: list[fmpq] = [x * to_fmpq(leader.scale) for x in power.entries()]
            total = [x + coefficient * y for x, y in zip(total, entries, strict=True)]
            power = product * power
        return total


def _is_gamma(x: AlgebraicNumber, gamma: AlgebraicNumber) -> bool:
    """Whether x, known to be ±γ, is γ."""
    return x.minimal_polynomial == gamma.minimal_polynomial and x.region.overlaps(gamma.region)
