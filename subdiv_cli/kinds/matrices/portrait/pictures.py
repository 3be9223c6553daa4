"""Curves that matrices refine: the components ψ_i, or the curve of a control polygon, by exact points; no flint."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from subdiv_cli.kinds.kind import Certify, NotDrawnError, Options
from subdiv_cli.kinds.matrices.rules import WELL_DEFINED
from subdiv_cli.kinds.matrices.scheme import MatrixFamily
from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model import findings as q
from subdiv_cli.model.blocks import Block, Curve, Drawing, Matrix, Polygon, Section, Text
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import answering

_MOST_NUMBERS = 40_000
"""The most coordinates of a curve, about."""
_CARD_POINTS = 200
_MOST_SHOWN = 6
"""The most components that are drawn on a card, and the largest matrices and the most of them that are written out."""

Vector = tuple[Fraction, ...]


def functions(scheme: MatrixFamily, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of the components ψ_1, …, ψ_n; empty unless the curve is proved to be well defined."""
    _, result = certify(effort)
    curves = components(scheme, result, options["samples"])
    return Drawing(curves, result) if curves else Drawing((), result, q.WELL_DEFINED)


def curves(scheme: MatrixFamily, effort: Effort, options: Options, certify: Certify) -> Drawing:
    """The drawing of the control polygon `points`, the polygons of the `levels` that follow, and its curve.

    It is empty unless the curve is proved to be well defined. Raises NotDrawnError for another number of points.
    """
    columns, n = options["points"], len(scheme.matrices[0])
    if len(columns[0]) != n:
        raise NotDrawnError(f"a curve of this scheme has {n} control points, and the file has {len(columns[0])}")
    _, result = certify(effort)
    ends = _ends(result)
    if ends is None:
        return Drawing((), result, q.WELL_DEFINED)
    control = [Polygon(columns[0], columns[1], control="control polygon")]
    for level in range(1, (options.get("levels") or 0) + 1):
        across, up = (_refined(scheme, column, level) for column in columns)
        control.append(Polygon(across, up, control=f"level {level}"))
    points = _points(scheme, ends, _level(scheme, options["samples"]))
    x, y = (tuple(_product(column, point) for point in points) for column in columns)
    return Drawing((*control, Polygon(x, y)), result)


def components(scheme: MatrixFamily, result: Result, samples: int) -> tuple[Curve, ...]:
    """The components of the curve at j p^-level; none unless it is proved to be well defined."""
    ends = _ends(result)
    if ends is None:
        return ()
    level, whole = _level(scheme, samples), (Fraction(0), Fraction(1))
    columns = zip(*_points(scheme, ends, level), strict=True)
    p = len(scheme.matrices)
    return tuple(
        Curve(p, level, 0, values, whole, name="ψ", label=f"ψ_{i}") for i, values in enumerate(columns, start=1)
    )


def sections(scheme: MatrixFamily, result: Result) -> tuple[Section, ...]:
    """The first components of the curve, where it is proved to be well defined, and the matrices."""
    drawn: tuple[Block, ...] = components(scheme, result, _CARD_POINTS)[:_MOST_SHOWN]
    picture = drawn or (Text("The curve is drawn where it is proved to be well defined.", "quiet"),)
    return Section("", picture), Section("matrices", tuple(matrices(scheme)))


def matrices(scheme: MatrixFamily) -> list[Block]:
    """The matrices, where they are not too large or too many."""
    p, n = len(scheme.matrices), len(scheme.matrices[0])
    if max(p, n) > _MOST_SHOWN:
        return [Text(f"{p} matrices of order {n}")]
    return [Matrix(f"A_{i}", tuple(tuple(map(rational, row)) for row in a)) for i, a in enumerate(scheme.matrices)]


def _ends(result: Result) -> tuple[Vector, Vector] | None:
    """The points ψ(0) and ψ(1) by the finding that proves that there is one curve; None where none does."""
    finding = answering(result.findings, q.WELL_DEFINED)
    if finding is None or result.well_defined is not Verdict.PROVED:
        return None
    witness = WELL_DEFINED.witness_of(finding)
    return witness["left"], witness["right"]


def _level(scheme: MatrixFamily, samples: int) -> int:
    """The smallest level with so many points, and no more numbers than are sane."""
    p, n, level = len(scheme.matrices), len(scheme.matrices[0]), 0
    while p**level < samples and n * p ** (level + 1) <= _MOST_NUMBERS:
        level += 1
    return level


def _points(scheme: MatrixFamily, ends: tuple[Vector, Vector], level: int) -> list[Vector]:
    """The points ψ(j p^-level), 0 <= j <= p^level."""
    columns = [tuple(zip(*a, strict=True)) for a in scheme.matrices]
    points = [ends[0]]
    for _ in range(level):
        points = [tuple(_product(column, x) for column in b) for b in columns for x in points]
    return [*points, ends[1]]


def _refined(scheme: MatrixFamily, column: Sequence[Fraction], level: int) -> tuple[Fraction, ...]:
    """The coordinates of the polygons of all pieces of a level, one after the other."""
    pieces = [tuple(column)]
    for _ in range(level):
        pieces = [tuple(_product(row, piece) for row in a) for piece in pieces for a in scheme.matrices]
    return tuple(x for piece in pieces for x in piece)


def _product(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), Fraction(0))
