"""Measures of images outside a body: their gauges, in floats, with the weights that show them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from subdiv_cli.jsr.arrays import Numbers, as_real
from subdiv_cli.jsr.body import Polytope
from subdiv_cli.jsr.dominance import Dominations, domination
from subdiv_cli.jsr.gauge import Bases, Gauges, gauges, inverses_of
from subdiv_cli.model import Look, no_clock

_REMEMBERED = 48
"""Bases that are tried as a start for new targets."""


class Balanced:
    """Gauges in the hull of all ±v, from bases that were good for earlier targets."""

    def __init__(self, body: Polytope, look: Look) -> None:
        self._body, self._look = body, look
        first = np.array([independent_columns(body.columns)])
        turns = np.ones(first.shape, dtype=body.columns.dtype)
        if body.complex:
            first, turns = np.hstack([first, first]), np.hstack([turns, 1j * turns])
        self.bases = Bases(first, turns)

    def measure(self, targets: Numbers, like: Any = None, *, inside: float = 0.0, outside: float = math.inf) -> Gauges:
        """The gauges of the M rows of `targets`, as exactly as `gauges` says.

        `like` has earlier gauges whose bases may do again.
        """
        columns = self._body.columns
        bases = self._best(columns, targets) if like is None else like.bases
        measures = gauges(columns, targets, bases, inside=inside, outside=outside, look=self._look)
        self._remember(measures.bases)
        return measures

    def _best(self, columns: Numbers, targets: Numbers) -> Bases:
        """The remembered bases in which the targets have the smallest weights, one for each of the M rows."""
        inverses = inverses_of(self.bases.vectors(columns))
        sums = np.abs(np.einsum("kij,mj->mki", inverses, as_real(targets))).sum(axis=2)
        return self.bases.chosen(sums.argmin(axis=1))

    def _remember(self, bases: Bases) -> None:
        kept = len(self.bases.numbers)
        oldest = [0, *range(max(1, kept + 8 - _REMEMBERED), kept)]
        pairs = zip(
            self.bases.chosen(np.array(oldest)), bases.chosen(np.arange(min(8, len(bases.numbers)))), strict=True
        )
        self.bases = Bases(*(np.concatenate(pair) for pair in pairs))


class Monotone:
    """Gauges in the hull of all x >= 0 that are below a convex combination of vertices."""

    def __init__(self, body: Polytope, look: Look) -> None:
        self._body, self._look = body, look

    def measure(
        self, targets: Numbers, like: Any = None, *, inside: float = 0.0, outside: float = math.inf
    ) -> Dominations:
        """The gauges of the M rows of `targets`, exactly in any case."""
        return Dominations([domination(self._body.columns, target, self._look) for target in targets])


def measure_of(body: Polytope, look: Look = no_clock) -> Balanced | Monotone:
    """The measure of gauges in a body of this sort; what `look` raises ends it."""
    return (Monotone if body.monotone else Balanced)(body, look)


def gauge(body: Polytope, vector: Numbers) -> float:
    """The gauge of one vector in a body whose columns span the space."""
    return float(measure_of(body).measure(vector[None]).value[0])


def independent_columns(columns: Numbers) -> list[int]:
    """The numbers of as many independent columns as there are rows, each far from the span of those before it.

    The matrix is real or complex; its rows must be independent. Each column is as far from that span as can be.
    """
    rest, chosen = columns.copy(), []
    for _ in range(len(columns)):
        lengths = np.linalg.norm(rest, axis=0)
        j = int(lengths.argmax())
        chosen.append(j)
        direction = rest[:, j] / lengths[j]
        rest = rest - np.outer(direction, direction.conj() @ rest)
    return chosen
