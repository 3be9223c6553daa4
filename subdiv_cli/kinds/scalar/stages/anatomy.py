"""A mask taken apart for a reader: what the stages found and what they leave unsaid, as plain data.

Nothing here is a verdict. The symbol is factored over Q with the smoothing factors pulled out first; the zeros of the
other factors are printed with digits that are certain.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple, cast

from flint import acb, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated_roots
from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.exact.linalg import rows_of
from subdiv_cli.exact.text import certain, number
from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.scalar.numbers.operators import refinement_window
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_fractions, support
from subdiv_cli.kinds.scalar.rules import (
    APPROXIMATION_ORDER,
    DERIVED_SCHEMES,
    EIGEN_CONDITION,
    INTEGER_VALUES,
    LIMIT_STENCILS,
    QUASI_INTERPOLATION,
)
from subdiv_cli.model import Data, Verdict
from subdiv_cli.model.blocks import Anatomy, Curve, Factor, Signal

_POINTS = 240
"""Of the curve, at least."""
_MOST_ZEROS = 60
"""Zeros of a factor of higher degree are not listed."""


class _Found(NamedTuple):
    """The witness of each code whose finding is proved, or is a refutation with one."""

    witnesses: dict[str, dict[str, Data]]

    def signals(self, code: str, starts: str, values: str) -> tuple[Signal, ...]:
        witness = self.witnesses.get(code, {})
        pairs = zip(
            cast("tuple[int, ...]", witness.get(starts, ())),
            cast("tuple[tuple[Fraction, ...], ...]", witness.get(values, ())),
            strict=True,
        )
        return tuple(Signal(start, numbers) for start, numbers in pairs)

    def rationals(self, code: str, key: str) -> tuple[Fraction, ...]:
        return cast("tuple[Fraction, ...]", self.witnesses.get(code, {}).get(key, ()))


def anatomy(analysis: Analysis) -> Anatomy:
    """Of the scheme that was analysed with the stages of `picture.py`."""
    numbers = analysis.numbers
    found = _Found({f.code: dict(f.witness) for f in analysis.findings if f.verdict is not Verdict.SKIPPED})
    constant, power, factors = _factored(numbers)
    quasi, orders = (
        found.witnesses.get(QUASI_INTERPOLATION.code),
        found.witnesses.get(APPROXIMATION_ORDER.code),
    )
    values = found.signals(INTEGER_VALUES.code, "starts", "values")
    eigenvalues = cast(
        "tuple[tuple[str, ...], ...]", found.witnesses.get(EIGEN_CONDITION.code, {}).get("eigenvalues", ())
    )
    sequences = cast(
        "tuple[tuple[Fraction, ...], ...]",
        found.witnesses.get(QUASI_INTERPOLATION.code, {}).get("eigen_sequences", ()),
    )
    return Anatomy(
        mask=Signal(numbers.scheme.start, numbers.scheme.coefficients),
        constant=constant,
        power=power,
        factors=factors,
        components=tuple(Signal(a.low, a.coefficients()) for a in numbers.symbol.components(numbers.p)),
        derived=found.signals(DERIVED_SCHEMES.code, "starts", "masks"),
        window=refinement_window(numbers.scheme).start,
        matrices=_matrices(numbers),
        eigenvalues=eigenvalues,
        support=support(numbers),
        values=values,
        stencils=found.signals(LIMIT_STENCILS.code, "starts", "stencils"),
        moments=found.rationals(QUASI_INTERPOLATION.code, "moments"),
        operator=found.rationals(QUASI_INTERPOLATION.code, "operator"),
        quasi_stencil=Signal(cast(int, quasi["stencil_start"]), found.rationals(QUASI_INTERPOLATION.code, "stencil"))
        if quasi
        else None,
        eigen_sequences=sequences,
        orders=(cast(int, orders["with_q"]), cast(int, orders["without_q"])) if orders else None,
        curve=_curve(numbers, values[0]) if values else None,
    )


def _matrices(numbers: ScalarNumbers) -> tuple[tuple[tuple[Fraction, ...], ...], ...]:
    """The refinement matrices, none where they are large or the window is empty."""
    order = len(refinement_window(numbers.scheme))
    if not order or not numbers.effort.allows(numbers.p * order**2):
        return ()
    return tuple(rows_of(matrix) for matrix in numbers.refinement_matrices)


def _factored(numbers: ScalarNumbers) -> tuple[Fraction, int, tuple[Factor, ...]]:
    """(c, s, factors) with a(z) = c z^s Π factors^multiplicity."""
    order, cofactor, _ = numbers.sum_rules
    factors = [Factor((1,) * numbers.p, order, smoothing=True)] if order else []
    if not numbers.effort.allows(cofactor.degree**2 * numbers.weight):
        numerators, denominator = cofactor.integer_form()
        whole = tuple(int(c) for c in numerators)
        return Fraction(1, denominator), cofactor.low, (*factors, *([Factor(whole, 1)] if len(whole) > 1 else []))
    numerators, denominator = cofactor.integer_form()
    content, found = numerators.factor()
    factors += [Factor(tuple(int(c) for c in f), m, zeros=_zeros(f)) for f, m in found]
    return Fraction(int(content), denominator), cofactor.low, tuple(factors)


def _zeros(f: fmpz_poly) -> tuple[str, ...]:
    """Real ones by size, then pairs `x ± yi`."""
    if f.degree() > _MOST_ZEROS:
        return ()
    balls = isolated_roots(f)
    zeros = [AlgebraicNumber(f, z) for z in balls]
    real = sorted((x for x in zeros if x.is_real), key=lambda x: float(x.region.real.mid()))
    upper = [x for x in zeros if not x.is_real and x.region.imag > 0]
    return (*map(_real, real), *(_pair(x, balls) for x in upper))


def _real(x: AlgebraicNumber) -> str:
    exact = x.rational
    return number(exact) if exact is not None else certain(lambda: x.enclosure().real, 6)


def _pair(x: AlgebraicNumber, balls: list[acb]) -> str:
    """A pair of complex zeros; its real part exactly where the polynomial is quadratic, or where it is 0.

    A zero of an even polynomial that alone is near its mirror image -z̄, which is a zero too, is this image.
    """
    f = x.minimal_polynomial
    even = not any(int(c) for c in list(f)[1::2])
    mirror = -x.region.conjugate()
    if f.degree() == 2:
        part = Fraction(-int(f[1]), 2 * int(f[2]))
        real = number(part) if part else ""
    elif even and [z.overlaps(x.region) for z in balls if z.overlaps(mirror)] == [True]:
        real = ""
    else:
        real = certain(lambda: x.enclosure().real, 6)
    return f"{real} ± {certain(lambda: x.enclosure().imag, 6)}i".strip()


def _curve(numbers: ScalarNumbers, values: Signal) -> Curve:
    """φ at the points i/p^m, the smallest m that makes enough of them."""
    p, level = numbers.p, 0
    while numbers.scheme.degree * p**level < _POINTS * (p - 1):
        level += 1
    fine = at_fractions(numbers.symbol, p, Laurent.from_coefficients(values.start, values.values), 0, level)
    return Curve(p, level, fine.low, fine.coefficients())
