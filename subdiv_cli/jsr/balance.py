"""Leaders scaled so that none lies inside what grows from another one (Guglielmi & Protasov 2013, section 3).

The hull that grows from leader j reaches c_ij times leader i: scaled by t, all leaders stay outside where c_ij t_j is
less than t_i, and the smaller it is the fewer steps bring an image inside. Floats, and a suggestion only.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import reduce

import numpy as np

from subdiv_cli.jsr.arrays import Array
from subdiv_cli.jsr.body import Polytope, Start
from subdiv_cli.jsr.measure import gauge
from subdiv_cli.jsr.polytope import ROUGHLY, grow
from subdiv_cli.model import Effort

_WORK = 200
"""Gauges that are computed in the body that grows from one leader."""
_SWEEPS = 64
_SMALLEST = 1e-3


def scales(starts: Sequence[Start], body_of: Callable[[Start], Polytope], effort: Effort) -> list[Fraction]:
    """A list of positive factors, one for every leader, 1 for the first one."""
    grown = [grow(body_of(start), effort.limited(_WORK), ROUGHLY).body for start in starts]
    functionals = [_functional(start, body) for start, body in zip(starts, grown, strict=True)]
    reach = np.array(
        [
            [_reach(start, functional, body) for body in grown]
            for start, functional in zip(starts, functionals, strict=True)
        ]
    )
    if not np.isfinite(reach).all():
        return [Fraction(1)] * len(starts)
    balanced = _balanced(np.log(np.maximum(reach, _SMALLEST)))
    return [Fraction(max(1, round(64 * x)), 64) for x in np.exp(balanced - balanced[0]).tolist()]


def _reach(start: Start, functional: Array | None, body: Polytope) -> float:
    """The largest factor by which a body reaches in the direction of a leader.

    With f the functional of its product, f(v) = 1, Π^n x / μ^n tends to f(x) v where the eigenvalue is simple: it is
    |f(x)|. Otherwise, what multiple of the leader is in the body.
    """
    if functional is not None:
        return float(np.abs(functional @ body.columns).max())
    value = gauge(body, start.vector)
    return 1 / value if value else 0.0


def _functional(start: Start, body: Polytope) -> Array | None:
    """The left eigenvector of the leader's product, a row of N entries with the value 1 at the leader.

    None where the eigenvalue is not simple or not real, or where the product is the reversal times that of the word.
    """
    if body.complex or not start.word:
        return None
    product = reduce(np.matmul, (body.scaled[letter] for letter in reversed(start.word)))
    if not np.isfinite(product).all():
        return None
    image, scale = product @ start.vector, _SMALLEST * float(np.linalg.norm(start.vector))
    if min(np.linalg.norm(image - start.vector), np.linalg.norm(image + start.vector)) > scale:
        return None
    values, vectors = np.linalg.eig(product.T)
    near = np.flatnonzero(np.abs(np.abs(values) - 1) < _SMALLEST)
    if len(near) != 1:
        return None
    functional = vectors[:, near[0]].real
    size = float(functional @ start.vector)
    return functional / size if abs(size) > scale else None


def _balanced(logarithms: Array) -> Array:
    """The n logarithms of t with max_j c_ij t_j / t_i = max_j c_ji t_i / t_j for all i, j ≠ i, from those of c.

    By sweeps over the n×n matrix (Schneider & Schneider 1991): no other t makes the largest of all smaller.
    """
    n = len(logarithms)
    t = np.zeros(n)
    for _ in range(_SWEEPS):
        for i in range(n):
            others = [j for j in range(n) if j != i]
            t[i] = (max(logarithms[i, j] + t[j] for j in others) + min(t[j] - logarithms[j, i] for j in others)) / 2
    return t
