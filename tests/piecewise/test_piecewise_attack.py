"""Random special rules, hard cases by hand, and the catalog, against floats that share no code with the program."""

import random
from fractions import Fraction

import numpy as np
import pytest
from bsplines import spline_scheme
from random_piecewise import decay_at_zero, exponent_at_zero, largest_step, mask, random_scheme, spread
from support import cases, findings, seeded

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.piecewise.numbers.functionals import Functionals, cells_of, window_of
from subdiv_cli.kinds.piecewise.rules import AT_ZERO
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import INFINITY, Effort, Smoothness, Verdict
from subdiv_cli.pipeline import check

ONE = (Fraction(1), Fraction(1))
FILES = sorted((masks_directory() / "piecewise").rglob("*.toml"))
HAT, CUBIC, FOUR = mask("hat"), mask("cubic"), mask("four-point")


def answer(scheme):
    return check(scheme, (), Effort()).result


def order_of(result):
    (finding,) = findings(result, "SD824")
    return AT_ZERO.witness_of(finding)["order"]


def agrees(scheme, result):
    """Whether floats see the same exponent at 0."""
    seen, exponent = exponent_at_zero(scheme, order_of(result)), result.holder_at_zero
    if exponent.exact == INFINITY:
        return seen is None or seen > 12
    return abs(seen - exponent.lower) < 0.02


def test_random_special_rules():
    """Convergence by 2^17 levels of all unit data, the exponent at 0 by eigenvalues of values of limits."""
    rng, mix = seeded(82), {"proved": 0, "refuted": 0, "C^1": 0, "rough": 0}
    for _ in range(cases(32)):
        scheme = random_scheme(rng, size=rng.choice([4, 12]))
        result = answer(scheme)
        with np.errstate(all="ignore"):
            size = spread(scheme, levels=2**17)
        if result.convergent is Verdict.PROVED:
            assert size < 0.1, scheme
            assert agrees(scheme, result), scheme
        else:
            assert result.convergent is Verdict.REFUTED
            assert not size < 1e-6, scheme
        mix[result.convergent.value] += 1
        mix["C^1"] += (result.smoothness.order or 0) >= 1
        mix["rough"] += result.holder is not None and (result.holder.upper or 9) < 1
    assert min(mix.values()) >= 3, mix


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_the_catalog_is_what_iteration_shows(file):
    """The local limits of each shipped scheme, by iteration at 0 and beside it."""
    mask_file = read_path(file)
    scheme = mask_file.scheme({})
    result = check(scheme, mask_file.expectations, Effort()).result
    assert result.status == "passed"
    assert {e.key for e in mask_file.expectations} >= {"convergent"}
    with np.errstate(all="ignore"):
        size, steps = spread(scheme, levels=400), [largest_step(side) for side in (scheme.left, scheme.right)]
    sums = [sum(x for _, x in row) for _, row in scheme.special]
    if result.convergent is Verdict.REFUTED:
        assert not size < 1e-3 or max(steps) > 0.5 or not set(sums) <= {1}
        return
    assert max(size, *steps) < 0.1
    assert set(sums) <= {1}
    assert agrees(scheme, result)
    sizes = [s for s in decay_at_zero(scheme, order_of(result)) if s > 1e-10]
    if result.holder_at_zero.exact == INFINITY:
        assert len(sizes) < 6
        return
    rate = -np.log(sizes[-1] / sizes[1]) / np.log(scheme.arity) / (len(sizes) - 2)
    assert abs(rate - result.holder_at_zero.lower) < 0.6


@pytest.mark.parametrize("degree", [1, 2, 3, 4])
def test_b_splines_have_their_classical_smoothness(degree):
    """Degree d and a knot of multiplicity m: C^(d-m), with all polynomials of degree d, whatever the spacings."""
    rng = random.Random(degree)
    for multiplicity in range(1, degree + 1):
        spacing = (1, rng.choice([1, 2, Fraction(2, 3), 5]))
        for arity in (2, 3) if degree < 4 else (2,):
            result = answer(spline_scheme(degree, spacing, multiplicity, arity))
            assert result.smoothness == Smoothness(degree - multiplicity, sharp=True)
            assert result.holder.exact == result.holder_at_zero.exact == degree - multiplicity + 1
            assert result.generation == degree


def test_the_uniform_scheme_has_its_own_exponent():
    for name in ("hat", "chaikin", "cubic", "four-point", "four-point 1/10", "unstable", "shifted cubic"):
        result = answer(PiecewiseScheme(mask(name), mask(name)))
        alone = answer(mask(name))
        assert result.holder.exact == alone.holder.exact
        assert result.smoothness == alone.smoothness


def bumps(mu):
    row = {4: Fraction(1, 2), 5: Fraction(1, 2), 8: -mu / 2, 9: mu, 10: -mu / 2}
    return PiecewiseScheme(HAT, HAT, ONE, ((9, tuple(row.items())),))


def test_bumps_that_no_fixed_grid_sees():
    """Bumps of height μ^n at 9/2^n: values on a grid of step 1/8 would give the exponent 1."""
    result = answer(bumps(Fraction(3, 4)))
    assert str(result.holder.exact) == "log2(4/3)"
    assert answer(bumps(Fraction(2))).convergent is Verdict.REFUTED
    assert answer(bumps(Fraction(1))).convergent is Verdict.REFUTED


def at_points(*rows, left=HAT, right=HAT, spacing=ONE):
    return PiecewiseScheme(left, right, spacing, rows)


def weights(start, *entries):
    return tuple((start + k, Fraction(x)) for k, x in enumerate(entries))


def test_two_eigenvalues_on_the_critical_circle():
    """1/2 as a double eigenvalue with a Jordan block, and ± 1/2: ties refute C^1, and the exponent is 1."""
    double = at_points((1, weights(-1, "1/2", 0, "1/2")), (-1, weights(-1, "1/2", "1/2")))
    signs = at_points((1, weights(-1, "1/2", "1/2")), (-1, weights(0, "1/2", "1/2")))
    for scheme in (double, signs):
        result = answer(scheme)
        assert result.convergent is Verdict.PROVED
        assert result.smoothness == Smoothness(0, sharp=True)
        assert result.holder_at_zero.exact == 1
        assert agrees(scheme, result)


def test_a_complex_pair():
    scheme = at_points((-1, weights(-1, "1/2", 0, "1/2")), (1, weights(-1, "-3/8", 1, "3/8")))
    result = answer(scheme)
    assert result.convergent is Verdict.PROVED
    assert str(result.holder_at_zero.exact) == "log2(8/3)/2"
    assert agrees(scheme, result)


def test_rules_read_at_one_side_only():
    """All points near 0 are computed from the left: the limit on the right begins where the left ends."""
    rows = [(i, weights(-2, "1/4", "1/2", "1/4")) for i in range(3)]
    result = answer(PiecewiseScheme(CUBIC, CUBIC, ONE, tuple(rows)))
    assert result.convergent is Verdict.PROVED
    assert agrees(PiecewiseScheme(CUBIC, CUBIC, ONE, tuple(rows)), result)


def test_limits_that_are_constant_near_zero():
    """Every point near 0 is point 0: limits are constant there, and the sides alone limit the exponent."""
    scheme = PiecewiseScheme(CUBIC, CUBIC, ONE, tuple((i, ((0, Fraction(1)),)) for i in range(-6, 7)))
    result = answer(scheme)
    assert result.holder_at_zero.exact == INFINITY
    assert result.holder.exact == 3
    assert result.smoothness == Smoothness(2, sharp=True)
    assert result.generation == 0


def test_cells_of_both_sides_need_the_same_data():
    """A mask so wide that it reads all data of the other side: where the spacings differ, it keeps no linear data."""
    weights = (-5, 0, 49, 0, -245, 0, 1225, 2048, 1225, 0, -245, 0, 49, 0, -5)
    wide = type(HAT)(arity=2, start=-7, coefficients=tuple(Fraction(x, 2048) for x in weights))
    assert answer(PiecewiseScheme(HAT, wide)).generation == 1
    for spacing in ((1, 2), (3, 1)):
        scheme = PiecewiseScheme(HAT, wide, tuple(map(Fraction, spacing)))
        assert answer(scheme).generation == answer(mirrored(scheme)).generation == 0


def test_limits_that_vanish_are_no_convergence():
    """A row of sum 1/2 makes limits 0 at 0; a mask whose limits are all 0 does not converge either."""
    half = at_points((0, ((0, Fraction(1, 2)),)))
    assert answer(half).convergent is Verdict.REFUTED
    dying = type(HAT)(arity=2, start=-1, coefficients=(Fraction(1, 4), Fraction(1, 2), Fraction(1, 4)))
    assert answer(PiecewiseScheme(HAT, dying)).convergent is Verdict.REFUTED
    empty = at_points((0, ()))
    assert answer(empty).convergent is Verdict.REFUTED


def test_a_diverging_side_refutes():
    wild = type(HAT)(arity=2, start=-3, coefficients=tuple(Fraction(x, 4) for x in (-3, 0, 5, 4, 5, 0, -3)))
    result = answer(PiecewiseScheme(CUBIC, wild))
    assert result.convergent is Verdict.REFUTED
    (finding,) = findings(result, "SD823")
    assert finding.witness["side"] == "right"


def mirrored(scheme):
    """The scheme seen from the other side; the row of 0 follows the right mask, and becomes a special one."""
    left, right = (
        type(side)(arity=2, start=-side.start - side.degree, coefficients=side.coefficients[::-1])
        for side in (scheme.right, scheme.left)
    )
    rows = {**dict(scheme.special), 0: scheme.row(0)}
    special = tuple((-i, tuple((-j, x) for j, x in row)) for i, row in rows.items())
    return PiecewiseScheme(left, right, scheme.spacing[::-1], special)


def test_reflection_changes_nothing():
    rng = seeded(823)
    for _ in range(cases(12)):
        scheme = random_scheme(rng)
        one, other = answer(scheme), answer(mirrored(scheme))
        assert (one.convergent, one.smoothness, one.generation) == (
            other.convergent,
            other.smoothness,
            other.generation,
        )
        assert (one.holder, one.holder_at_zero) == (other.holder, other.holder_at_zero)


def test_a_larger_window_changes_nothing():
    """All spaces of functionals by cells farther out: the recurrent parts have the same eigenvalues."""
    rng = seeded(824)
    for _ in range(cases(10)):
        scheme = random_scheme(rng)
        near = cells_of(scheme)
        far = tuple(c._replace(numbers=range(2 * min(c.numbers), 2 * max(c.numbers) + 2)) for c in near)
        spaces = [Functionals(scheme, cells, window_of(scheme, cells)) for cells in (near, far)]
        for k in (0, 1, 2, 4):
            one, other = (each.annihilating(k) for each in spaces)
            assert one.matrix.charpoly() == other.matrix.charpoly()


def after(scheme, data, i, level):
    """The value at point i after so many levels, by what it is computed from alone."""
    if not level:
        return data[i]
    return sum((w * after(scheme, data, j, level - 1) for j, w in scheme.row(i)), Fraction(0))


def test_limits_in_cells_are_those_of_the_masks():
    """In the cells nothing of the special rows, or of the other side, is ever used; one step farther in it may be."""
    rng, inside = seeded(828), 0
    for _ in range(cases(40)):
        scheme = random_scheme(rng)
        data = {j: Fraction(rng.randint(-9, 9)) for j in range(-60, 61)}
        left, right = cells_of(scheme)
        for side, i, inwards in ((left, max(left.numbers) + 1, 1), (right, min(right.numbers), -1)):
            uniform = PiecewiseScheme(side.mask, side.mask)
            for level in (1, 2, 4):
                at = i * scheme.arity**level
                assert after(scheme, data, at, level) == after(uniform, data, at, level)
            near = (i + inwards) * scheme.arity**2
            inside += after(scheme, data, near, 2) != after(uniform, data, near, 2)
    assert inside > 20, "cells are farther out than they must be"
