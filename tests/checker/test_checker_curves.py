"""Certificates of curves that matrices refine: true ones are verified, each rule rejects its forgeries by name, and no
number can be changed so that something false is verified."""

from __future__ import annotations

import copy
import json
import math
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import jsonschema
import numpy as np
import pytest
from hand_made import numbers
from hand_made_curves import ALL_CURVES, MATRICES, claim
from hypothesis import given, settings
from hypothesis import strategies as st
from test_checker_multivariate import rejected, said, witness
from test_checker_multivariate_mutations import CHANGES, JUNK, places

import subdiv_cli
from subdiv_cli.checker import KINDS, check_document, check_text
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS

OWN_RULES = set(KINDS["matrices"].rules) - set(RADIUS.rules)
MADE = {name: make() for name, make in ALL_CURVES.items()}
"""Made once and never changed."""
SCHEMA = json.loads((Path(subdiv_cli.__file__).parent / "certificate" / "schema.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", ALL_CURVES)
def test_true_certificates_are_verified(name):
    outcome = check_text(json.dumps(MADE[name]))
    assert outcome.verified, outcome.line
    jsonschema.validate(MADE[name], SCHEMA)


def test_every_rule_is_there():
    assert {c["rule"] for made in MADE.values() for c in made["claims"]} >= OWN_RULES


def test_the_line_reads_well():
    made = copy.deepcopy(MADE["takagi_1_8"])
    made["goal"] = [s for s in made["goal"] if s["property"] not in ("bounded", "radius")]
    assert check_document(made).line == (
        "VERIFIED all polygons converge; the pieces meet in one curve; "
        "3 components, polynomials of degree 1 among them; "
        "derivatives of order 1 do not fit at the joints; the curve is C^0; the curve is not C^1; alpha = 1"
    )
    made = copy.deepcopy(MADE["de_rham"])
    made["goal"] = made["goal"][-1:]
    assert check_document(made).line.startswith("VERIFIED alpha = -log2(the root of 9x^2 - 3x - 1 in [")
    made = copy.deepcopy(MADE["corner_cutting"])
    made["goal"] = made["goal"][-4:]
    line = "VERIFIED alpha = -log2(3/8); alpha >= -log2(3/8); alpha <= -log2(1/4); the curve is not C^2"
    assert check_document(made).line == line


def number(name, rule, **fields):
    """The number of a claim by this rule."""
    claims = enumerate(MADE[name]["claims"])
    return next(i for i, c in claims if c["rule"] == rule and fields.items() <= c["statement"].items())


def uses(place, other):
    """The claim in this place of those used becomes the first one by another rule."""

    def change(c, name):
        c["uses"][place] = number(name, other)

    return change


FORGED = [
    ("lebesgue", "contracts", said("holds", False), "does not prove such statements"),
    ("cycle", "expands", said("holds", True), "does not prove such statements"),
    ("takagi_1_8", "contracts", uses(0, "monotone-closing"), "another family"),
    ("takagi_1_8", "contracts", uses(1, "annihilators"), "does not come before it"),
    ("lebesgue", "consecutive-columns", said("length", 2), "the length is not 1"),
    ("constant", "positive-columns", said("length", 1), "has no positive column"),
    ("constant", "positive-columns", witness("steps", 1), "more patterns than stated"),
    ("constant", "positive-columns", witness("steps", 10**7), "too many patterns"),
    ("casteljau", "columns-converge", uses(0, "meets"), "uses well-defined"),
    ("lebesgue", "meets", said("holds", False), "the joints say otherwise"),
    ("cantor", "meets", said("holds", True), "the joints say otherwise"),
    ("lebesgue", "meets", witness("left", ["0", "1"]), "a vector is not fixed"),
    ("lebesgue", "meets", witness("right", ["0", "2"]), "do not sum to 1"),
    ("lebesgue", "meets", witness("left", ["1"]), "of another order"),
    ("takagi", "components", said("dimension", 2), "not as many as the dimension"),
    ("takagi", "components", said("degree", 2), "not d + 1"),
    ("degenerate", "components", witness("annihilator", []), "not the complementary dimension"),
    ("degenerate", "components", witness("annihilator", 0, ["1", "-1", "0"]), "the span is not invariant"),
    ("takagi", "components", witness("words", 1, []), "depends on those before it"),
    ("takagi", "components", witness("words", 1, [2]), "a letter is not there"),
    ("takagi", "components", witness("words", 1, [0] * 121), "a word or a level is too long"),
    ("takagi", "components", witness("polygons", 0, ["2", "2", "2"]), "the first polygon is not constant"),
    ("takagi", "components", witness("polygons", 1, ["0", "1/2", "2"]), "polygon 1 does not give x^1"),
    ("takagi", "components", witness("polygons", 1, ["0", "1/2"]), "of another order"),
    ("takagi", "components", witness("weights", []), "no relation excludes a higher degree"),
    ("takagi", "components", witness("weights", ["1"]), "not as many weights as points"),
    ("takagi", "components", witness("weights", ["1", "0", "0", "0", "0"]), "do not satisfy the relation"),
    ("takagi", "components", witness("weights", ["0"] * 5), "x^2 satisfies the relation"),
    ("takagi", "components", witness("level", 14), "too many points"),
    (
        "takagi",
        "annihilators",
        witness("basis", [["1", "-2", "1"], ["1", "0", "0"]]),
        "of another order than the basis",
    ),
    ("takagi", "annihilators", witness("basis", 0, ["1", "-2"]), "a vector is of another order"),
    ("takagi", "annihilators", witness("basis", 0, ["1", "-1", "0"]), "not in the space"),
    ("takagi", "annihilators", witness("basis", 0, ["0", "0", "0"]), "depends on those before it"),
    ("takagi", "annihilators", witness("matrices", 0, [["1/4"]]), "does not give the image"),
    ("takagi_1_8", "derivative", said("holds", True), "the joints say otherwise"),
    ("corner_cutting", "derivative", said("holds", False), "the joints say otherwise"),
    ("takagi_1_8", "derivative", said("order", 2), "no polynomial component"),
    ("smooth_takagi", "derivative", said("order", 2), "a vector is no eigenvector"),
    ("takagi_1_8", "derivative", witness("left", ["-7/3", "8/3", "1/3"]), "a vector is no eigenvector"),
    ("takagi_1_8", "derivative", witness("left", ["-14/3", "16/3", "-2/3"]), "a vector is no derivative"),
    ("takagi_1_8", "derivative", witness("right", ["0", "0", "0"]), "a vector is no derivative"),
    ("takagi_1_8", "derivative", witness("right", ["0", "0"]), "of another order"),
    ("takagi_1_8", "derivative", uses(1, "radius-of-blocks"), "with another family"),
    ("cantor", "meets", uses(0, "differences"), "uses family"),
    ("lebesgue", "continuous", said("order", 1), "does not prove such statements"),
    ("casteljau", "polynomial-curve", said("degree", 1), "with another degree"),
    ("corner_cutting", "smooth", said("order", 2), "the radius is not small enough"),
    ("corner_cutting", "not-smooth", said("order", 1), "the radius is not large enough"),
    ("takagi_1_8", "corner", said("order", 0), "are of order 1"),
    ("smooth_takagi", "corner", said("order", 2), "are of order 3"),
    ("corner_cutting", "holder-lower", said("bound", "1/3"), "the radius may be larger"),
    ("corner_cutting", "holder-lower", said("bound", "0"), "not positive"),
    ("corner_cutting", "holder-upper", said("bound", "1/3"), "another length or bound"),
    ("corner_cutting", "holder-root", said("length", 2), "with another length"),
    ("smooth_takagi", "holder-value", said("value", 2), "with another order"),
    ("takagi_1_8", "holder-value", said("value", 0), "with another order"),
]


@pytest.mark.parametrize(("name", "rule", "change", "words"), FORGED)
def test_forged_claims(name, rule, change, words):
    made = copy.deepcopy(MADE[name])
    at = number(name, rule)
    one = made["claims"][at]
    change(one, name) if change.__qualname__.startswith("uses") else change(one)
    if "more work than stated" not in words:
        one["work"] = 10**6
    assert words in check_document(made).line, check_document(made).line
    assert check_document(made).claim == at


def test_a_derivative_that_is_left_out():
    """Smoothness inside the pieces is not enough, nor are some of the orders."""
    for name, rule in (
        ("corner_cutting", "smooth"),
        ("corner_cutting", "holder-lower"),
        ("corner_cutting", "holder-root"),
    ):
        made = copy.deepcopy(MADE[name])
        at = number(name, rule)
        made["claims"][at]["uses"].pop()
        rejected(made, at, "does not use a claim on derivative")
    made = copy.deepcopy(MADE["smooth_takagi"])
    at = number("smooth_takagi", "holder-value")
    made["claims"][at]["uses"].pop()
    rejected(made, at, "does not use a claim on derivative")


def test_a_corner_does_not_fit():
    """The radius inside the pieces alone would say more: the claim that wants it needs derivatives that fit."""
    made = copy.deepcopy(MADE["takagi_1_8"])
    known, family, corner = (number("takagi_1_8", rule) for rule in ("components", "annihilators", "derivative"))
    radius = next(i for i, c in enumerate(made["claims"]) if c["statement"]["property"] == "bounded" and i > family)
    root = {key: made["claims"][radius]["statement"][key] for key in ("length", "polynomial", "low", "high")}
    for rule, statement in (
        ("smooth", {"order": 1}),
        ("holder-root", root),
        ("holder-lower", {"length": 1, "bound": "1/8"}),
    ):
        for used in ([known, radius, family], [known, radius, family, corner]):
            forged = copy.deepcopy(made)
            forged["claims"].append(claim(rule, dict(statement), {}, used, 9))
            rejected(forged, len(made["claims"]), "derivative")
    forged = copy.deepcopy(made)
    forged["claims"].append(claim("holder-lower", {"length": 1, "bound": "1/2"}, {}, [known, radius, family], 9))
    assert check_document(forged).verified


def test_the_radius_of_all_polygons_is_another():
    """It bounds that on V from above, and says nothing from below; only where V is all of e^⊥ they are one."""
    made = copy.deepcopy(MADE["takagi_1_8"])
    known, radius, family = (number("takagi_1_8", rule) for rule in ("components", "radius-of-blocks", "differences"))
    made["claims"].append(claim("not-smooth", {"order": 1}, {}, [known, radius, family]))
    rejected(made, len(made["claims"]) - 1, "the family is that of all polygons")
    assert number("lebesgue", "holder-root")
    assert all(c["rule"] != "annihilators" for c in MADE["lebesgue"]["claims"])


@pytest.mark.parametrize("name", ALL_CURVES)
def test_the_stated_work_is_needed(name):
    for at, one in enumerate(MADE[name]["claims"]):
        if one["rule"] in OWN_RULES:
            made = copy.deepcopy(MADE[name])
            made["claims"][at]["work"] = max(1, one["work"] // 2)
            assert one["work"] <= 2 or "more work than stated" in rejected(made, at).line


def test_matrices_that_refine_no_polygons():
    made = copy.deepcopy(MADE["cycle"])
    made["mask"]["matrices"][0][0] = ["2", "0", "0"]
    rejected(made, number("cycle", "differences"), "does not sum to 1")
    one = {**made["mask"], "matrices": [[["1"]], [["1"]]]}
    statement = {"property": "family", "family": 1, "on": "polygons"}
    document = {**made, "mask": one, "goal": [statement], "claims": [claim("differences", statement, work=9)]}
    rejected(document, 0, "not two matrices of order 2")
    made = copy.deepcopy(MADE["constant"])
    for m in made["mask"]["matrices"]:
        m[0] = ["-1", "1", "1"]
    rejected(made, number("constant", "positive-columns"), "an entry of a matrix is negative")


class Facts(NamedTuple):
    """What is known of a scheme."""

    convergent: bool
    meets: bool = False
    degree: int = 0
    dimension: int = 0
    alpha: float = math.nan
    smooth: float = -1
    fits: int = 0
    """The orders of derivatives that fit; the next one does not, where there is one."""
    columns: int | None = None


TRUTH = {
    "corner_cutting": Facts(True, True, 1, 3, math.log2(8 / 3), 1, 1, 2),
    "de_rham": Facts(True, True, 0, 3, 0.8907205870905388, 0, 0, 2),
    "takagi": Facts(True, True, 1, 3, 1, 0),
    "takagi_1_8": Facts(True, True, 1, 3, 1, 0, 0),
    "lebesgue": Facts(True, True, 0, 2, math.log2(3 / 2), 0, 0, 1),
    "casteljau": Facts(True, True, 2, 3, math.inf, math.inf, 2, 2),
    "smooth_takagi": Facts(True, True, 4, 6, 3, 2, 2),
    "degenerate": Facts(True, True, 0, 2, math.log2(3 / 2), 0, 0, 2),
    "cycle": Facts(False),
    "cantor": Facts(True, columns=1),
    "constant": Facts(True, True, 0, 1, math.inf, math.inf, 0, 2),
}


def is_true(s, name):
    facts = TRUTH[name]

    def exponent():
        return -math.log2(Fraction(s["bound"])) / s["length"]

    def root():
        zeros = np.roots([int(c) for c in s["polynomial"][::-1]])
        low, high = float(Fraction(s["low"])), float(Fraction(s["high"]))
        (zero,) = (z.real for z in zeros if abs(z.imag) < 1e-12 and low - 1e-12 <= z.real <= high + 1e-12)
        return abs(-math.log2(zero) / s["length"] - facts.alpha) < 1e-9

    return {
        "family": lambda: True,
        "convergent": lambda: s["holds"] == facts.convergent,
        "positive-columns": lambda: facts.columns is not None and s["length"] >= facts.columns,
        "well-defined": lambda: s["holds"] == facts.meets,
        "polynomials": lambda: (s["degree"], s["dimension"]) == (facts.degree, facts.dimension),
        "polynomial-curve": lambda: s["degree"] == facts.degree == facts.dimension - 1,
        "derivative": lambda: s["holds"] == (s["order"] <= facts.fits),
        "smooth": lambda: s["order"] <= facts.smooth,
        "not-smooth": lambda: s["order"] > facts.smooth,
        "holder-lower": lambda: exponent() <= facts.alpha + 1e-9,
        "holder-upper": lambda: exponent() >= facts.alpha - 1e-9,
        "holder-root": root,
        "holder-value": lambda: s["value"] == facts.alpha,
    }[s["property"]]()  # fmt: skip


def own(made):
    return [c for c in made["claims"] if c["rule"] in OWN_RULES]


@pytest.mark.parametrize("name", ALL_CURVES)
def test_the_truth_says_that_the_true_certificates_are_true(name):
    assert all(is_true(c["statement"], name) for c in own(MADE[name]))


PATHS = {
    name: [(i, *path) for i, c in enumerate(made["claims"]) if c["rule"] in OWN_RULES for path in numbers(c)]
    for name, made in MADE.items()
}
FREE = {
    "work",
    "uses",
    "order",
    "low",
    "high",
    "bound",
    "weights",
    "annihilator",
    "basis",
    "words",
    "steps",
    "length",
    "polynomial",
    "level",
}
"""What may be another in some claim: a weaker statement, a multiple of a vector, other words that span as well, the
level of a grid without weights."""


def true_or_rejected(name, path, change):
    """Whether the certificate with one number changed is verified; what is verified is true."""
    made = copy.deepcopy(MADE[name])
    place = made["claims"]
    for key in path[:-1]:
        place = place[key]
    old = place[path[-1]]
    new = change(Fraction(old))
    place[path[-1]] = str(new) if isinstance(old, str) else int(new)
    if place[path[-1]] == old:
        return False
    made["goal"] = [c["statement"] for c in made["claims"]]
    outcome = check_document(made)
    assert "fails on it" not in outcome.line
    if outcome.verified:
        assert all(is_true(c["statement"], name) for c in own(made)), (path, outcome.line)
    return outcome.verified


@settings(max_examples=300)
@given(st.data())
def test_any_number_changed(data):
    name = data.draw(st.sampled_from(sorted(MATRICES)))
    path = data.draw(st.sampled_from(PATHS[name]))
    change = data.draw(st.one_of(st.sampled_from(list(CHANGES.values())), st.fractions().map(lambda x: lambda _: x)))
    if true_or_rejected(name, path, change):
        assert FREE & set(path), path


PLACES = {name: [path for path in places(MADE[name]) if path] for name in ("takagi_1_8", "constant", "cantor")}


@settings(max_examples=200)
@given(st.sampled_from(sorted(PLACES)), st.data(), st.sampled_from(JUNK))
def test_anything_anywhere_is_answered(name, data, junk):
    path = data.draw(st.sampled_from(PLACES[name]))
    made = copy.deepcopy(MADE[name])
    place = made
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = junk
    assert "fails on it" not in check_document(made).line
