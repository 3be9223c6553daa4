"""Curves drawn with letters."""

from fractions import Fraction

import pytest

from subdiv_cli.model.blocks import Curve, Polygon
from subdiv_cli.plot.sampled import Line, graph, line, plane
from subdiv_cli.plot.terminal import draw

HAT = graph(Curve(2, 1, -1, (Fraction(1, 2), Fraction(1), Fraction(1, 2)), (Fraction(-1), Fraction(1))), "φ")


def test_a_graph_ends_where_its_support_ends():
    hat = HAT
    assert hat == Line("φ", (-1.0, -0.5, 0.0, 0.5, 1.0), (0.0, 0.5, 1.0, 0.5, 0.0))


def test_a_closed_polygon_returns():
    polygon = Polygon((Fraction(0), Fraction(1)), (Fraction(0), Fraction(2)), closed=True, control="square")
    square = plane(polygon, "of a mask")
    assert (square.label, square.x, square.y, square.polygon) == ("square", (0.0, 1.0, 0.0), (0.0, 2.0, 0.0), True)


def test_the_hat_in_ascii():
    assert draw([HAT], width=25, height=4, unicode=False) == [
        "         1 |     .:",
        "           |   .'  '.",
        "           | .''    ''.",
        "         0 |.'        '.",
        "           +------------",
        "            -1         1",
    ]


@pytest.mark.parametrize("unicode", [True, False])
@pytest.mark.parametrize("width", [1, 20, 40, 79, 200])
@pytest.mark.parametrize("height", [1, 4, 30])
def test_it_fits(unicode, width, height):
    rows = draw([HAT, line("level", [(0.0, 0.5), (3.0, 0.5)])], width=width, height=height, unicode=unicode)
    assert len(rows) == max(height, 4) + 2
    assert all(len(row) <= max(width, 24) for row in rows)
    assert "".join(rows).isascii() is (not unicode)


def test_nothing_and_constants_and_single_points():
    assert len(draw([], width=40, height=4)) == 6
    assert len(draw([line("", [(1.0, 2.0)])], width=40, height=4)) == 6
    assert len(draw([line("", [(0.0, 2.0), (1.0, 2.0)])], width=40, height=4)) == 6


def test_every_value_is_hit():
    """As many dots in a column as the graph passes, and its top and bottom rows are not empty."""
    rows = draw([HAT], width=60, height=10)
    assert rows[0].strip("│ 1")
    assert rows[9].strip("│ 0")
