"""Roots of integer polynomials: that an interval isolates one, and enclosures of the root and of its powers -1/ℓ."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.checker.core import Claim, Statement
from subdiv_cli.checker.polynomials import sturm_count, value
from subdiv_cli.checker.reading import require


class RealRoot(NamedTuple):
    """A positive number Λ, the only real root of the polynomial in [low, high], 0 < low."""

    polynomial: tuple[int, ...]
    low: Fraction
    high: Fraction

    @property
    def rational(self) -> Fraction | None:
        """The number Λ where the polynomial is of degree 1, else None."""
        return Fraction(-self.polynomial[0], self.polynomial[1]) if len(self.polynomial) == 2 else None


def root_of(s: Statement) -> RealRoot:
    """The root in a statement, not checked."""
    return RealRoot(s["polynomial"], s["low"], s["high"])


def isolated_root(c: Claim) -> RealRoot:
    """The root that the claim's statement names. Raises Rejected unless there is exactly one.

    Beyond degree 1 the polynomial changes its sign, and it is monotone between, or by Sturm has one distinct real root.
    """
    m, low, high = root = root_of(c.statement)
    d = len(m) - 1
    require(d >= 1 and m[-1] != 0, "the root's polynomial is constant or has no leading coefficient")
    require(0 < low <= high, "the root's interval is empty or not positive")
    if (exact := root.rational) is not None:
        require(low <= exact <= high, "the root is not in its interval")
        return root
    size, more = max(map(abs, m)).bit_length(), d * max(fraction_bits(low), fraction_bits(high))
    c.spend(9 * d, size + more)
    require(value(m, low) * value(m, high) < 0, "the root's polynomial does not change its sign in the interval")
    if not _is_monotone(m, low, high):
        c.spend(d**3, (d + 1) * size + more)
        require(sturm_count(m, low, high) == 1, "the root's interval does not have exactly one root")
    return root


def _is_monotone(m: Sequence[int], low: Fraction, high: Fraction) -> bool:
    """Whether m' is certainly not zero in [low, high], 0 < low: |m'(low)| > (high - low) Σ k(k-1)|m_k| high^(k-2)."""
    d, width = len(m) - 1, high - low
    slope = [k * x for k, x in enumerate(m)][1:]
    bend = [k * abs(x) for k, x in enumerate(slope)][1:]
    left = abs(value(slope, low)) * high.denominator ** (d - 2) * width.denominator
    return bool(left > width.numerator * value(bend, high) * low.denominator ** (d - 1))


def fraction_bits(x: Fraction) -> int:
    """The bits of numerator and denominator together."""
    return x.numerator.bit_length() + x.denominator.bit_length()


class Enclosure(NamedTuple):
    """An interval [low, low + width]/scale around Λ, all integers, low > 0."""

    low: int
    width: int
    scale: int


def enclose(c: Claim, root: RealRoot, bits: int) -> Enclosure:
    """The interval around Λ of width 2^-bits, or Λ exactly where its polynomial is of degree 1."""
    if (exact := root.rational) is not None:
        return Enclosure(exact.numerator, 0, exact.denominator)
    m, d, scale = root.polynomial, len(root.polynomial) - 1, 1 << bits
    size = d * (bits + int(root.high).bit_length()) + max(map(abs, m)).bit_length()
    c.spend(3 * d, size)
    rising = 1 if value(m, root.high) > 0 else -1
    scaled = [(rising * x) << (bits * (d - k)) for k, x in enumerate(m)]

    def at(x: int) -> int:
        """A positive multiple of ± m(x/scale): negative left of Λ, positive right of it."""
        c.spend(d, size)
        return value(scaled, x)

    a, b = -(-root.low.numerator * scale // root.low.denominator), int(root.high * scale)
    if a > b or at(a) >= 0:
        low = a - 1  # low scale > a - 1; and where a > b, high scale < a
    elif at(b) <= 0:
        low = b
    else:
        low = _bracket(at, a, b)
    require(low > 0, "the enclosure of the root is not positive")
    return Enclosure(low, 1, scale)


class _Bracket(NamedTuple):
    """A bracket of integers a < b and the values there, left <= 0 < right."""

    a: int
    b: int
    left: int
    right: int

    def probed(self, at: Callable[[int], int], x: int) -> _Bracket:
        """The part of the bracket, cut at x, where the sign changes; x may lie outside."""
        if not self.a < x < self.b:
            return self
        y = at(x)
        return self._replace(a=x, left=y) if y <= 0 else self._replace(b=x, right=y)


def _bracket(at: Callable[[int], int], a: int, b: int) -> int:
    """The integer x in [a, b) with at(x) <= 0 < at(x + 1), from at(a) < 0 < at(b).

    The bracket shrinks to a part of it around the zero of the chord, to smaller and smaller parts as long as that
    works, and to a half where it does not. How x is reached matters to the time alone: signs are exact.
    """
    bracket, parts = _Bracket(a, b, at(a), at(b)), 4
    while (width := bracket.b - bracket.a) > 1:
        step, guess = max(1, width // parts), bracket.a - width * bracket.left // (bracket.right - bracket.left)
        bracket = bracket.probed(at, guess - step).probed(at, guess + step)
        parts = parts * parts if 2 * (bracket.b - bracket.a) <= width else 4
        if parts == 4:
            bracket = bracket.probed(at, (bracket.a + bracket.b) // 2)
    return bracket.a


def root_below(x: int, n: int) -> int:
    """The integer ⌊x^(1/n)⌋ for x >= 0, n >= 1, by Newton's method.

    It starts above the root, from the root of the leading half of the digits, and falls until it falls no more: for y
    above the root the next y is not below it (Bernoulli).
    """
    if n == 1 or x < 2:
        return x
    bits = x.bit_length() // n
    half = (bits - n.bit_length()) // 2
    y = (root_below(x >> (n * half), n) + 1) << half if half > 2 else 1 << (bits + 1)
    while (z := ((n - 1) * y + x // y ** (n - 1)) // n) < y:
        y = z
    return y


class Scale(NamedTuple):
    """An enclosure of 1/σ = Λ^(-1/ℓ) in [value, value + error]/2^bits."""

    bits: int
    value: int
    error: int


def inverse_scale(c: Claim, at: Enclosure, length: int, bits: int) -> Scale:
    """The enclosure of 1/σ, from 2^(bits length)/Λ: its root from below, and by powers how far the one above is."""
    shifted = at.scale << (bits * length)
    c.spend(64 + 2 * length.bit_length(), shifted.bit_length())
    value, above, error = root_below(shifted // (at.low + at.width), length), -(-shifted // at.low), 1
    while (value + error) ** length < above:
        c.spend(2 * length.bit_length(), shifted.bit_length())
        error *= 2
    return Scale(bits, value, error)
