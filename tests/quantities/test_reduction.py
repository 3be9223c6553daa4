"""Unstable masks: the reduction is exact, ends, and undoes what made them unstable."""

from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from support import answer, four_point, scheme

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.kinds.scalar.numbers.operators import apply, symbol
from subdiv_cli.kinds.scalar.numbers.stability import reduction
from subdiv_cli.model import Verdict

HAT = Laurent.from_coefficients(0, [Fraction(1, 2), 1, Fraction(1, 2)])
CHAIKIN = Laurent.from_coefficients(0, [Fraction(c, 4) for c in (1, 3, 3, 1)])


def twist(a, g, p):
    """a(z) g(z^p)/g(z): φ becomes Σ g_j φ(·-j)/g(1) times a constant. None where it is no polynomial."""
    quotient, remainder = (a * g.inflate(p)).divide(g)
    return None if remainder.poly else quotient


def test_a_stable_mask_is_left_alone():
    assert reduction(CHAIKIN, 2) == ()
    assert reduction(symbol(four_point("1/16")), 2) == ()


@pytest.mark.parametrize(
    ("mask", "cycle"),
    [([1, 1, 1, 1], None), ([1, 0, 0, 2, 0, 0, 1], 3), ([1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1], 5)],
)
def test_back_to_the_hat_function(mask, cycle):
    steps = reduction(Laurent.from_coefficients(0, [Fraction(c, 2) for c in mask]), 2)
    assert steps[-1].symbol.coefficients() == HAT.coefficients()
    assert steps[0].cycle == cycle


@given(st.sampled_from([HAT, CHAIKIN]), st.sampled_from([[1, 1], [1, 0, 1], [1, 1, 1], [1, 1, 1, 1, 1], [5, -6, 5]]))
def test_a_twist_is_undone(a, g):
    twisted = twist(a, Laurent.from_coefficients(0, g), 2)
    assume(twisted is not None and twisted.degree > a.degree)
    steps = reduction(twisted, 2)
    assert steps
    assert steps[-1].symbol.degree <= a.degree
    result = answer(scheme(twisted.coefficients()))
    assert result.stable is Verdict.REFUTED
    assert (result.refinable.order, result.refinable.sharp) == (a.degree - 2, True)


def test_phi_is_the_combination_that_the_reduction_says():
    """For (1,1,1,1)/2 and its reduced mask, the hat: S^L δ is near φ = (h + h(·-1))/2."""
    (step,) = reduction(Laurent.from_coefficients(0, [Fraction(1, 2)] * 4), 2)
    a, data, hat = Laurent.from_coefficients(0, [Fraction(1, 2)] * 4), {0: Fraction(1)}, {0: Fraction(1)}
    for _ in range(8):
        data, hat = apply(a, 2, data), apply(step.symbol, 2, hat)
    g = step.factor.coefficients()
    total = sum(g)
    for i, value in data.items():
        combined = sum(c * hat.get(i - 256 * j, Fraction(0)) for j, c in enumerate(g)) / total
        assert abs(value - combined) < Fraction(1, 50)


def test_every_step_is_an_exact_division():
    a = Laurent.from_coefficients(0, [Fraction(c, 4) for c in (1, 1, 2, 2, 1, 1)])
    for step in reduction(a, 2):
        assert step.symbol * step.factor.inflate(2) == a * step.factor
        assert step.factor(1) != 0
        a = step.symbol
