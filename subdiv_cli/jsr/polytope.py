"""The invariant polytope algorithm, in floats: grow a balanced polytope until the scaled matrices map it into itself.

Guglielmi, Wirth & Zennaro 2005; Guglielmi & Protasov 2013, also for the monotone polytopes of matrices that are not
negative. Start from leading eigenvectors of products that attain the
candidate σ, together with their images along the way; images that lie outside become vertices, the farthest first.
Where no image is left outside, JSR <= σ. In a symmetric family every vertex stands for its reflection too, and only the
images of one of the two are looked at.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from subdiv_cli.jsr.arrays import Numbers
from subdiv_cli.jsr.body import Image, Polytope
from subdiv_cli.jsr.dominance import Dominations
from subdiv_cli.jsr.gauge import PRECISION, Gauges
from subdiv_cli.jsr.measure import Balanced, Monotone, measure_of
from subdiv_cli.model import ClockStruckError, Effort, Look, no_clock, watch

ROUGHLY = 1.02
"""Gauges up to which images may stay outside of bodies that only suggest something: they end sooner."""
_SHARE = 0.2
"""The share of the images outside that become vertices before the others are measured again."""
_CHUNK = 256
_INSIDE = 1 - 1e-3
"""A gauge below this needs no more precision: its weights are proof enough."""
_SAME = 1e-12
_SMALL = 1 / 16
_INDEPENDENT = 1e-3
"""The share of a vector that must be new for it to count as independent of others.

A body that is thin has proofs of no use.
"""
_SMALL_ORDER = 20
_HALVINGS = 6


class Grown(NamedTuple):
    """A polytope after growth, with its state: closed or not, and the images left."""

    body: Polytope
    closed: bool
    """Whether no image lies outside, as floats see it."""
    left: list[tuple[int, int]]
    """The images that are not decided, because the effort ended."""
    spent: int
    """The work that growth took, counted in gauges."""
    states: tuple[Grown, ...] = ()
    """The body at the beginning, and after a 64th, …, a quarter, a half and all of the work.

    Where growth ends without closing, bounds are taken from them: twice the effort has the same ones, and more.
    """

    @property
    def value(self) -> float:
        """The largest gauge of an image: the radius is at most σ times it, where none is left."""
        return max((image.value for image in self.body.images.values()), default=0.0)


def grow(body: Polytope, effort: Effort, within: float = 1.0) -> Grown:
    """The body after growth, closed or at the end of the effort; images of gauges up to `within` >= 1 may stay outside.

    Work is counted in gauges, those in large bodies many times, as they take.
    """
    (_cover if body.monotone else _span)(body)
    return _grow(body, body.pending(range(body.size)), effort, within)


def grow_on(grown: Grown, effort: Effort) -> Grown:
    """The body of `grown`, not closed so far, after more growth; it is changed."""
    return _grow(grown.body, grown.left, effort)


def push_out(body: Polytope, images: Iterable[tuple[int, int]], by: float, effort: Effort) -> Grown:
    """A copy of a closed body in which these images are inner points, after more growth.

    It has a vertex a little beyond each of them. The images of such a vertex are those of an inner point nearly, so
    that growth ends soon where it ends.
    """
    images, body = list(images), body.copy()
    extras = [body.add_extra(np.real(body.image(*pair)) * (1 + by)) for pair in images]
    return _grow(body, [*images, *body.pending(extras)], effort)


def _grow(body: Polytope, pending: list[tuple[int, int]], effort: Effort, within: float = 1.0) -> Grown:
    spent, states = 0, list[Grown]()
    due = deque([0, *(effort.work >> i for i in range(_HALVINGS, -1, -1))])
    with np.errstate(all="ignore"):  # a gauge that overflows is a large one
        memory = measure_of(body, effort.look)
        while pending:
            fresh: list[int] = []
            for start in range(0, len(pending), _CHUNK):
                chunk = pending[start : start + _CHUNK]
                spent += len(chunk) * (1 + body.columns.size * max(body.order, _SMALL_ORDER) // (2000 * _SMALL_ORDER))
                watch.count(body.size, "vertices")
                if due and due[0] < spent:
                    states.append(Grown(body.copy(), False, pending[start:] + body.pending(fresh), spent))
                    while due and due[0] < spent:
                        due.popleft()
                if not effort.allows(spent) or not np.isfinite(body.columns).all():
                    return _stopped(body, pending[start:] + body.pending(fresh), spent, states, effort)
                try:
                    fresh += _absorb(body, memory, chunk, within)
                except ClockStruckError:
                    left = [pair for pair in body.pending(range(body.size)) if pair not in body.images]
                    return _stopped(body, left, spent, states, effort)
            pending = body.pending(fresh)
    return Grown(body, True, [], spent, tuple(states))


def _stopped(body: Polytope, left: list[tuple[int, int]], spent: int, states: list[Grown], effort: Effort) -> Grown:
    """The body where growth stops: one more of the states, if it is the clock that stops it."""
    if spent <= effort.work:
        states = [*states, Grown(body, False, left, spent)]
    return Grown(body, False, left, spent, tuple(states))


def _span(body: Polytope) -> None:
    """Add images as vertices until there are N independent columns; where images do not suffice, small unit vectors."""
    frame: list[Numbers] = []

    def is_new(vector: Numbers) -> bool:
        rest = vector / (np.linalg.norm(vector) or 1.0)
        for _ in range(2):
            for direction in frame:
                rest = rest - np.vdot(direction, rest) * direction
        if (length := float(np.linalg.norm(rest))) <= _INDEPENDENT:
            return False
        frame.append(rest / length)
        return True

    for column in body.columns.T.copy():
        is_new(column)
    queue = list(range(body.size))
    while queue and len(frame) < body.order:
        u = queue.pop(0)
        for letter in range(len(body.scaled)):
            image = body.image(u, letter)
            new = [v for v in body.copied(image) if is_new(v)]
            if new and (u, letter) not in body.returns:
                queue.append(body.child(u, letter))
    for unit in np.eye(body.order):
        if len(frame) < body.order and [v for v in body.copied(unit) if is_new(v)]:
            body.add_extra(unit * _SMALL)


def _cover(body: Polytope) -> None:
    """Add images as vertices until every coordinate is positive somewhere; then the monotone hull is full-dimensional.

    Where images do not suffice, small unit vectors.
    """

    def missing(vector: Numbers) -> bool:
        covered = body.columns.max(axis=1) > _INDEPENDENT
        return any(bool(((v > _INDEPENDENT) & ~covered).any()) for v in body.copied(vector))

    queue = list(range(body.size))
    while queue:
        u = queue.pop(0)
        for letter in range(len(body.scaled)):
            if (u, letter) not in body.returns and missing(body.image(u, letter)):
                queue.append(body.child(u, letter))
    for unit in np.eye(body.order):
        if missing(unit):
            body.add_extra(unit * _SMALL)


def _absorb(body: Polytope, memory: Balanced | Monotone, pairs: list[tuple[int, int]], within: float) -> list[int]:
    """The numbers of the new vertices: images inside are recorded with weights, others become vertices.

    The farthest come first.
    """
    pairs = _coincidences(body, pairs)
    if not pairs:
        return []
    fresh: list[int] = []
    targets = np.array([body.image(*pair) for pair in pairs])
    measures = None
    while pairs:
        measures = memory.measure(targets, measures, inside=within * _INSIDE, outside=within + 10 * PRECISION)
        outside = measures.value > within + PRECISION
        for k in np.flatnonzero(~outside):
            _record(body, pairs[k], measures, int(k))
        order = np.flatnonzero(outside)[np.argsort(-measures.value[outside], kind="stable")]
        chosen, others = np.split(order, [max(1, int(_SHARE * len(order)))] if len(order) else [0])
        fresh += [body.add(targets[k], pairs[k]) for k in chosen]
        pairs, targets, measures = [pairs[k] for k in others], targets[others], measures.chosen(others)
    return fresh


def _coincidences(body: Polytope, pairs: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """The images that are no vertices up to sign; those that are vertices are recorded."""
    targets = np.array([body.image(*pair) for pair in pairs])
    rest = []
    for pair, target in zip(pairs, targets, strict=True):
        scale = _SAME * (float(np.abs(target).max()) or 1.0)
        for sign in (1.0, -1.0):
            near = np.flatnonzero(np.abs(body.columns - sign * target[:, None]).max(axis=0) <= scale)
            if len(near) and target.any():
                body.images[pair] = Image(*pair, (int(near[0]),), (sign,), 1.0)
                break
        else:
            rest.append(pair)
    return rest


def _record(body: Polytope, pair: tuple[int, int], measures: Gauges | Dominations, k: int) -> None:
    columns, weights = measures.shares(k)
    body.images[pair] = Image(*pair, columns, weights, float(measures.value[k]))


def measured(grown: Grown, look: Look = no_clock) -> Grown:
    """The same polytope with gauges of the images left too, for the bound that it proves as it is.

    Raises what `look` raises.
    """
    body = grown.body
    with np.errstate(all="ignore"):
        memory = measure_of(body, look)
        for start in range(0, len(grown.left), _CHUNK):
            chunk = grown.left[start : start + _CHUNK]
            targets = np.array([body.image(*pair) for pair in chunk])
            measures = memory.measure(targets)
            for k, pair in enumerate(chunk):
                _record(body, pair, measures, k)
    return grown._replace(left=[])
