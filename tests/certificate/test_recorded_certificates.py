"""Certificates as earlier versions wrote them: each verifies, with the line that was printed then."""

from pathlib import Path

import pytest

from subdiv_cli.checker import check_file

FOLDER = Path(__file__).parents[1] / "data" / "certificates"
LINES = dict(line.split(": ", 1) for line in (FOLDER / "lines.txt").read_text(encoding="utf-8").splitlines())


@pytest.mark.parametrize("name", LINES)
def test_a_recorded_certificate_verifies_with_the_same_line(name):
    outcome, _ = check_file(str(FOLDER / f"{name}.json"))
    assert outcome.line == LINES[name]
    assert outcome.verified


def test_every_recorded_certificate_has_its_line():
    assert sorted(LINES) == sorted(file.stem for file in FOLDER.glob("*.json"))
