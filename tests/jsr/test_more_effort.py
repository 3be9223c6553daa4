"""More effort never gives less: bounds from both sides only come closer, and what is exact stays so."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise

import pytest

from subdiv_cli.exact.linalg import matrix
from subdiv_cli.jsr import irreducible
from subdiv_cli.jsr.family import Family
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import joint_spectral_radius

UNCLOSED = {
    "ellipse": [[[2, 1], [0, -2]], [[2, 0], [-1, -2]]],
    "consensus": [
        [["1/5", "4/5", 0], [0, "1/5", "4/5"], ["1/5", 0, "4/5"]],
        [[1, 0, 0], ["4/5", "1/5", 0], [0, 0, 1]],
        [[1, 0, 0], [0, 1, 0], [0, "4/5", "1/5"]],
    ],
}
"""Families of radius 2 and 1, at which no polytope is seen to close."""


def family(seed):
    """Two matrices of an order from 4 to 12, two in five entries zero."""
    rng = random.Random(seed)
    n = rng.randrange(4, 13)
    entries = [rng.randint(-5, 5) if rng.random() < 0.6 else 0 for _ in range(2 * n * n)]
    return [[entries[i : i + n] for i in range(k, k + n * n, n)] for k in (0, n * n)]


def bounds(matrices, work):
    """The radius from below and above, and whether it is known."""
    found = joint_spectral_radius([[[Fraction(x) for x in row] for row in m] for m in matrices], Effort(work))
    assert found.document is not None
    return found.radius.lower, found.radius.upper, found.radius.exact is not None


@pytest.mark.parametrize("matrices", [*UNCLOSED.values(), *map(family, [1, 2, 5, 8, 12])])
def test_more_effort_never_gives_less(monkeypatch, matrices):
    monkeypatch.setattr(irreducible, "_QUICK_WORK", 20)
    results = [bounds(matrices, work) for work in (160, 320, 640)]
    for (low, high, known), (lower, higher, exact) in pairwise(results):
        assert exact or (not known and lower >= low and higher <= high)


LATER_IS_WORSE = [
    [[1, -5, -4, -3], [-5, 0, 3, 0], [-2, 0, -5, 0], [0, -2, 0, -2]],
    [[-2, 5, -5, 0], [-2, 1, 3, 0], [0, 1, 0, 5], [0, -1, 0, 2]],
]


def test_the_best_bound_of_all_attempts_is_taken(monkeypatch):
    """The polytope of the shortest products has 18 vertices and the bound 7.3411…; those of later ones, 7.4988…."""
    monkeypatch.setattr(irreducible, "_QUICK_WORK", 20)
    monkeypatch.setattr(irreducible._Attempt, "slackened", lambda attempt, effort, most: [])
    monkeypatch.setattr(irreducible, "ellipsoid_bound", lambda family, rate, effort: None)
    rows = Family([matrix([[Fraction(x) for x in row] for row in m]) for m in LATER_IS_WORSE])
    radius = irreducible.irreducible_radius(rows, Effort(110))
    assert radius.exact is None
    assert Fraction("7.34") < radius.upper[1] < Fraction("7.35")
