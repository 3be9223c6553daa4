"""A complex root of an integer polynomial, isolated by a disc: that there is one, its modulus, and values at it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb, lcm
from typing import NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.polynomials import remainder
from subdiv_cli.checker.radius.eigenvectors import Vector
from subdiv_cli.checker.reading import Rejected, require
from subdiv_cli.checker.roots import RealRoot, fraction_bits

MAX_CONJUGATES = 12
"""The most conjugates of μ: the polynomial of all products of two of them has half the square of this degree."""

Complex = tuple[Fraction, Fraction]


class Disc(NamedTuple):
    """A complex number μ, the only root of the polynomial in |z - center| <= distance; not real."""

    polynomial: tuple[int, ...]
    center: Complex
    distance: Fraction

    def enclosed(self, c: Claim, x: Vector, bits: int) -> tuple[list[int], int]:
        """The integers v, those of Re x and then those of Im x, and ε with |2^bits x_i - v_i| <= ε for all of them.

        At the center the value is exact; the true one differs by at most distance Σ_k k |x_k| (|center| +
        distance)^(k-1), because |μ^k - z^k| <= |μ - z| k max(|μ|, |z|)^(k-1). One unit more for the rounding down.
        """
        (a, b), r, order = self.center, self.distance, len(x.powers[0])
        size = abs(a) + abs(b) + r
        c.spend(4 * order * len(x.powers), x.bits + len(x.powers) * (fraction_bits(a) + fraction_bits(b)))
        powers: list[Complex] = [(Fraction(1), Fraction(0))]
        for _ in x.powers[1:]:
            p, q = powers[-1]
            powers.append((p * a - q * b, p * b + q * a))
        halves = [
            [
                sum((v[i] * power[part] for v, power in zip(x.powers, powers, strict=True)), Fraction(0))
                for i in range(order)
            ]
            for part in (0, 1)
        ]
        slope = sum((k * max(map(abs, v)) * size ** (k - 1) for k, v in enumerate(x.powers) if k), Fraction(0))
        scaled = [int((y * (1 << bits) / x.denominator) // 1) for half in halves for y in half]
        return scaled, int(r * slope * (1 << bits) / x.denominator) + 2


def read_disc(c: Claim, factor: Sequence[int], center: Sequence[Fraction], distance: Fraction) -> Disc:
    """The disc around an eigenvalue. Raises Rejected unless it isolates one root, which is not real (Rouché).

    With the Taylor coefficients t_k of f at the center, |t_0| + Σ_(k>1) |t_k| r^k < |t_1| r on the circle makes f and
    t_1 (z - center) have equally many zeros in it: one. Moduli are at least the larger and at most the sum of the
    absolute values of real and imaginary part.
    """
    f, d, r = tuple(factor), len(factor) - 1, distance
    require(2 <= d <= MAX_CONJUGATES and f[-1] != 0, "the eigenvalue's polynomial is of too low or too high a degree")
    require(len(center) == 2 and r > 0, "the center is not a pair, or the distance not positive")
    a, b = center
    require(abs(b) > r, "the eigenvalue may be real")
    bits = max(map(abs, f)).bit_length() + d * (fraction_bits(a) + fraction_bits(b) + fraction_bits(r))
    c.spend(d**3, bits)
    taylor = [_taylor(f, (a, b), k) for k in range(d + 1)]
    above = sum(((abs(x) + abs(y)) * r**k for k, (x, y) in enumerate(taylor) if k != 1), Fraction(0))
    require(above < max(map(abs, taylor[1])) * r, "the disc does not isolate a root")
    return Disc(f, (a, b), r)


def _taylor(f: Sequence[int], z: Complex, k: int) -> Complex:
    """The Taylor coefficient f^(k)(z)/k!, by Horner's rule."""
    x, y = Fraction(0), Fraction(0)
    for j in range(len(f) - 1, k - 1, -1):
        x, y = x * z[0] - y * z[1] + comb(j, k) * f[j], x * z[1] + y * z[0]
    return x, y


def modulus_is(c: Claim, disc: Disc, root: RealRoot) -> bool:
    """Whether |μ|² = Λ, m the polynomial of Λ.

    |μ|² = μ μ̄ is a zero of P, whose zeros are the products of two conjugates; P = m h, and h vanishes nowhere on an
    interval that |μ|² lies in, so that m does at |μ|²; and in [low, high], or anywhere if it is of degree 1, it has
    no other zero than Λ.
    """
    (a, b), r, m = disc.center, disc.distance, root.polynomial
    square, slack = a * a + b * b, 2 * (abs(a) + abs(b)) * r + r * r
    if root.rational is None and not root.low <= square - slack <= square + slack <= root.high:
        return False
    d = len(disc.polynomial) - 1
    c.spend(d**5, d * d * max(map(abs, disc.polynomial)).bit_length())
    products = products_of_pairs(disc.polynomial)
    h = quotient(products, m)
    value = sum((x * square**k for k, x in enumerate(h)), Fraction(0))
    change = slack * sum((k * abs(x) * (square + slack) ** (k - 1) for k, x in enumerate(h) if k), Fraction(0))
    return abs(value) > change


def products_of_pairs(f: Sequence[int]) -> list[Fraction]:
    """The coefficients of P = Σ_k P_k z^k with the zeros x_i x_j, i < j, x_i those of f, by Newton's identities.

    With the power sums p_k of the x_i those of the products are (p_k² - p_(2k))/2.
    """
    d = len(f) - 1
    count = d * (d - 1) // 2
    e = [Fraction((-1) ** i * f[d - i], f[d]) for i in range(d + 1)]
    sums = [Fraction(d)]
    for k in range(1, 2 * count + 1):
        total = sum(((-1) ** (i - 1) * e[i] * sums[k - i] for i in range(1, min(k - 1, d) + 1)), Fraction(0))
        sums.append(total + ((-1) ** (k - 1) * k * e[k] if k <= d else 0))
    pairs = [(sums[k] ** 2 - sums[2 * k]) / 2 for k in range(count + 1)]
    elementary = [Fraction(1)]
    for k in range(1, count + 1):
        elementary.append(
            sum(((-1) ** (i - 1) * elementary[k - i] * pairs[i] for i in range(1, k + 1)), Fraction(0)) / k
        )
    return [(-1) ** (count - k) * elementary[count - k] for k in range(count + 1)]


def quotient(f: Sequence[Fraction], g: Sequence[int]) -> list[Fraction]:
    """The quotient f/g, lowest power first. Raises Rejected where g does not divide f."""
    common = lcm(*(x.denominator for x in f))
    if remainder([x.numerator * (common // x.denominator) for x in f], g):
        raise Rejected("the root's polynomial does not divide that of the products of conjugates")
    rest, result = list(f), [Fraction(0)] * (len(f) - len(g) + 1)
    for k in range(len(result) - 1, -1, -1):
        result[k] = rest[k + len(g) - 1] / g[-1]
        for j, x in enumerate(g):
            rest[k + j] -= result[k] * x
    return result
