"""Forged proofs of false statements on radii, each by one trick; the checker says why it does not take it."""

from __future__ import annotations

import pytest
from hand_made import claim, document, poly
from hand_made_radius import four_point_attained, matrices_document

from subdiv_cli.checker import check_document

ONE = [[["1", "0"], ["0", "1"]]]
"""JSR 1."""
DOUBLE = [[["1", "0"], ["0", "2"]]]
"""JSR 2."""
HALF = [[["1", "0"], ["0", "1/2"]]]
NILPOTENT = [[["0", "1"], ["0", "0"]]]
UPPER = [[["0", "1"], ["0", "2"]]]
TURN = [[["0", "-1"], ["1", "0"]]]
SCALED_TURN = [[["0", "-1000000001/1000000000"], ["1000000001/1000000000", "0"]]]


def root(polynomial, low, high):
    return {"polynomial": polynomial, "low": low, "high": high}


def leader(**changes):
    said = {"word": [0], "reflected": False, "column": 0, "scale": "1", "annihilator": ["-1", "1"], "sign": 1}
    return {**said, **changes}


def turning(**changes):
    """i, an eigenvalue of the quarter turn."""
    said = leader(annihilator=["1", "0", "1"], factor=["1", "0", "1"], center=["0", "1"], distance="1/1024")
    del said["sign"]
    return {**said, **changes}


def hull(**changes):
    said = {"symmetry": 0, "bits": 64, "basis": [0, 1], "weight_bits": 2, "images": [], "extras": [], "tree": []}
    return {**said, **changes}


def closing(matrices, said, leaders, length=1, rule="closing", **changes):
    witness = hull(leaders=leaders, **{"ties": [], **changes})
    return matrices_document(
        matrices, [claim(rule, property="bounded", family=0, length=length, **said, witness=witness)]
    )


def monotone(matrices, said, leaders, length=1, **changes):
    return closing(matrices, said, leaders, length, "monotone-closing", **{"basis": [0, 0], **changes})


def tie(vertex, letter, weight, of=0):
    return {"vertex": vertex, "letter": letter, "weights": [{"vertex": of, "weight": weight}]}


def turned(matrices, said, leaders, length=2, **changes):
    witness = hull(leaders=leaders, **changes)
    made = claim("complex-closing", property="bounded", family=0, length=length, **said, witness=witness)
    return matrices_document(matrices, [made])


def polytope(matrices, bound, vertices, images, basis=(0, 1), symmetry=0):
    witness = {
        "symmetry": symmetry,
        "bits": 0,
        "vertices": vertices,
        "basis": list(basis),
        "weight_bits": 2,
        "images": images,
    }
    made = claim("polytope", property="radius-upper", family=0, length=1, bound=bound, witness=witness)
    return matrices_document(matrices, [made])


def blocks(matrices, sizes, parts, basis, *more):
    made = claim("blocks", family=0, parts=parts, witness={"basis": basis, "sizes": sizes})
    return matrices_document(matrices, [made, *more])


def upper(family, bound, uses=(), rule="zero", length=1):
    return claim(rule, uses, property="radius-upper", family=family, length=length, bound=bound)


def word(matrices, letters, bound):
    witness = {"word": letters}
    made = claim("word", property="radius-lower", family=0, length=max(1, len(letters)), bound=bound, witness=witness)
    return matrices_document(matrices, [made])


def closed_part(family, said):
    """A family of one number, by a leader alone."""
    number = said["low"]
    witness = hull(leaders=[leader(annihilator=["-" + number, "1"])], ties=[], basis=[0])
    return claim("closing", property="bounded", family=family, length=1, **said, witness=witness)


EVEN = [["2", "1"], ["1", "2"]]
"""The eigenvalues 3 of (1, 1) and 1 of (1, -1)."""
THREE = root(["-3", "1"], "3", "3")
TOP = leader(annihilator=["3", "-4", "1"])
"""(1, 1)."""
PHI = root(["-1", "-1", "1"], "1", "2")
SHEARED = leader(annihilator=["-1", "-1", "1"], column=1)
"""(1, φ)."""
PHI_SQUARED = root(["1", "-3", "1"], "2", "3")
SHEARED_TWICE = leader(word=[0, 0], annihilator=["1", "-3", "1"], column=1)
FIBONACCI = [["0", "1"], ["1", "1"]]
UNIT = [["1", "0"], ["0", "1"]]
FIVE, TWO, SMALL = root(["-5", "1"], "5", "5"), root(["-2", "1"], "2", "2"), root(["-1", "1"], "1", "1")
E0, E1 = leader(), leader(column=1)
POWERS = [[["0", "-2", "0", "0"], ["2", "0", "0", "0"], ["0"] * 4, ["0"] * 4]]
"""Twice a quarter turn: JSR² = 4, and z⁴ + 5z² + 4 = (z² + 1)(z² + 4) annihilates it too."""
OTHER_PAIR = {
    "annihilator": ["4", "0", "5", "0", "1"],
    "factor": ["4", "0", "5", "0", "1"],
    "center": ["0", "2"],
}


def not_the_largest():
    """(1+z)² (1 + 4z + z²)/12: the matrix C has the eigenvalues 1/12, twice, and 1/3, which is the radius."""
    small = root(["-1", "12"], "1/12", "1/12")
    squares = {"squares": poly(0, 1), "rest": poly(0, 4, 1, over=12), "power": 0}
    claims = [
        claim("sum-rules", mask=0, order=2, witness={"quotient": poly(0, 1, 4, 1, over=12)}),
        claim("transition", [0], property="family", family=0, mask=0, nu=2),
        claim("positive-symbol", [1, 0], squares, property="radius", family=0, length=1, **small),
    ]
    return document(2, poly(0, 1, 6, 10, 6, 1, over=12), claims)


def attained_at_an_integer():
    """The products of D of the four-point scheme are bounded at 1/4, and yet α = 2 is not attained."""
    made = four_point_attained()
    (number,) = [i for i, c in enumerate(made["claims"]) if c["rule"] == "positive-symbol"]
    uses = next(c["uses"] for c in made["claims"] if c["rule"] == "holder-root")
    assert made["claims"][number]["statement"]["property"] == "bounded"
    made["claims"].append(claim("attained-bounded", uses, property="attained", holds=True))
    made["goal"] = [made["claims"][-1]["statement"]]
    return made


ATTACKS = {
    "a combination of columns that is no eigenvector": (
        closing([[["2", "0"], ["0", "1"]]], TWO, [leader(annihilator=["-2", "1"], column=[1, 1])]),
        "the annihilator of a leader does not vanish on its column",
    ),
    "no combination of columns": (
        closing(ONE, SMALL, [leader(column=[0, 0])]),
        "a leader may be zero",
    ),
    "a combination of fewer columns": (
        closing(ONE, SMALL, [leader(column=[1])]),
        "the combination of columns of a leader does not have N coefficients",
    ),
    "a combination of columns with long numbers": (
        closing(ONE, SMALL, [leader(column=[1, 1000001])]),
        "is out of range",
    ),
    "the modulus of another pair": (
        turned(
            POWERS, SMALL, [turning(**OTHER_PAIR)], extras=[[0, 0, 2**30, 0], [0, 0, 0, 2**30]], tree=[-1, 0, -1, 1],
            basis=[0, 3, 1, 2], images=[[], []],
        ),
        "the eigenvalue does not have that modulus",
    ),
    "a complex image with too much weight": (
        turned([*TURN, [["3", "0"], ["0", "3"]]], SMALL, [turning()], images=[[0, 12, 0]]),
        "the image of vertex 0 by letter 1 is not inside",
    ),
    "a monotone hull of a leader with both signs": (
        monotone([EVEN], SMALL, [leader(annihilator=["3", "-4", "1"])]),
        "a coordinate of a leader may be negative",
    ),
    "a monotone hull of a negative eigenvalue": (
        monotone([[["0", "1"], ["1", "0"]]], SMALL, [leader(annihilator=["-1", "0", "1"], sign=-1)]),
        "a leader has the sign -1",
    ),
    "a monotone hull of matrices with signs": (
        monotone([EVEN, [["4", "-4"], ["0", "0"]]], THREE, [TOP], images=[[0, 4]]),
        "a matrix has a negative entry",
    ),
    "a monotone hull with a negative vertex": (
        monotone([EVEN], THREE, [TOP], extras=[[2**30, -(2**30)]], tree=[-1, 0], images=[[0, 4]]),
        "an extra vertex has a negative coordinate",
    ),
    "a monotone hull that is flat": (
        monotone(DOUBLE, SMALL, [leader()]), "a coordinate of a basis vertex may be zero"
    ),
    "a coordinate of a tie that is larger": (
        monotone([EVEN, [["0", "0"], ["2", "2"]]], THREE, [TOP], ties=[tie(0, 1, "1")]),
        "the tie of vertex 0 by letter 1 does not hold",
    ),
    "a monotone tie with a negative weight": (
        monotone([EVEN, UNIT], THREE, [TOP], ties=[tie(0, 1, "-1")]),
        "a weight of a tie may be negative",
    ),
    "a negative weight in a monotone hull": (
        monotone([EVEN, [["5", "0"], ["0", "5"]]], THREE, [TOP], images=[[0, -4]]),
        "a weight is not positive",
    ),
    "an irrational weight above 1": (
        monotone([FIBONACCI, [["2", "0"], ["0", "2"]]], PHI, [SHEARED], ties=[tie(0, 1, ["-2", "2"])]),
        "the weights of a tie are more than 1",
    ),
    "another irrational weight": (
        monotone([FIBONACCI, [["8/5", "0"], ["0", "17/10"]]], PHI, [SHEARED], ties=[tie(0, 1, ["-7/11", "1"])]),
        "the tie of vertex 0 by letter 1 does not hold",
    ),
    "a σ that is negative": (
        monotone(
            [FIBONACCI, UNIT], PHI_SQUARED, [SHEARED_TWICE], 2, tree=[0, 0], sigma=["1", "-1"],
            ties=[tie(0, 1, ["-2", "1"]), tie(1, 1, ["-2", "1"])],
        ),
        "σ may be negative",
    ),
    "a σ with another power": (
        monotone(
            [FIBONACCI, UNIT], PHI_SQUARED, [SHEARED_TWICE], 2, tree=[0, 0], sigma=["0", "1"],
            ties=[tie(0, 1, ["-2", "1"]), tie(1, 1, ["-2", "1"])],
        ),
        "the power of σ is not Λ",
    ),
    "the radius of the smaller part": (
        blocks(
            DOUBLE, [1, 1], [1, 2], UNIT, closed_part(1, SMALL), closed_part(2, TWO),
            claim("radius-of-blocks", [0, 1, 2], property="radius", family=0, length=1, **SMALL),
        ),
        "the radius of part 2 may be larger",
    ),
    "an eigenvalue that is not the largest": (not_the_largest(), "the root is not the largest real one"),
    "a class of functions at an integer": (attained_at_an_integer(), "the exponent may be an integer"),
    "an annihilator with a root that is none": (
        closing(ONE, FIVE, [leader(annihilator=["5", "-6", "1"])] * 2),
        "a leader may be zero",
    ),
    "a leading coefficient that is zero": (closing(ONE, FIVE, [leader(annihilator=["5", "0"])] * 2), "of a degree"),
    "an annihilator that is constant": (closing(ONE, FIVE, [leader(annihilator=["5"])] * 2), "of a degree"),
    "a polynomial that divides nothing": (closing(ONE, FIVE, [E0, E1]), "does not divide"),
    "a constant polynomial": (closing(ONE, root(["1"], "5", "5"), [E0, E1]), "constant or has no leading"),
    "a leading zero": (closing(ONE, root(["1", "0"], "5", "5"), [E0, E1]), "constant or has no leading"),
    "an interval with two roots": (closing(ONE, root(["2", "-3", "1"], "1/2", "5"), [E0]), "does not change its sign"),
    "an interval with three": (closing(ONE, root(["-6", "11", "-6", "1"], "1/2", "5"), [E0]), "not have exactly one"),
    "an interval with none": (closing(ONE, root(["-1", "1"], "2", "3"), [E0, E1]), "not in its interval"),
    "a double root": (closing(ONE, root(["4", "-4", "1"], "1", "3"), [E0, E1]), "does not change its sign"),
    "an interval from below zero": (closing(ONE, root(["-1", "0", "1"], "-2", "0"), [E0, E1]), "empty or not positive"),
    "an empty word": (closing(ONE, SMALL, [leader(word=[])] * 2), "of another length"),
    "a basis that does not span": (closing(DOUBLE, SMALL, [E0], basis=[0, 0], images=[]), "the basis does not span"),
    "a basis that is too short": (closing(DOUBLE, SMALL, [E0], basis=[0]), "not as many vertices as coordinates"),
    "no basis": (closing(DOUBLE, SMALL, [E0], basis=[]), "not as many vertices as coordinates"),
    "no leader": (closing(DOUBLE, SMALL, []), "there is no leader"),
    "an extra vertex that leads out": (
        closing(DOUBLE, SMALL, [E0], extras=[[0, 2**30]], tree=[-1, 0], images=[[1, 8]]),
        "the image of vertex 1 by letter 0 is not inside",
    ),
    "an extra vertex that is forgotten": (
        closing(DOUBLE, SMALL, [E0], extras=[[0, 2**30]], tree=[-1, 0]),
        "there are 1 images inside",
    ),
    "an extra vertex twice": (closing(DOUBLE, SMALL, [E0], extras=[[0, 1]], tree=[-1, 0, -1, 0]), "not the next extra"),
    "a tree that bites its tail": (closing(DOUBLE, SMALL, [E0], tree=[1, 0]), "does not come after its parent"),
    "an edge over the return": (closing(DOUBLE, SMALL, [E0], tree=[0, 0]), "the return of leader 0 is in the tree"),
    "a tie of an extra vertex": (
        closing(
            DOUBLE, SMALL, [E0], extras=[[0, 2**30]], tree=[-1, 0],
            ties=[{"vertex": 1, "letter": 0, "weights": [{"vertex": 1, "weight": "1"}]}],
        ),
        "a tie is of an extra vertex",
    ),
    "a tie that does not hold": (
        closing(
            [*ONE, [["0", "3"], ["3", "0"]]], SMALL, [E0, E1],
            ties=[
                {"vertex": 0, "letter": 1, "weights": [{"vertex": 1, "weight": "1"}]},
                {"vertex": 1, "letter": 1, "weights": [{"vertex": 0, "weight": "1"}]},
            ],
        ),
        "the tie of vertex 0 by letter 1 does not hold",
    ),
    "a tie of too much weight": (
        closing(
            [*ONE, [["0", "3"], ["3", "0"]]], SMALL, [E0, E1],
            ties=[
                {"vertex": 0, "letter": 1, "weights": [{"vertex": 1, "weight": "3"}]},
                {"vertex": 1, "letter": 1, "weights": [{"vertex": 0, "weight": "3"}]},
            ],
        ),
        "the weights of a tie are more than 1",
    ),
    "too much weight in two parts": (
        closing(
            [*ONE, [["0", "3"], ["3", "0"]]], SMALL, [E0, E1],
            ties=[
                {"vertex": 0, "letter": 1, "weights": [{"vertex": 1, "weight": "2"}, {"vertex": 1, "weight": "1"}]},
                {"vertex": 1, "letter": 1, "weights": [{"vertex": 0, "weight": "3"}]},
            ],
        ),
        "the weights of a tie are more than 1",
    ),
    "a symmetry that is none": (closing(DOUBLE, SMALL, [E0], symmetry=1), "do not have that symmetry"),
    "a reflection without a symmetry": (closing(TURN, SMALL, [leader(reflected=True)]), "nothing is symmetric"),
    "an odd length": (turned(TURN, SMALL, [turning()], length=3), "the length is odd"),
    "a modulus that is not 1": (turned(SCALED_TURN, SMALL, [turning()] * 2), "does not vanish on its column"),
    "a modulus that is too small": (turned(TURN, root(["-1", "2"], "1/2", "1/2"), [turning()]), "does not divide"),
    "a modulus that is too large": (turned(TURN, root(["-4", "1"], "4", "4"), [turning()]), "does not divide"),
    "a real eigenvalue": (
        turned(DOUBLE, SMALL, [turning(factor=["2", "-3", "1"], center=["1", "1/2048"])]),
        "the eigenvalue may be real",
    ),
    "a disc with two roots": (
        turned(TURN, SMALL, [turning(factor=["1", "0", "2", "0", "1"])]),
        "the disc does not isolate a root",
    ),
    "a disc with none": (turned(TURN, SMALL, [turning(center=["0", "3"])]), "the disc does not isolate a root"),
    "two eigenvalues": (turned(TURN, SMALL, [turning(), turning(center=["0", "-1"])]), "different eigenvalues"),
    "a polytope that is flat": (polytope(DOUBLE, "1", [["1", "0"], ["2", "0"]], [[0, 4], [1, 4]]), "does not span"),
    "a polytope of one vertex": (polytope(DOUBLE, "1", [["1", "0"]], [[0, 4]], basis=[0]), "not as many vertices"),
    "a polytope without vertices": (polytope(DOUBLE, "1", [], []), "do not have N coordinates"),
    "an image with too much weight": (polytope(DOUBLE, "1", UNIT, [[0, 4], [1, 8]]), "vertex 1 by letter 0 is not"),
    "an image with a vertex twice": (polytope(DOUBLE, "1", UNIT, [[0, 4], [1, 4, 1, 4]]), "a vertex has two"),
    "an image without weights": (polytope(DOUBLE, "1", UNIT, [[0, 4], []]), "vertex 1 by letter 0 is not inside"),
    "an image that is missing": (polytope(DOUBLE, "1", UNIT, [[0, 4]]), "there are not p images"),
    "a bound of zero": (polytope(NILPOTENT, "0", UNIT, [[], [0, 4]]), "not positive"),
    "a product that is nilpotent": (word(NILPOTENT, [0], "1/1000000000000"), "all eigenvalues of the product are"),
    "no word": (word(DOUBLE, [], "2"), "the word is of another length"),
    "a bound below zero": (word(NILPOTENT, [0], "-1"), "the bound is not positive"),
    "two matrices for one": (
        matrices_document(
            [[["1"]], [["2"]]],
            [claim("distinct", family=0, part=1, witness={"letters": [0]}), closed_part(1, SMALL),
             claim("of-distinct", [0, 1], property="bounded", family=0, length=1, **SMALL)],
        ),
        "matrix 1 is another, up to sign too",
    ),
    "the radius of another family": (
        matrices_document(
            [[["-1"]], [["1"]], [["-1"]]],
            [claim("distinct", family=0, part=1, witness={"letters": [0]}),
             claim("distinct", family=0, part=2, witness={"letters": [1]}), upper(2, "0"),
             claim("of-distinct", [0, 2], property="radius-upper", family=0, length=1, bound="0")],
        ),
        "a matrix is not zero",
    ),
    "parts that are one": (blocks(ONE, [1, 1], [1, 1], UNIT), "the next family is number 2"),
    "parts that are there already": (blocks(ONE, [1, 1], [0, 1], UNIT), "the next family is number 1"),
    "a block of size 0": (blocks(DOUBLE, [0, 2], [1, 2], UNIT), "not two blocks"),
    "sizes that leave one out": (blocks([[["1", "0"], ["0", "1"]]], [1], [1], UNIT), "not two blocks"),
    "no sizes": (blocks(ONE, [], [], UNIT), "not two blocks"),
    "a singular basis": (blocks(DOUBLE, [1, 1], [1, 2], [["1", "1"], ["1", "1"]]), "the basis is not one"),
    "a lower triangle": (blocks([[["0", "0"], ["1", "0"]]], [1, 1], [1, 2], UNIT), "not block upper triangular"),
    "the smaller part twice": (
        blocks(
            UPPER, [1, 1], [1, 2], UNIT, upper(1, "0"), upper(0, "0", [0, 1, 1], "upper-of-blocks")
        ),
        "or bounded with another family",
    ),
    "a part too few": (
        blocks(UPPER, [1, 1], [1, 2], UNIT, upper(1, "0"), upper(0, "0", [0, 1], "upper-of-blocks")),
        "does not use a claim on",
    ),
    "a matrix that is not zero": (matrices_document(NILPOTENT, [upper(0, "0")]), "a matrix is not zero"),
    "a negative radius": (matrices_document([[["0"]]], [upper(0, "-1")]), "the bound is not zero"),
}  # fmt: skip


@pytest.mark.parametrize("name", ATTACKS)
def test_the_checker_says_why_it_does_not_take_it(name):
    forged, why = ATTACKS[name]
    outcome = check_document(forged)
    assert not outcome.verified
    assert why in outcome.line, outcome.line


def test_the_attacks_fail_by_their_trick_alone():
    """Without it the same documents are proofs."""
    honest = [
        closing(ONE, SMALL, [E0, E1]),
        closing(HALF, root(["2", "-3", "1"], "1/2", "3/2"), [leader(annihilator=["2", "-3", "1"])] * 2, basis=[0, 2],
                extras=[[0, 2**28]], tree=[-1, 0], images=[[2, 2]]),
        closing([*ONE, [["0", "1"], ["1", "0"]]], SMALL, [E0, E1], ties=[
            {"vertex": 0, "letter": 1, "weights": [{"vertex": 1, "weight": "1"}]},
            {"vertex": 1, "letter": 1, "weights": [{"vertex": 0, "weight": "1/2"}, {"vertex": 0, "weight": "1/2"}]},
        ]),
        turned(TURN, SMALL, [turning()]),
        polytope(DOUBLE, "2", UNIT, [[0, 2], [1, 4]]),
        word(DOUBLE, [0], "2"),
        monotone([EVEN, UNIT], THREE, [TOP], images=[[0, 3]]),
        monotone([EVEN, UNIT], THREE, [TOP], ties=[tie(0, 1, "1/3")]),
        monotone([EVEN, [["0", "0"], ["3/2", "3/2"]]], THREE, [TOP], ties=[tie(0, 1, "1")]),
        monotone([FIBONACCI, UNIT], PHI_SQUARED, [SHEARED_TWICE], 2, tree=[0, 0], sigma=["-1", "1"],
                 ties=[tie(0, 1, ["-2", "1"]), tie(1, 1, ["-2", "1"])]),
        closing([FIBONACCI, UNIT], PHI, [SHEARED], basis=[0, 1], extras=[[2**30, 0]], tree=[-1, 0],
                ties=[tie(0, 1, ["-1", "1"])], weight_bits=10, images=[[0, 391, 1, -391], [1, 633]]),
        turned(
            POWERS, root(["-4", "1"], "4", "4"), [turning(**OTHER_PAIR)], extras=[[0, 0, 2**30, 0], [0, 0, 0, 2**30]],
            tree=[-1, 0, -1, 1], basis=[0, 3, 1, 2], images=[[], []],
        ),
        blocks(
            DOUBLE, [1, 1], [1, 2], UNIT, closed_part(1, SMALL), closed_part(2, TWO),
            claim("radius-of-blocks", [0, 1, 2], property="radius", family=0, length=1, **TWO),
        ),
        blocks([[["0", "1"], ["0", "0"]]], [1, 1], [1, 2], UNIT, upper(1, "0"), upper(2, "0"),
               upper(0, "0", [0, 1, 2], "upper-of-blocks")),
    ]  # fmt: skip
    for made in honest:
        outcome = check_document(made)
        assert outcome.verified, outcome.line


LONG = "1" + "0" * 9999


@pytest.mark.parametrize(
    "forged",
    [
        closing(ONE, root(["-" + LONG, "1"], LONG, LONG), [leader(word=[0] * 1000)] * 2, length=1000, bits=4096),
        closing(ONE, root(["-2", "0", "1"], "1/" + LONG, LONG), [E0, E1], bits=4096),
        word([[[LONG]]], [0] * 1000, LONG),
        word(DOUBLE, [0] * 1000, "1/" + LONG),
    ],
    ids=range(4),
)  # fmt: skip
def test_huge_numbers_end_at_once(forged):
    """Whatever they prove: no more work than is bounded."""
    assert "fails on it" not in check_document(forged).line
