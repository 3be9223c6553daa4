"""Curves of polygons: against subdivision of the same data, closed and open."""

from fractions import Fraction

import pytest
from support import b_spline, corner_cutting, four_point, scheme

from subdiv_cli.kinds.scalar import KIND
from subdiv_cli.kinds.scalar.numbers.operators import apply
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.portrait.curves import TooFewPointsError, limit
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import draw

F = Fraction
POLYGON = (tuple(map(F, (0, 1, 2, 4, 4, 2, 0, -1))), tuple(map(F, (0, 2, 0, 0, 3, 4, 3, 1))))
MASKS = {
    "four-point": four_point("1/16"),
    "cubic": scheme(b_spline(3).coefficients, start=-2),
    "corner cutting": corner_cutting("3/4", "1/4"),
    "ternary": scheme(b_spline(3, 3).coefficients, start=-1, arity=3),
}


CURVES, FUNCTIONS = KIND.drawings


def traced(mask, columns, samples, *, closed, levels=0):
    """The control polygons and the limit curve, each x and y."""
    options = {"points": columns, "samples": samples, "closed": closed, "levels": levels}
    *control, curve = draw(mask, CURVES, options, Effort()).blocks
    assert [polygon.control for polygon in control] == ["control polygon", *(f"level {i + 1}" for i in range(levels))]
    assert (control[0].x, control[0].y, control[0].closed) == (*columns, closed)
    return [(polygon.x, polygon.y) for polygon in control], (curve.x, curve.y)


@pytest.mark.parametrize("name", MASKS)
@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("level", [1, 2, 3])
def test_polygons_are_those_of_subdivision(name, closed, level):
    mask = MASKS[name]
    symbol, p, count = ScalarNumbers(mask, Effort()).symbol, mask.arity, len(POLYGON[0])
    refined, _ = traced(mask, POLYGON, 50, closed=closed, levels=level)
    for column, vertices in zip(POLYGON, refined[level], strict=True):
        reach = range(-3 * count, 4 * count) if closed else range(count)
        data = {i: column[i % count] for i in reach}
        for _ in range(level):
            data = apply(symbol, p, data)
        if closed:
            assert vertices == tuple(data[i] for i in range(count * p**level))
        else:
            low = mask.start * (p**level - 1) // (p - 1) + mask.degree * (p**level - 1) // (p - 1) - p**level + 1
            assert vertices == tuple(data.get(low + i, F(0)) for i in range(len(vertices)))
            # what lies outside depends on points that the polygon does not have
            moved = {**{i: column[i] for i in range(count)}, -1: F(100), count: F(100)}
            for _ in range(level):
                moved = apply(symbol, p, moved)
            assert vertices == tuple(moved.get(low + i, F(0)) for i in range(len(vertices)))
            assert moved[low - 1] != data.get(low - 1, 0)
            assert moved[low + len(vertices)] != data.get(low + len(vertices), 0)


def test_an_interpolatory_curve_passes_through_its_points():
    curves = limit(ScalarNumbers(MASKS["four-point"], Effort()), POLYGON, 100, closed=True)
    _, drawn = traced(MASKS["four-point"], POLYGON, 100, closed=True)
    assert drawn == tuple(curve.values for curve in curves)
    for column, curve in zip(POLYGON, curves, strict=True):
        step = 2**curve.level
        assert curve.start == 0
        assert curve.values[::step] == (*column, column[0])


@pytest.mark.parametrize("name", MASKS)
def test_the_limit_is_near_a_fine_polygon(name):
    refined, curve = traced(MASKS[name], POLYGON, 100, closed=True, levels=6 if "tern" not in name else 4)
    for values, vertices in zip(curve, refined[-1], strict=True):
        assert max(values) == pytest.approx(float(max(vertices)), abs=0.01)
        assert min(values) == pytest.approx(float(min(vertices)), abs=0.01)


def test_an_open_curve_knows_how_many_points_it_needs():
    for name, mask in MASKS.items():
        with pytest.raises(TooFewPointsError) as caught:
            traced(mask, tuple(column[:2] for column in POLYGON), 50, closed=False)
        needed = caught.value.needed
        with pytest.raises(TooFewPointsError):
            traced(mask, tuple(column[: needed - 1] for column in POLYGON), 50, closed=False)
        if needed <= len(POLYGON[0]):
            columns = tuple(column[:needed] for column in POLYGON)
            assert traced(mask, columns, 50, closed=False)[1][0], name


def test_a_polygon_whose_ends_meet_is_closed():
    around = tuple((*column, column[0]) for column in POLYGON)
    options = {"points": around, "samples": 50}
    control, curve = draw(MASKS["cubic"], CURVES, options, Effort()).blocks
    assert (control.x, control.y, control.closed) == (*POLYGON, True)
    assert (curve.x, curve.y) == traced(MASKS["cubic"], POLYGON, 50, closed=True)[1]


def test_functions_up_to_the_proved_order():
    result = draw(MASKS["cubic"], FUNCTIONS, {"samples": 100}, Effort())
    assert [curve.order for curve in result.blocks] == [0, 1, 2]
    assert {curve.support for curve in result.blocks} == {(-2, 2)}
    assert result.result.refinable.order == 2
    assert max(result.blocks[0].values) == F(2, 3)
    fewer = draw(MASKS["cubic"], FUNCTIONS, {"samples": 100, "derivatives": 1}, Effort())
    assert fewer.blocks == result.blocks[:2]
    assert draw(scheme([1, 1]), FUNCTIONS, {"samples": 100}, Effort()).blocks == ()
