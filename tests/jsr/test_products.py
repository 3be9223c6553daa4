"""Words and products: the search ranks by floats, what it returns is exact."""

from fractions import Fraction
from itertools import islice

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.exact.linalg import matrix
from subdiv_cli.jsr.products import best_product, lyndon_words, radius_bound
from subdiv_cli.kinds.scalar.numbers.radius import exponent_bound
from subdiv_cli.model import Effort


def test_lyndon_words_are_one_of_each_primitive_rotation_class():
    words = list(islice(lyndon_words(2), 2 + 1 + 2 + 3 + 6 + 9))
    assert words[:6] == [(0,), (1,), (0, 1), (0, 0, 1), (0, 1, 1), (0, 0, 0, 1)]
    for word in words:
        rotations = [word[i:] + word[:i] for i in range(len(word))]
        assert len(set(rotations)) == len(word)
        assert word == min(rotations)
    assert len(set(words)) == len(words)


@pytest.mark.parametrize("letters", [2, 3, 4])
def test_lyndon_words_are_counted_by_moebius(letters):
    words = list(islice(lyndon_words(letters), letters + letters * (letters - 1) // 2))
    assert sum(len(word) == 1 for word in words) == letters
    assert sum(len(word) == 2 for word in words) == letters * (letters - 1) // 2


def test_the_golden_ratio():
    """[[1,1],[0,1]] and its transpose: the product of both has ((1+√5)/2)² as an eigenvalue."""
    product = best_product([matrix([[1, 1], [0, 1]]), matrix([[1, 0], [1, 1]])], Effort())
    assert product is not None
    assert product.word == (0, 1)
    assert [int(c) for c in product.eigenvalue.minimal_polynomial] == [1, -3, 1]
    assert product.compare(Fraction(1618, 1000)) == 1
    assert product.compare(Fraction(1619, 1000)) == -1


def test_nilpotent_families_have_no_product():
    assert best_product([matrix([[0, 1], [0, 0]]), matrix([[0, 2], [0, 0]])], Effort()) is None
    assert best_product([matrix([[1]])], Effort(10)) is None


def test_ties_go_to_the_shortest_word():
    product = best_product([matrix([[Fraction(1, 2)]]), matrix([[Fraction(-1, 2)]])], Effort())
    assert product is not None
    assert product.word == (0,)


@pytest.mark.parametrize(
    ("rows", "norm", "level", "closes"),
    [
        ([[0, 1], [Fraction(1, 4), 0]], Fraction(1, 4), 2, True),  # eigenvalues ±1/2
        ([[0, -1], [Fraction(1, 2), 0]], Fraction(1, 2), 2, True),  # ±i/√2: irrational modulus, exact square
        ([[0, -1], [Fraction(1, 2), 0]], Fraction(7072, 10000), 1, False),
        ([[1, 1], [1, 0]], Fraction(1618, 1000), 1, False),
        ([[0, 2], [1, 1]], Fraction(2), 1, True),
        ([[0, 2], [1, 1]], Fraction(2) + Fraction(1, 10**30), 1, False),
    ],
)
def test_closing_is_exact(rows, norm, level, closes):
    product = best_product([matrix(rows)], Effort(300))
    assert product is not None
    assert product.closes(norm, level) is closes


entries = st.integers(-4, 4)


@given(st.lists(st.lists(st.lists(entries, min_size=3, max_size=3), min_size=3, max_size=3), min_size=2, max_size=2))
def test_the_best_product_beats_every_single_matrix(family):
    best = best_product([matrix(rows) for rows in family], Effort(4000))
    radii = [max(abs(np.linalg.eigvals(np.array(rows, dtype=float)))) for rows in family]
    if best is None:
        assert max(radii) < 1e-3
        return
    found = float(radius_bound(best)) ** (1 / len(best.word))
    assert found >= max(radii) - 1e-4
    total = np.eye(3)
    for letter in best.word:
        total = np.array(family[letter], dtype=float) @ total
    assert abs(max(abs(np.linalg.eigvals(total))) - float(radius_bound(best))) < 1e-3 * max(
        1, float(radius_bound(best))
    )


def test_exponent_bounds_are_outward():
    product = best_product([matrix([[1, 1], [0, 1]]), matrix([[1, 0], [1, 1]])], Effort())
    assert product is not None
    bound = exponent_bound(product, 2)
    true = -np.log2((1 + 5**0.5) / 2)
    assert bound.upper is not None
    assert true <= bound.upper <= true + 1e-15
    assert bound.exact is None
