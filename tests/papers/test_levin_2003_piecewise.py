"""A. Levin, Polynomial generation and quasi-interpolation in stationary non-uniform subdivision, 2003: section 3.5."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from support import findings

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.piecewise.rules import AT_ZERO, GENERATION, LOCAL_SPECTRUM
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Smoothness, Verdict
from subdiv_cli.pipeline import check

F = Fraction
SCHEME = read_path(masks_directory() / "piecewise" / "four_point_cubic.toml").scheme({})
RESULT = check(SCHEME, (), Effort()).result


def test_the_rules_are_the_printed_ones():
    rows = {i: [x for _, x in row] for i, row in SCHEME.special}
    assert rows[-1] == [F(-3, 64), F(1, 2), F(41, 64), F(-3, 32)]
    assert rows[1] == [F(-3, 37), F(24, 37), F(33, 74), F(-1, 74)]
    assert rows[2] == [F(-3, 148), F(6, 37), F(109, 148), F(9, 74)]
    assert rows[0] == [1]


def test_the_spectrum_is_the_printed_one():
    """1, 1/2, 1/4, 57/296, 1/8 are printed for five points; on the closed set there is -1/16 as well."""
    (finding,) = findings(RESULT, "SD822")
    witness = LOCAL_SPECTRUM.witness_of(finding)
    assert witness["points"] == (-3, -2, -1, 0, 1, 2)
    roots = {-F(f[0], f[1]) for f in witness["factors"]}
    assert roots == {F(1), F(1, 2), F(1, 4), F(57, 296), F(1, 8), F(-1, 16)}
    five = range(-2, 3)
    a = np.array([[float(dict(SCHEME.row(i)).get(j, 0)) for j in five] for i in five])
    assert sorted(np.linalg.eigvals(a).real) == pytest.approx(sorted([1, 1 / 2, 1 / 4, 57 / 296, 1 / 8]))


def test_all_cubics_are_generated():
    """Q f = f on the left and f - f''/6 on the right; Q x^2 = (…, 4, 1, 0, 1 - 1/3, 4 - 1/3, …), as in Figure 3."""
    (finding,) = findings(RESULT, "SD821")
    witness = GENERATION.witness_of(finding)
    assert witness["degree"] == RESULT.generation == 3
    assert (witness["left"], witness["right"]) == ((1, 0, 0, 0), (1, 0, F(-1, 6), 0))
    values = dict(enumerate(witness["sequences"][2], witness["start"]))
    assert [values[i] for i in range(-3, 4)] == [9, 4, 1, 0, F(2, 3), F(11, 3), F(26, 3)]


def test_limits_are_continuously_differentiable():
    """C^1 is printed; it is not C^2, and the exponent 2.376563351 at 0 is larger than that of the four-point scheme."""
    assert RESULT.convergent is Verdict.PROVED
    assert RESULT.smoothness == Smoothness(1, sharp=True)
    assert RESULT.holder.exact == 2
    assert str(RESULT.holder_at_zero.exact) == "log2(296/57)"
    assert RESULT.holder_at_zero.lower == pytest.approx(2.376563351)
    (finding,) = findings(RESULT, "SD824")
    assert AT_ZERO.witness_of(finding)["root"]["low"] == F(57, 296)


def limit_error(step, reach=4):
    """The largest error on [-reach, reach] of the limit of Q cos, samples taken at multiples of the step."""
    last = round(reach / step) + 12
    places = np.arange(-last, last + 1)
    samples = np.cos(places * step)
    data = samples.copy()
    data[last + 1 : -1] -= (samples[last + 2 :] - 2 * samples[last + 1 : -1] + samples[last:-2]) / 6
    data[-1] = samples[-1]
    data = dict(zip(places.tolist(), data.tolist(), strict=True))
    for _ in range(9):
        first, end = 2 * min(data) + 6, 2 * max(data) - 6
        data = {i: sum(float(x) * data[j] for j, x in SCHEME.row(i)) for i in range(first, end + 1)}
    scale = step / 2**9
    at = {i: x if i <= 0 else (data[i - 1] + 4 * x + data[i + 1]) / 6 for i, x in data.items() if i + 1 in data}
    return max(abs(x - np.cos(i * scale)) for i, x in at.items() if abs(i * scale) <= reach)


def test_the_errors_of_the_cosine_fall_like_the_fourth_power():
    """The printed errors belong to no single interval; on [-4, 4] they are these, with ratios near the printed ones."""
    errors = [limit_error(1 / 2**n) for n in range(3)]
    assert errors == pytest.approx([0.025453, 0.0018283, 0.00011770], rel=1e-3)
    assert [a / b for a, b in pairwise(errors)] == pytest.approx([13.9, 15.5], abs=0.1)
