"""`show` and `plot` of masks in several variables as commands: what they print and write, exit codes, bad input."""

import json
import re
import sys
from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest
from click.testing import CliRunner
from support import looks_like_latex, subdiv

from subdiv_cli.checker import check_text
from subdiv_cli.cli import main

MASKS = Path(__file__).parents[2] / "masks" / "multivariate"
LOOP, ZWART, TRICUBIC = (str(MASKS / f"{name}.toml") for name in ("loop", "zwart_powell", "tricubic"))
FOUR = str(MASKS.parent / "scalar" / "four_point.toml")


@pytest.fixture
def run(monkeypatch):
    for name in ("COLUMNS", "NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    return lambda *args, **more: CliRunner().invoke(main, args, prog_name="subdiv", **more)


@pytest.fixture
def net(tmp_path):
    """5 by 5 control points of a saddle."""
    file = tmp_path / "net.csv"
    rows = [f"{i},{j},{i},{j},{i * j}/2" for i, j in product(range(5), repeat=2)]
    file.write_text("\n".join(["i,j,x,y,z", *rows]), encoding="utf-8")
    return str(file)


@pytest.mark.parametrize(("columns", "encoding"), [("40", "utf-8"), ("40", "ascii"), ("100", "utf-8"), ("20", "ascii")])
def test_plot_in_the_terminal(columns, encoding):
    run = subdiv("plot", ZWART, encoding=encoding, COLUMNS=columns)
    assert run.returncode == 0
    shown = run.stdout
    lines = shown.splitlines()
    assert lines[0] == ("φ — Zwart-Powell element" if encoding == "utf-8" else "phi -- Zwart-Powell element")
    assert max(map(len, lines)) <= max(int(columns), 27)
    assert ("█" if encoding == "utf-8" else "#") in shown
    assert len(lines) <= 34


def test_values_below_zero_have_a_sign(run):
    shown = run("plot", str(MASKS / "butterfly.toml"))
    assert shown.exit_code == 0
    assert "- -0.0625 to 0" in shown.stdout
    assert "-----" in shown.stdout


def test_a_slice_says_where_it_is(run):
    assert run("plot", str(MASKS / "box_bcc_linear.toml")).stdout.startswith("φ(x, y, 0) — ")
    assert "φ(x, y, -1/2) — " in run("plot", str(MASKS / "box_fcc_cubic.toml")).stdout


@pytest.mark.parametrize(("form", "style"), [("svg", ["--as", "contour"]), ("png", []), ("pdf", ["--as", "contour"])])
def test_plot_into_a_file(run, form, style, tmp_path):
    pytest.importorskip("matplotlib")
    file = tmp_path / f"figure.{form}"
    shown = run("plot", ZWART, *style, "-o", str(file))
    assert (shown.exit_code, shown.output) == (0, "")
    assert len(file.read_bytes()) > 10_000


def test_several_masks_and_grids_that_are_not_rectangular(run, tmp_path):
    pytest.importorskip("matplotlib")
    bear, haar = str(MASKS / "bear.toml"), str(MASKS / "anisotropic_bilinear.toml")
    assert run("plot", bear, haar, "--as", "contour", "-o", str(tmp_path / "a.png")).exit_code == 0
    shown = run("plot", bear, haar)
    assert shown.exit_code == 0
    assert shown.stdout.count("φ — ") == 2


def parsed(file):
    rows = [line.split() for line in file.read_text(encoding="ascii").splitlines()]
    vertices = [tuple(map(float, row[1:])) for row in rows if row[0] == "v"]
    faces = [tuple(map(int, row[1:])) for row in rows if row[0] == "f"]
    assert all(1 <= index <= len(vertices) for face in faces for index in face)
    return vertices, faces


def test_a_net(run, tmp_path, net):
    file = tmp_path / "net.obj"
    shown = run("plot", LOOP, "--points", net, "--levels", "1", "-o", str(file))
    assert (shown.exit_code, shown.output) == (0, "")
    vertices, faces = parsed(file)
    assert (len(vertices), {len(face) for face in faces}) == (49, {3})
    assert file.read_text(encoding="ascii").startswith("# Loop, box spline (2,2,2): a control net at level 1\n")
    first = file.read_bytes()
    run("plot", LOOP, "--points", net, "--levels", "1", "-o", str(file))
    assert file.read_bytes() == first
    assert not [other for other in tmp_path.iterdir() if other.suffix == ".part"]


def test_the_graph_of_phi(run, tmp_path):
    file = tmp_path / "phi.obj"
    assert run("plot", LOOP, "-o", str(file)).exit_code == 0
    vertices, _ = parsed(file)
    heights = {(x, y): z for x, y, z in vertices}
    assert heights[2.0, 2.0] == 0.5
    assert heights[1.0, 2.0] == 1 / 12
    assert sum(z for z in heights.values()) == pytest.approx(64)


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("0,0,0,0\n", '"4 cells" is not a point of a net'),
        ("0,0,0,0,0\n0,1,x,0,0\n", '"x" is not a point of a net'),
        ("0,0.5,0,0,0\n", '"0.5" is no place in a net'),
        ("0,0,0,0,0\n0,0,1,1,1\n", "the place 0, 0 has a point already"),
        ("0,0,0,0,0\n0,1,0,0,0\n1,0,0,0,0\n", "the net has no point at 1, 1"),
        ("0,0,0,0,0\n99999,99999,0,0,0\n", "the net has no point at 0, 1"),
        ("i,j,x,y,z\n", "there are no points"),
        ('0,0,"0,0,0\n', "not CSV"),
        ("".join(f"{i},0,0,0,0\n" for i in range(10_001)), "more than 10000 points"),
    ],
)
def test_what_is_no_net(run, tmp_path, rows, message):
    file = tmp_path / "net.csv"
    file.write_text(rows, encoding="utf-8")
    shown = run("plot", LOOP, "--points", str(file), "-o", str(tmp_path / "net.obj"))
    assert (shown.exit_code, shown.stdout) == (2, "")
    assert "SD021" in shown.stderr
    assert message in shown.stderr
    assert not (tmp_path / "net.obj").exists()


def test_a_net_that_determines_nothing(run, tmp_path):
    file = tmp_path / "net.csv"
    file.write_text("0,0,0,0,0\n", encoding="utf-8")
    for levels, message in (("1", "no vertex of level 1"), ("0", "no face of level 0")):
        shown = run("plot", LOOP, "--points", str(file), "--levels", levels, "-o", str(tmp_path / "net.obj"))
        assert shown.exit_code == 2
        assert message in shown.stderr


def test_a_coordinate_beyond_doubles(run, tmp_path):
    file, large = tmp_path / "net.csv", 10**120
    file.write_text("".join(f"{i},{j},1e99,0,0\n" for i, j in product(range(2), repeat=2)), encoding="utf-8")
    mask = ["--mask", f"[[{large},{large}],[{large},{large}]]"]
    shown = run("plot", *mask, "--points", str(file), "--levels", "2", "-o", str(tmp_path / "net.obj"))
    assert shown.exit_code == 2
    assert "larger than any double" in shown.stderr
    assert not (tmp_path / "net.obj").exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["plot", LOOP, "--closed"], "--closed and --open belong to --points, for curves"),
        (["plot", LOOP, "--derivatives", "1"], "--derivatives belongs to curves"),
        (["plot", LOOP, "--samples", "100"], "--samples belongs to curves"),
        (
            ["plot", LOOP, "--levels", "2"],
            "or to the net of a mask in two variables, -o NET.obj",
        ),
        (["plot", LOOP, "--points", "net.csv"], "or to the net of one in two, -o NET.obj"),
        (["plot", LOOP, "--as", "contour"], "in -o FILE.svg, .png or .pdf"),
        (["plot", LOOP, "--as", "contour", "-o", "a.obj"], "--as belongs to surfaces"),
        (["plot", LOOP, "--as", "relief", "-o", "a.png"], "relief"),
        (["plot", LOOP, FOUR], "functions and surfaces are not drawn into one picture"),
        (["plot", LOOP, ZWART, "-o", "a.obj"], "these are 2 nets, and one picture takes 1 at most"),
        (["plot", *[LOOP] * 7], "7 surfaces, and one picture takes 6 at most"),
        (["plot", TRICUBIC, "-o", "a.obj"], "a mask in two variables"),
        (["plot", FOUR, "-o", "a.obj"], "a mask in two variables"),
        (["plot", FOUR, "--as", "contour"], "--as belongs to surfaces"),
        (["plot", LOOP, "--points", "none.csv", "-o", "a.obj"], "SD002"),
        (["plot", LOOP, "--levels", "8", "-o", "a.obj"], "too many values at level 8"),
        (["plot", LOOP, "--levels", "9", "-o", "a.obj"], "9"),
        (["plot", LOOP, "-o", "no/such/net.obj"], "cannot be written"),
        (["show", LOOP, "--tolerance", "1e-3"], "--tolerance belongs to curves"),
    ],
)
def test_bad_input(run, arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shown = run(*arguments)
    assert shown.exit_code == 2
    assert message in shown.stderr
    assert "Traceback" not in shown.stderr
    assert shown.stdout == ""
    assert not list(tmp_path.iterdir())


def test_nothing_to_draw(run, tmp_path):
    wrong = MASKS / "counterexamples"
    haar = run("plot", str(wrong / "haar.toml"))
    assert haar.exit_code == 1
    assert "nothing to draw, φ is not continuous" in haar.stderr
    slip = run("plot", str(wrong / "loop_slip.toml"), "-o", str(tmp_path / "a.obj"))
    assert slip.exit_code == 1
    assert (
        "nothing to draw, S does not converge uniformly to a non-zero limit: the 4 coset sums must be 1 " in slip.stderr
    )
    assert "but that of (0, 0) is 15/16\n" in slip.stderr
    assert not list(tmp_path.iterdir())
    divergent = run("plot", str(wrong / "box_on_sublattice.toml"))
    assert divergent.exit_code == 0  # S diverges, its φ is continuous


def test_a_missing_extra(run, monkeypatch, tmp_path, net):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    shown = run("plot", LOOP, "-o", str(tmp_path / "phi.svg"))
    assert shown.exit_code == 2
    assert "matplotlib, which is not installed" in shown.stderr
    assert run("plot", LOOP, "--points", net, "-o", str(tmp_path / "net.obj"), "--levels", "1").exit_code == 0


def test_show(run):
    shown = run("show", LOOP)
    assert (shown.exit_code, shown.stderr) == (0, "")
    for text in (
        "a(z) = 1/16 (1 + z2)^2 (1 + z1)^2 (1 + z1 z2)^2",
        "V_4, the space of the differences of order 4, has dimension 14",
        "coset (0, 0) at the old points, in 1/16",
        "φ at the integers, in 1/12",
        "centre of mass (2, 2)",
        "φ is the box spline of 6 directions",
        "  Q f(α) = g(α + (2, 2))\n  g = f - 1/6 f_xx - 1/6 f_xy - 1/6 f_yy\n    Q f(α) = Σ t_j f(α+j), in 1/12\n",
        "    2 │  -1  18  -1\n",
    ):
        assert text in shown.stdout


@pytest.mark.parametrize(
    "name", ["courant_ternary", "butterfly", "quincunx_linear", "box_fcc_cubic", "counterexamples/loop_slip"]
)
def test_show_in_both_formats(run, name):
    file = str(MASKS / f"{name}.toml")
    text = run("show", file)
    assert (text.exit_code, text.stderr) == (0, "")
    assert max(map(len, text.stdout.splitlines())) <= 100
    page = json.loads(run("show", file, "--format", "json").stdout)
    assert page["symbol"]["text"] in " ".join(text.stdout.split())
    assert multiplied_out(page) == {tuple(index): Fraction(x) for index, x in page["mask"]["terms"]}
    assert sum(len(coset["stencil"]) for coset in page["cosets"]) == len(page["mask"]["terms"])
    if page["values"] is not None:
        assert sum(Fraction(x) for _, x in page["values"]) == 1


SHOWN = sorted(file for file in MASKS.rglob("*.toml") if "seven" not in file.stem)[::3]


@pytest.mark.parametrize("file", [Path(LOOP), *SHOWN], ids=lambda file: file.stem)
def test_show_as_markdown_and_latex(run, analysed_once, file):
    """The same in both: sections, numbers of stencils, findings."""
    markdown, latex = (run("show", str(file), "--format", form) for form in ("markdown", "latex"))
    for shown in (markdown, latex):
        assert (shown.exit_code, shown.stderr) == (0, "")
    looks_like_latex(latex.stdout)
    sections = [line[3:] for line in markdown.stdout.splitlines() if line.startswith("## ")]
    assert sections == re.findall(r"\\subsection\*\{(.*)\}", latex.stdout)
    assert {"Mask", "Stencils", "Findings"} <= set(sections)
    assert markdown.stdout.count("\n| ---:") == latex.stdout.count("\\begin{tabular}")
    codes = re.findall(r"\(\w+, (SD\d+)\)", markdown.stdout)
    assert codes == re.findall(r"\(\w+, (SD\d+)\)", latex.stdout)
    assert "SD619" in codes


def test_loop_as_markdown_and_latex(run, tmp_path):
    markdown = run("show", LOOP, "--format", "markdown").stdout
    assert "`g = f - 1/6 f_xx - 1/6 f_xy - 1/6 f_yy`" in markdown
    assert "| 2 | -1 | 18 | -1 |" in markdown
    assert "| 1 | 1 | 1 | · |" in markdown
    latex = tmp_path / "loop.tex"
    assert run("show", LOOP, "-o", str(latex)).exit_code == 0
    text = latex.read_text(encoding="ascii")
    assert "g = f - \\tfrac{1}{6} f_{xx} - \\tfrac{1}{6} f_{xy} - \\tfrac{1}{6} f_{yy}" in text
    assert "a(z) = \\tfrac{1}{16} (1 + z_{2})^{2} (1 + z_{1})^{2} (1 + z_{1} z_{2})^{2}" in text
    assert "$2$ & $-1$ & $18$ & $-1$ \\\\" in text
    assert text.count("\\fill[black!") > 500


def test_q_as_data(run):
    page = json.loads(run("show", LOOP, "--format", "json").stdout)["quasi_interpolation"]
    assert page["degree"] == 3
    assert [[1, 1], "-1/12"] in page["stencil"]
    assert [[2, 0], "11/6"] in page["operator"]
    assert [[1, 1], "25/6"] in page["moments"]
    haar = str(MASKS / "counterexamples" / "haar.toml")
    assert json.loads(run("show", haar, "--format", "json").stdout)["quasi_interpolation"] is None


def test_the_stencil_of_q_in_reports(run):
    grid = "Q f(α) = Σ t_j f(α+j), in 1/12"
    assert grid not in run("check", LOOP).stdout
    for arguments in (["-v"], ["-vv"], ["--format", "html"], ["-v", "--no-cache"]):
        text = run("check", LOOP, *arguments).stdout
        assert grid in text
        assert "2 │  -1  18  -1" in text
    assert "a stencil with the weights 3/2 at (2, 2); -1/12 at" in run("check", LOOP, "--format", "concise").stdout
    assert "Σ t_j" not in run("check", str(MASKS / "butterfly.toml"), "-v").stdout


def multiplied_out(page):
    """The mask from the factors of its symbol and the quotient."""
    total = {tuple(index): Fraction(x) for index, x in page["symbol"]["quotient"]}
    c = page["mask"]["dilation"][0][0]
    for factor in page["symbol"]["factors"]:
        for _ in range(factor["multiplicity"]):
            product_ = {}
            for index, i in product(total, range(c)):
                at = tuple(x + i * t for x, t in zip(index, factor["direction"], strict=True))
                product_[at] = product_.get(at, 0) + total[index]
            total = {index: x for index, x in product_.items() if x}
    return total


def test_the_certificate_of_show_verifies(run, tmp_path):
    assert run("show", LOOP, "--certificate", str(tmp_path / "proofs")).exit_code == 0
    assert check_text((tmp_path / "proofs" / "loop.json").read_text(encoding="utf-8")).verified
