"""The vertices of a polytope that grows, in floats, with what each of them comes from."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from subdiv_cli.jsr.arrays import Array, Numbers
from subdiv_cli.jsr.family import Word

_SAME = 1e-12
EXTRA_BITS = 30


class Start(NamedTuple):
    """A word of length ℓ and an eigenvector of its product, or of J times it, of an eigenvalue of modulus σ^ℓ.

    The word () is for a vector that nothing is known of.
    """

    word: Word
    vector: Numbers


class Image(NamedTuple):
    """An image M_letter v / σ of a vertex v: ≈ Σ weights · columns, or <= that in all coordinates (monotone bodies)."""

    vertex: int
    letter: int
    columns: tuple[int, ...]
    weights: tuple[complex, ...]
    value: float
    """The sum of the |weights|."""


class Polytope:
    """A polytope while it grows: its vertices, with what each of them is the image of.

    Each vertex v stands for `copies` columns: v; its conjugate, where vectors are complex; and in a symmetric family
    the reflections of these. Column u·copies + c is copy c of vertex u.
    """

    def __init__(
        self, matrices: Array, sigma: float, *, symmetric: bool, starts: Sequence[Start], monotone: bool = False
    ) -> None:
        self.scaled = matrices / sigma
        self.monotone = monotone
        """Whether the hull is of all x >= 0 below a convex combination of vertices; nothing is negative then."""
        self.order = matrices.shape[1]
        self.symmetric = symmetric
        self.complex = np.iscomplexobj(starts[0].vector)
        self.copies = (2 if symmetric else 1) * (2 if self.complex else 1)
        self.parents: list[tuple[int, int] | None] = []
        """The (vertex, letter) of which a vertex is the image; None for a leader; (-1, e) for extra vertex e."""
        self.extras: list[tuple[int, ...]] = []
        """The vertices that make the body a little larger, times 2^EXTRA_BITS."""
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

    def copy(self) -> Polytope:
        """A copy that does not change with this body."""
        other = copy.copy(self)
        other.parents, other.extras, other.depths = self.parents[:], self.extras[:], self.depths[:]
        other.returns, other.images, other._columns = set(self.returns), dict(self.images), self._columns.copy()
        return other

    @property
    def size(self) -> int:
        """The number of vertices, reflections not counted."""
        return len(self.parents)

    @property
    def columns(self) -> Numbers:
        """The N×(size·copies) matrix of all vertices and their copies, as columns."""
        return self._columns[:, : self.size * self.copies]

    def numbers(self, columns: Iterable[int]) -> list[int]:
        """Columns as certificates number vertices: copy c of vertex u is u + c n."""
        return [j // self.copies + self.size * (j % self.copies) for j in columns]

    def image(self, u: int, letter: int) -> Numbers:
        """The vector M_letter v / σ of N entries, v the vertex number u."""
        return np.asarray(self.scaled[letter] @ self._columns[:, u * self.copies])

    def copied(self, vector: Numbers) -> list[Numbers]:
        """The vector, its conjugate where vectors are complex, and the reflections of these in a symmetric family."""
        copies = [vector, vector.conj()] if self.complex else [vector]
        return copies + [v[::-1] for v in copies] if self.symmetric else copies

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
        """The number of a new vertex, whose origin is `parent` as in `parents`."""
        at = self.size * self.copies
        if at + self.copies > self._columns.shape[1]:
            self._columns = np.hstack([self._columns, np.zeros_like(self._columns)])
        self._columns[:, at : at + self.copies] = np.array(self.copied(vector)).T
        self.parents.append(parent)
        self.depths.append(0 if parent is None or parent[0] < 0 else self.depths[parent[0]] + 1)
        return self.size - 1

    def add_extra(self, vector: Array) -> int:
        """The number of a new vertex without origin: the vector, rounded to multiples of 2^-EXTRA_BITS."""
        integers = [round(x * (1 << EXTRA_BITS)) for x in vector.tolist()]
        self.extras.append(tuple(integers))
        return self.add(np.array(integers) / (1 << EXTRA_BITS), (-1, len(self.extras) - 1))

    def descends_from_extra(self, u: int) -> bool:
        """Whether the vertex is an extra one or comes from one."""
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
