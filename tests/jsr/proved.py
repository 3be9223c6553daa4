"""Joint spectral radii as these tests ask for them: each with a certificate that the independent checker verifies.

And what floats know of them independently: products by brute force.
"""

from __future__ import annotations

import itertools
import json
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from subdiv_cli.checker import check_text
from subdiv_cli.model import DEFAULT_EFFORT, Effort
from subdiv_cli.pipeline import joint_spectral_radius


class Proved(NamedTuple):
    """What is known of a radius ρ; the bounds are doubles that follow from the verified goal, None beyond them."""

    lower: float
    upper: float
    root: tuple[int, tuple[int, ...]] | None
    """(n, coefficients of m) where ρ^n is proved to be a certain root of m."""
    words: tuple[tuple[int, ...], ...]
    bounded: bool
    rules: list[str]


def exactly(matrices):
    return [[[Fraction(x) for x in row] for row in rows] for rows in matrices]


def proved(matrices, work=DEFAULT_EFFORT):
    """The radius of a family; fails unless the checker verifies a certificate of this family that says all of it."""
    matrices = exactly(matrices)
    found = joint_spectral_radius(matrices, Effort(work))
    radius, text = found.radius, found.certificate_text()
    assert text is not None
    assert check_text(text).verified
    document = json.loads(text)
    assert exactly(document["mask"]["matrices"]) == matrices
    goal = {statement["property"]: statement for statement in document["goal"]}
    assert all(statement["family"] == 0 for statement in goal.values())
    lower, upper = (x if x is None else Fraction(x) for x in (radius.lower, radius.upper))
    said = goal.get("bounded", goal.get("radius"))
    if said is None:
        bound = goal["radius-upper"]
        assert upper ** bound["length"] >= Fraction(bound["bound"])
        assert lower == 0 or lower ** goal["radius-lower"]["length"] <= Fraction(goal["radius-lower"]["bound"])
        assert radius.exact == ("0" if upper == 0 else None)
    else:
        assert radius.exact is not None or max(map(len, said["polynomial"])) > 70
        assert _encloses(lower, upper, said)
    root = None if said is None else (said["length"], tuple(map(int, said["polynomial"])))
    rules = [claim["rule"] for claim in document["claims"]]
    bounded = "bounded" in goal or rules == ["zero"]
    assert radius.bounded == bounded
    return Proved(radius.lower, radius.upper, root, radius.words, bounded, rules)


def _encloses(lower, upper, said):
    """Whether the root that a verified statement names, to the power 1/n, lies in [lower, upper]: by signs."""
    n, m = said["length"], [int(c) for c in said["polynomial"]]
    low, high = Fraction(said["low"]), Fraction(said["high"])
    left, right = max(lower**n, low), high if upper is None else min(upper**n, high)
    return left <= right and at(m, left) * at(m, right) <= 0


def at(polynomial, x):
    return sum(c * x**k for k, c in enumerate(polynomial))


class Products(NamedTuple):
    """What products of up to some length say of ρ in floats, with roundings taken into account."""

    lower: float
    upper: float


def products(matrices, most=2000):
    """From the products of all lengths L with p^L <= most: max ρ(Π)^(1/L) <= ρ <= max ‖Π‖^(1/L) for three norms.

    An eigenvalue is off by κ(V) ε ‖Π‖ at most, V the eigenvectors (Bauer & Fike), or by what a defective one is.
    """
    family = np.array([[[float(x) for x in row] for row in rows] for rows in matrices])
    letters, order = len(family), family.shape[1]
    total, length, lower, upper = family, 1, 0.0, np.inf
    while True:
        for norm in (1, 2, np.inf):
            upper = min(upper, float(np.linalg.norm(total, ord=norm, axis=(1, 2)).max()) ** (1 / length))
        lower = max(lower, float(certain_radii(total).max()) ** (1 / length))
        if len(total) * letters > most or length > 12:
            return Products(lower * (1 - 1e-12), upper * (1 + 1e-12))
        total = (family[:, None] @ total[None]).reshape(-1, order, order)
        length += 1


def certain_radii(matrices):
    """Lower bounds of the spectral radii."""
    sizes = np.abs(matrices).max(axis=(1, 2))
    values, vectors = np.linalg.eig(matrices / np.where(sizes, sizes, 1)[:, None, None])
    off = np.fmin(1e-13 * np.linalg.cond(vectors), 1e-4) * matrices.shape[1]
    return np.fmax(0, np.abs(values).max(axis=1) - off) * sizes


def product_radius(matrices, word):
    """ρ(Π)^(1/ℓ) in floats."""
    total = np.eye(len(matrices[0]))
    for letter in word:
        total = np.array([[float(Fraction(x)) for x in row] for row in matrices[letter]]) @ total
    return float(np.abs(np.linalg.eigvals(total)).max()) ** (1 / len(word))


def times(a, b):
    return [
        [sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0)) for column in zip(*b, strict=True)]
        for row in a
    ]


def transposed(a):
    return [list(row) for row in zip(*a, strict=True)]


def inverse(a):
    """By Gauss and Jordan, over Fractions."""
    n = len(a)
    rows = [[Fraction(x) for x in row] + [Fraction(int(i == j)) for j in range(n)] for i, row in enumerate(a)]
    for k in range(n):
        pivot = next(i for i in range(k, n) if rows[i][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k], strict=True)]
    return [row[n:] for row in rows]


def similar(matrices, p):
    """P^-1 M P."""
    return [times(inverse(p), times(exactly([m])[0], exactly([p])[0])) for m in matrices]


def block_diagonal(*families):
    """One matrix of each family, along the diagonal; families of equally many matrices."""
    result = []
    for blocks in zip(*map(exactly, families), strict=True):
        n, at_row, rows = sum(map(len, blocks)), 0, []
        for block in blocks:
            rows += [[Fraction(0)] * at_row + row + [Fraction(0)] * (n - at_row - len(block)) for row in block]
            at_row += len(block)
        result.append(rows)
    return result


def kronecker(a, b):
    return [[x * y for x in row for y in other] for row in a for other in b]


def words(matrices, length):
    """All products of this many matrices."""
    result = []
    for word in itertools.product(exactly(matrices), repeat=length):
        total = word[0]
        for m in word[1:]:
            total = times(m, total)
        result.append(total)
    return result
