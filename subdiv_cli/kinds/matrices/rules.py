"""The codes of schemes of matrices: a row for each, in the form of those of scalar schemes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.matrices import witnesses as w
from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Rule, row, table

_MP = "Micchelli & Prautzsch 1989"

COMPONENTS = row(
    "SD810",
    "polynomial-components",
    f"{_MP}, Theorems 7.1 to 7.3",
    w.ComponentsWitness,
    answers=q.POLYNOMIALS,
    proves="polynomials",
)
CONVERGENCE = row(
    "SD811",
    "polygon-convergence",
    f"{_MP}, section 2; Daubechies & Lagarias 1992",
    w.PolygonConvergenceWitness,
    answers=q.CONVERGENCE,
    proves="convergent",
    holds=True,
)
SIGN_PATTERNS = row(
    "SD812",
    "sign-patterns",
    f"{_MP}, Theorem 2.1, Corollaries 2.3 and 2.4",
    w.SignPatternsWitness,
    proves="positive-columns convergent",
)
WELL_DEFINED = row(
    "SD813",
    "well-defined-curve",
    f"{_MP}, Theorem 3.1",
    w.WellDefinedWitness,
    answers=q.WELL_DEFINED,
    proves="well-defined",
    holds=True,
)
DIFFERENCE_RADIUS = row(
    "SD814",
    "curve-radius",
    f"{_MP}, Theorem 5.2; Guglielmi, Wirth & Zennaro 2005",
    w.CurveRadiusWitness,
    proves="radius bounded radius-upper",
    radius=True,
)
JOINTS = row("SD815", "joints", f"{_MP}, Theorem 5.2 (a)", w.JointsWitness, proves="derivative", holds=True)
SMOOTHNESS = row(
    "SD816",
    "curve-smoothness",
    f"{_MP}, Theorems 5.1 and 5.2",
    w.CurveSmoothnessWitness,
    answers=q.SMOOTHNESS,
    proves="smooth polynomial-curve",
)
NEXT_SMOOTHNESS = row(
    "SD817",
    "curve-next-smoothness",
    f"{_MP}, Theorem 5.2",
    w.CurveNextSmoothnessWitness,
    answers=q.NEXT_SMOOTHNESS,
    proves="not-smooth",
)
HOLDER_LOWER = row(
    "SD818",
    "curve-holder-lower",
    f"{_MP}, section 5; Daubechies & Lagarias 1992",
    w.CurveHolderLowerWitness,
    answers=q.HOLDER_LOWER,
    proves="holder-lower holder-root holder-value polynomial-curve",
)
HOLDER_UPPER = row(
    "SD819",
    "curve-holder-upper",
    f"{_MP}, section 5; Daubechies & Lagarias 1992",
    w.CurveHolderUpperWitness,
    answers=q.HOLDER_UPPER,
    proves="holder-upper holder-root holder-value",
)


def rules() -> Mapping[str, Rule[Any]]:
    """Every row by its code."""
    return table(globals())
