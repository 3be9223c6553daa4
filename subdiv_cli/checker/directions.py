"""Finite families of directions in Z^s: what they span, and their determinants. Counted work, no search."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import comb
from operator import mul

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.lattice import Index

_MINOR = 24
"""Products in a determinant of order 4."""


def determinant(rows: Sequence[Sequence[int]]) -> int:
    """By its first row (Laplace); 1 for no rows."""
    if not rows:
        return 1
    return sum(
        (-1) ** j * x * determinant([[*row[:j], *row[j + 1 :]] for row in rows[1:]]) for j, x in enumerate(rows[0]) if x
    )


def breadth(c: Claim, directions: Sequence[Index]) -> int:
    """d, the least number of directions whose removal leaves a set that does not span R^s; 0 if they do not span it.

    That is how many there are less the largest number in a hyperplane through 0. If they span R^s, a hyperplane with
    the largest number is spanned by s - 1 of them: otherwise another direction could be added to those in it.
    """
    s, n = len(directions[0]), len(directions)
    lines = sorted({max(x, tuple(-t for t in x)) for x in directions})
    subsets = comb(len(lines), s - 1)
    c.count(subsets * (s * _MINOR + s * n))
    normals = {_normal(subset) for subset in combinations(lines, s - 1)}
    return min((sum(1 for x in directions if sum(map(mul, normal, x))) for normal in normals if any(normal)), default=0)


def _normal(rows: Sequence[Index]) -> Index:
    """Perpendicular to s - 1 vectors; zero iff they are dependent."""
    s = len(rows) + 1
    return tuple((-1) ** i * determinant([[*row[:i], *row[i + 1 :]] for row in rows]) for i in range(s))


def is_unimodular(c: Claim, directions: Sequence[Index]) -> bool:
    """Whether every determinant of s of the directions is -1, 0 or 1: those of repeated ones are 0."""
    s = len(directions[0])
    different = sorted(set(directions))
    c.count(comb(len(different), s) * s * _MINOR)
    return all(abs(determinant(subset)) <= 1 for subset in combinations(different, s))
