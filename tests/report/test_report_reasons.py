"""The reasons of real masks: each property has one, long numbers have their size, and a report is one screen."""

import json
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from support import answer, deslauriers_dubuc, findings, four_point, multivariate_scheme, scheme, subdiv

from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Result, Verdict
from subdiv_cli.model.formulas import sized, valued
from subdiv_cli.pipeline import show
from subdiv_cli.report import marks, renderer
from subdiv_cli.report.look import Look
from subdiv_cli.report.reasons import of_result

MASKS = Path(__file__).parents[2] / "masks"
SAMPLE = (
    "scalar/four_point", "scalar/dual_four_point", "scalar/bspline_degree_3", "scalar/ternary_four_point_approximating",
    "scalar/counterexamples/chaikin_in_z3", "scalar/four_point_3_4", "multivariate/loop", "multivariate/butterfly",
    "multivariate/kobbelt_sqrt3", "multivariate/tensor_four_point", "multivariate/anisotropic_bilinear",
)  # fmt: skip
ROOT = "-log2(root(2048*x^2-40*x-1, 0.0339244, 0.0339245))/2"


def of_file(name: str) -> Result:
    return answer(read_path(MASKS / f"{name}.toml").scheme())


@pytest.mark.parametrize("name", SAMPLE)
def test_a_decided_property_has_its_reason_and_the_report_fits_a_screen(name):
    """Only degrees of generation and orders in several variables are what they are without one."""
    result = of_file(name)
    for found in result.findings:
        assert found.why is None or found.statement.endswith(found.why), found.code
        assert found.why is None or found.verdict in (Verdict.PROVED, Verdict.REFUTED)
    rows = of_result(result)
    assert len(rows) >= 8
    bare = {row.title for row in rows if not row.why and row.mark is not None and row.mark.name != "skipped"}
    assert bare <= {"generation", "sum rules"}
    lines = renderer("text")([result], Look()).splitlines()
    assert len(lines) <= 42
    assert lines[-1].startswith(f"{marks.of_status(result.status).text}: ")


def test_a_report_read_again_has_the_same_reasons(tmp_path):
    """Not the half of a sentence behind its first colon: the eigenvalues of a matrix have one, too."""
    file = tmp_path / "report.json"
    mask = ("--mask", "[1, 0, 0, 3, 0, 0, 3, 0, 0, 1]/4")
    subdiv("check", *mask, "-q", "-o", file)
    (result,) = json.loads(file.read_text("utf-8"))["results"]
    whys = {found["code"]: found["why"] for found in result["findings"]}
    assert whys["SD201"].startswith("½S_1 does not contract: the transition matrix T_0")
    assert whys["SD101"] is None
    assert whys["SD303"].startswith("φ0 of the reduced scheme is stable, and ")
    printed = subdiv("check", *mask).stdout
    assert subdiv("merge", file, "--format", "text").stdout == printed


def test_the_coset_that_is_off_is_named():
    half = {(0, 0): Fraction(1), (1, 0): Fraction(1), (0, 1): Fraction(2), (1, 1): Fraction(1)}
    result = answer(multivariate_scheme(half))
    (sums,), (converges,) = findings(result, "SD601"), findings(result, "SD611")
    assert sums.statement == "the 4 coset sums must be 1 each, but that of (0, 1) is 2"
    assert converges.why == sums.statement
    assert converges.statement == f"S does not converge uniformly to a non-zero limit: {sums.statement}"
    many = {(i, j): Fraction(1, 2) for i in range(3) for j in range(3)}
    (sums,) = findings(answer(multivariate_scheme(many, ((3, 0), (0, 3)))), "SD601")
    assert sums.statement.endswith(", that of (0, 2) is 1/2, and 5 more are not 1")


def test_long_fractions_have_their_decimal():
    assert valued(Fraction(16295, 16384)) == "16295/16384 = 0.9945…"
    assert valued(Fraction(9999, 10000)) == "9999/10000"
    assert valued(Fraction(1234567891)) == "1234567891"
    assert valued(Fraction(-16295, 16384)) == "-16295/16384 = -0.9945…"
    assert [sized(x) for x in (Fraction(5, 4), Fraction(2273, 2048), Fraction(16295, 16384))] == [
        "5/4", "2273/2048", "0.9945…"
    ]  # fmt: skip
    (whole,) = (f for f in findings(of_file("scalar/ternary_four_point_approximating"), "SD310"))
    assert whole.statement.startswith("ρ(S_(Δ^4)) = 0.0495872500… = (2065/839808)^(1/2): ")
    assert "modulus 2065/839808 = 0.0024… ≥ 1/729 = 3^-6" in " ".join(
        f.statement for f in findings(of_file("scalar/ternary_four_point_approximating"), "SD303")
    )


def test_decimals_stand_before_roots():
    result = answer(four_point("1/16"))
    text = renderer("text")([result], Look(width=300))
    assert f"2.4407654450… = {ROOT}: the transfer matrix of S_(Δ^4) has the spectral radius 0.0339244470…" in text
    assert "value: " not in renderer("text")([result], Look(verbosity=1))
    (below,) = findings(answer(four_point("1/20")), "SD311")
    assert below.statement == (
        "α = 1.4667221338… = -log2(root(20*x^2-10*x+1, 0.361803, 0.361804)), as ρ(S_(Δ^2)) = 0.3618033988…"
    )
    headline = renderer("text")([answer(four_point("1/20"))], Look(width=300)).splitlines()[0]
    assert headline.endswith("Hölder exponent 1.4667221338…, attained")


def test_error_bounds_have_their_size():
    def bound(mask):
        (found,) = findings(show(mask, Fraction(1, 1000), Effort())[0].result, "SD511")
        return re.sub(r" ‖Δf‖∞.*", "", found.statement).partition("≤ ")[2]

    assert bound(deslauriers_dubuc(2)) == "0 (1/2)^k"
    long = bound(four_point("3/20"))
    constant, rate = re.search(r"\(≈ ([0-9.]+) · ([0-9.]+)\^k\)$", long).groups()
    exact, norm, level = re.match(r"(\S+) \((\S+)\)\^⌊k/(\d+)⌋", long).groups()
    assert abs(Fraction(constant) / Fraction(exact) - 1) < Fraction(1, 100)
    assert abs(float(rate) / float(Fraction(norm)) ** (1 / int(level)) - 1) < 0.01


def test_the_marks_are_one_table_with_a_letter_each():
    assert len({mark.ascii for mark in marks.MARKS.values()}) == len({mark.sign for mark in marks.MARKS.values()})
    assert all(mark.ascii.isascii() for mark in marks.MARKS.values())
    sharp = of_file("scalar/four_point")
    page = renderer("html")([sharp], Look())
    assert '<span class="sharp">○ refuted</span><br>φ is not C<sup>2</sup>: φ is stable' in page
    assert '<span class="refuted">' not in page


def test_html_has_first_what_did_not_pass_and_powers():
    passed, failed = answer(four_point("1/16")), answer(scheme([1, 2, 3, 4], over=5))
    results = [replace(passed, file="a.toml"), replace(failed, file="b.toml"), replace(passed, file="c.toml")]
    page = renderer("html")(results, Look())
    assert re.findall(r'data-card="mask-(\d)"', page) == ["2", "1", "3"]
    assert re.findall(r'<article class="card" id="mask-(\d)">', page) == ["2", "1", "3"]
    assert "C<sup>1</sup>, not C<sup>2</sup>" in page
    assert "C^" not in page
    assert page.index("2.4407654450… = -log2(root(") > 0
    named = renderer("html")([replace(passed, name="C^1 scheme", file="C^2.toml")], Look())
    assert "C^1 scheme" in named
    assert "<code>C^2.toml</code>" in named


def test_annotations_explain_a_radius():
    result = answer(multivariate_scheme({(0, 0): Fraction(1)}))
    (diverges,) = findings(result, "SD611")
    diverges = replace(diverges, statement="S diverges: T_0 keeps ρ_1 ≥ 1", why="T_0 keeps ρ_1 ≥ 1")
    result = replace(result, file="m.toml", findings=(diverges,))
    meaning = "ρ_k: the joint spectral radius of S on differences of order k"
    for form in ("github", "junit", "sarif", "markdown", "text"):
        assert meaning in renderer(form)([result], Look(width=300)).replace("\\_", "_")
