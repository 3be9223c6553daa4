"""Facts of a scalar mask, seen without a theorem: support, symmetry, interpolation, signs, gaps."""

from __future__ import annotations

from fractions import Fraction
from math import gcd

from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Data


def facts(scheme: ScalarScheme) -> dict[str, Data]:
    """Keys: arity, support (first and last index), coefficients (their number), symmetry, centre, type, interpolatory,
    nonnegative, gaps (indices of zero coefficients inside the support) and spacing (the gcd of index differences).
    """
    symmetry, centre = _symmetry(scheme)
    indices = [scheme.start + i for i, c in enumerate(scheme.coefficients) if c]
    inside = range(scheme.start, scheme.start + len(scheme.coefficients))
    return {
        "arity": scheme.arity,
        "support": (inside[0], inside[-1]),
        "coefficients": len(indices),
        "symmetry": symmetry,
        "centre": centre,
        "type": None if centre is None else "primal" if centre.denominator == 1 else "dual",
        "interpolatory": interpolation_shift(scheme) == 0,
        "nonnegative": all(c >= 0 for c in scheme.coefficients),
        "gaps": tuple(sorted(set(inside) - set(indices))),
        "spacing": gcd(*(i - indices[0] for i in indices)),
    }


def _symmetry(scheme: ScalarScheme) -> tuple[str | None, Fraction | None]:
    """`symmetric` or `antisymmetric` and the centre, an integer or a half."""
    c = scheme.coefficients
    centre = Fraction(2 * scheme.start + scheme.degree, 2)
    if c == c[::-1]:
        return "symmetric", centre
    if c == tuple(-x for x in c[::-1]):
        return "antisymmetric", centre
    return None, None


def interpolation_shift(scheme: ScalarScheme) -> int | None:
    """The t with a_(t+pβ) = δ_(β,0): 0 for an interpolatory scheme, another for a shifted one; None without one.

    Of several the one nearest to 0.
    """
    ones = [scheme.start + i for i, c in enumerate(scheme.coefficients) if c == 1]
    shifts = [t for t in ones if _alone_in_class(scheme, t)]
    return min(shifts, key=lambda t: (abs(t), t), default=None)


def _alone_in_class(scheme: ScalarScheme, index: int) -> bool:
    first = (index - scheme.start) % scheme.arity
    return sum(1 for c in scheme.coefficients[first :: scheme.arity] if c) == 1
