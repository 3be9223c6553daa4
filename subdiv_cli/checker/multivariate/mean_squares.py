"""The rule on the Sobolev exponent of masks on Z^s. See FORMAT.md.

b(z) = a(z) a(1/z), (G v)(α) = (1/m) Σ_β b(Mα-β) v(β), w(z) = (Σ_j (2 - z_j - 1/z_j))^k, k the order of the sum rules,
λ = m^(1/s). N_L = (G^L w)(0) is m^-L times a sum of squares of the differences of order k of the mask of S^L.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.multivariate.lattice import Index, Sparse, add, multiply
from subdiv_cli.checker.multivariate.masks import SparseMask, mask_of
from subdiv_cli.checker.reading import MAX_LENGTH, MAX_ORDER, require
from subdiv_cli.checker.scalar.sobolev import count_growth, degree_of_annihilator, require_growth


def sobolev(c: Claim) -> None:
    """The exponent is at least -log_λ(Λ)/2, and that for stable φ, Λ = lim sup N_L^(1/L) the only zero of f in [x, y].

    All G^L w are positive definite, so N_L is the largest of their entries in modulus.
    """
    a = mask_of(c)
    require(a.dilation.is_isotropic(), "the dilation is not seen to be isotropic")
    k = c.use("total-sum-rules").statement["order"]
    require(k >= 1, "the sum rules are of order 0")
    if c.statement["property"] == "sobolev":
        c.use("stable", holds=True)
    degree = degree_of_annihilator(c)
    require(degree <= MAX_ORDER, f"the polynomials are of degree {degree}")
    s, t = a.dilation.dimension, len(a.terms)
    first = t**2 + k * (2 * s + 1) * (2 * k + 1) ** s
    c.count(first, 2 * a.bits)
    start = _laplacian_power(s, k)
    operator = _operator(c, a, start)
    step = 2 * a.bits + 2 * t.bit_length() + a.dilation.cosets.bit_length()
    count_growth(c, first + (degree + 1) * (operator.pairs + 4 * len(operator.window)), degree, step + 2 * s * k)
    v = [start.get(index, 0) for index in operator.window]
    require_growth(c, operator.image, v, a.dilation.cosets * a.denominator**2)


class _Operator(NamedTuple):
    """The operator m G, times the denominator of b, on a window that it does not leave."""

    window: list[Index]
    """The indices of the window, 0 first."""
    columns: list[list[tuple[int, int]]]
    """The places and numerators of the image for every index of the window."""

    @property
    def pairs(self) -> int:
        return sum(map(len, self.columns))

    def image(self, v: list[int]) -> list[int]:
        total = [0] * len(v)
        for x, column in zip(v, self.columns, strict=True):
            if x:
                for place, numerator in column:
                    total[place] += x * numerator
        return total


def _operator(c: Claim, a: SparseMask, start: Mapping[Index, int]) -> _Operator:
    """The operator G on the least window with the support of the start that it does not leave."""
    residue, divided = a.dilation.residue, a.dilation.divided
    by_residue: dict[Index, list[tuple[Index, int]]] = {}
    for index, numerator in multiply(a.terms, {tuple(-i for i in x): value for x, value in a.terms.items()}).items():
        by_residue.setdefault(residue(index), []).append((index, numerator))
    zero = (0,) * a.dilation.dimension
    window = [zero, *(index for index in start if index != zero)]
    places = {index: place for place, index in enumerate(window)}
    columns: list[list[tuple[int, int]]] = []
    for beta in window:  # it grows
        column = []
        near = by_residue.get(residue([-i for i in beta]), ())
        c.spend(1 + len(near), 0)
        for index, numerator in near:
            alpha = divided(add(beta, index))
            if alpha not in places:
                places[alpha] = len(window)
                window.append(alpha)
            column.append((places[alpha], numerator))
        columns.append(column)
        require(len(window) <= MAX_LENGTH, "the window is too large")
    return _Operator(window, columns)


def _laplacian_power(s: int, k: int) -> Sparse:
    """The coefficients of w(z) = (Σ_j (2 - z_j - 1/z_j))^k."""
    units = [tuple(int(i == j) for i in range(s)) for j in range(s)]
    once = {(0,) * s: 2 * s} | dict.fromkeys([*units, *(tuple(-i for i in x) for x in units)], -1)
    power = {(0,) * s: 1}
    for _ in range(k):
        power = multiply(power, once)
    return power
