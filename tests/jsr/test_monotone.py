"""Monotone polytopes: families of matrices that are not negative, from the combinatorics of words and at random."""

from __future__ import annotations

import json
from fractions import Fraction as Q
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from subdiv_cli.checker import check_document
from subdiv_cli.jsr.dominance import domination
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import CheckedRadius, joint_spectral_radius


def radius(matrices, work=4000) -> CheckedRadius:
    return joint_spectral_radius([[[Q(x) for x in row] for row in m] for m in matrices], Effort(work))


def digit_sums(count: int) -> list[list[list[int]]]:
    """M_ε[i][j] = 1 where 0 <= ε + i - 2j + N - 1 < count: how many ways Σ d_k 2^k, 0 <= d_k < count, is a number.

    Stern's sequence is that of count 3 (Reznick 1990; Protasov 2000).
    """
    order = count - 1
    return [
        [[int(0 <= e + i - 2 * j + order - 1 < count) for j in range(order)] for i in range(order)] for e in range(2)
    ]


def test_sterns_sequence_grows_like_powers_of_the_golden_ratio():
    found = radius(digit_sums(3)).radius
    assert found.exact == "root(x^2-x-1, 1.61803, 1.61804)"
    assert found.method == "monotone-closing"
    assert found.bounded


@pytest.mark.parametrize("half", [2, 3, 4])
def test_binary_partitions_with_an_even_number_of_digits(half):
    """n ↦ n^(log2 m) for 2m digits: the radius is m."""
    assert radius(digit_sums(2 * half)).radius.exact == str(half)


@pytest.mark.parametrize("order", [3, 5, 8])
def test_vertices_are_few(order):
    """The balanced polytope of the same family, its signs hidden by D M D, needs more, and says the same."""
    rng = np.random.default_rng(order)
    matrices = rng.integers(0, 3, (2, order, order)).tolist()
    signs = [(-1) ** i for i in range(order)]
    hidden = [[[signs[i] * signs[j] * x for j, x in enumerate(row)] for i, row in enumerate(m)] for m in matrices]
    one, other = radius(matrices).radius, radius(hidden).radius
    assert one.method == "monotone-closing"
    assert other.method == "closing"
    assert one.exact == other.exact
    assert (one.vertices or 0) <= (other.vertices or 0)


entries = st.sampled_from([0, 0, 0, 1, 1, 2, Q(1, 2)])


def families(order: int):
    return st.lists(
        st.lists(st.lists(entries, min_size=order, max_size=order), min_size=order, max_size=order),
        min_size=2,
        max_size=3,
    )


@settings(max_examples=60, deadline=None)
@given(st.integers(2, 4).flatmap(families))
def test_the_bounds_hold_and_are_verified(matrices):
    """Against all products of length up to 5; every certificate is verified after a round trip through JSON."""
    checked = radius(matrices, 1000)
    found = checked.radius
    assume(found.upper is not None)
    arrays = [np.array(m, dtype=float) for m in matrices]
    for length in range(1, 6):
        products = [np.linalg.multi_dot([np.eye(len(w[0])), *w]) for w in product(arrays, repeat=length)]
        assert found.upper >= max(max(abs(np.linalg.eigvals(x))) for x in products) ** (1 / length) - 1e-6
        assert found.lower <= max(np.abs(x).sum(axis=1).max() for x in products) ** (1 / length) + 1e-9
    assert check_document(json.loads(json.dumps(checked.document))).verified


columns = st.integers(1, 5).flatmap(
    lambda n: st.lists(st.lists(st.integers(0, 9), min_size=n, max_size=n), min_size=1, max_size=8)
)


@settings(max_examples=200, deadline=None)
@given(columns, st.lists(st.integers(0, 9), min_size=5, max_size=5))
def test_the_gauge_is_covered_and_no_functional_refutes_it(vertices, point):
    """Weak duality: Σ c v >= y with Σ c = value, and a multiple of y on the boundary is met from outside too."""
    v, y = np.array(vertices, dtype=float).T, np.array(point[: len(vertices[0])], dtype=float)
    value, numbers, weights = domination(v, y)
    if not np.isfinite(value):
        assert any(y[i] > 0 and not v[i].any() for i in range(len(y)))
        return
    assert all(c > 0 for c in weights)
    assert sum(weights) == pytest.approx(value)
    assert (v[:, list(numbers)] @ np.array(weights) >= y - 1e-7).all()
    if value > 1e-3:
        again = domination(v, y / value * 2)
        assert again[0] == pytest.approx(2, abs=1e-7) or value <= 1 - 1e-3
