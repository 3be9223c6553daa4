"""The statistics: how many masks did not pass for which reason, as a table and as JSON."""

import json
from dataclasses import replace

import report_samples as samples

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.report.look import Look
from subdiv_cli.report.statistics import as_json, as_text

WORSE = replace(samples.FOUR_POINT, status="failed", regressions=(faults.BASELINE.problem("C^1 was proved"),))
MANY = [*samples.ALL, samples.DIVERGENT, samples.DIVERGENT, WORSE]


def counted(results, **look):
    report = json.loads(as_json(results, Look(**look)))
    assert (report["format"], report["version"]) == ("subdiv-statistics", 1)
    keys = ("masks", "code", "property", "verdict", "reason")
    assert all(tuple(row) == keys for row in report["statistics"])
    return [tuple(row.values())[:4] for row in report["statistics"]]


def test_masks_are_counted_by_reason_the_most_frequent_first():
    assert counted(MANY) == [
        (3, "expect-convergent", "convergent", "refuted"),
        (3, "expect-holder", "holder", "undecided"),
        (1, "SD003", "", "invalid"),
        (1, "SD005", "", "invalid"),
        (1, faults.BASELINE.code, "baseline", "worse"),
        (1, "expect-smoothness", "smoothness", "undecided"),
    ]


def test_a_mask_is_counted_once_and_what_is_allowed_not_at_all():
    twice = replace(samples.DIVERGENT, expectations=samples.DIVERGENT.expectations * 2)
    assert counted([twice], allow_undecided=True) == [(1, "expect-convergent", "convergent", "refuted")]


def test_the_reason_of_an_undecided_finding():
    reasons = [row["reason"] for row in json.loads(as_json([samples.UNDECIDED], Look()))["statistics"]]
    said = {found.reason for found in samples.UNDECIDED.findings} | {""}
    assert set(reasons) <= said


def test_text():
    rows = as_text(MANY, Look()).splitlines()
    assert rows[0].split() == ["masks", "code", "property", "verdict", "reason"]
    assert rows[2].split() == ["3", "expect-convergent", "convergent", "refuted"]
    assert rows[-1] == "7 masks: 1 passed, 4 failed, 1 undecided, 1 invalid"
    assert as_text([samples.FOUR_POINT], Look()) == "1 mask: 1 passed\n"
