"""Laurent polynomials over Q in one variable: symbols of masks."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cache

from flint import fmpq, fmpq_poly, fmpz_poly

from subdiv_cli.exact.rationals import to_fmpq, to_fraction


class Laurent:
    """The Laurent polynomial z^low · poly(z) in canonical form: poly(0) ≠ 0, and zero is (0, 0). Never changed."""

    __slots__ = ("low", "poly")

    def __init__(self, low: int, poly: fmpq_poly) -> None:
        valuation = next((i for i, c in enumerate(poly) if c), None)
        if valuation is None:
            low, poly = 0, fmpq_poly()
        elif valuation:
            low, poly = low + valuation, poly.right_shift(valuation)
        self.low, self.poly = low, poly

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Laurent) and self.low == other.low and self.poly == other.poly

    def __hash__(self) -> int:
        return hash((self.low, str(self.poly)))

    def __repr__(self) -> str:
        return f"Laurent({self.low}, {self.poly})"

    @classmethod
    def from_coefficients(cls, low: int, coefficients: Iterable[Fraction | int]) -> Laurent:
        """The Laurent polynomial Σ_i coefficients[i] z^(low+i)."""
        return cls(low, fmpq_poly([to_fmpq(c) for c in coefficients]))

    @property
    def degree(self) -> int:
        """The highest minus the lowest exponent; -1 for zero."""
        return self.poly.degree()

    def coefficients(self) -> tuple[Fraction, ...]:
        """The coefficients from the lowest exponent to the highest, degree + 1 of them."""
        return tuple(to_fraction(c) for c in self.poly)

    def __add__(self, other: Laurent) -> Laurent:
        low = min(self.low, other.low)
        return Laurent(low, self.poly.left_shift(self.low - low) + other.poly.left_shift(other.low - low))

    def __sub__(self, other: Laurent) -> Laurent:
        return self + other.scale(-1)

    def __mul__(self, other: Laurent) -> Laurent:
        return Laurent(self.low + other.low, self.poly * other.poly)

    def scale(self, c: Fraction | int) -> Laurent:
        """The product of this polynomial with a rational."""
        return Laurent(self.low, self.poly * to_fmpq(c))

    def shift(self, n: int) -> Laurent:
        """The product of this polynomial with z^n."""
        return Laurent(self.low + n, self.poly) if self.poly else self

    def __call__(self, x: Fraction | int) -> Fraction:
        """The value at a non-zero rational; at 0 only where no exponent is negative."""
        value = self.poly(to_fmpq(x))
        return to_fraction(value if self.low == 0 else value * to_fmpq(x) ** self.low)

    def derivatives_at_one(self, count: int) -> tuple[Fraction, ...]:
        """The derivatives of order 0, …, count-1 at 1: Σ_α c_α α(α-1)…(α-j+1)."""
        terms, derivatives = list(self.poly), []
        for j in range(count):
            derivatives.append(to_fraction(sum(terms, fmpq(0))))
            terms = [c * (self.low + i - j) for i, c in enumerate(terms)]
        return tuple(derivatives)

    def inflate(self, p: int) -> Laurent:
        """The polynomial with z^p in place of z."""
        return Laurent(self.low * p, fmpq_poly(self.poly.numer().inflate(p), self.poly.denom()))

    def reversed(self) -> Laurent:
        """The polynomial with 1/z in place of z."""
        return Laurent(-self.low - self.poly.degree(), fmpq_poly(list(self.poly)[::-1]))

    def divide(self, divisor: Laurent) -> tuple[Laurent, Laurent]:
        """Quotient and remainder with self = quotient·divisor + remainder and degree(remainder) < degree(divisor).

        The remainder starts at this polynomial's lowest exponent or later; it is zero iff the division is exact.
        Raises ZeroDivisionError for a zero divisor.
        """
        quotient, remainder = divmod(self.poly, divisor.poly)
        return Laurent(self.low - divisor.low, quotient), Laurent(self.low, remainder)

    def components(self, p: int) -> tuple[Laurent, ...]:
        """The p polyphase components a_0, …, a_(p-1): a(z) = Σ_r z^r a_r(z^p)."""
        classes: list[list[fmpq]] = [[fmpq(0)] * (-(-len(self.poly) // p) + 1) for _ in range(p)]
        base = self.low // p
        for i, c in enumerate(self.poly):
            quotient, r = divmod(self.low + i, p)
            classes[r][quotient - base] = c
        return tuple(Laurent(base, fmpq_poly(coefficients)) for coefficients in classes)

    def integer_form(self) -> tuple[fmpz_poly, int]:
        """The coefficients over one denominator: (polynomial of their numerators, common denominator)."""
        return self.poly.numer(), int(self.poly.denom())


@cache
def smoothing_factor(p: int) -> Laurent:
    """The smoothing factor 1 + z + … + z^(p-1) of arity p."""
    return Laurent(0, fmpq_poly([1] * p))
