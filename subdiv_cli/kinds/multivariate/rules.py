"""The codes of schemes in several variables: a row for each, in the form of those of scalar schemes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.multivariate import witnesses as w
from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Rule, row, table

_RADIUS = "family radius bounded radius-upper"
_BOX_SPLINES = "de Boor, Höllig & Riemenschneider 1993"

COSET_SUMS = row(
    "SD601",
    "coset-sums",
    "Dyn 1992, Proposition 6.1",
    w.CosetSumsWitness,
    answers=q.SUMS,
    proves="coset-sums",
    holds=True,
)
SUM_RULES = row(
    "SD602",
    "total-sum-rules",
    "Jia 1998; Levin 2003, section 2",
    w.TotalSumRulesWitness,
    answers=(q.SUM_RULES, q.GENERATION),
    proves="total-sum-rules generation",
)
BOX_SPLINE = row("SD603", "box-spline", f"{_BOX_SPLINES}, chapters I and II", w.BoxSplineWitness, proves="box-spline")
DIRECTIONAL_NORMS = row(
    "SD604",
    "directional-norms",
    "Dyn 1992, (6.52), (6.53) and Proposition 6.10",
    w.DirectionalNormsWitness,
    proves="directional-norm",
)
DIFFERENCE_RADIUS = row(
    "SD605",
    "difference-radius",
    "Jia 1998; Han & Jia 1998; Guglielmi, Wirth & Zennaro 2005",
    w.DifferenceRadiusWitness,
    proves=_RADIUS,
    radius=True,
)
MATRIX_NORMS = row(
    "SD606",
    "matrix-norms",
    "Dyn 1992, Propositions 6.8 and 6.10, Theorems 6.9 and 7.5",
    w.MatrixNormsWitness,
    proves="matrix-norm",
)
DIRECTIONAL_SMOOTHNESS = row(
    "SD607",
    "directional-smoothness",
    "Dyn 1992, Corollary 7.9 and Proposition 6.10",
    w.DirectionalSmoothnessWitness,
    proves="smooth",
)
POSITIVE_MASK = row(
    "SD608", "positive-mask", "Dyn 1992, Theorem 6.4", w.PositiveMaskWitness, proves="convergent", holds=True
)
TENSOR_PRODUCT = row(
    "SD609", "tensor-product", "Dyn 1992, Proposition 6.3", w.TensorProductWitness, proves="tensor-product"
)
CONVERGENCE = row(
    "SD611",
    "surface-convergence",
    "Han & Jia 1998, Theorem 4.3; Dyn 1992, section 6",
    w.MultivariateConvergenceWitness,
    answers=q.CONVERGENCE,
    proves="convergent",
    holds=True,
)
SMOOTHNESS = row(
    "SD612",
    "surface-smoothness",
    f"Jia 1998; Han 2003; {_BOX_SPLINES}, I.36",
    w.MultivariateSmoothnessWitness,
    answers=q.SMOOTHNESS,
    proves="smooth not-smooth",
)
NEXT_SMOOTHNESS = row(
    "SD613",
    "surface-next-smoothness",
    f"Jia 1998; {_BOX_SPLINES}, I.36",
    w.MultivariateSmoothnessWitness,
    answers=q.NEXT_SMOOTHNESS,
    proves="not-smooth",
)
HOLDER_LOWER = row(
    "SD614",
    "surface-holder-lower",
    f"Jia 1998; Han 2003; {_BOX_SPLINES}, I.36",
    w.MultivariateHolderLowerWitness,
    answers=q.HOLDER_LOWER,
    proves="radius bounded radius-upper holder-lower holder-root holder-value of-factor",
)
HOLDER_UPPER = row(
    "SD615",
    "surface-holder-upper",
    f"Jia 1998; Han 2003; {_BOX_SPLINES}, I.36",
    w.MultivariateHolderUpperWitness,
    answers=q.HOLDER_UPPER,
    proves="holder-upper holder-root holder-value of-factor at-most-factor",
)
STABILITY = row(
    "SD616",
    "surface-stability",
    f"Jia & Micchelli 1991; {_BOX_SPLINES}, II.57",
    w.MultivariateStabilityWitness,
    answers=q.STABILITY,
    proves="stable",
    holds=True,
)
SOBOLEV = row(
    "SD617",
    "surface-sobolev",
    f"Jia 1999; Han 2003; {_BOX_SPLINES}, chapter I",
    w.MultivariateSobolevWitness,
    answers=q.SOBOLEV,
    proves="sobolev sobolev-lower sobolev-value sobolev-at-least sobolev-at-most of-factor at-most-factor",
)
REPRODUCTION = row(
    "SD618",
    "surface-reproduction",
    "Levin 2003, section 2; Conti & Hormann 2011; Charina & Conti 2013",
    w.MultivariateReproductionWitness,
    answers=q.REPRODUCTION,
    proves="reproduction",
)
QUASI_INTERPOLATION = row(
    "SD619",
    "surface-quasi-interpolation",
    "Levin 2003, Corollary 2.4 and section 2.5",
    w.MultivariateQuasiInterpolationWitness,
    answers=q.QUASI_INTERPOLATION,
    proves="quasi-interpolation",
)

SUBLATTICE = row(
    "SD620",
    "sublattice",
    "proved in the format of certificates, sublattice-diverges",
    w.SublatticeWitness,
    proves="convergent",
)
STENCIL_RADIUS = row(
    "SD621",
    "surface-stencil-radius",
    "Jia 1998; Guglielmi, Wirth & Zennaro 2005; proved in the format of certificates, stencil-differences",
    w.SurfaceStencilWitness,
    proves="stencil-family radius bounded radius-upper radius-lower",
    radius=True,
)


def rules() -> Mapping[str, Rule[Any]]:
    """Every row by its code."""
    return table(globals())
