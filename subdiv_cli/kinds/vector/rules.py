"""The codes of vector schemes: a row for each, in the form of those of scalar schemes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.vector import witnesses as w
from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Rule, row, table

_RADIUS = "family radius bounded radius-upper"
_STENCILS = "Micchelli & Sauer 1998; Charina, Conti & Sauer 2005; Jia 1998"

CONSTANTS = row(
    "SD701",
    "constants",
    "Micchelli & Sauer 1998; Moosmüller & Dyn 2018, (6)",
    w.ConstantsWitness,
    answers=q.DIMENSION,
    proves="constants",
)
EIGEN_SEQUENCES = row(
    "SD702",
    "eigen-sequences",
    "Micchelli & Sauer 1998; Levin 2003, section 2",
    w.EigenSequencesWitness,
    answers=(q.SUM_RULES, q.GENERATION),
    proves="eigen-sequences generation",
)
MEAN_MATRIX = row(
    "SD703",
    "mean-matrix",
    "Cohen, Dyn & Levin 1996; Moosmüller & Dyn 2018, Theorem 19 and Corollary 20",
    w.MeanMatrixWitness,
    proves="mean-matrix",
    holds=True,
)
DECAY_RADIUS = row(
    "SD704",
    "decay-radius",
    "Micchelli & Sauer 1998; Rota & Strang 1960; Guglielmi, Wirth & Zennaro 2005",
    w.SequenceRadiusWitness,
    proves=_RADIUS,
    radius=True,
)
CONVERGENCE = row(
    "SD705",
    "vector-convergence",
    "Micchelli & Sauer 1998",
    w.VectorConvergenceWitness,
    answers=q.CONVERGENCE,
    proves="convergent",
    holds=True,
)
LIMIT_STENCILS = row(
    "SD706",
    "vector-limit-stencils",
    "Micchelli & Sauer 1998",
    w.VectorStencilsWitness,
    proves="limit-stencils constants",
)
STENCIL_RADIUS = row(
    "SD707",
    "stencil-radius",
    "Jia 1998; Rota & Strang 1960; Guglielmi, Wirth & Zennaro 2005",
    w.SequenceRadiusWitness,
    proves=_RADIUS,
    radius=True,
)
SMOOTHNESS = row(
    "SD708",
    "vector-smoothness",
    _STENCILS,
    w.VectorSmoothnessWitness,
    answers=q.SMOOTHNESS,
    proves="smooth",
)
NEXT_SMOOTHNESS = row(
    "SD709",
    "vector-next-smoothness",
    _STENCILS,
    w.VectorNextSmoothnessWitness,
    answers=q.NEXT_SMOOTHNESS,
    proves="not-smooth",
)
HOLDER_LOWER = row(
    "SD710",
    "vector-holder-lower",
    _STENCILS,
    w.VectorHolderLowerWitness,
    answers=q.HOLDER_LOWER,
    proves="holder-lower holder-root",
)
HOLDER_UPPER = row(
    "SD711",
    "vector-holder-upper",
    _STENCILS,
    w.VectorHolderUpperWitness,
    answers=q.HOLDER_UPPER,
    proves="holder-upper holder-root",
)
HOLDER_ATTAINED = row(
    "SD712",
    "vector-holder-attained",
    "Rioul 1992; Jia 1998",
    w.VectorAttainedWitness,
    answers=q.HOLDER_ATTAINED,
    proves="attained",
    holds=True,
)
DERIVED_SCHEMES = row(
    "SD713",
    "vector-derived-schemes",
    "Cohen, Dyn & Levin 1996; Charina, Conti & Sauer 2005; Moosmüller & Dyn 2018, Theorems 9 and 11",
    w.VectorDerivedWitness,
    proves="derived derived-norm smooth convergent",
)


def rules() -> Mapping[str, Rule[Any]]:
    """Every row by its code."""
    return table(globals())
