"""Laurent polynomials over Q, small and bounded: integer numerators over one common denominator.

The variables are z and, in several of them, z1 to z4. The exponents of a monomial are the digits of one integer
(Kronecker's substitution): those of z itself are plain integers, products add, and the order of the integers is a
monomial order. The digits stay far below half of their base, so they are read off again without carries.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from heapq import heappop, heappush
from math import gcd, lcm

from subdiv_cli.maskfile.bounds import MAX_BITS, MAX_DIGITS, MAX_EXPONENT, MAX_MASK_LENGTH, MAX_WORK

VARIABLES = ("z", "z1", "z2", "z3", "z4")
_DIGIT = 24
_HALF = 1 << (_DIGIT - 1)


class TooLargeError(Exception):
    """Raised where a bound is reached; the message names the bound."""


class Work:
    """The cost of the expressions of one file so far, in products of small integers."""

    __slots__ = ("_spent",)

    def __init__(self) -> None:
        self._spent = 0

    def charge(self, products: int, bits_a: int = 1, bits_b: int = 1) -> None:
        """Add the cost of products of integers of that many bits. Raises TooLargeError beyond MAX_WORK."""
        self._spent += products * (1 + (bits_a // 30) * (bits_b // 30) // 100)
        if self._spent > MAX_WORK:
            raise TooLargeError("multiplying this out takes too long")


class BoundedLaurent:
    """The Laurent polynomial Σ numerators[k] z^k / denominator: no zero numerators, denominator > 0, lowest terms.

    k is an exponent of z, or `packed` from those of several variables.
    """

    __slots__ = ("bits", "denominator", "numerators")

    def __init__(self, numerators: Mapping[int, int], denominator: int = 1) -> None:
        kept = {k: n for k, n in numerators.items() if n}
        if denominator > 1:
            common = denominator
            for n in kept.values():
                if common == 1:
                    break
                common = gcd(common, n)
            if common > 1:
                kept = {k: n // common for k, n in kept.items()}
                denominator //= common
        self.numerators = kept
        self.denominator = denominator
        self.bits = max([denominator.bit_length(), *(n.bit_length() for n in kept.values())])
        if len(kept) > MAX_MASK_LENGTH:
            raise TooLargeError(f"a Laurent polynomial of more than {MAX_MASK_LENGTH} terms")
        if self.bits > MAX_BITS:
            raise TooLargeError(f"numbers of more than {MAX_DIGITS} digits come up")
        if kept and max(max(kept), -min(kept)) > MAX_EXPONENT:
            _bound(max(max(map(abs, exponents(k))) for k in kept))

    @property
    def coefficients(self) -> dict[int, Fraction]:
        """The non-zero coefficients by their exponents of z."""
        return {k: Fraction(n, self.denominator) for k, n in self.numerators.items()}

    def terms(self, dimension: int) -> dict[tuple[int, ...], Fraction]:
        """The non-zero coefficients by their exponents of z1, …, zs, for a polynomial in these."""
        return {exponents(k)[1 : dimension + 1]: value for k, value in self.coefficients.items()}

    def constant(self) -> Fraction | None:
        """The number that the polynomial is; None where z is in it."""
        if any(self.numerators):
            return None
        return Fraction(self.numerators.get(0, 0), self.denominator)


def packed(powers: Iterable[int]) -> int:
    """The monomial z^k0 z1^k1 z2^k2 … as one integer; each |k| at most 2 MAX_EXPONENT."""
    return sum(k << (_DIGIT * i) for i, k in enumerate(powers))


def exponents(k: int) -> tuple[int, ...]:
    """The exponents of z, z1, … z4 in a monomial."""
    digits = []
    for _ in VARIABLES:
        digit = ((k + _HALF) & (2 * _HALF - 1)) - _HALF
        digits.append(digit)
        k = (k - digit) >> _DIGIT
    return tuple(digits)


def _bound(exponent: int) -> None:
    if exponent > MAX_EXPONENT:
        raise TooLargeError(f"an exponent of z beyond {MAX_EXPONENT}")


def constant(value: Fraction) -> BoundedLaurent:
    """The constant polynomial of a number. Raises TooLargeError."""
    return BoundedLaurent({0: value.numerator}, value.denominator)


def total(terms: Iterable[tuple[int, BoundedLaurent]], work: Work) -> BoundedLaurent:
    """The sum Σ sign · term. Raises TooLargeError."""
    numerators: dict[int, int] = {}
    denominator = 1
    for sign, term in terms:
        common = lcm(denominator, term.denominator)
        if common.bit_length() > MAX_BITS:
            raise TooLargeError(f"a common denominator of more than {MAX_DIGITS} digits")
        if common != denominator:
            work.charge(len(numerators), MAX_BITS, common.bit_length() - denominator.bit_length())
            scale = common // denominator
            numerators = {k: n * scale for k, n in numerators.items()}
            denominator = common
        factor = sign * (common // term.denominator)
        work.charge(30 + len(term.numerators), term.bits, factor.bit_length())
        for k, n in term.numerators.items():
            numerators[k] = numerators.get(k, 0) + factor * n
    return BoundedLaurent(numerators, denominator)


def times(a: BoundedLaurent, b: BoundedLaurent, work: Work) -> BoundedLaurent:
    """The product a · b. Raises TooLargeError."""
    work.charge(30 + len(a.numerators) * len(b.numerators), a.bits, b.bits)
    numerators: dict[int, int] = {}
    for j, m in a.numerators.items():
        for k, n in b.numerators.items():
            numerators[j + k] = numerators.get(j + k, 0) + m * n
    return BoundedLaurent(numerators, a.denominator * b.denominator)


def inverse(a: BoundedLaurent) -> BoundedLaurent | None:
    """The inverse 1/a of a monomial c z^k, c ≠ 0; None for anything else."""
    if len(a.numerators) != 1:
        return None
    ((k, n),) = a.numerators.items()
    return BoundedLaurent({-k: a.denominator if n > 0 else -a.denominator}, abs(n))


def quotient(a: BoundedLaurent, b: BoundedLaurent, work: Work) -> BoundedLaurent | None:
    """The quotient a / b for b ≠ 0; None where it is no Laurent polynomial. Raises TooLargeError.

    Long division from the lowest monomial, in integers: a polynomial with integer coefficients that a primitive one
    divides has an integer quotient (Gauss). The box of the exponents of a product is the sum of those of its factors.
    """
    content = gcd(*b.numerators.values())
    divisor = {k: n // content for k, n in b.numerators.items()}
    lowest = min(divisor)
    box = [(low - below, high - above) for (low, high), (below, above) in zip(_box(a), _box(b), strict=True)]
    rest = dict(a.numerators)
    waiting = sorted(rest)  # a heap of the exponents in `rest`
    numerators: dict[int, int] = {}
    while waiting:
        k = heappop(waiting)
        if not (n := rest.pop(k)):
            continue
        factor, remainder = divmod(n, divisor[lowest])
        if remainder or any(not low <= e <= high for e, (low, high) in zip(exponents(k - lowest), box, strict=True)):
            return None
        if len(numerators) >= MAX_MASK_LENGTH:
            raise TooLargeError(f"a Laurent polynomial of more than {MAX_MASK_LENGTH} terms")
        if factor.bit_length() > MAX_BITS:
            raise TooLargeError(f"numbers of more than {MAX_DIGITS} digits come up")
        work.charge(30 + len(divisor), factor.bit_length(), b.bits)
        numerators[k - lowest] = factor
        for j, m in divisor.items():
            if j != lowest:
                if (at := k - lowest + j) not in rest:
                    heappush(waiting, at)
                rest[at] = rest.get(at, 0) - factor * m
    return BoundedLaurent({k: n * b.denominator for k, n in numerators.items()}, a.denominator * content)


def _box(a: BoundedLaurent) -> list[tuple[int, int]]:
    """The lowest and the highest exponent of each variable; (0, 0) for zero."""
    columns = list(zip(*map(exponents, a.numerators or {0: 0}), strict=True))
    return [(min(column), max(column)) for column in columns]


def spelled(a: BoundedLaurent, limit: int = 5) -> str | None:
    """The polynomial as a message may quote it, "1 - 2 z"; None for a long one."""
    if len(a.numerators) > limit or a.bits > 30:
        return None
    out = ""
    for k, c in sorted(a.coefficients.items()):
        size = "" if abs(c) == 1 and k else f"({abs(c)})" if k and abs(c).denominator > 1 else str(abs(c))
        powers = ((name, e) for name, e in zip(VARIABLES, exponents(k), strict=True) if e)
        variable = " ".join(name if e == 1 else f"{name}^{e}" for name, e in powers)
        sign = (" - " if c < 0 else " + ") if out else "-" if c < 0 else ""
        out += sign + f"{size} {variable}".strip()
    return out or "0"


def power(a: BoundedLaurent, n: int, work: Work) -> BoundedLaurent:
    """The power a^n for n >= 0, a^0 = 1. Raises TooLargeError, before numbers or terms grow out of hand."""
    if n == 0:
        return BoundedLaurent({0: 1})
    if len(a.numerators) == 1:
        ((k, c),) = a.numerators.items()
        _bound(max(map(abs, exponents(k))) * n)
        if max(abs(c).bit_length() - 1, a.denominator.bit_length() - 1) * n > MAX_BITS:
            raise TooLargeError(f"numbers of more than {MAX_DIGITS} digits come up")
        return BoundedLaurent({k * n: c**n}, a.denominator**n)
    result = a
    for bit in bin(n)[3:]:
        result = times(result, result, work)
        if bit == "1":
            result = times(result, a, work)
    return result
