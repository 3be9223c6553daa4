"""Small linear programs over the rationals, solved exactly by the simplex method with Bland's rule, which ends."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

Rationals = Sequence[Fraction]


class Optimum(NamedTuple):
    """The weights w with A w = b whose smallest one is largest, and why it is no larger.

    With `multipliers` y: y·(column j of A) >= 0 for all j, these sum to 1, and y·b = `least`.
    """

    weights: tuple[Fraction, ...]
    least: Fraction
    multipliers: tuple[Fraction, ...]


def largest_least_weight(columns: Sequence[Rationals], right: Rationals) -> Optimum | None:
    """The optimum for the columns of A, the first entry of each being 1, as that of b is; None where there is no w.

    With w = s + t, s >= 0 and n columns, t = (1 - Σ s)/n by the first row, and Σ s is to be smallest under the others,
    each less its mean. An optimal y' of that program's dual has y'·(column j) <= 1 and y'·b = Σ s.
    """
    n = len(columns)
    means = [sum(row, Fraction(0)) / n for row in zip(*columns, strict=True)][1:]
    table = [[x - mean for x in row] for row, mean in zip(list(zip(*columns, strict=True))[1:], means, strict=True)]
    solved = _smallest_sum(table, [x - mean for x, mean in zip(right[1:], means, strict=True)])
    if solved is None:
        return None
    s, dual = solved
    least = (1 - sum(s, Fraction(0))) / n
    constant = 1 + sum((y * mean for y, mean in zip(dual, means, strict=True)), Fraction(0))
    multipliers = tuple(x / n for x in (constant, *(-y for y in dual)))
    return Optimum(tuple(x + least for x in s), least, multipliers)


def _smallest_sum(rows: Sequence[Rationals], right: Rationals) -> tuple[list[Fraction], list[Fraction]] | None:
    """The s >= 0 of smallest sum with rows·s = right, and an optimal y: y·(column j) <= 1; None without such an s."""
    n, m = len(rows[0]) if rows else 0, len(rows)
    signs = [1 if x >= 0 else -1 for x in right]
    table = [
        [*(sign * x for x in row), *(Fraction(int(i == k)) for k in range(m)), sign * b]
        for i, (row, b, sign) in enumerate(zip(rows, right, signs, strict=True))
    ]
    basis = list(range(n, n + m))
    _minimise(table, basis, [Fraction(0)] * n + [Fraction(1)] * m, n + m)
    if any(table[i][-1] for i, j in enumerate(basis) if j >= n):
        return None
    for i, j in enumerate(basis):
        place = next((k for k in range(n) if table[i][k]), None) if j >= n else None
        if place is not None:
            _pivot(table, basis, i, place)
    cost = [Fraction(1)] * n + [Fraction(0)] * m
    _minimise(table, basis, cost, n)
    s = [Fraction(0)] * n
    for i, j in enumerate(basis):
        if j < n:
            s[j] = table[i][-1]
    y = [sum((cost[j] * table[i][n + k] for i, j in enumerate(basis)), Fraction(0)) for k in range(m)]
    return s, [sign * x for sign, x in zip(signs, y, strict=True)]


def _minimise(table: list[list[Fraction]], basis: list[int], cost: Rationals, allowed: int) -> None:
    """Pivot until no column below `allowed` lowers the cost; the least such column enters, the least basic one leaves.

    A basic column that may not come again has the value 0 and no other entries in its row, so it stays at 0.
    """
    while True:
        prices = [(cost[j], row) for j, row in zip(basis, table, strict=True) if cost[j]]
        lower = (j for j in range(allowed) if cost[j] < sum((c * row[j] for c, row in prices), Fraction(0)))
        entering = next(lower, None)
        if entering is None:
            return
        ratios = [(row[-1] / row[entering], basis[i], i) for i, row in enumerate(table) if row[entering] > 0]
        _pivot(table, basis, min(ratios)[2], entering)


def _pivot(table: list[list[Fraction]], basis: list[int], i: int, j: int) -> None:
    pivot = table[i][j]
    table[i] = [x / pivot for x in table[i]]
    for k, row in enumerate(table):
        if k != i and row[j]:
            factor = row[j]
            table[k] = [x - factor * y for x, y in zip(row, table[i], strict=True)]
    basis[i] = j
