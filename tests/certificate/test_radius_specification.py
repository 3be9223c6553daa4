"""The examples in RADIUS.md verify, and every rule on radii has a section there and is in one of them."""

import json
import re
from pathlib import Path

import jsonschema
import pytest

from subdiv_cli.checker import KINDS, check_document
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS

FOLDER = Path(__file__).parents[2] / "subdiv_cli" / "certificate"
TEXT = (FOLDER / "RADIUS.md").read_text(encoding="utf-8")
FORMAT = (FOLDER / "FORMAT.md").read_text(encoding="utf-8")
SCALAR_RULES = (FOLDER.parent / "kinds" / "scalar" / "FORMAT.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^### ([\w-]+)\n(.*?)(?=^##|\Z)", TEXT, re.MULTILINE | re.DOTALL))
EXAMPLES = {
    f"{name}-{i}": json.loads(block)
    for name, section in SECTIONS.items()
    for i, block in enumerate(re.findall(r"```json\n(.*?)```", section, re.DOTALL))
}


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_example_verifies(name):
    outcome = check_document(EXAMPLES[name])
    assert outcome.verified, outcome.line
    assert any(claim["rule"] == name.rpartition("-")[0] for claim in EXAMPLES[name]["claims"])
    jsonschema.validate(EXAMPLES[name], json.loads((FOLDER / "schema.json").read_text(encoding="utf-8")))


def test_no_example_is_left_out():
    assert TEXT.count("```json") == len(EXAMPLES) == TEXT.count("```") // 2


def test_every_rule_is_specified_here_or_in_format():
    elsewhere = set(re.findall(r"^### ([\w-]+)$", SCALAR_RULES, re.MULTILINE))
    assert set(SECTIONS) | elsewhere == set(KINDS["scalar"].rules)
    assert not set(SECTIONS) & elsewhere
    assert set(SECTIONS) >= set(RADIUS.rules)


def test_every_rule_has_its_parts_and_is_in_an_example():
    shown = {claim["rule"] for example in EXAMPLES.values() for claim in example["claims"]}
    assert shown >= set(SECTIONS)
    for name, section in SECTIONS.items():
        for part in ("**Statement**", "**Example**", "**Work**"):
            assert part in section, (name, part)


def test_the_two_files_know_of_each_other():
    assert "[RADIUS.md](RADIUS.md)" in FORMAT
    assert "[FORMAT.md](FORMAT.md)" in TEXT


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_stated_work_is_needed(name):
    """What a claim by a rule of RADIUS.md counts is what the file says: half of it is too little, or it is small."""
    for number, claim in enumerate(EXAMPLES[name]["claims"]):
        if claim["work"] > 20 and claim["rule"] in SECTIONS:
            less = json.loads(json.dumps(EXAMPLES[name]))
            less["claims"][number]["work"] //= 2
            outcome = check_document(less)
            assert outcome.claim == number
            assert "more work than stated" in outcome.line
