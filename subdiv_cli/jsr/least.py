"""Vectors as combinations of columns with the least sum of absolute values: many linear programmes at once.

That sum is the gauge of the hull of the columns and their opposites. The programmes are solved in floats (`gauge`), and
of what they say only the bases are used: the weights are solved for exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from subdiv_cli.exact.linalg import Combination, combinations
from subdiv_cli.jsr.gauge import Bases, gauges


def least_combinations(
    columns: Sequence[Sequence[int]], targets: Sequence[Sequence[Fraction]], basis: Sequence[int]
) -> tuple[Combination, ...]:
    """Each target as a combination of as many columns as it has coordinates, with the least sum that floats see.

    Exact for each target, whether or not the sum is the least. `basis` numbers independent columns, where the search
    starts.
    """
    array = np.array(columns, dtype=np.float64).T
    goals = np.array([[float(x) for x in target] for target in targets])
    numbers = np.tile(np.array(basis, dtype=np.int64), (len(goals), 1))
    least = gauges(array, goals, Bases(numbers, np.ones(numbers.shape)), inside=0.0, outside=float("inf"))
    result: list[Combination] = []
    for target, best in zip(targets, least.bases.numbers.tolist(), strict=True):
        solved = combinations(columns, [target], best)
        if solved is None:
            solved = combinations(columns, [target], basis)
            assert solved is not None, "the basis is dependent"
        result += solved
    return tuple(result)
