"""Vectors with coordinates in Q[Λ], Λ the root of an integer polynomial m: exact, and enclosed in fixed point."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, isqrt, lcm
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker.matrices import Matrix, apply
from subdiv_cli.checker.polynomials import remainder
from subdiv_cli.checker.roots import Enclosure


def size_of_leader(
    start: Sequence[int], letters: int, family_bits: int, g: Sequence[int], scale: Fraction, m: Sequence[int]
) -> list[tuple[int, int]]:
    """The operations of a product and its `leading_eigenvector`, with the bits of their numbers.

    The argument start is y; g has the numerators of the annihilator, of degree n, and then their common denominator. A
    step of the product lengthens its numbers by those of the family, one of the eigenvector by those of the product,
    one modulo m by those of m. Powers of E take as much as multiplying by them; in the end each number is divided by a
    common divisor.
    """
    order, n, d, steps = len(start), len(g) - 2, len(m) - 1, max(0, len(g) - len(m))
    product = letters * (family_bits + order.bit_length())
    annihilator = max(map(abs, g)).bit_length()
    modulus = max(map(abs, m)).bit_length() + 1
    rest = annihilator + steps * modulus
    powers = n * (product + order.bit_length()) + annihilator + max(map(abs, start)).bit_length()
    scaled, denominator = powers + scale.numerator.bit_length(), powers + scale.denominator.bit_length()
    reduced = scaled + steps * modulus
    return [
        (letters * order**3, _mean(product, family_bits)),
        (order**2, product),
        (steps * (n + d + 2), _mean(rest, modulus)),
        (d, rest),
        (n * order**2, _mean(powers, product)),
        (n * (order + 3), scaled // 2),
        (steps * (n + d) * order, _mean(reduced, modulus)),
        (min(n, d) * order, reduced),
        (2, denominator + steps * modulus),
    ]


def _mean(x: int, y: int) -> int:
    """A length such that its square takes what the product of a number of x bits and one of y takes."""
    return isqrt((512 + x) * (512 + y)) - 512


class Vector(NamedTuple):
    """The vector Σ_k Λ^k powers[k] / denominator with integer vectors for 0 <= k < d, d the degree of m.

    The denominator is positive.
    """

    powers: list[list[int]]
    denominator: int

    @property
    def bits(self) -> int:
        """The bits of the longest coordinate and of the denominator together."""
        return max(max(map(abs, v)) for v in self.powers).bit_length() + self.denominator.bit_length()

    def image(self, matrix: Matrix, denominator: int) -> Vector:
        """The image of the vector under the matrix over this denominator."""
        return Vector([apply(matrix, v) for v in self.powers], self.denominator * denominator)

    def reflected(self) -> Vector:
        """The vector J x, its coordinates in reverse."""
        return Vector([v[::-1] for v in self.powers], self.denominator)


def leading_eigenvector(
    product: tuple[Matrix, int],
    g: Sequence[Fraction],
    sign: int,
    start: Sequence[int],
    scale: Fraction,
    m: Sequence[int],
) -> Vector | None:
    """The vector x = scale h(Π) y from the start y, h(z) = (g(z) - g(μ))/(z - μ), μ = sign Λ, g(μ) = 0.

    None unless (Π - μ) x = scale g(Π) y is zero. Π = P/E. (g(z) - g(t))/(z - t) = Σ_k t^k w_k(z) with w_(n-1) = g_n,
    w_(k-1) = z w_k + g_k, and w_(-1) would be g. Kept are the vectors c E^(n-1-k) w_k(Π) y, c the common denominator
    of g: integers.
    """
    p, e = product
    n, c = len(g) - 1, lcm(*(x.denominator for x in g))
    w, powers = [0] * len(p), []
    for k, x in enumerate(reversed(g)):
        factor = x.numerator * (c // x.denominator) * e**k
        w = [y + factor * t for y, t in zip(apply(p, w), start, strict=True)]
        powers.append(w)
    if any(powers.pop()):
        return None
    factors = ((sign * e) ** k * scale.numerator for k in range(n))
    powers = [[factor * x for x in w] for factor, w in zip(factors, reversed(powers), strict=True)]
    return _reduced(powers, scale.denominator * c * e ** (n - 1), m)


def _reduced(powers: list[list[int]], denominator: int, m: Sequence[int]) -> Vector:
    """The vector modulo m: Λ^k = -(m_0 Λ^(k-d) + … + m_(d-1) Λ^(k-1)) / m_d."""
    d, lead = len(m) - 1, m[-1]
    while len(powers) > d:
        top = powers.pop()
        powers = [[lead * x for x in v] for v in powers]
        for k, c in enumerate(m[:-1], len(powers) - d):
            powers[k] = [x - c * y for x, y in zip(powers[k], top, strict=True)]
        denominator *= lead
    common = gcd(denominator, *(gcd(*v) for v in powers)) * (1 if denominator > 0 else -1)
    return Vector([[x // common for x in v] for v in powers], denominator // common)


def slope_bits(x: Vector, high: Fraction) -> int:
    """The bits of an upper bound of Σ_k k |x_k| high^(k-1).

    Λ must be known to so many bits more than a coordinate.
    """
    per_power = max(0, high.numerator.bit_length() - high.denominator.bit_length() + 1)
    largest = [max(map(abs, v)).bit_length() + k.bit_length() + k * per_power for k, v in enumerate(x.powers) if k]
    return max(0, max(largest, default=0) + len(largest).bit_length() - x.denominator.bit_length() + 1)


def enclosed(x: Vector, at: Enclosure, bits: int) -> tuple[list[int], int]:
    """The integers v and ε with |2^bits x_i - v_i| <= ε for all i.

    With Λ in [a, a + w]/q the value at a/q is exact, Σ_k x_k a^k q^(d-1-k) / (denominator q^(d-1)), and the true one
    differs by at most w/q Σ_k k |x_k| ((a + w)/q)^(k-1) / denominator. One unit more for each rounding down.
    """
    a, w, q = at
    d = len(x.powers)
    values = [a**k * q ** (d - 1 - k) for k in range(d)]
    slopes = [w * k * (a + w) ** max(0, k - 1) * q ** (d - 1 - k) for k in range(d)]
    below = x.denominator * q ** (d - 1)
    coordinates = list(zip(*x.powers, strict=True))
    steepest = max(sum(map(mul, map(abs, c), slopes)) for c in coordinates)
    return [(sum(map(mul, c, values)) << bits) // below for c in coordinates], (steepest << bits) // below + 2


Terms = Sequence[tuple[Sequence[Fraction], Vector]]


def common_denominator(terms: Terms) -> int:
    """The common denominator of all products of a coefficient and a coordinate."""
    return lcm(*(c.denominator * x.denominator for cs, x in terms for c in cs))


def nonzero_coordinates(terms: Terms, m: Sequence[int]) -> list[int]:
    """The coordinates of Σ c(z) x(z), over terms (c, x), that m does not divide: the others are zero at Λ."""
    unequal, common = [], common_denominator(terms)
    length = max(len(cs) for cs, _ in terms) + len(m)
    factors = [([c.numerator * (common // (c.denominator * x.denominator)) for c in cs], x) for cs, x in terms]
    for i in range(len(terms[0][1].powers[0])):
        total = [0] * length
        for cs, x in factors:
            for j, c in enumerate(cs):
                if c:
                    for k, v in enumerate(x.powers, j):
                        total[k] += c * v[i]
        while total and not total[-1]:
            total.pop()
        if total and remainder(total, m):
            unequal.append(i)
    return unequal
