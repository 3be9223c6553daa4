"""Reports of masks in several variables: facts and statements in words, stencils, and JSON by its schema."""

import json
from pathlib import Path

import jsonschema
import pytest

from subdiv_cli.catalog.run import check_all
from subdiv_cli.report import renderer, words
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import notices

ROOT = Path(__file__).parents[2]
MASKS = ROOT / "masks" / "multivariate"
NAMES = ["loop", "butterfly", "midedge", "anisotropic_bilinear", "bear", "trilinear", "counterexamples/haar"]


@pytest.fixture(scope="module")
def results():
    return dict(
        zip(NAMES, check_all([str(MASKS / f"{name}.toml") for name in NAMES], debug=True, sections=True), strict=True)
    )


def statement(result, code):
    (found,) = (finding for finding in result.findings if finding.code == code)
    return found.statement


def test_facts_in_words(results):
    assert words.facts(results["butterfly"]) == [
        "support (-3, -3) … (3, 3)",
        "dilation 2I",
        "25 coefficients",
        "12 symmetries",
        "interpolatory",
    ]
    assert "dilation [[1,1],[1,-1]]" in words.facts(results["midedge"])
    assert [name for name in NAMES if "anisotropic" in words.facts(results[name])] == ["anisotropic_bilinear"]


def test_statements(results):
    loop, butterfly = results["loop"], results["butterfly"]
    assert statement(loop, "SD603") == "φ is the box spline of 6 directions: (0, 1), (1, 0), (1, 1), each twice"
    assert statement(loop, "SD612") == "φ is C^2: its directions span without any 3 of them"
    assert statement(loop, "SD613") == "φ is not C^3: its directions do not span without some 4 of them"
    assert statement(butterfly, "SD612") == "φ is C^1: ρ_4 < λ^-1, λ = 2"
    assert statement(butterfly, "SD613").endswith("keeps ρ_4 ≥ λ^-2, λ = 2")
    assert statement(results["bear"], "SD612") == "φ is C^0: ρ_2 < 1"
    assert statement(results["midedge"], "SD603").endswith("; recognised in S^2, whose dilation is 2I")
    assert statement(results["counterexamples/haar"], "SD612").endswith("do not span without some one of them")


def test_the_table_names_the_proofs(results):
    text = renderer("text")([results["butterfly"]], Look())
    rows = {line.split("  ")[1]: line.split()[-1] for line in text.splitlines() if line.startswith("  ")}
    assert (rows["convergence"], rows["stability"], rows["sum rules"]) == ("SD611", "SD616", "SD602")


def test_stencils_are_shown_when_asked_for(results):
    plain, more = (renderer("text")([results["loop"]], Look(verbosity=v)) for v in (0, 1))
    assert "coset" not in plain.partition("SD601")[0]
    assert "coset (0, 0) at the old points, in 1/16" in more
    assert "coset (1, 1) at (1/2, 1/2), in 1/8" in more
    assert "-1 │   1  10  1" in more


def test_html_has_the_stencils(results):
    page = renderer("html")([results["loop"], results["trilinear"]], Look())
    assert page.count("<h3>stencils</h3><pre>") == 2
    assert "coset (1, 1) at (1/2, 1/2), in 1/8\n" in page
    assert "x3 = -1" in page
    assert "support (0, 0, 0) … (2, 2, 2) · dilation 2I" in page


def test_json_is_valid_and_has_facts_and_verdicts(results):
    schema = json.loads((ROOT / "subdiv_cli" / "report" / "schema.json").read_text(encoding="utf-8"))
    report = json.loads(renderer("json")(list(results.values()), Look()))
    jsonschema.Draft202012Validator(schema).validate(report)
    found = dict(zip(NAMES, report["results"], strict=True))
    assert found["midedge"]["facts"]["dilation"] == [[1, 1], [1, -1]]
    assert found["loop"]["smoothness"] == {"order": 2, "sharp": True}
    assert found["loop"]["holder"]["exact"] == "3"
    assert found["anisotropic_bilinear"]["holder"]["exact"] == "1"
    assert found["counterexamples/haar"]["convergent"]["verdict"] == "refuted"
    assert all(result["kind"] == "multivariate" for result in found.values())


def test_a_notice_names_a_finding_of_several_variables(tmp_path):
    file = tmp_path / "mask.toml"
    body = (MASKS / "courant.toml").read_text(encoding="utf-8").partition("[expect]")[0]
    file.write_text(f"{body}[expect]\nsmoothness = 1\nholder = 2\nstable = false\n", encoding="utf-8")
    (result,) = check_all([str(file)], debug=True)
    assert [notice.code for notice in notices(result, Look())] == ["SD612", "SD614", "SD616"]
