"""Exact tests of the checker that decide by inequalities: positive forms, complete trees of words, isolated roots."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

import pytest
from flint import fmpq_mat

from subdiv_cli.checker.polynomials import sturm_count, value
from subdiv_cli.checker.radius.norms import _has_root, _is_complete, _pivots
from subdiv_cli.checker.roots import _is_monotone


def forms(seed, count):
    """Random symmetric integer forms A'A - s, definite, semidefinite or neither, of short and long numbers."""
    rng = random.Random(seed)
    for _ in range(count):
        n, rank, size = rng.randrange(1, 6), rng.randrange(1, 6), rng.choice([1, 3, 10**6, 10**40])
        a = [[rng.randint(-size, size) for _ in range(n)] for _ in range(rank)]
        shift = rng.choice([0, 0, 0, 1, size, -1])
        yield [[sum(r[i] * r[j] for r in a) - shift * (i == j) for j in range(n)] for i in range(n)]


def least_signs(form):
    """Whether no eigenvalue is negative, and whether all are positive, by the characteristic polynomial."""
    n, f = len(form), fmpq_mat(form).charpoly()
    alternating = [f[k] * (-1) ** (n - k) for k in range(n + 1)]
    return all(c >= 0 for c in alternating), all(c > 0 for c in alternating)


def test_pivots_decide_semidefinite_and_definite_forms():
    seen = set()
    for form in forms(1, 400):
        semidefinite, definite = least_signs(form)
        assert _pivots(form, False) == semidefinite
        assert _pivots(form, True) == definite
        seen.add((semidefinite, definite))
    assert seen == {(True, True), (True, False), (False, False)}


def test_roots_in_integers_are_of_forms_above_the_order():
    """Never where C - N is not positive definite; of long definite forms nearly always."""
    proved = known = 0
    for form in forms(2, 400):
        shifted = [[x - len(form) * (i == j) for j, x in enumerate(row)] for i, row in enumerate(form)]
        definite = least_signs(shifted)[1]
        assert not _has_root(form) or definite
        large = [[x << 120 for x in row] for row in form]
        assert not _has_root(large) or least_signs(form)[1]
        proved, known = proved + _has_root(large), known + least_signs(form)[1]
    assert proved >= 0.95 * known > 0


def test_trees_of_words():
    """All sets of up to four words of up to two letters, against every long word."""
    ends = [word for length in (1, 2) for word in product(range(2), repeat=length)]
    complete = set()
    for size in range(1, 5):
        for words in product(ends, repeat=size):
            long = list(product(range(2), repeat=3))
            once = all(sum(w[: len(end)] == end for end in words) == 1 for w in long)
            assert _is_complete(words, 2) == (once and list(words) == sorted(words))
            if once:
                complete.add(tuple(sorted(words)))
    assert len(complete) == 4
    assert not _is_complete([], 2)
    assert not _is_complete([()], 2)
    assert not _is_complete([(0,), (1,), (2,)], 2)


@pytest.mark.parametrize("degree", [2, 3, 6, 12])
def test_monotone_is_so_by_sturm_too(degree):
    """Where m is seen to be monotone and changes its sign, Sturm counts one root; narrow intervals are seen."""
    rng, seen = random.Random(degree), 0
    for _ in range(300):
        p, q = rng.randrange(1, 40), rng.randrange(1, 20)
        g = [rng.randint(-9, 9) for _ in range(degree - 1)] + [rng.randint(1, 9)]
        m = [q * a - p * b for a, b in zip([0, *g], [*g, 0], strict=True)]
        width = Fraction(1, rng.choice([10, 1000, 10**6, 10**20]))
        low, high = Fraction(p, q) - width / 50, Fraction(p, q) + width
        slope = [k * c for k, c in enumerate(m)][1:]
        if _is_monotone(m, low, high):
            assert value(slope, low) * value(slope, high) > 0
            assert sturm_count(slope, low, high) == 0
            if value(m, low) * value(m, high) < 0:
                assert sturm_count(m, low, high) == 1
                seen += 1
    assert seen


def test_two_roots_and_double_roots_are_not_monotone():
    assert not _is_monotone([2, -3, 1], Fraction(1, 2), Fraction(5, 2))
    assert not _is_monotone([1, -2, 1], Fraction(1), Fraction(3, 2))
    assert not _is_monotone([-6, 11, -6, 1], Fraction(1, 2), Fraction(7, 2))
