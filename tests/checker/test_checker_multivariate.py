"""Certificates of masks on Z^s: true ones are verified, and each rule rejects its forgeries by name."""

import copy
import itertools
import json
from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
from hand_made import claim, q
from hand_made_multivariate import (
    ALL_MULTIVARIATE,
    MASKS,
    PAIRS,
    WORK,
    annihilator,
    differences,
    divided,
    document,
    norm,
    pair_norm,
    pair_quotient,
    quincunx_reduction,
    quotient,
    radius,
)

import subdiv_cli
from subdiv_cli.checker import KINDS, check_document, check_text
from subdiv_cli.checker.matrices import inverse
from subdiv_cli.checker.multivariate.lattice import DilationMatrix
from subdiv_cli.checker.multivariate.masks import multivariate_mask
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS

OWN_RULES = set(KINDS["multivariate"].rules) - set(RADIUS.rules)
MADE = {name: make() for name, make in ALL_MULTIVARIATE.items()}
"""Made once and never changed."""


def set_in(*path_and_value):
    *path, value = path_and_value

    def change(c):
        for key in path[:-1]:
            c = c[key]
        c[path[-1]] = value

    return change


def rejected(made, number, *words):
    outcome = check_document(made)
    assert not outcome.verified
    assert outcome.claim == number, outcome.line
    assert "fails on it" not in outcome.line
    for word in words:
        assert word in outcome.line
    return outcome


@pytest.mark.parametrize("name", ALL_MULTIVARIATE)
def test_true_certificates_are_verified(name):
    outcome = check_text(json.dumps(MADE[name]))
    assert outcome.verified, outcome.line


def test_every_rule_is_there():
    assert {c["rule"] for made in MADE.values() for c in made["claims"]} >= OWN_RULES


def test_the_line_reads_well():
    made = copy.deepcopy(MADE["four_eight"])
    made["goal"] = made["goal"][-6:]
    assert check_document(made).line == (
        "VERIFIED φ is the box spline of (0, 1) 2 times, (1, -1) 2 times, (1, 0) 2 times, (1, 1) 2 times; φ is C^4; "
        "φ is not C^5; α = 5; s = 11/2; φ is not stable"
    )
    made = copy.deepcopy(MADE["zwart_powell"])
    made["goal"] = made["goal"][2:5]
    assert check_document(made).line == "VERIFIED generation degree 1; reproduction degree 1; s >= 2"
    made = copy.deepcopy(MADE["butterfly"])
    made["goal"] = [s for s in made["goal"] if s["property"].startswith("sobolev")]
    assert check_document(made).line.startswith("VERIFIED s = -log_2(λ)/2, λ the zero of a polynomial; s >= -log_2(λ)")
    made = copy.deepcopy(MADE["quincunx"])
    made["goal"] = made["goal"][-5:-4]
    assert check_document(made).line.startswith("VERIFIED α = -2 log_2(the root of 4x^2 - 2x - 1 in [")
    made["goal"] = MADE["quincunx"]["goal"][-4:]
    assert check_document(made).line == (
        "VERIFIED ‖S_Q^3‖ = 27/32 for differences of order 1; S converges; φ is C^0; α >= 2 log_2(32/27)/3"
    )
    made = copy.deepcopy(MADE["butterfly"])
    made["goal"] = made["goal"][-4:-2]
    assert check_document(made).line == (
        "VERIFIED ‖S_cd^2‖ = 7/8 for the factors in directions (1, 0), (1, 1); φ is C^1"
    )


witness = lambda *path: set_in("witness", *path)  # noqa: E731
said = lambda key, value: set_in("statement", key, value)  # noqa: E731


def line(*coefficients):
    return {"start": 0, "coefficients": list(coefficients)}


Q = "surface-quasi-interpolation"


def term(key, index, value):
    """Another value at an index of the operator or the stencil."""

    def change(c):
        next(pair for pair in c["statement"][key] if pair[0] == index)[1] = value

    return change


def identity(c):
    """Q f = f."""
    c["statement"] |= {"operator": [[[0, 0], "1"]], "stencil": [[[0, 0], "1"]]}


def another_operator(c):
    """That of the bicubic B-spline, with its stencil."""
    far = [[[i, j], "-1/6"] for i, j in ((-1, 0), (0, -1), (0, 1), (1, 0))]
    stencil = [*far[:2], [[0, 0], "5/3"], *far[2:]]
    c["statement"] |= {"operator": [[[0, 0], "1"], [[0, 2], "-1/6"], [[2, 0], "-1/6"]], "stencil": stencil}


S = "stencil-differences"
FORGED = [
    ("trapezoids", "limit-stencil", said("coset", [1, 0]), "does not fix it"),
    ("trapezoids", "limit-stencil", said("coset", [0, 0, 0]), "an index is not of Z^2"),
    ("trapezoids", "limit-stencil", lambda c: c["witness"]["terms"].pop(), "the sum is not 1"),
    ("trapezoids", "limit-stencil", witness("terms", [[[0, 0], "1"]]), "does not fix it"),
    ("trapezoids", "limit-stencil", witness("terms", []), "is empty"),
    ("trapezoids", "limit-stencil", set_in("work", 10), "more work"),
    ("trapezoids", S, said("order", 0), "the order is not positive"),
    ("trapezoids", S, said("order", 1), "the tree"),
    ("trapezoids", S, said("order", 3), "the tree"),
    ("trapezoids", S, said("order", 61), "the order is too large"),
    ("trapezoids", S, said("family", 1), "the next family is number 0"),
    ("trapezoids", S, lambda c: c["uses"].pop(), "does not use a claim on limit-stencil"),
    ("trapezoids", S, lambda c: c["witness"]["basis"][0].pop(), "not as long as the window"),
    ("trapezoids", S, witness("basis", []), "the basis is empty"),
    ("trapezoids", S, lambda c: c["witness"]["matrices"].pop(), "the matrices are not m"),
    ("trapezoids", S, witness("matrices", 1, 0, 0, "1/7"), "matrix 1 does not give the image of row 0"),
    ("trapezoids", S, lambda c: c["witness"]["cosets"].reverse(), "does not give the image"),
    ("trapezoids", S, witness("cosets", 1, [0, 2]), "congruent"),
    ("trapezoids", S, lambda c: c["witness"]["basis"].__setitem__(0, c["witness"]["basis"][1]), "dependent"),
    ("trapezoids", S, lambda c: c["witness"]["leaves"].pop(), "the tree has not as many leaves"),
    ("trapezoids", S, lambda c: c["witness"]["leaves"][0].pop(), "a leaf has not as many coordinates"),
    ("trapezoids", S, witness("leaves", 0, 0, "1/7"), "has other coordinates"),
    ("trapezoids", S, lambda c: c["witness"]["tree"].reverse(), "nodes that are no images"),
    ("trapezoids", S, lambda c: c["witness"]["words"].pop(), "not as many words"),
    ("trapezoids", S, witness("words", 0, [99]), "a word has no leaf"),
    ("trapezoids", S, witness("words", 0, []), "a word has no leaf"),
    ("trapezoids", S, lambda c: c["witness"]["words"][0].append(4), "a letter is not there"),
    ("trapezoids", S, lambda c: c["witness"]["words"].__setitem__(0, c["witness"]["words"][1]), "do not span"),
    ("trapezoids", S, witness("breadth", 1), "has more indices"),
    ("trapezoids", S, set_in("work", 100), "more work"),
    ("trapezoids", "stencil-smooth", said("order", 1), "the radius is not small enough"),
    ("trapezoids", "stencil-smooth", said("order", 2), "the differences are of order 2"),
    ("trapezoids", "stencil-smooth", lambda c: c["uses"].pop(0), "not convergent"),
    ("trapezoids", "stencil-not-smooth", lambda c: c["uses"].pop(), "does not use a claim on stencil-family"),
    ("trapezoids", "stencil-not-smooth", said("order", 0), "the radius is not large enough"),
    ("trapezoids", "stencil-holder-lower", said("bound", "1/3"), "another length or bound"),
    ("trapezoids", "stencil-holder-lower", said("length", 2), "another length or bound"),
    ("trapezoids", "stencil-holder-upper", said("bound", "2/3"), "another length or bound"),
    ("trapezoids", "stencil-holder-upper", lambda c: c["uses"].pop(0), "not convergent"),
    ("trapezoids", "stencil-holder-root", said("polynomial", ["-1", "3"]), "another polynomial"),
    ("trapezoids", "holder-meets", lambda c: c["uses"].reverse(), "not holder-lower"),
    ("trapezoids", "holder-meets", said("length", 2), "the bound from below is another"),
    ("trapezoids", "holder-meets", said("polynomial", ["-1", "3"]), "not a rational number"),
    ("flat", "coset-sums", said("holds", True), "not all 1"),
    ("haar", "coset-sums", said("holds", False), "all 1"),
    ("bilinear", "total-sum-rules", said("order", 3), "fail for the monomial"),
    ("bilinear", "total-sum-rules", said("order", 1), "of a higher order"),
    ("bilinear", "total-sum-rules", said("order", 0), "of a higher order"),
    ("flat", "total-sum-rules", said("order", 1), "fail for the monomial (0, 0)"),
    ("butterfly", "total-sum-rules", said("order", 10_000), "more work"),
    ("bilinear", "generation", said("degree", 2), "of order 2"),
    ("flat", "generation", said("degree", 0), "of order 0"),
    ("bilinear", "reproduction", said("degree", 0), "a higher degree"),
    ("bilinear", "reproduction", said("degree", 2), "of order 2"),
    ("bilinear", "reproduction", said("degree", -1), "of order 2"),
    ("four_eight", "reproduction", said("degree", 2), "degree 2 are not reproduced"),
    ("four_eight", "reproduction", said("degree", 0), "a higher degree"),
    ("four_eight", "reproduction", set_in("work", 9), "more work"),
    ("butterfly", "reproduction", said("degree", 2), "a higher degree"),
    ("loop", Q, said("degree", 1), "a derivative is not one of order 0, …, 1"),
    ("loop", Q, said("degree", 4), "the sum rules are of order 4"),
    ("loop", Q, term("operator", [0, 2], "-1/3"), "the stencil is not the operator at (0, 2)"),
    ("loop", Q, term("operator", [0, 0], "2"), "does not begin with f"),
    ("loop", Q, lambda c: c["statement"]["operator"].pop(0), "does not begin with f"),
    (
        "loop",
        Q,
        lambda c: c["statement"]["operator"].append([[3, 0], "1"]),
        "the stencil is not the operator at (3, 0)",
    ),
    ("loop", Q, lambda c: c["statement"]["operator"].append([[2, 2], "1"]), "a derivative is not one of order"),
    ("loop", Q, lambda c: c["statement"]["operator"].insert(0, [[-1, 1], "1"]), "a derivative is not one of order"),
    ("loop", Q, lambda c: c["statement"]["operator"].append([[2, 2, 0], "1"]), "an index is not one of Z^2"),
    ("loop", Q, term("stencil", [0, 0], "4/3"), "the stencil is not the operator at (0, 0)"),
    ("loop", Q, term("stencil", [0, 1], "1/12"), "the stencil is not the operator at (0, 0)"),
    ("loop", Q, lambda c: c["statement"]["stencil"].append([[2, 2, 2], "1"]), "an index is not one of Z^2"),
    ("loop", Q, said("stencil", []), "is empty"),
    ("loop", Q, said("operator", []), "is empty"),
    ("loop", Q, another_operator, "S Q is not Q after the dilation at (1, 1)"),
    ("loop", Q, identity, "S Q is not Q after the dilation at (0, 2)"),
    ("loop", Q, lambda c: c["uses"].reverse(), "it uses total-sum-rules, not convergent"),
    ("loop", Q, lambda c: c["uses"].pop(), "does not use"),
    ("loop", Q, set_in("work", 50), "more work"),
    ("four_eight", Q, identity, "S Q is not Q after the dilation at (0, 1)"),
    ("bilinear", Q, said("degree", 2), "the sum rules are of order 2"),
    ("bilinear", "surface-sobolev", said("high", "1/9"), "not one of positive numbers"),
    ("bilinear", "surface-sobolev", said("low", "0"), "not one of positive numbers"),
    ("bilinear", "surface-sobolev", said("low", "1/7"), "not one of positive numbers"),
    ("bilinear", "surface-sobolev", said("low", "1/100"), "the cofactor is not seen to be positive"),
    ("bilinear", "surface-sobolev", said("polynomial", line("-1", "16")), "no change of sign"),
    ("bilinear", "surface-sobolev", said("polynomial", line("1", "-8")), "not seen to increase"),
    ("bilinear", "surface-sobolev", said("polynomial", line("1")), "is constant"),
    ("bilinear", "surface-sobolev", witness("cofactor", line("1")), "do not annihilate"),
    ("bilinear", "surface-sobolev", witness("cofactor", {"start": 0, "coefficients": []}), "the cofactor"),
    ("bilinear", "surface-sobolev", witness("cofactor", {"start": 200, "coefficients": ["1"]}), "of degree 201"),
    ("bilinear", "surface-sobolev", lambda c: c["uses"].pop(), "does not use a claim on stable"),
    ("bilinear", "surface-sobolev", lambda c: c["uses"].pop(0), "not total-sum-rules"),
    ("zwart_powell", "surface-sobolev", said("property", "sobolev"), "does not use a claim on stable"),
    ("bilinear", "surface-sobolev", said("property", "sobolev-lower"), "claims that it does not need"),
    ("bilinear", "surface-sobolev", set_in("work", 100), "more work"),
    ("bilinear", "differences", said("order", 3), "of order 2"),
    ("bilinear", "differences", said("order", 0), "of order 2"),
    ("bilinear", "differences", said("order", 1), "as many generators"),
    ("bilinear", "differences", said("family", 1), "the next family is number 0"),
    ("bilinear", "differences", witness("cosets", [[0, 0], [0, 1], [1, 0], [2, 1]]), "congruent"),
    ("bilinear", "differences", witness("cosets", [[0, 0], [0, 1], [1, 0]]), "not m"),
    ("bilinear", "differences", witness("cosets", [[0, 0], [0, 1], [1, 1], [1, 0]]), "does not give the image"),
    ("bilinear", "differences", witness("cosets", [[0, 0], [0, 1], [1, 0], [1, 1, 1]]), "another dimension"),
    ("bilinear", "differences", lambda c: c["witness"]["window"].__setitem__(0, [9, 9]), "not annihilate"),
    ("bilinear", "differences", lambda c: c["witness"]["window"].__setitem__(0, [0, 0, 0]), "not one of Z^2"),
    ("bilinear", "differences", lambda c: c["witness"]["window"].__setitem__(0, c["witness"]["window"][1]), "twice"),
    ("bilinear", "differences", lambda c: c["witness"]["window"].pop(), "not as long as the window"),
    ("bilinear", "differences", lambda c: c["witness"]["basis"].pop(), "another order than the basis"),
    ("bilinear", "differences", lambda c: c["witness"]["basis"][0].__setitem__(0, 7), "not annihilate"),
    ("bilinear", "differences", lambda c: c["witness"]["matrices"].pop(), "not m"),
    ("bilinear", "differences", lambda c: c["witness"]["matrices"][1][2].__setitem__(3, "1/3"), "matrix 1 does not"),
    ("bilinear", "differences", lambda c: c["witness"]["matrices"].reverse(), "does not give the image"),
    ("bilinear", "differences", lambda c: c["witness"]["generators"].pop(), "as many generators"),
    ("bilinear", "differences", lambda c: c["witness"]["generators"].reverse(), "coordinates of the difference"),
    ("bilinear", "differences", lambda c: c["witness"]["generators"][0].pop(), "as many coordinates"),
    ("bilinear", "differences", set_in("work", 100), "more work"),
    ("bilinear", "converges", lambda c: c["uses"].reverse(), "it uses family"),
    ("bilinear", "converges", lambda c: c["uses"].pop(), "does not use"),
    ("butterfly", "smooth", said("order", 2), "radius is not small enough"),
    ("butterfly", "holder-lower", said("length", 1), "another length or bound"),
    ("butterfly", "holder-lower", said("bound", "17/500"), "another length or bound"),
    ("haar", "diverges", said("holds", True), "does not prove such statements"),
    ("haar", "diverges", set_in("uses", [0]), "the coset sums are 1"),
    ("bilinear", "smooth", said("order", 1), "radius is not small enough"),
    ("bilinear", "smooth", said("order", 2), "differences are of order 2"),
    ("four_eight", "smooth", said("order", 4), "differences are of order 4"),
    ("bilinear", "not-smooth", said("order", 0), "radius is not large enough"),
    ("bilinear", "not-smooth", said("order", 2), "differences are of order 2"),
    ("bilinear", "not-smooth", lambda c: c["uses"].pop(0), "not stable"),
    ("bilinear", "holder-lower", said("bound", "1/3"), "another length or bound"),
    ("bilinear", "holder-lower", said("length", 2), "another length or bound"),
    ("bilinear", "holder-upper", said("bound", "3/5"), "another length or bound"),
    ("bilinear", "holder-upper", lambda c: c["uses"].pop(), "does not use"),
    ("quincunx", "holder-root", said("length", 2), "another length"),
    ("quincunx", "holder-root", said("high", "1"), "another high"),
    ("haar", "holder-root", lambda c: c["uses"].pop(2), "not total-sum-rules"),
    ("apart", "sublattice-diverges", said("holds", True), "does not prove such statements"),
    ("apart", "sublattice-diverges", witness("modulus", 2), "does not vanish on the differences"),
    ("apart", "sublattice-diverges", witness("modulus", 1), "zero modulo n"),
    ("apart", "sublattice-diverges", witness("modulus", 0), "zero modulo n"),
    ("apart", "sublattice-diverges", witness("functional", [3, 3]), "zero modulo n"),
    ("apart", "sublattice-diverges", witness("functional", [1, 0, 0]), "not one on Z^2"),
    ("bilinear", "interpolatory-stable", set_in("uses", []), "does not use"),
    ("bilinear", "interpolatory-stable", said("holds", False), "does not prove such statements"),
    ("bilinear", "gram-stable", set_in("uses", []), "does not use"),
    ("bilinear", "gram-stable", set_in("witness", "gram", 0, 1, "1/35"), "not even"),
    ("bilinear", "gram-stable", set_in("witness", "gram", 4, 1, "5/9"), "add up to 1"),
    ("bilinear", "gram-stable", witness("gram", [[[0, 0], "1"]]), "does not map g to itself"),
    ("bilinear", "gram-stable", witness("gram", [[[0, 0, 0], "1"]]), "another dimension"),
    ("bilinear", "gram-stable", witness("tree", [-1, -1, -1, -1]), "on a box is not positive"),
    ("bilinear", "gram-stable", witness("tree", [-1, 1, -1, -1, -1, 1, -1]), "ends early"),
    ("bilinear", "gram-stable", witness("tree", [-1, 1, -1, -1, -1, 2, -1, -1]), "not there"),
    ("bilinear", "gram-stable", witness("tree", [-1, 1, -1, -1, -1, 1, -1, -1, -1]), "more boxes"),
    ("bilinear", "gram-stable", set_in("work", 100), "more work"),
    ("zwart_powell", "gram-unstable", witness("point", [1, 0]), "not zero at the point"),
    ("zwart_powell", "gram-unstable", witness("point", [1, 1, 0]), "another dimension"),
    ("zwart_powell", "gram-unstable", witness("order", 3), "not zero at the point"),
    ("zwart_powell", "gram-unstable", said("holds", True), "does not prove such statements"),
    ("chaikin_hat", "tensor-product", said("parts", [[0, 1]]), "only one factor"),
    ("chaikin_hat", "tensor-product", said("parts", [[0], [0]]), "not in one factor each"),
    ("chaikin_hat", "tensor-product", said("parts", [[1], [0]]), "not the mask"),
    ("chaikin_hat", "tensor-product", witness("which", [1, 0]), "not the mask"),
    ("chaikin_hat", "tensor-product", witness("which", [0, 0]), "missing, or not used"),
    ("chaikin_hat", "tensor-product", witness("which", [0, 1, 1]), "not one certificate for each"),
    ("chaikin_hat", "tensor-product", set_in("work", 100), "more work"),
    ("chaikin_hat", "tensor-product", set_in("witness", "certificates", 1, {}), "a certificate is none"),
    ("chaikin_hat", "tensor-product", set_in("witness", "certificates", 1, "goal", []), "certificate 1: NOT VERIFIED"),
    (
        "chaikin_hat",
        "tensor-product",
        set_in("witness", "certificates", 1, "claims", 7, "statement", "holds", False),
        "certificate 1: NOT VERIFIED claim 7",
    ),
    ("chaikin_hat", "tensor-product", set_in("witness", "certificates", 1, "mask", "arity", 3), "certificate 1"),
    ("chaikin_hat", "tensor-converges", said("holds", False), "factors do not say so"),
    ("chaikin_hat", "tensor-stable", said("holds", False), "factors do not say so"),
    ("chaikin_hat", "tensor-stable", lambda c: c["uses"].pop(), "does not use"),
    ("chaikin_hat", "tensor-smooth", said("order", 1), "not known to be so smooth"),
    ("chaikin_hat", "tensor-not-smooth", said("order", 0), "no factor is known not to be so smooth"),
    ("chaikin_hat", "of-factor", said("variables", [0]), "does not prove the statement"),
    ("chaikin_hat", "of-factor", said("variables", [0, 1]), "no factor in these variables"),
    ("chaikin_hat", "of-factor", set_in("statement", "statement", "norm", "1/3"), "does not prove the statement"),
    ("chaikin_hat", "of-factor", set_in("statement", "statement", "property", "smooth"), "does not prove"),
    ("chaikin_hat", "of-factor", witness("between", "3"), "may have a smaller exponent"),
    ("chaikin_hat", "of-factor", witness("between", "1/2"), "at most the number between"),
    ("chaikin_hat", "of-factor", witness("between", "1001"), "out of range"),
    ("chaikin_hat", "of-factor", witness("between", "1501/1001"), "out of range"),
    ("chaikin_hat", "of-factor", witness("between", "0"), "out of range"),
    ("chaikin_hat", "of-factor", set_in("witness", {}), "a number between"),
    ("chaikin_hat", "at-most-factor", said("variables", [0]), "does not prove the statement"),
    ("bilinear", "box-spline", witness("shift", [0, 0]), "not that of the box spline"),
    ("bilinear", "box-spline", witness("shift", [-1, -1, 0]), "the shift"),
    ("bilinear", "box-spline", witness("power", 2), "power of the dilation"),
    ("bilinear", "box-spline", witness("power", 0), "the power"),
    ("bilinear", "box-spline", said("scale", 3), "power of the dilation"),
    ("bilinear", "box-spline", said("directions", [[0, 1], [0, 1], [1, 0]]), "not that of the box spline"),
    ("bilinear", "box-spline", said("directions", [[0, 1], [0, 1], [1, 0], [1, 1]]), "not that of the box spline"),
    ("bilinear", "box-spline", said("directions", [[0, 1], [1, 0], [0, 1], [1, 0]]), "not sorted"),
    ("bilinear", "box-spline", said("directions", [[0, 0], [0, 1], [0, 1], [1, 0], [1, 0]]), "is zero"),
    ("bilinear", "box-spline", said("directions", [[0, 1]]), "not enough"),
    ("bilinear", "box-spline", said("directions", [[0, 1], [0, 1], [0, 1], [0, 1]]), "do not span"),
    ("four_eight", "box-spline", witness("power", 1), "power of the dilation"),
    ("four_eight", "box-spline", witness("power", 4), "power of the dilation"),
    ("four_eight", "box-spline", said("scale", 4), "power of the dilation"),
    ("zwart_powell", "box-smooth", said("order", 2), "d = 3"),
    ("zwart_powell", "box-not-smooth", said("order", 1), "d = 3"),
    ("zwart_powell", "box-holder", said("value", 3), "d = 3"),
    ("zwart_powell", "box-sobolev", said("value", "2"), "d = 3"),
    ("zwart_powell", "box-sobolev", said("value", "3"), "d = 3"),
    ("zwart_powell", "box-stable", said("holds", True), "not unimodular"),
    ("bilinear", "box-stable", said("holds", False), "unimodular"),
    ("bilinear", "directional-norm", said("norm", "1/3"), "the norm is another"),
    ("bilinear", "directional-norm", said("level", 2), "the norm is another"),
    ("bilinear", "directional-norm", said("level", 0), "the level"),
    ("bilinear", "directional-norm", said("level", 60), "more work"),
    ("bilinear", "directional-norm", said("direction", [0, 1]), "not the mask"),
    ("bilinear", "directional-norm", said("direction", [0, 0]), "is zero"),
    ("bilinear", "directional-norm", said("direction", [1, 0, 0]), "the direction"),
    ("bilinear", "directional-norm", witness("quotient", quotient("bilinear", 0, 1)), "not the mask"),
    ("bilinear", "directional-norm", witness("quotient", [[[0, 0, 0], "1"]]), "the quotient"),
    ("bilinear", "directional-converges", lambda c: c["uses"].pop(), "does not use"),
    ("bilinear", "directional-converges", lambda c: c["uses"].__setitem__(2, c["uses"][1]), "not a basis"),
    ("bilinear", "positive-converges", lambda c: c["uses"].pop(), "does not use"),
    ("bilinear", "positive-converges", said("holds", False), "does not prove such statements"),
    ("butterfly", "pair-norm", said("norm", "3/4"), "the norm is another"),
    ("butterfly", "pair-norm", said("level", 1), "the norm is another"),
    ("butterfly", "pair-norm", said("level", 65), "the level"),
    ("butterfly", "pair-norm", said("level", 40), "more work"),
    ("butterfly", "pair-norm", said("directions", [[0, 1], [1, 1]]), "not the mask"),
    ("butterfly", "pair-norm", said("directions", [[0, 1]]), "not two directions"),
    ("butterfly", "pair-norm", said("directions", [[0, 1], [0, 0]]), "is zero"),
    ("butterfly", "pair-norm", said("directions", [[0, 1], [1, 0, 0]]), "is zero or not one"),
    ("butterfly", "pair-norm", witness("quotient", quotient("butterfly", 0, 1)), "not the mask"),
    ("butterfly", "pair-norm", witness("quotient", [[[0, 0, 0], "1"]]), "the quotient"),
    ("butterfly", "directional-smooth", said("order", 2), "second derivatives"),
    ("butterfly", "directional-smooth", lambda c: c["uses"].pop(), "does not use"),
    ("butterfly", "directional-smooth", lambda c: c["uses"].pop(0), "not coset-sums"),
    ("butterfly", "directional-smooth", lambda c: c["uses"].__setitem__(2, c["uses"][1]), "not all pairs"),
    ("quincunx", "matrix-norm", said("norm", "13/16"), "the norm is another"),
    ("quincunx", "matrix-norm", said("level", 4), "the norm is another"),
    ("quincunx", "matrix-norm", said("level", 0), "the level"),
    ("quincunx", "matrix-norm", said("level", 64), "too high"),
    ("quincunx", "matrix-norm", said("order", 2), "not 3^2 entries"),
    ("quincunx", "matrix-norm", said("order", 3), "of order 2"),
    ("quincunx", "matrix-norm", said("order", 0), "of order 2"),
    ("quincunx", "matrix-norm", witness("power", 2), "does not divide"),
    ("quincunx", "matrix-norm", witness("power", 3), "no reduction: row (0, 1)"),
    ("quincunx", "matrix-norm", witness("power", 0), "does not divide"),
    ("quincunx", "matrix-norm", lambda c: c["witness"]["entries"].pop(), "not 2^2 entries"),
    ("quincunx", "matrix-norm", lambda c: c["witness"]["entries"].reverse(), "no reduction: row (0, 1)"),
    ("quincunx", "matrix-norm", lambda c: c["witness"]["entries"][3].clear(), "no reduction: row (1, 0)"),
    ("quincunx", "matrix-norm", lambda c: c["witness"]["entries"][2].reverse(), "do not increase"),
    ("quincunx", "matrix-norm", lambda c: c["witness"]["entries"][2][0].__setitem__(1, "0"), "is zero"),
    ("quincunx", "matrix-norm", lambda c: c["witness"]["entries"][2][0].__setitem__(0, [0, 0, 0]), "not one of Z^2"),
    ("quincunx", "matrix-norm", lambda c: c["uses"].pop(), "does not use"),
    ("quincunx", "matrix-norm", set_in("work", 100), "more work"),
    ("trilinear", "directional-converges", lambda c: c["uses"].__setitem__(2, c["uses"][1]), "not a basis"),
]


@pytest.mark.parametrize(("name", "rule", "change", "words"), FORGED, ids=[f"{i}-{f[1]}" for i, f in enumerate(FORGED)])
def test_a_forged_claim_is_named(name, rule, change, words):
    made = copy.deepcopy(MADE[name])
    number = next(i for i, c in enumerate(made["claims"]) if c["rule"] == rule)
    change(made["claims"][number])
    made["goal"] = [made["claims"][number]["statement"]]
    rejected(made, number, f"claim {number}", words)


def test_less_may_be_said_of_q():
    """That of cubics is that of quadratics."""
    made = copy.deepcopy(MADE["loop"])
    number = next(i for i, c in enumerate(made["claims"]) if c["rule"] == Q)
    made["claims"][number]["statement"]["degree"] = 2
    made["goal"] = [made["claims"][number]["statement"]]
    assert check_document(made).line == "VERIFIED S^∞ Q = 1 on polynomials of total degree 2"


ROUTES = [
    ("bilinear", 0, "smooth", {"order": 1}, "φ is continuous because S converges"),
    ("bilinear", 0, "holder-lower", {"bound": "1/2"}, "another length or bound"),
    ("bilinear", 0, "holder-lower", {"length": 2}, "another length or bound"),
    ("bilinear", 0, "holder-upper", {"bound": "1/8"}, "another length or bound"),
    ("bilinear", 1, "holder-upper", {"bound": "1/4"}, "another length or bound"),
    ("bilinear", 0, "not-smooth", {"order": 1}, "the Sobolev exponent is too large"),
    ("bilinear", 0, "sobolev-at-least", {"bound": "1/4"}, "another length or bound"),
    ("bilinear", 0, "sobolev-at-most", {"bound": "1/4"}, "another length or bound"),
    ("bilinear", 1, "sobolev-at-most", {"length": 1}, "another length or bound"),
    ("bilinear", 0, "directional-decay", {"norm": "1/5"}, "a norm is not small enough"),
    ("bilinear", 0, "directional-decay", {"norm": "-1"}, "the bound is not positive"),
    ("bilinear", 0, "directional-decay", {"order": 2}, "not pair-norm"),
    ("bilinear", 0, "directional-decay", {"order": 3}, "the order is not 1 or 2"),
    ("bilinear", 0, "directional-decay", {"level": 65}, "the level is not one of"),
    ("butterfly", 0, "directional-decay", {"order": 1}, "not directional-norm"),
    ("butterfly", 0, "directional-decay", {"norm": "1/8"}, "a norm is not small enough"),
    ("haar", 0, "box-holder", {"value": 1}, "d = 1"),
]
"""Rules by another claim than that of a family: the number of the claim among those with such uses, from the end."""


def by_routes(name, place, rule):
    """The number of the claim: those by routes come last, in the order of `ROUTES`."""
    claims = MADE[name]["claims"]
    alike = [i for i, c in enumerate(claims) if c["rule"] == rule]
    first = (
        {"holder-lower": 1, "holder-upper": 1, "smooth": 1, "not-smooth": 2}.get(rule, 0) if name == "bilinear" else 0
    )
    return alike[first + place]


@pytest.mark.parametrize(("name", "place", "rule", "changes", "words"), ROUTES)
def test_other_routes_are_forged(name, place, rule, changes, words):
    made, number = copy.deepcopy(MADE[name]), by_routes(name, place, rule)
    forged = made["claims"][number]["statement"]
    made["goal"] = [forged]
    assert check_document(made).verified
    forged.update(changes)
    rejected(made, number, words)


def test_what_a_route_rests_on():
    """Not that S diverges, not a φ that is C^0 only by name, no unstable φ, no directions that are no basis."""
    made = copy.deepcopy(MADE["haar"])
    number = next(i for i, c in enumerate(made["claims"]) if c["rule"] == "diverges")
    made["claims"].append(claim("smooth", [number], order=0))
    rejected(made, len(made["claims"]) - 1, "φ is continuous because S converges")
    made["claims"][-1] = claim("holder-lower", [number], length=1, bound="1")
    rejected(made, len(made["claims"]) - 1, "S does not converge")
    made = copy.deepcopy(MADE["zwart_powell"])
    unstable = next(i for i, c in enumerate(made["claims"]) if c["rule"] == "gram-unstable")
    made["claims"].append(claim("holder-upper", [1, unstable], length=2, bound="1/16"))
    rejected(made, len(made["claims"]) - 1, "another holds")
    made["claims"][-1] = claim("sobolev-at-most", [1, unstable], length=2, bound="1/16")
    rejected(made, len(made["claims"]) - 1, "another holds")
    jumps = next(i for i, c in enumerate(made["claims"]) if c["rule"] == "box-not-smooth")
    made["claims"][-1] = claim("diverges", [jumps], property="convergent", holds=False)
    rejected(made, len(made["claims"]) - 1, "φ may be continuous")
    made = copy.deepcopy(MADE["bilinear"])
    decay = next(c for c in made["claims"] if c["rule"] == "directional-decay")
    decay["uses"][2] = decay["uses"][1]
    rejected(made, made["claims"].index(decay), "not a basis")


def test_every_rule_is_forged():
    assert {rule for _, rule, _, _ in FORGED} | {rule for _, _, rule, _, _ in ROUTES} >= OWN_RULES


def of(name, *claims):
    return document(name, list(claims))


def structure(k):
    return [claim("coset-sums", holds=k > 0), claim("total-sum-rules", order=k)]


def test_the_worked_example_of_differences():
    """By hand, MULTIVARIATE.md: the mask 1, 1, 1, 1 of the square, b_0 = δ_(0,0) - δ_(1,0), b_1 = δ_(0,1) - δ_(1,0)."""
    found = {
        "cosets": [[0, 0], [0, 1], [1, 0], [1, 1]],
        "window": [[0, 0], [0, 1], [1, 0]],
        "basis": [[1, 0, -1], [0, 1, -1]],
        "matrices": [
            [["1", "0"], ["0", "1"]],
            [["1", "1"], ["0", "0"]],
            [["0", "-1"], ["0", "1"]],
            [["0", "0"], ["0", "0"]],
        ],
        "generators": [["1", "-1"], ["1", "0"]],
    }
    claims = [
        *structure(1),
        claim("differences", [1], found, WORK, "family", family=0, order=1),
        claim("word", witness={"word": [0]}, property="radius-lower", family=0, length=1, bound="1"),
        claim("diverges", [3, 2], property="convergent", holds=False),
    ]
    assert check_document(of("haar", *claims)).verified


def test_matrices_beyond_order_64_and_no_further():
    """A basis of 120 rows is read, one of 121 is not."""
    for order, words in ((120, "another order than the basis"), (121, "too long")):
        made = of("haar", *structure(1), differences("haar", 1, 1))
        made["claims"][2]["witness"]["matrices"] = [[["0"] * order] * order] * 4
        rejected(made, 2, words)


def test_long_denominators_of_many_entries():
    """Over a common denominator each of 25,600 entries would have 66,000 bits."""
    made = of("haar", *structure(1), differences("haar", 1, 1))
    matrices = [[["0"] * 20 for _ in range(20)] for _ in range(64)]
    matrices[0][0][0] = "1/" + "9" * 19_999
    made["claims"][2]["witness"]["matrices"] = matrices
    rejected(made, 2, "common denominator that is too large")


def test_large_windows_for_many_terms_are_not_looked_at():
    made = of("haar", *structure(1), differences("haar", 1, 1))
    made["mask"]["terms"] = [[[i, j], "1/100"] for i in range(20) for j in range(20)]
    made["claims"][1]["statement"]["order"] = 1
    found = made["claims"][2]["witness"]
    found["window"] = [[i, j] for i in range(50) for j in range(60)]
    found["basis"] = [[0] * 3000, [0] * 3000]
    made["claims"][2]["work"] = 40_000_000
    rejected(made, 2, "too large for so many terms")


def test_dependent_rows_with_all_identities_true():
    """The first row of the basis a second time."""
    made = of("bilinear", *structure(2), differences("bilinear", 2, 1))
    found = made["claims"][2]["witness"]
    found["basis"].append(found["basis"][0])
    found["matrices"] = [
        [*([*row, row[0]] for row in matrix), ["0"] * (len(matrix) + 1)] for matrix in found["matrices"]
    ]
    found["generators"] = [[*row, "0"] for row in found["generators"]]
    rejected(made, 2, "row 8 of the basis depends")


def test_a_smaller_space_that_the_operators_leave_is_rejected():
    """One row less, and all that names it."""
    made = of("bilinear", *structure(2), differences("bilinear", 2, 1))
    found = made["claims"][2]["witness"]
    found["basis"].pop()
    found["matrices"] = [[row[:-1] for row in matrix[:-1]] for matrix in found["matrices"]]
    found["generators"] = [row[:-1] for row in found["generators"]]
    rejected(made, 2, "coordinates of the difference")


def test_the_smallest_invariant_window_is_too_small():
    """There ∇² has no room, and nothing is left of the bilinear B-spline: it would be C^∞."""
    made = of("bilinear", *structure(2))
    window = [[i, j] for i in (-1, 0, 1) for j in (-1, 0, 1)]
    basis = [[1, -2, 1, 0, 0, 0, 0, 0, 0]]
    matrices = [[["0"]]] * 4
    generators = [["1"], ["0"], ["0"]]
    space = {
        "cosets": [[0, 0], [0, 1], [1, 0], [1, 1]],
        "window": window,
        "basis": basis,
        "matrices": matrices,
        "generators": generators,
    }
    made["claims"].append(claim("differences", [1], space, WORK, "family", family=0, order=2))
    rejected(made, 2, "the window does not contain the support of the difference (0, 2)")


def test_images_that_leave_the_window():
    """A window with room for the differences, and none for their images: the mask is moved away."""
    made = of("haar", *structure(1), differences("haar", 1, 1))
    for term in made["mask"]["terms"]:
        term[0] = [term[0][0] + 8, term[0][1]]
    rejected(made, 2, "leaves the window")


def test_a_larger_window_changes_nothing():
    made = of("haar", *structure(1), differences("haar", 1, 1))
    found = made["claims"][2]["witness"]
    found["window"].append([50, -50])
    found["basis"] = [[*row, 0] for row in found["basis"]]
    assert check_document(made).verified


@pytest.mark.parametrize(
    ("matrix", "isotropic"),
    [
        ([[2, 0], [0, 2]], True),
        ([[1, 1], [1, -1]], True),
        ([[1, -1], [1, 1]], True),
        ([[1, -2], [1, 0]], True),
        ([[2, -1], [1, -2]], True),
        ([[0, 2], [1, 0]], True),
        ([[-3, 0], [0, -3]], True),
        ([[2, 0], [0, 3]], False),
        ([[2, 1], [0, 2]], False),
        ([[3, 1], [1, 3]], False),
        ([[2, 0, 0], [0, 2, 0], [0, 0, 2]], True),
        ([[0, 0, 2], [1, 0, 0], [0, 1, 0]], True),
        ([[2, 1, 0], [0, 2, 0], [0, 0, 2]], False),
        ([[0, 0, 0, 2], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], True),
    ],
)
def test_isotropic_dilations(matrix, isotropic):
    assert DilationMatrix(matrix, *inverse(matrix)).is_isotropic() is isotropic


def test_without_an_isotropic_dilation_nothing_follows_for_smoothness():
    """The anisotropic bilinear B-spline: it converges, with radius 1/2 for order 2, and nothing is said of α."""
    claims = [*structure(2), differences("anisotropic", 2, 1)]
    for rule, fields, uses in [
        ("smooth", {"order": 1}, [3, 2]),
        ("not-smooth", {"order": 1}, [3, 2]),
        ("holder-lower", {"length": 1, "bound": "1/2"}, [3, 2]),
        ("holder-upper", {"length": 1, "bound": "1/2"}, [3, 2, 1]),
        ("holder-root", {"length": 1, "polynomial": ["-1", "2"], "low": "1/2", "high": "1/2"}, [3, 2, 1]),
    ]:
        made = of("anisotropic", *claims, trivial_bound(), claim(rule, uses, **fields))
        rejected(made, 4, f"claim 4 ({rule}): the dilation is not seen to be isotropic")
    made = of("sheared", *structure(1), claim("smooth", [1, 1], order=1))
    rejected(made, 2, "not seen to be isotropic")
    bound, proved = radius("anisotropic", 2, 3)
    converges, last = 3 + len(bound), 4 + len(bound)
    said = claim("converges", [proved, 2], property="convergent", holds=True)
    made = of("anisotropic", *claims, *bound, said, claim("smooth", [converges], order=0))
    assert check_document(made).verified
    made["claims"][-1] = claim("smooth", [proved, 2], order=0)
    rejected(made, last, "not seen to be isotropic")


def trivial_bound():
    """JSR >= 1/1000, by a word of one letter."""
    return claim("word", witness={"word": [0]}, work=WORK, property="radius-lower", family=0, length=1, bound="1/1000")


def test_thresholds_are_strict():
    """ρ = 1/2 and λ = 2: not C^1, and no more; ρ = 1 is no convergence."""
    made = copy.deepcopy(MADE["haar"])
    root = next(i for i, c in enumerate(made["claims"]) if c["rule"] == "diverges")
    uses = made["claims"][root]["uses"]
    made["claims"][root] = claim("converges", uses, property="convergent", holds=True)
    rejected(made, root, "radius is not small enough")


def test_an_upper_bound_needs_stability():
    """Of the 4-8 scheme the formula for stable φ would give α = 4; it is 5."""
    for rule in ("holder-upper", "holder-root"):
        made = copy.deepcopy(MADE["four_eight"])
        claims = made["claims"]
        lower = next(c for c in claims if c["rule"] == "holder-lower")
        stable = len(claims) - 1
        fields = {"length": 1, "bound": "1/4"}
        if rule == "holder-root":
            fields = {"length": 1, "polynomial": ["-1", "4"], "low": "1/4", "high": "1/4"}
        claims.append(claim(rule, [*lower["uses"], 1, stable], **fields))
        rejected(made, len(claims) - 1, "it uses stable with another holds")


def test_a_lattice_must_hold_its_image():
    """u = (1, 0) vanishes modulo 2 on the differences of these indices, (0, 1), but not on M (0, 1) = (1, -1)."""
    witness = {"functional": [1, 0], "modulus": 2}
    made = of("halves", claim("sublattice-diverges", witness=witness, work=WORK, property="convergent", holds=False))
    rejected(made, 0, "does not vanish on the differences")


@pytest.mark.parametrize(("name", "words"), [("moved", None), ("perturbed", "no coset has one coefficient only")])
def test_an_interpolatory_mask_interpolates(name, words):
    """Both converge, by their directional factors; the shift of an interpolatory mask is as stable as that."""
    factors = []
    for x in ((1, 0), (0, 1)):
        d = quotient(name, *x)
        fields = {"direction": list(x), "level": 1, "norm": q(norm(d, 2, 1))}
        factors.append(claim("directional-norm", witness={"quotient": d}, work=WORK, **fields))
    converges = claim("directional-converges", [0, 1, 2], property="convergent", holds=True)
    claims = [claim("coset-sums", holds=True), *factors, converges]
    assert check_document(of(name, *claims)).verified
    made = of(name, *claims, claim("interpolatory-stable", [3], property="stable", holds=True))
    if words is None:
        assert check_document(made).verified
    else:
        rejected(made, 4, words)


def test_a_smaller_growth_than_the_largest_is_not_that_of_the_mean_squares():
    """Of the bilinear B-spline 1/16 and 1/32 are zeros of the polynomial as well: they would give s = 2 and 5/2."""
    for zero in (16, 32):
        made = copy.deepcopy(MADE["bilinear"])
        number = next(i for i, c in enumerate(made["claims"]) if c["rule"] == "surface-sobolev")
        f = [Fraction(-1), Fraction(zero)]
        cofactor = [q(c) for c in divided(annihilator("bilinear", 2), f)]
        made["claims"][number]["witness"]["cofactor"] = line(*cofactor)
        at = q(Fraction(1, zero))
        made["claims"][number]["statement"] |= {"polynomial": line("-1", str(zero)), "low": at, "high": at}
        rejected(made, number, "the cofactor is not seen to be positive")


def test_a_zero_that_is_no_pole():
    """(z - 1) f annihilates too."""
    made = copy.deepcopy(MADE["bilinear"])
    number = next(i for i, c in enumerate(made["claims"]) if c["rule"] == "surface-sobolev")
    made["claims"][number]["witness"]["cofactor"] = line(*map(q, annihilator("bilinear", 2)))
    made["claims"][number]["statement"] |= {"polynomial": line("-1", "1"), "low": "1", "high": "1"}
    rejected(made, number, "poles for all its zeros")


def test_the_exponent_in_the_mean_needs_an_isotropic_dilation_and_sum_rules():
    found = {"cofactor": line("1")}
    said = {"property": "sobolev-lower", "polynomial": line("-1", "8"), "low": "1/8", "high": "1/8"}
    made = of("anisotropic", *structure(2), claim("surface-sobolev", [1], found, WORK, **said))
    rejected(made, 2, "not seen to be isotropic")
    made = of("flat", *structure(0), claim("surface-sobolev", [1], found, WORK, **said))
    rejected(made, 2, "the sum rules are of order 0")


def test_mean_squares_that_decay_too_slowly_prove_no_convergence():
    """Of the square s = 1/2, so m Λ = 2."""
    said = {"property": "sobolev-lower", "polynomial": line("-1", "2"), "low": "1/2", "high": "1/2"}
    mean = claim("surface-sobolev", [1], {"cofactor": line("1")}, WORK, **said)
    assert check_document(of("haar", *structure(1), mean)).verified
    converges = claim("converges", [2], property="convergent", holds=True)
    rejected(of("haar", *structure(1), mean, converges), 3, "radius is not small enough")


def matrix_norm(entries, level, norm, order=1, power=1):
    found = {"power": power, "entries": entries}
    return claim("matrix-norm", [1], found, WORK, order=order, level=level, norm=norm)


def test_the_worked_example_of_matrix_norms():
    """MULTIVARIATE.md: the norms are 1, 1 and 27/32, and only the last proves convergence; none of them C^1."""
    for level, norm_ in ((1, "1"), (2, "1"), (3, "27/32")):
        claims = [*structure(2), matrix_norm(quincunx_reduction(), level, norm_)]
        assert check_document(of("quincunx", *claims)).verified
        converges = of("quincunx", *claims, claim("converges", [2], property="convergent", holds=True))
        assert check_document(converges).verified is (level == 3)
        rejected(of("quincunx", *claims, claim("smooth", [2], order=1)), 3, "differences are of order 1")


def test_a_matrix_scheme_of_another_mask_or_order_reduces_nothing():
    """That of Courant's hat is diagonal; without sum rules there is none, whatever stands there."""
    half = [[[0, 0], "1/2"]]
    rejected(of("haar", *structure(1), matrix_norm([half, [], [], half], 1, "1/2")), 2, "no reduction: row (0, 1)")
    rejected(of("flat", *structure(0), matrix_norm([half, [], [], half], 1, "1/2")), 2, "of order 0")


def test_haar_has_no_contracting_matrix_scheme():
    """Its diagonal one has norm 1, which is no convergence."""
    rows = [[[[0, 0], "1"], [[1, 0], "1"]], [], [], [[[0, 0], "1"], [[0, 1], "1"]]]
    claims = [*structure(1), matrix_norm(rows, 5, "1")]
    assert check_document(of("haar", *claims)).verified
    rejected(of("haar", *claims, claim("converges", [2], property="convergent", holds=True)), 3, "not small enough")


def test_smoothness_by_matrix_norms_needs_an_isotropic_dilation():
    """The anisotropic hat: Q is diagonal with the norms 1/2 and 1/3."""
    second, first = quotient_of_anisotropic()
    claims = [*structure(2), matrix_norm([second, [], [], first], 1, "1/2")]
    assert check_document(
        of("anisotropic", *claims, claim("converges", [2], property="convergent", holds=True))
    ).verified
    rejected(of("anisotropic", *claims, claim("smooth", [2], order=0)), 3, "not seen to be isotropic")


def quotient_of_anisotropic():
    """a/(1 + z_2 + z_2²) and a/(1 + z_1)."""
    return quotient("anisotropic", 0, 1, count=3), quotient("anisotropic", 1, 0)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("haar", "a side of the box is shorter than 2"),
        ("courant", "not a whole box"),
        ("quincunx", "not a multiple of the identity"),
        ("four_eight", "not a multiple of the identity"),
        ("perturbed", "a coefficient is negative"),
        ("half_haar", "a side of the box is shorter than 2"),
    ],
)
def test_what_is_no_positive_mask_on_a_box(name, words):
    made = of(
        name, claim("coset-sums", holds=True), claim("positive-converges", [0], property="convergent", holds=True)
    )
    rejected(made, 1, words)


def test_norms_of_pairs_that_are_not_below_one():
    """At level 1 the butterfly scheme has the norm 1."""
    claims = [claim("coset-sums", holds=True)]
    for pair in PAIRS:
        fields = {"directions": [list(x) for x in pair], "level": 1, "norm": "1"}
        claims.append(claim("pair-norm", witness={"quotient": pair_quotient("butterfly", *pair)}, work=WORK, **fields))
    claims.append(claim("directional-smooth", [0, 1, 2, 3], property="smooth", order=1))
    rejected(of("butterfly", *claims), 4, "a norm is not below 1")


def test_directions_that_are_no_bases():
    """The quotients of Zwart and Powell's mask contract, but det((1, 1), (1, -1)) = -2."""
    claims = [claim("coset-sums", holds=True)]
    for pair in itertools.combinations([(0, 1), (1, -1), (1, 1)], 2):
        found = pair_quotient("zwart_powell", *pair)
        level = next(n for n in range(1, 9) if pair_norm(found, n) < 1)
        fields = {"directions": [list(x) for x in pair], "level": level, "norm": q(pair_norm(found, level))}
        claims.append(claim("pair-norm", witness={"quotient": found}, work=WORK, **fields))
    claims.append(claim("directional-smooth", [0, 1, 2, 3], property="smooth", order=1))
    rejected(of("zwart_powell", *claims), 4, "not a basis of Z^s")


def spline(directions, power=1, shift=(0, 0), scale=2):
    found = {"power": power, "shift": list(shift)}
    return claim("box-spline", witness=found, work=WORK, directions=sorted(map(list, directions)), scale=scale)


def test_a_number_between_exponents_may_have_a_long_numerator():
    made = copy.deepcopy(MADE["chaikin_hat"])
    next(c for c in made["claims"] if c["rule"] == "of-factor")["witness"]["between"] = "1501/1000"
    assert check_document(made).verified


def test_a_factor_that_asks_too_much_is_not_said_to_be_wrong():
    made = copy.deepcopy(MADE["chaikin_hat"])
    number = next(i for i, c in enumerate(made["claims"]) if c["rule"] == "tensor-product")
    inside = made["claims"][number]["witness"]["certificates"][1]["claims"]
    inside += [{**inside[0], "work": 0}] * 10_001
    assert rejected(made, number, "certificate 1", "too many claims").exhausted


def test_parallel_directions_are_counted_whatever_their_length_and_sign():
    """(-1, 0), (1, 0), (2, 0) are one line: without (0, 1) nothing is spanned, d = 1."""
    shown = spline([(-1, 0), (1, 0), (2, 0), (0, 1)])
    assert check_document(of("parallel", shown, claim("box-not-smooth", [0], property="not-smooth", order=0))).verified
    rejected(of("parallel", shown, claim("box-smooth", [0], property="smooth", order=0)), 1, "d = 1")
    rejected(of("parallel", shown, claim("box-smooth", [0], property="smooth", order=1)), 1, "d = 1")
    rejected(of("parallel", shown, claim("box-holder", [0], property="holder-value", value=1)), 1, "d = 1")
    assert check_document(of("parallel", shown, claim("box-holder", [0], property="holder-value", value=0))).verified
    rejected(of("parallel", shown, claim("box-stable", [0], property="stable", holds=True)), 1, "not unimodular")


def test_a_measure_on_a_line_is_no_box_spline():
    rejected(of("line", spline([(1, 0), (1, 0)])), 0, "do not span")


def test_the_sign_of_the_mask_is_seen():
    """a(z) a(z^M) is the same for -a."""
    directions = [(1, 0), (1, 0), (0, 1), (0, 1), (1, 1), (1, 1), (1, -1), (1, -1)]
    assert check_document(of("four_eight", spline(directions, 2))).verified
    rejected(of("negative", spline(directions, 2)), 0, "do not add up to m")


def with_mask(**changes):
    made = copy.deepcopy(MADE["flat"])
    made["mask"] |= changes
    return made


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"dilation": [[2, 0], [0, 1]]}, "not expanding"),
        ({"dilation": [[1, 1], [1, 1]]}, "singular"),
        ({"dilation": [[2, 1], [1, 1]]}, "not expanding"),
        ({"dilation": [[2, 0]]}, "square"),
        ({"dilation": [[2, 0], [0, 2, 0]]}, "square"),
        ({"dilation": [[2]]}, "square"),
        ({"dilation": [[65, 0], [0, 65]]}, "determinant"),
        ({"dilation": [[2, 0], [0, 2_000_000]]}, "out of range"),
        ({"dilation": [[True, 0], [0, 2]]}, "not an integer"),
        ({"dilation": 2}, "not a list"),
        ({"terms": []}, "empty"),
        ({"terms": [[[0, 0], "0"]]}, "zero"),
        ({"terms": [[[0, 0], "1"], [[0, 0], "1"]]}, "do not increase"),
        ({"terms": [[[0, 1], "1"], [[0, 0], "1"]]}, "do not increase"),
        ({"terms": [[[0, 0, 0], "1"]]}, "not one of Z^2"),
        ({"terms": [[[0], "1"]]}, "not one of Z^2"),
        ({"terms": [[[0, 1_000_001], "1"]]}, "out of range"),
        ({"terms": [[[0, 0], 1]]}, "not a string"),
        ({"terms": [[[0, 0], "2/4"]]}, "lowest terms"),
        ({"terms": [[[0, 0], "1", "1"]]}, "too long"),
        ({"terms": [[[0, 0]]]}, "not a pair"),
        ({"terms": {"0,0": "1"}}, "not a list"),
        ({"arity": 2}, "unknown key"),
    ],
)
def test_what_is_no_mask(changes, words):
    outcome = check_document(with_mask(**changes))
    assert outcome.line.startswith("NOT VERIFIED document: ")
    assert words in outcome.line


def test_residues_tell_the_cosets_apart():
    for matrix, terms in MASKS.values():
        pairs = [(x, value) for x, value in terms.items()]
        dilation = multivariate_mask([tuple(row) for row in matrix], pairs).dilation
        inside = [(i, j) for i in range(-4, 5) for j in range(-4, 5)] if len(matrix) == 2 else [(1, 2, 3), (-1, 0, 4)]
        for x in inside:
            image = tuple(sum(a * b for a, b in zip(row, x, strict=True)) for row in matrix)
            assert dilation.divided(image) == x
            assert not any(dilation.residue(image))
        if len(matrix) == 2:
            assert len({dilation.residue(x) for x in inside}) == dilation.cosets


def test_rules_of_multivariate_masks_prove_nothing_of_other_kinds():
    made = copy.deepcopy(MADE["flat"])
    made["mask"] = {"kind": "matrices", "matrices": [[["1"]]]}
    assert not check_document(made).verified
    made["mask"] = {"kind": "scalar", "arity": 2, "start": 0, "coefficients": ["1", "1"]}
    assert not check_document(made).verified


def test_a_certificate_of_another_mask_is_no_proof():
    for name in ("bilinear", "zwart_powell", "butterfly", "quincunx"):
        made = copy.deepcopy(MADE[name])
        made["mask"]["terms"][0][1] = "1/7"
        assert not check_document(made).verified
        made = copy.deepcopy(MADE[name])
        made["mask"]["dilation"][0][0] += 1
        assert not check_document(made).verified


SCHEMA = json.loads((Path(subdiv_cli.__file__).parent / "certificate" / "schema.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", ALL_MULTIVARIATE)
def test_the_schema_describes_them(name):
    jsonschema.validate(json.loads(json.dumps(MADE[name])), SCHEMA)


@pytest.mark.parametrize(
    "change",
    [
        lambda made: made["mask"].update(dilation=2),
        lambda made: made["mask"]["terms"][0].append("1"),
        lambda made: made["mask"]["terms"].__setitem__(0, [[0], "1"]),
        lambda made: made["claims"][0]["statement"].update(order=1),
        lambda made: made["claims"][3]["witness"].pop("window"),
        lambda made: made["claims"][3]["witness"]["cosets"].__setitem__(0, [0]),
        lambda made: made["claims"][3]["witness"]["basis"][0].__setitem__(0, "1"),
        lambda made: made["claims"][0].update(rule="coset-sum"),
    ],
)
def test_the_schema_describes_nothing_else(change):
    made = json.loads(json.dumps(MADE["bilinear"]))
    change(made)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(made, SCHEMA)
    assert not check_document(made).verified


def test_every_rule_is_in_the_schema():
    rules = SCHEMA["properties"]["claims"]["items"]["properties"]["rule"]["enum"]
    assert set(rules) == {name for kind in KINDS for name in KINDS[kind].rules}
    named = [s["properties"]["property"] for s in SCHEMA["$defs"]["statement"]["oneOf"]]
    properties = {name for each in named for name in each.get("enum", [each.get("const")])}
    assert properties == {name for kind in KINDS for name in KINDS[kind].properties}
