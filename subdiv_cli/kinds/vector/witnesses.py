"""The forms of the witnesses of vector findings, and of what their certificates need besides.

`rules.py` says which rule has which; what the keys mean stands in the docstring of the stage.
"""

# No `from __future__ import annotations` here: it would hide from a TypedDict which of its keys are required.

from fractions import Fraction
from typing import NotRequired, Required, TypedDict

from subdiv_cli.kinds.scalar.witnesses import JordanBlockWitness
from subdiv_cli.model.proofs import Integers, Numbers, PowerData, RadiusProof, RadiusWitness

Rows = tuple[Numbers, ...]


class ConstantsWitness(TypedDict):
    """The form of SD701."""

    dimension: int
    basis: Rows
    size: int


class EigenSequencesWitness(TypedDict):
    """The form of SD702."""

    order: int


class EigenSequencesProof(TypedDict):
    """What the certificate needs besides SD702."""

    sequences: tuple[tuple[Rows, ...], ...]
    multipliers: Numbers
    functional: Numbers


class MeanMatrixWitness(TypedDict):
    """The form of SD703."""

    dimension: int


class SequenceRadiusWitness(RadiusWitness):
    """The form of SD704 and SD707."""

    order: int
    dimension: int
    method: str


class SequenceSpaceData(TypedDict):
    """An invariant space of sequences on an interval of indices."""

    start: int
    basis: tuple[Integers, ...]
    matrices: tuple[Rows, ...]
    tree: Integers
    leaves: Rows
    words: tuple[Integers, ...]
    orthogonal: NotRequired[Rows]


class SequenceRadiusProof(TypedDict):
    """What the certificate needs besides SD704 and SD707."""

    space: SequenceSpaceData
    radius: RadiusProof


class VectorConvergenceWitness(TypedDict, total=False):
    """The form of SD705."""

    by: Required[str]
    word: Integers
    start: int
    fixed: Rows


class VectorStencilsWitness(TypedDict):
    """The form of SD706."""

    start: int
    rows: Rows


class VectorSmoothnessWitness(TypedDict):
    """The form of SD708."""

    order: int
    by: str


class VectorNextSmoothnessWitness(TypedDict):
    """The form of SD709."""

    order: int
    by: str
    word: Integers


class VectorHolderLowerWitness(PowerData):
    """The form of SD710."""


class VectorHolderUpperWitness(TypedDict):
    """The form of SD711."""

    word: Integers
    length: int
    radius: Fraction


class VectorAttainedWitness(JordanBlockWitness):
    """The form of SD712."""

    order: int


class VectorAttainedProof(TypedDict):
    """What the certificate needs besides SD712."""

    space: SequenceSpaceData
    radius: NotRequired[RadiusProof]


class VectorDerivedWitness(TypedDict):
    """The form of SD713."""

    derivations: int
    level: int
    norm: Fraction
    order: int


class VectorDerivedProof(TypedDict):
    """What the certificate needs besides SD713."""

    transformations: tuple[Rows, ...]
    dimensions: Integers
    starts: Integers
    masks: tuple[tuple[Rows, ...], ...]
