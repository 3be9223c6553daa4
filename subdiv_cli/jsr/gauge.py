"""Gauges of vectors in a balanced polytope: many small linear programmes at once, in floats.

The gauge of y in the hull P of all ±v (of all e^(iθ) v, where vectors are complex) is min Σ|c| over Σ c_v v = y. It is
solved by the primal simplex method with long steps: weights are signed, so a weight that reaches zero may turn its
sign as long as the objective falls, and a step ends where it would rise. A complex vertex offers a column for every
phase, and the best one enters. All targets advance together, each with its own basis, and the expensive part,
pricing, is one product of matrices. A target whose basis is at hand from a similar one takes a few steps.

Nothing here is a proof: `closing` and `enclosing` recompute what the weights say.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from subdiv_cli.jsr.arrays import Array, Integers, Numbers, as_real
from subdiv_cli.model import Look, no_clock

PRECISION = 2e-10
"""Gauges closer to 1 than this are taken for 1."""
_OPTIMAL = 1e-11
_SMALLEST_PIVOT = 1e-11
_MOST_STEPS = 400
_PATIENCE = 40
"""Steps after which the column that enters is drawn by lot, since degenerate bases may form a circle."""


class Bases(NamedTuple):
    """A basis for each of M targets: d columns each, d = N, or 2N where vectors are complex."""

    numbers: Integers
    """The column numbers, M×d."""
    turns: Numbers
    """The factors of modulus 1 by which the columns are turned, M×d."""

    def chosen(self, targets: Integers) -> Bases:
        """The rows of `targets` in this batch."""
        return Bases(self.numbers[targets], self.turns[targets])

    def vectors(self, columns: Numbers) -> Array:
        """The basis vectors as an M×d×d array, the columns of M real matrices."""
        return as_real((columns[:, self.numbers] * self.turns).transpose(1, 2, 0)).transpose(0, 2, 1)


class Gauges(NamedTuple):
    """The gauges of M targets: each is at most `value`, and Σ_i weights_i turns_i (column numbers_i) = target."""

    value: Array
    bases: Bases
    weights: Array
    """The weights, M×d; `value` is the sum of their absolute values."""

    def chosen(self, targets: Integers) -> Gauges:
        """The rows of `targets` in this batch."""
        return Gauges(self.value[targets], self.bases.chosen(targets), self.weights[targets])

    def shares(self, k: int) -> tuple[tuple[int, ...], tuple[complex, ...]]:
        """The columns and the weights of target k."""
        return tuple(self.bases.numbers[k].tolist()), tuple((self.weights[k] * self.bases.turns[k]).tolist())


def gauges(
    columns: Numbers, targets: Numbers, bases: Bases, *, inside: float, outside: float, look: Look = no_clock
) -> Gauges:
    """The gauges of M targets (rows of N entries) in the hull of the n columns (N×n), from M bases.

    A target is left where its gauge is known to be at most `inside` or above `outside`; otherwise the optimum is
    computed. Raises what `look` raises, which is asked at every step.
    """
    state = _State(columns, as_real(targets), Bases(bases.numbers.copy(), bases.turns.copy()))
    active, generator = np.arange(len(targets)), None
    for number in range(_MOST_STEPS):
        look()
        if number == _PATIENCE:
            generator = np.random.default_rng(len(targets))
        active = state.step(active, inside, outside, generator)
        if not len(active):
            break
    state.refresh()
    return Gauges(np.abs(state.weights).sum(axis=1), state.bases, state.weights)


class _State:
    """Bases, their inverses and weights, advanced in place."""

    def __init__(self, columns: Numbers, targets: Array, bases: Bases) -> None:
        self.columns, self.targets, self.bases = columns, targets, bases
        self.refresh()

    def refresh(self) -> None:
        self.inverses: Array = inverses_of(self.bases.vectors(self.columns))
        self.weights: Array = np.einsum("mij,mj->mi", self.inverses, self.targets)

    def step(self, active: Integers, inside: float, outside: float, generator: np.random.Generator | None) -> Integers:
        """The numbers of the targets that are to go on after one step of the active ones.

        f = Σ_i sign(c_i) (row i of the inverse) has f·b = ±1 on the basis and f·y = Σ|c|. If |f·v| <= m on all columns,
        f/m bounds the gauge from below by Σ|c|/m; the column with the largest |f·v| enters, or any one above 1.
        """
        signs = np.where(self.weights[active] >= 0, 1.0, -1.0)
        prices = self._functional(np.einsum("mi,mij->mj", signs, self.inverses[active])) @ self.columns
        sizes = np.abs(prices)
        entering = sizes.argmax(axis=1)
        here = np.arange(len(active))
        value = np.abs(self.weights[active]).sum(axis=1)
        largest = sizes[here, entering]
        going = (largest > 1 + _OPTIMAL) & (value > inside) & (value <= outside * np.maximum(largest, 1.0))
        if generator is not None:
            entering = (np.maximum(sizes - 1 - _OPTIMAL, 0.0) * generator.random(sizes.shape)).argmax(axis=1)
        size, price = sizes[here, entering], prices[here, entering]
        active, entering, size, signs = active[going], entering[going], size[going], signs[going]
        if not len(active):
            return active
        turn = np.conj(price[going]) / size
        change, leaving, weight = self._ratio(active, entering, turn, size, signs)
        moving = np.isfinite(weight)
        active, entering, turn = active[moving], entering[moving], turn[moving]
        self._exchange(active, entering, turn, change[moving], leaving[moving], weight[moving])
        return active

    def _functional(self, real: Array) -> Numbers:
        """The functional f as it acts on complex columns: Re(φ·z) = f·(Re z, Im z)."""
        if not np.iscomplexobj(self.columns):
            return real
        n = real.shape[1] // 2
        return np.asarray(real[:, :n] - 1j * real[:, n:])

    def _ratio(
        self, active: Integers, entering: Integers, turn: Numbers, size: Array, signs: Array
    ) -> tuple[Array, Integers, Array]:
        """The changes of the weights with that of the newcomer (M×d), the columns that leave, and the new weights (M).

        Along weights - t·change the objective has the slope 1 - size, and 2|change_i| more beyond the zero of weight i.
        """
        newcomers = as_real((self.columns[:, entering] * turn).T)
        change = np.einsum("mij,mj->mi", self.inverses[active], newcomers)
        falling = signs * change > _SMALLEST_PIVOT
        with np.errstate(divide="ignore", invalid="ignore"):
            zeros = np.where(falling, self.weights[active] / change, np.inf)
        order = np.argsort(zeros, axis=1, kind="stable")
        jumps = np.where(falling, 2 * np.abs(change), 0.0)
        slopes = (1 - size)[:, None] + np.cumsum(np.take_along_axis(jumps, order, axis=1), axis=1)
        here = np.arange(len(active))
        position = (slopes >= 0).argmax(axis=1)
        position = np.where(slopes[here, position] >= 0, position, falling.sum(axis=1) - 1)
        leaving = order[here, position]
        return change, leaving, zeros[here, leaving]

    def _exchange(
        self, active: Integers, entering: Integers, turn: Numbers, change: Array, leaving: Integers, weight: Array
    ) -> None:
        here = np.arange(len(active))
        row = self.inverses[active, leaving] / change[here, leaving][:, None]
        self.inverses[active] -= change[:, :, None] * row[:, None, :]
        self.inverses[active, leaving] = row
        self.weights[active] -= weight[:, None] * change
        self.weights[active, leaving] = weight
        self.bases.numbers[active, leaving] = entering
        self.bases.turns[active, leaving] = turn


def inverses_of(matrices: Array) -> Array:
    """The inverses of M real d×d matrices; a singular one gets an inverse of large numbers, which proves nothing.

    Too many roundings make matrices singular.
    """
    try:
        return np.asarray(np.linalg.inv(matrices))
    except np.linalg.LinAlgError:
        return np.array([_inverse(m) for m in matrices])


def _inverse(m: Array) -> Array:
    try:
        return np.asarray(np.linalg.inv(m))
    except np.linalg.LinAlgError:
        return np.eye(len(m)) * 1e9
