"""Piecewise schemes at the command line: check, cache, show, certificates, reports."""

import json
from dataclasses import replace

import pytest
from support import looks_like_latex, subdiv

from subdiv_cli.catalog import masks_directory
from subdiv_cli.catalog.trust import trusted
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Exponent
from subdiv_cli.pipeline import check

FOLDER = masks_directory() / "piecewise"
LEVIN = FOLDER / "four_point_cubic.toml"
SPACED = FOLDER / "bspline_cubic_spacing.toml"


def test_the_report_says_what_decides():
    run = subdiv("check", LEVIN, "--no-cache")
    assert run.returncode == 0
    for line in (
        "four-point scheme joined to cubic B-splines: C^1, not C^2 — convergence proved; Hölder exponent",
        "arity 2 · left mask on -3 … 3 · right mask on -2 … 2 · special rows -1, 0, 1, 2",
        "limits near 0 from 6 points, -3 … 2",
        "exponent at 0    ✓ proved   log2(296/57) = 2.3765633514…",
        "C^2              ○ refuted  the left mask is not",
    ):
        assert line in run.stdout, line
    assert "spacings 1, 2" in subdiv("check", SPACED, "--no-cache").stdout
    (hint,) = json.loads(subdiv("check", FOLDER / "bumps_3_4.toml", "--no-cache", "--format", "json").stdout)[
        "results"
    ][0]["hints"]
    assert hint == "special row 9 stands in for the right mask where that reads points of its own side alone"


@pytest.mark.parametrize("name", ["four_point_cubic", "complex_pair", "counterexamples/bumps_2", "cubic_quarters"])
def test_the_cache_gives_the_same_bytes_and_verifies(name, tmp_path):
    first, again = (
        subdiv("check", FOLDER / f"{name}.toml", "--cache-dir", tmp_path, "--format", "json", "-v").stdout
        for _ in range(2)
    )
    assert first == again


def test_an_altered_exponent_at_zero_is_not_trusted():
    file = read_path(LEVIN)
    scheme = file.scheme({})
    checked = check(scheme, file.expectations, Effort())
    result, text = checked.result, checked.certificate_text()
    assert trusted(result, text, scheme, file.expectations)
    wrong = replace(result, holder_at_zero=Exponent(2.0, 2.5, None))
    assert not trusted(wrong, text, scheme, file.expectations)
    findings = tuple(
        replace(
            f,
            answers=((f.answers[0][0], Exponent(9.0, 9.0)),),
            value=f.value._replace(lower=9.0, upper=9.0, exact=None),
            closed=None,
        )
        if f.code == "SD824"
        else f
        for f in result.findings
    )
    wrong = replace(result, findings=findings, holder_at_zero=Exponent(9.0, 9.0))
    assert not trusted(wrong, text, scheme, file.expectations)


def test_certificates_are_about_the_file(tmp_path):
    proof = tmp_path / "proof.json"
    assert subdiv("check", LEVIN, "--no-cache", "--certificate", proof).returncode == 0
    run = subdiv("verify", proof, "--mask", LEVIN)
    assert (run.returncode, run.stdout.startswith("VERIFIED")) == (0, True)
    assert "alpha at 0 = -log2(57/296)" in run.stdout
    assert "expanded" not in run.stdout
    other = subdiv("verify", proof, "--mask", SPACED)
    assert other.returncode == 1


def test_sides_may_be_files_and_have_parameters(tmp_path):
    (tmp_path / "four.toml").write_text('[mask]\nsymbol = "z^-3 (1+z)^2 (z^2/2 - (z-1)^2 (1+z^2)/16)"\n')
    text = LEVIN.read_text().replace("[left]", "[ignored]")
    body = text[text.index("[right]") :]
    file = tmp_path / "scheme.toml"
    file.write_text(f'kind = "piecewise"\nleft = "four.toml"\n{body}')
    result = json.loads(subdiv("check", file, "--no-cache", "--format", "json").stdout)["results"][0]
    assert (result["status"], result["holder_at_zero"]["exact"]) == ("passed", "log2(296/57)")
    file.write_text(f'kind = "piecewise"\nleft = "four.toml"\nspacing = [1, "h"]\n{body}[parameters]\nh = 1\n')
    spaced = json.loads(subdiv("check", file, "--no-cache", "--format", "json", "-p", "h=2").stdout)["results"][0]
    assert (spaced["status"], spaced["generation"]) == ("failed", 0)


def test_show_takes_it_apart():
    text = subdiv("show", LEVIN).stdout
    for line in ("right Q f = f - 1/6 f''", "F(0) = c_0", "Q x^2", "the order of approximation is 4", "(-57 + 296 z)"):
        assert line in text
    data = json.loads(subdiv("show", LEVIN, "--format", "json").stdout)
    page = data.get("show", data)
    assert page["points"] == [-3, -2, -1, 0, 1, 2]
    assert page["quasi_interpolation"]["right"] == ["1", "0", "-1/6", "0"]
    assert page["value_at_zero"] == {"points": [0], "weights": ["1"]}
    looks_like_latex(subdiv("show", LEVIN, "--format", "latex").stdout)
