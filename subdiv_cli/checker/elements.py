"""Numbers in Q[Λ], as polynomials in Λ with the constant first: products, values, and what is zero modulo m(Λ) = 0."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm

from subdiv_cli.checker.polynomials import remainder
from subdiv_cli.checker.roots import Enclosure, fraction_bits

Element = Sequence[Fraction]


def element_bits(x: Element) -> int:
    return sum(map(fraction_bits, x))


def longest_numerator(x: Element) -> int:
    """In bits."""
    return max((c.numerator.bit_length() for c in x), default=0)


def times(x: Element, y: Element) -> Element:
    product = [Fraction(0)] * (len(x) + len(y) - 1)
    for i, a in enumerate(x):
        for j, b in enumerate(y):
            product[i + j] += a * b
    return product


def power(x: Element, n: int, m: Sequence[int]) -> Element:
    """x^n, of a degree below that of m where n >= 1."""
    result: Element = [Fraction(1)]
    for _ in range(n):
        result = _reduced(times(result, x), m)
    return result


def _reduced(x: Element, m: Sequence[int]) -> Element:
    rest = list(x)
    while len(rest) >= len(m):
        top = rest.pop() / m[-1]
        for k, c in enumerate(m[:-1], len(rest) - len(m) + 1):
            rest[k] -= top * c
    return rest


def is_zero(x: Element, m: Sequence[int]) -> bool:
    """Whether m divides x: then it is zero at Λ."""
    common = lcm(*(c.denominator for c in x))
    numerators = [c.numerator * (common // c.denominator) for c in x]
    while numerators and not numerators[-1]:
        numerators.pop()
    return not remainder(numerators, m)


def bounds(x: Element, at: Enclosure) -> tuple[Fraction, Fraction]:
    """low <= x(Λ) <= high: the value at the lower end a/q, and Λ is at most w/q away.

    |x'| is at most Σ_k k |x_k| ((a + w)/q)^(k-1) between.
    """
    low, high = Fraction(at.low, at.scale), Fraction(at.low + at.width, at.scale)
    value = slope = Fraction(0)
    for k in range(len(x) - 1, -1, -1):
        value = value * low + x[k]
        slope = slope * high + k * abs(x[k]) if k else slope
    error = (high - low) * slope
    return value - error, value + error
