"""The distance of a control polygon from the limit: the constants of Dyn 3.3 and 4.7, in the mask's own indexing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers

MOST_LEVELS = 12
"""The last level whose norm is tried: norms beyond cost more than they save."""
MOST_REFINEMENTS = 10**6
"""The most levels of refinement that are counted: nobody refines beyond them."""
_ENOUGH = Fraction(9, 8)
"""A level is taken once its norm is below so many times the best estimate of ‖S_ν^∞‖."""
MOST_BITS = 10**7
"""The most bits of a power of μ."""


class ErrorBound(NamedTuple):
    """The bound ‖S_ν^∞ g - S_ν^k g‖∞ <= constant · norm^⌊k/level⌋ · ‖Δg‖∞, the polygon's vertices at i p^-k."""

    nu: int
    level: int
    """The number L of levels between two powers of μ."""
    norms: tuple[Fraction, ...]
    """The norms ‖((1/p)S_(ν+1))^j‖∞ for j = 1, …, L; the last one is μ < 1."""
    distance: Fraction
    """The norm E of S_ν - U as an operator on differences, U the linear spline."""
    constant: Fraction
    """The constant C = E L/(1-μ) · max(1, the norms below L)."""

    @property
    def norm(self) -> Fraction:
        """The norm μ < 1 of level L."""
        return self.norms[-1]

    def levels_for(self, tolerance: Fraction) -> int | None:
        """The smallest multiple of L that brings the bound down to the tolerance; None where none is reasonable.

        Floats guess how often μ is needed, exact powers decide.
        """
        if self.constant <= tolerance:
            return 0
        ratio, rate = tolerance / self.constant, self.norm
        guess = math.ceil(_log(ratio) / _log(rate)) if rate else 1
        if guess * self.level > MOST_REFINEMENTS or guess * rate.denominator.bit_length() > MOST_BITS:
            return None
        steps = max(guess - 2, 1)
        while rate**steps > ratio:
            steps += 1
        return steps * self.level


def _log(x: Fraction) -> float:
    return math.log(x.numerator) - math.log(x.denominator)


def distance_to_spline(symbol: Laurent, p: int) -> Fraction:
    """The norm E = max_γ Σ_β |e_(γ+pβ)|, symbol - z^-(p-1) σ²/p = (1-z^p) z^-p e(z).

    Raises ArithmeticError where the residue sums are not 1.
    """
    sigma = smoothing_factor(p)
    spline = (sigma * sigma).scale(Fraction(1, p)).shift(1 - p)
    quotient, remainder = (symbol - spline).shift(p).divide(Laurent.from_coefficients(0, [1, *[0] * (p - 1), -1]))
    if remainder.poly:
        raise ArithmeticError("a symbol without residue sums 1")
    sums = [Fraction(0)] * p
    for i, c in enumerate(quotient.coefficients()):
        sums[(quotient.low + i) % p] += abs(c)
    return max(sums)


def bounds(numbers: ScalarNumbers, nu: int) -> Iterator[ErrorBound]:
    """The bound for each level L whose norm is below 1, as far as the effort goes."""
    p, last = numbers.p, numbers.difference(nu + 1).scale(numbers.p**nu)
    distance = distance_to_spline(numbers.difference(nu).scale(p**nu), p)
    norms: tuple[Fraction, ...] = ()
    for level, norm in enumerate(power_norms(last, p, numbers.effort), 1):
        if level > MOST_LEVELS:
            return
        norms = (*norms, norm)
        if norm < 1:
            constant = distance * level / (1 - norm) * max([Fraction(1), *norms[:-1]])
            yield ErrorBound(nu, level, norms, distance, constant)


def best_bound(numbers: ScalarNumbers, tolerance: Fraction) -> ErrorBound | None:
    """The bound that needs the fewest levels for the tolerance, of several the one with the smallest L."""
    best: tuple[int, ErrorBound] | None = None
    for bound in bounds(numbers, 0):
        levels = bound.levels_for(tolerance)
        if levels is not None and (best is None or levels < best[0]):
            best = levels, bound
    return None if best is None else best[1]


class HermiteBound(NamedTuple):
    """The bound ‖S^∞ f - Q^k‖∞ <= constant · p^-(νk) · ‖Δ^ν f‖∞ for the Hermite interpolant Q^k at i p^-k, ν even.

    It has degree ν-1.
    """

    bound: ErrorBound
    """The error bound of S_ν."""
    level: int
    """The level j at which ‖S_ν^∞‖ is estimated."""
    norm: Fraction
    """The norm ‖((1/p)S_ν)^j‖∞; p^j times it is ‖S_ν^j‖∞."""
    constant: Fraction


def hermite_bound(numbers: ScalarNumbers, nu: int) -> HermiteBound | None:
    """The bound of the Hermite interpolant of degree ν-1, ν = 2m; None where the effort gives no bound of S_ν.

    |f - Q| <= h^ν/(4^m ν!) ‖f^(ν)‖∞ on an interval of length h, and f^(ν) = S_ν^∞ Δ^ν f⁰. ‖S_ν^∞‖ <= ‖S_ν^j‖ +
    2C μ^⌊j/L⌋ for every j, by the error bound of S_ν; the best of a few j is good enough.
    """
    bound = next(bounds(numbers, nu), None)
    if bound is None:
        return None
    p, sizes = numbers.p, []
    for j, norm in enumerate(power_norms(numbers.difference(nu).scale(p ** (nu - 1)), p, numbers.effort), 1):
        if j > MOST_LEVELS:
            break
        sizes.append((norm * p**j + 2 * bound.constant * bound.norm ** (j // bound.level), j, norm))
    if not sizes:
        return None
    enough = min(sizes)[0] * _ENOUGH
    size, j, norm = next(entry for entry in sizes if entry[0] <= enough)
    return HermiteBound(bound, j, norm, size / (2**nu * math.factorial(nu)))
