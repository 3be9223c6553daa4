"""Sums of a mask over the cosets of Z^s / M Z^s, and its sum rules of total degree."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.multivariate.lattice import Lattice, indices_of_degree
from subdiv_cli.kinds.multivariate.scheme import Index, MultivariateScheme

HIGHEST_ORDER = 40
"""Of sum rules that are looked for."""


def coset_sums(scheme: MultivariateScheme, lattice: Lattice, mu: Index) -> tuple[Fraction, ...]:
    """Σ_β a_(γ+Mβ) (γ+Mβ)^μ for each representative γ."""
    sums = {lattice.coset(gamma): Fraction(0) for gamma in lattice.representatives}
    for alpha, value in scheme.terms.items():
        power = 1
        for x, e in zip(alpha, mu, strict=True):
            power *= x**e
        sums[lattice.coset(alpha)] += value * power
    return tuple(sums[lattice.coset(gamma)] for gamma in lattice.representatives)


def sum_rule_order(scheme: MultivariateScheme, lattice: Lattice) -> int:
    """The largest k <= HIGHEST_ORDER with sum rules of order k: for |μ| < k the coset sums with (γ+Mβ)^μ are the same

    for all cosets, those of the mask itself 1. 0 where these are not.
    """
    s = lattice.dimension
    if set(coset_sums(scheme, lattice, (0,) * s)) != {Fraction(1)}:
        return 0
    for k in range(1, HIGHEST_ORDER):
        if any(len(set(coset_sums(scheme, lattice, mu))) > 1 for mu in indices_of_degree(s, k)):
            return k
    return HIGHEST_ORDER
