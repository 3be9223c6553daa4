"""Functions of two variables drawn: in letters they fit and say what is high, by matplotlib the same bytes twice."""

from fractions import Fraction
from itertools import product

import pytest

from subdiv_cli.model.blocks import Heights
from subdiv_cli.plot.heights import draw_heights
from subdiv_cli.plot.relief import Relief, relief, sampled
from subdiv_cli.plot.reliefs import STYLES, reliefs

F = Fraction
HALF = ((F(1, 2), F(0)), (F(0), F(1, 2)))
HAT = Heights(HALF, {(i, j): F((2 - abs(i)) * (2 - abs(j)), 4) for i, j in product((-1, 0, 1), repeat=2)})
TURNED = Heights(((F(1, 2), F(1, 2)), (F(1, 2), F(-1, 2))), HAT.values)
SIGNED = Heights(HALF, {**HAT.values, (2, 0): F(-1, 3)})
MAGIC = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF"}


def test_the_hat_in_ascii():
    assert draw_heights(HAT, width=22, height=5, unicode=False) == [
        "         1 |",
        "           | ++###++",
        "           | ++###++",
        "        -1 |",
        "           +---------",
        "            -1      1",
        "  . to 0.2   : to 0.4",
        "  + to 0.6   * to 0.8",
        "  # to 1",
    ]


@pytest.mark.parametrize("unicode", [True, False])
@pytest.mark.parametrize("width", [1, 20, 40, 79, 200])
@pytest.mark.parametrize("height", [1, 4, 30])
@pytest.mark.parametrize("heights", [HAT, TURNED, SIGNED])
def test_it_fits(unicode, width, height, heights):
    rows = draw_heights(heights, width=width, height=height, unicode=unicode)
    assert all(len(row) <= max(width, 24) for row in rows)
    assert "".join(rows).isascii() is (not unicode)
    assert ("- -0.333 to 0" in "\n".join(rows)) is (heights is SIGNED)


def test_a_grid_has_a_ring_of_zeros():
    found = relief(HAT, "hat")
    line = (-1.0, -0.5, 0.0, 0.5, 1.0)
    assert (found.x, found.y) == (line, line)
    assert found.z[0] == found.z[4] == (0.0,) * 5
    assert found.z[2] == (0.0, 0.5, 1.0, 0.5, 0.0)


def test_a_dilation_that_is_negative_turns_nothing_around():
    turned = Heights(((F(-1, 2), F(0)), (F(0), F(-1, 2))), {(1, 0): F(1), (0, 0): F(2)})
    found = relief(turned, "turned")
    assert found.x == (-1.0, -0.5, 0.0, 0.5)
    assert found.z[1] == (0.0, 1.0, 2.0, 0.0)


def test_another_grid_is_sampled_at_its_nearest_points():
    raster, box = sampled(TURNED, 9, 9)
    assert box == [(-2.0, 2.0), (-2.0, 2.0)]
    assert raster[4][4] == 1.0
    assert raster == raster[::-1] == [row[::-1] for row in raster]
    assert relief(TURNED, "turned").x == relief(TURNED, "turned").y


@pytest.mark.parametrize("form", MAGIC)
@pytest.mark.parametrize("style", STYLES)
def test_each_format(form, style):
    pytest.importorskip("matplotlib")
    panels = [relief(HAT, "φ — hat"), relief(SIGNED, "φ — signed")]
    content = reliefs(panels, form, style)
    assert content.startswith(MAGIC[form])
    assert content == reliefs(panels, form, style)
    assert reliefs(panels[:1], form, style) != content


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9])
def test_heights_of_any_size(scale):
    pytest.importorskip("matplotlib")
    small = Relief("", (0.0, 1.0, 2.0), (0.0, 1.0, 2.0), ((0.0,) * 3, (0.0, scale, 0.0), (0.0,) * 3))
    for style in STYLES:
        assert reliefs([small], "png", style).startswith(MAGIC["png"])
