"""The polynomials that a scheme in several variables reproduces, and with which parameters."""

from __future__ import annotations

from fractions import Fraction
from math import prod
from typing import NamedTuple

from subdiv_cli.kinds.multivariate.lattice import Lattice, indices_of_degree
from subdiv_cli.kinds.multivariate.scheme import Index, MultivariateScheme


class Reproduction(NamedTuple):
    """S maps p(· + σ) to p(M^-1 (· + σ)), (M - I) σ = τ, for the polynomials p of this total degree."""

    degree: int
    shift: tuple[Fraction, ...]
    """τ."""
    defect: Index | None
    """A μ, |μ| = degree + 1, with Σ a_α α^μ ≠ m τ^μ; None where the generation degree is not larger."""


def reproduction(scheme: MultivariateScheme, lattice: Lattice, generation: int) -> Reproduction:
    """The largest degree, for a scheme that generates polynomials of degree `generation` >= 0 and no higher one."""
    m, s = lattice.index, lattice.dimension
    tau = tuple(moment(scheme, tuple(int(i == j) for i in range(s))) / m for j in range(s))
    for degree in range(2, generation + 1):
        for mu in indices_of_degree(s, degree):
            if moment(scheme, mu) != m * _power(tau, mu):
                return Reproduction(degree - 1, tau, mu)
    return Reproduction(generation, tau, None)


def moment(scheme: MultivariateScheme, mu: Index) -> Fraction:
    """Σ_α a_α α^μ."""
    return sum((value * prod(map(pow, alpha, mu)) for alpha, value in scheme.terms.items()), Fraction(0))


def _power(x: tuple[Fraction, ...], mu: Index) -> Fraction:
    return prod((t**n for t, n in zip(x, mu, strict=True)), start=Fraction(1))
