"""Curves of matrices at the command line: check, cache, show, plot, reports and certificates, and `jsr` beside them."""

import json
import re
from dataclasses import replace

import pytest
from support import looks_like_latex, subdiv

from subdiv_cli.catalog import masks_directory
from subdiv_cli.catalog.cache import Cache
from subdiv_cli.catalog.trust import trusted
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import INFINITY, Exponent, Smoothness

FOLDER = masks_directory() / "matrices"
CASTELJAU = FOLDER / "de_casteljau_2.toml"
CORNERS = FOLDER / "counterexamples" / "takagi_landsberg_1_8.toml"
TRANSPOSED = 'kind = "matrices"\nmatrices = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]\n'


def report(file, *more):
    run = subdiv("check", file, "--no-cache", "--format", "json", *more)
    (result,) = json.loads(run.stdout)["results"]
    return result


def test_a_polynomial_is_infinitely_smooth():
    result = report(CASTELJAU)
    assert result["status"] == "passed"
    assert result["smoothness"] == {"order": "infinity", "sharp": True}
    holder = result["holder"]
    assert (holder["lower"], holder["upper"], holder["exact"], holder["digits"]) == (None, None, "infinity", None)
    assert (result["well_defined"], result["polynomials"]) == ({"verdict": "proved"}, 2)
    assert (result["sobolev"], result["generation"], result["reproduction"]) == (None, None, None)
    assert result["stable"] == {"verdict": "skipped"}
    text = subdiv("check", CASTELJAU, "--no-cache").stdout
    assert "de Casteljau, degree 2: C^∞ — convergence proved; Hölder exponent infinity" in text


@pytest.mark.parametrize("key", ["smoothness", "holder"])
def test_infinity_is_judged(tmp_path, key):
    file = tmp_path / "curve.toml"
    body = CASTELJAU.read_text().partition("[expect]")[0]
    for expected, status in ((">= 5", "passed"), ("infinity", "passed"), ("3", "failed"), ("1 .. 4", "failed")):
        file.write_text(f'{body}[expect]\n{key} = "{expected}"\n')
        assert report(file)["status"] == status, expected
    body = CORNERS.read_text().partition("[expect]")[0]
    file.write_text(f'{body}[expect]\n{key} = "infinity"\n')
    assert report(file)["status"] == "failed"
    file.write_text(f'{body}[expect]\nsmoothness = "infinity"\nholder = "2"\n')
    run = subdiv("check", file, "--no-cache")
    assert run.returncode == 2
    assert "C^n has a Hölder exponent of at least n" in run.stderr


@pytest.mark.parametrize("file", [CASTELJAU, CORNERS, FOLDER / "levy.toml", FOLDER / "counterexamples" / "cycle.toml"])
def test_the_cache_gives_the_same_bytes_and_verifies(file, tmp_path):
    first, again = (
        subdiv("check", file, "--cache-dir", tmp_path / "cache", "--format", "json", "-v").stdout for _ in range(2)
    )
    assert first == again == subdiv("check", file, "--no-cache", "--format", "json", "-v").stdout
    (entry,) = (tmp_path / "cache").rglob("*.entry")
    kept = Cache(tmp_path / "cache").find(entry.stem)
    read = read_path(file)
    scheme = read.scheme({})
    assert kept is not None
    assert trusted(kept.result, kept.certificate, scheme, read.expectations)
    more, infinite = Smoothness(7, sharp=True), Exponent(1.0, exact=INFINITY)
    for lie in (
        replace(kept.result, smoothness=more, refinable=more),
        replace(kept.result, polynomials=9),
        replace(kept.result, holder=infinite),
    ):
        assert not trusted(lie, kept.certificate, scheme, read.expectations)


def test_a_baseline_with_an_infinite_exponent(tmp_path):
    old = tmp_path / "old.json"
    old.write_text(subdiv("check", CASTELJAU, "--no-cache", "--format", "json").stdout)
    assert subdiv("check", CASTELJAU, "--no-cache", "--baseline", old).returncode == 0
    data = json.loads(old.read_text())
    result = data["results"][0]
    del result["well_defined"], result["polynomials"]  # as an older report has it
    old.write_text(json.dumps(data))
    assert subdiv("check", CASTELJAU, "--no-cache", "--baseline", old).returncode == 0
    result |= {"holder": {**result["holder"], "lower": 1.0, "upper": 1.0, "exact": "1"}}
    old.write_text(json.dumps(data))
    run = subdiv("check", CASTELJAU, "--no-cache", "--baseline", old)
    assert run.returncode == 1
    assert "the Hölder exponent was 1 and is infinity" in " ".join(run.stdout.split())
    merged = subdiv("merge", old, "--format", "concise").stdout
    assert "SD816 curve-smoothness proved" in merged


def test_certificates_are_about_the_file(tmp_path):
    subdiv("check", CASTELJAU, CORNERS, "--no-cache", "--certificate", tmp_path)
    plain, expanded = (subdiv("verify", tmp_path / f"{f.stem}.json", "--mask", f).stdout for f in (CASTELJAU, CORNERS))
    assert plain.startswith("VERIFIED")
    assert plain.endswith(f"(the mask of {CASTELJAU})\n")
    assert "its parameters and symbol expanded by subdiv" in expanded
    other = subdiv("verify", tmp_path / "de_casteljau_2.json", "--mask", CORNERS)
    assert other.returncode == 1
    assert "another mask" in other.stdout


def test_show_takes_it_apart():
    text = subdiv("show", CORNERS).stdout
    for said in (
        "A_0 = ",
        "det(z - A_0) = (-1 + z) (-1 + 2 z) (-1 + 8 z)",
        "ψ(0) = f_0 = (1, 0, 0)",
        "ψ'(0) = (-7/3, 8/3, -1/3)",
        "do not fit at x = 1/2",
        "S^(0), S^(1), S^(2), each in the one before, of dimensions 3, 2, 1",
        "U_1 = ",
        "the rows are polygons with the curves 1, x",
    ):
        assert said in text, said
    page = json.loads(subdiv("show", CORNERS, "--format", "json").stdout)
    assert page["ends"] == {"left": ["1", "0", "0"], "right": ["0", "0", "1"]} or page["ends"]["left"] == [1, 0, 0]
    assert page["derivatives"][0]["joint"] == 1
    assert page["chain"] == [3, 2, 1]
    cycle = subdiv("show", FOLDER / "counterexamples" / "cycle.toml").stdout
    assert "Chain of invariant spaces" not in cycle
    assert "S^(3) is 0: the curve is a polynomial" in subdiv("show", CASTELJAU).stdout


def test_show_as_a_page_of_latex():
    run = subdiv("show", CORNERS, "--format", "latex")
    assert run.returncode == 0
    looks_like_latex(run.stdout)
    assert "A_{0}" in run.stdout or "A_0" in run.stdout.replace("\\", "")


def test_the_card_draws_the_components():
    page = subdiv("check", CORNERS, "--no-cache", "--format", "html").stdout
    assert page.count("<polyline") == 3
    for name in ("ψ_1", "ψ_2", "ψ_3"):
        assert f"{name}, exact values at finitely many points" in page
    assert "A_1 = " in page
    page = subdiv("check", FOLDER / "counterexamples" / "cantor.toml", "--no-cache", "--format", "html").stdout
    assert "<polyline" not in page
    assert "drawn where it is proved to be well defined" in page


def test_plot_draws_components_and_curves(tmp_path):
    run = subdiv("plot", CORNERS)
    assert run.returncode == 0
    assert run.stdout.startswith("ψ — corners at all joints")
    polygon = tmp_path / "polygon.csv"
    polygon.write_text("0,0\n1/2,1/2\n1,0\n")
    run = subdiv("plot", FOLDER / "takagi.toml", "--points", polygon, "--levels", "2")
    assert run.returncode == 0
    assert "0.666" in run.stdout
    assert subdiv("plot", FOLDER / "takagi.toml", "--points", polygon, "-o", tmp_path / "takagi.svg").returncode == 0
    assert (tmp_path / "takagi.svg").read_bytes().startswith(b"<?xml")
    polygon.write_text("0,0\n1,0\n")
    run = subdiv("plot", FOLDER / "takagi.toml", "--points", polygon)
    assert (run.returncode, "has 3 control points, and the file has 2" in run.stderr) == (2, True)
    for name, why in (("cantor", "the pieces do not meet in one curve"), ("cycle", "not all polygons converge")):
        run = subdiv("plot", FOLDER / "counterexamples" / f"{name}.toml")
        assert (run.returncode, why in run.stderr) == (1, True)


def test_jsr_reads_the_same_files_and_more(tmp_path):
    run = subdiv("jsr", CASTELJAU)
    assert run.returncode == 0
    assert "joint spectral radius = 1" in run.stdout
    file = tmp_path / "family.toml"
    file.write_text(TRANSPOSED)
    assert "1.618033988749894" in subdiv("jsr", file).stdout
    run = subdiv("check", file, "--no-cache")
    assert run.returncode == 2
    assert re.search(r"error\[SD024\] the row sums to 2, must be 1", run.stderr)
    file.write_text(TRANSPOSED.partition("\n")[2])
    assert "1.618033988749894" in subdiv("jsr", file).stdout
    run = subdiv("check", file, "--no-cache")
    assert run.returncode == 2
    assert 'add kind = "matrices", or use subdiv jsr' in run.stderr


def test_parameters_are_put_in_before_rows_are_summed(tmp_path):
    file = tmp_path / "curve.toml"
    body = 'kind = "matrices"\nmatrices = [[[1, 0], ["b", "a"]], [["b", "a"], [0, 1]]]\n'
    file.write_text(f'{body}[parameters]\na = "1/3"\nb = "2/3"\n')
    assert report(file)["holder"]["exact"] == "log2(3/2)"
    run = subdiv("check", file, "--no-cache", "-p", "a=1/2")
    assert run.returncode == 2
    assert "the row sums to 7/6, must be 1" in run.stderr
    assert report(file, "-p", "a=1/4", "-p", "b=3/4")["holder"]["exact"] == "log2(4/3)"
