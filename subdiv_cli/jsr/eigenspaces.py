"""Leaders in an eigenspace of several dimensions: so many, and so far out, that what comes back to it stays inside.

Let E be the eigenspace of the leading eigenvalue μ of a product Π, Q the projection on E along the other eigenspaces.
Π^n v/μ^n tends to Q v. Where that is not an inner point of the hull of the leaders in E, the images of v do not come to
lie inside, and the polytope does not close. As many leaders as dimensions are hardly ever enough (Guglielmi & Protasov
2013 assume one dimension). So a hull in each E is sought that all ways from such spaces to such spaces map into the
inner parts of each other, which there is where these contract in some norm; its corners are the leaders. Floats, and a
suggestion only.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from flint import ctx

from subdiv_cli.exact.enclosures import ball
from subdiv_cli.jsr.arrays import Array
from subdiv_cli.jsr.body import Polytope, Start
from subdiv_cli.jsr.family import Candidate, Family
from subdiv_cli.jsr.gauge import Bases, gauges
from subdiv_cli.jsr.leaders import MOST_LEADERS, Ball, Leader, Leaders, eigenvectors
from subdiv_cli.jsr.measure import independent_columns
from subdiv_cli.jsr.polytope import ROUGHLY, grow
from subdiv_cli.model import Effort

_WORK = 1000
"""Gauges that are computed in the body whose tree has the ways that are used."""
_MARGINS = (1 / 10, 1 / 40)
"""The margins by which images that come back are to stay inside.

The smaller one is for hulls that grow on and on with the larger one.
"""
_SPENT = 3 / 4
"""The share of the margin that is given up for fewer leaders."""
_ROUNDS = 6
"""The most bodies that grow one after another."""
_STEPS = 40
_TARGETS = 100_000
"""The most points whose gauges are computed, all in all."""
_MOST = 64
"""The most corners of a hull."""
_BITS = 19
"""The bits of the numbers by which columns are combined to a leader."""
_FAR = 1000
"""A hull that is so many times as large as at first grows on and on."""
_SAME = 1e-9
_ROUNDING = 1e-6
"""The rounding error of gauges in hulls that may be flat."""


def surrounding(
    family: Family, leading: Leaders, body_of: Callable[[Sequence[Start]], Polytope], effort: Effort
) -> Leaders | None:
    """More leaders where an eigenspace has several dimensions; None where none has, or where no hulls are reached."""
    groups: dict[Candidate, list[Leader]] = {}
    for leader in leading.each:
        groups.setdefault(leader.candidate, []).append(leader)
    several = any(len(group) > 1 for group in groups.values()) and len(leading.each) < MOST_LEADERS
    if not several or not leading.is_real or leading.has_both_signs:
        return None
    with ctx.workprec(256):
        if any(_slope(group[0]).contains(0) for group in groups.values()):  # a Jordan block: norms grow
            return None
    for margin in _MARGINS:
        spaces = [_Eigenspace(family, group) for group in groups.values()]
        with np.errstate(all="ignore"):
            if _surround(spaces, body_of, margin, effort):
                return leading._replace(each=tuple(x for space in spaces for x in space.leaders(_SPENT * margin)))
    return None


def _surround(
    spaces: Sequence[_Eigenspace], body_of: Callable[[Sequence[Start]], Polytope], margin: float, effort: Effort
) -> bool:
    """Whether hulls grow until the ways in the tree of a body that grows from them lead inside; they are changed."""
    ways: dict[tuple[object, ...], _Way] = {}
    left = _TARGETS
    for _ in range(_ROUNDS):
        starts = [start for space in spaces for start in space.starts()]
        body = grow(body_of(starts), effort.limited(_WORK), ROUGHLY).body
        ways.update((way.key, way) for way in _ways(spaces, body))
        steps, left = _widen(spaces, tuple(ways.values()), margin, left)
        if steps is None or not effort.allows(0):
            return False
        if steps == 0:
            return True
    return False


class _Eigenspace:
    """An eigenspace E in coordinates, and a hull in it."""

    def __init__(self, family: Family, group: Sequence[Leader]) -> None:
        self._group = group
        with ctx.workprec(256):
            columns, slope = eigenvectors(family, group[0]), _slope(group[0])
            projection = np.array([[float((x / slope).mid()) for x in column] for column in columns]).T
            sizes = [float((slope * ball(leader.scale)).mid()) for leader in group]
        self.frame: Array = np.linalg.svd(projection)[0][:, : len(group)]
        self.projection: Array = self.frame.T @ projection
        starts = np.array([leader.start for leader in group], dtype=np.float64)
        self._basis = self.projection @ starts.T * np.array(sizes)
        self.corners: Array = self._basis
        """The corners of the hull as columns, without their negatives and what turns make of them."""
        self.turns: list[Array] = [np.eye(len(group))]
        """Matrices of ways from E to E that are exact: with a corner its images by them are in the body."""

    def starts(self) -> list[Start]:
        return [Start(self._group[0].candidate.word, self.frame @ corner) for corner in self.corners.T]

    def hull(self) -> Array:
        """The corners and all that turns make of them, as columns."""
        return self._turned(self.corners)

    def _turned(self, points: Array) -> Array:
        return np.hstack([turn @ points for turn in self.turns])

    @property
    def is_far(self) -> bool:
        """Whether the hull has grown on and on."""
        return self.corners.shape[1] > _MOST or bool(np.abs(self.corners).max() > _FAR * np.abs(self._basis).max())

    def surround(self, points: Array) -> Array:
        """The new corners, as columns, and their images by turns, of the hull made so large that it has these points.

        The farthest point comes first.
        """
        added = np.zeros((len(points), 0))
        while points.size and not self.is_far:
            values = _gauges(self.hull(), points)
            points, values = points[:, values > 1 + _ROUNDING], values[values > 1 + _ROUNDING]
            if points.size:
                corner = points[:, [values.argmax()]]
                self.corners, added = np.hstack([self.corners, corner]), np.hstack([added, corner])
        if added.size:
            self.corners = self._without(self.corners, _ROUNDING)
        return self._turned(added)

    def _without(self, corners: Array, by: float) -> Array:
        """The corners, as columns, without those that the hull of all does without, larger by at most `by`."""
        hull, kept = self._turned(corners), list(range(corners.shape[1]))
        for k in range(corners.shape[1]):
            fewer = self._turned(corners[:, [i for i in kept if i != k]])
            if np.linalg.matrix_rank(fewer) == len(fewer) and _gauges(fewer, hull).max() <= 1 + by:
                kept.remove(k)
        return corners[:, kept]

    def leaders(self, by: float) -> list[Leader]:
        """Leaders at few corners: the hull of all corners is larger by at most `by`."""
        combined = np.linalg.solve(self._basis, self._without(self.corners, by))
        return [self._leader([Fraction(x) for x in column]) for column in combined.T.tolist()]

    def _leader(self, combined: Sequence[Fraction]) -> Leader:
        """The leader Σ c_i x_i, with rounded c_i, of the first leaders x_i."""
        parts = [c * leader.scale for c, leader in zip(combined, self._group, strict=True)]
        largest = max(map(abs, parts))
        unit = Fraction(2) ** (largest.numerator.bit_length() - largest.denominator.bit_length() + 1 - _BITS)
        start = [0] * len(self._group[0].start)
        for part, leader in zip(parts, self._group, strict=True):
            start = [x + round(part / unit) * y for x, y in zip(start, leader.start, strict=True)]
        return self._group[0]._replace(start=tuple(start), scale=unit)


def _slope(leader: Leader) -> Ball:
    """The number h(μ) = g'(μ), where h(Π) = h(μ) Q."""
    at = leader.eigenvalue.enclosure().real
    return sum((ball(k * c) * at ** (k - 1) for k, c in enumerate(leader.annihilator) if k), ball(0))


class _Way(NamedTuple):
    """A map x -> Q A x from one eigenspace to another, A the product of a word over powers of σ."""

    start: int
    end: int
    matrix: Array
    exact: bool
    """Whether Q A x = A x, so that the image itself lies in the second eigenspace."""

    @property
    def key(self) -> tuple[object, ...]:
        """A key that is equal for ways that are equal as floats see it."""
        return self.start, self.end, *np.round(self.matrix / _SAME).ravel().tolist()

    def magnifies(self, margin: float) -> bool:
        """Whether the way maps no hull into its inner part."""
        if self.start != self.end or self.exact:
            return False
        return bool(np.abs(np.linalg.eigvals(self.matrix)).max() * (1 + margin) >= 1)


def _ways(spaces: Sequence[_Eigenspace], body: Polytope) -> list[_Way]:
    """The ways by the words in the tree of a body, and in a symmetric family their reversals."""
    numbers = [k for k, space in enumerate(spaces) for _ in space.corners.T]
    images: list[tuple[int, Array] | None] = []
    ways: list[_Way | None] = []
    for u, parent in enumerate(body.parents):
        if parent is None:
            start, image = numbers[u], spaces[numbers[u]].frame
        elif (before := images[parent[0]] if parent[0] >= 0 else None) is None:  # it comes from an extra vertex
            images.append(None)
            continue
        else:
            start, image = before[0], body.scaled[parent[1]] @ before[1]
            ways += [_way(spaces, start, end, image) for end in range(len(spaces))]
        images.append((start, image))
        if body.symmetric:
            ways += [_way(spaces, start, end, image[::-1]) for end in range(len(spaces))]
    return [way for way in ways if way is not None]


def _way(spaces: Sequence[_Eigenspace], start: int, end: int, image: Array) -> _Way | None:
    """The way between two spaces that an image shows; None for a turn, which the space itself keeps."""
    space = spaces[end]
    matrix = space.projection @ image
    exact = bool(np.linalg.norm(space.frame @ matrix - image) <= _SAME * np.linalg.norm(image))
    if not exact or start != end:
        return _Way(start, end, matrix, exact)
    if all(np.linalg.norm(matrix - turn) > _SAME for turn in space.turns):
        space.turns.append(matrix)
    return None


def _widen(spaces: Sequence[_Eigenspace], ways: Sequence[_Way], margin: float, left: int) -> tuple[int | None, int]:
    """The number of steps in which hulls grow until all ways map them into each other, None where that does not end.

    The second number is how many points may still be looked at.
    """
    if any(way.magnifies(margin) for way in ways):
        return None, left
    fresh = [space.hull() for space in spaces]
    for step in range(_STEPS):
        coming = [[np.zeros((len(points), 0))] for points in fresh]
        for way in ways:
            coming[way.end].append(way.matrix @ fresh[way.start] * (1.0 if way.exact else 1 + margin))
        together = [np.hstack(points) for points in coming]
        left -= sum(points.shape[1] for points in together)
        if left < 0:
            return None, left
        fresh = [space.surround(points) for space, points in zip(spaces, together, strict=True)]
        if any(space.is_far for space in spaces):
            return None, left
        if not any(points.size for points in fresh):
            return step, left
    return None, left


def _gauges(columns: Array, targets: Array) -> Array:
    """The M gauges of the M columns of `targets` in the hull of all ±columns, which span the space."""
    numbers = np.array([independent_columns(columns)] * targets.shape[1])
    return gauges(columns, targets.T, Bases(numbers, np.ones(numbers.shape)), inside=0.0, outside=math.inf).value
