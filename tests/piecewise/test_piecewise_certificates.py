"""Certificates of piecewise schemes: the specification, forged claims rule by rule, and every number changed."""

import copy
import json
import re
from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
from bsplines import spline_scheme
from number_mutations import at, changed, places, put
from random_piecewise import mask
from support import cases

import subdiv_cli
from subdiv_cli.catalog import masks_directory
from subdiv_cli.checker import KINDS, check_document
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.kinds.piecewise import KIND
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import DisagreementError, certified, check

PACKAGE = Path(subdiv_cli.__file__).parent
TEXT = (PACKAGE / "kinds" / "piecewise" / "FORMAT.md").read_text(encoding="utf-8")
SCHEMA = json.loads((PACKAGE / "certificate" / "schema.json").read_text(encoding="utf-8"))
(EXAMPLE,) = map(json.loads, re.findall(r"```json\n(.*?)```", TEXT, re.DOTALL))
RULES = set(KINDS["piecewise"].rules) - set(RADIUS.rules)
ONE = (Fraction(1), Fraction(1))
CONSTANT = tuple((i, ((0, Fraction(1)),)) for i in range(-6, 7))
PAIR = ((-1, ((-1, Fraction(1, 2)), (1, Fraction(1, 2)))), (1, ((-1, Fraction(-3, 8)), (0, 1), (1, Fraction(3, 8)))))


def shipped(name):
    return read_path(masks_directory() / "piecewise" / f"{name}.toml").scheme({})


SCHEMES = {
    "Levin": shipped("four_point_cubic"),
    "cubic": shipped("cubic_cubic"),
    "plain": shipped("chaikin_cubic_plain"),
    "complex": PiecewiseScheme(mask("hat"), mask("hat"), ONE, PAIR),
    "constant": PiecewiseScheme(mask("cubic"), mask("cubic"), ONE, CONSTANT),
    "enclosed": shipped("complex_pair"),
    "double knot": spline_scheme(3, (1, 2), 2),
    "bumps": shipped("counterexamples/bumps_2"),
    "row": shipped("counterexamples/half_at_zero"),
    "side": shipped("counterexamples/divergent_side"),
}


def document(scheme):
    return json.loads(json.dumps(check(scheme, (), Effort()).document))


DOCUMENTS = {name: document(scheme) for name, scheme in SCHEMES.items()} | {"example": EXAMPLE}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_certificates_verify_and_have_the_form(name):
    assert check_document(DOCUMENTS[name]).verified, check_document(DOCUMENTS[name]).line
    jsonschema.Draft202012Validator(SCHEMA).validate(DOCUMENTS[name])


def test_every_rule_is_specified_and_met():
    sections = dict(re.findall(r"^### ([\w-]+)\n(.*?)(?=^##|\Z)", TEXT, re.MULTILINE | re.DOTALL))
    assert set(sections) == RULES
    table = TEXT[TEXT.index("## Statements") : TEXT.index("## What all rests on")]
    assert set(re.findall(r"`([\w-]+)`", table)) >= set(KINDS["piecewise"].properties) - set(RADIUS.properties)
    for name, section in sections.items():
        assert "Statement" in section, name
        assert "Uses" in section, name
        assert "Work" in section, name
    met = {claim["rule"] for results in DOCUMENTS.values() for claim in results["claims"]}
    assert met >= RULES - {"side-above"}, RULES - met


def index(results, rule):
    """The number of the first claim by a rule, or that states a property of a name."""
    names = (rule, rule.partition("@")[0])
    claims = results["claims"]
    return next(
        i
        for i, claim in enumerate(claims)
        if claim["rule"] in names
        and (rule in names[1:] or str(list(claim["statement"].values())[-1]) == rule.partition("@")[2])
    )


def with_claim(name, rule, statement, uses=(), witness=None, work=10**6):
    """The outcome for a document with one claim more, which is its goal; `uses` are rules or numbers."""
    results = copy.deepcopy(DOCUMENTS[name])
    numbers = [use if isinstance(use, int) else index(results, use) for use in uses]
    claim = {"rule": rule, "statement": statement, "witness": witness or {}, "uses": numbers, "work": work}
    return check_document({**results, "claims": [*results["claims"], claim], "goal": [statement]})


def holds(value):
    return {"property": "convergent", "holds": value}


def bound(property_, x, length=1):
    return {"property": property_, "length": length, "bound": x}


def radius(results, order):
    """The numbers of the claims on the radius of the space of an order above 0 (or of 0), and on its family."""
    claims = results["claims"]
    family = next(
        i for i, c in enumerate(claims) if c["rule"] == "functionals" and (c["statement"]["order"] > 0) is (order > 0)
    )
    number = claims[family]["statement"]["family"]
    known = next(i for i, c in enumerate(claims) if c["rule"] == "eigenvalues" and c["statement"]["family"] == number)
    return known, family


LEVIN = DOCUMENTS["Levin"]
ZERO, DECAY = radius(LEVIN, 1), radius(LEVIN, 0)
SIDES = ("side@left", "side@right")
NUMBER = LEVIN["claims"][ZERO[1]]["statement"]["family"]
CERTIFICATE = {"certificate": LEVIN["claims"][index(LEVIN, "side@left")]["witness"]["certificate"]}
FORGED = [
    ("side", {"property": "side", "side": "right"}, (), CERTIFICATE, "the mask of the certificate is another"),
    ("functionals", {"property": "family", "family": NUMBER + 1, "order": 3}, ("converges",), None, None),
    ("functionals", {"property": "family", "family": NUMBER, "order": 3}, ("converges",), None, "the next family"),
    ("functionals", {"property": "family", "family": NUMBER + 1, "order": 3}, (), None, "does not use a claim"),
    ("vanishing", {"property": "vanishing", "order": 4}, ("converges",), None, "the space is not 0"),
    ("vanishing", {"property": "vanishing", "order": 0}, (), None, "the space is not 0"),
    ("converges", holds(True), (*SIDES, *ZERO), None, "not on rows that sum to 0"),
    ("converges", holds(True), ("side@right", "side@left", *DECAY), None, "another side"),
    ("side-diverges", holds(False), ("side@left",), None, "not known to diverge"),
    ("row-diverges", holds(False), (), {"row": 1}, "the row sums to 1"),
    ("row-diverges", holds(False), (), {"row": 7}, "no such special row"),
    ("expands", holds(False), DECAY, None, "not large enough"),
    ("expands", holds(False), ZERO, None, "not on rows that sum to 0"),
    ("generation", {"property": "generation", "degree": 2}, (), None, "x^3 is generated"),
    ("generation", {"property": "generation", "degree": 4}, (), None, "x^4 is not generated"),
    (
        "value-at-zero",
        {"property": "value-at-zero", "start": 0, "weights": ["1/2", "1/2"]},
        ("converges",),
        None,
        "fixed",
    ),
    ("value-at-zero", {"property": "value-at-zero", "start": 0, "weights": ["2"]}, ("converges",), None, "sum to 1"),
    ("value-at-zero", {"property": "value-at-zero", "start": 99, "weights": ["1"]}, ("converges",), None, "outside"),
    ("continuous", {"property": "smooth", "order": 1}, ("converges",), None, "does not prove such statements"),
    ("smooth", {"property": "smooth", "order": 1}, ("converges", *SIDES, *ZERO), None, None),
    ("smooth", {"property": "smooth", "order": 2}, ("converges", *SIDES, *ZERO), None, "a side is not known"),
    ("smooth", {"property": "smooth", "order": 1}, ("converges", *SIDES, *DECAY), None, "annihilates polynomials"),
    ("side-not-smooth", {"property": "not-smooth", "order": 1}, ("converges", "side@left"), None, "less smooth"),
    ("side-not-smooth", {"property": "not-smooth", "order": 3}, ("converges", "side@right"), None, None),
    ("zero-not-smooth", {"property": "not-smooth", "order": 2}, ("converges", *ZERO), None, "not large enough"),
    ("zero-not-smooth", {"property": "not-smooth", "order": 3}, ("converges", *ZERO), None, None),
    ("holder-lower", bound("holder-lower", "1/4"), ("converges", *SIDES, *ZERO), None, None),
    ("holder-lower", bound("holder-lower", "1/5"), ("converges", *SIDES, *ZERO), None, "at a side may be smaller"),
    ("holder-lower", bound("holder-lower", "0"), ("converges", *SIDES, *ZERO), None, "not positive"),
    ("side-above", bound("holder-upper", "1/4"), ("converges", "side@left"), None, None),
    ("side-above", bound("holder-upper", "1/5"), ("converges", "side@left"), None, "states another bound"),
    ("zero-above", bound("holder-upper", "57/296"), ("converges", *ZERO), None, None),
    ("zero-above", bound("zero-upper", "57/296"), ("converges", *ZERO), None, None),
    ("zero-above", bound("zero-upper", "1/4"), ("converges", *ZERO), None, "it is another"),
    ("zero-lower", bound("zero-lower", "57/296"), ("converges", *ZERO), None, None),
    ("zero-lower", bound("zero-lower", "1/16"), ("converges", *ZERO), None, "that at 0 may be smaller"),
    ("zero-polynomial", {"property": "zero-polynomial"}, ("converges", ZERO[0]), None, "not vanishing"),
    ("inside", {"property": "radius-upper", "family": NUMBER, "length": 1, "bound": "57/296"}, (), None, "not smaller"),
    ("inside", {"property": "radius-upper", "family": NUMBER, "length": 1, "bound": "1/5"}, (), None, None),
]


@pytest.mark.parametrize(("rule", "statement", "uses", "witness", "why"), FORGED)
def test_claims_that_no_stage_makes(rule, statement, uses, witness, why):
    """Forged ones are rejected for the right reason; those without one are true, and verified."""
    outcome = with_claim("Levin", rule, statement, uses, witness)
    assert outcome.verified is (why is None), outcome.line
    assert (why or "") in outcome.line


def exact(property_, polynomial, x, length=1, **more):
    return {"property": property_, "length": length, "polynomial": polynomial, "low": x, "high": x, **more}


def test_roots_are_those_of_a_part_and_the_least():
    quarter, local = exact("holder-root", ["-1", "4"], "1/4"), exact("holder-root", ["-57", "296"], "57/296")
    uses = ("converges", *SIDES, *ZERO)
    assert with_claim("Levin", "holder-root", quarter, uses, {"by": "left"}).verified
    for statement, by, why in (
        (quarter, "zero", "the radius at 0 is another"),
        (quarter, "right", "the exponent of the side is another"),
        (quarter, "middle", "no such part"),
        (local, "zero", "that at left may be smaller"),
        (exact("holder-root", ["-1", "8"], "1/8"), "right", "that at left may be smaller"),
    ):
        assert why in with_claim("Levin", "holder-root", statement, uses, {"by": by}).line
    zero = {**local, "property": "zero-root"}
    assert with_claim("Levin", "zero-root", zero, ("converges", *ZERO)).verified
    assert (
        "another" in with_claim("Levin", "zero-root", {**quarter, "property": "zero-root"}, ("converges", *ZERO)).line
    )


def test_eigenvalues_need_all_factors_and_a_radius_between():
    claim = LEVIN["claims"][ZERO[0]]
    statement, witness = claim["statement"], claim["witness"]
    assert witness["factors"] == [["-57", "296"], ["1", "16"]]
    for other, why in (
        ({"factors": [["-57", "296"]]}, "another degree"),
        ({"factors": [["-57", "296"], ["1", "17"]]}, "not the characteristic polynomial"),
        ({"factors": [["-57", "296"], ["1", "0"]]}, "no leading coefficient"),
        ({"inner": "1/5"}, "not below the root"),
        ({"inner": "1/16"}, "factor 1 has a root that is not inside"),
    ):
        assert why in with_claim("Levin", "eigenvalues", statement, (), {**witness, **other}).line, changed
    small = {**statement, **exact("radius", ["-1", "16"], "1/16")}
    assert "not inside" in with_claim("Levin", "eigenvalues", small, (), {**witness, "inner": "1/32"}).line
    other = {**statement, **exact("radius", ["-1", "5"], "1/5")}
    assert "factor 0 has a root" in with_claim("Levin", "eigenvalues", other, (), witness).line
    far = {**statement, **exact("radius", ["-1", "3"], "1/3")}
    assert (
        "no factor has roots of this modulus"
        in with_claim("Levin", "eigenvalues", far, (), {**witness, "inner": "1/4"}).line
    )


def test_an_irrational_radius_is_the_only_root_outside():
    results = DOCUMENTS["plain"]
    number, _ = radius(results, 1)
    claim = results["claims"][number]
    assert len(claim["statement"]["polynomial"]) == 3
    assert with_claim("plain", "eigenvalues", claim["statement"], (), claim["witness"]).verified
    forged = {**claim["witness"], "inner": "3/10"}
    assert "not one root outside" in with_claim("plain", "eigenvalues", claim["statement"], (), forged).line
    squared = {**claim["statement"], "length": 2}
    assert "that is not inside" in with_claim("plain", "eigenvalues", squared, (), claim["witness"]).line


FACTS = {
    "Levin": (True, 3, 1, "1/4", "57/296"),
    "cubic": (True, 3, 2, "1/8", "1/8"),
    "constant": (True, 0, 2, "1/8", None),
    "row": (False, -1, -1, None, None),
    "bumps": (False, 1, -1, None, None),
}
"""Convergence, generation, smoothness, and the decays of the exponent and of that at 0."""


def is_true(s, name):
    """Whether a statement is true, by what is known of the scheme; of families nothing is asked."""
    convergent, generation, smoothness, decay, at_zero = FACTS[name]
    match s["property"]:
        case "convergent":
            return s["holds"] is convergent
        case "generation":
            return s["degree"] == generation
        case "smooth":
            return convergent and s["order"] <= smoothness
        case "not-smooth":
            return convergent and s["order"] > smoothness
        case "holder-root" | "zero-root":
            x = Fraction(decay if s["property"] == "holder-root" else at_zero)
            root = -Fraction(s["polynomial"][0]) / Fraction(s["polynomial"][1])
            return root == x ** s["length"] and Fraction(s["low"]) <= root <= Fraction(s["high"])
        case "zero-polynomial":
            return at_zero is None
        case "value-at-zero":
            weights = {i: Fraction(x) for i, x in enumerate(s["weights"], s["start"]) if Fraction(x)}
            cubic = {-1: Fraction(1, 6), 0: Fraction(2, 3), 1: Fraction(1, 6)}
            return weights == (cubic if name == "cubic" else {0: 1})
        case "local-spectrum":
            return s in [claim["statement"] for claim in DOCUMENTS[name]["claims"]]
    return s["property"] in {"side", "family", "vanishing", "radius", "radius-upper"}


@pytest.mark.parametrize("name", FACTS)
def test_every_number_changed(name):
    """A certificate with one number changed is rejected, or all that it states is true all the same."""
    results, rejected, kept = DOCUMENTS[name], 0, 0
    everywhere = [(number, place) for number, claim in enumerate(results["claims"]) for place in places(claim)]
    for number, place in everywhere[:: max(1, len(everywhere) // cases(60))]:
        for new in changed(at(results["claims"][number], place)):
            forged = json.loads(json.dumps(results))
            put(forged["claims"][number], place, new)
            forged["goal"] = [forged["claims"][number]["statement"]]
            outcome = check_document(forged)
            rejected, kept = rejected + (not outcome.verified), kept + outcome.verified
            assert not outcome.verified or is_true(forged["goal"][0], name), (number, place, new)
    assert rejected > kept, (rejected, kept)


@pytest.mark.parametrize("key", ["left", "right", "spacing", "special"])
def test_a_certificate_of_another_mask_is_rejected(key):
    forged = json.loads(json.dumps(LEVIN))
    change = {
        "left": {"start": -2, "coefficients": forged["mask"]["left"]["coefficients"]},
        "right": {"start": -2, "coefficients": ["1/8", "1/2", "3/4", "1/2", "1/4"]},
        "spacing": ["1", "2"],
        "special": forged["mask"]["special"][1:],
    }
    forged["mask"][key] = change[key]
    assert not check_document(forged).verified


@pytest.mark.parametrize("name", ["Levin", "cubic", "constant"])
def test_less_work_than_it_takes_is_refused(name):
    results = DOCUMENTS[name]
    for number, claim in enumerate(results["claims"]):
        if claim["work"] > 1 and claim["rule"] in RULES:
            forged = json.loads(json.dumps(results))
            forged["claims"][number]["work"] //= 2
            outcome = check_document(forged)
            assert outcome.claim == number, claim["rule"]
            assert "more work than stated" in outcome.line


@pytest.mark.parametrize("code", ["SD823", "SD825", "SD826", "SD821"])
def test_a_wrong_finding_is_caught(code):
    """A stage that says too much disagrees with the checker."""
    scheme = SCHEMES["Levin"]
    analysis = KIND.analyse(scheme, Effort())
    wrong = []
    for finding in analysis.findings:
        if finding.code != code:
            wrong.append(finding)
        elif code == "SD823":
            witness = {"by": "radius", "dimension": 5}
            wrong.append(KIND.rules()[code].refuted("S does not converge", witness))
        else:
            key, step = ("degree", 1) if code == "SD821" else ("order", 1 if code == "SD825" else -1)
            witness = {**finding.witness, key: finding.witness[key] + step}
            rule = KIND.rules()[code]
            made = rule.refuted("", witness) if finding.verdict is Verdict.REFUTED else rule.proved("", witness)
            wrong.append(made)
    with pytest.raises(DisagreementError):
        certified(KIND, analysis._replace(findings=tuple(wrong)), (), Effort())


def test_a_space_of_too_small_an_order_proves_no_smoothness():
    """Without x^2 among the limits ρ_2 = 1/8 < 2^-2, but C^2 needs an order above 2; and α at most the order."""
    scheme = shipped("cubic_quarters")
    made = document(scheme)
    claims = made["claims"]
    converges, sides = index(made, "converges"), [index(made, f"side@{name}") for name in ("left", "right")]
    number = 1 + max(claim["statement"].get("family", 0) for claim in claims)
    family = {"rule": "functionals", "statement": {"property": "family", "family": number, "order": 2}, "witness": {}}
    radius = {
        "rule": "eigenvalues",
        "statement": {"property": "radius", "family": number, **exact("radius", ["-1", "8"], "1/8")},
        "witness": {"factors": [["-1", "8"], ["-1", "8"]], "inner": "0"},
    }
    more = [{**family, "uses": [converges], "work": 10**6}, {**radius, "uses": [], "work": 10**6}]
    both = [len(claims) + 1, len(claims)]
    for statement, rule, witness, uses, why in (
        (
            {"property": "smooth", "order": 2},
            "smooth",
            {},
            [converges, *sides, *both],
            "order of the family is too small",
        ),
        ({"property": "smooth", "order": 1}, "smooth", {}, [converges, *sides, *both], None),
        (exact("zero-root", ["-1", "8"], "1/8"), "zero-root", {}, [converges, *both], "not below the order"),
        (bound("zero-lower", "1/8"), "zero-lower", {}, [converges, *both], "may be smaller"),
        (bound("zero-lower", "1/4"), "zero-lower", {}, [converges, *both], None),
        (bound("zero-upper", "1/8"), "zero-above", {}, [converges, *both], "not below the order"),
    ):
        claim = {"rule": rule, "statement": statement, "witness": witness, "uses": uses, "work": 10}
        outcome = check_document({**made, "claims": [*claims, *more, claim], "goal": [statement]})
        assert outcome.verified is (why is None), outcome.line
        assert (why or "") in outcome.line
