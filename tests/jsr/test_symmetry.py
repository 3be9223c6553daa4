"""Hidden symmetries of families: found, made the reversal of the coordinates, and used."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from flint import fmpq_mat
from proved import proved, similar
from support import shipped_multivariate

from subdiv_cli.exact.linalg import matrix, rows_of
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.reduce import decomposed
from subdiv_cli.jsr.symmetry import reversing
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.model import Effort


def mirrored(m):
    return [row[::-1] for row in reversed(m)]


def symmetric_family(n, letters, sign, seed):
    """M_(p-1-i) = sign J M_i J, entries in Z."""
    rng = random.Random(seed)
    first = [[[rng.randint(-4, 4) for _ in range(n)] for _ in range(n)] for _ in range(letters // 2)]
    last = [[[sign * x for x in row] for row in mirrored(m)] for m in reversed(first)]
    middle = []
    if letters % 2:
        m = [[rng.randint(-4, 4) for _ in range(n)] for _ in range(n)]
        middle = [[[x + sign * y for x, y in zip(*rows, strict=True)] for rows in zip(m, mirrored(m), strict=True)]]
    return [*first, *middle, *last]


def basis(n, seed):
    rng = random.Random(seed)
    while True:
        rows = [[rng.randint(-3, 3) for _ in range(n)] for _ in range(n)]
        if matrix(rows).det() != 0:
            return rows


def hidden(family, seed):
    return Family([matrix(m) for m in similar(family, basis(len(family[0]), seed))])


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("letters", [2, 3, 4])
@pytest.mark.parametrize("n", [3, 4, 5, 8, 13])
def test_a_hidden_symmetry_is_found(n, letters, sign):
    family = hidden(symmetric_family(n, letters, sign, seed=n), seed=letters)
    assert family.symmetry == 0
    c = reversing(family)
    assert c is not None
    assert Family([c.inv() * m * c for m in family.matrices]).symmetry == sign


@pytest.mark.parametrize("n", [3, 6, 10])
def test_there_is_none_in_random_families(n):
    rng = random.Random(n)
    for _ in range(5):
        family = Family([matrix([[rng.randint(-4, 4) for _ in range(n)] for _ in range(n)]) for _ in range(2)])
        assert reversing(family) is None


def test_an_involution_with_another_trace_is_no_reversal():
    """P = diag(1, 1, 1, -1), which no basis makes J: J has as many eigenvalues 1 as -1."""
    rng = random.Random(4)
    p = matrix([[(1 if i < 3 else -1) * (i == j) for j in range(4)] for i in range(4)])
    m = matrix([[rng.randint(-4, 4) for _ in range(4)] for _ in range(4)])
    assert reversing(Family([m, p * m * p])) is None


def test_an_involution_with_an_irrational_factor_is_no_reversal():
    """P M = M' P and P² = 2, which no rational multiple of P makes 1."""
    p = matrix([[0, 2, 0, 0], [1, 0, 0, 0], [0, 0, 0, 2], [0, 0, 1, 0]])
    m = matrix([[1, 2, 0, 3], [0, -1, 1, 1], [2, 0, 1, -2], [1, 1, 0, 2]])
    assert reversing(Family([m, p * m * p.inv()])) is None


def test_what_is_symmetric_already_or_not_negative_is_left_alone():
    family = Family([matrix(m) for m in symmetric_family(5, 2, 1, seed=1)])
    assert family.symmetry == 1
    assert reversing(family) is None
    positive = [[[1, 2, 0], [0, 1, 3], [1, 0, 1]], [[1, 0, 1], [3, 1, 0], [0, 2, 1]]]
    assert reversing(Family([matrix(m) for m in positive])) is None


def test_denominators_that_the_prime_divides_are_no_error():
    m = fmpq_mat([[1, 2, 0], [0, 1, 3], [-1, 0, 1]]) / ((1 << 61) - 1)
    assert reversing(Family([m, m * m])) is None


@pytest.mark.parametrize("name", ["bear", "butterfly_1_10", "kobbelt_sqrt3", "quincunx_interpolatory", "sqrt3_linear"])
def test_every_large_block_of_a_mask_that_is_its_own_mirror_image_is_symmetric(name):
    numbers = MultivariateNumbers(shipped_multivariate(name), Effort())
    blocks = decomposed(Family(numbers.space.matrices))
    large = [part for part in blocks.parts if part.order >= 3]
    assert large
    assert all(abs(part.symmetry) == 1 for part in large)
    product = blocks.basis.inv() * numbers.space.matrices[0] * blocks.basis
    assert rows_of(product)[-1][0] == 0


def test_a_symmetric_block_is_proved_with_reflections():
    """Two copies of one family, in another basis: blocks, each of which has its symmetry hidden."""
    part = [[[Fraction(x, 4) for x in row] for row in m] for m in symmetric_family(4, 2, 1, seed=8)]
    other = [[[x / 2 for x in row] for row in m] for m in part]
    both = [[[*row, *[0] * 4] for row in a] + [[*[0] * 4, *row] for row in b] for a, b in zip(part, other, strict=True)]
    found = proved(similar(both, basis(8, seed=2)))
    assert "blocks" in found.rules
    assert found.root is not None
