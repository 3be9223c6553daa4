"""Curves of a scalar mask for `plot`: φ and its derivatives, limits of polygons and their control polygons, exactly."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.kinds.kind import Certify, NotDrawnError, Options
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_fractions, at_integers, iterated, support
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.model.blocks import Curve, Drawing, Polygon
from subdiv_cli.model.findings import CONVERGENCE, SMOOTHNESS

MOST_VALUES = 40_000
"""The most values of one curve, about: what has more is drawn at a coarser level."""
_DERIVATIVES = 4
"""The number of derivatives drawn unless more are wanted."""

Coordinates = Sequence[Fraction]
"""The x or the y coordinates of the points of a polygon."""


class TooFewPointsError(NotDrawnError):
    """An open polygon that determines no piece of the limit; `needed` is the number of points that would."""

    def __init__(self, needed: int) -> None:
        super().__init__(f"an open polygon needs {needed} points for this mask: give more, or --closed")
        self.needed = needed


def functions(scheme: ScalarScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of φ and its derivatives up to the proved order, or `derivatives`; empty unless φ is continuous.

    φ must be proved continuous by the stages.
    """
    analysis, result = certify(effort)
    proved, wanted = result.refinable.order, options.get("derivatives")
    if proved is None:
        return Drawing((), result, SMOOTHNESS)
    last = int(min(proved, _DERIVATIVES if wanted is None else wanted))
    return Drawing(refinable(analysis.numbers, last, options["samples"]), result)


def curves(scheme: ScalarScheme, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of the control polygon `points`, the polygons of the `levels` that follow, and the limit curve.

    It is empty where S is not proved to converge. Raises TooFewPointsError.
    """
    x, y = options["points"]
    meets = x[0] == x[-1] and y[0] == y[-1]
    closed = meets if options.get("closed") is None else options["closed"]
    if closed and meets and len(x) > 2:
        x, y = x[:-1], y[:-1]
    analysis, result = certify(effort)
    if result.convergent is not Verdict.PROVED:
        return Drawing((), result, CONVERGENCE)
    across, up = limit(analysis.numbers, (x, y), options["samples"], closed=closed)
    control = [Polygon(x, y, closed, "control polygon")]
    for level in range(1, (options.get("levels") or 0) + 1):
        vertices = polygons(analysis.numbers, (x, y), level, closed=closed)
        control.append(Polygon(vertices[0], vertices[1], closed, f"level {level}"))
    return Drawing((*control, Polygon(across.values, up.values)), result)


def level_for(numbers: ScalarNumbers, length: Fraction | int, points: int) -> int:
    """The smallest level at which an interval of this length has so many points, and no more values than are sane."""
    level, p = 0, numbers.p
    while length * p**level < points and length * p ** (level + 1) <= MOST_VALUES:
        level += 1
    return level


def refinable(numbers: ScalarNumbers, order: int, points: int) -> tuple[Curve, ...]:
    """The curves of φ, φ', …, φ^(order) at i/p^m. Needs φ ∈ C^order, proved by the stages."""
    first, last = support(numbers)
    level = level_for(numbers, last - first, points)
    curves = []
    for j in range(order + 1):
        fine = at_fractions(numbers.symbol, numbers.p, at_integers(numbers, j), j, level)
        curves.append(Curve(numbers.p, level, fine.low, fine.coefficients(), (first, last), j))
    return tuple(curves)


def limit(numbers: ScalarNumbers, columns: Sequence[Coordinates], points: int, *, closed: bool) -> tuple[Curve, ...]:
    """The limit of a polygon, one curve for each coordinate: (S^∞ f)(i/p^m) on the interval that it determines.

    Point number i is f_i. A closed polygon of N points is continued periodically, and the interval is [0, N]; an open
    one determines [b-1, a+N], where [a, b] is the support of φ. Needs S to converge. Raises TooFewPointsError.
    """
    count, (a, b) = len(columns[0]), support(numbers)
    first, last = (Fraction(0), Fraction(count)) if closed else (b - 1, a + count)
    if first >= last:
        raise TooFewPointsError(int(b - a))
    level, p = level_for(numbers, last - first, points), numbers.p
    values = at_integers(numbers, 0)
    reach = range(int(first - b) - 2, int(last - a) + 3) if closed else range(count)
    low, high = -((-first * p**level) // 1), (last * p**level) // 1
    curves = []
    for column in columns:
        data = Laurent.from_coefficients(reach[0], [column[i % count] for i in reach])
        fine = at_fractions(numbers.symbol, p, values, 0, level, data)
        curves.append(Curve(p, level, low, _between(fine, low, high), (first, last)))
    return tuple(curves)


def polygons(
    numbers: ScalarNumbers, columns: Sequence[Coordinates], level: int, *, closed: bool
) -> tuple[tuple[Fraction, ...], ...]:
    """The vertices of S^level f, one sequence for each coordinate: those of a period, or all that f determines."""
    count, p = len(columns[0]), numbers.p
    power = iterated(numbers.symbol, p, level)
    first, degree = power.low, power.degree
    if closed:
        low, high = 0, count * p**level - 1
        reach = range((low - first - degree) // p**level - 1, (high - first) // p**level + 2)
    else:
        low, high = first + degree - p**level + 1, first + count * p**level - 1
        reach = range(count)
    pieces = []
    for column in columns:
        data = Laurent.from_coefficients(reach[0], [column[i % count] for i in reach])
        pieces.append(_between(power * data.inflate(p**level), low, high))
    return tuple(pieces)


def _between(f: Laurent, low: int, high: int) -> tuple[Fraction, ...]:
    """The coefficients of z^low, …, z^high."""
    c = f.coefficients()
    padding = [Fraction(0)] * max(f.low - low, 0)
    inner = c[max(low - f.low, 0) : max(high + 1 - f.low, 0)]
    return (*padding[: max(high + 1 - low, 0)], *inner, *[Fraction(0)] * (high + 1 - low - len(padding) - len(inner)))
