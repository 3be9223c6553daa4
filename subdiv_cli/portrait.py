"""What `show` and `plot` want beyond a check: more findings, certified alike; the mask taken apart; curves.

A module of its own, so that `check` does not load what it does not need.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.scalar import KIND
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages import analyse
from subdiv_cli.kinds.scalar.stages.anatomy import anatomy
from subdiv_cli.kinds.scalar.stages.curves import TooFewPointsError, limit, polygons, refinable, support
from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model.blocks import Anatomy, Curve
from subdiv_cli.pipeline import Checked, certified

__all__ = ["TooFewPointsError", "Vertices", "drawn", "portrait", "traced"]

Vertices = tuple[tuple[Fraction, ...], ...]
"""The coordinates of the vertices of a polygon, one sequence for each coordinate."""


def portrait(scheme: ScalarScheme, tolerance: Fraction, effort: Effort) -> tuple[Checked, Anatomy]:
    """What `check` finds and, certified and checked alike, values, stencils, Q and error bounds; the mask taken apart.

    `tolerance` is that of the error bound. Raises DisagreementError where the checker says no.
    """
    analysis = analyse(scheme, effort, tolerance)
    return certified(KIND, analysis, (), effort), anatomy(analysis)


def drawn(
    scheme: ScalarScheme, effort: Effort, points: int
) -> tuple[Result, tuple[Curve, ...], tuple[Fraction, Fraction]]:
    """The result of `check`; φ and its derivatives up to the proved order, with about so many points; their support.

    No curves where φ is not proved continuous.
    """
    analysis = analyse(scheme, effort)
    result = certified(KIND, analysis, (), effort).result
    order = result.refinable.order
    curves = () if order is None else refinable(analysis.numbers, order, points)
    return result, curves, support(analysis.numbers)


def traced(
    scheme: ScalarScheme, effort: Effort, columns: Vertices, points: int, *, closed: bool, levels: int
) -> tuple[Result, tuple[Curve, ...], tuple[Vertices, ...]]:
    """The result of `check`; the limit of a polygon, a curve for each coordinate; the polygons of levels 1 to `levels`.

    No curves where S is not proved to converge. Raises TooFewPointsError for an open polygon that determines no limit.
    """
    analysis = analyse(scheme, effort)
    result = certified(KIND, analysis, (), effort).result
    if result.convergent is not Verdict.PROVED:
        return result, (), ()
    curves = limit(analysis.numbers, columns, points, closed=closed)
    refined = (polygons(analysis.numbers, columns, level, closed=closed) for level in range(1, levels + 1))
    return result, curves, tuple(refined)
