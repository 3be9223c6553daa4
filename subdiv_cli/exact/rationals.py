"""The one door between Python's Fractions and FLINT's rationals (`fmpq(Fraction)` is a TypeError)."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq


def to_fmpq(x: Fraction | int) -> fmpq:
    return fmpq(x.numerator, x.denominator)


def to_fraction(x: fmpq) -> Fraction:
    return Fraction(int(x.p), int(x.q))
