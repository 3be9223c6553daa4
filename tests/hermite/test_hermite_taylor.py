"""The Taylor scheme: its law on data, published masks, agreement with the exact route, forged certificates."""

import copy
import json
from fractions import Fraction
from math import factorial

import pytest
from flint import fmpq, fmpq_mat
from hypothesis import given, settings
from hypothesis import strategies as st
from matrix_masks import HERMITE_CUBIC, conjugated, de_rham, hermite_interpolation, merrien, scheme, smoothed_jets

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.checker import check_document
from subdiv_cli.kinds.hermite.numbers import HermiteNumbers
from subdiv_cli.kinds.hermite.taylor import taylor_mask
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check

DE_RHAM = de_rham(HERMITE_CUBIC)
MASKS = {
    "cubic": (HERMITE_CUBIC, 2),
    "de Rham": (DE_RHAM, 2),
    "smoothed": (smoothed_jets(DE_RHAM), 2),
    "septic": (hermite_interpolation(4), 2),
    "ternary": (hermite_interpolation(3, 3), 3),
    "other multiple": (conjugated(HERMITE_CUBIC, [[1, 0], [0, Fraction(1, 2)]], [[1, 0], [0, 2]]), 2),
}


def terms_of(mask):
    return {i: fmpq_mat([[fmpq(*Fraction(x).as_integer_ratio()) for x in row] for row in a]) for i, a in mask.items()}


def refined(p, terms, c):
    """S c, of columns by their indices."""
    image = {}
    for i, a in terms.items():
        for j, x in c.items():
            image[i + p * j] = image[i + p * j] + a * x if i + p * j in image else a * x
    return image


def remainders(c, d):
    """T c: what Taylor's formula leaves, one component after the other, and the last derivative."""
    zero = fmpq_mat(d, 1)
    total = {}
    for i in {i - k for i in c for k in (0, 1)}:
        here, ahead = c.get(i, zero), c.get(i + 1, zero)
        rows = [
            ahead[j, 0] - sum(here[l, 0] / factorial(l - j) for l in range(j, d)) if j < d - 1 else here[j, 0]
            for j in range(d)
        ]
        total[i] = fmpq_mat([[x] for x in rows])
    return total


@pytest.mark.parametrize("name", MASKS)
@settings(max_examples=20)
@given(data=st.data())
def test_the_law(name, data):
    """T S_A c = p^-(d-1) S_B T c, equation (30) of Moosmüller & Dyn for d = 2 = p."""
    mask, p = MASKS[name]
    terms = terms_of(mask)
    d = next(iter(terms.values())).nrows()
    entries = st.lists(st.integers(-9, 9), min_size=d, max_size=d)
    columns = data.draw(st.dictionaries(st.integers(-3, 3), entries))
    c = {i: fmpq_mat([[x] for x in column]) for i, column in columns.items()}
    taylor = taylor_mask(p, terms)
    left, right = remainders(refined(p, terms, c), d), refined(p, taylor, remainders(c, d))
    zero = fmpq_mat(d, 1)
    assert all(left.get(i, zero) * p ** (d - 1) == right.get(i, zero) for i in {*left, *right})


def test_the_printed_mask():
    """Formulas (31) to (34) for cubic Hermite interpolation."""
    quarter = fmpq(1, 4)
    assert taylor_mask(2, terms_of(HERMITE_CUBIC)) == {
        -2: fmpq_mat([[0, -1], [0, 0]]) * quarter,
        -1: fmpq_mat([[0, 2], [0, -1]]) * quarter,
        0: fmpq_mat([[4, 1], [0, 4]]) * quarter,
        1: fmpq_mat([[-2, -2], [6, 5]]) * quarter,
    }


def of(mask, p=2):
    result = check(scheme(mask, p, kind="hermite"), (), Effort()).result
    return next(finding for finding in result.findings if finding.code == "SD717")


@pytest.mark.parametrize(
    ("mask", "order"),
    [(HERMITE_CUBIC, 1), (DE_RHAM, 2), (smoothed_jets(HERMITE_CUBIC), 2), (smoothed_jets(DE_RHAM), 3)],
    ids=["44", "45", "44 smoothed", "45 smoothed"],
)
def test_published_schemes_contract(mask, order):
    """Examples 44 and 45: HC^1 and HC^2 by the Taylor scheme, and one order more when they are smoothed."""
    finding = of(mask)
    assert finding.verdict is Verdict.PROVED
    assert finding.witness["order"] == order
    assert finding.witness["norm"] < 1


@pytest.mark.parametrize(
    ("mask", "reason"),
    [
        (MASKS["other multiple"][0], None),
        (merrien("-1/8", "2"), None),
        (hermite_interpolation(4), "no norm"),
    ],
    ids=["another multiple of the derivative", "not HC^1", "slow"],
)
def test_where_it_says_nothing(mask, reason):
    finding = of(mask)
    assert finding.verdict is (Verdict.SKIPPED if reason is None else Verdict.UNDECIDED)
    assert reason is None or reason in finding.reason


def test_it_never_says_more_than_the_exact_route():
    decided = 0
    for path in sorted((masks_directory() / "hermite").rglob("*.toml")):
        mask = read_path(path).scheme({})
        result = check(mask, (), Effort()).result
        finding = next(finding for finding in result.findings if finding.code == "SD717")
        if finding.verdict is Verdict.PROVED:
            decided += 1
            assert result.convergent is Verdict.PROVED
            assert result.smoothness.order == finding.witness["order"]
        if HermiteNumbers(mask, Effort()).taylor is None:
            assert path.stem == "unseen_linear"
    assert decided >= 8


DOCUMENT = json.loads(json.dumps(check(scheme(DE_RHAM, kind="hermite"), (), Effort()).document))


def forged(change):
    document = copy.deepcopy(DOCUMENT)
    claims = {claim["rule"]: number for number, claim in enumerate(document["claims"])}
    change(document["claims"], claims)
    outcome = check_document(document)
    assert not outcome.verified
    return outcome.line


def by(rule, change):
    """A change of the last claim by a rule."""
    return lambda claims, numbers: change(claims[numbers[rule]])


def entry(claim):
    claim["witness"]["coefficients"][0][0][0] = "7"


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (by("taylor", entry), "the Taylor mask is another"),
        (by("taylor", lambda claim: claim["witness"].update(start=5)), "the Taylor mask is another"),
        (by("taylor", lambda claim: claim["uses"].clear()), "does not use"),
        (by("taylor", lambda claim: claim.update(work=1)), "more work than stated"),
        (by("taylor-derived", entry), "the derived mask is another"),
        (by("taylor-derived", lambda claim: claim["statement"].update(order=1)), "not taylor"),
        (by("taylor-derived", lambda claim: claim["statement"].update(order=0)), "not positive"),
        (by("taylor-derived", lambda claim: claim.update(rule="derived")), "unknown rule"),
        (by("taylor-converges", lambda claim: claim["statement"].update(order=2)), "not that of the last derivative"),
        (by("taylor-converges", lambda claim: claim["uses"].clear()), "does not use"),
        (by("taylor-smooth", lambda claim: claim["statement"].update(order=3)), "the norm is that of derived scheme 2"),
        (by("taylor-smooth", lambda claim: claim["statement"].update(order=1)), "the norm is that of derived scheme 2"),
        (by("taylor-smooth", lambda claim: claim.update(rule="derived-smooth")), "unknown rule"),
        (by("derived-norm", lambda claim: claim["statement"].update(norm="1/2")), "it is another number"),
    ],
)
def test_forged_claims(change, why):
    line = forged(change)
    assert why in line, line
