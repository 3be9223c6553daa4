"""N. Dyn, Subdivision schemes in CAGD, 1992: limit and derivative stencils, error bounds (3.3, 4.3, 4.6, 4.7)."""

from fractions import Fraction

import pytest
from support import b_spline, corner_cutting, findings, four_point, scheme, six_point

from subdiv_cli.exact.algebraic import roots
from subdiv_cli.kinds.scalar.numbers.error_bounds import best_bound, bounds, hermite_bound
from subdiv_cli.kinds.scalar.numbers.operators import refinement_matrices
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.numbers.spectra import limit_stencil
from subdiv_cli.kinds.scalar.numbers.values import at_integers, limit_weights
from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import show

F = Fraction
CUBIC = scheme([1, 4, 6, 4, 1], start=-2, over=8)
CHAIKIN = scheme([1, 3, 3, 1], start=-2, over=4)
"""In Dyn's indexing, support -2 … 1."""
TERNARY = scheme([1, 3, 6, 7, 6, 3, 1], start=-3, arity=3, over=9)


def numbers(mask):
    return ScalarNumbers(mask, Effort())


def pairs(laurent):
    return {laurent.low + i: c for i, c in enumerate(laurent.coefficients()) if c}


def shown(mask, code, tolerance="1/1000"):
    (found,) = findings(show(mask, F(tolerance), Effort())[0].result, code)
    return found


def test_values_of_the_cubic_b_spline():
    assert pairs(at_integers(numbers(CUBIC), 0)) == {-1: F(1, 6), 0: F(2, 3), 1: F(1, 6)}
    assert pairs(at_integers(numbers(CUBIC), 1)) == {-1: F(1, 2), 1: F(-1, 2)}
    assert pairs(at_integers(numbers(CUBIC), 2)) == {-1: 1, 0: -2, 1: 1}


def test_values_of_the_ternary_quadratic_b_spline():
    assert pairs(at_integers(numbers(TERNARY), 0)) == {-1: F(1, 8), 0: F(3, 4), 1: F(1, 8)}


def test_a_shift_of_the_mask_by_arity_minus_one_is_one_of_indices():
    for t, values in ((-2, {-2: F(1, 8), -1: F(3, 4), 0: F(1, 8)}), (-1, {-1: F(1, 2), 0: F(1, 2)})):
        shifted = scheme(TERNARY.coefficients, start=-3 + t, arity=3)
        assert pairs(at_integers(numbers(shifted), 0)) == values


@pytest.mark.parametrize(("r", "s"), [(F(3, 4), F(1, 4)), (F(2, 3), F(1, 3)), (F(4, 5), F(1, 10)), (F(9, 10), F(2, 5))])
def test_corner_cutting(r, s):
    """v = (s, 1-r, 0)/(1-(r-s)); and where r - s = 1/2 the derivative stencil is (-1, 1)."""
    n, one = numbers(corner_cutting(r, s)), 1 - (r - s)
    assert pairs(limit_weights(n, 0)) == {0: s / one, 1: (1 - r) / one}
    if r - s == F(1, 2):
        assert pairs(limit_weights(n, 1)) == {0: -1, 1: 1}


def test_chaikin():
    assert pairs(limit_weights(numbers(CHAIKIN), 0)) == {0: F(1, 2), 1: F(1, 2)}
    assert pairs(limit_weights(numbers(CHAIKIN), 1)) == {0: -1, 1: 1}


@pytest.mark.parametrize("w", [F(1, 16), F(1, 32), F(1, 10), F(3, 20)])
def test_four_point_derivative(w):
    """Section 4, example 2: (w, -1/2, 0, 1/2, -w)/(1-4w) at i-2, …, i+2, from v = (-w, 1/2-w, 1/2-w, -w)/(1-4w)."""
    n, one = numbers(four_point(w)), 1 - 4 * w
    assert pairs(limit_weights(n, 0)) == {0: 1}
    assert pairs(limit_weights(n, 1)) == {-2: w / one, -1: F(-1, 2) / one, 1: F(1, 2) / one, 2: -w / one}
    symbol = n.difference(1).scale(2)
    derived = scheme(symbol.coefficients(), start=symbol.low)
    v = limit_stencil(refinement_matrices(derived)[0])
    assert [x for x in v if x] == [-w / one, (F(1, 2) - w) / one, (F(1, 2) - w) / one, -w / one]


@pytest.mark.parametrize("w", [F(1, 16), F(3, 64), F(-1, 2), F(3, 20)])
def test_four_point_eigenvalues_of_half_a01(w):
    """1/2, 2w and (1 ± √(1-16w))/4; our window has one index more than needed, and with it the corner entry -w."""
    symbol = numbers(four_point(w)).difference(1)
    matrix = refinement_matrices(scheme(symbol.coefficients(), start=symbol.low))[0]
    spectrum = sorted((complex(float(z.real.mid()), float(z.imag.mid())) for z in eigenvalues(matrix)), key=key)
    root = complex(1 - 16 * w) ** 0.5
    expected = sorted([0.5, complex(-w), complex(2 * w), (1 + root) / 4, (1 - root) / 4], key=key)
    nonzero = [z for z in spectrum if abs(z) > 1e-12]
    assert nonzero == pytest.approx([z for z in expected if abs(z) > 1e-12], abs=1e-7)


def eigenvalues(matrix):
    return [x.region for x, multiplicity in roots(matrix.charpoly()) for _ in range(multiplicity)]


def key(z):
    return round(complex(z).real, 6), round(complex(z).imag, 6)


def test_stencils_in_the_report():
    found = shown(four_point("1/16"), "SD502")
    assert found.verdict is Verdict.PROVED
    assert found.witness["starts"] == (0, -2)
    assert found.witness["stencils"][1] == (F(1, 12), F(-2, 3), 0, F(2, 3), F(-1, 12))
    assert "1/12 f_(i-2) - 2/3 f_(i-1) + 2/3 f_(i+1) - 1/12 f_(i+2)" in found.statement


def test_error_bound_of_the_cubic_b_spline():
    """E = 1/4, μ = 1/2, C = E/(1-μ) = 1/2: nine levels for 1/1000, as 2^-10 < 1/1000 < 2^-9."""
    first = next(bounds(numbers(CUBIC), 0))
    assert (first.distance, first.norm, first.constant, first.level) == (F(1, 4), F(1, 2), F(1, 2), 1)
    assert best_bound(numbers(CUBIC), F(1, 1000)) == first
    assert first.levels_for(F(1, 1000)) == 9
    assert first.levels_for(F(1, 1024)) == 9
    assert first.levels_for(F(1, 1025)) == 10
    assert first.levels_for(F(1, 2)) == 0
    found = shown(CUBIC, "SD511")
    assert (found.witness["constant"], found.witness["levels"]) == (F(1, 2), 9)


def test_error_bound_of_the_four_point_scheme():
    """½S_1 has the norm 5/8 and (½S_1)² 21/64; E = 1/8 from a - u = (-z^-3 + z^-1 + z - z^3)/16."""
    first, second = (bound for bound, _ in zip(bounds(numbers(four_point("1/16")), 0), range(2), strict=False))
    assert (first.distance, first.norm, first.constant) == (F(1, 8), F(5, 8), F(1, 3))
    assert (second.norm, second.constant) == (F(21, 64), F(1, 8) * 2 / (1 - F(21, 64)))


def test_hermite_bound():
    """The cubic B-spline: S_2 is the linear spline, ‖S_2^∞‖ = 1, so H is 1/8 at least."""
    bound = hermite_bound(numbers(CUBIC), 2)
    assert F(1, 8) <= bound.constant <= F(1, 8) * F(9, 8)
    found = shown(b_spline(5), "SD512")
    assert found.witness["order"] == 4
    assert found.witness["constant"] >= F(1, 16 * 24)
    assert shown(four_point("1/16"), "SD512").verdict is Verdict.SKIPPED
    assert shown(six_point("1/100"), "SD512").verdict is Verdict.PROVED


def test_interpolatory_schemes_need_to_reproduce():
    """Theorem 5.1; other schemes have no such finding."""
    assert shown(four_point("1/16"), "SD505").witness == {"order": 4}
    assert shown(four_point("1/10"), "SD505").witness == {"order": 2}
    assert not findings(show(CUBIC, F(1, 10), Effort())[0].result, "SD505")
    moved = scheme(four_point("1/16").coefficients, start=-2)
    assert not findings(show(moved, F(1, 10), Effort())[0].result, "SD505")
