"""The mean-square growth of the k-th differences of a scheme in several variables.

With a^[L] the mask of S^L and C(k; μ) the multinomial coefficients, let N_L = m^-L Σ_(|μ|=k) C(k; μ) ‖a^[L] * ∇^μ δ‖².
For b = a * a(-·), the autocorrelation of the mask, and its transition operator (T v)(α) = Σ_β b(Mα-β) v(β),

    N_L = (G^L w)(0),  G = T/m,  w(z) = (Σ_j (1 - z_j)(1 - 1/z_j))^k,

as T^L v is b^[L] * v on the lattice M^L Z^s, and w is the sum of the autocorrelations of the ∇^μ δ with these weights.
All G^L w are positive definite sequences, so N_L is the largest of the numbers |(G^L w)(α)|; hence the spectral radius
of G on the span W of all G^L w is λ = lim sup N_L^(1/L), and by Pringsheim's theorem on Σ N_L z^L it is an eigenvalue.
It is the largest real zero of the minimal polynomial of w, and all zeros of that lie in |z| <= λ.

W is not the space of all autocorrelations that T leaves invariant, and the window is not the smallest invariant one: it
holds w, without which differences that cross windows would not count (the bilinear B-spline would have s = 2).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import lcm
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly

from subdiv_cli.kinds.multivariate.numbers.box_spline import multiplied
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth, simple_growth
from subdiv_cli.model import Effort
from subdiv_cli.spaces.lattice import Index, Lattice

LARGEST_WINDOW = 4000
LARGEST_DEGREE = 120
"""The largest degree of a minimal polynomial."""
_PRIME = (1 << 61) - 1


class MeanSquares(NamedTuple):
    """The growth of the sequences G^L w of a scheme, and the size of its operator."""

    window: int
    """The number of indices that they need."""
    pairs: int
    """The number of entries of G on the window that are not zero."""
    growth: Growth | None
    """The growth λ; f c is the minimal polynomial of w. None where λ is a multiple zero of it."""


def mean_squares(scheme: MultivariateScheme, lattice: Lattice, k: int, effort: Effort) -> MeanSquares | None:
    """The growth of mean squares for differences of order k; None where window, dimension or effort do not suffice.

    Raises ClockStruckError.
    """
    start = laplacian_power(lattice.dimension, k, effort)
    t = correlation_operator(scheme, lattice, start, effort)
    if t is None:
        return None
    annihilator = minimal_polynomial(t, [int(start.get(alpha, 0)) for alpha in t.window], effort)
    if annihilator is None:
        return None
    scale = fmpq(t.denominator * lattice.index)
    d = annihilator.degree()
    of_g = fmpq_poly([c * scale**j for j, c in enumerate(annihilator)]) / scale**d
    return MeanSquares(len(t.window), sum(map(len, t.columns)), simple_growth(of_g))


def autocorrelation(scheme: MultivariateScheme) -> dict[Index, Fraction]:
    """The autocorrelation b(z) = a(z) a(1/z) of the mask."""
    return multiplied(scheme.terms, {tuple(-x for x in alpha): value for alpha, value in scheme.terms.items()})


def laplacian_power(s: int, k: int, effort: Effort) -> dict[Index, Fraction]:
    """The coefficients of w(z) = (Σ_j (2 - z_j - 1/z_j))^k. Raises ClockStruckError."""
    once = {(0,) * s: Fraction(2 * s)}
    for j in range(s):
        for sign in (1, -1):
            once[tuple(sign * (i == j) for i in range(s))] = Fraction(-1)
    power = {(0,) * s: Fraction(1)}
    for _ in range(k):
        effort.look()
        power = multiplied(power, once)
    return power


class SparseOperator(NamedTuple):
    """The operator T on sequences over a window that it maps to such, times a denominator."""

    window: tuple[Index, ...]
    columns: tuple[tuple[tuple[int, int], ...], ...]
    """The places and numerators of the image for each index of the window."""
    denominator: int

    def image(self, v: Sequence[int]) -> list[int]:
        """The numerators of T v."""
        image = [0] * len(v)
        for x, column in zip(v, self.columns, strict=True):
            if x:
                for place, numerator in column:
                    image[place] += x * numerator
        return image


def correlation_operator(
    scheme: MultivariateScheme, lattice: Lattice, start: Iterable[Index], effort: Effort
) -> SparseOperator | None:
    """The operator T on the smallest window that it maps to itself and that holds the start; None if too large.

    Raises ClockStruckError.
    """
    b = autocorrelation(scheme)
    common = lcm(*(x.denominator for x in b.values()))
    by_coset: dict[Index, list[tuple[Index, int]]] = {}
    for gamma, x in b.items():
        by_coset.setdefault(lattice.coset(gamma), []).append((gamma, int(x * common)))
    places = {beta: j for j, beta in enumerate(start)}
    queue, columns = list(places), []
    for beta in queue:  # grows
        effort.look()
        column = []
        for gamma, numerator in by_coset.get(lattice.coset(tuple(-x for x in beta)), ()):
            alpha = lattice.preimage(tuple(x + y for x, y in zip(beta, gamma, strict=True)))
            assert alpha is not None
            if alpha not in places:
                places[alpha] = len(queue)
                queue.append(alpha)
            column.append((places[alpha], numerator))
        columns.append(tuple(column))
        if len(queue) > LARGEST_WINDOW:
            return None
    return SparseOperator(tuple(queue), tuple(columns), common)


def minimal_polynomial(t: SparseOperator, w: list[int], effort: Effort) -> fmpq_poly | None:
    """The monic f of the smallest degree with f(t) w = 0, w ≠ 0; None beyond the largest degree or the effort.

    The degree is computed modulo a prime, f over Q. Raises ArithmeticError for a prime that misleads, ClockStruckError.
    """
    vectors, rows = [w], _IndependentRows()
    while rows.take(vectors[-1]):
        if len(vectors) > LARGEST_DEGREE or not effort.allows(len(vectors) * len(w) // 4):
            return None
        vectors.append(t.image(vectors[-1]))
    effort.look()
    known, last = vectors[:-1], vectors[-1]
    matrix = fmpq_mat([[v[i] for v in known] for i in rows.pivots])
    solved = [x for (x,) in matrix.solve(fmpq_mat([[last[i]] for i in rows.pivots])).table()]
    if fmpq_mat([solved]) * fmpq_mat(known) != fmpq_mat([last]):
        raise ArithmeticError("vectors are dependent modulo a prime and not over Q")
    return fmpq_poly([*(-x for x in solved), 1])


class _IndependentRows:
    """The vectors of an echelon form modulo a prime."""

    def __init__(self) -> None:
        self.pivots: list[int] = []
        self._rows: list[list[int]] = []

    def take(self, vector: Sequence[int]) -> bool:
        """Whether the vector is independent of those before it; then it is one of them."""
        rest = [x % _PRIME for x in vector]
        for pivot, row in zip(self.pivots, self._rows, strict=True):
            if f := rest[pivot]:
                rest = [(x - f * y) % _PRIME for x, y in zip(rest, row, strict=True)]
        pivot = next((i for i, x in enumerate(rest) if x), -1)
        if pivot < 0:
            return False
        inverse = pow(rest[pivot], -1, _PRIME)
        self.pivots.append(pivot)
        self._rows.append([inverse * x % _PRIME for x in rest])
        return True
