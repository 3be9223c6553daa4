"""The shipped catalog against the pipeline: every expectation of every mask is proved, and two runs say the same."""

import json
from pathlib import Path

from support import shipped_results, subdiv

from subdiv_cli.catalog import masks_directory

MASKS = Path(__file__).parents[2] / "masks"


def test_every_expectation_is_proved():
    results = shipped_results()
    assert [result.file for result in results if result.status != "passed"] == []
    assert len(results) >= 60
    assert masks_directory() == MASKS


def test_the_json_report_is_the_same_bytes_twice():
    first, second = (subdiv("check", MASKS / "scalar", "--format", "json").stdout for _ in "ab")
    assert first == second
    summary = json.loads(first)["summary"]
    assert summary["passed"] == summary["files"] >= 60
