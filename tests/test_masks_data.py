"""The catalog as data, read with tomllib and a few lines of arithmetic: nothing of the package decides here."""

import json
import re
import tomllib
from fractions import Fraction
from pathlib import Path

import pytest

HERE = Path(__file__).parent
MASKS = HERE.parent / "masks" / "scalar"
FILES = sorted(MASKS.rglob("*.toml"))
ROWS = json.loads((HERE / "data" / "reference_scalar.json").read_text(encoding="utf-8"))

KEYS = {"format", "name", "reference", "kind", "parameters", "mask", "expect"}
EXPECTED = {"convergent", "smoothness", "holder", "sobolev", "generation", "reproduction", "stable"}


def load(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


def terms(text):
    """The signed terms of a sum of products, as the catalog writes coefficients: `-1/16 - 3*theta`."""
    for sign, term in re.findall(r"([+-]?)([^+-]+)", text.replace(" ", "")):
        yield (-1 if sign == "-" else 1), term


def value(text, parameters):
    """A coefficient of the catalog: sums of products and quotients of numbers and parameters."""
    total = Fraction(0)
    for sign, term in terms(str(text)):
        product = Fraction(sign)
        for operator, factor in re.findall(r"([*/]?)([^*/]+)", term):
            number = Fraction(parameters.get(factor, factor))
            product = product / number if operator == "/" else product * number
        total += product
    return total


def canonical(coefficients):
    """Up to a shift: zeros at the ends dropped."""
    support = [i for i, c in enumerate(coefficients) if c]
    return tuple(coefficients[support[0] : support[-1] + 1])


def listed_masks():
    """(arity, coefficients) -> expectations, for every file that lists coefficients."""
    masks = {}
    for path in FILES:
        document = load(path)
        mask, parameters = document["mask"], document.get("parameters", {})
        if "coefficients" in mask:
            found = canonical([value(c, parameters) for c in mask["coefficients"]])
            masks.setdefault((mask.get("arity", 2), found), []).append(document["expect"])
    return masks


LISTED = listed_masks()


def test_there_are_enough_masks():
    assert len(list(MASKS.glob("*.toml"))) >= 55
    assert len(list((MASKS / "counterexamples").glob("*.toml"))) >= 10


def test_file_names_are_unique_and_snake_case():
    names = [path.stem for path in FILES]
    assert len(names) == len(set(names))
    assert all(re.fullmatch(r"[a-z0-9]+(_[a-z0-9]+)*", name) for name in names)


def test_mask_names_are_unique():
    names = [load(path)["name"] for path in FILES]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_what_every_file_says(path):
    document = load(path)
    assert path.read_text(encoding="utf-8").startswith("# ")
    assert document.keys() <= KEYS
    assert document["format"] == 1
    assert document["name"].strip()
    assert document["reference"].strip()
    assert document.get("kind", "scalar") == "scalar"
    mask, expect = document["mask"], document["expect"]
    assert ("symbol" in mask) != ("coefficients" in mask)
    assert ("start" in mask) == ("coefficients" in mask)
    assert not any(isinstance(c, float) for c in mask.get("coefficients", []))
    assert all(isinstance(v, str) for v in document.get("parameters", {}).values())
    assert expect.keys() <= EXPECTED
    assert isinstance(expect["convergent"], bool)
    assert ("smoothness" in expect) is expect["convergent"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_residue_sums_agree_with_the_expectation(path):
    """Convergence needs them to be 1; the one condition that these few lines can decide."""
    document = load(path)
    mask, parameters = document["mask"], document.get("parameters", {})
    if "coefficients" not in mask:
        pytest.skip("given by a symbol")
    coefficients = [value(c, parameters) for c in mask["coefficients"]]
    arity = mask.get("arity", 2)
    if any(sum(coefficients[gamma::arity]) != 1 for gamma in range(arity)):
        assert document["expect"]["convergent"] is False
        assert "generation" not in document["expect"]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_reference_row_is_in_the_catalog(row):
    """The same coefficients up to a shift, and no expectation that contradicts the reference value."""
    mask = canonical([Fraction(c) for c in row["coefficients"]])
    assert (row["arity"], mask) in LISTED
    truth = row["truth"]
    for expect in LISTED[row["arity"], mask]:
        assert expect["convergent"] is truth["converges"]
        assert expect.get("stable", truth["stable"]) is truth["stable"]
        assert expect.get("generation", truth["generation"]) == truth["generation"]
        assert expect.get("reproduction", truth["reproduction"]) == truth["reproduction"]
        smoothness = expect.get("smoothness")
        if isinstance(smoothness, str):
            assert int(smoothness.removeprefix(">= ")) <= truth["smoothness"]
        else:
            assert smoothness == truth["smoothness"]
