"""A kind that is made up: `show` and `plot` and the pictures of reports know nothing of it but what it declares."""

import json
import sys
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import TypedDict

import pytest
from click.testing import CliRunner

from subdiv_cli import checker, kinds
from subdiv_cli.certificate.claims import Claims, proofs
from subdiv_cli.checker.core import Rulebook, Step, Subject
from subdiv_cli.checker.reading import require
from subdiv_cli.cli import main
from subdiv_cli.kinds.kind import PICTURES, Analysis, Drawings, Kind, NotDrawnError, Portraits
from subdiv_cli.model import Rule, Smoothness
from subdiv_cli.model.blocks import (
    Curve,
    Drawing,
    Formula,
    Grid,
    Heights,
    Matrix,
    Net,
    Plane,
    Planes,
    Polygon,
    Portrait,
    Section,
    Statements,
    Text,
    Words,
)
from subdiv_cli.model.findings import CONVERGENCE, SMOOTHNESS

F = Fraction
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
HAT = Curve(2, 1, -1, (F(1, 2), F(1), F(1, 2)), (F(-1), F(1)))
BUMP = Heights(((F(1, 2), F(0)), (F(0), F(1, 2))), {(i, j): F(1, 1 + i * i + j * j) for i, j in SQUARE})


class Empty(TypedDict):
    """The witness of a toy."""


CONVERGES = Rule("SD998", "toy-convergence", "nobody", Empty, answers=(CONVERGENCE,))
SMOOTH = Rule("SD999", "toy-smoothness", "nobody", Empty, answers=(SMOOTHNESS,))


class Toy:
    kind = "toy"

    def __init__(self, size):
        self.size = size


class Body:
    """Of a file with one number."""

    def __init__(self, size):
        self.size = size

    def expressions(self):
        return []

    def scheme(self, values, problems, work):
        return Toy(self.size)


def analyse(scheme, effort, tolerance=None):
    if scheme.size > 2:
        found = SMOOTH.proved("it is smooth", {}, answers={SMOOTHNESS: Smoothness(0)})
    else:
        found = SMOOTH.undecided("is it smooth?", "nobody knows")
    return Analysis(scheme, {"extent": scheme.size}, (CONVERGES.undecided("does it?", "who knows"), found), scheme)


def portrait(analysis, result):
    blocks = (
        Words("facts"),
        Text("a line", "quiet"),
        Formula("x", "1/2 y"),
        Grid("i", ("0", "1"), (("a_i", ("1/2", "")), ("b_i", ("", "3")))),
        Planes((Plane("one", {(0, 0): "1", (1, 2): "-2"}), Plane("two", {(0, 0): "7"}))),
        Matrix("M", (("1", "2"), ("3", "40"))),
        HAT,
        BUMP,
        Statements(result.findings),
        Words("exponents"),
    )
    return Portrait(
        (Section("All", blocks), Section("Found", (Statements(result.findings, full=True),))), {"extent": 3}
    )


def functions(scheme, effort, options, certify):
    _, result = certify(effort)
    return Drawing((HAT,) if result.refinable.order is not None else (), result, SMOOTHNESS)


def polygons(scheme, effort, options, certify):
    x, y = zip(*options["points"], strict=True)
    if scheme.size > 9:
        raise NotDrawnError("it is too large")
    return Drawing((Polygon(x, y, closed=True, control="control polygon"), Polygon(x, y)))


def net(scheme, effort, options, certify):
    return Drawing((Net({place: (*map(F, place), F(1)) for place in SQUARE}, title="φ is flat"),))


def proved(analysis):
    claims = Claims()
    mask = {"kind": "toy", "size": analysis.scheme.size}
    return proofs(claims, mask, analysis.findings, lambda _: [claims.prove("toy", {"property": "smooth", "order": 0})])


def is_smooth(claim):
    claim.count(1)
    require(claim.about > 2, "it is too small to be smooth")


RULEBOOK = Rulebook(
    {"size": "natural"},
    lambda fields: Subject(2, fields["size"]),
    {"smooth": {"order": "natural"}},
    {"toy": Step(("smooth",), {}, ({},), is_smooth)},
    lambda statement, subject: "it is smooth",
    None,
)
KIND = Kind(
    name="toy",
    keys=("size",),
    read=lambda top, parameters, problems: Body(top.data["size"]),
    body_of=lambda scheme: Body(scheme.size),
    spell=lambda body: [f"size = {body.size}"],
    canonical=lambda scheme: {"kind": "toy", "size": scheme.size},
    rules=lambda: {rule.code: rule for rule in (CONVERGES, SMOOTH)},
    analyse=analyse,
    proofs=proved,
    sections=lambda scheme, result: (Section("numbers", (Grid("", ("n",), (("size", (str(scheme.size),)),)),)),),
    portraits=Portraits(analyse, portrait),
    drawings=(
        Drawings("nets", net, frozenset({".obj"}), most=1),
        Drawings("curves", polygons, PICTURES, needs=frozenset({"points"}), options=frozenset({"points"}),
                 points=lambda file: [tuple(map(F, place)) for place in SQUARE]),
        Drawings("functions", functions, PICTURES, options=frozenset({"samples"})),
    ),
)  # fmt: skip


@pytest.fixture
def run(monkeypatch, tmp_path):
    module = ModuleType("toy_kind")
    module.KIND = KIND
    monkeypatch.setitem(sys.modules, "toy_kind", module)
    monkeypatch.setitem(kinds.KINDS, "toy", "toy_kind")
    monkeypatch.setitem(checker.KINDS, "toy", RULEBOOK)
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.chdir(tmp_path)
    for size in (1, 3, 10):
        (tmp_path / f"toy{size}.toml").write_text(f'kind = "toy"\nname = "toy {size}"\nsize = {size}\n')
    return lambda *args: CliRunner().invoke(main, args, prog_name="subdiv")


def test_show_in_every_format(run):
    text = run("show", "toy3.toml")
    assert (text.exit_code, text.stderr) == (0, "")
    for part in ("  extent: 3\n", "x = 1/2 y", "    a_i  1/2\n    b_i       3\n", " 2 │  ·  -2", "⎣ 3  40 ⎦", "█"):
        assert part in text.stdout
    assert "it is smooth (proved, SD999)" in text.stdout
    assert "✓ proved     SD999 toy-smoothness\n               it is smooth\n               nobody\n" in text.stdout
    markdown = run("show", "toy3.toml", "--format", "markdown").stdout
    assert "| 2 | · | -2 |" in markdown
    assert "M =\n  1   2\n  3  40\n" in markdown
    latex = run("show", "toy3.toml", "--format", "latex").stdout
    assert latex.count("\\begin{tikzpicture}") == 2
    page = json.loads(run("show", "toy3.toml", "--format", "json").stdout)
    assert (page["extent"], page["report"]["kind"]) == (3, "toy")
    refused = run("show", "toy3.toml", "--tolerance", "1/2")
    assert refused.exit_code == 2
    assert "--tolerance belongs to curves" in refused.stderr


def test_plot(run):
    drawn = run("plot", "toy3.toml", "toy10.toml")
    assert (drawn.exit_code, drawn.stderr) == (0, "")
    assert drawn.stdout.startswith("φ\n")
    assert run("plot", "toy3.toml", "--points", "-").stdout.startswith("toy 3\n")
    nothing = run("plot", "toy1.toml")
    assert nothing.exit_code == 3
    assert nothing.stderr == "toy 1: nothing to draw, φ is not proved continuous\n"
    assert "not drawn: it is too large" in run("plot", "toy10.toml", "--points", "-").stderr
    assert run("plot", "toy3.toml", "-o", "a.obj").exit_code == 0
    assert Path("a.obj").read_text(encoding="ascii").startswith("# toy 3: phi is flat\n")
    for arguments, message in (
        (["--levels", "2"], "--levels belongs to"),
        (["--points", "-", "--samples", "5"], "--samples belongs to"),
        (["-o", "a.obj", "--samples", "5"], "--samples belongs to"),
        (["toy1.toml", "-o", "a.obj"], "2 nets, and one picture takes 1"),
    ):
        refused = run("plot", "toy3.toml", *arguments)
        assert (refused.exit_code, refused.stdout) == (2, "")
        assert message in refused.stderr


def test_reports_have_its_sections(run):
    for arguments in (["-v"], ["--format", "html"]):
        shown = run("check", "toy3.toml", "--no-cache", *arguments)
        assert shown.exit_code == 3
        assert "size" in shown.stdout
    assert "<h3>numbers</h3><table><tr><th>size</th>" in shown.stdout
