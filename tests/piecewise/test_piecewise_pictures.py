"""Pictures of piecewise schemes: the limits of unit data near 0, against splines and against iteration."""

from fractions import Fraction

import numpy as np
import pytest
from bsplines import spline_scheme
from random_piecewise import limit_value, mask, random_scheme
from support import cases, seeded, subdiv

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.piecewise.numbers.piecewise import PiecewiseNumbers
from subdiv_cli.kinds.piecewise.portrait.pictures import limits
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check

FOLDER = masks_directory() / "piecewise"


def drawn(scheme, samples=60):
    """The curves as functions, points of the parameter in its unit -> values, by the point of their data."""
    result = check(scheme, (), Effort()).result
    curves = limits(PiecewiseNumbers(scheme, Effort()), result, samples)
    functions = {}
    for curve in curves:
        unit = Fraction(1, curve.arity**curve.level)
        point = int(curve.label.removeprefix("c_").removesuffix(" = 1"))
        functions[point] = {(curve.start + i) * unit: y for i, y in enumerate(curve.values)}
    return curves, functions


def test_hats_with_two_spacings():
    curves, functions = drawn(PiecewiseScheme(mask("hat"), mask("hat"), (Fraction(1), Fraction(2))))
    assert {curve.name for curve in curves} == {"F(2·)"}
    assert sorted(functions) == [-1, 0, 1]
    for x, y in functions[0].items():  # x = 1/2 is old point -1 or 1/2 of the way to point 1, 2 to the right
        assert y == max(0, 1 - abs(x) * (2 if x < 0 else 1))


@pytest.mark.parametrize(("degree", "spacing", "multiplicity"), [(2, (1, 3), 1), (3, (1, 2), 2), (3, (2, 1), 1)])
def test_b_splines_are_a_partition_of_unity(degree, spacing, multiplicity):
    _, functions = drawn(spline_scheme(degree, spacing, multiplicity))
    near = [Fraction(k, 8) for k in range(-1, 2)]
    for x in near:
        assert sum(values.get(x, 0) for values in functions.values()) == 1
    assert all(y >= 0 for values in functions.values() for y in values.values())


def test_values_are_those_of_iteration():
    rng, compared = seeded(827), 0
    for _ in range(cases(6)):
        scheme = random_scheme(rng)
        scheme = PiecewiseScheme(scheme.left, scheme.right, special=scheme.special)
        if check(scheme, (), Effort()).result.convergent is not Verdict.PROVED:
            continue
        _, functions = drawn(scheme, 30)
        for j, values in functions.items():
            for i in (*range(-12, -7), *range(8, 13)):
                data = np.zeros(81)
                data[j + 40] = 1
                assert limit_value(scheme, data, -40, i) == pytest.approx(float(values.get(Fraction(i), 0)), abs=1e-9)
                compared += 1
    assert compared > 100


def test_plot_draws_them(tmp_path):
    file = tmp_path / "limits.svg"
    assert subdiv("plot", FOLDER / "four_point_cubic.toml", "-o", file).returncode == 0
    text = file.read_text(encoding="utf-8")
    assert "four-point scheme joined to cubic B-splines" in text
    letters = subdiv("plot", FOLDER / "bspline_cubic_double_knot.toml")
    assert letters.returncode == 0
    assert "F — cubic B-splines with a double knot" in letters.stdout
    refused = subdiv("plot", FOLDER / "counterexamples" / "bumps_2.toml")
    assert refused.returncode != 0
    html = subdiv("check", FOLDER / "four_point_cubic.toml", "--no-cache", "--format", "html").stdout
    assert html.count("the limit function F for the data") >= 6
