"""Parameter sweeps across known boundaries: within 10^-12 of them the verdict flips exactly where it must."""

from fractions import Fraction

import pytest
from support import answer, corner_cutting, findings, four_point, scheme, six_point

from subdiv_cli.model import Verdict

TINY = Fraction(1, 10**12)
HALF = Fraction(1, 2)


@pytest.mark.parametrize("distance", [TINY, Fraction(1, 10**6), Fraction(1, 100)])
def test_convergence_of_the_four_point_scheme_at_one_half(distance):
    """It converges iff |w| < 1/2, and that is decided however close to the boundary."""
    for sign in (1, -1):
        assert answer(four_point(sign * (HALF + distance))).convergent is Verdict.REFUTED
        assert answer(four_point(sign * HALF)).convergent is Verdict.REFUTED
        assert answer(four_point(sign * (HALF - distance))).convergent is Verdict.PROVED


@pytest.mark.parametrize("distance", [TINY, Fraction(1, 10**6), Fraction(1, 100)])
def test_smoothness_of_the_four_point_scheme_at_zero(distance):
    """C^1 iff 0 < w < w*."""
    for w, order in ((-distance, 0), (Fraction(0), 0), (distance, 1)):
        smoothness = answer(four_point(w)).smoothness
        assert (smoothness.order, smoothness.sharp) == (order, True)


@pytest.mark.parametrize("distance", [TINY, Fraction(1, 10**6)])
def test_smoothness_of_the_four_point_scheme_at_one_sixteenth(distance):
    """Never C^2; the sum rules jump from 2 to 4 and back."""
    for w, order in ((-distance, 2), (Fraction(0), 4), (distance, 2)):
        result = answer(four_point(Fraction(1, 16) + w), 500)
        assert (result.smoothness.order, result.smoothness.sharp) == (1, True)
        assert result.sum_rule_order == order


def test_smoothness_of_the_four_point_scheme_at_its_irrational_end():
    """32w*³ + 4w* = 1: bisected to 10^-12, C^1 is refuted above and proved below."""
    low, high = Fraction(19, 100), Fraction(1, 5)
    while high - low > TINY:
        middle = (low + high) / 2
        low, high = (middle, high) if 32 * middle**3 + 4 * middle < 1 else (low, middle)
    above, below = answer(four_point(high)), answer(four_point(low))
    assert (above.smoothness.order, above.smoothness.sharp) == (0, True)
    assert (below.smoothness.order, below.smoothness.sharp) == (1, True)


@pytest.mark.parametrize("distance", [TINY, Fraction(1, 10**6), Fraction(1, 1000)])
def test_smoothness_of_the_six_point_scheme_at_zero(distance):
    """C^2 for small θ > 0, not for θ <= 0."""
    for theta, order in ((-distance, 1), (Fraction(0), 1), (distance, 2)):
        smoothness = answer(six_point(theta)).smoothness
        assert (smoothness.order, smoothness.sharp) == (order, True)


@pytest.mark.parametrize("distance", [TINY, Fraction(1, 10**6), Fraction(1, 100)])
def test_smoothness_of_corner_cutting_off_its_line(distance):
    """C^1 iff r - s = 1/2."""
    for r, order in ((-distance, 0), (Fraction(0), 1), (distance, 0)):
        smoothness = answer(corner_cutting(Fraction(3, 4) + r, Fraction(1, 4))).smoothness
        assert (smoothness.order, smoothness.sharp) == (order, True)


@pytest.mark.parametrize("distance", [TINY, Fraction(1, 10**6)])
def test_residue_sums_are_never_nearly_one(distance):
    result = answer(scheme([HALF + distance, 1, HALF]))
    assert result.convergent is Verdict.REFUTED
    assert findings(result, "SD101")[0].verdict is Verdict.REFUTED


@pytest.mark.parametrize("distance", [TINY, Fraction(1, 10**6)])
def test_stability_at_a_zero_on_the_circle(distance):
    """g(z) = z + c divides both polyphase components of (1+z)²(z²+c)/(2(1+c)): unstable iff |c| = 1."""
    for c, stable in ((1 - distance, True), (Fraction(1), False), (1 + distance, True)):
        base = [Fraction(1, 2), Fraction(1), Fraction(1, 2)]
        mask = [Fraction(0)] * 5
        for i, x in enumerate(base):
            mask[i] += c * x / (1 + c)
            mask[i + 2] += x / (1 + c)
        result = answer(scheme(mask))
        assert result.stable is (Verdict.PROVED if stable else Verdict.REFUTED)
        assert result.linearly_independent is Verdict.REFUTED
