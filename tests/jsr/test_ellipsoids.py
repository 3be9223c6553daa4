"""Ellipsoids: families with a known invariant form, disguised, and bounds of families where nothing closes."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from proved import block_diagonal, inverse, products, proved, times, transposed

from subdiv_cli.jsr.ellipsoids import _tree
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import joint_spectral_radius

TURN = [[Fraction(3, 5), Fraction(-4, 5)], [Fraction(4, 5), Fraction(3, 5)]]


def orthogonal(rng, order):
    """A product of signed permutations and plane rotations by an angle that is no rational part of a turn."""
    total = [[Fraction(int(i == j)) for j in range(order)] for i in range(order)]
    for _ in range(4):
        i, j = rng.sample(range(order), 2)
        turn = [[Fraction(int(k == m)) for m in range(order)] for k in range(order)]
        turn[i][i], turn[i][j], turn[j][i], turn[j][j] = *TURN[0], *TURN[1]
        signs = [rng.choice([1, -1]) for _ in range(order)]
        places = rng.sample(range(order), order)
        total = times(turn, [[s * x for x in total[k]] for s, k in zip(signs, places, strict=True)])
    return total


def disguised(matrices, rng):
    """B^-1 M B for a random invertible B."""
    order = len(matrices[0])
    b = [
        [Fraction(rng.randrange(-2, 3)) if j < i else Fraction(int(i == j)) for j in range(order)] for i in range(order)
    ]
    return [times(inverse(b), times(m, b)) for m in matrices]


@pytest.mark.parametrize("seed", range(8))
def test_matrices_that_keep_a_form_up_to_a_factor(seed):
    """ρ is the factor of the first; others are smaller, or as large; the same for transposes."""
    rng = random.Random(seed)
    order, factor = rng.randrange(2, 5), Fraction(rng.randrange(1, 8), rng.randrange(1, 8))
    family = [orthogonal(rng, order) for _ in range(2)]
    family = disguised([[[factor * x for x in row] for row in m] for m in family], rng)
    if seed % 2:
        family = [transposed(m) for m in family]
    found = proved(family)
    assert found.lower == pytest.approx(float(factor), rel=1e-12)
    assert found.upper == pytest.approx(float(factor), rel=1e-12)
    assert found.root in [(n, (-(factor**n).numerator, (factor**n).denominator)) for n in (1, 2)]


def test_an_irrational_factor():
    """Two similarities by √2, with turns by an eighth and by an angle that is no part of a turn."""
    eighth = [[1, -1], [1, 1]]
    other = [[Fraction(7, 5), Fraction(-1, 5)], [Fraction(1, 5), Fraction(7, 5)]]
    found = proved(disguised([[[Fraction(x) for x in row] for row in m] for m in (eighth, other)], random.Random(1)))
    assert found.root == (2, (-2, 1))
    assert found.bounded


def test_a_block_with_a_form_beside_a_smaller_one():
    ellipse = [[[2, 1], [0, -2]], [[2, 0], [-1, -2]]]
    found = proved(block_diagonal(ellipse, [[[1, 1], [0, 1]], [[1, 0], [0, 1]]]))
    assert found.root == (2, (-4, 1))
    assert "ellipsoid" in found.rules


@pytest.mark.parametrize(("order", "seed"), [(12, 2), (20, 2), (24, 1)])
def test_signs_and_zeros_at_random(order, seed):
    """Matrices for which no polytope closes with this effort: an enclosure of a few per cent, true in floats too."""
    family = np.random.default_rng(seed).integers(-1, 2, (2, order, order)).tolist()
    found, known = proved(family, 2000), products(family)
    assert found.lower <= known.upper
    assert known.lower <= found.upper
    assert found.root is not None or found.upper <= 1.1 * found.lower
    assert found.upper < known.upper


def test_an_order_beyond_polytopes():
    family = np.random.default_rng(61).integers(-1, 2, (2, 61, 61)).tolist()
    found, known = proved(family, 4000), products(family, 64)
    assert known.lower <= found.upper < known.upper


def test_the_words_of_a_tree_are_the_ends_of_all_words():
    """Every word of the longest length begins with exactly one of them; without that nothing would be proved."""
    images = np.array([[[0.0, 1.3], [0.6, 0.0]], [[0.9, 0.2], [0.0, 0.5]], [[0.1, 1.1], [0.3, 0.2]]])
    words = _tree(images, 500, Effort())
    assert words is not None
    deepest = max(map(len, words))
    assert deepest > 1
    for word in product(range(3), repeat=deepest):
        assert sum(word[: len(end)] == end for end in words) == 1
    for word in words:
        total = np.linalg.multi_dot([np.eye(2), *(images[k] for k in reversed(word))])
        assert np.linalg.norm(total, 2) < 1
    assert _tree(images, len(words) - 1, Effort()) is None


@pytest.mark.parametrize("scale", [Fraction(18 * 10**30), Fraction(7, 10**25), Fraction(18, 10**6)])
def test_units_of_the_numbers_do_not_matter(scale):
    """A turn and a swap times a number: the unit circle shows that it is the radius."""
    family = [[[scale * x for x in row] for row in m] for m in (TURN, [[0, 1], [1, 0]])]
    found = proved(family)
    assert found.root[1] == (-((scale ** found.root[0]).numerator), (scale ** found.root[0]).denominator)
    assert found.bounded
    assert "ellipsoid" in found.rules


@pytest.mark.parametrize("seconds", [None, 10])
def test_a_single_matrix_whose_polytope_does_not_close(seconds):
    """Its powers do not become more with their length: the search for coordinates ends all the same."""
    rng = random.Random(3)
    m = [[Fraction(rng.randint(-9, 9)) for _ in range(20)] for _ in range(20)]
    found = joint_spectral_radius([m], Effort(500, seconds)).radius
    truth = max(abs(np.linalg.eigvals(np.array(m, dtype=float))))
    assert found.lower <= truth * (1 + 1e-12)
    assert truth * (1 - 1e-12) <= found.upper <= 1.1 * truth
