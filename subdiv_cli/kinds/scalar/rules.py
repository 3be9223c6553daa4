"""The codes of scalar schemes: a row for each, with its source, the questions it answers and what its claims state."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.scalar import witnesses as w
from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Rule, row, table

_RADIUS = "norm product family radius bounded radius-upper"

RESIDUE_SUMS = row(
    "SD101", "residue-sums", "Dyn 1992, Proposition 2.1", w.ResidueSumsWitness, answers=q.SUMS, proves="residue-sums"
)
SUM_RULES = row(
    "SD102", "sum-rule-order", "Dyn 1992, (3.15)", w.SumRulesWitness, answers=q.SUM_RULES, proves="sum-rules"
)
GENERATION = row(
    "SD103",
    "generation-degree",
    "Levin 2003, section 2",
    w.GenerationWitness,
    answers=q.GENERATION,
    proves="generation sum-rules",
)
REPRODUCTION = row(
    "SD104",
    "reproduction-degree",
    "Conti & Hormann 2011",
    w.ReproductionWitness,
    answers=q.REPRODUCTION,
    proves="reproduction sum-rules",
)
DERIVED_SCHEMES = row(
    "SD105",
    "derived-schemes",
    "Dyn 1992, Proposition 3.1 and (3.17)",
    w.DerivedSchemesWitness,
    proves="derived sum-rules",
)
CONVERGENCE = row(
    "SD201",
    "convergence",
    "Dyn 1992, Theorem 3.2",
    w.ConvergenceWitness,
    answers=q.CONVERGENCE,
    proves="convergent",
    holds=True,
)
EIGEN_CONDITION = row(
    "SD202",
    "eigenvalue-condition",
    "Dyn 1992, Theorem 4.2",
    w.EigenConditionWitness,
    answers=q.EIGEN_CONDITION,
    proves="eigen-condition",
    holds=True,
)
CONTRACTIVITY = row(
    "SD301", "contractivity", "Dyn 1992, Theorems 3.2 and 3.4", w.ContractivityWitness, proves=f"{_RADIUS} sum-rules"
)
SMOOTHNESS = row(
    "SD302",
    "smoothness",
    "Dyn 1992, Theorem 3.4",
    w.SmoothnessWitness,
    answers=q.SMOOTHNESS,
    proves="smooth not-smooth",
)
NEXT_SMOOTHNESS = row(
    "SD303",
    "next-smoothness",
    "Cavaretta, Dahmen & Micchelli 1991; Dyn 1992, Theorem 5.3",
    w.NextSmoothnessWitness,
    answers=q.NEXT_SMOOTHNESS,
    proves="not-smooth",
)
SMOOTHNESS_SPECTRUM = row(
    "SD304",
    "smoothness-spectrum",
    "Dyn 1992, Theorem 4.2 and (4.12)",
    w.SmoothnessSpectrumWitness,
    proves="eigen-condition sum-rules",
)
JOINT_RADIUS = row(
    "SD310",
    "joint-spectral-radius",
    "Rota & Strang 1960; Guglielmi, Wirth & Zennaro 2005; Dyn 1992, section 4",
    w.JointRadiusWitness,
    proves=_RADIUS,
    radius=True,
)
HOLDER_LOWER = row(
    "SD311",
    "holder-lower",
    "Dyn 1992, section 3; Rioul 1992",
    w.HolderLowerWitness,
    answers=q.HOLDER_LOWER,
    proves="holder-lower holder holder-root",
)
HOLDER_UPPER = row(
    "SD312",
    "holder-upper",
    "Cavaretta, Dahmen & Micchelli 1991; Rioul 1992",
    w.HolderUpperWitness,
    answers=q.HOLDER_UPPER,
    proves="holder-upper holder holder-root",
)
HOLDER_ATTAINED = row(
    "SD313",
    "holder-attained",
    "Rioul 1992; Dyn 1992, section 3",
    w.HolderAttainedWitness,
    answers=q.HOLDER_ATTAINED,
    proves="attained",
    holds=True,
)
SOBOLEV = row(
    "SD321",
    "sobolev-exponent",
    "Villemoes 1992; Jia 1999",
    w.SobolevWitness,
    answers=q.SOBOLEV,
    proves="sobolev sobolev-at-least sobolev-at-most",
)
INDEPENDENCE = row(
    "SD401",
    "linear-independence",
    "Jia & Wang 1993; Zhou 1996",
    w.IndependenceWitness,
    answers=q.INDEPENDENCE,
    proves="independent",
    holds=True,
)
STABILITY = row(
    "SD402",
    "stability",
    "Jia & Wang 1993; Zhou 1996",
    w.StabilityWitness,
    answers=q.STABILITY,
    proves="stable",
    holds=True,
)
REDUCTION = row("SD403", "reduction", "Jia & Wang 1993; Zhou 1996", w.ReductionWitness, proves="reduction")
INTEGER_VALUES = row(
    "SD501", "integer-values", "Dyn 1992, Theorem 4.2 and Corollary 4.6", w.IntegerValuesWitness, proves="values"
)
LIMIT_STENCILS = row(
    "SD502", "limit-stencils", "Dyn 1992, Corollaries 4.3 and 4.6", w.LimitStencilsWitness, proves="convergent values"
)
QUASI_INTERPOLATION = row(
    "SD503",
    "quasi-interpolation",
    "Levin 2003, Corollary 2.4 and section 2.5",
    w.QuasiInterpolationWitness,
    answers=q.QUASI_INTERPOLATION,
    proves="quasi-interpolation",
)
APPROXIMATION_ORDER = row(
    "SD504",
    "approximation-order",
    "Levin 2003, Theorem 2.7",
    w.ApproximationOrderWitness,
    proves="quasi-interpolation reproduction",
)
INTERPOLATORY_ORDER = row(
    "SD505", "interpolatory-order", "Dyn 1992, Theorem 5.1", w.InterpolatoryOrderWitness, proves="not-smooth"
)
ERROR_BOUND = row("SD511", "error-bound", "Dyn 1992, Corollary 3.3", w.ErrorBoundWitness, proves="error-bound levels")
HERMITE_BOUND = row(
    "SD512", "hermite-bound", "Dyn 1992, Proposition 4.7", w.HermiteBoundWitness, proves="hermite-bound"
)


def rules() -> Mapping[str, Rule[Any]]:
    """Every row by its code."""
    return table(globals())
