"""The forms of the witnesses of findings on piecewise schemes, as kind scalar has them."""

# No `from __future__ import annotations` here: it would hide from a TypedDict which of its keys are required.

from fractions import Fraction
from typing import Required, TypedDict

from subdiv_cli.model.proofs import Integers, Numbers, PowerData


class SideWitness(TypedDict):
    """The form of SD820."""

    side: str


class PiecewiseGenerationWitness(TypedDict):
    """The form of SD821: Q on both sides, and the values of q_0, …, q_degree on the points from `start` on."""

    degree: int
    left: Numbers
    right: Numbers
    start: int
    sequences: tuple[Numbers, ...]


class LocalSpectrumWitness(TypedDict):
    """The form of SD822: irreducible factors of the characteristic polynomial but z, as often as they stand in it."""

    points: Integers
    factors: tuple[Integers, ...]


class PiecewiseConvergenceWitness(TypedDict, total=False):
    """The form of SD823: `by` a row, `side` or the spectral radius of rows that sum to 0."""

    by: Required[str]
    row: int
    total: Fraction
    side: str
    dimension: int


class AtZeroWitness(PowerData, total=False):
    """The form of SD824; `root` with `length` where the radius is known, else `bound` and `below`."""

    order: Required[int]
    dimension: Required[int]
    below: Fraction


class PiecewiseSmoothnessWitness(TypedDict):
    """The form of SD825."""

    order: int


class PiecewiseNextSmoothnessWitness(TypedDict):
    """The form of SD826: `by` is `left`, `right` or `zero`."""

    order: int
    by: str


class PiecewiseHolderWitness(PowerData, total=False):
    """The form of SD827 and SD828: `by` is `left`, `right` or `zero`."""

    by: Required[str]


class ValueAtZeroWitness(TypedDict):
    """The form of SD829: the weights of the data from `start` on."""

    start: int
    weights: Numbers
