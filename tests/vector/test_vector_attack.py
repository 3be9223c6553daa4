"""Random masks of matrices, many of them unstable, degenerate or near the critical radius, against floats.

The floats share no code with the package: S^n δ is iterated, and limits are read off by the sequence that the
transposed rule of even points converges to.
"""

import math
import random
from fractions import Fraction

import numpy as np
import pytest
from matrix_masks import blocked, conjugated, diagonal, scalar, scheme, smoothed
from support import cases

from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check

SEEDS = range(cases(4))
EACH = 16
LEVELS = ((6, 10), (10, 14))
"""The first and the last level of a rate; the second pair where what dies out slowly hides it at the first."""
SMOOTH = ((3, 5), (4, 6))
"""The same for limits so smooth that differences are soon below the noise of doubles."""


def convolved(a, b):
    """The product of two polynomials."""
    found = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            found[i + j] += Fraction(x) * Fraction(y)
    return found


def scalar_mask(rng, p):
    """Smoothing factors times a random cofactor; now and then times g(z^p)/g(z) for g = 1 + z, which is not stable."""
    k = rng.randint(1, 4)
    q = [Fraction(rng.randint(-5, 5), 4) for _ in range(rng.randint(1, 3))]
    q.append(1 - sum(q))
    mask = [Fraction(x) for x in q]
    for _ in range(k):
        mask = [x / p for x in convolved(mask, [1] * p)]
    mask = [x * p for x in mask]
    if p == 2 and rng.random() < 0.3:  # g(z) = 1 + z + z^2, g(z^2)/g(z) = 1 - z + z^2
        mask = convolved(mask, [1, -1, 1])
    return mask


def vector_mask(rng):
    """A mask of 2×2 or 3×3 matrices on Z and its arity."""
    p, sort = rng.choice((2, 2, 2, 3)), rng.randrange(5)
    a, b = scalar_mask(rng, p), scalar_mask(rng, p)
    if sort == 0 and p == 2:
        return blocked(a, -len(a) // 2, rng.choice((2, 3))), 2
    shear = rng.randint(-2, 2)
    change, inverse = [[1 + shear, shear], [1, 1]], [[1, -shear], [-1, 1 + shear]]
    weight = rng.choice((Fraction(1), Fraction(3, 4), Fraction(7, 8), Fraction(1, 2), Fraction(9, 8)))
    other = {i: [[weight * x for x in row] for row in rows] for i, rows in scalar(b).items()}
    mask = diagonal(scalar(a), other)
    if sort in (1, 2):  # one feeds the other
        i = rng.choice(sorted(mask))
        rows = [list(row) for row in mask[i]]
        rows[0][1] += Fraction(rng.randint(-2, 2), 4)
        mask[i] = rows
    if sort == 3 and p == 2 and weight < 1 and sum(Fraction(x) for x in a) == 2:
        mask = smoothed(mask, [[1, 0], [0, 1]], [[1, 0], [0, 1]])
    return conjugated(mask, change, inverse), p


def iterated(mask, p, levels):
    """The data S^n e_l δ, n = 0 … levels, for each l, as arrays with a row for each index, and their first indices."""
    low, m = min(mask), len(next(iter(mask.values())))
    matrices = {i: np.array([[float(x) for x in row] for row in rows]) for i, rows in mask.items()}
    found = []
    for unit in range(m):
        data, start = np.eye(m)[unit][None, :], 0
        each = [(data, start)]
        for _ in range(levels):
            fine = np.zeros((p * (len(data) - 1) + max(mask) - low + 1, m))
            for i, a in matrices.items():
                fine[i - low : i - low + p * (len(data) - 1) + 1 : p] += data @ a.T
            data, start = fine, p * start + low
            each.append((data, start))
        found.append(each)
    return found


def complement(mask, p):
    """Projectors to the common fixed vectors of the sums over the residue classes, and to their complement."""
    m = len(next(iter(mask.values())))
    rows = []
    for epsilon in range(p):
        total = sum((np.array(a, dtype=float) for i, a in mask.items() if i % p == epsilon), np.zeros((m, m)))
        rows.append(total - np.eye(m))
    _, values, right = np.linalg.svd(np.vstack(rows))
    constants = right[values < 1e-9]
    return constants, right[values >= 1e-9]


def decay(data, others):
    """The size of differences, and of what is not constant."""
    values = data[0]
    differences = np.abs(np.diff(np.vstack([values * 0, values, values * 0]), axis=0)).max()
    return max(differences, np.abs(values @ others.T).max() if len(others) else 0.0)


def stencils(mask, p, constants):
    """Rows w with T_0 w = w of the mask moved to begin at 0, by iteration of T_0 on x δ."""
    low, m = min(mask), len(next(iter(mask.values())))
    size = (max(mask) - low) // (p - 1) + 3
    operator = np.zeros((size * m, size * m))
    for i, a in mask.items():
        for alpha in range(size):
            if 0 <= (beta := p * alpha - (i - low)) < size:
                operator[m * alpha : m * alpha + m, m * beta : m * beta + m] += np.array(a, dtype=float).T
    power = np.linalg.matrix_power(operator, 1 << 20)
    at = m * (size // 2)
    return [(power[:, at : at + m] @ u).reshape(size, m) for u in constants]


def exponent(mask, p, constants, k, first, last):
    """-log_p of the rate at which the largest k-th differences of the limits fall between two levels."""
    sizes, weights, iterates = [], stencils(mask, p, constants), iterated(mask, p, last)
    for level in (first, last):
        largest = 0.0
        for each in iterates:
            values = each[level][0]
            for w in weights:
                line = sum(np.convolve(w[:, i], values[:, i]) for i in range(w.shape[1]))
                largest = max(largest, np.abs(np.diff(line, k)).max())
        sizes.append(largest)
    return -math.log(sizes[1] / sizes[0]) / math.log(p) / (last - first)


def rate(mask, p, others, first, last):
    """The rate per level at which differences, and what is not constant, fall between two levels."""
    iterates = iterated(mask, p, last)
    sizes = [max(decay(each[n], others) for each in iterates) for n in (first, last)]
    return (sizes[1] / max(sizes[0], 1e-300)) ** (1 / (last - first))


@pytest.fixture(scope="module")
def seen():
    """The numbers of masks of each sort that were met, asserted at the end."""
    counted = dict.fromkeys(("all", "proved", "refuted", "smooth", "exact", "degenerate"), 0)
    yield counted
    assert counted["proved"] >= counted["all"] / 4, counted
    assert counted["refuted"] >= counted["all"] / 4, counted
    assert counted["smooth"] >= 2, counted
    assert counted["degenerate"] >= 3, counted


@pytest.mark.parametrize("seed", SEEDS)
def test_random_masks_against_floats(seed, seen):
    rng = random.Random(seed)
    for _ in range(EACH):
        mask, p = vector_mask(rng)
        result = check(scheme(mask, p), (), Effort(6000)).result
        seen["all"] += 1
        deeper = LEVELS if p == 2 else ((3, 7), (8, 11))
        constants, others = complement(mask, p)
        assert result.dimension == len(constants)
        if result.convergent is Verdict.REFUTED:
            seen["refuted"] += 1
            if len(constants):
                assert any(rate(mask, p, others, *pair) > 0.95 for pair in deeper), mask
        if result.convergent is not Verdict.PROVED:
            continue
        seen["proved"] += 1
        seen["smooth"] += (result.smoothness.order or 0) >= 2
        seen["degenerate"] += 0 < len(constants) < len(next(iter(mask.values())))
        assert any(rate(mask, p, others, *pair) < 1 for pair in deeper), mask
        holder = result.holder
        if holder.exact is None or p != 2:
            continue
        seen["exact"] += 1
        k = math.floor(holder.lower) + 1
        found = (exponent(mask, p, constants, k, *pair) for pair in (LEVELS if k <= 4 else SMOOTH))
        assert any(abs(alpha - holder.lower) < 0.25 for alpha in found), (mask, holder)
        assert result.smoothness.order == math.ceil(holder.lower) - 1 or not result.smoothness.sharp
