"""One positive vector decides matrices that are not negative: families with a known radius, disguised."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from proved import block_diagonal, products, proved, transposed


def stochastic(rng, order, total=1):
    """A matrix with row sums `total`, about half of its entries zero."""
    rows = [[rng.randrange(1, 10) * rng.randrange(2) for _ in range(order)] for _ in range(order)]
    rows = [row if any(row) else [1, *row[1:]] for row in rows]
    return [[Fraction(total * x, sum(row)) for x in row] for row in rows]


def in_other_units(m, units):
    """D^-1 M D."""
    return [[x * d / c for x, d in zip(row, units, strict=True)] for row, c in zip(m, units, strict=True)]


@pytest.mark.parametrize("seed", range(12))
def test_disguised_stochastic_matrices(seed):
    """Row sums r, at most r in the other matrices, and other units; or columns instead: the radius is r."""
    rng = random.Random(seed)
    order, radius = rng.randrange(2, 12), Fraction(rng.randrange(1, 9), rng.randrange(1, 9))
    less = Fraction(rng.randrange(1, 9), 8) * radius
    family = [stochastic(rng, order, radius), stochastic(rng, order, less), stochastic(rng, order, radius)]
    units = [Fraction(rng.randrange(1, 100), rng.randrange(1, 100)) for _ in range(order)]
    family = [in_other_units(m, units) for m in family]
    if seed % 2:
        family = [transposed(m) for m in family]
    found = proved(family)
    assert found.root == (1, (-radius.numerator, radius.denominator))
    assert found.bounded
    assert "common-vector" in found.rules


@pytest.mark.parametrize("order", [64, 100])
def test_large_orders(order):
    rng = random.Random(order)
    units = [Fraction(rng.randrange(1, 50)) for _ in range(order)]
    found = proved([in_other_units(stochastic(rng, order), units) for _ in range(2)])
    assert found.root == (1, (-1, 1))


def test_blocks_that_only_some_vector_of_each_proves():
    """Row sums 2 in one block, column sums 2 in the other, and neither in the whole."""
    rng = random.Random(1)
    rows = [stochastic(rng, 3, 2), stochastic(rng, 3, 2)]
    columns = [transposed(stochastic(rng, 4, 2)), transposed(stochastic(rng, 4, 2))]
    found = proved(block_diagonal(rows, columns))
    assert found.root == (1, (-2, 1))


@pytest.mark.parametrize("seed", range(6))
def test_one_row_sum_too_large(seed):
    """Row sums 1 but for one: what products say in floats is kept to, and 1 is not said where it is more."""
    rng = random.Random(seed)
    family = [stochastic(rng, 4), [[Fraction(1, 4)] * 4] * 4]
    family[0][1] = [x * Fraction(101, 100) for x in family[0][1]]
    found, known = proved(family), products(family)
    assert found.lower <= known.upper
    assert found.upper >= known.lower


@pytest.mark.parametrize("scale", [Fraction(18 * 10**30), Fraction(7, 10**25), Fraction(18, 10**6)])
def test_units_of_the_numbers_do_not_matter(scale):
    family = [[[Fraction(1, 2), Fraction(1, 2)], [Fraction(1, 3), Fraction(2, 3)]], [[1, 0], [Fraction(1, 4), 0]]]
    found = proved([[[scale * x for x in row] for row in m] for m in family])
    assert found.root == (1, (-scale.numerator, scale.denominator))
    assert "common-vector" in found.rules
