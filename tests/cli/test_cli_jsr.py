"""`subdiv jsr` as a user runs it: text, JSON, a certificate for `subdiv verify`, exit codes."""

import json
from fractions import Fraction

import pytest
from click.testing import CliRunner
from support import subdiv

from subdiv_cli import pipeline
from subdiv_cli.checker import Outcome, check_document
from subdiv_cli.cli import main
from subdiv_cli.jsr.answer import _primitive, answer
from subdiv_cli.model import Effort
from subdiv_cli.model.family import FamilyRadius

FAMILY = """\
name = "two shears"
matrices = [[[1, 1], [0, 1]], [["a", 0], ["a", "a"]]]
[parameters]
a = "9/10"
"""


@pytest.fixture
def family(tmp_path):
    file = tmp_path / "family.toml"
    file.write_text(FAMILY, encoding="utf-8")
    return file


def test_the_report(family):
    run = subdiv("jsr", family)
    assert (run.returncode, run.stderr) == (0, "")
    first, second, *rest = run.stdout.splitlines()
    assert first.startswith(
        "✓ joint spectral radius = root(100*x^2-270*x+81, 2.35623, 2.35624)^(1/2) = 1.53500182080507"
    )
    assert second == f"  two shears · {family} · 2 matrices of order 2"
    assert "  attained by the product M_1 M_0, length 2" in rest


def test_json_and_a_certificate_that_verifies(family, tmp_path):
    proof = tmp_path / "proof.json"
    run = subdiv("jsr", family, "-p", "a=1", "--format", "json", "--certificate", proof)
    assert run.returncode == 0
    said = json.loads(run.stdout)
    assert (said["format"], said["version"], said["smp"]) == ("subdiv-jsr", 1, [[0, 1]])
    assert said["exact"] == "root(x^2-x-1, 1.61803, 1.61804)"
    low, high = Fraction(said["lower"]), Fraction(said["upper"])
    assert low**2 - low - 1 <= 0 <= high**2 - high - 1
    assert high - low < Fraction(1, 10**15)
    assert (said["bounded"], said["stopped"], said["certificate"]) == (True, None, str(proof))
    verified = subdiv("verify", proof)
    assert verified.returncode == 0
    assert "VERIFIED JSR = the root of x^2 - x - 1 in [" in verified.stdout
    document = json.loads(proof.read_text(encoding="utf-8"))
    document["goal"][0]["polynomial"] = ["-2", "1"]
    proof.write_text(json.dumps(document), encoding="utf-8")
    assert subdiv("verify", proof).returncode == 1


def test_an_enclosure(family):
    run = subdiv("jsr", family, "-p", "a=749326546330/1000000000000", "--format", "json")
    said = json.loads(run.stdout)
    assert run.returncode == 0
    assert said["exact"] is None
    assert said["lower"] < 1.40924722212 < said["upper"]


def test_the_same_bytes_again():
    first, again = (subdiv("jsr", "-", "--format", "json", stdin=FAMILY).stdout for _ in range(2))
    assert first == again


@pytest.mark.parametrize(
    ("arguments", "stdin", "code"),
    [
        (["-", "--effort", "1"], FAMILY, 3),
        (["-"], "matrices = [[[0]]]", 0),
        (["-"], "matrices = [[[1, 1], [0, 1]], [[1, 0]]]", 2),
        (["-"], "matrices = []", 2),
        (["-"], "matrices = [[[0.5]], [[1, 0], [0, 1]]]", 2),
        (["-"], "[mask]\nsymbol = '(1+z)^2/2'", 2),
        (["-", "-p", "b=1"], FAMILY, 2),
        (["no such file"], None, 2),
        (["-", "--certificate", "no such directory/proof.json"], FAMILY, 2),
        ([], None, 2),
    ],
)
def test_exit_codes(arguments, stdin, code):
    run = subdiv("jsr", *arguments, stdin=stdin)
    assert run.returncode == code
    assert "Traceback" not in run.stderr
    assert (code == 2) == (run.stdout == "")


def test_no_certificate_without_a_bound(family, tmp_path):
    proof = tmp_path / "proof.json"
    run = subdiv("jsr", family, "--effort", "1", "--certificate", proof)
    assert run.returncode == 3
    assert run.stderr == f"warning: {proof} is not written: nothing is proved\n"
    assert not proof.exists()


EXHAUSTED = Outcome(False, lambda: "NOT VERIFIED claim 0: too much work", exhausted=True)


def test_a_bound_whose_proof_is_beyond_the_checker_is_left_out(family, tmp_path, monkeypatch):
    """What is verified takes its place, and a line says so."""

    def check(document, goes_on):
        return check_document(document) if document["claims"][0]["rule"] == "polytope" else EXHAUSTED

    monkeypatch.setattr("subdiv_cli.pipeline.check_document", check)
    proof = tmp_path / "proof.json"
    run = subdiv("jsr", family, "--certificate", proof)
    assert run.returncode == 3
    assert run.stderr == "warning: a better bound is left out: its proof asks more work of the checker than it does\n"
    assert run.stdout.startswith("~ joint spectral radius in ")
    assert check_document(json.loads(proof.read_text())).verified


def test_without_a_proof_that_the_checker_accepts_there_is_no_bound(family, tmp_path, monkeypatch):
    monkeypatch.setattr("subdiv_cli.pipeline.check_document", lambda document, goes_on: EXHAUSTED)
    proof = tmp_path / "proof.json"
    run = subdiv("jsr", family, "--certificate", proof)
    assert run.returncode == 3
    assert run.stderr.startswith(f"warning: {proof} is not written: nothing is proved\n")
    why = "its proof asks more work of the checker than it does"
    assert run.stdout.startswith(f"? joint spectral radius: not one bound was found; {why}\n")
    assert not proof.exists()
    assert subdiv("jsr", family).returncode == 3


@pytest.mark.parametrize(
    ("lower", "upper", "exact", "sign", "code"),
    [
        (0.0, 8.88, None, "~", 3),
        (1.0, 1.2, None, "~", 3),
        (1.0, 1.05, None, "~", 0),
        (2.0, 2.0000001, None, "✓", 0),
        (2.0, 2.0, "2", "✓", 0),
        (0.0, 0.0, "0", "✓", 0),
        (0.0, 0.0, None, "✓", 0),
    ],
)
def test_a_wide_enclosure_is_no_success(family, monkeypatch, lower, upper, exact, sign, code):
    radius = FamilyRadius(order=2, letters=2, lower=lower, upper=upper, exact=exact, method="polytope")
    monkeypatch.setattr(pipeline, "joint_spectral_radius", lambda *_: pipeline.CheckedRadius(radius, None))
    done = CliRunner().invoke(main, ["jsr", str(family)], prog_name="subdiv")
    assert done.exit_code == code
    assert done.output.startswith(f"{sign} joint spectral radius")


def test_the_product_is_named_by_its_primitive_word():
    halves = [[[Fraction(x) for x in row] for row in rows] for rows in ([[0, 2], [2, 0]], [[0, 1], [1, 0]])]
    for word in ((0, 0), (0, 0, 0), (0,)):
        assert _primitive(word) == (0,)
    assert _primitive((0, 1, 0, 1)) == (0, 1)
    assert _primitive((0, 1, 1)) == (0, 1, 1)
    assert answer(halves, Effort()).words == ((0,),)
