"""Certificates with claims left out: what remains is verified, and what is not certified is not claimed."""

from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from subdiv_cli.certificate import claims as written
from subdiv_cli.checker import check_document, check_file, core
from subdiv_cli.cli import main
from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import DECIDED, Effort, Verdict
from subdiv_cli.model.findings import TOO_DEAR, UNCERTIFIED
from subdiv_cli.pipeline import certified, check, show

MASKS = Path(__file__).parents[2] / "masks"
FILES = (
    "scalar/four_point.toml",
    "scalar/counterexamples/circle_zeros.toml",
    "scalar/counterexamples/chaikin_in_z3.toml",
    "scalar/counterexamples/zero_ends.toml",
    "scalar/counterexamples/four_point_1_2.toml",
    "multivariate/butterfly.toml",
    "multivariate/loop.toml",
    "multivariate/tensor_four_point.toml",
    "multivariate/quincunx_interpolatory.toml",
)


@cache
def analysed(file):
    """The kind of a mask, its analysis, and what is found where nothing is too dear."""
    scheme = read_path(MASKS / file).scheme({})
    kind = kind_of(scheme)
    analysis = kind.analyse(scheme, Effort())
    return kind, analysis, certified(kind, analysis, (), Effort()).result


@pytest.mark.parametrize("file", FILES)
def test_any_claim_can_be_left_out(file):
    kind, analysis, _ = analysed(file)
    proofs = kind.proofs(analysis)
    whole = proofs.certificate()
    assert check_document(whole.document).verified
    for claim in whole.made:
        part = proofs.certificate(frozenset({claim}))
        if part is None:
            continue
        outcome = check_document(part.document)
        assert outcome.verified, (claim, outcome.line)
        assert claim not in part.made
        each = zip(proofs.findings, whole.claims, part.findings, part.claims, strict=True)
        for finding, before, chosen, after in each:
            if chosen is not finding:
                assert any(chosen is other for other in finding.otherwise)
                assert after
                continue
            full = [whole.document["claims"][number]["statement"]["property"] for number in before]
            assert not after or full == [part.document["claims"][number]["statement"]["property"] for number in after]
            assert bool(before) or not after, finding.code


@pytest.mark.parametrize("work", [10, 100, 1_000, 10_000, 100_000])
@pytest.mark.parametrize("file", FILES)
def test_what_is_too_dear_is_undecided_or_follows_by_another_route(file, work, monkeypatch):
    kind, analysis, full = analysed(file)
    monkeypatch.setattr(written, "MOST_WORK", work)
    checked = certified(kind, analysis, (), Effort())
    for finding, before, whole in zip(checked.result.findings, full.findings, analysis.findings, strict=True):
        if finding.verdict in DECIDED:
            assert finding.claims
            routes = [(before.verdict, before.statement), *((each.verdict, each.statement) for each in whole.otherwise)]
            assert (finding.verdict, finding.statement) in routes
        elif before.verdict in DECIDED:
            assert finding.reason in UNCERTIFIED
            assert (finding.value, finding.claims) == (None, ())
    if checked.document is not None:
        assert sum(claim["work"] for claim in checked.document["claims"]) <= work
        assert check_document(checked.document).verified
    result = checked.result
    assert result.convergent in (full.convergent, Verdict.UNDECIDED)
    for smooth, whole in ((result.smoothness, full.smoothness), (result.refinable, full.refinable)):
        assert smooth.order is None or smooth.order <= whole.order
        assert smooth == whole or not smooth.sharp or smooth.order == whole.order
    assert result.holder is None or result.holder.exact in (None, full.holder.exact)


def test_convergence_comes_first(monkeypatch):
    scheme = from_option("[1, 3, 3, 1]/4").scheme({})
    monkeypatch.setattr(written, "MOST_WORK", 60)
    result = check(scheme, (), Effort()).result
    assert result.convergent is Verdict.PROVED
    assert any(finding.reason == TOO_DEAR for finding in result.findings)


@pytest.mark.parametrize(
    "mask",
    [
        "(1+z)^3*(1-z^31)^3/(1-z)^3/(4*29791)",
        "(1+z^190)^2/2",
        "(1+z)^165/2^164",
        "(1+z+z^2)^120/3^119",
        "(1+z^3)^164/2^163",
    ],
)
def test_long_masks_are_certified_in_full(mask):
    arity = 3 if "z^2)^120" in mask else 2
    result = check(from_option(mask, arity=arity).scheme({}), (), Effort()).result
    assert all(finding.claims for finding in result.findings if finding.verdict in DECIDED)
    assert not any(finding.reason in UNCERTIFIED for finding in result.findings)


def test_a_bound_of_its_own(tmp_path, capsys, monkeypatch):
    with pytest.raises(SystemExit) as ended:
        main(["check", str(MASKS / "scalar" / "four_point.toml"), "-q", "--no-cache", "--certificate", str(tmp_path)])
    assert ended.value.code == 0
    proof = str(tmp_path / "four_point.json")
    outcome, _ = check_file(proof, 100)
    assert outcome.exhausted
    assert "more than 100 of work" in outcome.line
    for work, code in (("100", 1), ("250000000", 0)):
        with pytest.raises(SystemExit) as ended:
            main(["verify", proof, "--work", work])
        assert ended.value.code == code
    monkeypatch.setattr(core, "MAX_WORK", 100)
    with pytest.raises(SystemExit) as ended:
        main(["verify", proof])
    assert ended.value.code == 1
    assert "more than 100 of work" in capsys.readouterr().out


def test_a_certificate_that_leaves_something_out_is_no_success(tmp_path, capsys, monkeypatch):
    file = str(MASKS / "scalar" / "four_point.toml")
    monkeypatch.setattr(written, "MOST_WORK", 500)
    for more, code in (((), 3), (("--allow-undecided",), 0)):
        with pytest.raises(SystemExit) as ended:
            main(["check", file, "-q", "--no-cache", "--jobs", "1", "--certificate", str(tmp_path), *more])
        assert ended.value.code == code
        told = capsys.readouterr().err
        assert f"warning: {tmp_path / 'four_point.json'} leaves out SD" in told
        assert TOO_DEAR in told
    assert check_file(str(tmp_path / "four_point.json"))[0].verified


def test_no_certificate_is_said(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(written, "MOST_WORK", 0)
    with pytest.raises(SystemExit) as ended:
        main(["check", str(MASKS / "scalar" / "four_point.toml"), "-q", "--no-cache", "--certificate", str(tmp_path)])
    assert ended.value.code == 3
    assert "there is no certificate of" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("work", [0, 60, 500, 5_000])
def test_show_prints_nothing_of_what_is_left_out(work, monkeypatch):
    monkeypatch.setattr(written, "MOST_WORK", work)
    scheme = read_path(MASKS / "scalar" / "four_point.toml").scheme({})
    checked, portrait = show(scheme, Fraction(1, 1000), Effort())
    left = {finding.code for finding in checked.result.findings if finding.reason in UNCERTIFIED}
    keys = {"SD501": "values", "SD502": "stencils", "SD503": "quasi_interpolation", "SD511": "error_bound"}
    assert left
    for code, key in keys.items():
        assert code not in left or not portrait.data[key], key
