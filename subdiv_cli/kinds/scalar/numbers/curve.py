"""Stencils and exact values of φ for pictures: at the integers from the limit stencil, at finer points by refinement.

Light: flint is imported only where something is drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import lcm
from typing import NamedTuple

from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model.blocks import Curve

POINTS = 512
"""A curve has at most so many points, unless its support has more integers."""
LONGEST = 64
"""For longer windows the exact values are not worth their cost in a picture."""


class Signal(NamedTuple):
    """A finitely supported sequence: a mask, a stencil, values at the integers."""

    start: int
    values: tuple[Fraction, ...]

    def trimmed(self) -> Signal:
        """Without the zeros at its ends; without any value where all are zero."""
        used = [i for i, value in enumerate(self.values) if value]
        return Signal(self.start + used[0], self.values[used[0] : used[-1] + 1]) if used else Signal(0, ())


def rule(scheme: ScalarScheme, epsilon: int) -> Signal:
    """(S f)_(pk+ε) = Σ_j a_(ε-pj) f_(k+j); no weights where the class has no coefficients."""
    p, last = scheme.arity, scheme.start + scheme.degree
    first = -((last - epsilon) // p)
    weights = tuple(
        scheme.coefficients[k]
        for j in range(first, -(-(epsilon - scheme.start) // p) + 1)
        if 0 <= (k := epsilon - p * j - scheme.start) <= scheme.degree
    )
    return Signal(first, weights)


def limit_stencil(integers: Mapping[int, Fraction]) -> Signal:
    """S^∞f(k) = Σ_j φ(-j) f_(k+j), from φ at the integers."""
    betas = sorted(-x for x in integers)
    return Signal(betas[0], tuple(integers[-beta] for beta in betas))


def integer_values(scheme: ScalarScheme) -> dict[int, Fraction] | None:
    """φ at the integers of its support, for a scheme that converges; None where the support is long.

    The left eigenvector v of A_0[α,β] = a_(α-pβ) for the eigenvalue 1 with Σv = 1 has v_β = φ(-β) (Dyn 4.3, 4.6).
    Convergence makes it unique.
    """
    from subdiv_cli.kinds.scalar.numbers import operators, spectra

    window = operators.refinement_window(scheme)
    v = None if len(window) > LONGEST else spectra.limit_stencil(operators.refinement_matrices(scheme)[0])
    return None if v is None else {-beta: value for beta, value in zip(window, v, strict=True)}


def curve(scheme: ScalarScheme, integers: Mapping[int, Fraction]) -> Curve:
    """φ at ℓ p^-k over its support, by φ(x) = Σ_j a_j φ(px - j) from the integers on.

    Integers over the common denominator D of the mask times the powers that refinement brings.
    """
    p, first, last = scheme.arity, scheme.start, scheme.start + scheme.degree
    mask_denominator = lcm(*(c.denominator for c in scheme.coefficients))
    mask = [int(c * mask_denominator) for c in scheme.coefficients]
    denominator = lcm(*(v.denominator for v in integers.values()))
    values = {x: int(v * denominator) for x, v in integers.items() if v}
    level = 0
    while (scheme.degree // (p - 1) + 1) * p ** (level + 1) <= POINTS:
        values = _refined(mask, first, p, values, p**level)
        level, denominator = level + 1, denominator * mask_denominator
    low, high = first * p**level // (p - 1), -(-last * p**level // (p - 1))
    fine = tuple(Fraction(values.get(x, 0), denominator) for x in range(low, high + 1))
    return Curve(p, level, low, fine, (Fraction(first, p - 1), Fraction(last, p - 1)))


def _refined(mask: Sequence[int], start: int, p: int, values: Mapping[int, int], step: int) -> dict[int, int]:
    """The numerators at ℓ/(p step) from those at ℓ/step: φ(ℓ/(p step)) = Σ_j a_j φ(ℓ/step - j)."""
    finer: dict[int, int] = {}
    for x, value in values.items():
        for i, c in enumerate(mask):
            if c:
                at = x + (start + i) * step
                finer[at] = finer.get(at, 0) + c * value
    return finer
