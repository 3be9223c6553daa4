"""Monotone polytopes, for matrices >= 0: all x >= 0 that are below a convex combination of vertices."""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.reading import require

_PLACES = 64


class MonotoneBody(NamedTuple):
    """P, all x with |x| <= Σ c_k v_k, c >= 0, Σ c_k <= 1, where v_k >= 0 and |vertices[k][i] - v_k[i]| <= errors[k].

    Coordinate i of some vertex b is at least floors[i] > 0: P is the unit ball of a norm, and an r >= 0 is below
    Σ_i r_i/floors[i] v_b.
    """

    vertices: list[list[int]]
    errors: list[int]
    floors: list[int]
    weight_bits: int

    def contains(self, image: Sequence[int], over: int, error: int, weights: Sequence[int]) -> bool:
        """Whether a vector >= 0 is in P that differs from image/over by at most error/over in every coordinate.

        weights is k_1, c_1, k_2, c_2, …: with r_i the positive parts of image/over - Σ (c_k/2^w) v_k, up to the errors
        of all of them, it is below Σ c_k/2^w + Σ_i r_i/floors[i] times a convex combination. All is multiplied by
        over 2^w, and each quotient rounded up.
        """
        numbers, cs, w = weights[::2], weights[1::2], self.weight_bits
        require(len(numbers) == len(cs) == len(set(numbers)), "a weight has no vertex, or a vertex has two")
        require(all(0 <= k < len(self.vertices) for k in numbers), "a weight is for a vertex that is not there")
        require(all(c > 0 for c in cs), "a weight is not positive")
        columns = zip(*[self.vertices[k] for k in numbers], strict=True) if cs else ((),) * len(image)
        error = (error << w) + over * sum(map(mul, cs, [self.errors[k] for k in numbers]))
        rest = 0
        for x, column, floor in zip(image, columns, self.floors, strict=True):
            above = (x << w) - over * sum(map(mul, cs, column)) + error
            rest += -(-(above << _PLACES) // floor) if above > 0 else 0
        return bool(rest <= ((1 << w) - sum(cs)) * over << _PLACES)


def monotone_body(
    c: Claim, vertices: list[list[int]], errors: list[int], basis: Sequence[int], weight_bits: int, bits: int
) -> MonotoneBody:
    """Of vertices that are known not to be negative; `basis` has a vertex for each coordinate, positive there."""
    order = len(vertices[0])
    require(len(basis) == order, "the basis has not as many vertices as coordinates")
    require(max(basis) < len(vertices), "the basis has a vertex that is not there")
    c.spend(order, bits)
    floors = [vertices[k][i] - errors[k] for i, k in enumerate(basis)]
    require(all(floor > 0 for floor in floors), "a coordinate of a basis vertex may be zero")
    return MonotoneBody(vertices, errors, floors, weight_bits)


def require_nonnegative(family: Family) -> None:
    """No matrix of the family has a negative entry."""
    entries = (x for matrix in family.matrices for row in matrix for x in row)
    require(all(x >= 0 for x in entries), "a matrix has a negative entry")
