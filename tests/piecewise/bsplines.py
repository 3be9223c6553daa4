"""Refinement of B-splines whose knots change at 0: spacings on both sides, a knot of any multiplicity at 0."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.kinds.scalar.scheme import ScalarScheme


def bspline_mask(degree, arity, start):
    """The mask of B-splines on uniform knots: ((1 + … + z^(p-1))^(d+1) / p^d."""
    a = [Fraction(1)]
    for _ in range(degree + 1):
        a = [sum(a[max(0, i - arity + 1) : i + 1], Fraction(0)) for i in range(len(a) + arity - 1)]
    return ScalarScheme(arity=arity, start=start, coefficients=tuple(x / arity**degree for x in a))


def spline_scheme(degree, spacing=(1, 1), multiplicity=1, arity=2):
    """The scheme that inserts knots, by discrete B-splines (Cohen, Lyche & Riesenfeld 1980).

    Knots are … -2h, -h, 0 (as often as said), h', 2h', …; those of the finer spline are the p-th parts of these.
    """
    left, right = map(Fraction, spacing)

    def knot(i):
        return left * i if i < 0 else right * max(0, i - multiplicity + 1)

    def finer(i):
        return knot(i) / arity

    @cache
    def alpha(j, k, i):
        """The discrete B-spline of order k."""
        if k == 1:
            return Fraction(knot(j) <= finer(i) < knot(j + 1))
        total, x = Fraction(0), finer(i + k - 1)
        if knot(j + k - 1) > knot(j):
            total += (x - knot(j)) / (knot(j + k - 1) - knot(j)) * alpha(j, k - 1, i)
        if knot(j + k) > knot(j + 1):
            total += (knot(j + k) - x) / (knot(j + k) - knot(j + 1)) * alpha(j + 1, k - 1, i)
        return total

    shift = (degree + multiplicity) // 2  # of the indices, so that old points lie near i h
    reach = 3 * (degree + multiplicity) + 4
    rows = []
    for i in range(-reach, reach + 1):
        results = {j: alpha(j - shift, degree + 1, i - shift) for j in range(-reach, reach + 1)}
        rows.append((i, tuple((j, x) for j, x in results.items() if x)))
    step = arity - 1
    masks = [
        bspline_mask(degree, arity, -step * shift),
        bspline_mask(degree, arity, -step * (shift + multiplicity - 1)),
    ]
    return PiecewiseScheme(*masks, (left, right), tuple(rows))
