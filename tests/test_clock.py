"""A clock that strikes anywhere: what is decided by then is kept and certified, and nothing else is said.

The clock of these tests goes on by one at every look, so that each look is a place where it may strike.
"""

from __future__ import annotations

import json
from fractions import Fraction
from types import SimpleNamespace

import pytest
from support import b_spline, four_point, scheme, shipped_multivariate, six_point

from subdiv_cli import model
from subdiv_cli.catalog import masks_directory
from subdiv_cli.catalog.run import check_all
from subdiv_cli.checker import check_document
from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.model import DECIDED, ClockStruckError, Effort, Verdict
from subdiv_cli.model.findings import OUT_OF_TIME
from subdiv_cli.pipeline import check, joint_spectral_radius

BOX = 'kind = "multivariate"\n[mask]\nbox_spline = {{directions = [[1,0],[0,1],[1,1]], multiplicities = [{0},{0},{0}]}}'


def box_spline(times):
    return read_text(BOX.format(times), file="box.toml").scheme({})


def vector(name):
    return read_path(masks_directory() / "vector" / f"{name}.toml").scheme({})


def curve(name, **parameters):
    file = read_path(masks_directory() / "matrices" / f"{name}.toml")
    return file.scheme({key: Fraction(value) for key, value in parameters.items()})


MASKS = {
    "chaikin": b_spline(2),
    "four-point": four_point("1/16"),
    "unstable": scheme([1, 2, 2, 2, 1], over=4),
    "divergent": scheme([1, 3, 3, 3], over=5),
    "six-point": six_point("1/70"),
    "box spline": box_spline(3),
    "quincunx": shipped_multivariate("quincunx_interpolatory"),
    "bear": shipped_multivariate("bear"),
    "tensor": shipped_multivariate("tensor_cubic_four_point"),
    "corner cutting": curve("corner_cutting_5_8_1_8"),
    "corners": curve("takagi", a="1/8"),
    "Koch": curve("koch"),
    "double knots": vector("double_knot_cubic"),
    "blocks": vector("six_point_in_threes"),
    "two schemes": vector("two_four_points"),
}


@pytest.fixture
def clock(monkeypatch):
    """The number of looks at the clock so far, in `looks`."""
    ticking = SimpleNamespace(looks=0)

    def monotonic():
        ticking.looks += 1
        return float(ticking.looks)

    monkeypatch.setattr(model, "time", SimpleNamespace(monotonic=monotonic))
    return ticking


def looks(mask, clock):
    """How often an analysis looks at the clock, where that does not strike."""
    clock.looks = 0
    assert check(mask, (), Effort(seconds=1e9)).result.stopped is None
    return clock.looks


def verdicts(result):
    """The verdicts of the questions that are decided once, and the numbers that are exact."""
    answers = {"convergent": result.convergent, "stable": result.stable, "independent": result.linearly_independent}
    answers["well defined"] = result.well_defined
    found = {key: value for key, value in answers.items() if value in DECIDED}
    numbers = {"sum rules": result.sum_rule_order, "generation": result.generation, "reproduction": result.reproduction}
    numbers["polynomials"] = result.polynomials
    return found | {key: value for key, value in numbers.items() if value is not None}


@pytest.mark.parametrize("name", MASKS)
def test_wherever_it_strikes_nothing_else_is_decided(name, clock):
    mask, kept = MASKS[name], set()
    whole, count = check(mask, (), Effort()).result, looks(MASKS[name], clock)
    for share in (0.02, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.1, 1.3, 1.6, 2):
        checked = check(mask, (), Effort(seconds=share * count))
        result = checked.result
        assert verdicts(result).items() <= verdicts(whole).items()
        assert (result.smoothness.order or -1) <= (whole.smoothness.order or -1)
        assert not result.smoothness.sharp or result.smoothness == whole.smoothness
        if result.holder and result.holder.upper is not None and whole.holder.lower is not None:
            assert result.holder.upper >= whole.holder.lower
        if checked.document is None:
            assert not any(finding.verdict in DECIDED for finding in result.findings)
        else:
            assert check_document(json.loads(checked.certificate_text())).verified
            assert all(finding.claims for finding in result.findings if finding.verdict in DECIDED)
        kept.add(len(verdicts(result)))
    assert len(kept) > 1, "it never struck in the middle"


def test_it_is_said_that_it_struck(clock):
    checked = check(box_spline(3), (), Effort(seconds=0.5 * looks(box_spline(3), clock)))
    assert checked.result.stopped == "budget"
    assert "the time budget ended" in {finding.reason for finding in checked.result.findings}
    assert checked.result.status == "undecided"


def test_what_is_not_checked_in_time_is_undecided(monkeypatch):
    """The stages have all the time, and the checker has it for the first few claims: those that say most."""
    whole = check(box_spline(3), (), Effort(seconds=1000)).result
    asked = iter([True] * 4)
    monkeypatch.setattr(Effort, "time_to_check", lambda self: lambda: next(asked, False))
    checked = check(box_spline(3), (), Effort(seconds=1000))
    assert whole.stopped is None
    assert checked.result.stopped == "budget"
    late = {finding.name for finding in checked.result.findings if finding.reason == OUT_OF_TIME}
    assert late
    assert checked.result.convergent is whole.convergent is Verdict.PROVED
    assert late <= {finding.name for finding in whole.findings if finding.verdict in DECIDED}
    assert len(checked.document["claims"]) == 4
    assert check_document(json.loads(checked.certificate_text())).verified


def test_the_checker_stops_at_the_claim_that_there_is_no_time_for():
    document = check(b_spline(2), (), Effort()).document
    asked = iter([True, True, False])
    outcome = check_document(document, lambda: next(asked))
    assert (outcome.verified, outcome.exhausted, outcome.claim) == (False, True, 2)
    assert outcome.line.startswith("NOT VERIFIED claim 2: there is no time left")


def test_a_radius_that_time_ends_for_has_a_bound(clock):
    """From nothing but a look at the columns to the radius itself, 2: each is verified."""
    matrices = [[[2, 1], [0, -2]], [[2, 0], [-1, -2]]]
    uppers = []
    for seconds in (3, 100, 1000, 10_000):
        clock.looks = 0
        found = joint_spectral_radius(matrices, Effort(500, seconds))
        assert check_document(found.document).verified
        assert found.radius.lower <= 2 <= found.radius.upper
        uppers.append(found.radius.upper)
        assert found.radius.stopped == "budget" or seconds > 1000
    assert uppers[0] > uppers[-1]


def test_part_of_an_effort_has_its_share_of_the_time(clock):
    whole = Effort(seconds=1000)
    part = whole.limited(10, 0.5)
    while part.allows(0):
        pass
    assert whole.struck
    assert whole.allows(0)
    with pytest.raises(ClockStruckError):
        part.look()
    assert whole.in_time(lambda: 1) == 1
    assert whole.in_time(part.look) is None


@pytest.mark.parametrize("times", [14, 21])
def test_box_splines_are_decided_by_their_directions_at_any_multiplicity(times):
    result = check(box_spline(times), (), Effort()).result
    assert result.convergent is Verdict.PROVED
    assert (result.smoothness.order, result.smoothness.sharp) == (2 * times - 2, True)
    assert (result.holder.exact, result.sobolev.exact) == (2 * times - 1, Fraction(4 * times - 1, 2))
    assert (result.stable, result.sum_rule_order) == (Verdict.PROVED, 2 * times)


def test_a_budget_that_is_enough_changes_nothing(tmp_path):
    file = tmp_path / "box.toml"
    file.write_text(BOX.format(2))
    (whole,), (stopped,) = (list(check_all([str(file)], seconds=seconds)) for seconds in (None, 1000))
    assert verdicts(whole) == verdicts(stopped)
    assert stopped.stopped is None
