"""The gauge of a monotone polytope: how little of its vertices covers a vector, by linear programming in floats.

The gauge of y >= 0 in co_-(V) = {x >= 0 : x <= Σ c_v v, c >= 0, Σ c <= 1}, V >= 0, is min Σ c over c >= 0, Σ c_v v >= y
(Guglielmi & Protasov 2013, section 3). Its dual, max f·y over f >= 0, f·v <= 1 for all v, has the starting point f = 0,
and its multipliers are the weights c.
"""

from __future__ import annotations

import numpy as np

from subdiv_cli.jsr.arrays import Array, Integers
from subdiv_cli.model import Look, no_clock

_OPTIMAL = 1e-11
_SMALLEST_PIVOT = 1e-11
_MOST_STEPS = 500

Covered = tuple[float, tuple[int, ...], tuple[float, ...]]


class Dominations:
    """Gauges of M targets in a monotone hull: each target is below Σ weights · columns, its gauge at most `value`."""

    def __init__(self, covered: list[Covered]) -> None:
        self._covered = covered
        self.value: Array = np.array([value for value, _, _ in covered])

    def chosen(self, targets: Integers) -> Dominations:
        """The rows of `targets` in this batch."""
        return Dominations([self._covered[k] for k in targets])

    def shares(self, k: int) -> tuple[tuple[int, ...], tuple[float, ...]]:
        """The columns and the weights of target k."""
        return self._covered[k][1], self._covered[k][2]


def domination(columns: Array, target: Array, look: Look = no_clock) -> Covered:
    """The gauge of a vector of N entries in the hull of the n columns (N×n), with numbers of columns and weights.

    It is infinite where the columns do not cover the vector. Raises what `look` raises.
    """
    if (single := _by_one(columns, target)) is not None:
        return single
    rows, limits, prices = columns.T.copy(), np.ones(columns.shape[1]), target.copy()
    order = len(target)
    inside, outside = np.arange(order), np.arange(order, order + len(limits))  # f_i, then the slacks of f·v <= 1
    for _ in range(_MOST_STEPS):
        look()
        entering = int(prices.argmax())
        if prices[entering] <= _OPTIMAL:
            return _weights(prices, inside, order)
        column = rows[:, entering]
        if not (positive := column > _SMALLEST_PIVOT).any():
            break
        ratios = np.full(len(limits), np.inf)
        np.divide(limits, column, out=ratios, where=positive)
        leaving = int(ratios.argmin())
        _exchange(rows, limits, prices, leaving, entering)
        inside[entering], outside[leaving] = outside[leaving], inside[entering]
    return np.inf, (), ()


def _by_one(columns: Array, target: Array) -> Covered | None:
    """The smallest multiple of one column that covers the vector, where that is well inside; None otherwise."""
    needed = target[:, None] > _SMALLEST_PIVOT
    with np.errstate(divide="ignore", invalid="ignore"):
        sizes = np.where(needed, target[:, None] / np.maximum(columns, 0.0), 0.0).max(axis=0)
    k = int(sizes.argmin())
    if not sizes[k]:
        return 0.0, (), ()
    return (float(sizes[k]), (k,), (float(sizes[k]),)) if sizes[k] <= 1 - 1e-3 else None


def _exchange(rows: Array, limits: Array, prices: Array, leaving: int, entering: int) -> None:
    """A pivot of the tableau without its identity columns, in place."""
    pivot = rows[leaving, entering]
    row, limit = rows[leaving] / pivot, limits[leaving] / pivot
    column = rows[:, entering].copy()
    column[leaving] = 0.0
    price = prices[entering]
    rows -= column[:, None] * row
    limits -= column * limit
    prices -= price * row
    rows[:, entering] = -column / pivot
    prices[entering] = -price / pivot
    rows[leaving], limits[leaving] = row, limit
    rows[leaving, entering] = 1 / pivot


def _weights(prices: Array, inside: Integers, order: int) -> Covered:
    """The gauge and its weights from the multipliers, which are what slacks in the head of the tableau would cost."""
    pairs = [(int(name) - order, -float(price)) for name, price in zip(inside, prices, strict=True) if name >= order]
    pairs = sorted((k, c) for k, c in pairs if c > 0)
    return sum(c for _, c in pairs), tuple(k for k, _ in pairs), tuple(c for _, c in pairs)
