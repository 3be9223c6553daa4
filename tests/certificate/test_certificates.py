"""The prover's certificates: the checker verifies them all, they cover every verdict, and the schema describes them."""

import json
import os
from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from support import corner_cutting, four_point, scheme, six_point

from subdiv_cli.catalog.run import check_all
from subdiv_cli.catalog.task import Settings, Task, perform
from subdiv_cli.checker import check_document, check_text
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check, show

ROOT = Path(__file__).parents[2]
MASKS = sorted((ROOT / "masks").rglob("*.toml"))
SCHEMA = json.loads((ROOT / "subdiv_cli" / "certificate" / "schema.json").read_text(encoding="utf-8"))
DECIDED = (Verdict.PROVED, Verdict.REFUTED)


def checked(mask, work=20_000):
    return check(mask, (), Effort(work))


@pytest.mark.parametrize("file", MASKS, ids=lambda file: file.stem)
def test_every_verdict_of_a_shipped_mask_has_a_verified_claim(file):
    result, document = checked(read_path(file).scheme())
    text = perform(Task(str(file)), Settings(cache=os.environ["SUBDIV_CACHE_DIR"], certificates=True)).certificate
    outcome = check_text(text)
    assert outcome.verified, outcome.line
    assert json.loads(text) == document, "another run has the same"
    jsonschema.validate(document, SCHEMA)
    for finding in result.findings:
        assert bool(finding.claims) is (finding.verdict in DECIDED), finding.code
        for claim in finding.claims:
            assert document["claims"][claim]["statement"] in document["goal"]


def test_the_goal_says_what_the_report_says():
    _, document = checked(four_point("1/16"))
    goal = document["goal"]
    assert {"property": "convergent", "holds": True} in goal
    assert {"property": "smooth", "order": 1} in goal
    assert {"property": "not-smooth", "order": 2} in goal
    root = {"length": 1, "polynomial": ["-1", "4"], "low": "1/4", "high": "1/4"}
    assert {"property": "holder-root", **root} in goal
    assert {"property": "attained", "holds": False} in goal
    assert {"property": "stable", "mask": 0, "holds": True} in goal


small = st.fractions(min_value=-2, max_value=2, max_denominator=8)


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(st.integers(2, 4), st.integers(0, 3), st.lists(small, min_size=1, max_size=4), st.integers(-5, 5))
def test_random_masks_get_a_certificate_that_verifies(arity, order, cofactor, start):
    """`check` raises where the independent checker says no: any mask will do, converging or not."""
    coefficients = cofactor if any(cofactor) else [Fraction(1)]
    for _ in range(order):
        padded = [Fraction(0)] * (arity - 1)
        window = [*padded, *coefficients, *padded]
        coefficients = [sum(window[i : i + arity]) for i in range(len(window) - arity + 1)]
    total = sum(coefficients)
    if total:
        coefficients = [c * arity / total for c in coefficients]
    result, document = checked(scheme(coefficients, start=start, arity=arity), work=2000)
    assert document is not None
    assert all(finding.claims for finding in result.findings if finding.verdict in DECIDED)


def test_a_certificate_of_another_mask_is_no_proof():
    _, document = checked(four_point("1/16"))
    _, other = checked(four_point("1/8"))
    assert not check_document({**document, "mask": other["mask"]}).verified


def test_reports_name_the_file(tmp_path):
    (result,) = check_all([str(ROOT / "masks" / "scalar" / "four_point.toml")], certificates=str(tmp_path / "proofs"))
    assert result.certificate == str(tmp_path / "proofs" / "four_point.json")
    assert check_text(Path(result.certificate).read_text(encoding="utf-8")).verified


def test_masks_of_one_name_have_certificates_of_their_own(tmp_path):
    for directory, mask in (("a", "[1, 2, 1]/2"), ("b", "[1, 3, 3, 1]/4")):
        (tmp_path / directory).mkdir()
        body = f'[mask]\nsymbol = "{"(1+z)^2/2" if mask.startswith("[1, 2") else "(1+z)^3/4"}"\n'
        (tmp_path / directory / "mask.toml").write_text(body, encoding="utf-8")
    results = list(check_all([str(tmp_path)], certificates=str(tmp_path / "proofs")))
    assert [Path(result.certificate).name for result in results] == ["mask.json", "mask-2.json"]


@pytest.mark.parametrize("mask", [four_point("1/10"), six_point("1/64"), corner_cutting("2/3", "1/3")])
def test_a_higher_effort_still_fits_the_checker(mask):
    _, document = checked(mask, work=60_000)
    assert document is not None
    assert sum(claim["work"] for claim in document["claims"]) <= 250_000_000


@pytest.mark.parametrize("file", [file for file in MASKS if "scalar" in file.parts], ids=lambda file: file.stem)
def test_what_show_says_of_a_shipped_mask_is_certified_too(file):
    (result, document), _ = show(read_path(file).scheme(), Fraction(1, 1000), Effort(20_000))
    assert document is not None
    jsonschema.validate(document, SCHEMA)
    for finding in result.findings:
        assert bool(finding.claims) is (finding.verdict in DECIDED), finding.code
