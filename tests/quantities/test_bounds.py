"""No finding of a report proves more than its short answers say: bounds are the best of all routes.

With λ the base of exponents, d the dimension, α the Hölder and s the Sobolev exponent, k the order of the sum rules:
s - d/2 <= α <= s; φ ∈ C^n has α >= n; α > n has φ ∈ C^n; a stable φ has α <= k and s <= k, and is no C^n where α <= n
or s <= n; a scheme that converges has a continuous φ, and one whose φ is not continuous diverges. M is isotropic where
anything is said of exponents.
"""

import math
from collections import Counter
from fractions import Fraction

import pytest
from random_masks import random_multivariate, random_scalar
from support import answer, cases, findings, four_point, multivariate_scheme, scheme, seeded, shipped_results

from subdiv_cli.certificate import claims
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Verdict
from subdiv_cli.spaces.lattice import Lattice

NEAR = 1e-9


def logarithm(x):
    return math.log(x.numerator) - math.log(x.denominator)


def base_of(mask):
    """ln λ, the dimension, and whether exponents are spoken of."""
    if mask.kind == "scalar":
        return math.log(mask.arity), 1, True
    lattice = Lattice(mask.dilation)
    return math.log(lattice.index) / lattice.dimension, lattice.dimension, lattice.is_isotropic


def from_norms(result, base):
    """What the norms and radii of findings say of α from below, by code."""
    for finding in result.findings:
        w = finding.witness
        if finding.verdict is not Verdict.PROVED:
            continue
        if finding.code == "SD301" and "norm" in w:
            yield finding.code, w["nu"] - 1 - logarithm(w["norm"]) / base / w["level"]
        if finding.code in ("SD310", "SD605"):
            bound = w["root"]["high"] if "root" in w else w["bound"]
            yield finding.code, -logarithm(bound) / base / w["length"]
        if finding.code == "SD606":
            yield finding.code, -logarithm(w["norm"]) / base / w["level"]
        if finding.code in ("SD604", "SD607"):
            pairs = zip(w["norms"], w["levels"], strict=True)
            slowest = min(-logarithm(x) / base / level for x, level in pairs)
            yield finding.code, slowest + (finding.code == "SD607")


def missing(mask, result):
    """What follows from a result and its findings and is not said."""
    base, d, isotropic = base_of(mask)
    order, sharp = result.refinable
    lower, upper = (result.holder.lower, result.holder.upper) if result.holder else (None, None)
    least, most = (result.sobolev.lower, result.sobolev.upper) if result.sobolev else (None, None)
    known = lower is not None or upper is not None
    orders = {"converges": 0 if result.convergent is Verdict.PROVED else None}
    orders["α"] = math.ceil(lower) - 1 if lower is not None and lower > 0 else None
    yield from (f"C^{n} by {by}" for by, n in orders.items() if n is not None and (order is None or order < n))
    if order is None and sharp and result.convergent is not Verdict.REFUTED:
        yield "S diverges, as φ is not continuous"
    if not isotropic or not (result.sum_rule_order and known):
        return
    below = [*from_norms(result, base), ("the order", order), ("s", None if least is None else least - d / 2)]
    if mask.kind == "multivariate" and lower is None:  # a factor or a box spline with an exponent that is not positive
        below = [(by, x) for by, x in below if x is not None and x > 0]
    yield from (f"α >= {x} by {by}" for by, x in below if x is not None and (lower is None or lower < x - NEAR))
    stable = mask.kind == "scalar" or result.stable is Verdict.PROVED
    above = [("s", most), ("the order", (0 if order is None else order + 1) if sharp else None)]
    above += [("k", result.sum_rule_order)] if result.stable is Verdict.PROVED else []
    yield from (f"α <= {x} by {by}" for by, x in above if x is not None and (upper is None or upper > x + NEAR))
    if order is not None and stable and not sharp and min(x for x in (upper, most) if x is not None) <= order + 1:
        yield f"no C^{order + 1}"
    for by, x in (("α", lower), ("the order", order)):
        if x is not None and (least is None or least < x - NEAR):
            yield f"s >= {x} by {by}"
    for by, x in (("α", None if upper is None else upper + d / 2), above[-1] if above[-1][0] == "k" else ("", None)):
        if x is not None and (most is None or most > x + NEAR):
            yield f"s <= {x} by {by}"


@pytest.mark.parametrize("work", [300, 2000])
@pytest.mark.parametrize("make", [random_scalar, random_multivariate])
def test_nothing_is_proved_beyond_the_bounds(make, work):
    rng, mix = seeded(4), Counter()
    for _ in range(cases(60 if make is random_scalar else 16)):
        mask = make(rng)
        result = answer(mask, work)
        assert not [*missing(mask, result)], mask
        mix[result.convergent] += 1
        mix[result.stable] += 1
        mix["smooth"] += (result.refinable.order or 0) > 0
    assert mix[Verdict.PROVED] > 8
    assert mix[Verdict.REFUTED] > 2
    assert mix["smooth"] > 1


def long_masks(rng, count):
    """Masks of up to 66 coefficients, arbitrary but for their sum rules: most radii are only enclosed."""
    for _ in range(count):
        p, k = rng.choice((2, 3)), rng.randint(1, 5)
        terms = [Fraction(1), *(Fraction(rng.randint(-9, 9)) for _ in range(rng.randint(4, 40))), Fraction(-2)]
        terms[rng.randrange(1, len(terms) - 1)] += rng.randint(1, 300)
        for _ in range(k):
            terms = [sum(terms[max(0, i - p + 1) : i + 1]) for i in range(len(terms) + p - 1)]
        yield scheme(terms, arity=p, over=sum(terms) / p)


def test_long_masks():
    exact, rng = Counter(), seeded(5)
    for mask in long_masks(rng, cases(20)):
        result = answer(mask, 300)
        assert not [*missing(mask, result)], mask
        exact[result.holder is not None and result.holder.exact is not None] += 1
    assert exact[False] > 5


def test_the_catalog():
    for result in (each for each in shipped_results() if each.kind in ("scalar", "multivariate")):
        assert not [*missing(read_path(result.file).scheme(), result)], result.file


def by(finding):
    return finding.witness["by"]


def test_a_matrix_norm_bounds_the_exponent_too():
    """C^1 by a matrix scheme of differences: α >= 1 as well, where the polytope had no time for more than α >= -0.3."""
    mask = multivariate_scheme(
        {
            (0, 0): Fraction(3, 8), (1, -1): Fraction(-1, 8), (1, 0): Fraction(3, 4), (1, 1): Fraction(1, 4),
            (2, -1): Fraction(-1, 4), (2, 0): Fraction(3, 8), (2, 1): Fraction(1, 2), (3, -1): Fraction(-1, 8),
            (3, 1): Fraction(1, 4),
        },
        ((0, -2), (1, 1)),
    )  # fmt: skip
    result = answer(mask, 300)
    (lower,) = findings(result, "SD614")
    (norms,) = findings(result, "SD606")
    bound = -2 * math.log2(norms.witness["norm"]) / norms.witness["level"]
    assert result.holder.lower >= bound - NEAR > 0
    assert by(lower) in ("SD606", "SD617")


def test_where_the_best_is_too_dear_the_next_best_is_certified(monkeypatch):
    """The checker has work for the norms of the four-point scheme, not for the polytope that gives its exponent."""
    mask = four_point("1/32")
    whole = answer(mask)
    assert whole.holder.exact is not None
    monkeypatch.setattr(claims, "MOST_WORK", 2500)
    result = answer(mask)
    assert result.holder is not None
    assert result.holder.exact is None
    assert 0 < result.holder.lower < whole.holder.lower + NEAR < whole.holder.upper + 2 * NEAR
    assert not [*missing(mask, result)]
