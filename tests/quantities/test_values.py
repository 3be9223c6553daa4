"""Exact values against float cascades, the refinement equation, and the reduction; error bounds against errors."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from support import b_spline, corner_cutting, deslauriers_dubuc, findings, four_point, scheme, six_point

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.kinds.scalar.numbers.error_bounds import best_bound, bounds
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.values import at_fractions, at_integers, iterated, support
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import show

F = Fraction
MASKS = {
    "cubic B-spline": (scheme([1, 4, 6, 4, 1], start=-2, over=8), 2),
    "quintic B-spline": (b_spline(5), 4),
    "four-point": (four_point("1/16"), 1),
    "six-point": (six_point("1/100"), 2),
    "interpolatory, 8 points": (deslauriers_dubuc(8), 3),
    "corner cutting": (corner_cutting("4/5", "1/10"), 0),
    "ternary": (scheme([-4, -7, 0, 34, 76, 99, 76, 34, 0, -7, -4], start=-5, arity=3, over=99), 2),
    "quaternary": (scheme(b_spline(3, 4).coefficients, start=-3, arity=4), 2),
    "(1, 1, 1, 1)/2": (scheme([1, 1, 1, 1], over=2), 0),
    "unstable, C^1": (scheme([1, 1, 2, 2, 1, 1], over=4), 1),
    "divergent, Chaikin in z^3": (scheme([1, 0, 0, 3, 0, 0, 3, 0, 0, 1], over=4), 1),
}


def cascade(mask, order, levels):
    """The divided differences of an order of S^levels δ in floats, and the index of S^levels δ's first coefficient."""
    p, a, data, first = mask.arity, np.array([float(c) for c in mask.coefficients]), np.array([1.0]), 0
    for _ in range(levels):
        spread = np.zeros((len(data) - 1) * p + 1)
        spread[::p] = data
        data, first = np.convolve(spread, a), p * first + mask.start
    return np.diff(np.pad(data, order), order) * float(p) ** (levels * order), first


@pytest.mark.parametrize("name", [n for n in MASKS if "divergent" not in n])
@pytest.mark.parametrize("order", range(3))
def test_a_cascade_of_twelve_levels(name, order):
    """At every point i/p^m the exact value is a fixed combination of the data of level 12: equal to rounding."""
    mask, smooth = MASKS[name]
    if order > smooth:
        pytest.skip("not so smooth")
    numbers = ScalarNumbers(mask, Effort())
    levels = {2: 12, 3: 8, 4: 6}[mask.arity]
    values = at_integers(numbers, order)
    exact = at_fractions(numbers.symbol, numbers.p, values, order, levels)
    # φ^(j) at level m from the float data of level m by the limit stencil, written as differences of order j
    v = [float(c) for c in divided(values, order)]
    data, first = cascade(mask, order, levels)
    floats = np.convolve(data, v)
    start = first + values.low
    by_index = {i: float(c) for i, c in pairs(exact).items()}
    scale = max(map(abs, by_index.values()))
    worst = max(abs(by_index.get(start + i, 0.0) - x) for i, x in enumerate(floats))
    rounding = {0: 1e-12, 1: 1e-9, 2: 1e-5}[order]  # a difference of neighbours loses p^levels
    assert worst <= rounding * scale


def divided(values, order):
    """h with values(z) = (1/z - 1)^order h(z), up to the shift that padding makes good."""
    for _ in range(order):
        values, remainder = values.divide(Laurent.from_coefficients(0, [1, -1]))
        assert not remainder.poly
    return values.coefficients()


@pytest.mark.parametrize("name", MASKS)
def test_values_satisfy_the_refinement_equation_at_every_level(name):
    """φ^(j)(x) = Σ a_α p^j φ^(j)(px - α) at i/p^2, which also holds where S diverges and the values come from φ0."""
    mask, smooth = MASKS[name]
    numbers, p = ScalarNumbers(mask, Effort()), mask.arity
    for order in range(smooth + 1):
        values = at_integers(numbers, order)
        fine = pairs(at_fractions(numbers.symbol, p, values, order, 2))
        coarse = pairs(at_fractions(numbers.symbol, p, values, order, 1))
        for i in range(min(fine) - 2, max(fine) + 3):
            terms = (c * p**order * coarse.get(i - p * (mask.start + k), 0) for k, c in enumerate(mask.coefficients))
            assert fine.get(i, 0) == sum(terms)
        assert all(fine.get(p * i, 0) == value for i, value in coarse.items())


def pairs(laurent):
    return {laurent.low + i: c for i, c in enumerate(laurent.coefficients())}


@pytest.mark.parametrize("name", MASKS)
def test_partition_of_unity_and_support(name):
    mask, _ = MASKS[name]
    numbers, p = ScalarNumbers(mask, Effort()), mask.arity
    values = at_integers(numbers, 0)
    fine = pairs(at_fractions(numbers.symbol, p, values, 0, 3))
    for r in range(p**3):
        assert sum(value for i, value in fine.items() if i % p**3 == r) == 1
    first, last = support(numbers)
    assert first * p**3 < min(fine)
    assert max(fine) < last * p**3


def test_the_values_of_an_unstable_phi_are_those_of_its_own_matrices():
    """(1, 1, 1, 1)/2 converges, so A_0 has a unique left eigenvector, whatever the reduction says."""
    from subdiv_cli.kinds.scalar.numbers.values import limit_weights

    for name in ("(1, 1, 1, 1)/2", "unstable, C^1"):
        numbers = ScalarNumbers(MASKS[name][0], Effort())
        assert numbers.reduction
        assert limit_weights(numbers, 0).reversed() == at_integers(numbers, 0)


def test_the_limit_of_any_data():
    """Σ f_α φ(·-α) at i/p^m, in one product."""
    numbers = ScalarNumbers(four_point("1/16"), Effort())
    values, data = at_integers(numbers, 0), Laurent.from_coefficients(-1, [2, -1, 0, F(1, 2)])
    limit = pairs(at_fractions(numbers.symbol, 2, values, 0, 3, data))
    phi = pairs(at_fractions(numbers.symbol, 2, values, 0, 3))
    for i, value in limit.items():
        assert value == sum(c * phi.get(i - 8 * k, 0) for k, c in pairs(data).items())
    assert [limit[8 * i] for i in range(-1, 3)] == [2, -1, 0, F(1, 2)]


@pytest.mark.parametrize("name", [n for n in MASKS if "divergent" not in n])
def test_the_error_bound_holds_and_is_not_silly(name):
    """max |S^∞ f - f^k| at fine points, for random data, for k = 0, …, 4, against C μ^⌊k/L⌋ ‖Δf‖."""
    mask, _ = MASKS[name]
    numbers, p = ScalarNumbers(mask, Effort()), mask.arity
    rng = np.random.default_rng(7)
    data = Laurent.from_coefficients(0, [F(int(x), 8) for x in rng.integers(-8, 9, 9)])
    differences = data * Laurent.from_coefficients(-1, [1, -1])
    size = max(map(abs, differences.coefficients()))
    depth = {2: 6, 3: 4, 4: 3}[p]
    limit = pairs(at_fractions(numbers.symbol, p, at_integers(numbers, 0), 0, depth, data))
    chosen, first = best_bound(numbers, F(1, 1000)), next(bounds(numbers, 0))
    for k in range(min(5, depth)):
        polygon = pairs(iterated(numbers.symbol, p, k) * data.inflate(p**k))
        step = p ** (depth - k)
        worst = F(0)
        for i in range(min(*limit, min(polygon) * step), max(*limit, max(polygon) * step) + 1):
            left, rest = divmod(i, step)
            value = polygon.get(left, 0) * F(step - rest, step) + polygon.get(left + 1, 0) * F(rest, step)
            worst = max(worst, abs(limit.get(i, 0) - value))
        for bound in (chosen, first):
            assert worst <= bound.constant * bound.norm ** (k // bound.level) * size
        assert k > 0 or first.constant * size < 200 * worst


SMALL = st.fractions(min_value=-1, max_value=2, max_denominator=6)


@given(st.integers(2, 4), st.integers(1, 4), st.lists(SMALL, min_size=1, max_size=3), st.integers(-5, 5), st.booleans())
def test_random_masks_are_certified(p, k, cofactor, start, gapped):
    """`show` raises where the independent checker says no; what is proved has claims, and the values sum to 1."""
    q = Laurent.from_coefficients(start, cofactor)
    q = q.inflate(3) if gapped else q
    assume(q.degree >= 0 and q(1) != 0)
    for _ in range(k):
        q = q * smoothing_factor(p)
    a = q.scale(F(p) / q(1))
    checked, _ = show(scheme(a.coefficients(), start=a.low, arity=p), F(1, 100), Effort(2000))
    assert checked.document is not None
    for found in checked.result.findings:
        assert bool(found.claims) is (found.verdict in (Verdict.PROVED, Verdict.REFUTED)), found.code
    (values,) = findings(checked.result, "SD501")
    if values.verdict is Verdict.PROVED:
        assert sum(values.witness["values"][0]) == 1
        assert len(values.witness["values"]) == checked.result.refinable.order + 1
