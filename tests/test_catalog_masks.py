"""The shipped catalog against the pipeline: every expectation of every mask is proved, and two runs say the same."""

import json
import subprocess
import sys
from pathlib import Path

from subdiv_cli.catalog import masks_directory
from subdiv_cli.catalog.run import check_all

MASKS = Path(__file__).parents[1] / "masks"


def test_every_expectation_is_proved():
    results = list(check_all([str(MASKS)]))
    assert [result.file for result in results if result.status != "passed"] == []
    assert len(results) >= 60
    assert masks_directory() == MASKS


def test_the_json_report_is_the_same_bytes_twice():
    def report():
        command = [sys.executable, "-m", "subdiv_cli", "check", str(MASKS / "scalar"), "--format", "json"]
        return subprocess.run(command, capture_output=True, check=True).stdout

    first = report()
    assert first == report()
    summary = json.loads(first)["summary"]
    assert summary["passed"] == summary["files"] >= 60
