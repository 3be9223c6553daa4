"""Real roots of integer polynomials, counted between two bounds, without floats and without floating algebra.

Vincent, Collins & Akritas: the roots of f in (0, 1) are at most as many as (1+t)^n f(1/(1+t)) has changes of sign
(Descartes), and where that is 0 or 1 exactly as many; otherwise the interval is halved. For the root of a polynomial
that an expectation names this tells at once in nearly all cases.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from subdiv_cli.model import Root

_MOST_PIECES = 64
"""Intervals that are looked at: those around a multiple root would never end."""


def roots_between(coefficients: Sequence[int], low: Fraction, high: Fraction) -> int | None:
    """How many different roots a polynomial, lowest power first, has in [low, high]; None where it is hard to tell."""
    if low == high:
        return int(not _shifted(coefficients, low, Fraction(0))[0])
    waiting = [_shifted(coefficients, low, high - low)]
    count = int(not sum(waiting[0]))  # at high
    for _ in range(_MOST_PIECES):
        if not waiting:
            return count
        f = waiting.pop()
        if not f[0]:
            count += 1
            while not f[0]:
                f = f[1:]
        if (changes := _changes(_shifted(f[::-1], Fraction(1), Fraction(1)))) > 1:
            half = [c << (len(f) - 1 - i) for i, c in enumerate(f)]
            waiting += [half, _shifted(half, Fraction(1), Fraction(1))]
        else:
            count += changes
    return None


def _shifted(f: Sequence[int], start: Fraction, length: Fraction) -> list[int]:
    """f(start + length t) times a positive integer, by Horner's rule."""
    unit = start.denominator * length.denominator
    a, b = int(start * unit), int(length * unit)
    result, power = [f[-1]], 1
    for c in reversed(f[:-1]):
        power *= unit
        scaled = [a * x for x in result] + [0]
        for i, x in enumerate(result):
            scaled[i + 1] += b * x
        scaled[0] += c * power
        result = scaled
    return result


def _changes(f: Sequence[int]) -> int:
    signs = [c > 0 for c in f if c]
    return sum(x is not y for x, y in pairwise(signs))


def multiplied(root: Root, factor: Fraction) -> Root:
    """The root times a number that is not zero."""
    n = len(root.coefficients) - 1
    p, q = factor.as_integer_ratio()
    coefficients = tuple(c * q**i * p ** (n - i) for i, c in enumerate(root.coefficients))
    ends = sorted((root.low * factor, root.high * factor))
    return Root(coefficients, ends[0], ends[1])


def inverse(root: Root) -> Root:
    """One over the root, whose bounds have one sign."""
    ends = sorted((1 / root.low, 1 / root.high))
    return Root(root.coefficients[::-1], ends[0], ends[1])
