"""Hermite masks in reports: exponents of derivatives, properties on the command line, pages and pictures."""

import json
from fractions import Fraction
from math import comb

import pytest
from matrix_masks import HERMITE_CUBIC, de_rham, hermite_interpolation, merrien, scheme
from support import subdiv

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.exact.closed import closed_ball
from subdiv_cli.kinds.hermite import KIND
from subdiv_cli.kinds.hermite.numbers import HermiteNumbers
from subdiv_cli.model import Effort, Exponent, Verdict, logarithm
from subdiv_cli.model.closed import plus
from subdiv_cli.pipeline import check, draw, show

MASKS = masks_directory() / "hermite"


@pytest.mark.parametrize("n", [0, -1, -2, 5])
def test_an_exponent_plus_an_integer(n):
    root = check(scheme(de_rham(HERMITE_CUBIC), kind="hermite"), (), Effort()).result.holder.exact
    for x in (Fraction(7, 2), logarithm(2, Fraction(64, 9)), logarithm(3, Fraction(11), 2), root):
        total = plus(x, n)
        assert abs(float(closed_ball(x)) + n - float(closed_ball(total))) < 1e-12
    assert plus(root, 0) == root
    assert plus(logarithm(2, Fraction(64, 9)), -1) == logarithm(2, Fraction(32, 9))


def test_the_exponent_of_a_derivative_is_read_again_as_the_same_number():
    from subdiv_cli.exact.closed import compare
    from subdiv_cli.maskfile.closed import read_closed_form

    root = check(scheme(merrien("-1/10", "-1/2"), kind="hermite"), (), Effort()).result.holder.exact
    exponent = plus(root, -1)
    assert str(exponent) == "-log2(root(80*x^2-30*x+1, 0.338019, 0.338020))-1"
    assert exponent.root.coefficients == (1, -15, 20)
    assert compare(read_closed_form(str(exponent)), exponent) == 0


def test_bounds_of_a_derivative_are_outward():
    x = Exponent(lower=0.1 + 1, upper=1.3, digits="1.1000…")
    found = x.of_derivative(1)
    assert Fraction(found.lower) <= Fraction(x.lower) - 1
    assert Fraction(found.upper) >= Fraction(x.upper) - 1
    assert Fraction(found.upper) - Fraction(found.lower) < Fraction(201, 1000)
    assert found.digits == "0.1000…"
    assert Exponent(digits="2.5…e-7").of_derivative(0).digits is None


def test_derivatives_in_the_report():
    done = subdiv("check", MASKS / "hermite_quintic.toml", "--format", "json")
    assert done.returncode == 0
    (result,) = json.loads(done.stdout)["results"]
    assert [(x["order"], x["holder"]["exact"]) for x in result["derivatives"]] == [(1, "2"), (2, "1")]
    assert result["spectral"] == {"verdict": "proved"}
    done = subdiv("check", MASKS / "counterexamples" / "merrien_8_2.toml", "--format", "json")
    (result,) = json.loads(done.stdout)["results"]
    assert (done.returncode, result["derivatives"], result["smoothness"]["order"]) == (0, None, None)
    assert result["holder"]["exact"] == "log2(4/3)"


@pytest.mark.parametrize(
    ("file", "required", "expected"),
    [
        ("hermite_cubic", "HC1", 0),
        ("hermite_cubic", "HC2", 1),
        ("de_rham_cubic", "HC2", 0),
        ("counterexamples/merrien_8_2", "HC1", 1),
        ("counterexamples/no_derivative", "HC0", 1),
        ("unseen_linear", "spectral", 1),
    ],
)
def test_properties_on_the_command_line(file, required, expected):
    assert subdiv("check", MASKS / f"{file}.toml", "--require", required).returncode == expected


def test_shown_and_drawn():
    mask = scheme(HERMITE_CUBIC, kind="hermite")
    _, portrait = show(mask, Fraction(1, 1000), Effort())
    assert portrait.data["eigen_sequences"][1] == (((0, 1), (1, 0)),)
    drawing = draw(mask, KIND.drawings[0], {"samples": 100, "derivatives": None}, Effort())
    assert [(curve.order, curve.label) for curve in drawing.blocks] == [(0, "e_0"), (1, "e_0"), (0, "e_1"), (1, "e_1")]
    for curve in drawing.blocks:  # f(0), f'(0): the jets that are interpolated
        at_0 = curve.values[-curve.start] if 0 <= -curve.start < len(curve.values) else 0
        assert at_0 == (curve.label == f"e_{curve.order}")


def test_the_table_of_a_scheme_that_diverges_says_nothing_twice():
    found = subdiv("check", MASKS / "counterexamples" / "merrien_8_2.toml", "-v").stdout
    assert "σ_j: the joint spectral radius" in found
    assert "φ: C^0: ρ_1 < 1" in found
    assert "S converges:" not in found
    assert "✓ proved   shifts 0, 0 " in found
    found = subdiv("check", MASKS / "counterexamples" / "no_derivative.toml", "-v").stdout
    assert "no jet of degree 1 is an eigen-sequence" in found


def test_components_are_counted_as_derivatives():
    found = subdiv("show", MASKS / "hermite_cubic.toml").stdout
    assert "for the data e_0 at 0" in found
    assert "for the data e_2" not in found
    assert "(S c)_(2k),0   (1, 0)" in subdiv("check", MASKS / "hermite_cubic.toml", "-v").stdout


@pytest.mark.parametrize(
    ("components", "arity", "row"), [(2, 2, "row 1 times 1/2 "), (2, 3, "row 1 times 1/3 "), (3, 2, "row j times 2^-j")]
)
def test_rows_that_are_not_scaled_have_a_hint(components, arity, row):
    mask = hermite_interpolation(components, arity)
    rows = {i: [[x * arity**j for x in line] for j, line in enumerate(a)] for i, a in mask.items()}
    result = check(scheme(rows, arity, "hermite"), (), Effort()).result
    assert result.convergent is Verdict.REFUTED
    assert f"with {row}" in result.hints[0]
    (finding,) = (each for each in result.findings if each.code == "SD716")
    assert finding.why.startswith("D^n c^n does not converge: ")
    assert check(scheme(mask, arity, "hermite"), (), Effort()).result.hints == ()
    assert not any(
        "row" in hint for hint in check(scheme(merrien("-1/8", 2), kind="hermite"), (), Effort()).result.hints
    )


def test_jets_of_more_than_a_hundred_degrees_are_counted():
    spline = [Fraction(comb(105, i), 2**104) for i in range(106)]
    mask = {i: [[x, 0], [0, x / 2]] for i, x in enumerate(spline)}
    assert HermiteNumbers(scheme(mask, kind="hermite"), Effort()).jets.order == 105


def test_more_degrees_than_the_checker_reads_are_undecided(monkeypatch):
    monkeypatch.setattr("subdiv_cli.checker.hermite.jets._MAX_DEGREE", 3)
    result = check(scheme(HERMITE_CUBIC, kind="hermite"), (), Effort()).result
    assert result.convergent is Verdict.PROVED
    (finding,) = (each for each in result.findings if each.code == "SD714")
    assert finding.verdict is Verdict.UNDECIDED
