"""Every rule: it accepts what is true (FORMAT.md's examples too), and a forged statement or witness is rejected."""

import json
from pathlib import Path

import pytest
from hand_made import ALL, chaikin, claim, document, poly, sobolev, text
from hand_made_radius import OF_RADII

from subdiv_cli.checker import KINDS, check_document, check_text

BY_HAND = Path(__file__).parents[1] / "certificate" / "chaikin_by_hand.json"


def test_chaikin_by_hand():
    outcome = check_text(BY_HAND.read_text(encoding="utf-8"))
    assert outcome.verified
    assert outcome.claim is None
    assert outcome.line == ("VERIFIED S converges; φ is C^1; φ is not C^2; α = 2; sum rules of order 3; φ is stable")
    assert outcome.statements == tuple(json.loads(BY_HAND.read_text(encoding="utf-8"))["goal"])


@pytest.mark.parametrize("name", ALL)
def test_true_certificates_are_verified(name):
    outcome = check_text(text(ALL[name]()))
    assert outcome.line.startswith("VERIFIED ")
    assert outcome.verified


def test_every_rule_is_in_some_true_certificate():
    assert {c["rule"] for make in ALL.values() for c in make()["claims"]} == set(KINDS["scalar"].rules) - OF_RADII


def forge(name, number, statement=None, **changes):
    """A certificate with one claim changed, and the goal with it, so that only the claim itself can be wrong."""
    certificate = ALL[name]()
    c = certificate["claims"][number]
    c["statement"].update(statement or {})
    c.update(changes)
    certificate["goal"] = [c["statement"]]
    return certificate, number, c["rule"]


def bezout(*cofactors, **rest):
    return {"witness": {"cofactors": list(cofactors), **rest}}


FORGED = [
    forge("chaikin", 20, uses=[19]),
    forge("chaikin", 20, uses=[19, 9]),
    forge("chaikin", 21, {"order": 2}),
    forge("chaikin", 22, {"order": 2}),
    forge("chaikin", 23, {"norm": "1/32"}),
    forge("chaikin", 23, {"level": 3}),
    forge("chaikin", 24, {"radius": "1/16"}),
    forge("chaikin", 24, {"length": 1}),
    forge("chaikin", 25, {"norm": "1/8"}),
    forge("chaikin", 25, uses=[5]),
    forge("chaikin", 26, {"bound": "1/32"}),
    forge("chaikin", 26, {"length": 1}),
    forge("chaikin", 26, uses=[16]),
    forge("chaikin", 27, {"bound": "1/16"}),
    forge("chaikin", 27, {"length": 1}),
    forge("chaikin", 27, uses=[15]),
    forge("chaikin", 28, {"bound": "1/4"}),
    forge("chaikin", 28, uses=[10]),
    forge("cycle", 10, uses=[9]),
    forge("cycle", 10, {"holds": True}),
    forge("chaikin", 0, {"sums": ["1", "3/4"]}),
    forge("chaikin", 0, {"sums": ["1"]}),
    forge("chaikin", 1, {"order": 4}),
    forge("chaikin", 1, {"order": 2}),
    forge("chaikin", 1, {"order": 2}, witness={"quotient": poly(-1, 1, 1, over=4)}),
    forge("chaikin", 1, witness={"quotient": poly(0, "1/4")}),
    forge("chaikin", 1, witness={"quotient": poly(0)}),
    forge("divergent", 1, {"order": 1}),
    forge("divergent", 1, witness={"quotient": poly(1, 1, 1, 1, over=2)}),
    forge("chaikin", 2, {"symbol": poly(1, 1, 2, 1, over=2)}),
    forge("chaikin", 2, {"symbol": poly(0, 1, 2, 1, over=4)}),
    forge("chaikin", 2, {"nu": 2}),
    forge("chaikin", 2, {"nu": 0, "symbol": poly(-1, 1, 3, 3, 1, over=4)}),
    forge("chaikin", 2, {"nu": 4, "symbol": poly(0)}),
    forge("chaikin", 3, {"degree": 3}),
    forge("divergent", 2, {"degree": 0}),
    forge("chaikin", 4, {"degree": 2}),
    forge("chaikin", 4, {"degree": 0}),
    forge("four_point", 14, {"degree": 4}),
    forge("divergent", 4, {"degree": 0}),
    forge("divergent", 4, {"degree": -2}),
    forge("chaikin", 5, {"norm": "1/4"}),
    forge("chaikin", 5, {"level": 2}),
    forge("chaikin", 5, {"level": 0, "norm": "1"}),
    forge("chaikin", 5, {"nu": 0}),
    forge("chaikin", 5, {"nu": 4}),
    forge("four_point", 3, {"level": 3}),
    forge("chaikin", 7, {"radius": "1/3"}),
    forge("chaikin", 7, {"radius": "0"}),
    forge("chaikin", 7, {"radius": "-1"}),
    forge("chaikin", 7, {"word": []}),
    forge("chaikin", 7, {"word": [2]}),
    forge("chaikin", 7, {"word": [0, 0, 0]}),
    forge("four_point", 11, {"radius": "1000001/64000000"}),
    forge("four_point", 11, {"word": [0, 1, 0]}),
    forge("chaikin", 8, {"holds": False}),
    forge("chaikin", 8, {"nu": 3}),
    forge("four_point", 12, {"holds": False}),
    forge("four_point", 13, {"holds": True}),
    forge("overshooting", 3, {"holds": True}),
    forge("ternary", 14, {"nu": 2}),
    forge("chaikin", 9, **bezout(poly(0, "3/2"), poly(0, "-1/2"))),
    forge("chaikin", 9, **bezout(poly(0), poly(0))),
    forge("chaikin", 9, **bezout(poly(0, "3/2"))),
    forge("chaikin", 9, **bezout(poly(0, "3/2"), poly(1, "-1/2"), poly(0))),
    forge("unstable", 1, rule="independent", **bezout(poly(0), poly(0, 2))),
    forge("unstable", 1, witness={"factor": poly(0, -1, 1)}),
    forge("unstable", 1, witness={"factor": poly(0, 0, 1, 0)}),
    forge("unstable", 1, witness={"factor": poly(0)}),
    forge("unstable", 1, witness={"factor": poly(0, 1, 2, 1)}),
    forge("unstable", 1, witness={"cycle": 3}),
    forge("cycle", 0, witness={"cycle": 5}),
    forge("cycle", 0, witness={"cycle": 1}),
    forge("cycle", 0, witness={"cycle": 6}),
    forge("cycle", 0, witness={"factor": poly(0, 1, 1)}),
    forge("off_circle", 0, witness={"factor": poly(0, 3, 1)}),
    forge("off_circle", 1, **bezout(poly(0), poly(0, 3), gcd=poly(0, 1))),
    forge("off_circle", 1, **bezout(poly(0), poly(0, "3/2"), gcd=poly(0, 2, 1))),
    forge("off_circle", 1, **bezout(poly(0), poly(0), gcd=poly(0))),
    forge("off_circle", 1, **bezout(poly(0), poly(0, 3, 3), gcd=poly(0, 2, 3, 1))),
    forge("unstable", 2, witness={"factor": poly(0, 2)}),
    forge("unstable", 2, witness={"factor": poly(0, 2, 1)}),
    forge("unstable", 2, witness={"cycle": 3}),
    forge("off_circle", 1, {"holds": False}, rule="unstable", witness={"factor": poly(0, 2, 1)}),
    forge("cycle", 1, witness={"cycle": 7}),
    forge("unstable", 7, witness={"factor": poly(0, 1, 1), "mask": poly(0, 1, 1)}),
    forge("unstable", 7, witness={"factor": poly(0, 1, 1), "mask": poly(1, 1, 2, 1, over=2)}),
    forge("unstable", 7, witness={"factor": poly(0, 1, -1), "mask": poly(0, 1, 0, 1, over=2)}),
    forge("unstable", 7, witness={"factor": poly(0), "mask": poly(0)}),
    forge("unstable", 7, {"to": 2}),
    forge("unstable", 7, {"to": 0}),
    forge("unstable", 7, {"from": 1}),
    forge("unstable", 6, uses=[9]),
    forge("unstable", 6, uses=[3]),
    forge("overshooting", 2, uses=[0]),
    forge("chaikin", 11, {"holds": False}, rule="diverges", uses=[0]),
    forge("chaikin", 11, {"holds": False}, rule="diverges", uses=[7]),
    forge("chaikin", 11, {"holds": False}, rule="diverges", uses=[8]),
    forge("four_point", 6, {"holds": False}, rule="diverges", uses=[5]),
    forge("chaikin", 12, {"order": 2}),
    forge("chaikin", 12, {"order": 2}, uses=[6]),
    forge("ternary", 13, {"order": 2}),
    forge("unstable", 10, uses=[9]),
    forge("unstable", 10, {"order": 1}),
    forge("chaikin", 13, {"order": 1}),
    forge("chaikin", 14, {"order": 2}),
    forge("unstable", 14, uses=[12, 13]),
    forge("unstable", 14, {"order": 0}),
    forge("chaikin", 15, {"norm": "1/17"}),
    forge("chaikin", 15, {"level": 1}),
    forge("chaikin", 15, {"norm": "1/8"}, uses=[5, 1]),
    forge("unstable", 16, uses=[15, 8]),
    forge("chaikin", 16, {"radius": "1/3"}),
    forge("chaikin", 16, {"length": 2}),
    forge("chaikin", 17, {"radius": "1/4"}),
    forge("chaikin", 17, {"length": 2}),
    forge("cycle", 9, uses=[1, 7, 2]),
    forge("cycle", 9, uses=[4, 7]),
    forge("chaikin", 18, {"norm": "1/8"}),
    forge("chaikin", 18, {"level": 1}),
    forge("chaikin", 18, uses=[15, 17]),
    forge("ternary", 11, {"norm": "1/27"}),
    forge("chaikin", 19, {"low": "1/64"}, witness={"cofactor": poly(0, 0, 1)}),
    forge("chaikin", 19, {"low": "1/64", "high": "1/64"}),
    forge("chaikin", 19, {"polynomial": poly(0, "-1/64", 1), "low": "1/64", "high": "1/64"}),
    forge("chaikin", 19, {"polynomial": poly(0, "-1/16", 1), "low": "1/16", "high": "1/16"}),
    forge("chaikin", 19, {"polynomial": poly(0, "1/32", -1)}),
    forge("chaikin", 19, {"polynomial": poly(0, 1)}),
    forge("chaikin", 19, {"polynomial": poly(0)}),
    forge("chaikin", 19, {"polynomial": poly(1, "-1/32", 1)}),
    forge("chaikin", 19, {"low": "0", "high": "1"}),
    forge("chaikin", 19, {"low": "-1/32"}),
    forge("chaikin", 19, witness={"cofactor": poly(0)}),
    forge("chaikin", 19, witness={"cofactor": poly(0, -1)}),
    forge("chaikin", 19, uses=[10, 1, 1]),
    forge("chaikin", 19, uses=[9, 1]),
    forge("chaikin", 19, work=8),
    # the smaller zero -1/512 of the characteristic polynomial, and the larger one as a zero of the cofactor
    forge("four_point", 15, {"polynomial": poly(0, 1, 512), "low": "1/1024", "high": "1"}),
    forge("four_point", 15, {"polynomial": poly(0, "1/512", 1)}, witness={"cofactor": poly(0, -1, -40, 2048)}),
    forge("four_point", 15, {"low": "17/500"}),
    forge("four_point", 15, {"high": "339/10000"}),
    forge("four_point", 15, {"polynomial": poly(0, -1, -40, 2049)}),
    forge("four_point", 15, witness={"cofactor": poly(0, "1/512", "513/512", 1)}),
    # a zero that is none of the matrix: its polynomial times that of e_0 annihilates e_0, but 1 is no pole
    forge(
        "four_point",
        15,
        {"polynomial": poly(0, -1, 1), "low": "1", "high": "1"},
        witness={"cofactor": poly(0, -1, -40, 2048)},
    ),
    forge(
        "unstable", 19, {"polynomial": poly(0, -1, 1), "low": "1", "high": "1"}, witness={"cofactor": poly(0, -1, 8)}
    ),
    forge("unstable", 19, uses=[12, 8]),
    forge("unstable", 19, uses=[12, 0, 7]),
    forge("ternary", 15, {"polynomial": poly(0, -1, 81), "low": "1/81", "high": "1/81"}),
    forge("cubic", 5, {"values": poly(0, 1, 4, 1, over=6)}),
    forge("cubic", 5, {"values": poly(-1, 1, 4, 1, over=3)}),
    forge("cubic", 5, {"values": poly(-1, 1, 1, 1, over=3)}),
    forge("cubic", 5, {"values": poly(0)}),
    forge("cubic", 5, {"order": 1}),
    forge("cubic", 6, {"values": poly(-1, -1, 0, 1, over=2)}),
    forge("cubic", 6, {"values": poly(-1, 1, 0, -1)}),
    forge("cubic", 7, {"order": 3}),
    forge("cubic", 7, {"order": 300}),
    forge("cubic", 7, uses=[2]),
    forge("cubic", 6, uses=[1]),
    forge("cubic", 7, witness={"values": poly(-1, 2, -4, 2)}),
    forge("unstable", 20, uses=[9]),
    forge("unstable", 20, uses=[7, 9]),
    forge("unstable", 20, {"values": poly(1, 1)}),
    forge("unstable", 20, witness={"values": poly(2, 1)}),
    forge("unstable", 20, witness={"values": poly(1, 1, 1, over=2)}),
    forge("unstable", 20, witness={}),
    forge("unstable", 20, {"values": poly(1, 1, 0, 1, over=2)}),
    forge("unstable", 21, {"values": poly(0, 1, 1, over=2)}),
    forge("cubic", 8, {"degree": 4}),
    forge("cubic", 8, {"degree": 4, "operator": ["1", "0", "-1/6", "0", "0"]}),
    # right of the values and of the stencil, but S does not generate quartic polynomials
    forge(
        "cubic",
        8,
        {
            "degree": 4,
            "operator": ["1", "0", "-1/6", "0", "1/72"],
            "stencil": poly(-2, 1, -10, 54, -10, 1, over=36),
        },
    ),
    forge("cubic", 8, {"operator": ["1", "0", "1/6", "0"], "stencil": poly(-1, 1, 4, 1, over=6)}),
    forge("cubic", 8, {"degree": 2}),
    forge("cubic", 8, {"operator": ["1", "0", "1/6", "0"]}),
    forge("cubic", 8, {"operator": ["1", "0", "-1/6", "1"]}),
    forge("cubic", 8, {"stencil": poly(0, 1)}),
    forge("cubic", 8, {"stencil": poly(0, -1, 8, -1, over=6)}),
    forge("cubic", 8, {"stencil": poly(-1, -1, 8, over=6)}),
    forge("cubic", 8, uses=[4, 6, 0]),
    forge("cubic", 8, uses=[5, 0]),
    forge("cubic", 9, {"constant": "1/4"}),
    forge("cubic", 9, {"norm": "1/4"}),
    forge("cubic", 9, {"level": 2}),
    forge("cubic", 9, {"level": 0}, uses=[0]),
    forge("cubic", 9, {"nu": 1}),
    forge("cubic", 9, {"nu": 4}),
    forge("cubic", 9, uses=[1]),
    forge("cubic", 14, {"constant": "1/2"}),
    forge("cubic", 14, uses=[0, 13, 1]),
    forge("cubic", 14, uses=[0, 13]),
    forge("cubic", 11, {"nu": 0}),
    forge("cubic", 11, {"constant": "1/2"}),
    forge("cubic", 10, {"levels": 8}),
    forge("cubic", 10, {"tolerance": "1/1025"}),
    forge("cubic", 10, {"tolerance": "0"}),
    forge("cubic", 10, uses=[11]),
    forge("cubic", 12, {"constant": "1/8"}),
    forge("cubic", 12, {"order": 4}),
    forge("cubic", 12, {"order": 0}),
    forge("cubic", 12, {"order": 1}),
    forge("cubic", 12, uses=[9, 2]),
    forge("cubic", 12, uses=[11, 3]),
]


@pytest.mark.parametrize(
    ("certificate", "number", "rule"), FORGED, ids=[f"{i}-{rule}" for i, (_, _, rule) in enumerate(FORGED)]
)
def test_a_forged_claim_is_named(certificate, number, rule):
    outcome = check_text(text(certificate))
    assert not outcome.verified
    assert outcome.line.startswith(f"NOT VERIFIED claim {number} ({rule}): ")
    assert outcome.claim == number
    assert outcome.statements == ()
    assert "fails on it" not in outcome.line


def test_every_rule_is_forged():
    assert {rule for _, _, rule in FORGED} == set(KINDS["scalar"].rules) - OF_RADII


def test_norms_that_are_not_below_their_bound():
    """1 at ν = 1 proves nothing; 1 at ν = 3 and level 2, for Chaikin's mask, that φ is C^1 and not that it is C^2."""
    certificate = ALL["unstable"]()
    certificate["claims"][4]["statement"] |= {"level": 1, "norm": "1"}
    line = check_text(text(certificate)).line
    assert line == "NOT VERIFIED claim 6 (converges): the norm is not small enough"
    certificate = chaikin()
    certificate["claims"][11]["uses"] = certificate["claims"][12]["uses"] = [6]
    assert check_text(text(certificate)).verified
    certificate["claims"][12]["statement"]["order"] = 2
    line = check_text(text(certificate)).line
    assert line == "NOT VERIFIED claim 12 (smooth): the norm is not small enough"
    certificate["claims"][12]["statement"]["order"] = 3
    line = check_text(text(certificate)).line
    assert line == "NOT VERIFIED claim 12 (smooth): the norm is not one of S_4 or a later one"


def test_a_claim_on_a_reduced_mask_says_nothing_of_convergence():
    """The hat function's norm proves that φ is continuous, not that S of mask 0 converges."""
    certificate = ALL["unstable"]()
    certificate["claims"][6]["uses"] = [9]
    certificate["claims"].append(certificate["claims"].pop(6))
    for c in certificate["claims"][:-1]:
        c["uses"] = [i - (i > 6) for i in c["uses"]]
    certificate["claims"][-1]["uses"] = [8]
    outcome = check_text(text(certificate))
    assert outcome.line == "NOT VERIFIED claim 21 (converges): it uses norm with another mask"


def test_a_divergent_product_of_a_reduced_mask_says_nothing_of_mask_0():
    certificate = ALL["cycle"]()
    certificate["claims"].append(claim("diverges", [7], property="convergent", holds=False))
    assert check_text(text(certificate)).claim == 11


def test_reductions_must_lead_from_mask_to_mask():
    """0 -> 1 and 0 -> 2: what is proved of mask 2 is not led back over 1."""
    certificate = ALL["cycle"]()
    again = claim("reduction", from_=0, to=2, witness={"factor": poly(0, 1, 1, 1), "mask": poly(5, 1, 1)})
    rest = [
        claim("sum-rules", mask=2, order=1, witness={"quotient": poly(5, 1)}),
        claim("independent", mask=2, holds=True, witness={"cofactors": [poly(0), poly(-2, 1)]}),
        claim("stable", [13], mask=2, holds=True),
        claim("not-smooth", [14, 12, 2, 11], order=1),
    ]
    certificate["claims"] += [again, *rest]
    outcome = check_text(text(certificate))
    assert outcome.line == "NOT VERIFIED claim 15 (not-smooth): it uses reduction with another from"


def test_a_mask_that_does_not_sum_to_the_arity_has_no_refinable_function():
    half = poly(0, 1, 1, over=2)
    for c in (
        claim("independent", mask=0, holds=True, witness={"cofactors": [poly(0, 2), poly(0)]}),
        claim("dependent", property="independent", mask=0, holds=False, witness={"cycle": 3}),
        claim("stable", mask=0, holds=True, witness={"gcd": poly(0, 1), "cofactors": [poly(0, 2), poly(0)]}),
        claim("unstable", property="stable", mask=0, holds=False, witness={"cycle": 3}),
        claim("reduction", from_=0, to=1, witness={"factor": poly(0, 1), "mask": half}),
        claim("sum-rules", mask=0, order=1, witness={"quotient": poly(0, "1/2")}),
    ):
        assert check_text(text(document(2, half, [c]))).line.endswith("a(1) is not the arity")


def test_cycles_are_sought_where_the_components_are_coprime():
    """1 + z^3: Bezout holds, a cycle of third roots of unity does not."""
    witness = {"cofactors": [poly(0, 1), poly(0)]}
    for c in (
        claim("independent", mask=0, holds=True, witness=witness),
        claim("stable", mask=0, holds=True, witness={"gcd": poly(0, 1), **witness}),
    ):
        line = check_text(text(document(2, poly(0, 1, 0, 0, 1), [c]))).line
        assert line.endswith("there is a cycle of 3-th roots of unity")


def test_zeros_at_the_ends_of_polynomials_change_nothing():
    certificate = chaikin()
    certificate["mask"] |= poly(-3, 0, 0, 1, 3, 3, 1, 0, over=4)
    certificate["claims"][1]["witness"]["quotient"] = poly(-3, 0, 0, "1/4", 0)
    certificate["goal"][2]["symbol"] = poly(-1, 0, 1, 2, 1, 0, over=2)
    assert check_text(text(certificate)).verified


def test_a_negative_start_and_a_shift_change_nothing_but_indices():
    certificate = chaikin()
    certificate["mask"]["start"] = -1001
    for c in certificate["claims"]:
        if c["rule"] == "sum-rules":
            c["witness"]["quotient"]["start"] = -1001
        if c["rule"] == "independent":
            for u in c["witness"]["cofactors"]:
                u["start"] += 500
        if c["rule"] == "derived":
            c["statement"]["symbol"]["start"] -= 1000
    certificate["goal"] = [c["statement"] for c in certificate["claims"]]
    assert check_document(certificate).verified


def appended(name, *claims):
    """The line on a true certificate with more claims."""
    certificate = ALL[name]()
    certificate["claims"] += claims
    return check_text(text(certificate)).line


def test_hermite_interpolants_have_an_even_order():
    """The error bound of S_1 is true, E = 1/4 and μ = 1/2; a Hermite interpolant of odd order is not spoken of."""
    bound = claim("error-bound", [0, 2], nu=1, level=1, norm="1/2", constant="1/2")
    assert appended("cubic", bound).startswith("VERIFIED")
    hermite = claim("hermite-bound", [15, 1], order=1, constant="3/4")
    assert appended("cubic", bound, hermite).endswith("the order is not even and positive")


def test_without_sum_rules_no_sobolev_exponent():
    mask = poly(0, 2, 2, 2, over=3)
    claims = [
        claim("sum-rules", mask=0, order=0, witness={"quotient": mask}),
        claim("independent", mask=0, holds=True, witness={"cofactors": [poly(0), poly(0, "3/2")]}),
        claim("stable", [1], mask=0, holds=True),
    ]
    assert check_text(text(document(2, mask, claims))).verified
    claims.append(sobolev([2, 0], poly(0, -2, 3), "2/3"))
    assert check_text(text(document(2, mask, claims))).line.endswith("the sum rules are of order 0")


@pytest.mark.parametrize(
    ("name", "number"),
    [("chaikin", 19), ("four_point", 15), ("unstable", 20), *(("cubic", number) for number in range(5, 15))],
)
def test_work_is_counted_before_it_is_done(name, number):
    certificate = ALL[name]()
    rule = certificate["claims"][number]["rule"]
    certificate["claims"][number]["work"] = 0
    line = check_text(text(certificate)).line
    assert line.startswith(f"NOT VERIFIED claim {number} ({rule}): it takes more work than stated") or rule == "norm"
