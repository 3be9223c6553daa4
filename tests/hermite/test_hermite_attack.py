"""Random Hermite masks, many of them unstable, conjugated or near the critical radius, against floats.

The floats share no code with the package: c^n = D^-n S^n δ is iterated. S is HC^(d-1) iff each component is a Cauchy
sequence, ever less different at neighbours, and h times its sum ever closer to the component before.
"""

import random
from fractions import Fraction

import numpy as np
import pytest
from matrix_masks import (
    conjugated,
    de_rham,
    hermite_interpolation,
    merrien,
    scalar,
    scheme,
    smoothed_jets,
    spaces,
)
from support import cases

from subdiv_cli.model import Effort, Verdict
from subdiv_cli.pipeline import check

SEEDS = range(cases(4))
EACH = 12
LEVELS = {2: (7, 12), 3: (4, 7)}
"""The first and the last level of a rate, for each arity."""


def by_differences(rng):
    """A scalar mask, stable or not, and the derivative as a difference of its limit stencil of the level before."""
    k, q = rng.randint(1, 4), [Fraction(rng.randint(-2, 2), 4) for _ in range(rng.randint(0, 2))]
    a = np.convolve(np.array([*q, 1 - sum(q)], dtype=object), [Fraction(1, 2), Fraction(1, 2)])
    for _ in range(k - 1):  # 1 + z^2 for 1 + z: not stable, as smooth, and with fewer jets that are reproduced
        a = np.convolve(a, rng.choice(([Fraction(1, 2), Fraction(1, 2)], [Fraction(1, 2), 0, Fraction(1, 2)])))
    a = [2 * x for x in a]
    stencils = spaces(scalar(a)).stencils
    if stencils is None:
        return None
    w = {i: Fraction(int(x.p), int(x.q)) for (i,), (x,) in stencils[0].items()}
    zero = [Fraction(0)] * 2
    mask = {i: [[x, Fraction(0)], list(zero)] for i, x in enumerate(a)}
    for i in range(min(w), max(w) + 2):
        for e in (0, 1):
            row = mask.setdefault(e + 2 * i, [list(zero), list(zero)])
            row[1][0] += (w.get(i, 0) - w.get(i - 1, 0)) / 2
    return mask


def hermite_mask(rng):
    """A mask of jets, and its arity."""
    sort = rng.randrange(9)
    lam = -Fraction(rng.randint(1, 12), 32) if sort else Fraction(-1, 8)
    mu = Fraction(rng.randint(-7, 5), 4)
    mask, p = merrien(lam, mu), 2
    if sort == 1:
        mask = de_rham(mask)
    elif sort == 2:
        mask = smoothed_jets(mask)
    elif sort in (3, 6, 7):
        mask = by_differences(rng) or mask
    elif sort == 4:
        mask, p = hermite_interpolation(2, 3), 3
        weight = Fraction(rng.randint(-4, 4), 18)
        for left, right in ((1, -2), (2, -1)):  # another rule for derivatives, the same for x
            for i, sign in ((left, 1), (right, -1)):
                mask[i][1] = [mask[i][1][0] + sign * 2 * weight, mask[i][1][1] + weight]
    elif sort == 5:
        mask = hermite_interpolation(3)
        weight = Fraction(rng.randint(-2, 5), 16)
        for i, sign in ((-1, 1), (1, -1)):
            mask[i][2][1] -= sign * weight
            mask[i][2][2] += weight / 2
    d = len(next(iter(mask.values())))
    if rng.random() < 0.4:
        s = [Fraction(rng.randint(-2, 2), 2) for _ in range(3)]
        change = [[1, s[0], s[1]], [0, 1, s[2]], [0, 0, 1]]
        inverse = [[1, -s[0], s[0] * s[2] - s[1]], [0, 1, -s[2]], [0, 0, 1]]
        mask = conjugated(mask, [row[:d] for row in change[:d]], [row[:d] for row in inverse[:d]])
    if rng.random() < 0.15:
        c = rng.choice((Fraction(2), Fraction(1, 2), Fraction(-1)))
        last = [[Fraction(int(k == l)) * (c if k == d - 1 else 1) for l in range(d)] for k in range(d)]
        mask = conjugated(mask, [[1 / x if x else x for x in row] for row in last], last)
    return mask, p


def jets(mask, p, levels):
    """The data D^-n S^n e_l δ of each level, for each l, a row for each index, with zeros at both ends."""
    low, d = min(mask), len(next(iter(mask.values())))
    matrices = {i: np.array([[float(Fraction(x)) for x in row] for row in rows]) for i, rows in mask.items()}
    found = []
    for unit in range(d):
        data, start, each = np.eye(d)[unit][None, :], 0, []
        for n in range(levels + 1):
            scaled = data * float(p) ** (n * np.arange(d))
            each.append((np.vstack([np.zeros(d), scaled, np.zeros(d)]), start - 1))
            fine = np.zeros((p * (len(data) - 1) + max(mask) - low + 1, d))
            for i, a in matrices.items():
                fine[i - low : i - low + p * (len(data) - 1) + 1 : p] += data @ a.T
            data, start = fine, p * start + low
        found.append(each)
    return found


def distance(each, p, n):
    """How far the data of a level are from the jets of one function, in the largest of three ways."""
    (data, start), (fine, fine_start) = each[n], each[n + 1]
    neighbours = np.abs(np.diff(data, axis=0)).max()
    places = p * (np.arange(len(data)) + start) - fine_start
    inside = (places >= 0) & (places < len(fine))
    levels = np.abs(data - np.where(inside[:, None], fine[np.clip(places, 0, len(fine) - 1)], 0.0)).max()
    sums = np.abs(np.cumsum(data[:, 1:], axis=0) / p**n - data[:, :-1]).max()
    return max(neighbours, levels, sums)


def rate(mask, p):
    """The rate per level at which the data approach jets, and how far they are at the last one."""
    first, last = LEVELS[p]
    iterates = jets(mask, p, last + 1)
    sizes = [max(distance(each, p, n) for each in iterates) for n in (first, last)]
    return (sizes[1] / sizes[0]) ** (1 / (last - first)), sizes[1]


@pytest.fixture(scope="module")
def seen():
    """The numbers of masks of each sort that were met, asserted at the end."""
    counted = dict.fromkeys(("all", "proved", "refuted", "smooth", "no spectral condition", "three", "unknown"), 0)
    yield counted
    assert counted["proved"] >= counted["all"] / 4, counted
    assert counted["refuted"] >= counted["all"] / 4, counted
    assert counted["smooth"] >= 2, counted
    assert counted["no spectral condition"] >= 2, counted
    assert counted["three"] >= 2, counted
    assert counted["unknown"] <= counted["all"] / 8, counted


@pytest.mark.parametrize("seed", SEEDS)
def test_random_masks_against_floats(seed, seen):
    rng = random.Random(seed)
    for _ in range(EACH):
        mask, p = hermite_mask(rng)
        result = check(scheme(mask, p, "hermite"), (), Effort(6000)).result
        seen["all"] += 1
        found, left = rate(mask, p)
        radii = [p ** f.witness["order"] * f.value.upper for f in result.findings if f.code == "SD715" and f.value]
        if result.convergent is Verdict.REFUTED:
            seen["refuted"] += 1
            assert found > 0.93, (mask, p, found, left)
            assert left > 1e-3, (mask, p, found, left)
        elif result.convergent is Verdict.PROVED:
            seen["proved"] += 1
            d = len(next(iter(mask.values())))
            seen["smooth"] += result.smoothness.order >= d
            seen["three"] += d == 3
            seen["no spectral condition"] += result.spectral is Verdict.REFUTED
            assert found < min(0.99, max(*radii, 1 / p) + 0.12), (mask, p, found, left)
            assert result.smoothness.order >= d - 1
        else:
            seen["unknown"] += 1


def test_a_change_of_data_that_dies_out_changes_nothing():
    """Data R^-1 c with an upper triangular R with ones: in the limit they are jets of the same function."""
    for mask in (merrien("-1/10", "-1/2"), hermite_interpolation(3)):
        d = len(mask[0])
        change = [[Fraction(int(k == l)) + (2 if l == k + 1 else 0) for l in range(d)] for k in range(d)]
        inverse = [[(-2) ** (l - k) if l >= k else 0 for l in range(d)] for k in range(d)]
        one = check(scheme(mask, kind="hermite"), (), Effort()).result
        other = check(scheme(conjugated(mask, change, inverse), kind="hermite"), (), Effort()).result
        assert one.convergent is other.convergent is Verdict.PROVED
        assert (str(one.holder.exact), one.smoothness) == (str(other.holder.exact), other.smoothness)


@pytest.mark.parametrize("c", ["2", "1/3", "-1", "99/100"])
def test_a_multiple_of_the_derivative_is_refuted_with_the_way_out(c):
    c = Fraction(c)
    mask = conjugated(hermite_interpolation(2), [[1, 0], [0, 1 / c]], [[1, 0], [0, c]])
    result = check(scheme(mask, kind="hermite"), (), Effort()).result
    assert result.convergent is Verdict.REFUTED
    assert result.holder.exact == 2
    (hint,) = result.hints
    assert f"is {c} times the derivative: with R = diag(1, {c})" in hint
    back = conjugated(mask, [[1, 0], [0, c]], [[1, 0], [0, 1 / c]])
    assert back == hermite_interpolation(2)


@pytest.mark.parametrize(("components", "arity"), [(2, 2), (3, 2), (2, 3)])
@pytest.mark.parametrize("shift", [-4, 6])
def test_a_shift_of_the_mask_changes_nothing_but_the_shift_of_jets(components, arity, shift):
    mask = hermite_interpolation(components, arity)
    moved = {i + shift: a for i, a in mask.items()}
    one, other = (check(scheme(m, arity, "hermite"), (), Effort()).result for m in (mask, moved))
    assert one.convergent is other.convergent is Verdict.PROVED
    assert (one.holder, one.smoothness, one.generation) == (other.holder, other.smoothness, other.generation)
    (found,) = (each for each in other.findings if each.code == "SD714")
    tau = Fraction(shift, arity - 1)  # limits move by τ: the jets of f_j = (x + τ)^j/j! have the limit x^j/j!
    assert found.witness["shifts"][:3] == (1, tau, tau**2 / 2)
