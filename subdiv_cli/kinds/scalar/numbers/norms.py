"""Exact norms of the powers of a scheme, ‖S^L‖∞ = max_γ Σ_β |a^[L]_(γ + p^L β)| (Dyn 3.11, 3.13)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from flint import fmpz, fmpz_poly

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.model import Effort

_MOST_COEFFICIENTS = 4_000_000
"""The most coefficients of one iterated symbol, whatever the effort: FLINT aborts the process when memory ends."""


def power_norms(a: Laurent, p: int, effort: Effort) -> Iterator[Fraction]:
    """The norms ‖S‖∞, ‖S²‖∞, ‖S³‖∞, … for the scheme with symbol a ≠ 0, as far as the effort goes.

    It counts the coefficients of a^[L], long ones in pieces of 512 bits.

    a^[L](z) = Π_(j<L) a(z^(p^j)) = a(z) a^[L-1](z^p), so its class r mod p is a_r a^[L-1] with the polyphase
    component a_r, and the classes mod p^L of a^[L] are the classes mod p^(L-1) of these products.
    """
    numerators, denominator = a.integer_form()
    coefficients, bits = numerators.coeffs(), numerators.height_bits()
    components = [fmpz_poly(coefficients[r::p]) for r in range(p)]
    power, level, spent = fmpz_poly([1]), 0, 0
    while True:
        size = max(len(coefficients) - 1, p - 1) * (p ** (level + 1) - 1) // (p - 1) + 1
        spent += size * (1 + bits * (level + 1) // 512)
        if size > _MOST_COEFFICIENTS or not effort.allows(spent):
            return
        blocks = [component * power for component in components]
        classes = p**level
        level += 1
        yield Fraction(int(max(_largest_class_sum(block, classes) for block in blocks)), denominator**level)
        power = sum((block.inflate(p).left_shift(r) for r, block in enumerate(blocks)), fmpz_poly())


def _largest_class_sum(f: fmpz_poly, classes: int) -> fmpz:
    """The largest absolute class sum max_γ Σ_β |f_(γ + classes·β)|."""
    magnitudes = list(map(abs, f.coeffs()))
    return max((sum(magnitudes[g::classes], fmpz(0)) for g in range(min(classes, len(magnitudes)))), default=fmpz(0))
