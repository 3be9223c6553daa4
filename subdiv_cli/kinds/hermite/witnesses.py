"""The forms of the witnesses of findings on jets, and of what their certificates need besides.

`rules.py` says which rule has which; what the keys mean stands in the docstring of the stage.
"""

# No `from __future__ import annotations` here: it would hide from a TypedDict which of its keys are required.

from typing import Required, TypedDict

from subdiv_cli.kinds.vector.witnesses import Rows, VectorDerivedProof
from subdiv_cli.model.proofs import Integers, Numbers


class SpectralConditionWitness(TypedDict):
    """The form of SD714."""

    order: int
    shifts: Numbers


class HermiteConvergenceWitness(TypedDict, total=False):
    """The form of SD716."""

    order: Required[int]
    by: Required[str]
    derivative: int
    word: Integers


class TaylorProof(VectorDerivedProof):
    """What the certificate needs besides SD717: the Taylor mask, from which the others are derived."""

    start: int
    taylor: tuple[Rows, ...]
