"""The invariant polytope algorithm, in floats: grow a balanced polytope until the scaled matrices map it into itself.

Guglielmi, Wirth & Zennaro 2005; Guglielmi & Protasov 2013. Start from leading eigenvectors of products that attain the
candidate σ, together with their images along the way; images that lie outside become vertices, the farthest first.
Where no image is left outside, JSR <= σ. In a symmetric family every vertex stands for its reflection too, and only the
images of one of the two are looked at.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from subdiv_cli.jsr.arrays import Array, Numbers, as_real
from subdiv_cli.jsr.family import Word
from subdiv_cli.jsr.gauge import PRECISION, Bases, Gauges, gauges, inverses_of
from subdiv_cli.model import Effort

_INSIDE = 1 - 1e-3
"""A gauge below this needs no more precision: its weights are proof enough."""
_SHARE = 0.2
"""Of the images outside, how many become vertices before the others are measured again."""
_REMEMBERED = 48
"""Bases that are tried as a start for new targets."""
_CHUNK = 256
_SAME = 1e-12
_SMALL = 1 / 16
EXTRA_BITS = 30
_INDEPENDENT = 1e-8


class Start(NamedTuple):
    """A word of length ℓ and an eigenvector of its product, or of J times it, of an eigenvalue of modulus σ^ℓ.

    The word () is for a vector that nothing is known of.
    """

    word: Word
    vector: Numbers


class Image(NamedTuple):
    """M_letter v / σ, v the vertex: ≈ Σ weights · columns."""

    vertex: int
    letter: int
    columns: tuple[int, ...]
    weights: tuple[complex, ...]
    value: float
    """Σ |weights|."""


class Body:
    """The polytope so far. Each vertex v stands for `copies` columns: v; its conjugate, where vectors are complex; and

    in a symmetric family the reflections of these. Column u·copies + c is copy c of vertex u.
    """

    def __init__(self, matrices: Array, sigma: float, *, symmetric: bool, starts: Sequence[Start]) -> None:
        self.scaled = matrices / sigma
        self.order = matrices.shape[1]
        self.symmetric = symmetric
        self.complex = np.iscomplexobj(starts[0].vector)
        self.copies = (2 if symmetric else 1) * (2 if self.complex else 1)
        self.parents: list[tuple[int, int] | None] = []
        """(vertex, letter) of which a vertex is the image; None for a leader; (-1, e) for extra vertex e."""
        self.extras: list[tuple[int, ...]] = []
        """Vertices that make the body a little larger, times 2^EXTRA_BITS."""
        self.depths: list[int] = []
        """The number of letters between a vertex and its leader."""
        self._columns: Numbers = np.zeros((self.order, 64), dtype=starts[0].vector.dtype)
        self.returns: set[tuple[int, int]] = set()
        self.images: dict[tuple[int, int], Image] = {}
        for start in starts:
            self.add(start.vector, None)
        for number, start in enumerate(starts):
            u = number
            for letter in start.word[:-1]:
                u = self.child(u, letter)
            if start.word:
                self.returns.add((u, start.word[-1]))

    @property
    def size(self) -> int:
        """The number of vertices, reflections not counted."""
        return len(self.parents)

    @property
    def columns(self) -> Numbers:
        return self._columns[:, : self.size * self.copies]

    def image(self, u: int, letter: int) -> Numbers:
        return np.asarray(self.scaled[letter] @ self._columns[:, u * self.copies])

    def copied(self, vector: Numbers) -> list[Numbers]:
        copies = [vector, vector.conj()] if self.complex else [vector]
        return copies + [v[::-1] for v in copies] if self.symmetric else copies

    def gauge(self, vector: Numbers) -> float:
        """Of any vector; the columns must span."""
        target = vector[None]
        found = gauges(self.columns, target, _Memory(self).best(self.columns, target), inside=0.0, outside=float("inf"))
        return float(found.value[0])

    def child(self, u: int, letter: int) -> int:
        """The vertex that is the image of u under a letter, made where it is missing."""
        if (u, letter) in self.parents:
            return self.parents.index((u, letter))
        return self.add(self.image(u, letter), (u, letter))

    def target(self, u: int, letter: int) -> tuple[int, float]:
        """The vertex (numbered as in certificates) and the sign that an edge or a return leads to."""
        if (u, letter) in self.parents:
            return self.parents.index((u, letter)), 1.0
        image, n = self.image(u, letter), self.size
        leaders = [(k + c * n, self.columns[:, k * self.copies + c]) for k in range(n) for c in range(self.copies)]
        sign_of = [
            (number, sign) for number, v in leaders for sign in (1.0, -1.0) if np.allclose(image, sign * v, atol=_SAME)
        ]
        return sign_of[0]

    def add(self, vector: Numbers, parent: tuple[int, int] | None) -> int:
        at = self.size * self.copies
        if at + self.copies > self._columns.shape[1]:
            self._columns = np.hstack([self._columns, np.zeros_like(self._columns)])
        self._columns[:, at : at + self.copies] = np.array(self.copied(vector)).T
        self.parents.append(parent)
        self.depths.append(0 if parent is None or parent[0] < 0 else self.depths[parent[0]] + 1)
        return self.size - 1

    def add_extra(self, vector: Array) -> int:
        """A vertex of no origin, rounded to multiples of 2^-EXTRA_BITS."""
        integers = [round(x * (1 << EXTRA_BITS)) for x in vector.tolist()]
        self.extras.append(tuple(integers))
        return self.add(np.array(integers) / (1 << EXTRA_BITS), (-1, len(self.extras) - 1))

    def descends_from_extra(self, u: int) -> bool:
        while (parent := self.parents[u]) is not None:
            if parent[0] < 0:
                return True
            u = parent[0]
        return False

    def pending(self, vertices: Iterable[int]) -> list[tuple[int, int]]:
        """The images of these vertices that are neither vertices by construction nor returns to a leader."""
        edges = {parent for parent in self.parents if parent is not None} | self.returns
        pairs = ((u, letter) for u in vertices for letter in range(len(self.scaled)))
        return [pair for pair in pairs if pair not in edges]


class Grown(NamedTuple):
    """A polytope after growth."""

    body: Body
    closed: bool
    """No image lies outside, as floats see it."""
    value: float
    """The largest gauge of an image: the radius is at most σ times it."""


def grow(body: Body, effort: Effort) -> Grown:
    """Let a body grow until it is closed or the effort ends.

    Work is counted in gauges, those in large bodies several times.
    """
    _span(body)
    return _grow(body, body.pending(range(body.size)), effort)


def push_out(body: Body, images: Iterable[tuple[int, int]], by: float, effort: Effort) -> Grown:
    """Make images on the boundary of a closed body inner ones, in a copy: a vertex a little beyond each, and grow on.

    The images of such a vertex are those of an inner point nearly, so that growth ends soon where it ends.
    """
    images, body = list(images), copy.deepcopy(body)
    extras = [body.add_extra(np.real(body.image(*pair)) * (1 + by)) for pair in images]
    return _grow(body, [*images, *body.pending(extras)], effort)


def _grow(body: Body, pending: list[tuple[int, int]], effort: Effort) -> Grown:
    memory, spent = _Memory(body), 0
    with np.errstate(all="ignore"):  # a gauge that overflows is a large one
        while pending:
            fresh: list[int] = []
            for start in range(0, len(pending), _CHUNK):
                chunk = pending[start : start + _CHUNK]
                spent += len(chunk) * (1 + body.columns.size // 2000)
                if not effort.allows(spent):
                    return _unfinished(body, memory, pending[start:] + body.pending(fresh))
                fresh += _absorb(body, memory, chunk)
            pending = body.pending(fresh)
    return Grown(body, True, max((image.value for image in body.images.values()), default=0.0))


def _span(body: Body) -> None:
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


class _Memory:
    """Bases that were good for earlier targets."""

    def __init__(self, body: Body) -> None:
        first = np.array([independent_columns(body.columns)])
        turns = np.ones(first.shape, dtype=body.columns.dtype)
        if body.complex:
            first, turns = np.hstack([first, first]), np.hstack([turns, 1j * turns])
        self.bases = Bases(first, turns)

    def best(self, columns: Numbers, targets: Numbers) -> Bases:
        """For each target the remembered basis in which it has the smallest weights."""
        inverses = inverses_of(self.bases.vectors(columns))
        sums = np.abs(np.einsum("kij,mj->mki", inverses, as_real(targets))).sum(axis=2)
        return self.bases.chosen(sums.argmin(axis=1))

    def remember(self, bases: Bases) -> None:
        kept = len(self.bases.numbers)
        oldest = [0, *range(max(1, kept + 8 - _REMEMBERED), kept)]
        pairs = zip(
            self.bases.chosen(np.array(oldest)), bases.chosen(np.arange(min(8, len(bases.numbers)))), strict=True
        )
        self.bases = Bases(*(np.concatenate(pair) for pair in pairs))


def independent_columns(columns: Numbers) -> list[int]:
    """As many independent columns as there are rows, each as far as possible from the span of those before it.

    Real or complex; the rows must be independent.
    """
    rest, chosen = columns.copy(), []
    for _ in range(len(columns)):
        lengths = np.linalg.norm(rest, axis=0)
        j = int(lengths.argmax())
        chosen.append(j)
        direction = rest[:, j] / lengths[j]
        rest = rest - np.outer(direction, direction.conj() @ rest)
    return chosen


def _absorb(body: Body, memory: _Memory, pairs: list[tuple[int, int]]) -> list[int]:
    """Decide images: those inside are recorded with weights, those outside become vertices, the farthest first."""
    pairs = _coincidences(body, pairs)
    if not pairs:
        return []
    fresh: list[int] = []
    targets = np.array([body.image(*pair) for pair in pairs])
    bases = memory.best(body.columns, targets)
    while pairs:
        found = gauges(body.columns, targets, bases, inside=_INSIDE, outside=1 + 10 * PRECISION)
        memory.remember(found.bases)
        outside = found.value > 1 + PRECISION
        for k in np.flatnonzero(~outside):
            _record(body, pairs[k], found, int(k))
        order = np.flatnonzero(outside)[np.argsort(-found.value[outside], kind="stable")]
        chosen, others = np.split(order, [max(1, int(_SHARE * len(order)))] if len(order) else [0])
        fresh += [body.add(targets[k], pairs[k]) for k in chosen]
        pairs, targets, bases = [pairs[k] for k in others], targets[others], found.bases.chosen(others)
    return fresh


def _coincidences(body: Body, pairs: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Record the images that are vertices up to sign; the others are returned."""
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


def _record(body: Body, pair: tuple[int, int], found: Gauges, k: int) -> None:
    columns, weights = found.bases.numbers[k].tolist(), (found.weights[k] * found.bases.turns[k]).tolist()
    body.images[pair] = Image(*pair, tuple(columns), tuple(weights), float(found.value[k]))


def _unfinished(body: Body, memory: _Memory, pairs: list[tuple[int, int]]) -> Grown:
    """The effort ended: measure what is left, for the bound that the body proves as it is."""
    for start in range(0, len(pairs), _CHUNK):
        chunk = pairs[start : start + _CHUNK]
        targets = np.array([body.image(*pair) for pair in chunk])
        bases = memory.best(body.columns, targets)
        found = gauges(body.columns, targets, bases, inside=_INSIDE, outside=float("inf"))
        for k, pair in enumerate(chunk):
            _record(body, pair, found, k)
    return Grown(body, False, max((image.value for image in body.images.values()), default=0.0))
