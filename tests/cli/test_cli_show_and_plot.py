"""`show` and `plot` as commands: what they print and write, exit codes, bad input."""

import json
import sys
from pathlib import Path

import jsonschema
import pytest
from click.testing import CliRunner
from support import looks_like_latex, subdiv

from subdiv_cli.checker import check_text
from subdiv_cli.cli import main

MASKS = Path(__file__).parents[2] / "masks" / "scalar"
SCHEMA = json.loads((MASKS.parents[1] / "subdiv_cli" / "certificate" / "schema.json").read_text(encoding="utf-8"))
FOUR, CUBIC = str(MASKS / "four_point.toml"), str(MASKS / "bspline_degree_3.toml")


@pytest.fixture
def run(monkeypatch):
    for name in ("COLUMNS", "NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    return lambda *args, **more: CliRunner().invoke(main, args, prog_name="subdiv", **more)


@pytest.fixture
def polygon(tmp_path):
    file = tmp_path / "polygon.csv"
    file.write_text("x,y\n0,0\n1,2\n2,0\n4,0\n4,3\n2,4\n0,3\n", encoding="utf-8")
    return str(file)


def test_show(run):
    shown = run("show", CUBIC)
    assert (shown.exit_code, shown.stderr) == (0, "")
    for text in (
        "a(z) = 1/8 z^-2 (1 + z)^4",
        "φ(i)    1/6  2/3  1/6",
        "Q f = f - 1/6 f''",
        "Q f(i)   -1/6   4/3    -1/6",
        "Sobolev exponent 7/2 (SD321)",
        "‖S^∞ f - f^k‖∞ ≤ 1/2 (1/2)^k ‖Δf‖∞; 9 levels bring it below 1/1000 ‖Δf‖∞ (proved, SD511)",
    ):
        assert text in shown.stdout


@pytest.mark.parametrize("file", sorted(MASKS.rglob("*.toml"))[::3], ids=lambda file: file.stem)
@pytest.mark.parametrize("form", ["text", "markdown", "latex", "json"])
def test_every_shipped_mask_is_shown_in_every_format(run, analysed_once, file, form):
    shown = run("show", str(file), "--format", form)
    assert (shown.exit_code, shown.stderr) == (0, "")
    text = shown.stdout
    if form == "json":
        page = json.loads(text)
        assert (page["format"], page["version"]) == ("subdiv-show", 1)
        assert set(page) == KEYS
        assert page["report"]["status"] in ("passed", "failed", "undecided")
    elif form == "latex":
        looks_like_latex(text)
    elif form == "text":
        assert max(map(len, text.splitlines())) <= 100 or "⎢" in text


KEYS = {
    "format", "version", "tool", "report", "mask", "symbol", "polyphase", "derived", "refinement_matrices", "support",
    "values", "stencils", "quasi_interpolation", "approximation_order", "error_bound", "hermite_bound", "curve",
}  # fmt: skip


def test_the_numbers_of_the_json_page(run):
    page = json.loads(run("show", FOUR, "--format", "json", "--tolerance", "1/1000").stdout)
    assert page["symbol"]["text"] == "-1/16 z^-3 (1 + z)^4 (1 - 4 z + z^2)"
    assert page["symbol"]["factors"][1] == {
        "coefficients": [1, -4, 1],
        "multiplicity": 1,
        "smoothing": False,
        "zeros": ["0.267949…", "3.732050…"],
    }
    assert page["stencils"][1] == {"order": 1, "start": -2, "values": ["1/12", "-2/3", "0", "2/3", "-1/12"]}
    assert page["support"] == ["-3", "3"]
    assert page["error_bound"]["levels"] == 12
    assert page["hermite_bound"] is None
    assert page["approximation_order"] == {"with_q": 4, "without_q": 4}
    assert page["refinement_matrices"]["first_index"] == -2
    assert page["report"]["sobolev"]["lower"] == pytest.approx(2.4407654)
    codes = {finding["code"] for finding in page["report"]["findings"]}
    assert {"SD501", "SD502", "SD503", "SD504", "SD505", "SD511", "SD512"} <= codes


def test_names_of_files_and_scripts_in_latex(run):
    text = run("show", FOUR, "--format", "latex").stdout
    assert "four\\_point.toml" in text
    assert "S${}^{\\infty }$ f" in text
    assert "S\\textasciicircum" not in text


def test_the_same_page_twice(run):
    assert run("show", FOUR, "--format", "json").stdout == run("show", FOUR, "--format", "json").stdout


def test_its_certificate_verifies_and_fits_the_schema(run, tmp_path):
    shown = run("show", CUBIC, "--certificate", str(tmp_path / "proofs"))
    assert shown.exit_code == 0
    text = (tmp_path / "proofs" / "bspline_degree_3.json").read_text(encoding="utf-8")
    outcome = check_text(text)
    assert outcome.verified
    for words in ("values of φ^(2) at the integers", "S^∞ Q = 1 on polynomials of degree 3", "at level k = 9"):
        assert words in outcome.line
    jsonschema.validate(json.loads(text), SCHEMA)
    assert run("verify", str(tmp_path / "proofs"), "--mask", CUBIC).exit_code == 0


def test_show_writes_files(run, tmp_path):
    for name, start in (("a.tex", "\\documentclass"), ("a.md", "# B-spline"), ("a.json", "{"), ("a.txt", "B-spline")):
        file = tmp_path / name
        assert run("show", CUBIC, "-o", str(file)).exit_code == 0
        assert file.read_text(encoding="utf-8").startswith(start)
    assert not [file for file in tmp_path.iterdir() if file.suffix == ".part"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["show"], "name a mask"),
        (["show", FOUR, "--mask", "[1,1]"], "name a mask"),
        (["show", FOUR, "--start", "1"], "--start belongs to --mask"),
        (["show", FOUR, "--tolerance", "0"], "not a positive number"),
        (["show", FOUR, "--tolerance", "-1e-3"], "not a positive number"),
        (["show", FOUR, "--tolerance", "1e9999999999"], "not a positive number"),
        (["show", FOUR, "--tolerance", "1/0"], "not a positive number"),
        (["show", FOUR, "-p", "v=1"], "SD011"),
        (["show", FOUR, "-p", "w=1", "-p", "w=2"], "takes one mask"),
        (["show", "none.toml"], "SD002"),
        (["show", str(MASKS)], "SD002"),
        (["show", FOUR, "-o", "no/such/directory.md"], "cannot be written"),
        (["show", "--mask", "[1,"], "SD0"),
        (["plot"], "name a mask"),
        (["plot", FOUR, "-o", "a.gif"], "must end in .svg"),
        (["plot", FOUR, "--closed"], "belong to --points"),
        (["plot", FOUR, "--levels", "2"], "--levels belongs to --points"),
        (["plot", FOUR, "--points", "none.csv"], "SD002"),
        (["plot", FOUR, "--points", FOUR], "SD021"),
        (["plot", FOUR, "-p", "w=1/16", "-p", "v=2"], "SD011"),
        (["plot", FOUR, "--points", "x.csv", "--derivatives", "1"], "leave out --points"),
    ],
)
def test_bad_input(run, arguments, message):
    shown = run(*arguments)
    assert shown.exit_code == 2
    assert message in shown.stderr
    assert "Traceback" not in shown.stderr
    assert shown.stdout == ""


def test_plot_in_the_terminal(run):
    shown = run("plot", CUBIC)
    assert (shown.exit_code, shown.stderr) == (0, "")
    for title in ("φ — B-spline of degree 3", "φ' — B-spline", "φ'' — B-spline"):
        assert title in shown.stdout
    assert run("plot", CUBIC, "--derivatives", "0").stdout.count("B-spline") == 1


def test_plot_on_an_ascii_terminal():
    run = subdiv("plot", FOUR, "--derivatives", "0", encoding="ascii", COLUMNS="70")
    assert run.returncode == 0
    shown = run.stdout
    assert shown.startswith("phi -- four-point scheme")
    assert max(map(len, shown.splitlines())) <= 70


@pytest.mark.parametrize("form", ["svg", "png", "pdf"])
def test_plot_into_a_file(run, form, tmp_path, polygon):
    pytest.importorskip("matplotlib")
    six = str(MASKS / "six_point.toml")
    file = tmp_path / f"figure.{form}"
    values = ("-p", "w=.022", "-p", "w=.04", "-p", "theta=.002", "-p", "theta=.014", "-p", "theta=.02")
    shown = run("plot", FOUR, six, "--points", polygon, "--closed", *values, "-o", str(file))
    assert (shown.exit_code, shown.output) == (0, "")
    first = file.read_bytes()
    assert run("plot", FOUR, six, "--points", polygon, "--closed", *values, "-o", str(file)).exit_code == 0
    assert file.read_bytes() == first
    assert len(first) > 5000


def test_curves_through_their_points(run, polygon, tmp_path):
    pytest.importorskip("matplotlib")
    for extra in (["--closed"], ["--open"], ["--open", "--levels", "3"], ["--closed", "--levels", "2"]):
        assert run("plot", FOUR, "--points", polygon, *extra).exit_code == 0
        assert run("plot", FOUR, "--points", polygon, *extra, "-o", str(tmp_path / "a.svg")).exit_code == 0


def test_an_open_polygon_may_be_too_short(run, tmp_path):
    file = tmp_path / "short.csv"
    file.write_text("0,0\n1,1\n2,0\n", encoding="utf-8")
    shown = run("plot", FOUR, "--points", str(file))
    assert shown.exit_code == 2
    assert "an open polygon needs 6 points for this mask: give more, or --closed" in shown.stderr
    assert run("plot", FOUR, "--points", str(file), "--closed").exit_code == 0


def test_nothing_to_draw(run, polygon):
    haar = run("plot", "--mask", "[1, 1]")
    assert haar.exit_code == 1
    assert "nothing to draw, φ is not continuous" in haar.stderr
    divergent = ["--mask", "[1, 0, 0, 3, 0, 0, 3, 0, 0, 1]/4"]
    assert run("plot", *divergent).exit_code == 0
    shown = run("plot", *divergent, "--points", polygon, "--closed")
    assert shown.exit_code == 1
    assert "S does not converge uniformly" in shown.stderr
    undecided = run("plot", FOUR, "-p", "w=0.4999999999", "--effort", "1")
    assert undecided.exit_code == 3
    assert "φ is not proved continuous" in undecided.stderr


def test_a_missing_extra(run, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    shown = run("plot", FOUR, "-o", str(tmp_path / "phi.svg"))
    assert shown.exit_code == 2
    assert "matplotlib, which is not installed: pip install 'subdiv-cli[plot]'" in shown.stderr
    assert not list(tmp_path.iterdir())


def test_a_page_is_not_written_under_the_name_of_another_format(run, tmp_path):
    done = run("show", FOUR, "-o", tmp_path / "page.pdf")
    assert done.exit_code == 2
    assert "no format .pdf; say which, as in --format text -o" in done.output
    assert not list(tmp_path.iterdir())
    assert run("show", FOUR, "--format", "latex", "-o", tmp_path / "page.pdf").exit_code == 0


def test_without_a_refinable_function_plot_says_what_check_says(run):
    drawn, checked = run("plot", "--mask", "[1, 2, 2]/4"), run("check", "--mask", "[1, 2, 2]/4", "-q")
    assert (drawn.exit_code, checked.exit_code) == (1, 1)
    why = "the residue classes must sum to 1 each, but Σ a_(0+2β) = 3/4, Σ a_(1+2β) = 1/2"
    assert why in " ".join(drawn.output.split())
    assert why in " ".join(checked.output.split())
