"""Curves of polygons: against subdivision of the same data, closed and open."""

from fractions import Fraction

import pytest
from support import b_spline, corner_cutting, four_point, scheme

from subdiv_cli.kinds.scalar.numbers.operators import apply
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Effort
from subdiv_cli.portrait import TooFewPointsError, drawn, traced

F = Fraction
POLYGON = (tuple(map(F, (0, 1, 2, 4, 4, 2, 0, -1))), tuple(map(F, (0, 2, 0, 0, 3, 4, 3, 1))))
MASKS = {
    "four-point": four_point("1/16"),
    "cubic": scheme(b_spline(3).coefficients, start=-2),
    "corner cutting": corner_cutting("3/4", "1/4"),
    "ternary": scheme(b_spline(3, 3).coefficients, start=-1, arity=3),
}


@pytest.mark.parametrize("name", MASKS)
@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("level", [1, 2, 3])
def test_polygons_are_those_of_subdivision(name, closed, level):
    mask = MASKS[name]
    symbol, p, count = ScalarNumbers(mask, Effort()).symbol, mask.arity, len(POLYGON[0])
    _, _, refined = traced(mask, Effort(), POLYGON, 50, closed=closed, levels=level)
    for column, vertices in zip(POLYGON, refined[level - 1], strict=True):
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
    _, curves, _ = traced(MASKS["four-point"], Effort(), POLYGON, 100, closed=True, levels=0)
    for column, curve in zip(POLYGON, curves, strict=True):
        step = 2**curve.level
        assert curve.start == 0
        assert curve.values[::step] == (*column, column[0])


@pytest.mark.parametrize("name", MASKS)
def test_the_limit_is_near_a_fine_polygon(name):
    _, curves, refined = traced(MASKS[name], Effort(), POLYGON, 100, closed=True, levels=6 if "tern" not in name else 4)
    for curve, vertices in zip(curves, refined[-1], strict=True):
        assert max(curve.values) == pytest.approx(float(max(vertices)), abs=0.01)
        assert min(curve.values) == pytest.approx(float(min(vertices)), abs=0.01)


def test_an_open_curve_knows_how_many_points_it_needs():
    for name, mask in MASKS.items():
        with pytest.raises(TooFewPointsError) as caught:
            traced(mask, Effort(), tuple(column[:2] for column in POLYGON), 50, closed=False, levels=0)
        needed = caught.value.needed
        with pytest.raises(TooFewPointsError):
            traced(mask, Effort(), tuple(column[: needed - 1] for column in POLYGON), 50, closed=False, levels=0)
        if needed <= len(POLYGON[0]):
            columns = tuple(column[:needed] for column in POLYGON)
            _, curves, _ = traced(mask, Effort(), columns, 50, closed=False, levels=0)
            assert curves[0].values, name


def test_functions_up_to_the_proved_order():
    result, curves, support = drawn(MASKS["cubic"], Effort(), 100)
    assert [curve.order for curve in curves] == [0, 1, 2]
    assert support == (-2, 2)
    assert result.refinable.order == 2
    assert max(curves[0].values) == F(2, 3)
    assert drawn(scheme([1, 1]), Effort(), 100)[1] == ()
