"""A new kind is a line in `checker.KINDS`: a toy kind goes through check, words and plain files; and who knows whom."""

import ast
import json
import subprocess
import sys
from pathlib import Path

import pytest
from hand_made_multivariate import ALL_MULTIVARIATE

import subdiv_cli.checker
from subdiv_cli.checker import KINDS, check_document, check_text
from subdiv_cli.checker.__main__ import main
from subdiv_cli.checker.core import Rulebook, Step, Subject
from subdiv_cli.checker.numerals import UnreadableError
from subdiv_cli.checker.plain import PlainMask, PlainReaders, certified_mask, mask_of, plain_mask
from subdiv_cli.checker.reading import require

FOLDER = Path(subdiv_cli.checker.__file__).parent
BY_HAND = Path(__file__).parents[1] / "certificate" / "chaikin_by_hand.json"


def divides(c):
    c.count(1)
    require(c.about == c.statement["factor"] * c.witness["cofactor"], "it does not divide the number")


def colour(value):
    if value not in ("red", "blue"):
        raise UnreadableError("is no colour")
    return value


TOY = Rulebook(
    fields={"number": "natural", "colour": colour},
    subject=lambda parts: Subject(1, parts["number"]),
    properties={"divisor": {"factor": "natural"}},
    rules={"divides": Step(("divisor",), {}, ({"cofactor": "natural"},), divides)},
    words=lambda statement, subject: f"{statement['factor']} divides {subject.about}",
    plain=PlainReaders(
        of_file=lambda document: PlainMask("toy", (document["number"],)) if "number" in document else None,
        of_certificate=lambda mask: PlainMask("toy", (mask["number"],)),
    ),
)


@pytest.fixture
def toy(monkeypatch):
    monkeypatch.setitem(KINDS, "toy", TOY)


def certificate(factor=3, cofactor=4, **mask):
    statement = {"property": "divisor", "factor": factor}
    claim = {"rule": "divides", "statement": statement, "witness": {"cofactor": cofactor}, "uses": [], "work": 1}
    about = {"kind": "toy", "number": 12, "colour": "red", **mask}
    document = {"format": "subdiv-certificate", "version": 1, "mask": about, "goal": [statement], "claims": [claim]}
    return json.loads(json.dumps(document))


@pytest.mark.usefixtures("toy")
def test_a_toy_kind_is_checked():
    assert check_document(certificate()).line == "VERIFIED 3 divides 12"
    assert check_document(certificate(5)).line == "NOT VERIFIED claim 0 (divides): it does not divide the number"
    assert check_document(certificate(colour="pink")).line == "NOT VERIFIED document: 'colour' of the mask is no colour"


def test_an_unknown_kind_is_not():
    known = "scalar, matrices, multivariate, vector, hermite, piecewise"
    line = f"NOT VERIFIED document: the kind of the mask is not one of {known}"
    for kind in ("toy", "json", "subdiv_cli.checker.scalar.rules", "", "__class__"):
        assert check_document(certificate(kind=kind)).line == line


@pytest.mark.usefixtures("toy")
def test_plain_files_of_a_toy_kind(tmp_path, capsys):
    assert plain_mask('kind = "toy"\nnumber = 12\n') == certified_mask(json.dumps(certificate()))
    assert plain_mask('kind = "toy"\n') is None
    proof, plain, other = (tmp_path / name for name in ("c.json", "plain.toml", "other.toml"))
    proof.write_text(json.dumps(certificate()), encoding="utf-8")
    plain.write_text('kind = "toy"\nnumber = 12\n', encoding="utf-8")
    other.write_text('kind = "toy"\nnumber = 13\n', encoding="utf-8")
    assert main([str(proof), "--mask", str(plain)]) == 0
    assert capsys.readouterr().out == f"VERIFIED 3 divides 12 (the mask of {plain})\n"
    assert main([str(proof), "--mask", str(other)]) == 1
    assert plain_mask('kind = ["toy"]\n') is plain_mask('kind = "none"\n') is None


def test_masks_of_two_kinds_differ():
    scalar = mask_of({"kind": "scalar", "arity": 2, "start": 0, "coefficients": ["1", "1"]})
    assert scalar == PlainMask("scalar", (2, 0, (1, 1)))
    assert scalar != PlainMask("toy", (2, 0, (1, 1)))


@pytest.mark.usefixtures("toy")
def test_a_tensor_product_of_a_toy_is_none():
    made = json.loads(json.dumps(ALL_MULTIVARIATE["chaikin_hat"]()))
    inside = next(claim["witness"] for claim in made["claims"] if claim["rule"] == "tensor-product")
    assert check_document(made).verified
    inside["certificates"][0] = certificate()
    assert "a certificate is about no mask" in check_document(made).line


def test_a_kind_is_loaded_when_it_is_asked_for():
    code = (
        "import sys; from subdiv_cli.checker import check_file\n"
        f"assert check_file({str(BY_HAND)!r})[0].verified\n"
        "print(*sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    kinds = {name.split(".")[2] for name in run.stdout.split() if name.startswith("subdiv_cli.checker.")}
    assert {"core", "radius", "scalar"} <= kinds
    assert "multivariate" not in kinds


KNOWS = {
    "radius": {"radius"},
    "curves": {"radius", "curves"},
    "scalar": {"radius", "scalar"},
    "multivariate": {"radius", "scalar", "multivariate"},
    "vector": {"radius", "scalar", "vector"},
    "hermite": {"radius", "vector", "hermite"},
    "piecewise": {"radius", "scalar", "piecewise"},
}
"""Which folders the modules of a folder import; those at the top import none."""


@pytest.mark.parametrize("file", sorted(FOLDER.rglob("*.py")), ids=lambda file: str(file.relative_to(FOLDER)))
def test_kinds_know_those_below_and_the_core_none(file):
    known = KNOWS.get(file.relative_to(FOLDER).parts[0], set())
    folders = {each.name for each in FOLDER.iterdir() if (each / "__init__.py").exists()}
    assert folders == set(KNOWS)
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("subdiv_cli.checker"):
            parts = {*(node.module or "").split(".")[2:3], *(alias.name for alias in node.names)}
            assert parts & folders <= known, f"{file}:{node.lineno}"


def test_every_rule_says_what_it_proves():
    for name in KINDS:
        for rule, step in KINDS[name].rules.items():
            assert (step.check.__doc__ or "").strip(), rule
            assert set(step.properties) <= set(KINDS[name].properties), rule
            assert step.witnesses, rule


def test_a_text_is_checked_by_the_table_too(monkeypatch):
    monkeypatch.setitem(KINDS, "toy", TOY)
    assert check_text(json.dumps(certificate())).verified
    monkeypatch.delitem(KINDS, "toy")
    assert not check_text(json.dumps(certificate())).verified
