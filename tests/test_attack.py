"""An attack on every verdict: structured random masks against floats that share no code with the prover.

The masks are smoothing factors times a random cofactor near the critical radius, some made unstable by g(z^p)/g(z).
Three witnesses speak against the prover: a branch-and-bound estimate of the joint spectral radius of the difference
matrices, direct subdivision of δ, and, for unstable masks, the smoothness of the stable mask they were built from.
The mix is asserted, so that the test cannot pass by deciding nothing. `SUBDIV_CASES` asks for another number of masks,
fresh ones.
"""

import math
from collections import Counter
from fractions import Fraction

import numpy as np
import pytest
from support import answer, cases, scheme, seeded

from subdiv_cli.model import Verdict

PARTS = 4
COUNT = cases(400) // PARTS
SLACK = 1e-7


def multiply(a, b):
    product = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            product[i + j] += x * y
    return product


def inflate(a, p):
    spread = [Fraction(0)] * ((len(a) - 1) * p + 1)
    spread[::p] = a
    return spread


def random_stable_part(rng, p):
    """(a, k, q): a = p ((1+…+z^(p-1))/p)^k q, q(1) = 1, q scaled so that the critical order is near an integer."""
    k = rng.choice([1, 1, 2, 2, 3, 4])
    while True:
        q = [
            Fraction(rng.randint(-6, 6), rng.choice([1, 2, 3, 4, 8])) for _ in range(rng.randint(1, 5 if p == 2 else 3))
        ]
        if rng.random() < 0.5:
            q += q[-2::-1]
        if sum(q) and q[0] and q[-1]:
            break
    q = [c / sum(q) for c in q]
    # pull the cofactor towards a monomial, so that divergence does not win every time
    t = Fraction(rng.choice([1, 2, 3, 4]), rng.choice([1, 2, 4, 8]))
    q = [c * t for c in q]
    q[len(q) // 2] += 1 - t
    a = [Fraction(p)]
    for _ in range(k):
        a = multiply(a, [Fraction(1, p)] * p)
    return multiply(a, q), k


FACTORS = [[1, 1], [5, -6, 5], [1, 2, 1], [1, 0, 1], [2, 1], [1, -3, 1], [1, 1, 1]]


def unstable(rng, a, p):
    """a(z) g(z^p)/g(z) where that is a polynomial: φ becomes a combination of its translates, as smooth as before."""
    for g in rng.sample(FACTORS, len(FACTORS)):
        g = [Fraction(c) for c in g]
        quotient = divide(multiply(a, inflate(g, p)), g)
        if quotient is not None and len(quotient) > len(a):
            return quotient
    return None


def divide(a, b):
    a, quotient = list(a), []
    while len(a) >= len(b):
        c = a[0] / b[0]
        quotient.append(c)
        for i, y in enumerate(b):
            a[i] -= c * y
        a.pop(0)
    return None if any(a) else quotient


def sum_rule_order(a, p):
    k = 0
    while (quotient := divide(a, [Fraction(1)] * p)) is not None:
        a, k = quotient, k + 1
    return k, a


def difference_matrices(a, p):
    """Float transition matrices of S_(Δ^k), written anew from Dyn 4.2."""
    k, q = sum_rule_order(a, p)
    d = np.array([float(c) for c in q])
    n = len(d) - 1
    size = max(1, math.ceil(n / (p - 1)))
    matrices = np.zeros((p, size, size))
    for e in range(p):
        for i in range(size):
            for j in range(size):
                t = e + i - p * j + (p - 1) * (size - 1)
                if 0 <= t <= n:
                    matrices[e, i, j] = d[t]
    return k, matrices


def jsr_bounds(matrices, limit=3000):
    """(low, high) in floats: spectral radii of products from below, norms of all words of a length from above."""
    low, high, level, words = 0.0, np.inf, 0, np.eye(matrices.shape[1])[None]
    while len(words) * len(matrices) <= limit:
        words = np.einsum("aij,wjk->awik", matrices, words).reshape(-1, *matrices.shape[1:])
        level += 1
        radii = np.abs(np.linalg.eigvals(words)).max(axis=1)
        norms = np.linalg.norm(words, 2, axis=(1, 2))
        low = max(low, radii.max() ** (1 / level))
        high = min(high, norms.max() ** (1 / level))
        if level >= 12:
            break
    return low, high


def mean_square_exponent(a, p):
    """-log_p(ρ)/2 for the autocorrelation of S_(Δ^k): never above the Sobolev exponent, and equal for a stable mask."""
    _, q = sum_rule_order(a, p)
    d, n = np.array([float(c) for c in q]), len(q) - 1
    b = {t - n: x for t, x in enumerate(np.convolve(d, d[::-1]))}
    places = range(-n - 1, n + 2)
    return exponent(max(abs(np.linalg.eigvals([[b.get(p * i - j, 0.0) / p for j in places] for i in places]))), p) / 2


def subdivide_delta(a, p, levels):
    """Largest difference of neighbours of S^L δ, L = 0, 1, …: goes to 0 iff S converges, where residue sums are 1."""
    mask, data, sizes = np.array([float(c) for c in a]), np.array([1.0]), []
    for _ in range(levels):
        sizes.append(np.abs(np.diff(data, prepend=0, append=0)).max())
        spread = np.zeros((len(data) - 1) * p + 1)
        spread[::p] = data
        data = np.convolve(spread, mask)
    return sizes


def exponent(low_or_high, p):
    return -math.log(low_or_high, p) if low_or_high > 0 else math.inf


def attack(rng, mix):
    p = rng.choice([2, 2, 2, 3, 4, 5])
    a, _ = random_stable_part(rng, p)
    parent = a
    if rng.random() < 0.4 and (twisted := unstable(rng, a, p)) is not None:
        a = twisted
    result = answer(scheme(a, start=rng.randint(-9, 9), arity=p), work=4000)
    note = f"p = {p}, mask {[str(c) for c in a]}: "

    k, matrices = difference_matrices(a, p)
    low, high = jsr_bounds(matrices)
    residues_hold = k >= 1
    # convergence: JSR(D) < 1
    if result.convergent is Verdict.PROVED:
        assert residues_hold, note
        assert low < 1 + SLACK, note + "proved, but a product has radius >= 1"
        sizes = subdivide_delta(a, p, 8 if p == 2 else 5)
        assert sizes[-1] < 50 * max(high, low, 1 / p) ** (len(sizes) - 1) * 10, note
    if result.convergent is Verdict.REFUTED:
        assert not residues_hold or high > 1 - SLACK, note + "refuted, but all long products are small"
    # the parent is as smooth as the mask; a stable mask is its own exponent
    _, parent_matrices = difference_matrices(parent, p)
    for family in [parent_matrices] + ([matrices] if result.stable is Verdict.PROVED else []):
        family_low, family_high = jsr_bounds(family)
        alpha_high, alpha_low = exponent(family_low, p), exponent(family_high, p)
        if result.refinable.order is not None and result.stable is Verdict.PROVED:
            assert result.refinable.order < alpha_high + SLACK, (
                note + f"C^{result.refinable.order} against {alpha_high}"
            )
        if result.refinable.sharp:
            refuted = 0 if result.refinable.order is None else result.refinable.order + 1
            assert alpha_low <= refuted + SLACK, note + f"not C^{refuted} against {alpha_low}"
        if result.holder is not None and family is matrices:
            assert result.holder.lower <= alpha_high + SLACK, note
            assert result.holder.upper >= alpha_low - SLACK, note
            mix["exact"] += result.holder.exact is not None
    if result.sobolev is not None:
        assert result.sobolev.upper >= mean_square_exponent(parent, p) - 1e-6, note
        assert result.sobolev.lower >= result.holder.lower - SLACK, note
        assert result.sobolev.lower - 0.5 <= result.holder.upper, note
        if result.stable is Verdict.PROVED:
            assert abs(result.sobolev.lower - mean_square_exponent(a, p)) < 1e-6, note
    mix[result.convergent.value] += 1
    mix["stable" if result.stable is Verdict.PROVED else "unstable"] += 1
    if result.refinable.order is not None:
        mix[f"C{min(result.refinable.order, 2)}"] += 1
        mix["sharp"] += result.refinable.sharp
    if result.stable is Verdict.REFUTED and result.convergent is Verdict.REFUTED and result.refinable.order is not None:
        mix["smooth but divergent"] += 1


@pytest.mark.parametrize("part", range(PARTS))
def test_no_verdict_contradicts_the_floats(part, capsys):
    rng, mix = seeded(part), Counter()
    for _ in range(COUNT):
        attack(rng, mix)
    with capsys.disabled():
        print(f"\n  {COUNT} masks, part {part}: {dict(mix)}")
    assert mix["proved"] >= COUNT / 4
    assert mix["refuted"] >= COUNT / 4
    assert mix["C2"] >= COUNT / 50
    assert mix["unstable"] >= COUNT / 20
    assert mix["sharp"] >= COUNT / 8
    assert mix["exact"] >= COUNT / 4
