"""The key `box_spline = {directions = [[1,0],[0,1],[1,1]], multiplicities = [2,2,2]}` of a mask file."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.multivariate.text.bodies import BoxSplineMask
from subdiv_cli.kinds.multivariate.text.dilation import Dilation
from subdiv_cli.kinds.multivariate.text.integers import integer_list
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_DIMENSION, MAX_FACTORS
from subdiv_cli.maskfile.entries import Table
from subdiv_cli.maskfile.problems import Fault
from subdiv_cli.maskfile.values import described
from subdiv_cli.spaces.lattice import Index

_HELP = "write box_spline = {directions = [[1,0],[0,1],[1,1]], multiplicities = [2,2,2]}"


def read_box_spline(table: Table, dilation: Dilation) -> BoxSplineMask | None:
    """The body of a box spline; None where something is wrong, which is recorded."""
    inner = table.table("box_spline", _HELP)
    if inner is None:
        return None
    inner.only(("directions", "multiplicities"))
    directions = _directions(inner)
    multiplicities = None if directions is None else _multiplicities(inner, len(directions))
    if dilation.rows is not None and dilation.factor is None:
        message = "a box spline is refined by its mask for dilations 2, 3, … only, not for this matrix"
        help = "give the mask itself: symbol in z1, z2, …, or terms"
        table.problems.add(Fault(faults.BAD_DILATION, message, help), dilation.path)
        return None
    if directions is None:
        return None
    matrix = dilation.of(len(directions[0]))
    if matrix is None or multiplicities is None:
        return None
    return BoxSplineMask(dilation=matrix, directions=directions, multiplicities=multiplicities)


def _directions(inner: Table) -> tuple[Index, ...] | None:
    value, path = inner.data.get("directions"), (*inner.path, "directions")
    if value is None:
        inner.missing("directions", "the directions of the box spline are missing", _HELP)
        return None
    fault = None
    if not isinstance(value, list) or not value:
        given = "an empty list" if value == [] else described(value)
        fault = Fault(faults.WRONG_TYPE, f"directions must be a list of vectors, not {given}", _HELP)
    elif len(value) > MAX_FACTORS:
        fault = Fault(
            faults.OUT_OF_BOUNDS, f"{len(value)} directions; the limit is {MAX_FACTORS}", "use multiplicities"
        )
    if fault:
        inner.problems.add(fault, path)
        return None
    assert isinstance(value, list), "anything else is a fault"
    read = [integer_list(x, (*path, i), inner.problems, "a direction", _HELP) for i, x in enumerate(value)]
    directions = tuple(direction for direction in read if direction is not None)
    if len(directions) < len(read):
        return None
    if fault := _of_directions(directions):
        inner.problems.add(fault, path)
        return None
    return directions


def _of_directions(directions: tuple[Index, ...]) -> Fault | None:
    """The fault of directions that give no box spline; None where they do."""
    s = len(directions[0])
    if any(len(direction) != s for direction in directions):
        return Fault(
            faults.BAD_SHAPE, "the directions have different numbers of components", "give each one for each variable"
        )
    if not 2 <= s <= MAX_DIMENSION:
        message = f"the directions have {s} component{'' if s == 1 else 's'}; there are 2 to {MAX_DIMENSION} variables"
        return Fault(faults.BAD_SHAPE, message, _HELP)
    if rank(directions) < s:
        message = f"the directions span {rank(directions)} of {s} dimensions: there is no such box spline"
        return Fault(faults.BAD_SHAPE, message, "add a direction: [1,0], [0,1]")
    if not all(map(any, directions)):
        return Fault(faults.BAD_SHAPE, "a direction is zero", "leave it out")
    return None


def _multiplicities(inner: Table, count: int) -> tuple[int, ...] | None:
    """The multiplicities, all 1 where none are given; None where something is wrong, which is recorded."""
    if "multiplicities" not in inner.data:
        return (1,) * count
    path = (*inner.path, "multiplicities")
    counts = integer_list(inner.data["multiplicities"], path, inner.problems, "multiplicities", _HELP)
    if counts is None:
        return None
    fault = None
    if len(counts) != count:
        fault = Fault(
            faults.BAD_SHAPE, f"{len(counts)} multiplicities for {count} directions", "give each direction one"
        )
    elif min(counts) < 1:
        fault = Fault(
            faults.OUT_OF_BOUNDS, f"a multiplicity must be at least 1, not {min(counts)}", "leave the direction out"
        )
    elif sum(counts) > MAX_FACTORS:
        fault = Fault(
            faults.OUT_OF_BOUNDS, f"{sum(counts)} factors; the limit is {MAX_FACTORS}", "use smaller multiplicities"
        )
    if fault:
        inner.problems.add(fault, path)
        return None
    return counts


def rank(vectors: tuple[Index, ...]) -> int:
    """The dimension of the span of integer vectors, by elimination."""
    rows = [list(map(Fraction, vector)) for vector in vectors]
    pivots = 0
    for column in range(len(vectors[0])):
        pivot = next((i for i in range(pivots, len(rows)) if rows[i][column]), None)
        if pivot is None:
            continue
        rows[pivots], rows[pivot] = rows[pivot], rows[pivots]
        for row in rows[pivots + 1 :]:
            factor = row[column] / rows[pivots][column]
            row[:] = [x - factor * y for x, y in zip(row, rows[pivots], strict=True)]
        pivots += 1
    return pivots
