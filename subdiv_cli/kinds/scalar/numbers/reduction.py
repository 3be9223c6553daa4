"""An unstable mask reduced to a stable one with the same smoothness of the refinable function."""

from __future__ import annotations

from typing import NamedTuple

from flint import fmpz_poly

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.kinds.scalar.numbers.independence import circle_factors, cycles, monic, polyphase_gcd


class Step(NamedTuple):
    """a0(z) = a(z) g(z)/g(z^p), an exact division; φ = Σ_j g_j φ0(·-j) / g(1)."""

    factor: Laurent
    """g: the gcd of the polyphase components, or Φ_n for a cycle."""
    cycle: int | None
    """n, where g = Φ_n."""
    symbol: Laurent
    """a0."""


def reduction(a: Laurent, p: int) -> tuple[Step, ...]:
    """The steps from a symbol with a(1) = p to one with a stable refinable function; none where it is stable.

    Where all polyphase components vanish at a point of |z| = 1, g is their gcd; where a has a cycle of n-th roots of
    unity, g = Φ_n. In both cases g(z^p) divides a(z) g(z), g(1) ≠ 0 because a(1) = p, and 1/g is a power series, so
    that φ and φ0 are finite or locally finite combinations of each other's translates: equally smooth. The degree
    falls by (p-1) deg g in each step, so the steps end; the sum-rule order does not fall.
    """
    steps: list[Step] = []
    while (found := _unstable_factor(a, p)) is not None:
        g, cycle = found
        a, remainder = (a * g).divide(g.inflate(p))
        if remainder.poly or g(1) == 0:
            raise ArithmeticError("an inexact reduction step")
        steps.append(Step(g, cycle, a))
    return tuple(steps)


def _unstable_factor(a: Laurent, p: int) -> tuple[Laurent, int | None] | None:
    g = polyphase_gcd(a, p)
    if circle_factors(g):
        return g, None
    n = next(cycles(a, p), None)
    return None if n is None else (monic(fmpz_poly.cyclotomic(n)), n)
