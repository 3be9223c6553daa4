"""Certificates of masks of matrices: the specification, forged claims rule by rule, and every number changed."""

import copy
import json
import math
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
from flint import fmpq_mat
from matrix_masks import DGHM, DOUBLE_KNOT_CUBIC, blocked, diagonal, merrien, scalar, scheme
from number_mutations import at, changed, places, put
from support import cases

import subdiv_cli
from subdiv_cli.checker import check_document
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.checker.vector.rules import RULES
from subdiv_cli.kinds.scalar.stages.holder import defect
from subdiv_cli.kinds.vector import KIND
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers
from subdiv_cli.kinds.vector.stages.convergence import space_data
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.model.closed import rationals
from subdiv_cli.pipeline import DisagreementError, certified, check

PACKAGE = Path(subdiv_cli.__file__).parent
TEXT = (PACKAGE / "kinds" / "vector" / "FORMAT.md").read_text(encoding="utf-8")
SCHEMA = json.loads((PACKAGE / "certificate" / "schema.json").read_text(encoding="utf-8"))
(EXAMPLE,) = map(json.loads, re.findall(r"```json\n(.*?)```", TEXT, re.DOTALL))
RADIUS_RULES = set(RADIUS.rules)
FOUR_POINT = ("-1/16", 0, "9/16", 1, "9/16", 0, "-1/16")
ENDS = {0: [[1, 0], ["1/2", "1/2"]], 1: [["1/2", "1/2"], [0, 1]]}
UNEQUAL = {-1: [["1/2", 0], [0, "1/4"]], 0: [["3/2", 0], [0, "1/2"]], 1: [[0, 0], [0, "1/4"]]}
JORDAN = {-1: [["1/2", "1/2"], [0, "1/2"]], 0: [[1, 1], [0, 1]], 1: [["1/2", "1/2"], [0, "1/2"]]}
MASKS = {
    "double knots": DOUBLE_KNOT_CUBIC,
    "DGHM": DGHM,
    "two four-points": diagonal(scalar(FOUR_POINT), scalar(FOUR_POINT)),
    "Merrien": merrien("-1/10", "-1/2"),
    "cubic by 2": blocked(("1/8", "1/2", "3/4", "1/2", "1/8"), -2, 2),
    "ends": ENDS,
    "unequal": UNEQUAL,
    "Jordan": JORDAN,
}


def document(name):
    checked = check(scheme(MASKS[name]), (), Effort())
    return json.loads(json.dumps(checked.document))


DOCUMENTS = {name: document(name) for name in MASKS} | {"example": EXAMPLE}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_certificates_verify_and_have_the_form(name):
    assert check_document(DOCUMENTS[name]).verified, check_document(DOCUMENTS[name]).line
    jsonschema.Draft202012Validator(SCHEMA).validate(DOCUMENTS[name])


@pytest.mark.parametrize("name", DOCUMENTS)
def test_a_radius_is_proved_once(name):
    families = [claim["statement"]["family"] for claim in DOCUMENTS[name]["claims"] if claim["rule"] == "blocks"]
    assert len(families) == len(set(families))


def test_every_rule_is_specified_and_met():
    sections = dict(re.findall(r"^### ([\w-]+)\n(.*?)(?=^##|\Z)", TEXT, re.MULTILINE | re.DOTALL))
    own = set(RULES) - RADIUS_RULES
    assert set(sections) == own
    for name, section in sections.items():
        for part in ("**Statement**", "**Work**", "**Example**"):
            assert part in section, (name, part)
    met = {claim["rule"] for found in DOCUMENTS.values() for claim in found["claims"]}
    assert met >= own - {"holder-lower", "holder-upper"}, own - met


def index(found, rule):
    """The number of the first claim by a rule."""
    return next(i for i, claim in enumerate(found["claims"]) if claim["rule"] == rule)


def with_claim(name, rule, statement, uses, witness=None, work=10**6):
    """The outcome for a document with one claim more, which is its goal; `uses` are rules, or numbers of claims."""
    found = copy.deepcopy(DOCUMENTS[name])
    numbers = [use if isinstance(use, int) else index(found, use) for use in uses]
    claim = {"rule": rule, "statement": statement, "witness": witness or {}, "uses": numbers, "work": work}
    return check_document({**found, "claims": [*found["claims"], claim], "goal": [statement]})


def bound(family, length, x, property_="radius-upper"):
    return {"property": property_, "family": family, "length": length, "bound": x}


def test_bounds_that_no_stage_finds():
    """holder-lower and holder-upper by weaker bounds of the radius than the ones that are known."""
    upper = {"property": "holder-lower", "length": 1, "bound": "3/5"}
    found = copy.deepcopy(EXAMPLE)
    closing, family = index(found, "monotone-closing"), index(found, "stencil-differences")
    assert with_claim("example", "holder-lower", upper, ["converges", closing, family]).verified
    word = index(found, "word")
    lower = {"property": "holder-upper", "length": 1, "bound": "1/2"}
    assert with_claim("example", "holder-upper", lower, ["converges", word, family]).verified
    assert (
        "another" in with_claim("example", "holder-upper", {**lower, "bound": "2/3"}, ["converges", word, family]).line
    )
    low = {"property": "holder-lower", "length": 1, "bound": "1/5"}
    assert "another length or bound" in with_claim("example", "holder-lower", low, ["converges", closing, family]).line


def smooth(n, property_="smooth"):
    return {"property": property_, "order": n}


def holds(property_, value):
    return {"property": property_, "holds": value}


FORGED = [
    ("double knots", "converges", holds("convergent", True), ["closing@1", "stencil-differences"], "another order"),
    ("double knots", "diverges", holds("convergent", False), ["constants"], "there are constants"),
    ("double knots", "diverges", holds("convergent", False), ["closing@0", "decay"], "not large enough"),
    ("double knots", "smooth", smooth(2), ["converges", "closing@1", "stencil-differences"], "not small enough"),
    ("double knots", "smooth", smooth(4), ["converges", "closing@1", "stencil-differences"], "not of a higher order"),
    ("double knots", "smooth", smooth(0), ["converges", "closing@0", "decay"], "not that of differences"),
    (
        "double knots",
        "not-smooth",
        smooth(1, "not-smooth"),
        ["converges", "closing@1", "stencil-differences"],
        "not large",
    ),
    ("double knots", "continuous", smooth(1), ["converges"], "does not prove such statements"),
    ("double knots", "derived-smooth", smooth(2), ["derived-norm"], "the norm is that of derived scheme 2"),
    ("double knots", "generation", {"property": "generation", "degree": 4}, ["eigen-sequences"], "are of order 4"),
    ("double knots", "mean-matrix", holds("mean-matrix", False), ["constants"], "it is true"),
    ("Jordan", "mean-matrix", holds("mean-matrix", True), ["constants"], "it is false"),
    ("unequal", "mean-matrix", holds("mean-matrix", True), ["constants"], "there are no constants"),
    ("unequal", "generation", {"property": "generation", "degree": 0}, ["eigen-sequences"], "are of order 0"),
    ("two four-points", "attained", holds("attained", True), ["closing@1", "stencil-differences", "holder-root"], ""),
    ("Merrien", "not-attained", holds("attained", False), ["closing@1", "stencil-differences", "holder-root"], "uses"),
]


def radius_of(found, family):
    """The number of the last claim that says what the radius of the family is."""
    return max(
        i
        for i, claim in enumerate(found["claims"])
        if claim["statement"]["property"] in ("radius", "bounded", "radius-upper")
        and claim["statement"]["family"] == family
    )


@pytest.mark.parametrize(
    ("name", "rule", "statement", "uses", "why"), FORGED, ids=lambda x: x if isinstance(x, str) else ""
)
def test_forged_claims(name, rule, statement, uses, why):
    found = DOCUMENTS[name]
    numbers = []
    for use in uses:
        if use.startswith("closing@"):
            rule_of = "decay" if use.endswith("0") else "stencil-differences"
            numbers.append(radius_of(found, found["claims"][index(found, rule_of)]["statement"]["family"]))
        else:
            numbers.append(use)
    outcome = with_claim(name, rule, statement, numbers)
    assert not outcome.verified
    assert why in outcome.line


def test_an_integer_exponent_is_not_judged_by_differences_of_a_lower_order():
    """α = 2 is attained by V_2 alone: that products on V_1 have a Jordan block at 1/4 says nothing."""
    found = DOCUMENTS["two four-points"]
    claims = found["claims"]
    stencils = index(found, "limit-stencils")
    numbers = VectorNumbers(scheme(MASKS["two four-points"]), Effort())
    lower = numbers.growth_of(1)
    data, family = space_data(lower.on), 1 + max(c["statement"].get("family", 0) for c in claims)
    sign, _, vector = defect(lower.on.space.matrices[0], Fraction(1, 4))
    witness = {"start": data["start"], "tree": list(data["tree"]), "words": [list(w) for w in data["words"]]}
    witness |= {key: rationals(data[key]) for key in ("basis", "matrices", "leaves")}
    last = len(claims)
    more = [
        {"rule": "stencil-differences", "statement": {"property": "family", "family": family, "order": 1},
         "witness": witness, "uses": [stencils], "work": 10**6},
        {"rule": "defective", "statement": {"property": "defective", "family": family, "length": 1, "value": "1/4"},
         "witness": {"word": [0], "sign": sign, "vector": rationals(vector)}, "uses": [], "work": 10**6},
        {"rule": "not-attained", "statement": holds("attained", False), "witness": {},
         "uses": [last + 1, last, index(found, "holder-root")], "work": 1},
    ]  # fmt: skip
    outcome = check_document({**found, "claims": [*claims, *more], "goal": [holds("attained", False)]})
    assert outcome.claim == last + 2
    assert "not below the order" in outcome.line


FACTS = {
    "double knots": (1, 4, True, 1, 2.0, None),
    "DGHM": (1, 2, True, 0, 1.0, None),
    "two four-points": (2, 4, True, 1, 2.0, False),
    "Merrien": (1, 2, True, 1, 1.5648197735615827, True),
    "cubic by 2": (1, 4, True, 2, 3.0, True),
    "ends": (1, 2, False, -1, math.nan, None),
    "unequal": (0, 0, False, -1, math.nan, None),
    "Jordan": (1, 2, False, -1, math.nan, None),
    "example": (1, 2, True, 0, 1.0, True),
}
"""Dimension of E_A, order of the eigen-sequences, convergence, smoothness, Hölder exponent, whether it is attained."""
OF_FAMILIES = {"family", "radius", "radius-upper", "radius-lower", "bounded", "blocks", "distinct", "defective"}


def is_true(s, name):
    """Whether a statement on the mask is true, by what is known of it."""
    dimension, order, convergent, smoothness, alpha, attained = FACTS[name]
    match s["property"]:
        case "constants":
            return s["dimension"] == dimension
        case "limit-stencils":
            return s["count"] == dimension
        case "eigen-sequences":
            return s["order"] == order
        case "generation":
            return s["degree"] == order - 1
        case "mean-matrix":
            return s["holds"] is (name != "Jordan")
        case "convergent":
            return s["holds"] is convergent
        case "smooth":
            return convergent and s["order"] <= smoothness
        case "not-smooth":
            return convergent and s["order"] > smoothness
        case "holder-root":
            return abs(root(s) - alpha) < 1e-9
        case "attained":
            return s["holds"] is attained
    return s["property"] in OF_FAMILIES | {"derived", "derived-norm"}


def root(s):
    import numpy as np

    low, high = float(Fraction(s["low"])), float(Fraction(s["high"]))
    zeros = np.roots([int(c) for c in s["polynomial"][::-1]])
    (zero,) = (z.real for z in zeros if abs(z.imag) < 1e-12 and low - 1e-9 <= z.real <= high + 1e-9)
    return -math.log2(zero) / s["length"]


@pytest.mark.parametrize("name", ["double knots", "two four-points", "ends", "unequal", "Jordan", "example", "Merrien"])
def test_every_number_changed(name):
    """A certificate with one number changed is rejected, or all that it states is true all the same."""
    found, rejected, kept = DOCUMENTS[name], 0, 0
    everywhere = [(number, place) for number, claim in enumerate(found["claims"]) for place in places(claim)]
    for number, place in everywhere[:: max(1, len(everywhere) // cases(25))]:
        claim = found["claims"][number]
        for new in changed(at(claim, place)):
            forged = json.loads(json.dumps(found))
            put(forged["claims"][number], place, new)
            forged["goal"] = [forged["claims"][number]["statement"]]
            outcome = check_document(forged)
            rejected, kept = rejected + (not outcome.verified), kept + outcome.verified
            assert not outcome.verified or is_true(forged["claims"][number]["statement"], name), (
                number,
                place,
                new,
            )
    assert rejected > kept / 2, (rejected, kept)


@pytest.mark.parametrize("name", ["double knots", "two four-points", "example"])
def test_half_the_work_is_too_little(name):
    found = DOCUMENTS[name]
    for number, claim in enumerate(found["claims"]):
        if claim["work"] > 200 and claim["rule"] not in RADIUS_RULES:
            forged = json.loads(json.dumps(found))
            forged["claims"][number]["work"] //= 4
            outcome = check_document(forged)
            assert outcome.claim == number, claim["rule"]
            assert "more work than stated" in outcome.line


def lifted(found, window):
    """The rows of the basis of a space of sequences on a larger window."""
    m = found.space.basis.ncols() // len(found.window)
    rows = []
    for row in found.space.basis.tolist():
        at = {i: row[m * place : m * place + m] for place, (i,) in enumerate(found.window)}
        rows.append([int(x) for i in window for x in at.get(i, [0] * m)])
    return rows


def sum_of(one, other):
    """The block diagonal matrices of two families."""
    zero = "0"
    return [
        [*([*map(str, row), *[zero] * b.nrows()] for row in a.tolist()),
         *([*[zero] * a.nrows(), *map(str, row)] for row in b.tolist())]
        for a, b in zip(one.space.matrices, other.space.matrices, strict=True)
    ]  # fmt: skip


def test_a_space_that_is_not_spanned_by_differences_refutes_nothing():
    """A cubic spline beside a hat times 3/4: with what dies out, the radius on the space would be 3/4."""
    dying = {i: [[Fraction(3, 4) * Fraction(x)]] for i, ((x,),) in scalar(("1/2", 1, "1/2"), -1).items()}
    mask = diagonal(scalar(("1/8", "1/2", "3/4", "1/2", "1/8"), -2), dying)
    checked = check(scheme(mask), (), Effort())
    numbers = VectorNumbers(scheme(mask), Effort())
    one, other = numbers.spaces.differences(4), numbers.spaces._space([{(0,): fmpq_mat([[0, 1]]).entries()}])
    window = range(min(one.window + other.window)[0], max(one.window + other.window)[0] + 1)
    found = json.loads(json.dumps(checked.document))
    claim = found["claims"][index(found, "stencil-differences")]
    rest = other.space.dimension
    witness = {
        "start": window[0],
        "basis": [[str(x) for x in row] for row in (*lifted(one, window), *lifted(other, window))],
        "matrices": sum_of(one, other),
        "tree": claim["witness"]["tree"],
        "leaves": [[*row, *["0"] * rest] for row in claim["witness"]["leaves"]],
        "words": claim["witness"]["words"] * (1 + rest),
    }
    forged = {**claim, "witness": witness, "work": 10**6}
    outcome = check_document({**found, "claims": [*found["claims"][: found["claims"].index(claim)], forged]})
    assert "the words do not span the space" in outcome.line


def test_what_dies_out_is_all_that_must():
    """Without the direction that grows, or with the limit stencil itself, the space would prove what is false."""
    found = DOCUMENTS["double knots"]
    decay = found["claims"][index(found, "decay")]
    without = {**decay, "witness": {**decay["witness"], "orthogonal": []}}
    outcome = check_document({**found, "claims": [*found["claims"][: found["claims"].index(decay)], without]})
    assert "the complement of E_A has another dimension" in outcome.line
    # the hat: w = δ at 1 is fixed, T_0 w = w and T_1 w = δ/2 at 0 + δ/2 at 1
    hat = copy.deepcopy(EXAMPLE)
    witness = {
        "start": 0, "basis": [["1", "-1"], ["0", "1"]],
        "matrices": [[["1/2", "0"], ["0", "1"]], [["1/2", "1/2"], ["0", "1"]]],
        "tree": [1], "leaves": [["1", "0"]], "orthogonal": [],
    }  # fmt: skip
    hat["claims"] = [hat["claims"][0], {**hat["claims"][1], "witness": witness, "work": 10**4}]
    assert "the sum of row 1 of the basis is not orthogonal to E_A" in check_document(hat).line


def one_more(value):
    return value + 1


@pytest.mark.parametrize(
    ("code", "key", "wrong"),
    [
        ("SD701", "dimension", one_more),
        ("SD702", "order", one_more),
        ("SD706", "rows", lambda rows: (tuple(2 * x for x in rows[0]), *rows[1:])),
        ("SD706", "start", one_more),
        ("SD708", "order", one_more),
        ("SD709", "order", lambda order: order - 1),
        ("SD712", "value", lambda value: value / 2),
        ("SD713", "order", one_more),
        ("SD713", "norm", lambda norm: norm / 2),
    ],
)
def test_a_wrong_finding_is_a_disagreement(code, key, wrong):
    analysis = KIND.analyse(scheme(MASKS["two four-points"]), Effort())
    (finding,) = (each for each in analysis.findings if each.code == code)
    forged = replace(finding, witness={**finding.witness, key: wrong(finding.witness[key])})
    findings = tuple(forged if each is finding else each for each in analysis.findings)
    with pytest.raises(DisagreementError):
        certified(KIND, analysis._replace(findings=findings), (), Effort())


@pytest.mark.parametrize("code", ["SD703", "SD705"])
def test_a_wrong_verdict_is_a_disagreement(code):
    analysis = KIND.analyse(scheme(MASKS["Jordan"]), Effort())
    (finding,) = (each for each in analysis.findings if each.code == code)
    assert finding.verdict is Verdict.REFUTED
    findings = tuple(replace(each, verdict=Verdict.PROVED) if each is finding else each for each in analysis.findings)
    with pytest.raises(DisagreementError):
        certified(KIND, analysis._replace(findings=findings), (), Effort())
