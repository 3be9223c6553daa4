"""Discs of complex eigenvalues, as the rule `complex-closing` of certificate/RADIUS.md takes them."""

from __future__ import annotations

from fractions import Fraction

from flint import acb, ctx

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated_roots
from subdiv_cli.exact.enclosures import ball, bounds
from subdiv_cli.model.proofs import DiscData

_DISC = 512
"""The significant bits of the center of a complex eigenvalue.

Its disc is much larger than one unit, and much smaller than the intervals of a `Root`.
"""


def _unit(mu: acb) -> Fraction:
    """The number 2^-_DISC times a power of two near |μ|."""
    mantissa, exponent = abs(mu).mid().man_exp()
    return Fraction(2) ** (int(exponent) + int(mantissa).bit_length() - _DISC)


def has_disc(eigenvalue: AlgebraicNumber) -> bool:
    """Whether an eigenvalue's disc is small beside its distance from all conjugates, as Rouché's theorem needs it."""
    with ctx.workprec(_DISC + 64):
        mu = eigenvalue.enclosure()
        far = ball(_unit(mu) * (1 << _DISC // 2 + 20))
        others = [z for z in isolated_roots(eigenvalue.minimal_polynomial) if not z.overlaps(mu)]
        return all(abs(z - mu) > far for z in others)


def disc_data(eigenvalue: AlgebraicNumber) -> DiscData:
    """A disc of rational center and distance that isolates a complex eigenvalue far better than its modulus needs."""
    with ctx.workprec(_DISC + 64):
        mu = eigenvalue.enclosure()
        unit = _unit(mu)
        x, y = (bounds(part)[0] // unit * unit for part in (mu.real, mu.imag))
    factor = tuple(int(x) for x in eigenvalue.minimal_polynomial)
    return {"factor": factor, "center": (x, y), "distance": unit * (1 << _DISC // 2)}
