"""The forms of the witnesses of findings in several variables, and of their further data for certificates.

As those of scalar schemes: `rules.py` says which rule has which witness, the docstring of the stage what the keys mean.
"""

# No `from __future__ import annotations` here: it would hide from a TypedDict which of its keys are required.

from fractions import Fraction
from typing import NotRequired, TypedDict

from subdiv_cli.model.proofs import RadiusProof, RadiusWitness, RootData
from subdiv_cli.spaces.lattice import Index

Numbers = tuple[Fraction, ...]
Integers = tuple[int, ...]
Rows = tuple[Numbers, ...]
PlacedNumbers = tuple[tuple[Index, Fraction], ...]
"""Pairs of an index and a number: a mask, a stencil, the derivatives of an operator."""


class CosetSumsWitness(TypedDict):
    """The form of SD601."""

    cosets: tuple[Index, ...]
    sums: Numbers


class TotalSumRulesWitness(TypedDict):
    """The form of SD602."""

    order: int


class BoxSplineWitness(TypedDict):
    """The form of SD603."""

    directions: tuple[Index, ...]
    multiplicities: Integers
    power: int
    scale: int
    shift: Index
    depth: int
    unimodular: bool


class DirectionalNormsWitness(TypedDict):
    """The form of SD604."""

    directions: tuple[Index, ...]
    levels: Integers
    norms: Numbers


class DifferenceRadiusWitness(RadiusWitness):
    """The form of SD605."""

    order: int
    dimension: int
    method: str


class SurfaceStencilWitness(RadiusWitness):
    """The form of SD621: of a radius that is known or bounded, or, with `least`, of one that a product keeps up."""

    order: int
    dimension: int
    stencil: PlacedNumbers
    method: NotRequired[str]
    least: NotRequired[Fraction]


class MatrixNormsWitness(TypedDict):
    """The form of SD606."""

    order: int
    smooth: int
    power: int
    steps: int
    level: int
    norm: Fraction
    by: str
    lemma_norm: Fraction
    least_norm: NotRequired[Fraction]


class DirectionalSmoothnessWitness(TypedDict):
    """The form of SD607."""

    directions: tuple[tuple[Index, Index], ...]
    levels: Integers
    norms: Numbers


class PositiveMaskWitness(TypedDict):
    """The form of SD608."""

    lowest: Index
    highest: Index


class TensorProductWitness(TypedDict):
    """The form of SD609."""

    parts: tuple[Integers, ...]


class MultivariateConvergenceWitness(TypedDict):
    """The form of SD611."""

    by: str
    word: NotRequired[Integers]


class MultivariateSmoothnessWitness(TypedDict):
    """The form of SD612 and SD613."""

    order: int
    by: str


class ExponentWitness(TypedDict):
    """An exponent of a box spline, its `value`, or of a tensor product: the least one of a factor."""

    by: str
    value: NotRequired[Fraction]
    variables: NotRequired[Integers]
    between: NotRequired[Fraction]


class MultivariateHolderLowerWitness(ExponentWitness, total=False):
    """The form of SD614."""

    length: int
    root: RootData
    bound: Fraction


class MultivariateHolderUpperWitness(TypedDict):
    """The form of SD615: of a box spline, of a factor, or of a product."""

    by: str
    value: NotRequired[Fraction]
    variables: NotRequired[Integers]
    word: NotRequired[Integers]
    length: NotRequired[int]
    radius: NotRequired[Fraction]


class MultivariateStabilityWitness(TypedDict):
    """The form of SD616."""

    by: str
    zero: NotRequired[Index]
    order: NotRequired[int]
    boxes: NotRequired[int]


class MultivariateSobolevWitness(ExponentWitness, total=False):
    """The form of SD617: from factors, from mean squares, or from bounds of the Hölder exponent."""

    variables_above: Integers
    polynomial: Integers
    low: Fraction
    high: Fraction
    holds: bool
    below: int
    above: int


class MultivariateReproductionWitness(TypedDict):
    """The form of SD618."""

    degree: int
    shift: Numbers
    defect: NotRequired[Index]


class MultivariateQuasiInterpolationWitness(TypedDict):
    """The form of SD619."""

    degree: int
    centre: Numbers
    moments: PlacedNumbers
    operator: PlacedNumbers
    centred: PlacedNumbers
    stencil: PlacedNumbers


class SublatticeWitness(TypedDict):
    """The form of SD620."""

    index: int | None
    functional: Index
    modulus: int


class QuotientsProof(TypedDict):
    """The further data of SD604 and SD607: the quotients of the mask."""

    quotients: tuple[PlacedNumbers, ...]


class SpaceProof(TypedDict):
    """The space of differences V_k with the transition operators on it."""

    order: int
    cosets: tuple[Index, ...]
    window: tuple[Index, ...]
    basis: tuple[Integers, ...]
    matrices: tuple[Rows, ...]
    generators: Rows


class DifferenceRadiusProof(TypedDict):
    """The further data of SD605."""

    space: SpaceProof
    radius: RadiusProof


class StencilSpaceProof(TypedDict):
    """The space V_k(w) of differences of a limit stencil with the transition operators on it."""

    cosets: tuple[Index, ...]
    window: tuple[Index, ...]
    basis: tuple[Integers, ...]
    matrices: tuple[Rows, ...]
    tree: Integers
    breadth: int
    leaves: Rows
    words: tuple[Integers, ...]


class StencilRadiusProof(TypedDict):
    """The further data of SD621."""

    space: StencilSpaceProof
    radius: NotRequired[RadiusProof]


class MatrixNormsProof(TypedDict):
    """The further data of SD606: the entries of Q row by row, and the work to multiply it out."""

    entries: tuple[PlacedNumbers, ...]
    work: int


class GramProof(TypedDict):
    """The further data of SD616: the Gram sequence, and the tree of boxes where its symbol is positive."""

    gram: PlacedNumbers
    correlations: int
    tree: NotRequired[Integers]


class GrowthProof(TypedDict):
    """The further data of what rests on mean squares of differences: their growth."""

    polynomial: Integers
    low: Fraction
    high: Fraction
    cofactor: Numbers
    window: int
    pairs: int
