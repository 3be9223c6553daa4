"""Rules on joint spectral radii: true certificates are verified, and forged claims are rejected by name."""

import copy
import random
from fractions import Fraction

import pytest
from hand_made_radius import ALL_RADIUS, OF_RADII, matrices_document, of_family, of_mask
from support import four_point, six_point

from subdiv_cli.checker import check_document

MADE = {name: make() for name, make in ALL_RADIUS.items()}


@pytest.mark.parametrize("name", MADE)
def test_true_certificates_are_verified(name):
    outcome = check_document(MADE[name])
    assert outcome.verified, outcome.line


def test_every_rule_is_in_some_true_certificate():
    rules = {c["rule"] for document in MADE.values() for c in document["claims"]}
    assert rules >= OF_RADII


def low(x):
    """A little less."""
    return str(Fraction(x) * Fraction(6, 7))


def weights(c):
    """The first list of weights that is not empty."""
    return next(flat for flat in c["witness"]["images"] if flat)


def set_in(*path):
    """A change that puts the last member of the path where the others lead."""
    *keys, last, value = path

    def change(c):
        for key in keys:
            c = c[key]
        c[last] = value

    return change


FORGED = [
    ("one_vertex", "monotone-polytope", set_in("statement", "bound", "19/10")),
    ("one_vertex", "monotone-polytope", set_in("statement", "length", 2)),
    ("one_vertex", "monotone-polytope", set_in("witness", "vertices", 0, ["2", "1"])),
    ("one_vertex", "monotone-polytope", set_in("witness", "vertices", 0, ["1", "-1"])),
    ("one_vertex", "monotone-polytope", set_in("witness", "vertices", 0, ["1", "0"])),
    ("one_vertex", "monotone-polytope", set_in("witness", "basis", [0])),
    ("one_vertex", "monotone-polytope", set_in("witness", "basis", [0, 1])),
    ("one_vertex", "monotone-polytope", set_in("witness", "images", [[0, 1], []])),
    ("one_vertex", "monotone-polytope", set_in("witness", "images", [[0, 1], [0, 2]])),
    ("one_vertex", "monotone-polytope", set_in("witness", "images", [[0, 1], [1, 1]])),
    ("one_vertex", "monotone-polytope", set_in("witness", "images", [[0, 1], [0, 2, 0, -1]])),
    ("monotone_enclosed", "monotone-polytope", lambda c: weights(c).__setitem__(1, -weights(c)[1])),
    (
        "monotone_enclosed",
        "monotone-polytope",
        lambda c: c["statement"].__setitem__("bound", low(c["statement"]["bound"])),
    ),
    ("monotone", "monotone-closing", set_in("statement", "length", 2)),
    ("monotone", "monotone-closing", set_in("statement", "polynomial", ["-1", "-2", "1"])),
    ("monotone", "monotone-closing", set_in("witness", "leaders", 0, "sign", -1)),
    ("monotone", "monotone-closing", set_in("witness", "leaders", 0, "reflected", False)),
    ("monotone", "monotone-closing", set_in("witness", "symmetry", 0)),
    ("monotone", "monotone-closing", set_in("witness", "basis", [0, 2])),
    ("monotone", "monotone-closing", set_in("witness", "ties", [])),
    ("monotone", "monotone-closing", set_in("witness", "ties", 0, "weights", [])),
    ("monotone", "monotone-closing", set_in("witness", "ties", 0, "weights", 0, "weight", "2")),
    ("monotone", "monotone-closing", set_in("witness", "ties", 0, "weights", 0, "weight", "-1")),
    ("monotone", "monotone-closing", set_in("witness", "ties", 0, "weights", 0, "vertex", 1)),
    ("monotone", "monotone-closing", set_in("witness", "ties", 0, "letter", 0)),
    ("golden", "closing", set_in("statement", "length", 2)),
    ("golden", "closing", set_in("statement", "polynomial", ["-1", "-2", "1"])),
    ("golden", "closing", set_in("statement", "low", "2")),
    ("golden", "closing", set_in("statement", "high", "-1")),
    ("golden", "closing", set_in("witness", "leaders", [])),
    ("golden", "closing", set_in("witness", "leaders", 0, "sign", 1)),
    ("golden", "closing", set_in("witness", "leaders", 0, "scale", "0")),
    ("golden", "closing", set_in("witness", "leaders", 0, "column", 2)),
    ("golden", "closing", set_in("witness", "leaders", 0, "word", [1])),
    ("golden", "closing", set_in("witness", "leaders", 0, "word", [0, 1])),
    ("golden", "closing", set_in("witness", "leaders", 0, "reflected", False)),
    ("golden", "closing", set_in("witness", "leaders", 0, "annihilator", ["-1", "1"])),
    ("golden", "closing", set_in("witness", "symmetry", -1)),
    ("golden", "closing", set_in("witness", "symmetry", 0)),
    ("golden", "closing", set_in("witness", "bits", 0)),
    ("golden", "closing", set_in("witness", "basis", [0, 0])),
    ("golden", "closing", set_in("witness", "basis", [0])),
    ("golden", "closing", set_in("witness", "tree", [])),
    ("golden", "closing", set_in("witness", "extras", [[1, 1]])),
    ("golden", "closing", lambda c: c["witness"]["images"].pop()),
    ("golden", "closing", lambda c: c["witness"]["images"].append([0, 1])),
    ("golden", "closing", lambda c: weights(c).__setitem__(1, weights(c)[1] + (1 << c["witness"]["weight_bits"]))),
    ("golden", "closing", lambda c: weights(c).__setitem__(1, -weights(c)[1])),
    ("golden", "closing", lambda c: weights(c).__setitem__(0, 99)),
    ("golden", "closing", set_in("work", 1)),
    ("rotation", "complex-closing", set_in("statement", "length", 3)),
    ("rotation", "complex-closing", set_in("statement", "length", 1)),
    ("rotation", "complex-closing", set_in("statement", "polynomial", ["-1", "2"])),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "distance", "1")),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "distance", "0")),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "center", ["1/2", "1/2"])),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "center", ["3/5", "0"])),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "factor", ["5", "-5", "5"])),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "factor", ["-1", "1"])),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "word", [1])),
    ("rotation", "complex-closing", set_in("witness", "leaders", 0, "scale", "-1")),
    ("rotation", "complex-closing", set_in("witness", "basis", [0, 0])),
    ("rotation", "complex-closing", lambda c: c["witness"]["images"].pop()),
    ("rotation", "complex-closing", lambda c: weights(c).__setitem__(1, weights(c)[1] + (1 << 39))),
    ("signed", "distinct", set_in("witness", "letters", [0])),
    ("signed", "distinct", set_in("witness", "letters", [0, 2])),
    ("signed", "distinct", set_in("witness", "letters", [0, 1, 3])),
    ("signed", "distinct", set_in("witness", "letters", [0, 1, 2, 0])),
    ("signed", "distinct", set_in("witness", "letters", [])),
    ("signed", "distinct", set_in("statement", "part", 2)),
    ("signed", "distinct", set_in("statement", "part", 0)),
    ("signed", "distinct", set_in("work", 11)),
    ("signed", "of-distinct", set_in("uses", [0])),
    ("signed", "of-distinct", set_in("uses", [1, 0])),
    ("signed", "of-distinct", set_in("statement", "property", "radius")),
    ("signed", "of-distinct", set_in("statement", "length", 2)),
    ("signed", "of-distinct", set_in("statement", "polynomial", ["-2", "-1", "1"])),
    ("signed", "of-distinct", set_in("statement", "family", 1)),
    ("triangular", "blocks", set_in("witness", "sizes", [2])),
    ("triangular", "blocks", set_in("witness", "sizes", [1, 2])),
    ("triangular", "blocks", set_in("witness", "basis", [["0", "1"], ["1", "0"]])),
    ("triangular", "blocks", set_in("witness", "basis", [["1", "0"], ["1", "0"]])),
    ("triangular", "blocks", set_in("statement", "parts", [1, 3])),
    ("triangular", "radius-of-blocks", set_in("statement", "polynomial", ["-2", "1"])),
    ("triangular", "radius-of-blocks", set_in("uses", [0, 1])),
    ("triangular", "radius-of-blocks", set_in("uses", [0, 2, 1])),
    ("nilpotent", "zero", set_in("statement", "family", 0)),
    ("nilpotent", "upper-of-blocks", set_in("uses", [0, 1])),
    ("enclosed", "polytope", lambda c: set_in("statement", "bound", "7/5")(c)),
    ("enclosed", "polytope", set_in("statement", "length", 2)),
    ("enclosed", "polytope", lambda c: c["witness"]["vertices"].pop()),
    ("enclosed", "word", set_in("statement", "bound", "173/2")),
    ("enclosed", "word", set_in("statement", "length", 12)),
    ("enclosed", "word", set_in("witness", "word", [2] * 13)),
    ("lower_of_blocks", "lower-of-blocks", set_in("statement", "bound", "3")),
    ("lower_of_blocks", "word", set_in("statement", "bound", "3")),
    ("lower_of_blocks", "word", set_in("statement", "bound", "0")),
    ("swap", "polytope", set_in("statement", "bound", "1/2")),
    ("swap", "polytope", set_in("statement", "bound", "-1")),
    ("swap", "polytope", set_in("witness", "images", [[1, 1]])),
    ("swap", "polytope", set_in("witness", "images", [[1, 1], [1, 1]])),
    ("swap", "polytope", set_in("witness", "basis", [0, 2])),
    ("swap", "polytope", set_in("witness", "symmetry", -1)),
    ("swap", "polytope", set_in("witness", "vertices", [["1", "1"], ["2", "2"]])),
    ("weighted", "growing-vector", set_in("statement", "bound", "9/8")),
    ("weighted", "growing-vector", set_in("statement", "bound", "-1")),
    ("weighted", "growing-vector", set_in("statement", "length", 2)),
    ("weighted", "growing-vector", set_in("witness", "word", [1])),
    ("weighted", "growing-vector", set_in("witness", "word", [2])),
    ("weighted", "growing-vector", set_in("witness", "sign", -1)),
    ("weighted", "growing-vector", set_in("witness", "sign", 0)),
    ("weighted", "growing-vector", set_in("witness", "left", True)),
    ("weighted", "growing-vector", set_in("witness", "vector", ["0", "0"])),
    ("weighted", "growing-vector", set_in("witness", "vector", ["-1", "-3"])),
    ("weighted", "growing-vector", set_in("witness", "vector", ["1", "2", "0"])),
    ("weighted", "growing-vector", set_in("work", 3)),
    ("weighted", "common-vector", set_in("statement", "bound", "7/8")),
    ("weighted", "common-vector", set_in("statement", "length", 2)),
    ("weighted", "common-vector", set_in("witness", "left", True)),
    ("weighted", "common-vector", set_in("witness", "vector", ["4", "1"])),
    ("weighted", "common-vector", set_in("witness", "vector", ["1", "2", "3"])),
    ("weighted", "common-vector", set_in("witness", "vector", ["-1", "-2"])),
    ("weighted", "common-vector", set_in("witness", "vector", ["0", "1"])),
    ("weighted", "meeting-bounds", set_in("uses", [0])),
    ("weighted", "meeting-bounds", set_in("uses", [1, 0])),
    ("weighted", "meeting-bounds", set_in("statement", "length", 2_000)),
    ("weighted", "meeting-bounds", set_in("statement", "polynomial", ["-1", "0", "1"])),
    ("weighted", "meeting-bounds", set_in("statement", "polynomial", ["-2", "1"])),
    ("weighted", "meeting-bounds", lambda c: c["statement"].update(polynomial=["-2", "1"], low="2", high="2")),
    ("weighted", "meeting-bounds", lambda c: c["statement"].update(polynomial=["-1", "2"], low="1/2", high="1/2")),
    ("column_sums", "transposed", set_in("statement", "part", 2)),
    ("column_sums", "transposed", set_in("statement", "family", 1)),
    ("column_sums", "transposed", set_in("work", 7)),
    ("column_sums", "of-transposed", set_in("uses", [1])),
    ("column_sums", "of-transposed", set_in("statement", "bound", "1/2")),
    ("column_sums", "of-transposed", set_in("statement", "family", 1)),
    ("column_sums", "common-vector", set_in("statement", "family", 0)),
    ("column_sums", "growing-vector", set_in("witness", "left", False)),
    ("ellipse", "growing-vector", set_in("witness", "sign", 1)),
    ("ellipse", "ellipsoid", set_in("statement", "bound", "3999/1000")),
    ("ellipse", "ellipsoid", set_in("statement", "bound", "-4")),
    ("ellipse", "ellipsoid", set_in("statement", "length", 1)),
    ("ellipse", "ellipsoid", set_in("witness", "form", [1, 0, 1])),
    ("ellipse", "ellipsoid", set_in("witness", "form", [-4, -1, -4])),
    ("ellipse", "ellipsoid", set_in("witness", "form", [0, 0, 0])),
    ("ellipse", "ellipsoid", set_in("witness", "form", [4, 1])),
    ("ellipse", "ellipsoid", set_in("witness", "words", [[0]])),
    ("ellipse", "ellipsoid", set_in("witness", "words", [[1], [0]])),
    ("ellipse", "ellipsoid", set_in("witness", "words", [[0], [0, 1], [1]])),
    ("ellipse", "ellipsoid", set_in("witness", "words", [[0], [1], [2]])),
    ("ellipse", "ellipsoid", set_in("witness", "words", [[]])),
    ("ellipse", "ellipsoid", set_in("witness", "words", [])),
    ("ellipse", "ellipsoid", set_in("work", 87)),
    ("tree_of_words", "ellipsoid", set_in("witness", "words", [[0], [1]])),
    ("tree_of_words", "ellipsoid", set_in("witness", "words", [[0, 0], [1]])),
    ("tree_of_words", "ellipsoid", set_in("witness", "words", [[0, 0], [0, 0, 1], [1]])),
    ("four_point_attained", "transition", set_in("statement", "nu", 5)),
    ("four_point_attained", "transition", set_in("statement", "family", 3)),
    ("four_point_attained", "positive-symbol", set_in("statement", "polynomial", ["-1", "8"])),
    ("four_point_attained", "positive-symbol", set_in("statement", "length", 2)),
    ("four_point_attained", "positive-symbol", set_in("witness", "power", 1)),
    ("four_point_attained", "holder-root", set_in("statement", "length", 2)),
    ("four_point_attained", "holder-root", set_in("statement", "polynomial", ["-1", "8"])),
    ("four_point_attained", "defective", set_in("statement", "value", "1/8")),
    ("four_point_attained", "defective", set_in("witness", "sign", -1)),
    ("four_point_attained", "defective", set_in("witness", "vector", ["1", "0", "0", "0"])),
    ("four_point_attained", "not-attained", set_in("uses", [])),
    ("four_point_polytope", "holder-root", lambda c: c["uses"].pop()),
    ("four_point_polytope", "attained-bounded", lambda c: c["uses"].pop(0)),
    ("four_point_polytope", "attained-bounded", set_in("statement", "holds", False)),
    ("quadratic", "attained-norm", lambda c: c["uses"].pop()),
    ("quadratic", "attained-norm", set_in("statement", "holds", False)),
]


@pytest.mark.parametrize(("name", "rule", "change"), FORGED, ids=[f"{i}-{f[1]}" for i, f in enumerate(FORGED)])
def test_a_forged_claim_is_named(name, rule, change):
    document = copy.deepcopy(MADE[name])
    numbers = [i for i, c in enumerate(document["claims"]) if c["rule"] == rule]
    number = numbers[0]
    change(document["claims"][number])
    document["goal"] = [document["claims"][number]["statement"]]
    outcome = check_document(document)
    assert not outcome.verified
    assert outcome.line.startswith(f"NOT VERIFIED claim {number} ({rule}): ") or outcome.claim == number
    assert "fails on it" not in outcome.line


def test_every_rule_is_forged():
    assert {rule for _, rule, _ in FORGED} == OF_RADII


def test_a_certificate_of_another_family_is_no_proof():
    document = copy.deepcopy(MADE["golden"])
    document["mask"]["matrices"][0][0][1] = "2"
    assert not check_document(document).verified


@pytest.mark.parametrize("mask", [six_point("1/64"), four_point("19/100"), four_point("1/2")], ids=str)
def test_any_smaller_radius_is_rejected(mask):
    """Each radius that a mask's certificate states, a little smaller, with the interval moved along."""
    document = of_mask(mask)
    tried = 0
    for number, c in enumerate(document["claims"]):
        if c["statement"]["property"] in ("radius", "bounded") and c["rule"] != "radius-of-blocks":
            forged = copy.deepcopy(document)
            said = forged["claims"][number]["statement"]
            said["low"], said["high"] = low(low(said["low"])), low(said["high"])
            forged["goal"] = [said]
            outcome = check_document(forged)
            assert outcome.claim == number, outcome.line
            tried += 1
    assert tried


def test_families_of_random_integers_are_verified():
    """The prover raises where the checker says no: families with real and complex leaders, blocks and zeros."""
    generator, kinds = random.Random(5), set()
    for _ in range(40):
        order, letters = generator.randint(1, 4), generator.randint(1, 3)
        matrices = [
            [[generator.choice([0, 0, 1, -1, 2, -3]) for _ in range(order)] for _ in range(order)]
            for _ in range(letters)
        ]
        kinds |= {c["rule"] for c in of_family(matrices)["claims"]}
    assert kinds >= {"closing", "complex-closing", "blocks", "zero"}


@pytest.mark.parametrize(("order", "bits", "limits"), [(40, 8, True), (60, 500, False), (120, 60, False)])
def test_a_basis_of_long_minors_is_not_inverted(order, bits, limits):
    """Minors are as long as all rows together; the checker says that they are too long, before it computes them."""
    rng = random.Random(order)
    basis = [[str(rng.getrandbits(bits)) for _ in range(order)] for _ in range(order)]
    unit = [[str(int(i == j)) for j in range(order)] for i in range(order)]
    said = {"property": "blocks", "family": 0, "parts": [1, 2]}
    witness = {"basis": basis, "sizes": [1, order - 1]}
    made = {"rule": "blocks", "statement": said, "witness": witness, "uses": [], "work": 2 * order**3}
    outcome = check_document(matrices_document([unit], [made]))
    assert outcome.verified == limits, outcome.line
    assert outcome.exhausted != limits
