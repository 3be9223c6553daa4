"""FORMAT.md of kind matrices: every rule has a section, the example verifies, and what is worked by hand is so."""

import json
import re
from fractions import Fraction
from pathlib import Path

import jsonschema

from subdiv_cli.checker import KINDS, check_document
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS

FOLDER = Path(__file__).parents[2] / "subdiv_cli"
TEXT = (FOLDER / "kinds" / "matrices" / "FORMAT.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^### ([\w-]+)\n(.*?)(?=^##|\Z)", TEXT, re.MULTILINE | re.DOTALL))


def test_every_rule_and_property_is_specified():
    book = KINDS["matrices"]
    assert set(SECTIONS) == set(book.rules) - set(RADIUS.rules)
    table = TEXT[TEXT.index("## Statements") : TEXT.index("## What all rests on")]
    named = set(re.findall(r"`([\w-]+)`(?=[^|]*\|)", table.replace("| `", "\n| `")))
    assert named >= set(book.properties) - (set(RADIUS.properties) - {"family"})
    for name, section in SECTIONS.items():
        assert "Statement" in section, name
        assert "Uses" in section or "Uses nothing" in section, name


def test_the_example_verifies():
    (block,) = re.findall(r"```json\n(.*?)```", TEXT, re.DOTALL)
    made = json.loads(block)
    outcome = check_document(made)
    assert outcome.verified, outcome.line
    jsonschema.validate(made, json.loads((FOLDER / "certificate" / "schema.json").read_text(encoding="utf-8")))
    a = [[[Fraction(x) for x in row] for row in m] for m in made["mask"]["matrices"]]

    def image(letter, v):
        return [sum(row[i] * x for row, x in zip(a[letter], v, strict=True)) for i in range(3)]

    left, right = [1, 0, 0], [0, 0, 1]
    assert image(1, left) == image(0, right) == [0, 1, 0]
    quarter, three = image(0, image(1, left)), image(1, image(1, left))
    points = (left, quarter, [0, 1, 0], three)
    assert [sum(w * x[i] for w, x in zip((-3, 7, -5, 1), points, strict=True)) for i in range(3)] == [0, 0, 0]
    r, l = [Fraction(-7, 3), Fraction(8, 3), Fraction(-1, 3)], [Fraction(1, 3), Fraction(-8, 3), Fraction(7, 3)]
    assert image(0, r) == [x / 2 for x in r]
    assert [6 * x for x in image(1, r)] == [-1, -4, 5]
    assert [6 * x for x in image(0, l)] == [-5, 4, 1]
    for said in ("(-1/6, -2/3, 5/6)", "(-5/6, 2/3, 1/6)", "(7/16, 5/8, -1/16)", "(1, -2, 1)"):
        assert said in TEXT


def test_the_files_know_of_each_other():
    for name in ("FORMAT.md", "RADIUS.md"):
        assert "kinds/matrices/FORMAT.md" in (FOLDER / "certificate" / name).read_text(encoding="utf-8")
        assert f"({'../../certificate/' + name})" in TEXT
