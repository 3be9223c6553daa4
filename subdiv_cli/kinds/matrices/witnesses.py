"""The forms of the witnesses of findings on curves, and of what certificates have besides, as kind scalar has them."""

# No `from __future__ import annotations` here: it would hide from a TypedDict which of its keys are required.

from fractions import Fraction
from typing import NotRequired, Required, TypedDict

from subdiv_cli.model.proofs import Integers, Numbers, PowerData, RadiusProof, RadiusWitness


class ComponentsWitness(TypedDict):
    """The form of SD810."""

    degree: int
    dimension: int


class ComponentsProof(TypedDict):
    """What the certificate of SD810 has besides."""

    words: tuple[Integers, ...]
    annihilator: tuple[Numbers, ...]
    polygons: tuple[Numbers, ...]
    level: int
    weights: Numbers


class PolygonConvergenceWitness(PowerData, total=False):
    """The form of SD811; its proof is that of the radius."""

    by: Required[str]
    word: Integers


class SignPatternsWitness(TypedDict, total=False):
    """The form of SD812: `word` where it is refuted, else the others."""

    length: int
    by: str
    steps: int
    word: Integers


class WellDefinedWitness(TypedDict):
    """The form of SD813."""

    left: Numbers
    right: Numbers
    joint: NotRequired[int]


class CurveRadiusWitness(RadiusWitness):
    """The form of SD814."""

    dimension: int
    method: str


class SpaceData(TypedDict):
    """The space V, and the family on it."""

    basis: tuple[Numbers, ...]
    matrices: tuple[tuple[Numbers, ...], ...]


class CurveRadiusProof(SpaceData):
    """What the certificate of SD814 has besides."""

    whole: bool
    radius: RadiusProof


class JointsWitness(TypedDict):
    """The form of SD815."""

    orders: Integers
    joint: NotRequired[int]


class JointsProof(TypedDict):
    """What the certificate of SD815 has besides: the derivatives of each order at 0 and at 1."""

    left: tuple[Numbers, ...]
    right: tuple[Numbers, ...]


class CurveSmoothnessWitness(TypedDict):
    """The form of SD816: `order`, or `degree` of a polynomial."""

    by: str
    order: NotRequired[int]
    degree: NotRequired[int]


class CurveNextSmoothnessWitness(TypedDict):
    """The form of SD817."""

    by: str
    order: int
    word: NotRequired[Integers]


class CurveHolderLowerWitness(PowerData, total=False):
    """The form of SD818."""

    by: Required[str]
    value: int


class CurveHolderUpperWitness(TypedDict, total=False):
    """The form of SD819."""

    by: Required[str]
    value: int
    word: Integers
    length: int
    radius: Fraction
