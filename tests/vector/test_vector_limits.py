"""Values of limits and derivatives against S^n δ, the pictures, the page of `show`, and commands on these masks."""

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from matrix_masks import DGHM, DOUBLE_KNOT_CUBIC, HERMITE_CUBIC, blocked, scheme, spline
from support import subdiv

from subdiv_cli.catalog.trust import trusted
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.kinds.vector.numbers.values import limit_curves, refined, stencils
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import check

MASKS = Path(__file__).parents[2] / "masks" / "vector"
FILE = MASKS / "double_knot_cubic.toml"


def value(curve, x):
    """The value of a curve at a point of its grid."""
    place = x * curve.arity**curve.level - curve.start
    assert place.denominator == 1
    return curve.values[int(place)] if 0 <= place < len(curve.values) else Fraction(0)


def test_cubic_hermite_functions():
    """For e_1: 1 - 3x²+2x³ on [0, 1], and its derivative; for e_2: x(1-x)²."""
    curves = limit_curves(VectorNumbers(scheme(HERMITE_CUBIC), Effort()), 1, 60)
    assert [(c.order, c.label, c.name) for c in curves] == [
        (0, "e_1", "f"), (1, "e_1", "f"), (0, "e_2", "f"), (1, "e_2", "f"),
    ]  # fmt: skip
    for i in range(1, 16):
        x = Fraction(i, 16)
        assert value(curves[0], x) == 1 - 3 * x**2 + 2 * x**3 == value(curves[0], -x)
        assert value(curves[1], x) == -6 * x + 6 * x**2 == -value(curves[1], -x)
        assert value(curves[2], x) == x * (1 - x) ** 2
        assert value(curves[3], x) == 1 - 4 * x + 3 * x**2


def test_b_splines_with_double_knots():
    """The two Bernstein-like functions of knots 0,0,1,1,2 and 0,1,1,2,2: values and slopes at 1."""
    first, slope, second, _ = limit_curves(VectorNumbers(scheme(DOUBLE_KNOT_CUBIC), Effort()), 1, 60)
    assert (value(first, Fraction(1)), value(second, Fraction(1))) == (Fraction(1, 2), Fraction(1, 2))
    assert value(slope, Fraction(1)) == Fraction(-3, 2)
    assert value(first, Fraction(1, 2)) + value(second, Fraction(1, 2)) + value(first, Fraction(3, 2)) + value(
        second, Fraction(3, 2)
    ) == 1  # fmt: skip


@pytest.mark.parametrize(
    ("mask", "arity"),
    [(DGHM, 2), (spline(3, 2, 3), 3), ({i + 1: a for i, a in spline(3, 2, 3).items()}, 3), (spline(2, 2), 2)],
)
def test_limits_are_those_of_the_data(mask, arity):
    """(w * S^n c)(a) u against S^(n+8) c at the same points, which need not be exact."""
    numbers = VectorNumbers(scheme(mask, arity), Effort())
    found = stencils(numbers)
    fine = 9 if arity == 2 else 6
    for unit in range(2):
        data, low = refined(numbers, unit, fine)
        at = [Fraction(0), Fraction(1), Fraction(2)]
        for x in at:
            got = sum(
                sum(a * b for a, b in zip(found.each[0].tolist()[k], [int(unit == j) for j in range(2)], strict=True))
                for k in [int(x) - found.start]
                if 0 <= k < found.each[0].nrows()
            )
            for component, u in enumerate(numbers.constants[0]):
                place = int(x * arity**fine) - low
                there = data[component][place] if place >= 0 else 0
                assert abs(float(Fraction(str(there))) - float(Fraction(str(got))) * float(u)) < 0.03


def test_blocks_have_the_limits_of_the_scalar_scheme():
    """The basic limit functions of Chaikin in pairs are the quadratic B-spline at 2x, and its translate."""
    from subdiv_cli.kinds.scalar.numbers.curve import curve, integer_values
    from subdiv_cli.kinds.scalar.scheme import ScalarScheme

    quarter = Fraction(1, 4)
    chaikin = ScalarScheme(arity=2, start=-1, coefficients=(quarter, 3 * quarter, 3 * quarter, quarter))
    phi = curve(chaikin, integer_values(chaikin))
    blocks = limit_curves(VectorNumbers(scheme(blocked(chaikin.coefficients, -1, 2)), Effort()), 0, 60)
    for i in range(-32, 33):
        x = Fraction(i, 16)
        assert value(blocks[0], x) == value(phi, 2 * x)
        assert value(blocks[1], x) == value(phi, 2 * x - 1)


def test_show_and_its_json():
    page = subdiv("show", FILE)
    assert page.returncode == 0
    for text in ("E_A is spanned by (1, 1)", "eigenvalues of M_A: 1, 1/8", "(1, 1) i + (2/3, 4/3)", "canonical R"):
        assert text in page.stdout
    data = json.loads(subdiv("show", FILE, "--format", "json").stdout)
    assert data["canonical_transformation"] == [["1", "1"], ["1", "-1"]]
    (stencil,) = data["limit_stencils"]["stencils"]
    assert [row for row in stencil if row != ["0", "0"]] == [["1/2", "1/2"]]
    assert data["eigen_sequences"][1] == [[["2/3", "4/3"], ["1", "1"]]]


@pytest.mark.parametrize("form", ["html", "markdown", "junit", "json", "concise"])
def test_reports_of_every_form(form):
    found = subdiv("check", FILE, "--no-cache", "--format", form)
    assert found.returncode == 0, found.stderr
    if form == "html":
        assert "f for the data e_1" in found.stdout
        assert "limit at k" in found.stdout
    if form == "json":
        (result,) = json.loads(found.stdout)["results"]
        assert (result["dimension"], result["kind"], result["sobolev"]) == (1, "vector", None)
        assert (result["stable"], result["reproduction"]) == ({"verdict": "skipped"}, None)


def test_pictures(tmp_path):
    assert "│" in subdiv("plot", FILE).stdout
    assert subdiv("plot", FILE, "-o", tmp_path / "f.svg").returncode == 0
    assert (tmp_path / "f.svg").read_bytes().startswith(b"<?xml")
    nothing = subdiv("plot", MASKS / "counterexamples" / "double_knot_linear.toml")
    assert (nothing.returncode, nothing.stdout) == (1, "")
    assert "nothing to draw" in nothing.stderr


def test_certificates_and_the_plain_file(tmp_path):
    assert subdiv("check", FILE, "--no-cache", "--certificate", tmp_path).returncode == 0
    proof = tmp_path / "double_knot_cubic.json"
    outcome = subdiv("verify", proof, "--mask", FILE)
    assert outcome.returncode == 0
    assert "VERIFIED E_A has dimension 1" in outcome.stdout
    other = subdiv("verify", proof, "--mask", MASKS / "dghm.toml")
    assert (other.returncode, "another mask" in other.stdout) == (1, True)


@pytest.mark.parametrize("name", ["double_knot_cubic", "two_four_points", "counterexamples/no_constants"])
def test_kept_results_are_trusted_as_they_are_and_not_otherwise(name):
    """The cache: every answer follows from verified statements, and altered ones do not."""
    mask = read_path(MASKS / f"{name}.toml")
    checked = check(mask.scheme(), mask.expectations, Effort())
    result, proof = checked.result, checked.certificate_text()
    assert trusted(result, proof, mask.scheme(), mask.expectations)
    for wrong in ({"dimension": 7}, {"sum_rule_order": 9}, {"generation": 8}):
        assert not trusted(replace(result, **wrong), proof, mask.scheme(), mask.expectations)


def test_expectations_are_judged(tmp_path):
    file = tmp_path / "m.toml"
    file.write_text(FILE.read_text(encoding="utf-8").replace("dimension = 1", "dimension = 2"), encoding="utf-8")
    found = subdiv("check", file, "--no-cache")
    assert found.returncode == 1
    assert "dimension = 2" in found.stdout
