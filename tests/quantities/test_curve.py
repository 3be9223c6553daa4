"""The curve of φ: closed forms of B-splines, interpolation, partition of unity, and subdivision of δ itself."""

from fractions import Fraction
from math import comb, factorial

import pytest
from support import b_spline, corner_cutting, deslauriers_dubuc, four_point, scheme

from subdiv_cli.catalog.shipped import masks_directory
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.kinds.scalar.numbers.curve import Signal, curve, integer_values, limit_stencil, rule
from subdiv_cli.kinds.scalar.numbers.operators import apply, symbol
from subdiv_cli.model import Verdict


def cardinal_b_spline(degree, x):
    """N_degree on [0, degree + 1], from its truncated powers."""
    return sum(
        (-1) ** j * comb(degree + 1, j) * max(x - j, Fraction(0)) ** degree for j in range(degree + 2)
    ) / factorial(degree)


def drawn(mask):
    """x -> φ(x)."""
    values = curve(mask, integer_values(mask))
    return {Fraction(values.start + i, values.arity**values.level): y for i, y in enumerate(values.values)}


@pytest.mark.parametrize("degree", [1, 2, 3, 4, 6])
@pytest.mark.parametrize("arity", [2, 3, 4])
def test_b_splines(degree, arity):
    points = drawn(b_spline(degree, arity))
    assert len(points) > 100
    for x, y in points.items():
        assert y == cardinal_b_spline(degree, x)


def test_an_interpolatory_scheme_is_delta_at_the_integers():
    for mask in (four_point("1/16"), deslauriers_dubuc(6)):
        values = integer_values(mask)
        assert {x for x, y in values.items() if y} == {0}
        assert values[0] == 1
        assert limit_stencil(values).trimmed() == Signal(0, (Fraction(1),))


@pytest.mark.parametrize("mask", [four_point("1/20"), corner_cutting("1/5", "3/4"), b_spline(3, 3)], ids=str)
def test_subdivision_of_delta_goes_to_the_curve(mask):
    """S^k δ at ℓ is near φ(ℓ p^-k): the operator itself, not the refinement equation."""
    data = {0: Fraction(1)}
    levels = 8 if mask.arity == 2 else 5
    for _ in range(levels):
        data = apply(symbol(mask), mask.arity, data)
    points = drawn(mask)
    fine = mask.arity**levels
    first, weights = limit_stencil(integer_values(mask))
    seen = 0
    for x, y in points.items():
        if (x * fine).denominator == 1:
            at, seen = int(x * fine), seen + 1
            assert y == sum(w * data.get(at + first + i, 0) for i, w in enumerate(weights))
    assert seen > 50


def test_a_shift_by_one_index_step_shifts_the_curve():
    here, there = four_point("1/16"), scheme(four_point("1/16").coefficients, start=4)
    assert drawn(there) == {x + 7: y for x, y in drawn(here).items()}


def test_rules_are_what_the_operator_does():
    for mask in (four_point("1/16"), corner_cutting("1/5", "3/4"), scheme([1, 3, 5, 7, 9, 11], start=-7, arity=3)):
        data = {i: Fraction(i * i + 1, 3) for i in range(-20, 20)}
        refined = apply(symbol(mask), mask.arity, data)
        for epsilon in range(mask.arity):
            first, weights = rule(mask, epsilon)
            for k in range(-3, 4):
                expected = sum(w * data[k + first + i] for i, w in enumerate(weights))
                assert refined[mask.arity * k + epsilon] == expected


def test_shipped_masks_form_a_partition_of_unity():
    from subdiv_cli.catalog.run import check_all

    count = 0
    for result in check_all([str(masks_directory() / "scalar")]):
        mask = read_path(result.file).scheme()
        rules = [rule(mask, epsilon).trimmed() for epsilon in range(mask.arity)]
        assert all(weights[0] and weights[-1] for _, weights in rules if weights)
        assert sum(sum(weights) for _, weights in rules) == sum(mask.coefficients)
        values = integer_values(mask) if result.convergent is Verdict.PROVED else None
        if values is not None:
            count += 1
            assert sum(limit_stencil(values).values) == 1
            sums = {}
            for x, y in drawn(mask).items():
                sums[x % 1] = sums.get(x % 1, 0) + y
            assert set(sums.values()) == {1}
    assert count >= 80
