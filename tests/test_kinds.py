"""A toy kind, defined here and registered by its name, goes everywhere: what a new kind has to bring is in this file.

The toy scheme multiplies the data by a weight at each level. It converges iff the weight is below 1 in modulus.
"""

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple, NotRequired, TypedDict

import pytest
from click.testing import CliRunner

from subdiv_cli import checker
from subdiv_cli.certificate.claims import Claims, proofs
from subdiv_cli.checker.core import Rulebook, Step, Subject
from subdiv_cli.checker.plain import PlainMask, PlainReaders, literal
from subdiv_cli.checker.reading import require
from subdiv_cli.cli import main
from subdiv_cli.kinds import KINDS
from subdiv_cli.kinds.kind import PICTURES, Analysis, ContradictionError, Drawings, Kind, Portraits, gather, run_stages
from subdiv_cli.maskfile.entries import mask_table, read_expression
from subdiv_cli.maskfile.expressions import Expression, number_of
from subdiv_cli.maskfile.expressions import literal as literal_expression
from subdiv_cli.maskfile.problems import Fault
from subdiv_cli.model import Verdict
from subdiv_cli.model.blocks import Curve, Drawing, Formula, Grid, Portrait, Section, Statements
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import CONVERGENCE, row, table
from subdiv_cli.report import FORMATS
from subdiv_cli.report.show import FORMATS as PAGES


class ToyWitness(TypedDict):
    weight: NotRequired[Fraction]


CONVERGES = row(
    "SD899", "toy-convergence", "folklore", ToyWitness, answers=CONVERGENCE, proves="convergent", holds=True
)


@dataclass(frozen=True, slots=True)
class ToyScheme:
    weight: Fraction
    kind = "toy"


class ToyBody(NamedTuple):
    weight: Expression

    def expressions(self) -> Iterable[Expression]:
        return (self.weight,)

    def scheme(self, values: Mapping[str, Fraction], problems, work) -> ToyScheme | None:
        weight = number_of(self.weight, values, problems, work)
        return None if weight is None else ToyScheme(weight)


def read(top, parameters, problems):
    inner = mask_table(top)
    if inner is None:
        return None
    inner.only(("weight",))
    try:
        return ToyBody(read_expression(inner.data.get("weight"), ("mask", "weight"), parameters))
    except Fault as fault:
        problems.add(fault, ("mask", "weight"))
        return None


def convergence(scheme, facts):
    if abs(scheme.weight) < 1:
        return (CONVERGES.proved(f"S converges: the weight {scheme.weight} is below 1", {"weight": scheme.weight}),)
    return (CONVERGES.refuted(f"S does not converge: the weight {scheme.weight} is too large", {}),)


def analyse(scheme, effort, tolerance=None):
    return Analysis(scheme, {"weight": scheme.weight}, run_stages(scheme, (convergence,)), scheme)


def certificate(analysis):
    claims = Claims()

    def claims_of(finding):
        return [claims.prove("toy", {"property": "convergent", "holds": finding.verdict is Verdict.PROVED})]

    return proofs(claims, canonical(analysis.scheme), analysis.findings, claims_of)


def canonical(scheme) -> Mapping[str, Any]:
    return {"kind": "toy", "weight": rational(scheme.weight)}


def sections(scheme, result):
    return (Section("multiply by", (Grid("", ("f",), (("S f", (str(scheme.weight),)),)),)),)


def portrait(analysis, result):
    blocks = (Formula("S f", f"{analysis.scheme.weight} f"), Statements(result.findings))
    return Portrait((Section("Scheme", blocks),), {"weight": analysis.scheme.weight})


def draw(scheme, effort, options, certify):
    _, result = certify(effort)
    if result.convergent is not Verdict.PROVED:
        return Drawing((), result, CONVERGENCE)
    values = tuple(scheme.weight**i for i in range(5))
    return Drawing((Curve(2, 0, 0, values, (Fraction(0), Fraction(4))),), result)


KIND = Kind(
    name="toy",
    read=read,
    body_of=lambda scheme: ToyBody(literal_expression(scheme.weight)),
    spell=lambda body: ["[mask]", f'weight = "{body.weight.text}"'],
    canonical=canonical,
    rules=lambda: table({"CONVERGES": CONVERGES}),
    analyse=analyse,
    proofs=certificate,
    base=lambda mask, variables: (2, 1),
    sections=sections,
    portraits=Portraits(analyse, portrait),
    drawings=(Drawings("sequences", draw, PICTURES),),
)


def check_toy(claim):
    claim.count(1)
    require((abs(claim.about) < 1) is claim.statement["holds"], "the weight says otherwise")


RULEBOOK = Rulebook(
    {"weight": "rational"},
    lambda parts: Subject(1, parts["weight"]),
    {"convergent": {"holds": "boolean"}},
    {"toy": Step(("convergent",), {}, ({},), check_toy)},
    lambda statement, subject: "S converges" if statement["holds"] else "S diverges",
    PlainReaders(
        lambda document: PlainMask("toy", (literal(document["mask"]["weight"]),)),
        lambda mask: PlainMask("toy", (Fraction(mask["weight"]),)),
    ),
)


@pytest.fixture(autouse=True)
def registered(monkeypatch):
    monkeypatch.setitem(KINDS, "toy", __name__)
    monkeypatch.setitem(checker.KINDS, "toy", RULEBOOK)
    for name in ("COLUMNS", "NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)


@pytest.fixture
def file(tmp_path):
    """A mask of the kind, which expects to converge."""
    path = tmp_path / "toy.toml"
    path.write_text(
        'name = "a toy"\nkind = "toy"\n[parameters]\nw = "1/2"\n[mask]\nweight = "w"\n[expect]\nconvergent = true\n'
    )
    return path


def run(*arguments, code=0):
    """What a command prints, in this process; it exits with the code."""
    done = CliRunner().invoke(main, [str(x) for x in arguments], prog_name="subdiv")
    assert done.exit_code == code, done.output
    return done.stdout


def check(file, *more, code=0):
    return run("check", file, "--jobs", "1", *more, code=code)


def test_check_decides_and_judges(file, tmp_path):
    text = check(file, "--no-cache")
    assert "a toy: convergent — convergence proved" in text
    assert "SD899\n" in text
    assert "✓ passed: converges; 1 of 1 expectation proved\n" in text
    assert "SD899 toy-convergence" in check(file, "--no-cache", "-v")
    report = json.loads(check(file, "-p", "w=-2", "--no-cache", "--format", "json", code=1))
    (result,) = report["results"]
    assert (result["kind"], result["parameters"], result["status"]) == ("toy", {"w": "-2"}, "failed")
    assert result["convergent"] == {"verdict": "refuted"}
    assert result["facts"] == {"weight": "-2"}
    assert result["findings"][0]["claims"] == [0]
    assert (result["generation"], result["holder"], result["stable"]) == (None, None, {"verdict": "skipped"})


def test_errors_in_its_files_say_where(file):
    file.write_text('kind = "toy"\n[mask]\nwieght = 1\n')
    done = CliRunner().invoke(main, ["check", str(file), "--jobs", "1"], prog_name="subdiv")
    assert done.exit_code == 2
    assert "did you mean weight?" in done.stderr


@pytest.mark.parametrize("form", FORMATS)
def test_every_format_shows_it(file, form):
    failing = ("--no-cache", "--format", form, "-p", "w=7")
    plain, full = check(file, *failing, code=1), check(file, *failing, "-v", code=1)
    assert "the weight 7 is too large" in full or form in ("sarif", "github", "markdown")
    assert "found not convergent" in full or form in ("json", "jsonl", "text", "html")
    assert form != "html" or "multiply by" in plain
    assert form != "text" or ("S f  7" in full and "S f" not in plain)


def test_the_cache_verifies_it_again(file, tmp_path, monkeypatch):
    where = tmp_path / "cache"
    first = check(file, "--cache-dir", where, "--format", "json")
    assert len(list(where.rglob("*.entry"))) == 1
    monkeypatch.setattr(f"{__name__}.convergence", None)  # which is not asked again
    assert check(file, "--cache-dir", where, "--format", "json") == first
    monkeypatch.setitem(checker.KINDS, "toy", RULEBOOK._replace(rules={}))  # the checker does not know its rule
    assert "not checked: 1 error" in " ".join(check(file, "--cache-dir", where, code=2).split())  # it is asked again


def test_certificates_verify_and_forged_ones_do_not(file, tmp_path):
    check(file, "--no-cache", "--certificate", tmp_path / "proofs")
    proof = tmp_path / "proofs" / "toy.json"
    assert run("verify", proof).startswith("VERIFIED S converges")
    assert "expanded by subdiv" in run("verify", proof, "--mask", file)
    plain = tmp_path / "plain.toml"
    plain.write_text('kind = "toy"\n[mask]\nweight = "1/2"\n')
    assert f"the mask of {plain})" in run("verify", proof, "--mask", plain)
    plain.write_text('kind = "toy"\n[mask]\nweight = "1/3"\n')
    assert "another mask" in run("verify", proof, "--mask", plain, code=1)
    proof.write_text(proof.read_text().replace("true", "false"))
    assert "NOT VERIFIED claim 0 (toy): the weight says otherwise" in run("verify", proof, code=1)


def test_a_baseline_judges_it(file, tmp_path):
    report = tmp_path / "report.json"
    report.write_text(check(file, "--no-cache", "--format", "json"))
    assert "nothing is worse" in check(file, "--no-cache", "--baseline", report)
    file.write_text(file.read_text().replace("1/2", "3"))
    assert "convergence was proved and is refuted" in check(file, "--no-cache", "--baseline", report, code=1)
    merged = run("merge", report, "--format", "concise")
    assert "SD899 toy-convergence proved" in merged


@pytest.mark.parametrize("form", PAGES)
def test_show_takes_it_apart(file, form):
    page = run("show", file, "--format", form)
    assert "1/2" in page or "tfrac{1}{2}" in page
    if form == "json":
        assert json.loads(page)["weight"] == "1/2"


def test_plot_draws_it(file, tmp_path):
    assert "│" in run("plot", file)
    picture = tmp_path / "toy.svg"
    run("plot", file, "-o", picture)
    assert picture.read_bytes().startswith(b"<?xml")
    run("plot", file, "-p", "w=2", code=1)


def test_what_a_kind_does_not_declare_it_cannot(file, monkeypatch):
    bare = Kind(**{name: getattr(KIND, name) for name in ("name", "read", "body_of", "spell", "canonical", "rules")})
    monkeypatch.setattr(f"{__name__}.KIND", bare)
    for command, word in (("check", "checked"), ("show", "taken apart"), ("plot", "drawn")):
        done = CliRunner().invoke(main, [command, str(file)], prog_name="subdiv")
        assert done.exit_code == 2
        assert f"masks of kind toy cannot be {word} yet" in done.stderr


def test_a_question_is_answered_once(file):
    (finding,) = convergence(ToyScheme(Fraction(1, 2)), None)
    assert gather((finding,)).convergent is Verdict.PROVED
    with pytest.raises(ContradictionError, match="SD899 answers convergence again"):
        gather((finding, finding))
