"""Laurent polynomials with integer coefficients over a common denominator, and exact decisions on their zeros.

Plain coefficient lists are integers, lowest power first.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise, zip_longest
from math import gcd, lcm
from struct import unpack
from typing import NamedTuple


class Polynomial(NamedTuple):
    """The polynomial Σ_k numerators[k] z^(start+k) / denominator in lowest terms, both ends non-zero; () for zero."""

    start: int
    numerators: tuple[int, ...]
    denominator: int

    @property
    def length(self) -> int:
        """The degree plus one, the start not counted."""
        return len(self.numerators)

    @property
    def bits(self) -> int:
        """The bits of the longest numerator and of the denominator together."""
        return max(map(abs, self.numerators), default=0).bit_length() + self.denominator.bit_length()

    def at(self, exponent: int) -> int:
        """The numerator of the coefficient of z^exponent."""
        k = exponent - self.start
        return self.numerators[k] if 0 <= k < len(self.numerators) else 0

    def sum_is(self, value: int) -> bool:
        """Whether the polynomial takes this value at z = 1."""
        return sum(self.numerators) == value * self.denominator


def polynomial(start: int, numerators: Sequence[int], denominator: int) -> Polynomial:
    """The polynomial in its normal form: two polynomials are equal iff they are the same tuple."""
    first, end = 0, len(numerators)
    while end and not numerators[end - 1]:
        end -= 1
    if not end:
        return Polynomial(0, (), 1)
    while not numerators[first]:
        first += 1
    if (common := gcd(denominator, *numerators)) == 1:
        return Polynomial(start + first, tuple(numerators[first:end]), denominator)
    return Polynomial(start + first, tuple([c // common for c in numerators[first:end]]), denominator // common)


def over_common_denominator(start: int, pairs: Sequence[tuple[int, int]], most_bits: int) -> Polynomial | None:
    """The polynomial with the coefficients p/q of these pairs; None for a common denominator above most_bits."""
    common = 1
    for _, q in pairs:
        common = lcm(common, q)
        if common.bit_length() > most_bits:
            return None
    return polynomial(start, [p * (common // q) for p, q in pairs], common)


def multiply(f: Polynomial, g: Polynomial) -> Polynomial:
    """The product f(z) g(z)."""
    product = [0] * (f.length + g.length)
    for i, x in enumerate(f.numerators):
        for j, y in enumerate(g.numerators, i):
            product[j] += x * y
    return polynomial(f.start + g.start, product, f.denominator * g.denominator)


def add(f: Polynomial, g: Polynomial) -> Polynomial:
    """The sum f(z) + g(z)."""
    if not f.numerators or not g.numerators:
        return f if f.numerators else g
    start = min(f.start, g.start)
    end = max(f.start + f.length, g.start + g.length)
    total = [f.at(i) * g.denominator + g.at(i) * f.denominator for i in range(start, end)]
    return polynomial(start, total, f.denominator * g.denominator)


def times(f: Polynomial, numerator: int, denominator: int = 1, shift: int = 0) -> Polynomial:
    """The polynomial f(z) z^shift · numerator/denominator."""
    return polynomial(f.start + shift, [numerator * c for c in f.numerators], f.denominator * denominator)


def times_sigma(f: Polynomial, p: int, power: int) -> Polynomial:
    """The polynomial f(z) (1 + z + … + z^(p-1))^power."""
    numerators = list(f.numerators)
    for _ in range(power):
        numerators = [sum(numerators[max(0, i - p + 1) : i + 1]) for i in range(len(numerators) + p - 1)]
    return polynomial(f.start, numerators, f.denominator)


def spread(f: Polynomial, p: int) -> Polynomial:
    """The polynomial f(z^p)."""
    numerators = [0] * (p * f.length)
    numerators[::p] = f.numerators
    return polynomial(p * f.start, numerators, f.denominator)


def classes(f: Polynomial, p: int) -> list[tuple[int, ...]]:
    """The numerators at the exponents ≡ r mod p, lowest first, for r = 0, …, p-1."""
    return [f.numerators[(r - f.start) % p :: p] for r in range(p)]


def components(f: Polynomial, p: int) -> list[Polynomial]:
    """The polyphase components f_0, …, f_(p-1) with f(z) = Σ_r z^r f_r(z^p)."""
    first = [f.start + (r - f.start) % p for r in range(p)]
    return [polynomial((first[r] - r) // p, numerators, f.denominator) for r, numerators in enumerate(classes(f, p))]


def sigma_divides(f: Polynomial, p: int) -> bool:
    """Whether σ = 1 + z + … + z^(p-1) divides f: whether its residue sums are equal.

    Modulo z^p - 1 the multiples of σ are its constant multiples.
    """
    return len({sum(numerators) for numerators in classes(f, p)}) == 1


def slot_bits(f: Polynomial, level: int) -> int:
    """The bits for any coefficient of a product of `level` factors with these numerators: whole bytes, at least 8."""
    return max(64, 8 * ((level * sum(map(abs, f.numerators)).bit_length() + 2 + 7) // 8))


def iterated_norm(f: Polynomial, p: int, level: int) -> int:
    """The norm max_γ Σ_β |F_(γ + p^L β)| for F(z) = Π_(j<L) f(z^(p^j)), f by its numerators only."""
    magnitudes = iterated_magnitudes(f, p, level)
    rows = [magnitudes[i : i + p**level] for i in range(0, len(magnitudes), p**level)]
    return max(map(sum, zip_longest(*rows, fillvalue=0)))


def iterated_magnitudes(f: Polynomial, p: int, level: int) -> list[int]:
    """The absolute values of the coefficients of F, the lowest first.

    F is kept as the one integer F(2^w), w so large that its coefficients can be read off in the end.
    """
    width = slot_bits(f, level)
    packed, length = 1, 1
    for j in range(level):
        step = width * p**j
        packed = sum((c * packed) << (i * step) for i, c in enumerate(f.numerators) if c)
        length += (f.length - 1) * p**j
    size, half = width // 8, 1 << (width - 1)
    packed += int.from_bytes((bytes(size - 1) + b"\x80") * length, "little")
    data = packed.to_bytes(size * length, "little")
    if size == 8:
        slots: Sequence[int] = unpack(f"<{length}Q", data)
    else:
        slots = [int.from_bytes(data[i : i + size], "little") for i in range(0, len(data), size)]
    return [abs(slot - half) for slot in slots]


def remainder(f: Sequence[int], g: Sequence[int]) -> list[int]:
    """A positive multiple of the remainder of f by g ≠ 0, without its content; [] for zero."""
    rest, lead, sign = list(f), abs(g[-1]), 1 if g[-1] > 0 else -1
    while len(rest) >= len(g):
        top, shift = sign * rest[-1], len(rest) - len(g)
        rest = [lead * c for c in rest]
        for i, c in enumerate(g, shift):
            rest[i] -= top * c
        while rest and not rest[-1]:
            rest.pop()
    common = gcd(*rest)
    return [c // common for c in rest]


def greatest_common_divisor(f: Sequence[int], g: Sequence[int]) -> list[int]:
    """The greatest common divisor of two polynomials, up to a constant factor."""
    a, b = list(f), list(g)
    while b:
        a, b = b, remainder(a, b)
    return a


def divides(g: Polynomial, fs: Iterable[Polynomial]) -> bool:
    """Whether g ≠ 0 divides every one of fs, powers of z aside."""
    return all(not remainder(f.numerators, g.numerators) for f in fs)


def vanishes_on_circle(g: Polynomial) -> bool:
    """Whether g ≠ 0 has a zero on |z| = 1.

    Such zeros are zeros of the reverse too, hence of h, the common divisor, which is ± its own reverse. If
    h(1) ≠ 0 ≠ h(-1), it is its own reverse and of even degree 2e, and z^-e h(z) = H(z + 1/z).
    """
    h = greatest_common_divisor(g.numerators, g.numerators[::-1])
    if not sum(h) or not sum(h[::2]) - sum(h[1::2]):
        return True
    return sturm_count(on_circle(h), -2, 2) > 0


def on_circle(h: Sequence[int]) -> list[int]:
    """The polynomial H with z^-e h(z) = H(z + 1/z), for h of degree 2e that is its own reverse; lowest power first."""
    e = len(h) // 2
    total, before, now = [h[e]], [2], [0, 1]
    for c in h[e + 1 :]:
        total = [x + c * t for x, t in zip_longest(total, now, fillvalue=0)]
        before, now = now, [x - y for x, y in zip_longest([0, *now], before, fillvalue=0)]
    return total


def sturm_count(f: Sequence[int], left: Fraction | int, right: Fraction | int) -> int:
    """The number of distinct real zeros of f in (left, right]; f(left) ≠ 0, or f has no multiple zeros.

    Where f(left) = 0 is simple, f and f' have the same sign just right of it, which is what leaving out the zero says.
    """
    chain = [list(f), [i * c for i, c in enumerate(f)][1:]]
    while chain[-1]:
        chain.append([-c for c in remainder(chain[-2], chain[-1])])
    return _sign_changes(chain, left) - _sign_changes(chain, right)


def count_zeros(f: Sequence[int], left: Fraction | int, right: Fraction | int) -> int:
    """The number of distinct real zeros of f ≠ 0 in [left, right]."""
    simple = quotient(f, greatest_common_divisor(f, [i * c for i, c in enumerate(f)][1:]))
    return sturm_count(simple, left, right) + (value(simple, left) == 0)


def value(f: Sequence[int], x: Fraction | int) -> int:
    """The integer f(x) v^n, n the length of f less one, v > 0 the denominator of x: it has the sign of f(x)."""
    u, v = x.numerator, x.denominator
    total, power = 0, 1
    for c in reversed(f):
        total, power = total * u + c * power, power * v
    return total


def quotient(f: Sequence[int], g: Sequence[int]) -> list[int]:
    """A multiple of f/g, without its content, where g ≠ 0 divides f over Q."""
    rest, result, lead = list(f), [0] * (len(f) - len(g) + 1), g[-1]
    for shift in range(len(result) - 1, -1, -1):
        top = rest[shift + len(g) - 1]
        rest = [lead * c for c in rest]
        result = [lead * c for c in result]
        result[shift] = top
        for i, c in enumerate(g, shift):
            rest[i] -= top * c
    common = gcd(*result)
    return [c // common for c in result]


def _sign_changes(chain: Sequence[Sequence[int]], x: Fraction | int) -> int:
    values = [v for v in (value(f, x) for f in chain) if v]
    return sum((u > 0) != (v > 0) for u, v in pairwise(values))


def totients(last: int) -> list[int]:
    """The values φ(0), …, φ(last) of Euler's function; φ(0) is set to 0."""
    phi = list(range(last + 1))
    for q in range(2, last + 1):
        if phi[q] == q:
            for multiple in range(q, last + 1, q):
                phi[multiple] -= phi[multiple] // q
    return phi


def is_cycle(a: Polynomial, n: int, p: int) -> bool:
    """Whether Φ_n(z^p)/Φ_n(z) = Π_(d|p, d>1) Φ_(nd)(z) divides a ≠ 0, for n > 1 coprime to p."""
    return all(cyclotomic_divides(n * d, a) for d in range(2, p + 1) if p % d == 0)


def cyclotomic_divides(m: int, a: Polynomial) -> bool:
    """Whether Φ_m divides a: iff z^m - 1 divides a(z) Π_(q|m prime) (z^(m/q) - 1).

    The factors vanish at the m-th roots of unity that are not primitive, and only there. An identity of integer
    polynomials, so it is tried at z = 2 first.
    """
    steps = [m // q for q in prime_factors(m)]
    value = sum(c << i for i, c in enumerate(a.numerators))
    for step in steps:
        value *= (1 << step) - 1
    if value % ((1 << m) - 1):
        return False
    folded = [sum(a.numerators[i::m]) for i in range(m)]
    for step in steps:
        folded = [x - y for x, y in zip(folded[-step:] + folded[:-step], folded, strict=True)]
    return not any(folded)


def prime_factors(m: int) -> list[int]:
    """The primes that divide m > 0."""
    primes, q = [], 2
    while q * q <= m:
        if m % q == 0:
            primes.append(q)
            while m % q == 0:
                m //= q
        q += 1
    return [*primes, m] if m > 1 else primes
