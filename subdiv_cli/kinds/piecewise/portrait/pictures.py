"""The limits of unit data near 0 by exact values, for `plot` and for cards."""

from __future__ import annotations

from fractions import Fraction
from math import lcm

from subdiv_cli.kinds.kind import Certify, Options
from subdiv_cli.kinds.piecewise.numbers.piecewise import PiecewiseNumbers
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model.blocks import Curve, Drawing
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import CONVERGENCE

_MOST_DRAWN = 9
"""The most points whose limits are drawn."""
_MOST_VALUES = 20_000
"""The most values of a curve, about."""


def functions(scheme: PiecewiseScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of the limits of unit data near 0; empty where S is not proved to converge."""
    analysis, result = certify(effort)
    curves = limits(analysis.numbers, result, options["samples"])
    return Drawing(curves, result, None if curves else CONVERGENCE)


def limits(numbers: PiecewiseNumbers, result: Result, samples: int) -> tuple[Curve, ...]:
    """The limits for the data 1 at one of the points near 0, as functions of the geometric parameter.

    The parameter is in the smallest unit that is a multiple of both spacings. None unless S is proved to converge.
    """
    if result.convergent is not Verdict.PROVED or numbers.functionals is None:
        return ()
    points = [j for j in numbers.closed_set if abs(j) <= _MOST_DRAWN // 2]
    return tuple(_limit(numbers, j, samples) for j in points)


def _limit(numbers: PiecewiseNumbers, j: int, samples: int) -> Curve:
    """The limit for the data 1 at point j and 0 elsewhere, on a grid of about so many points."""
    p, steps, unit = numbers.p, *_steps(numbers.scheme)
    level, beyond = 0, 0
    while p**level < samples // 6 and p ** (level + 1) <= _MOST_VALUES:
        level += 1
    while p**beyond < max(abs(i) for cells in numbers.cells for i in cells.numbers) // p + 1:
        beyond += 1
    data = {j: Fraction(1)}
    for _ in range(level + beyond):
        data = _refined(numbers.scheme, data)
    values = {
        k: value
        for k in _places(data, p**beyond, steps)
        if (value := _value(numbers, data, k * steps[k >= 0] * p**beyond, j))
    }
    first, last = min(values, default=0) - 1, max(values, default=0) + 1
    heights = tuple(values.get(k, Fraction(0)) for k in range(first, last + 1))
    support = Fraction(first, p**level), Fraction(last, p**level)
    name = "F" if unit == 1 else f"F({rational(unit)}·)"
    return Curve(p, level, first, heights, support, name=name, label=f"c_{j} = 1")


def _steps(scheme: PiecewiseScheme) -> tuple[tuple[int, int], Fraction]:
    """The steps of the index on both sides for one of the parameter, and its unit: a multiple of both spacings."""
    a, b = scheme.spacing
    common = lcm(a.denominator, b.denominator)
    m, n = int(a * common), int(b * common)
    both = lcm(m, n)
    return (both // m, both // n), Fraction(both, common)


def _refined(scheme: PiecewiseScheme, data: dict[int, Fraction]) -> dict[int, Fraction]:
    """The data of the next level that are not 0."""
    p, low, high = scheme.arity, min(data), max(data)
    reach = max(abs(x) for mask in (scheme.left, scheme.right) for x in (mask.start, mask.start + mask.degree))
    special = [i for i, _ in scheme.special]
    first, last = min([p * low - reach, *special]), max([p * high + reach, *special])
    new = {}
    for i in range(first, last + 1):
        value = sum((w * data[j] for j, w in scheme.row(i) if j in data), Fraction(0))
        if value:
            new[i] = value
    return new or {0: Fraction(0)}


def _places(data: dict[int, Fraction], scale: int, steps: tuple[int, int]) -> range:
    """The numbers of the points of the parameter where the limit may not be 0."""
    margin = 8 * scale
    return range((min(data) - margin) // (scale * steps[0]), (max(data) + margin) // (scale * steps[1]) + 1)


def _value(numbers: PiecewiseNumbers, data: dict[int, Fraction], i: int, j: int) -> Fraction:
    """The limit at index i of the data, those of a level that come from 1 at point j."""
    if i == 0:
        assert numbers.functionals is not None
        return numbers.functionals.value[j - numbers.functionals.window[0]]
    low, row = numbers.cells[i > 0].low, numbers.stencils[i > 0]
    return sum((w * data[i + k] for k, w in enumerate(row, low) if w and i + k in data), Fraction(0))
