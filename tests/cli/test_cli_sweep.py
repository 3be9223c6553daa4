"""`subdiv sweep` as a user runs it: known exponents and norms along families, formats, the picture, bad input."""

import csv
import io
import json
import re
from fractions import Fraction as Q
from math import log2, sqrt
from pathlib import Path

import jsonschema
import pytest
from lxml import etree
from support import four_point, subdiv

import subdiv_cli
from subdiv_cli import pipeline
from subdiv_cli.catalog import masks_directory
from subdiv_cli.catalog.task import Done
from subdiv_cli.cli import progress
from subdiv_cli.cli.sweep import _Values
from subdiv_cli.maskfile.option import MOST_VALUES
from subdiv_cli.model import Exponent, Finding, Result, Verdict
from subdiv_cli.model.findings import HOLDER_UPPER
from subdiv_cli.model.properties import BY_KEY
from subdiv_cli.model.sweep import Row, changes, maximizing_product

MASKS = masks_directory()
FOUR = MASKS / "scalar" / "four_point.toml"
SIX = MASKS / "scalar" / "six_point.toml"
REPORT = Path(subdiv_cli.__file__).parent / "report"
SCHEMA = json.loads((REPORT / "sweep_schema.json").read_text(encoding="utf-8"))
GRID = [Q(i, 8) for i in range(-4, 5)]


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("cache")


@pytest.fixture
def sweep(cache):
    """A sweep in one process, with the cache of this file."""
    return lambda *words: subdiv("sweep", *words, "--jobs", 1, "--cache-dir", cache)


def data(run):
    """The JSON of a run, which is as the schema says."""
    report = json.loads(run.stdout)
    jsonschema.validate(report, SCHEMA)
    keys = {"value", "undecided", "errors", *report["columns"]} | (
        {"product"} if "holder" in report["columns"] else set()
    )
    assert all(row.keys() == keys for row in report["rows"])
    return report


def close(exponent, value):
    return exponent["lower"] - 1e-12 <= value <= exponent["upper"] + 1e-12 and exponent["exact"]


def test_the_four_point_family_has_its_known_exponents(sweep):
    """ρ = (1 + √(1 - 16w))/4 from -1/2 to 1/16, and 2w near 1/2; at -1/2 φ is a hat function in z^3."""
    run = sweep(FOUR, "w=-1/2:1/2:1/8", "--format", "json")
    assert (run.returncode, run.stderr) == (0, "")
    report = data(run)
    assert (report["parameter"], report["fixed"], report["kind"]) == ("w", {}, "scalar")
    assert report["columns"] == ["convergent", "smoothness", "holder"]
    rows = {Q(row["value"]["exact"]): row for row in report["rows"]}
    assert list(rows) == GRID
    for w in (Q(-3, 8), Q(-1, 4), Q(-1, 8), Q(0)):
        assert close(rows[w]["holder"], -log2((1 + sqrt(1 - 16 * w)) / 4))
    assert rows[Q(3, 8)]["holder"]["exact"] == "log2(4/3)"
    assert (rows[Q(-1, 2)]["holder"]["exact"], rows[Q(1, 2)]["holder"]["exact"]) == ("1", "0")
    verdicts = [row["convergent"]["verdict"] for row in report["rows"]]
    assert verdicts == ["refuted", *["proved"] * 7, "refuted"]
    orders = [row["smoothness"]["order"] for row in report["rows"]]
    assert orders == [None, 0, 0, 0, 0, 1, 0, 0, None]
    assert [row["product"] for row in report["rows"]] == [[0]] * 5 + [[0, 1]] * 2 + [[0]] * 2


def test_the_table_is_short_and_marks_what_changes(sweep):
    run = sweep(FOUR, "w=1/16,3/32,1/8", "--columns", "smoothness,holder,generation,stable")
    assert run.returncode == 0
    assert (
        run.stdout
        == """\
four-point scheme: 3 values of w
  w     smoothness    Hölder exponent  generation  stability  product
  ────  ────────────  ───────────────  ──────────  ─────────  ────────
  1/16  C^1, not C^2  2                3           ✓ proved   T_0
  3/32  C^1, not C^2  1.6410538670…    1           ✓ proved   T_1T_0 *
  1/8   C^1, not C^2  1.3851709636…    1           ✓ proved   T_1T_0
(*: the product that attains the exponent is another one than at the next smaller w)
"""
    )
    assert run.stdout == subdiv("sweep", FOUR, "w=1/16,3/32,1/8", "--no-cache", "--jobs", 2, "--columns",
                                "smoothness,holder,generation,stable").stdout  # fmt: skip


def norm_of(a, nu, level):
    """‖((1/2) S_ν)^level‖∞ of a symbol a as a list: divide by (1+z)/2 ν times, halve, iterate, sum the classes."""
    for _ in range(nu):
        quotient = []
        for c in a:
            quotient.append(2 * c - (quotient[-1] if quotient else 0))
        assert quotient.pop() == 0
        a = quotient
    a, power = [c / 2 for c in a], [Q(1)]
    for _ in range(level):
        longer = [Q(0)] * (2 * len(power) + len(a) - 2)
        for i, c in enumerate(power):
            for j, b in enumerate(a):
                longer[2 * i + j] += c * b
        power = longer
    step = 2**level
    return max(sum(map(abs, power[g::step])) for g in range(step))


def test_norms_are_exact_and_need_no_check(sweep, monkeypatch):
    monkeypatch.setattr("subdiv_cli.catalog.sweep.check_all", None)
    names = ["norm:1:1", "norm:1:2", "norm:2:3", "norm:3:1"]
    report = data(sweep(FOUR, "w=-1/2:1/2:1/8,1/16", "--columns", ",".join(names), "--format", "json"))
    for row in report["rows"]:
        w = Q(row["value"]["exact"])
        for name in names[:3]:
            _, nu, level = name.split(":")
            norm = row[name]
            assert Q(norm["exact"]) == norm_of(list(four_point(w).coefficients), int(nu), int(level))
            assert Q(norm["lower"]) <= Q(norm["exact"]) <= Q(norm["upper"])
        assert (row["norm:3:1"] is None) == (w != Q(1, 16)), "S_3 exists at 1/16 alone"
    assert [row["norm:1:2"]["exact"] for row in report["rows"][:5]] == ["5/4", "1", "3/4", "1/2", "1/4"]


def test_csv_is_exact_with_outward_doubles(sweep):
    run = sweep(FOUR, "w=1/20:1/10:1/20", "--columns", "convergent,smoothness,holder,norm:1:1", "--format", "csv")
    first, second = csv.DictReader(io.StringIO(run.stdout))
    assert first == {
        "w": "1/20", "w_lower": "0.049999999999999996", "w_upper": "0.05", "convergent": "proved", "smoothness": "1",
        "smoothness_sharp": "true", "holder": "-log2(root(20*x^2-10*x+1, 0.361803, 0.361804))",
        "holder_lower": "1.4667221338130638", "holder_upper": "1.466722133813064", "norm:1:1": "3/5",
        "norm:1:1_lower": "0.6", "norm:1:1_upper": "0.6000000000000001", "product": "0", "error": "",
    }  # fmt: skip
    assert Q(float(first["w_lower"])) < Q(1, 20) < Q(float(first["w_upper"]))
    assert Q(float(first["norm:1:1_lower"])) < Q(3, 5) < Q(float(first["norm:1:1_upper"]))
    assert (second["w"], second["product"]) == ("1/10", "0 1")


def test_an_enclosure_that_is_wide_is_not_decided(sweep, tmp_path):
    """With little effort the exponents are enclosed only: exit 3, a band in the picture, and no product."""
    picture = tmp_path / "alpha.svg"
    words = [SIX, "theta=0,1/64,1/32", "--columns", "holder", "--effort", 40]
    run = sweep(*words, "--format", "json", "--plot", picture)
    assert run.returncode == 3
    assert run.stderr == "note: undecided at 2 of 3 values\n"
    exact, *wide = data(run)["rows"]
    assert (exact["holder"]["exact"], exact["product"], exact["undecided"]) == ("2", [0], [])
    for row in wide:
        assert (row["holder"]["exact"], row["product"], row["undecided"]) == (None, None, ["holder"])
        assert row["holder"]["upper"] - row["holder"]["lower"] > 1
    assert len(vertices(group(picture, "band"))) == 5, "two ends at two values, and one number"
    assert "2.17 .. 4" in sweep(*words).stdout
    rows = data(sweep(*words[:2], "--columns", "convergent,smoothness", "--effort", 40, "--format", "json"))["rows"]
    assert [row["undecided"] for row in rows] == [[], ["smoothness"], ["smoothness"]]


def test_a_norm_beyond_the_effort_is_not_decided(sweep):
    """Level 9 has more coefficients than that; at w = 0 there is no S_3, which is an answer."""
    words = [FOUR, "w=0,1/16", "--columns", "norm:3:9", "--effort", 500]
    run = sweep(*words, "--format", "json")
    assert run.returncode == 3
    assert [(row["norm:3:9"], row["undecided"]) for row in data(run)["rows"]] == [(None, []), (None, ["norm:3:9"])]
    assert [line.split() for line in sweep(*words).stdout.splitlines()[-2:]] == [["0", "–"], ["1/16", "?"]]


@pytest.mark.parametrize(("exact", "word"), [(Q(1), (0, 1)), (None, None)])
def test_only_an_exact_exponent_is_attained_by_a_product(exact, word):
    finding = Finding(
        code="SD312", name="holder-upper", verdict=Verdict.PROVED, statement="", source="",
        answers=((HOLDER_UPPER, Exponent(upper=1.0)),), witness={"word": (1, 0)},
    )  # fmt: skip
    result = Result(file="", status="passed", findings=(finding,), holder=Exponent(0.5, 1.0, exact))
    assert maximizing_product(result) == word


def group(picture, name):
    """The group of an SVG with this id."""
    (node,) = etree.parse(str(picture)).xpath("//*[@id=$name]", name=name)
    return node


def vertices(node):
    """The different points of the first path in a group."""
    path = node.xpath(".//*[local-name()='path']")[0].get("d")
    return set(re.findall(r"[ML] (-?[\d.]+ -?[\d.]+)", path))


def test_the_picture_has_the_band_the_exact_values_and_the_changes(sweep, tmp_path):
    one, other = tmp_path / "one.svg", tmp_path / "other.svg"
    for picture in (one, other):
        assert sweep(FOUR, "w=-1/2:1/2:1/8", "--plot", picture).returncode == 0
    assert one.read_bytes() == other.read_bytes()
    assert etree.parse(str(one)).getroot().tag == "{http://www.w3.org/2000/svg}svg"
    assert len(vertices(group(one, "band"))) >= len(GRID)
    assert len(vertices(group(one, "exact"))) == len(GRID)
    across = [sorted(float(v.split()[0]) for v in vertices(group(one, f"change-{i}"))) for i in range(2)]
    assert not etree.parse(str(one)).xpath("//*[@id='change-2']")
    places = sorted({float(v.split()[0]) for v in vertices(group(one, "exact"))})
    for (left, *_, right), (low, high) in zip(across, ((4, 5), (6, 7)), strict=True):
        assert (left, right) == pytest.approx((places[low], places[high]), abs=0.01)


@pytest.mark.parametrize("suffix", [".png", ".pdf"])
def test_other_pictures(sweep, tmp_path, suffix):
    picture = tmp_path / f"norms{suffix}"
    assert sweep(FOUR, "w=0,1/16", "--columns", "norm:1:1,norm:2:2", "--plot", picture).returncode == 0
    assert picture.read_bytes().startswith({".png": b"\x89PNG", ".pdf": b"%PDF"}[suffix])


def test_results_are_kept_for_check_too(tmp_path):
    sweep = ["sweep", FOUR, "w=1/16,1/20", "--cache-dir", tmp_path, "--format", "csv"]
    first = subdiv(*sweep)
    entries = {file: file.stat().st_mtime_ns for file in tmp_path.rglob("*.entry")}
    assert len(entries) == 2
    assert subdiv(*sweep).stdout == first.stdout
    assert subdiv("check", FOUR, "-p", "w=1/20", "--cache-dir", tmp_path).returncode == 1
    assert {file: file.stat().st_mtime_ns for file in tmp_path.rglob("*.entry")} == entries


def test_a_value_without_a_mask_is_a_row(sweep):
    """1/w is no number at 0; [w, 2w, w] has only zeros there."""
    run = sweep("--mask", "[w, 1, 1-w]/(2*w)*w*2", "w=-1:1:1", "--format", "json")
    bad, middle, good = data(run)["rows"]
    assert (run.returncode, run.stderr) == (0, "note: no mask at 1 of 3 values\n")
    assert (bad["errors"], good["errors"]) == ([], [])
    assert [middle[key] for key in ("convergent", "smoothness", "holder", "product")] == [None] * 4
    assert {error["code"] for error in middle["errors"]} == {"SD011"}
    run = sweep("--mask", "[w, 2*w, w]", "w=0:1:1/2")
    assert run.returncode == 0
    assert "w = 0: SD009 all coefficients of the mask are zero\n" in run.stdout
    assert re.search(r"^  1/2 +✓ proved +C\^0, not C\^1 +1 ", run.stdout, re.MULTILINE)
    run = sweep("--mask", "[w, 2*w, w]", "w=0", "--format", "csv")
    assert run.returncode == 2, "there is no mask at all"
    assert run.stdout.splitlines()[1].endswith(",SD009 all coefficients of the mask are zero")


def test_an_internal_error_is_none_of_the_values(sweep, monkeypatch):
    def broken(scheme, *rest, check=pipeline.check):
        if scheme == four_point("1/17"):
            raise ZeroDivisionError("ours")
        return check(scheme, *rest)

    monkeypatch.setattr(pipeline, "check", broken)
    run = sweep(FOUR, "w=1/17,1/18")
    assert run.returncode == 2
    assert re.search(r"^  1/18 +✓ proved", run.stdout, re.MULTILINE)
    assert "error[SD099] internal error: ZeroDivisionError: ours" in run.stderr


KINDS = {
    "vector": (
        '[mask]\nstart = 0\ncoefficients = [[["w", 0], [0, "w"]], [[1, 0], [0, 1]], [["1-w", 0], [0, "1-w"]]]',
        "w=1/4,1/2",
    ),
    "matrices": ('matrices = [[["1-w", "w"], [0, 1]], [[1, 0], ["1-w", "w"]]]', "w=1/4:3/4:1/4"),
    "multivariate": ('[mask]\ntensor = [{symbol = "(1+z)^2/2"}, {coefficients = ["w", 1, "1-w"]}]', "w=1/4"),
    "hermite": (
        '[mask]\nstart = -1\ncoefficients = [[["1/2", "-w"], ["3/4", "-1/8"]], [[1, 0], [0, "1/2"]], '
        '[["1/2", "w"], ["-3/4", "-1/8"]]]',
        "w=1/8,1/7",
    ),
}


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_with_parameters_has_its_rows(sweep, tmp_path, kind):
    """Of de Rham's functions, w and 1 - w in the matrices, the exponent is -log2 of the larger one."""
    body, values = KINDS[kind]
    top, table = ("", body) if body.startswith("[mask]") else (body, "")
    file = tmp_path / "family.toml"
    file.write_text(f'kind = "{kind}"\n{top}\n[parameters]\nw = "1/3"\n{table}\n', encoding="utf-8")
    run = sweep(file, values, "--columns", "convergent,holder,norm:1:1,well_defined", "--format", "json")
    report = data(run)
    assert report["kind"] == kind
    for row in report["rows"]:
        assert row["norm:1:1"] is None, "norms are those of scalar masks"
        w = Q(row["value"]["exact"])
        line = "infinity" if kind == "matrices" else "1"  # there it is the curve, here the refinable function
        exponents = {Q(1, 4): "log2(4/3)", Q(1, 2): line, Q(3, 4): "log2(4/3)", Q(1, 8): "2"}
        if w in exponents:
            assert (row["convergent"]["verdict"], row["holder"]["exact"]) == ("proved", exponents[w])


def test_other_parameters_are_set_with_p(sweep):
    """-p sets one of two: de Rham's corner cutting at r = 2/3, s = 1/3 is the shipped one."""
    run = sweep(MASKS / "matrices" / "de_rham_1_3.toml", "s=1/3", "-p", "r=2/3", "--format", "json")
    report = data(run)
    assert report["fixed"] == {"r": "2/3"}
    assert report["rows"][0]["holder"]["exact"] == "-log2(root(9*x^2-3*x-1, 0.539344, 0.539345))"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([FOUR, "w=0:1:0"], "the step is 0"),
        ([FOUR, "w=0:1:-1/4"], "the step leads away from 1"),
        ([FOUR, "w=1:0:1/4"], "help: write -1/4, or exchange FROM and TO"),
        ([FOUR, f"w=0:1:1/{MOST_VALUES}"], f"these are more than {MOST_VALUES} values"),
        ([FOUR, "w=0:1:10^-400"], f"these are more than {MOST_VALUES} values"),
        ([FOUR, "w=0:1"], '"0:1" is neither a value nor a range'),
        ([FOUR, "w=0:1:1/4:2"], "is neither a value nor a range"),
        ([FOUR, "w=0::1/4"], "NAME=FROM:TO:STEP:1:5"),
        ([FOUR, "w="], "no value for w"),
        ([FOUR, "w=0:1:v"], "NAME=FROM:TO:STEP:1:7"),
        ([FOUR, "u=0:1:1/4"], "no mask here has a parameter u"),
        ([FOUR, "w=0", "-p", "v=1"], "no mask here has a parameter v"),
        ([FOUR, "w=0", "-p", "w=1"], "w is given twice"),
        ([FOUR, "w=0", "-p", "v=0:1:1/4"], "-p gives v a value, not a range"),
        ([FOUR, "w=0", "--columns", "holder,smothness"], "no column 'smothness': did you mean smoothness?"),
        ([FOUR, "w=0", "--columns", "norm:0:1"], "no column 'norm:0:1'"),
        ([FOUR, "w=0", "--columns", ","], "names no column"),
        ([FOUR, "w=0", "--plot", "alpha.gif"], "must end in .svg, .png, .pdf"),
        ([FOUR, "w=0", "--plot", "none/alpha.svg"], "cannot be written"),
        ([FOUR, "w=0", "--plot", "a.svg", "--columns", "convergent"], "--plot draws exponents and norms"),
        ([FOUR], "name a FILE, then the values of a parameter"),
        (["w=0"], "name a mask: a FILE or --mask"),
        ([FOUR, SIX, "w=0"], "one mask and one parameter"),
        ([FOUR, "w=0", "--mask", "[1, 2, 1]/2"], "name a mask: a FILE or --mask"),
        ([MASKS / "scalar" / "dual_four_point.toml", "w=0"], "declare it in [parameters]"),
        (["none.toml", "w=0"], "none.toml"),
    ],
)
def test_bad_input_is_refused_with_the_mend(sweep, words, message):
    run = sweep(*words)
    assert (run.returncode, run.stdout) == (2, "")
    assert message in re.sub(r"\s+", " ", run.stderr)


@pytest.mark.parametrize("command", ["check", "show", "plot", "smooth"])
def test_a_range_elsewhere_names_this_command(command):
    run = subdiv(command, FOUR, "-p", "w=0:1/4:1/100")
    assert run.returncode == 2
    assert "error[SD011] -p gives w a value, not a range" in run.stderr
    assert "`subdiv sweep FILE w=0:1/4:1/100`" in run.stderr


def test_values_are_exact_in_the_order_given_and_none_twice(sweep):
    words = ["w=0.1:0.35:0.1,1/3,2^-3,1/10,1:1/2:-1/4", "--columns", "norm:1:1", "--format", "csv"]
    shown = [row["w"] for row in csv.DictReader(io.StringIO(sweep(FOUR, *words).stdout))]
    assert shown == ["1/10", "1/5", "3/10", "1/3", "1/8", "1", "3/4", "1/2"]


def test_a_number_beyond_all_doubles_has_none(sweep):
    (row,) = data(sweep(FOUR, "w=10^400", "--columns", "norm:1:1", "--format", "json"))["rows"]
    assert (row["value"]["lower"], row["value"]["upper"]) == (None, None)
    assert row["value"]["exact"] == "1" + "0" * 400


def test_changes_pass_over_rows_without_a_product():
    result = Result(file="", status="passed")
    rows = [Row(Q(w), result, product=word) for w, word in ((2, (0, 1)), (0, (0,)), (1, None), (3, (0, 1)))]
    assert [(row.value, other.value) for row, other in changes(rows)] == [(0, 2)]


def test_the_schema_shares_its_parts_with_that_of_reports():
    report = json.loads((REPORT / "schema.json").read_text(encoding="utf-8"))
    parts = {name: part for name, part in SCHEMA["$defs"].items() if name != "row"}
    assert parts == {name: report["$defs"][name] for name in parts}
    assert BY_KEY.keys() <= SCHEMA["$defs"]["row"]["properties"].keys()


def test_progress_counts_values(monkeypatch):
    monkeypatch.setattr(progress, "PAUSE", 0)
    terminal = io.StringIO()
    terminal.isatty = lambda: True
    shown = _Values(terminal)
    shown.begin(3)
    for cached in (False, True):
        shown.step(Done(Result(file="a.toml", status="failed"), cached=cached))
    assert [line.rstrip() for line in terminal.getvalue().split("\r")[1:]] == [
        "1/3 values",
        "2/3 values, 1 from the cache",
    ]
