"""Polynomials under a scalar scheme: residue sums, sum rules, generation and reproduction degrees."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.exact.laurent import Laurent, smoothing_factor


def residue_sums(a: Laurent, p: int) -> tuple[Fraction, ...]:
    """Σ_β a_(γ+pβ) for γ = 0, …, p-1 (Dyn 2.7)."""
    return tuple(component(1) for component in a.components(p))


def sum_rules(a: Laurent, p: int) -> tuple[int, Laurent, Laurent]:
    """(k, q, r): a = (1+z+…+z^(p-1))^k q with the largest k, and the remainder r ≠ 0 of q by one more factor.

    Needs a ≠ 0; the sum rules of order k hold in the usual sense where a(1) = p.
    """
    order = 0
    while True:
        quotient, remainder = a.divide(smoothing_factor(p))
        if remainder.poly:
            return order, a, remainder
        a, order = quotient, order + 1


def parameter_shift(a: Laurent, p: int) -> Fraction:
    """τ = a'(1)/p: the value of level j with index i belongs to the parameter (i + τ/(p-1)) / p^j."""
    return a.derivatives_at_one(2)[1] / p


def reproduction_defects(a: Laurent, p: int, degree: int) -> tuple[Fraction, ...]:
    """a^(j)(1) - p·Π_(i<j) (τ - i) for j = 0, …, degree; all zero iff π_degree is reproduced, where it is generated."""
    tau = parameter_shift(a, p)
    defects, expected = [], Fraction(p)
    for j, derivative in enumerate(a.derivatives_at_one(degree + 1)):
        defects.append(derivative - expected)
        expected *= tau - j
    return tuple(defects)
