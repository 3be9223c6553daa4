"""Sums of a mask over the cosets of Z^s / M Z^s, and its sum rules of total degree.

The polynomials that a scheme in several variables reproduces, and with which parameters.

The operator Q that inverts S^∞ on polynomials in several variables (Levin 2.5): moments, operator, stencil.

On polynomials of total degree <= d, which the sum rules of order d + 1 make S map to such, S^∞ = Σ m_μ/μ! D^μ and
Q = Σ q_μ D^μ. As power series, h(θ) = Σ m_μ/μ! θ^μ, of S^∞ exp(θ·x) = h(θ) exp(θ·x), and q = 1/h up to degree d;
S exp(θ·x) = H(M^-T θ) exp(θ·M^-1 x), H(ω) = Σ a_α exp(-α·ω)/m, so S^∞ S = σ S^∞ says h(M^T ω) = H(ω) h(ω).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import count, product
from math import ceil, factorial, floor, lcm, prod
from operator import mul
from typing import NamedTuple

from subdiv_cli.exact.linalg import matrix, solution
from subdiv_cli.kinds.multivariate.numbers.symmetries import generated
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort
from subdiv_cli.spaces.lattice import Index, IntMatrix, Lattice, indices_of_degree, multiple_of_identity, times


def coset_sums(scheme: MultivariateScheme, lattice: Lattice) -> tuple[Fraction, ...]:
    """The sums Σ_β a_(γ+Mβ) for each representative γ."""
    sums = {lattice.coset(gamma): Fraction(0) for gamma in lattice.representatives}
    for alpha, value in scheme.terms.items():
        sums[lattice.coset(alpha)] += value
    return tuple(sums[lattice.coset(gamma)] for gamma in lattice.representatives)


def sum_rule_order(scheme: MultivariateScheme, lattice: Lattice, effort: Effort) -> int:
    """The largest k with sum rules of order k; 0 where the coset sums of the mask are not 1.

    For |μ| < k the coset sums with (γ+Mβ)^μ are the same for all cosets, those of the mask itself 1. Polynomials of
    degree < k are so wherever their origin is: the corner of the support, which keeps numbers short. Raises
    ClockStruckError.
    """
    if set(coset_sums(scheme, lattice)) != {Fraction(1)}:
        return 0
    lowest, _ = scheme.bounds()
    common = lcm(*(x.denominator for x in scheme.terms.values()))
    cosets: dict[Index, dict[Index, int]] = {}
    for alpha, x in scheme.terms.items():
        place = tuple(i - low for i, low in zip(alpha, lowest, strict=True))
        cosets.setdefault(lattice.coset(alpha), {})[place] = x.numerator * (common // x.denominator)
    sums = [_PowerSums(terms) for terms in cosets.values()]
    for k in count(1):
        for mu in indices_of_degree(lattice.dimension, k):
            effort.look()
            if len({coset.of(mu) for coset in sums}) > 1:
                return k
    raise AssertionError("no finite mask has sum rules of all orders")


class _PowerSums:
    """The sums Σ a_α α^μ of the terms of one coset, variable by variable: what several μ share is summed once."""

    def __init__(self, terms: Mapping[Index, int]) -> None:
        self._known: dict[Index, Mapping[Index, int]] = {(): terms}

    def of(self, mu: Index) -> int:
        """The sum with α^μ."""
        return self._folded(mu)[()]

    def _folded(self, mu: Index) -> Mapping[Index, int]:
        """The sums over the last variables, as many as μ has, by the indices in the others."""
        if mu not in self._known:
            folded: dict[Index, int] = {}
            for (*others, last), x in self._folded(mu[1:]).items():
                folded[tuple(others)] = folded.get(tuple(others), 0) + x * last ** mu[0]
            self._known[mu] = folded
        return self._known[mu]


class Reproduction(NamedTuple):
    """The reproduction degree: S maps p(· + σ) to p(M^-1 (· + σ)), (M - I) σ = τ, for the p of this total degree."""

    degree: int
    shift: tuple[Fraction, ...]
    """The shift τ."""
    defect: Index | None
    """A μ, |μ| = degree + 1, with Σ a_α α^μ ≠ m τ^μ; None where the generation degree is not larger."""


def reproduction(scheme: MultivariateScheme, lattice: Lattice, generation: int) -> Reproduction:
    """The reproduction degree of a scheme that generates polynomials of degree `generation` >= 0 and no higher one."""
    m, s = lattice.index, lattice.dimension
    tau = tuple(moment(scheme, tuple(int(i == j) for i in range(s))) / m for j in range(s))
    for degree in range(2, generation + 1):
        for mu in indices_of_degree(s, degree):
            if moment(scheme, mu) != m * _power(tau, mu):
                return Reproduction(degree - 1, tau, mu)
    return Reproduction(generation, tau, None)


def moment(scheme: MultivariateScheme, mu: Index) -> Fraction:
    """The moment Σ_α a_α α^μ of the mask."""
    return sum((value * prod(map(pow, alpha, mu)) for alpha, value in scheme.terms.items()), Fraction(0))


def _power(x: tuple[Fraction, ...], mu: Index) -> Fraction:
    return prod((t**n for t, n in zip(x, mu, strict=True)), start=Fraction(1))


Series = Mapping[Index, Fraction]
"""A power series: μ -> the coefficient of θ^μ; what is not there is zero."""
Point = tuple[Fraction, ...]

_LARGEST_ENTRY = 100
"""The largest entry of a symmetry."""


class QuasiInterpolation(NamedTuple):
    """The operator Q on the polynomials of total degree at most `degree`; what is zero is left out."""

    degree: int
    centre: Point
    """The centre c = (q_e1, …, q_es) of φ."""
    moments: Series
    """The moments m_μ = Σ_β φ(-β) β^μ, |μ| <= degree."""
    operator: Series
    """The coefficients q_μ of Q = Σ q_μ D^μ."""
    centred: Series
    """The coefficients of the operator f -> Q f(· - c), which has no terms of first order."""
    stencil: Mapping[Index, Fraction]
    """The stencil t with Q f(α) = Σ_j t_j f(α + j)."""


def quasi_interpolation(
    scheme: MultivariateScheme, lattice: Lattice, degree: int, symmetries: Sequence[IntMatrix]
) -> QuasiInterpolation:
    """The operator Q of a scheme that converges and has sum rules of an order above `degree` >= 0.

    `symmetries` are those of the mask.
    """
    h = expansion(scheme, lattice, degree)
    q = inverse(h, lattice.dimension, degree)
    c = tuple(q.get(unit, Fraction(0)) for unit in multiple_of_identity(1, lattice.dimension))
    t = stencil(q, degree, c, symmetries_of_limits(lattice.dilation, symmetries))
    m = {mu: c * prod(map(factorial, mu)) for mu, c in h.items()}
    return QuasiInterpolation(degree, c, m, q, moved(q, c, degree), t)


def expansion(scheme: MultivariateScheme, lattice: Lattice, degree: int) -> dict[Index, Fraction]:
    """The series h, degree by degree: h_j(M^T ω) - h_j(ω) = Σ_(i<j) H_(j-i)(ω) h_i(ω), h_0 = 1.

    On the homogeneous polynomials of degree j >= 1 the eigenvalues of p -> p(M^T ·) are products of j ones of M, all
    beyond 1 in modulus: there is one solution.
    """
    s = lattice.dimension
    symbol = _symbol(scheme, lattice, degree)
    h = {(0,) * s: Fraction(1)}
    images = {(0,) * s: {(0,) * s: 1}}
    for j in range(1, degree + 1):
        powers = list(indices_of_degree(s, j))
        right = [sum((h[nu] * symbol[x] for nu, x in _splits(mu, h) if x in symbol), Fraction(0)) for mu in powers]
        images = {mu: _turned(mu, images, lattice.dilation) for mu in powers}
        rows = [[images[nu].get(mu, 0) - (mu == nu) for nu in powers] for mu in powers]
        values = solution(matrix(rows), right)
        assert values is not None, "M is expanding"
        h |= {mu: x for mu, x in zip(powers, values, strict=True) if x}
    return h


def _symbol(scheme: MultivariateScheme, lattice: Lattice, degree: int) -> dict[Index, Fraction]:
    """The coefficients of H, those that are not zero."""
    denominator = lcm(*(x.denominator for x in scheme.terms.values()))
    terms = [(alpha, x.numerator * (denominator // x.denominator)) for alpha, x in scheme.terms.items()]
    series = {}
    for j in range(degree + 1):
        for mu in indices_of_degree(lattice.dimension, j):
            if total := sum(x * prod(map(pow, alpha, mu)) for alpha, x in terms):
                series[mu] = Fraction((-1) ** j * total, lattice.index * denominator * prod(map(factorial, mu)))
    return series


def _turned(mu: Index, images: Mapping[Index, Mapping[Index, int]], rows: IntMatrix) -> dict[Index, int]:
    """The polynomial (M^T ω)^μ, by that of μ less one: a further factor Σ_l M_li ω_l."""
    i = next(i for i, x in enumerate(mu) if x)
    product: dict[Index, int] = {}
    for nu, x in images[_raised(mu, i, -1)].items():
        for l, row in enumerate(rows):
            if row[i]:
                at = _raised(nu, l, 1)
                product[at] = product.get(at, 0) + x * row[i]
    return product


def _raised(mu: Index, i: int, by: int) -> Index:
    return (*mu[:i], mu[i] + by, *mu[i + 1 :])


def _splits(mu: Index, known: Series) -> Iterator[tuple[Index, Index]]:
    """The pairs of ν <= μ in `known` and μ - ν, with μ - ν ≠ 0."""
    for nu in known:
        rest = tuple(x - y for x, y in zip(mu, nu, strict=True))
        if min(rest) >= 0 and any(rest):
            yield nu, rest


def inverse(h: Series, dimension: int, degree: int) -> dict[Index, Fraction]:
    """The series 1/h up to this degree; h has the constant 1."""
    q = {(0,) * dimension: Fraction(1)}
    for j in range(1, degree + 1):
        for mu in indices_of_degree(dimension, j):
            if c := sum((q[nu] * h[rest] for nu, rest in _splits(mu, q) if rest in h), Fraction(0)):
                q[mu] = -c
    return q


def moved(q: Series, c: Point, degree: int) -> dict[Index, Fraction]:
    """The series exp(-c·θ) q(θ) up to this degree."""
    if not any(c):
        return dict(q)
    product: dict[Index, Fraction] = {}
    for j in range(degree + 1):
        for nu in indices_of_degree(len(c), j):
            x = prod(((-a) ** n / factorial(n) for a, n in zip(c, nu, strict=True)), start=Fraction(1))
            for mu, y in q.items() if x else ():
                if j + sum(mu) <= degree:
                    at = tuple(a + b for a, b in zip(mu, nu, strict=True))
                    product[at] = product.get(at, Fraction(0)) + x * y
    return {mu: x for mu, x in product.items() if x}


def symmetries_of_limits(dilation: IntMatrix, symmetries: Sequence[IntMatrix]) -> tuple[IntMatrix, ...]:
    """A group of integer matrices g with φ(g x + t) = φ(x) for some t: for S that converges.

    The largest set G of symmetries of the mask with M^-1 G M = G, and all their products. φ^(ω) = Π_(l>=1) H(M^-Tl ω)
    and M^-Tl g^T = (M^l g M^-l)^T M^-Tl, so a g in G changes each factor by a factor exp(i t·ω). φ is continuous and
    not zero, so such matrices keep a body that is compact, and there are finitely many.
    """
    kept = set(symmetries)
    while True:
        images = {times(dilation, f) for f in kept}
        turned = {g for g in kept if times(g, dilation) in images}
        if turned == kept:
            return tuple(sorted(generated(sorted(kept), _Small())))
        kept = turned


class _Small:
    """The matrices without large entries: a finite group has no others, and without a limit there is an end as well."""

    def __contains__(self, g: object) -> bool:
        return isinstance(g, tuple) and max(abs(x) for row in g for x in row) <= _LARGEST_ENTRY


def stencil(q: Series, degree: int, centre: Point, group: Sequence[IntMatrix]) -> dict[Index, Fraction]:
    """The stencil t with Q f(α) = Σ_j t_j f(α + j) on polynomials of total degree at most `degree`.

    Σ_j t_j j^μ = μ! q_μ. It lies about the centre c of φ. t is invariant under the symmetries of φ about c, those of
    them that map Z^s to itself: the indices are taken by whole orbits, the nearest ones first and none that is of no
    use. "Near" is in the largest coordinate of the orbit about c, and then in the sum of squares. ArithmeticError would
    mean that no stencil exists.
    """
    powers = [mu for j in range(degree + 1) for mu in indices_of_degree(len(centre), j)]
    right = [q.get(mu, Fraction(0)) * prod(map(factorial, mu)) for mu in powers]
    for reach in range(8 * (degree + 1)):
        orbits = _orbits(centre, group, reach + Fraction(1, 2))
        rows = [[sum(prod(map(pow, j, mu)) for j in orbit) for orbit in orbits] for mu in powers]
        weights = solution(matrix(rows), right) if orbits else None
        if weights is not None:
            pairs = zip(orbits, weights, strict=True)
            return dict(sorted((j, weight) for orbit, weight in pairs if weight for j in orbit))
    raise ArithmeticError("no stencil with enough nodes")


def _orbits(centre: Point, group: Sequence[IntMatrix], reach: Fraction) -> list[list[Index]]:
    """The orbits of all j with all coordinates of g(j - c) at most `reach`, in order.

    By the g about c that map Z^s to itself.
    """
    scale = lcm(*(c.denominator for c in centre))
    c = [int(x * scale) for x in centre]
    own = [g for g in group if not any((x - y) % scale for x, y in zip(c, _image(g, c), strict=True))]
    sides = [range(ceil(x - reach), floor(x + reach) + 1) for x in centre]
    seen: set[Index] = set()
    orbits = []
    for j in product(*sides):
        if j in seen:
            continue
        about = [scale * x - y for x, y in zip(j, c, strict=True)]
        images = {_image(g, about) for g in own}
        orbit = sorted(tuple([(x + y) // scale for x, y in zip(image, c, strict=True)]) for image in images)
        seen |= set(orbit)
        furthest = max(abs(x) for image in images for x in image)
        if furthest <= scale * reach:
            squares = Fraction(sum(x * x for image in images for x in image), len(images))
            orbits.append((furthest, squares, orbit))
    return [orbit for *_, orbit in sorted(orbits)]


def _image(g: IntMatrix, x: Sequence[int]) -> Index:
    return tuple([sum(map(mul, row, x)) for row in g])
