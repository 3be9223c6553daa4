"""The one door between Python's Fractions and FLINT's rationals (`fmpq(Fraction)` is a TypeError)."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq


def to_fmpq(x: Fraction | int) -> fmpq:
    """A fraction or an integer as FLINT's rational."""
    return fmpq(x.numerator, x.denominator)


def whole(x: Fraction | int) -> str:
    """A rational as `p/q`, of any length: Python itself refuses to print integers beyond 4300 digits."""
    return str(to_fmpq(x))


def to_fraction(x: fmpq) -> Fraction:
    """FLINT's rational as a fraction."""
    return Fraction(int(x.p), int(x.q))
