"""The forms of the witnesses of scalar findings: stages write them, claims and pages read them.

`rules.py` says which rule has which; what the keys mean stands in the docstring of the stage. A key that not every
finding of a rule has is optional.
"""

# No `from __future__ import annotations` here: it would hide from a TypedDict which of its keys are required.

from fractions import Fraction
from typing import NotRequired, Required, TypedDict

from subdiv_cli.model.proofs import Integers, Numbers, PowerData, RadiusWitness

Spectra = tuple[tuple[str, ...], ...]


class ResidueSumsWitness(TypedDict):
    """The form of SD101."""

    sums: Numbers


class SumRulesWitness(TypedDict):
    """The form of SD102."""

    order: int
    cofactor_start: int
    cofactor: Numbers
    remainder: Numbers


class GenerationWitness(TypedDict):
    """The form of SD103; empty where it is refuted."""

    degree: NotRequired[int]


class ReproductionWitness(TypedDict):
    """The form of SD104."""

    degree: NotRequired[int]
    shift: Fraction
    defects: Numbers


class DerivedSchemesWitness(TypedDict):
    """The form of SD105."""

    starts: Integers
    masks: tuple[Numbers, ...]


class ProductWitness(TypedDict, total=False):
    """A product of transition matrices with a large eigenvalue."""

    word: Integers
    minimal_polynomial: Integers
    box: tuple[Fraction, Fraction, Fraction, Fraction]


class ObstacleWitness(ProductWitness, total=False):
    """What keeps a stable φ from being smoother: the order of its sum rules, a product, or `by` a finding."""

    sum_rule_order: int
    by: str


class ContractionWitness(ProductWitness, total=False):
    """What makes a derived scheme contract, a norm or the joint spectral radius; or a product that keeps it from it."""

    level: int
    norm: Fraction
    norms: Numbers
    condition: str
    radius_of: str


class ContractivityWitness(ContractionWitness):
    """The form of SD301."""

    nu: int


class ConvergenceWitness(ContractionWitness, total=False):
    """The form of SD201: that of SD101, SD202 or SD301, whichever decides, or the code of SD302 or SD321 alone."""

    by: Required[str]
    nu: int
    sums: Numbers
    eigenvalues: Spectra
    matrix: int


class EigenConditionWitness(TypedDict):
    """The form of SD202."""

    eigenvalues: Spectra
    matrix: NotRequired[int]
    stencil_start: NotRequired[int]
    stencil: NotRequired[Numbers]


class SmoothnessWitness(ObstacleWitness, total=False):
    """The form of SD302: `order` and `by`, or an obstacle to continuity."""

    order: int
    radius_of: str


class NextSmoothnessWitness(ObstacleWitness):
    """The form of SD303."""

    order: int


class SmoothnessSpectrumWitness(TypedDict):
    """The form of SD304."""

    nu: int
    eigenvalues: Spectra


class JointRadiusWitness(RadiusWitness):
    """The form of SD310."""

    of: str
    difference_order: int
    method: str
    vertices: NotRequired[int]


class HolderLowerWitness(PowerData):
    """The form of SD311."""

    difference_order: int
    radius_of: NotRequired[str]
    by: NotRequired[str]
    nu: NotRequired[int]


class HolderUpperWitness(ProductWitness):
    """The form of SD312."""

    difference_order: int
    radius: NotRequired[Fraction]
    by: NotRequired[str]
    length: NotRequired[int]


class JordanBlockWitness(TypedDict, total=False):
    """A product of transition matrices with a Jordan block."""

    word: Integers
    sign: int
    value: Fraction
    vector: Numbers


class HolderAttainedWitness(JordanBlockWitness):
    """The form of SD313."""

    nu: int
    by: NotRequired[str]
    level: NotRequired[int]
    norm: NotRequired[Fraction]


class SobolevWitness(TypedDict, total=False):
    """The form of SD321: the growth of mean squares, or bounds of the Hölder exponent from below and from above."""

    difference_order: int
    polynomial: Integers
    low: Fraction
    high: Fraction
    cofactor: Numbers
    by: str
    length: int
    bound: Fraction
    word: Integers
    radius: Fraction
    sum_rule_order: int


class IndependenceWitness(TypedDict, total=False):
    """The form of SD401."""

    largest_n: int
    gcd: Numbers
    cycle: int


class StabilityWitness(TypedDict, total=False):
    """The form of SD402."""

    gcd: Numbers
    starts: Integers
    cofactors: tuple[Numbers, ...]
    circle_factor: Integers
    cycle: int


class ReductionWitness(TypedDict):
    """The form of SD403."""

    factors: tuple[Numbers, ...]
    cycles: tuple[int | None, ...]
    starts: Integers
    masks: tuple[Numbers, ...]
    order: int
    cofactor_start: int
    cofactor: Numbers
    stable: StabilityWitness


class IntegerValuesWitness(TypedDict):
    """The form of SD501."""

    starts: Integers
    values: tuple[Numbers, ...]
    own_starts: Integers
    own_values: tuple[Numbers, ...]
    support: tuple[Fraction, Fraction]


class LimitStencilsWitness(TypedDict):
    """The form of SD502."""

    starts: Integers
    stencils: tuple[Numbers, ...]


class QuasiInterpolationWitness(TypedDict):
    """The form of SD503."""

    degree: int
    moments: Numbers
    operator: Numbers
    stencil_start: int
    stencil: Numbers
    eigen_sequences: tuple[Numbers, ...]


class ApproximationOrderWitness(TypedDict):
    """The form of SD504."""

    with_q: int
    without_q: int


class InterpolatoryOrderWitness(TypedDict):
    """The form of SD505."""

    order: int


class ErrorBoundWitness(TypedDict):
    """The form of SD511."""

    nu: int
    level: int
    norms: Numbers
    distance: Fraction
    constant: Fraction
    tolerance: Fraction
    levels: int


class HermiteBoundWitness(TypedDict):
    """The form of SD512."""

    order: int
    norms: Numbers
    derived_constant: Fraction
    level: int
    norm: Fraction
    constant: Fraction
