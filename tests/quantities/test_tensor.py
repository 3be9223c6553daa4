"""Tensor products: found whatever the order of the variables, and decided as the differences V_k decide them."""

import json
import random
from dataclasses import replace
from fractions import Fraction
from itertools import product

import pytest
from support import answer, findings, four_point, scheme, shipped_multivariate

from subdiv_cli.catalog.trust import trusted
from subdiv_cli.checker import check_document
from subdiv_cli.exact.closed import compare
from subdiv_cli.kinds.multivariate import stages
from subdiv_cli.kinds.multivariate.numbers.tensor import tensor_factors
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort, Log, Verdict
from subdiv_cli.model.findings import UNWRITTEN
from subdiv_cli.pipeline import check
from subdiv_cli.spaces.lattice import Lattice

HAT, HAT3 = scheme(["1/2", 1, "1/2"], start=-1), scheme(["1/3", "2/3", 1, "2/3", "1/3"], arity=3, start=-2)
CUBIC = scheme(["1/8", "1/2", "3/4", "1/2", "1/8"], start=-2)
TERNARY = scheme([Fraction(c, 99) for c in (-4, -7, 0, 34, 76, 99, 76, 34, 0, -7, -4)], arity=3, start=-5)


def terms_of(factor):
    if isinstance(factor, MultivariateScheme):
        return factor.terms
    return {(factor.start + i,): c for i, c in enumerate(factor.coefficients) if c}


def rows_of(factor):
    return factor.dilation if isinstance(factor, MultivariateScheme) else ((factor.arity,),)


def tensor(*parts):
    """Of pairs of variables and a factor in them."""
    s = sum(len(variables) for variables, _ in parts)
    rows, terms = [[0] * s for _ in range(s)], {}
    for variables, factor in parts:
        for i, row in zip(variables, rows_of(factor), strict=True):
            for j, x in zip(variables, row, strict=True):
                rows[i][j] = x
    for chosen in product(*(terms_of(factor).items() for _, factor in parts)):
        alpha, value = [0] * s, Fraction(1)
        for (variables, _), (x, c) in zip(parts, chosen, strict=True):
            value *= c
            for i, y in zip(variables, x, strict=True):
                alpha[i] = y
        terms[tuple(alpha)] = value
    return MultivariateScheme(dilation=tuple(map(tuple, rows)), terms=terms)


def factors_of(mask):
    return {factor.variables: factor.scheme for factor in tensor_factors(mask, Lattice(mask.dilation))}


def test_random_factors_are_found_again():
    rng = random.Random(1)
    for _ in range(50):
        parts = []
        for i in range(rng.choice([2, 3, 4])):
            arity, size = rng.choice([2, 3]), rng.randint(2, 5)
            c = [Fraction(rng.choice([-3, -1, 1, 2, 5])) for _ in range(size)]
            if sum(c):
                c = [arity * x / sum(c) for x in c]
                parts.append(((len(parts),), scheme(c, arity=arity, start=rng.randint(-3, i))))
        if len(parts) > 1:
            assert factors_of(tensor(*parts)) == dict(parts)


@pytest.mark.parametrize("variables", [(0, 1), (0, 2), (1, 2)])
def test_factors_in_several_variables(variables):
    butterfly = shipped_multivariate("butterfly")
    (rest,) = {0, 1, 2} - set(variables)
    assert factors_of(tensor((variables, butterfly), ((rest,), HAT))) == {variables: butterfly, (rest,): HAT}


@pytest.mark.parametrize("name", ["butterfly", "loop", "courant", "quincunx_interpolatory", "box_bcc_linear"])
def test_what_is_no_product_has_no_factors(name):
    assert not factors_of(shipped_multivariate(name))


def test_one_coefficient_that_is_another():
    terms = dict(tensor(((0,), CUBIC), ((1,), four_point("1/16"))).terms)
    terms[0, 0], terms[0, 1] = terms[0, 0] + Fraction(1, 100), terms[0, 1] - Fraction(1, 100)
    assert not factors_of(MultivariateScheme(dilation=((2, 0), (0, 2)), terms=terms))


def test_a_dilation_that_mixes_the_variables_or_reverses_one():
    hats = tensor(((0,), HAT), ((1,), HAT)).terms
    assert not factors_of(MultivariateScheme(dilation=((2, 1), (0, 2)), terms=hats))
    assert not factors_of(MultivariateScheme(dilation=((-2, 0), (0, 2)), terms=hats))


@pytest.mark.parametrize(
    "parts",
    [
        (((0,), CUBIC), ((1,), four_point("1/16"))),
        (((0,), four_point("1/10")), ((1,), four_point("1/16"))),
        (((0,), four_point("1/32")), ((1,), HAT)),
    ],
    ids=["cubic", "two weights", "hat"],
)
def test_the_differences_decide_the_same(parts, monkeypatch):
    by_factors = answer(tensor(*parts))
    monkeypatch.setattr(stages, "tensor_factors", lambda *_: ())
    by_differences = answer(tensor(*parts))
    assert not findings(by_differences, "SD609")
    for key in ("convergent", "stable", "smoothness", "sum_rule_order", "generation", "reproduction"):
        assert getattr(by_factors, key) == getattr(by_differences, key), key
    assert compare(by_factors.holder.exact, by_differences.holder.exact) == 0
    assert by_factors.sobolev.lower == pytest.approx(by_differences.sobolev.lower)


def test_dilations_that_are_not_isotropic():
    """Exponents to the bases 2 and 3: the four-point scheme has 2, the ternary one log3(11) = 2.18, cubic splines 3."""
    rough = answer(tensor(((0,), four_point("1/16")), ((1,), TERNARY)))
    smooth = answer(tensor(((0,), TERNARY), ((1,), CUBIC)))
    assert rough.holder.exact == 2
    assert smooth.holder.exact == Log(3, Fraction(11), 1)
    assert (rough.smoothness.order, smooth.smoothness.order) == (1, 2)
    assert rough.smoothness.sharp
    assert answer(tensor(((0,), HAT), ((1,), HAT3))).holder.exact == 1


def test_an_unstable_factor():
    """(1 - z + z²) times the four-point mask: φ + φ(· - 1) + φ(· - 2), as smooth and not stable."""
    c = four_point("1/16").coefficients
    times = [a - b + d for a, b, d in zip((*c, 0, 0), (0, *c, 0), (0, 0, *c), strict=True)]
    found = answer(tensor(((0,), scheme(times)), ((1,), HAT)))
    assert found.convergent is Verdict.PROVED
    assert found.stable is Verdict.REFUTED
    assert found.holder.exact == 1


def test_the_reduced_mask_of_an_unstable_factor_is_another_mask():
    """That it is stable is proved in the certificate of the factor, and says nothing of the product."""
    c = four_point("1/16").coefficients
    times = [a - b + d for a, b, d in zip((*c, 0, 0), (0, *c, 0), (0, 0, *c), strict=True)]
    document = json.loads(json.dumps(check(tensor(((0,), scheme(times)), ((1,), HAT)), (), Effort()).document))
    claims = {claim["rule"]: claim for claim in document["claims"]}
    unstable, said = claims["tensor-product"]["witness"]["certificates"][0], {"property": "stable", "holds": True}
    unstable["goal"].append({**said, "mask": 1})
    assert check_document(document).verified
    claims["tensor-stable"]["statement"] = said
    document["goal"] = [said]
    assert "the factors do not say so" in check_document(document).line


def test_a_factor_that_diverges():
    found = answer(tensor(((0,), CUBIC), ((1,), four_point(1))))
    assert found.convergent is Verdict.REFUTED
    assert found.smoothness.order is None
    assert findings(found, "SD612")[0].verdict is Verdict.REFUTED
    assert findings(found, "SD614")[0].verdict is Verdict.UNDECIDED


def test_factors_of_factors_and_what_the_cache_believes():
    """Butterfly in (z1, z3) times hat in z2: certificates inside, and an altered exponent is not believed."""
    mask = tensor(((0, 2), shipped_multivariate("butterfly")), ((1,), HAT))
    checked = check(mask, (), Effort())
    assert checked.document is not None
    assert check_document(checked.document).verified
    assert checked.result.holder.exact == 1
    text = checked.certificate_text()
    assert trusted(checked.result, text, mask, ())
    for change in (
        {"holder": checked.result.holder._replace(exact=Fraction(2))},
        {"holder": checked.result.holder._replace(lower=1.5)},
        {"sobolev": checked.result.sobolev._replace(upper=1.2)},
    ):
        assert not trusted(replace(checked.result, **change), text, mask, ())


def test_a_factor_with_findings_that_its_certificate_leaves_out():
    """Of weights with 1000 digits no Bezout cofactors are computed: what rests on stability is undecided."""
    w = Fraction(10**999 + 7, 10**1000 + 9)
    checked = check(tensor(((0,), four_point(w)), ((1,), HAT)), (), Effort(150))
    assert checked.document is not None
    assert check_document(checked.document).verified
    found = {finding.code: finding for finding in checked.result.findings}
    assert found["SD611"].verdict is Verdict.PROVED
    assert found["SD611"].claims
    assert found["SD612"].claims
    assert (found["SD616"].verdict, found["SD616"].reason) == (Verdict.UNDECIDED, UNWRITTEN)
    assert checked.result.stable is Verdict.UNDECIDED
