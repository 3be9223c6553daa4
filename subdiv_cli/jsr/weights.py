"""The radius of matrices that are not negative, by one positive vector: M_i u <= ρ u for all i, or u' M_i <= ρ u'.

Then all matrices have norms <= ρ in max |y_k|/u_k, or in Σ u_k |y_k|. So it is for stochastic matrices, with u = (1, …,
1), for those of column sums 1, and for both in other units D^-1 M_i D. The least ρ for which there is such a u is the
eigenvalue of the map u -> max_i M_i u, coordinate by coordinate, which iteration finds in floats; where it is rational
and not larger than that of a product, u is rounded and the rest is exact.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from fractions import Fraction

import numpy as np
from flint import fmpq_mat

from subdiv_cli.exact.linalg import eigenvectors, matrix
from subdiv_cli.exact.rationals import to_fmpq, to_fraction
from subdiv_cli.jsr.arrays import Array
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.result import Radius, meeting
from subdiv_cli.jsr.search import candidates
from subdiv_cli.model import Effort
from subdiv_cli.model.proofs import LowerBound, RadiusProof

_SHORT = 2
"""The length of the products that may have the radius."""
_SWEEPS = 2000
_NEAR = 1e-10
_ROUNDED = 40
"""The binary places of a vector that grows."""
_DENOMINATORS = (1, 60, 1000, 1 << 20)
"""The largest denominators of a vector's entries over the largest one, and of the radius."""


def weighted_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius of a family without negative entries, where it is rational and one positive vector proves it."""
    if not family.size:
        return None
    rate, contenders = candidates(family, _SHORT, effort=effort)
    sigma = _rational(rate, family)
    if sigma is None:
        return None
    for left in (False, True):
        floats = family.floats.transpose(0, 2, 1) if left else family.floats
        estimate = _iterated(floats, rate, effort)
        if estimate is None:
            continue
        turned = [m.transpose() for m in family.matrices] if left else list(family.matrices)
        u = next((v for v in _rounded(turned, floats, estimate, sigma) if _is_common(turned, v, sigma)), None)
        if u is None:
            continue
        for candidate in contenders:
            if (below := _attained(family, family.full_word(candidate), sigma, u, left)) is not None:
                part: RadiusProof = {"rule": "common-vector", "length": 1, "bound": sigma, "left": left, "vector": u}
                return meeting(part, below, 1, sigma)
    return None


def _rational(rate: float, family: Family) -> Fraction | None:
    """The rational that a radius seems to be: of small numerator and denominator, or so beside the largest entry."""
    for most, unit in itertools.product(_DENOMINATORS, (family.unit, family.size)):
        share = rate * float(family.unit / unit)
        guess = Fraction(share).limit_denominator(most)
        if guess > 0 and abs(float(guess) / share - 1) < _NEAR:
            return guess * unit
    return None


def _iterated(matrices: Array, rate: float, effort: Effort) -> Array | None:
    """A vector u > 0, its largest entry 1, with M_i u <= (1 + ε) rate u for all i; None where none comes up.

    Half of each step is the old vector, so that entries do not take turns.
    """
    u = np.ones(matrices.shape[1])
    for _ in range(_SWEEPS):
        if not effort.allows(0):
            return None
        image = (matrices @ u).max(axis=0)
        if (image <= u * rate * (1 + _NEAR)).all():
            return u
        u = u + image / rate
        u /= u.max()
        if u.min() < _NEAR:
            return None
    return None


def _rounded(matrices: list[fmpq_mat], floats: Array, u: Array, sigma: Fraction) -> Iterator[tuple[Fraction, ...]]:
    """Positive vectors that the floats may stand for: short fractions, and solutions of B u = σ u.

    B has in each coordinate the row, of one of the matrices, that makes it largest.
    """
    for most in _DENOMINATORS:
        yield tuple(Fraction(x).limit_denominator(most) for x in (u / u[0]).tolist())
    letters = (floats @ u).argmax(axis=0).tolist()
    rows = fmpq_mat([matrices[letter].tolist()[k] for k, letter in enumerate(letters)])
    kernel = eigenvectors(rows, sigma)
    if not kernel:
        return
    places = [next(j for j, x in enumerate(v) if x and not any(w[j] for w in kernel if w is not v)) for v in kernel]
    shares = [
        Fraction(u[j] / u[places[0]]).limit_denominator(1 << 20) / v[j] for j, v in zip(places, kernel, strict=True)
    ]
    yield tuple(
        sum((c * x for c, x in zip(shares, entries, strict=True)), Fraction(0)) for entries in zip(*kernel, strict=True)
    )


def _is_common(matrices: list[fmpq_mat], u: tuple[Fraction, ...], sigma: Fraction) -> bool:
    """Whether u > 0 and M u <= σ u for all matrices, exactly."""
    if min(u) <= 0:
        return False
    column = matrix([[x] for x in u])
    return all(x <= to_fmpq(sigma * y) for m in matrices for x, y in zip((m * column).entries(), u, strict=True))


def _attained(
    family: Family, word: tuple[int, ...], sigma: Fraction, u: tuple[Fraction, ...], left: bool
) -> LowerBound | None:
    """The proof that the word's product has the eigenvalue σ^ℓ, by a vector; None where it has not."""
    product, bound = family.product(word), sigma ** len(word)
    turned = product.transpose() if left else product
    images = [to_fraction(x) for x in (turned * matrix([[x] for x in u])).entries()]
    if images != [bound * x for x in u]:
        if not (vectors := eigenvectors(turned, bound)):
            return None
        u = vectors[0]
    return {"word": word, "bound": bound, "sign": 1, "left": left, "vector": u}


def growing_bound(family: Family, word: tuple[int, ...]) -> LowerBound | None:
    """A lower bound of the radius by a product Π of matrices that are not negative: Π v >= x v for a rounded v >= 0.

    v is about its leading eigenvector; None where that has the eigenvalue 0.
    """
    floats = family.floats[list(word)]
    v = np.ones(family.order)
    for _ in range(_SWEEPS):
        image = v
        for m in floats:
            image = m @ image
        if not image.max() > 0:
            return None
        v = v / v.max() + image / image.max()
    rounded = [Fraction(round(x * (1 << _ROUNDED)), 1 << _ROUNDED) for x in (v / v.max()).tolist()]
    images = [to_fraction(x) for x in (family.product(word) * matrix([[x] for x in rounded])).entries()]
    bound = min(y / x for x, y in zip(rounded, images, strict=True) if x)
    digits = Fraction(1, 10**20)
    bound = bound if bound < digits else bound // digits * digits
    return {"word": word, "bound": bound, "sign": 1, "left": False, "vector": tuple(rounded)} if bound else None
