"""Certificates of Hermite masks: the specification, forged claims rule by rule, and every number changed."""

import copy
import json
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
from matrix_masks import (
    HERMITE_CUBIC,
    HERMITE_QUINTIC,
    UNSEEN,
    conjugated,
    diagonal,
    merrien,
    scalar,
    scheme,
)
from number_mutations import at, changed, places
from number_mutations import put as replace_at
from support import cases

import subdiv_cli
from subdiv_cli.checker import KINDS, check_document
from subdiv_cli.kinds.hermite import KIND
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import DisagreementError, certified, check

PACKAGE = Path(subdiv_cli.__file__).parent
TEXT = (PACKAGE / "kinds" / "hermite" / "FORMAT.md").read_text(encoding="utf-8")
SCHEMA = json.loads((PACKAGE / "certificate" / "schema.json").read_text(encoding="utf-8"))
(EXAMPLE,) = map(json.loads, re.findall(r"```json\n(.*?)```", TEXT, re.DOTALL))
HAT = scalar(("1/2", 1, "1/2"), -1)
MASKS = {
    "cubic": HERMITE_CUBIC,
    "quintic": HERMITE_QUINTIC,
    "unseen": UNSEEN,
    "rough": merrien("-1/8", 2),
    "twice": conjugated(HERMITE_CUBIC, [[1, 0], [0, Fraction(1, 2)]], [[1, 0], [0, 2]]),
    "two constants": diagonal(HAT, HAT),
    "other constants": conjugated(HERMITE_CUBIC, [[1, 0], [-1, 1]], [[1, 0], [1, 1]]),
    "diverging": merrien(-2, -2),
}
DOCUMENTS = {
    name: json.loads(json.dumps(check(scheme(mask, kind="hermite"), (), Effort()).document))
    for name, mask in MASKS.items()
} | {"example": EXAMPLE}
TRUE = {
    "cubic": (4, True),
    "quintic": (6, True),
    "unseen": (1, True),
    "rough": (3, False),
    "twice": (1, False),
    "two constants": (1, False),
    "other constants": (0, False),
    "diverging": (2, False),
    "example": (3, True),
}
"""The number of degrees of the spectral condition, and whether the scheme is HC^(m-1)."""
TRUE_STATEMENTS = {
    "spectral": lambda s, name: (s["order"], s["holds"]) == (TRUE[name][0], TRUE[name][0] >= size(name)),
    "hermite-convergent": lambda s, name: (s["order"], s["holds"]) == (size(name) - 1, TRUE[name][1]),
    "smooth": lambda s, name: name == "cubic" and s["order"] <= 1,
}
"""What makes a statement of a property true, of those masks whose Taylor schemes are seen to contract."""


def size(name):
    """The number m of components."""
    return len(DOCUMENTS[name]["mask"]["coefficients"][0])


@pytest.mark.parametrize("name", DOCUMENTS)
def test_certificates_verify_and_have_the_form(name):
    found = DOCUMENTS[name]
    assert check_document(found).verified, check_document(found).line
    jsonschema.Draft202012Validator(SCHEMA).validate(found)
    order, holds = TRUE[name]
    for claim in found["claims"]:
        s = claim["statement"]
        if s["property"] == "spectral":
            assert s["order"] == order
        if s["property"] == "hermite-convergent":
            assert s["holds"] is holds


def test_every_rule_is_specified_and_met():
    sections = dict(re.findall(r"^### ([\w-]+)\n(.*?)(?=^##|\Z)", TEXT, re.MULTILINE | re.DOTALL))
    own = set(KINDS["hermite"].rules) - set(KINDS["vector"].rules)
    assert set(sections) == own
    for name, section in sections.items():
        for part in ("**Statement**", "**Work**", "**Example**"):
            assert part in section, (name, part)
    met = {claim["rule"] for found in DOCUMENTS.values() for claim in found["claims"]}
    assert met >= own


def test_the_line():
    assert check_document(EXAMPLE).line == "VERIFIED the spectral condition holds for degrees below 3; S is HC^1"
    assert "S is not HC^1" in check_document(DOCUMENTS["rough"]).line


def index(found, rule, **fields):
    """The number of the first claim by a rule, with these fields in its statement."""
    return next(
        i
        for i, claim in enumerate(found["claims"])
        if claim["rule"] == rule and fields.items() <= claim["statement"].items()
    )


def radius_of(found, jet):
    """The number of the last claim that bounds the radius of the family of a claim from above."""
    family = found["claims"][jet]["statement"]["family"]
    return max(
        i
        for i, claim in enumerate(found["claims"])
        if claim["statement"]["property"] in ("radius", "bounded", "radius-upper")
        and claim["statement"]["family"] == family
    )


def with_claim(name, rule, statement, uses, witness=None, work=10**6):
    """The outcome for a document with one claim more, which is its goal; `uses` are numbers of claims."""
    found = copy.deepcopy(DOCUMENTS[name])
    claim = {"rule": rule, "statement": statement, "witness": witness or {}, "uses": uses, "work": work}
    return check_document({**found, "claims": [*found["claims"], claim], "goal": [statement]})


def hermite(order, holds):
    return {"property": "hermite-convergent", "order": order, "holds": holds}


def used(name, *rules):
    """The numbers of claims: by their rules; `jet j` for one on a derivative, `radius j` for that on its radius."""
    found, numbers = DOCUMENTS[name], []
    for rule in rules:
        if rule.startswith("jet"):
            numbers.append(index(found, "jet", component=int(rule[-1])))
        elif rule.startswith("radius"):
            numbers.append(radius_of(found, index(found, "jet", component=int(rule[-1]))))
        elif rule.startswith("decay radius"):
            numbers.append(radius_of(found, index(found, "decay")))
        else:
            numbers.append(index(found, rule))
    return numbers


FORGED = [
    ("quintic", "hermite-converges", hermite(2, True), ("converges", "radius 1", "jet 1"), "does not use a claim"),
    (
        "quintic",
        "hermite-converges",
        hermite(2, True),
        ("converges", "radius 2", "jet 2", "radius 2", "jet 2"),
        "another component",
    ),
    (
        "quintic",
        "hermite-converges",
        hermite(2, True),
        ("converges", "radius 1", "jet 2", "radius 2", "jet 2"),
        "another family",
    ),
    ("cubic", "hermite-converges", hermite(2, True), ("converges", "radius 1", "jet 1"), "not that of the last"),
    ("cubic", "hermite-converges", hermite(1, True), ("radius 1", "jet 1"), "not convergent"),
    ("cubic", "hermite-converges", hermite(1, True), ("converges", "decay radius", "decay"), "uses family, not jet"),
    ("rough", "hermite-converges", hermite(1, True), ("converges", "radius 1", "jet 1"), "not small enough"),
    ("twice", "hermite-converges", hermite(1, True), ("converges", "radius 1", "jet 1"), "not small enough"),
    ("cubic", "hermite-diverges", hermite(1, False), ("constants",), "E_A is spanned by e_0"),
    ("cubic", "hermite-diverges", hermite(1, False), ("converges",), "S converges"),
    ("cubic", "hermite-diverges", hermite(1, False), ("radius 1", "jet 1"), "not large enough"),
    ("cubic", "hermite-diverges", hermite(1, False), ("decay radius", "decay"), "uses family, not jet"),
    ("rough", "hermite-diverges", hermite(0, False), ("radius 1", "jet 1"), "not that of the last"),
    ("two constants", "hermite-diverges", hermite(1, False), ("constants", "spectral"), "does not need"),
]


@pytest.mark.parametrize(
    ("name", "rule", "statement", "uses", "why"), FORGED, ids=lambda x: x if isinstance(x, str) else ""
)
def test_forged_claims(name, rule, statement, uses, why):
    outcome = with_claim(name, rule, statement, used(name, *uses))
    assert not outcome.verified
    assert why in outcome.line


def changed_claim(name, rule, change, **fields):
    """The outcome for the claims up to one by a rule, which is changed."""
    found = copy.deepcopy(DOCUMENTS[name])
    place = index(found, rule, **fields)
    change(found["claims"][place])
    kept = found["claims"][: place + 1]
    return check_document({**found, "claims": kept, "goal": [kept[-1]["statement"]]})


def put(key, value, part="witness"):
    return lambda claim: claim[part].__setitem__(key, value)


def one_degree_more(claim):
    claim["statement"]["order"] += 1
    claim["work"] *= 10


def degree_less(claim):
    claim["statement"]["order"] -= 1
    claim["witness"]["shifts"].pop()


@pytest.mark.parametrize(
    ("name", "change", "why"),
    [
        ("cubic", put("shifts", ["1", "1", "0", "0"]), "the jet of degree 1 is no eigen-sequence"),
        ("cubic", put("shifts", ["2", "0", "0", "0"]), "the first number is not 1"),
        ("cubic", put("shifts", ["1", "0", "0"]), "not one number for each degree"),
        ("cubic", put("holds", False, "statement"), "do not go with that verdict"),
        ("cubic", degree_less, "there is an eigen-sequence of degree 3"),
        ("other constants", one_degree_more, "the jet of degree 0 is no eigen-sequence"),
        ("cubic", put("order", 101, "statement"), "the order is too large"),
        ("cubic", lambda claim: claim.update(work=10), "more work than stated"),
    ],
)
def test_forged_spectral_conditions(name, change, why):
    outcome = changed_claim(name, "spectral", change)
    assert not outcome.verified
    assert why in outcome.line


def test_constants_beside_e_0_are_no_place_for_jets():
    """With E_A spanned by (1, 1) the stencil w is not that of the function, and nothing follows from e_1 δ - ∇w."""
    found = DOCUMENTS["other constants"]
    claim = DOCUMENTS["cubic"]["claims"][index(DOCUMENTS["cubic"], "jet")]
    family = 1 + max(c["statement"].get("family", 0) for c in found["claims"])
    statement = {**claim["statement"], "family": family}
    uses = [index(found, "constants"), index(found, "limit-stencils")]
    outcome = with_claim("other constants", "jet", statement, uses, claim["witness"])
    assert "the basis of E_A is not e_0" in outcome.line


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (put("component", 2, "statement"), "of the tree has other coordinates"),
        (put("component", 0, "statement"), "there is no such derivative"),
        (put("component", 3, "statement"), "there is no such derivative"),
        (put("words", [[0]]), "not as many words"),
        (lambda claim: claim["witness"]["words"].__setitem__(-1, claim["witness"]["words"][0]), "do not span"),
        (lambda claim: claim["uses"].reverse(), "it uses limit-stencils, not constants"),
        (lambda claim: claim.update(work=claim["work"] // 4), "more work than stated"),
    ],
)
def test_forged_spaces(change, why):
    outcome = changed_claim("quintic", "jet", change, component=1)
    assert not outcome.verified
    assert why in outcome.line, outcome.line


def test_one_component_is_no_jet():
    mask = {"kind": "hermite", "arity": 2, "start": 0, "coefficients": [[["1"]], [["1"]]]}
    outcome = check_document({**EXAMPLE, "mask": mask})
    assert "two components at least" in outcome.line


def test_a_certificate_of_a_vector_mask_is_none_of_a_hermite_mask():
    found = copy.deepcopy(EXAMPLE)
    found["mask"]["kind"] = "vector"
    assert not check_document(found).verified


@pytest.mark.parametrize("name", ["cubic", "quintic", "unseen", "rough", "twice", "two constants", "example"])
def test_every_number_changed(name):
    """A certificate with one number of these rules changed is rejected, or all that it states is true all the same."""
    found, rejected = DOCUMENTS[name], 0
    own = set(KINDS["hermite"].rules) - set(KINDS["vector"].rules)
    numbers = [number for number, claim in enumerate(found["claims"]) if claim["rule"] in own]
    everywhere = [(number, place) for number in numbers for place in places(found["claims"][number])]
    for number, place in everywhere[:: max(1, len(everywhere) // cases(60))]:
        for new in changed(at(found["claims"][number], place)):
            forged = json.loads(json.dumps(found))
            replace_at(forged["claims"][number], place, new)
            forged["goal"] = [forged["claims"][number]["statement"]]
            outcome = check_document(forged)
            rejected += not outcome.verified
            s = forged["claims"][number]["statement"]
            if outcome.verified and s["property"] not in ("jet", "taylor", "derived"):
                assert s["property"] in TRUE_STATEMENTS
                assert TRUE_STATEMENTS[s["property"]](s, name), s
    assert rejected > 3


@pytest.mark.parametrize(
    ("name", "code", "key", "wrong"),
    [
        ("cubic", "SD714", "order", lambda order: order - 1),
        ("cubic", "SD714", "shifts", lambda shifts: (*shifts[:-1], shifts[-1] + 1)),
        ("cubic", "SD716", "order", lambda order: order + 1),
        ("quintic", "SD715", "order", lambda order: 3 - order),
        ("rough", "SD716", "derivative", lambda j: j + 1),
        ("twice", "SD716", "by", lambda by: "SD705"),
        ("two constants", "SD716", "by", lambda by: "SD705"),
    ],
)
def test_a_wrong_finding_is_a_disagreement(name, code, key, wrong):
    analysis = KIND.analyse(scheme(MASKS[name], kind="hermite"), Effort())
    finding = next(each for each in analysis.findings if each.code == code)
    forged = replace(finding, witness={**finding.witness, key: wrong(finding.witness[key])})
    findings = tuple(forged if each is finding else each for each in analysis.findings)
    with pytest.raises((DisagreementError, ValueError)):
        certified(KIND, analysis._replace(findings=findings), (), Effort())


@pytest.mark.parametrize(
    ("name", "code"), [("rough", "SD716"), ("twice", "SD714"), ("twice", "SD716"), ("cubic", "SD714")]
)
def test_a_wrong_verdict_is_a_disagreement(name, code):
    analysis = KIND.analyse(scheme(MASKS[name], kind="hermite"), Effort())
    (finding,) = (each for each in analysis.findings if each.code == code)
    other = Verdict.PROVED if finding.verdict is Verdict.REFUTED else Verdict.REFUTED
    findings = tuple(replace(each, verdict=other) if each is finding else each for each in analysis.findings)
    with pytest.raises(DisagreementError):
        certified(KIND, analysis._replace(findings=findings), (), Effort())
