"""Polynomials under a scalar scheme: residue sums, sum rules, generation and reproduction degrees.

The operator Q that inverts S^∞ on polynomials (Levin 2.5): moments, operator, stencil, eigen-sequences.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import factorial, perm

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.exact.linalg import matrix, solution


def residue_sums(a: Laurent, p: int) -> tuple[Fraction, ...]:
    """The p residue sums Σ_β a_(γ+pβ) for γ = 0, …, p-1 (Dyn 2.7)."""
    return tuple(component(1) for component in a.components(p))


def sum_rules(a: Laurent, p: int) -> tuple[int, Laurent, Laurent]:
    """The order k of sum rules, the cofactor q, and the remainder r ≠ 0 of q by one more smoothing factor.

    a = (1+z+…+z^(p-1))^k q with the largest k. Needs a ≠ 0; the sum rules of order k hold in the usual sense where
    a(1) = p.
    """
    order = 0
    while True:
        quotient, remainder = a.divide(smoothing_factor(p))
        if remainder.poly:
            return order, a, remainder
        a, order = quotient, order + 1


def parameter_shift(a: Laurent, p: int) -> Fraction:
    """The shift τ = a'(1)/p: the value of level j with index i belongs to the parameter (i + τ/(p-1)) / p^j."""
    return a.derivatives_at_one(2)[1] / p


def reproduction_defects(a: Laurent, p: int, degree: int) -> tuple[Fraction, ...]:
    """The numbers a^(j)(1) - p·Π_(i<j) (τ - i) for j = 0, …, degree.

    All are zero iff π_degree is reproduced, where it is generated.
    """
    tau = parameter_shift(a, p)
    defects, expected = [], Fraction(p)
    for j, derivative in enumerate(a.derivatives_at_one(degree + 1)):
        defects.append(derivative - expected)
        expected *= tau - j
    return tuple(defects)


Rationals = tuple[Fraction, ...]


def moments(values: Laurent, count: int) -> Rationals:
    """The moments m_i = Σ_β φ(-β) β^i for i < count, from φ at the integers.

    S^∞ f = Σ m_i/i! D^i f on polynomials.
    """
    terms = [(-(values.low + place), value) for place, value in enumerate(values.coefficients())]
    return tuple(sum((value * beta**i for beta, value in terms), Fraction(0)) for i in range(count))


def operator(m: Sequence[Fraction]) -> Rationals:
    """The coefficients q_0, … of the operator Q f = Σ q_i D^i f, which inverts Σ m_i/i! D^i; m_0 = 1.

    On polynomials of degree below len(m).
    """
    q: list[Fraction] = []
    for i in range(len(m)):
        known = sum((m[i - j] / factorial(i - j) * q[j] for j in range(i)), Fraction(0))
        q.append(Fraction(int(i == 0)) - known)
    return tuple(q)


def eigen_sequence(q: Sequence[Fraction], degree: int) -> Rationals:
    """The coefficients of Q x^degree, lowest power first: its samples are mapped by S to p^-degree times them."""
    return tuple(q[degree - i] * perm(degree, degree - i) for i in range(degree + 1))


def stencil(q: Sequence[Fraction], symmetric: bool) -> Laurent:
    """The shortest stencil t with Q f(i) = Σ_j t_j f(i+j) on polynomials of degree below len(q), near the centre of φ.

    That centre is at q_1 = -m_1. Where it is an integer or a half and φ is symmetric, t is symmetric about it; else
    its nodes are the consecutive integers nearest to it. There is one with as many nodes as q has numbers, by
    interpolation, or one more where only that number is symmetric; ArithmeticError would mean that this is wrong.
    """
    centre = q[1] if len(q) > 1 else Fraction(0)
    symmetric = symmetric and (2 * centre).denominator == 1
    for count in range(1, len(q) + 2):
        first = centre - Fraction(count - 1, 2)
        if symmetric and first.denominator > 1:
            continue
        nodes = range(round(first), round(first) + count)
        if (weights := _weights(q, nodes, symmetric)) is not None:
            return Laurent.from_coefficients(nodes[0], weights)
    raise ArithmeticError("no stencil with enough nodes")


def _weights(q: Sequence[Fraction], nodes: range, symmetric: bool) -> Rationals | None:
    """The weights with Σ t_j j^i = i! q_i for all i, equal in pairs where symmetric; None if there are none."""
    count = len(nodes)
    rows = [[Fraction(j) ** i for j in nodes] for i in range(len(q))]
    right = [factorial(i) * c for i, c in enumerate(q)]
    if symmetric:
        for place in range(count // 2):
            rows.append([Fraction(int(j == place) - int(j == count - 1 - place)) for j in range(count)])
            right.append(Fraction(0))
    return solution(matrix(rows), right)
