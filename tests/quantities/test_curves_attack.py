"""Random families of matrices, whose curves are known or not, against what floats see: convergence, joints, exponents.

The floats iterate the matrices and take differences of the refined points, those across joints among them. They share
no code with what decides.
"""

from __future__ import annotations

import math
from collections import Counter
from fractions import Fraction
from math import comb

import pytest
from matrix_families import (
    Built,
    degenerate_part,
    estimated,
    family,
    gap,
    growth,
    segment,
    signed,
    stochastic,
    structured,
)
from support import cases, seeded

from subdiv_cli.model import INFINITY, Effort, Exponent, Result, Verdict
from subdiv_cli.model.order import enclosure
from subdiv_cli.pipeline import check

SORTS = (structured, structured, structured, segment, stochastic, signed)
LEVELS = {2: 12, 3: 8}
OFF = 0.2
"""How far estimates at these levels are off: the decay of differences sets in slowly where two rates are near."""


def decided(k: int) -> tuple[Built, Result]:
    rng = seeded(k)
    built = SORTS[k % len(SORTS)](rng)
    return built, check(built.scheme, (), Effort(2000)).result


def attack(built: Built, result: Result) -> list[str]:
    """What floats have against the result, and what sort of scheme it is."""
    scheme, p = built.scheme, len(built.scheme.matrices)
    seen = [built.sort, f"convergent {result.convergent.value}", f"well defined {result.well_defined.value}"]
    rate = growth(scheme, 5, 11) if p == 2 else growth(scheme, 3, 7)
    if result.convergent is Verdict.PROVED:
        assert rate < 1.1, rate
    if result.convergent is Verdict.REFUTED:
        assert rate > 0.9, rate
    if result.convergent is not Verdict.PROVED:
        return seen
    assert (gap(scheme) < 1e-9) is (result.well_defined is Verdict.PROVED)
    if result.well_defined is Verdict.PROVED:
        seen += exponent(built, result)
    return seen


def exponent(built: Built, result: Result) -> list[str]:
    assert result.polynomials is not None
    assert result.holder is not None
    p = len(built.scheme.matrices)
    estimate = estimated(built.scheme, result.polynomials + 2, LEVELS[p])
    if result.smoothness.order == INFINITY:
        assert estimate == math.inf
        return ["polynomial"]
    found = {f.code: f for f in result.findings}
    corner = "SD815" in found and found["SD815"].verdict is Verdict.REFUTED
    if result.holder.exact is not None:
        alpha = float(enclosure(result.holder.exact)[0])
        assert abs(alpha - estimate) < OFF, (alpha, estimate)
    if result.holder.lower is not None:
        assert estimate > result.holder.lower - OFF
    if result.holder.upper is not None:
        assert estimate < result.holder.upper + OFF
    order = result.smoothness.order
    assert order is not None
    if result.smoothness.sharp and result.holder.upper is not None:
        assert result.holder.upper <= order + 1 + 1e-9
    return [f"C^{order}", "exact" if result.holder.exact is not None else "enclosed", "corner" if corner else "inside"]


def test_random_families() -> None:
    count = cases(72)
    mix = Counter(word for k in range(count) for word in attack(*decided(k)))
    for word, least in {
        "convergent proved": 0.4, "convergent refuted": 0.1, "well defined proved": 0.4, "well defined refuted": 0.05,
        "polynomial": 0.03, "corner": 0.1, "inside": 0.1, "C^0": 0.2, "C^1": 0.03, "exact": 0.3, "degenerate": 0.05,
    }.items():  # fmt: skip
        assert mix[word] >= least * count, (word, mix)


@pytest.mark.parametrize("k", range(6))
def test_more_control_points_change_nothing(k: int) -> None:
    """A coordinate that is 0 on the curve: the same curve, of fewer dimensions than there are control points."""
    rng = seeded(1000 + k)
    built = structured(rng)
    larger = degenerate_part(rng, built.scheme)
    one, other = (check(scheme, (), Effort(2000)).result for scheme in (built.scheme, larger))
    assert other.convergent is one.convergent
    if one.holder is not None and one.holder.exact is not None:
        assert other.holder is not None
        assert (other.holder.exact, other.smoothness) == (one.holder.exact, one.smoothness)
        assert other.polynomials == one.polynomials


def test_patterns_decide_where_the_effort_ends() -> None:
    """Without any bound of the radius stochastic matrices are seen to converge, or not, and the curve to be C^0."""
    third = Fraction(1, 3)
    line = family([[[1, 0], [1 - third, third]], [[1 - third, third], [0, 1]]])
    result = check(line, (), Effort(0)).result
    assert {f.code for f in result.findings if f.verdict is Verdict.PROVED} >= {
        "SD812",
        "SD811",
        "SD813",
        "SD810",
        "SD816",
    }
    (found,) = (f for f in result.findings if f.code == "SD811")
    assert found.witness == {"by": "SD812"}
    assert (result.smoothness.order, result.smoothness.sharp, result.holder) == (0, False, Exponent())
    cycle = family([[[1, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 0], [0, 0, 1], [0, 0, 1]]])
    result = check(cycle, (), Effort(100)).result
    assert result.convergent is Verdict.REFUTED


@pytest.mark.parametrize("k", range(8))
def test_more_effort_gives_no_less(k: int) -> None:
    built = SORTS[k % len(SORTS)](seeded(2000 + k))
    less, more = (check(built.scheme, (), Effort(work)).result for work in (50, 4000))
    for question in ("convergent", "well_defined"):
        assert getattr(less, question) in (getattr(more, question), Verdict.UNDECIDED, Verdict.SKIPPED)
    if less.holder is not None and less.holder.exact is not None:
        assert more.holder is not None
        assert more.holder.exact == less.holder.exact


@pytest.mark.parametrize("order", [9, 16, 24])
def test_many_control_points(order: int) -> None:
    """Bernstein polynomials of high degree, and the same with the points in another order."""
    rows = []
    for end in range(order):  # point j of the first half is the mean of binomials
        rows.append([Fraction(comb(end, k), 2**end) if k <= end else Fraction(0) for k in range(order)])
    matrices = [rows, [row[::-1] for row in rows[::-1]]]
    result = check(family(matrices), (), Effort()).result
    assert (result.smoothness.order, result.polynomials) == (INFINITY, order - 1)
