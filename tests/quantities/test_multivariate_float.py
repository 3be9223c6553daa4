"""Convergence and exponents in several variables against the decay of differences of the subdivided delta, in floats.

Nothing is shared with the exact route: no transition operators and no V_k. For stable φ the k-th differences of S^n δ
decay like λ^(-αn), k the order of the sum rules; for unstable masks not faster.
"""

import random
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from support import answer, multivariate_scheme, shipped_answer, shipped_multivariate

from subdiv_cli.catalog import masks_directory
from subdiv_cli.model import Verdict

SLOW = {
    "kobbelt_sqrt3",
    "labsik_greiner",
    "quincunx_interpolatory_4",
    "tensor_six_point",
    "tensor_ternary_four_point",
    "butterfly_1_10",
    "butterfly_1_12",
}
MOST_POINTS = {2: 100_000, 3: 500_000}
NAMES = sorted(
    path.relative_to(masks_directory() / "multivariate").with_suffix("").as_posix()
    for path in (masks_directory() / "multivariate").rglob("*.toml")
    if path.stem not in SLOW
)


def subdivided_deltas(scheme):
    """S δ, S² δ, … as arrays over boxes, while they are not too large."""
    m = np.array(scheme.dilation)
    steps = np.array(list(scheme.terms))
    weights = np.array([float(x) for x in scheme.terms.values()])
    places, values = np.zeros((1, scheme.dimension), dtype=int), np.ones(1)
    while True:
        points = (places @ m.T)[:, None, :] + steps[None, :, :]
        added = (values[:, None] * weights[None, :]).ravel()
        points = points.reshape(-1, scheme.dimension)
        low, high = points.min(axis=0), points.max(axis=0)
        box = np.zeros(high - low + 1)
        if box.size > MOST_POINTS[scheme.dimension]:
            return
        np.add.at(box, tuple((points - low).T), added)
        yield box
        nonzero = np.argwhere(box)
        places, values = nonzero + low, box[tuple(nonzero.T)]


def difference(box, direction):
    """v - v(· - direction), on a larger box."""
    padded = np.pad(box, [(abs(x), abs(x)) for x in direction])
    return padded - np.roll(padded, direction, axis=range(len(direction)))


def directions(dimension):
    """±-classes of the directions with entries -1, 0, 1."""
    return [d for d in product((-1, 0, 1), repeat=dimension) if d > (0,) * dimension]


def decay(scheme, k):
    """For each direction the factor by which k-th differences in it shrink in a step, over the last four steps."""
    sizes = {d: [] for d in directions(scheme.dimension)}
    for box in subdivided_deltas(scheme):
        for d, found in sizes.items():
            v = box
            for _ in range(k):
                v = difference(v, d)
            found.append(np.abs(v).max())
    span = 4 if len(found) > 5 else 2
    return {d: (found[-1] / found[-1 - span]) ** (1 / span) for d, found in sizes.items()}


def exponents(scheme, k):
    """-log_λ of the factors."""
    log = np.log(abs(np.linalg.det(np.array(scheme.dilation, dtype=float)))) / scheme.dimension
    return {d: float(-np.log(factor) / log) for d, factor in decay(scheme, k).items()}


@pytest.mark.parametrize("name", NAMES)
def test_the_catalog_against_the_decay_of_differences(name):
    scheme, result = shipped_multivariate(name), shipped_answer(name)
    k = result.sum_rule_order
    if not k:
        assert result.convergent is Verdict.REFUTED
        return
    found = exponents(scheme, k)
    slowest = min(found.values())
    assert (slowest > 0.1) is (result.convergent is Verdict.PROVED)
    if result.holder is None:
        return
    lower, upper = result.holder.lower, result.holder.upper
    if lower is not None and result.stable is not Verdict.REFUTED:
        assert slowest >= lower - 0.35
    if upper is not None:
        assert slowest <= upper + 0.1


@pytest.mark.parametrize("name", ["tensor_cubic_four_point", "box_211", "counterexamples/box_21_discontinuous"])
def test_one_direction_is_worse_than_another(name):
    """The exponent belongs to the worst direction, and another decays faster by half an order at least."""
    scheme, result = shipped_multivariate(name), shipped_answer(name)
    found = exponents(scheme, 4)
    assert max(found.values()) >= min(found.values()) + 0.5
    lower = 0 if result.holder is None else result.holder.lower
    assert abs(min(found.values()) - lower) < 0.35


def random_masks():
    """Two or three box-spline factors times 1 + c(δ - …), of which about half converge."""
    chosen = random.Random(8)
    axes = [(1, 0), (0, 1), (1, 1), (1, -1)]
    for _ in range(28):
        thetas = [(1, 0), (0, 1), *chosen.sample(axes, chosen.randint(0, 1))]
        terms = {(0, 0): Fraction(4, 2 ** len(thetas))}
        for x, y in thetas:
            terms = added(terms, {(i + x, j + y): v for (i, j), v in terms.items()})
        c = Fraction(chosen.choice([-3, -2, 2, 3, 4, 5]), 4)
        x, y = chosen.choice(axes)
        rough = {index: v * (1 - c) for index, v in terms.items()}
        yield multivariate_scheme(added(rough, {(i + x, j + y): v * c for (i, j), v in terms.items()}))


def added(a, b):
    return {index: a.get(index, 0) + b.get(index, 0) for index in {**a, **b}}


def test_random_masks_against_the_decay_of_differences():
    verdicts = []
    for scheme in random_masks():
        result = answer(scheme, 4000)
        verdicts.append(result.convergent)
        if not result.sum_rule_order:
            continue
        slowest = min(exponents(scheme, result.sum_rule_order).values())
        if result.convergent is Verdict.PROVED:
            assert slowest > -0.1
        if result.convergent is Verdict.REFUTED:
            assert slowest < 0.1
        if result.holder is not None and result.stable is Verdict.PROVED:
            assert slowest >= result.holder.lower - 0.35
    for verdict in (Verdict.PROVED, Verdict.REFUTED):
        assert 4 * verdicts.count(verdict) >= len(verdicts)
