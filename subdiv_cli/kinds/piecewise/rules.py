"""The codes of piecewise schemes: a row for each, in the form of those of scalar schemes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.piecewise import witnesses as w
from subdiv_cli.model import findings as q
from subdiv_cli.model.findings import Rule, row, table

_AL = "A. Levin 2003"
_LL = "Levin & Levin 2003"

SIDE = row("SD820", "side", "Dyn 1992; Jia & Wang 1993", w.SideWitness, proves="side")
GENERATION = row(
    "SD821",
    "piecewise-generation",
    f"{_AL}, Lemma 3.2, Corollary 3.3",
    w.PiecewiseGenerationWitness,
    answers=q.GENERATION,
    proves="generation",
)
LOCAL_SPECTRUM = row("SD822", "local-spectrum", f"{_AL}, section 3.5", w.LocalSpectrumWitness, proves="local-spectrum")
CONVERGENCE = row(
    "SD823",
    "piecewise-convergence",
    f"{_AL}, section 3.1; {_LL}, section 3",
    w.PiecewiseConvergenceWitness,
    answers=q.CONVERGENCE,
    proves="convergent",
    holds=True,
)
AT_ZERO = row(
    "SD824",
    "exponent-at-zero",
    f"{_LL}, section 3; Dyn, Gregory & Levin 1995",
    w.AtZeroWitness,
    answers=q.HOLDER_AT_ZERO,
    proves="zero-root zero-lower zero-upper zero-polynomial",
)
SMOOTHNESS = row(
    "SD825",
    "piecewise-smoothness",
    f"{_LL}, section 3; Dyn, Gregory & Levin 1995",
    w.PiecewiseSmoothnessWitness,
    answers=q.SMOOTHNESS,
    proves="smooth",
)
NEXT_SMOOTHNESS = row(
    "SD826",
    "piecewise-next-smoothness",
    f"{_LL}, section 3; Dyn, Gregory & Levin 1995",
    w.PiecewiseNextSmoothnessWitness,
    answers=q.NEXT_SMOOTHNESS,
    proves="not-smooth",
)
HOLDER_LOWER = row(
    "SD827",
    "piecewise-holder-lower",
    f"{_LL}, section 3; Dyn, Gregory & Levin 1995",
    w.PiecewiseHolderWitness,
    answers=q.HOLDER_LOWER,
    proves="holder-lower holder-root",
)
HOLDER_UPPER = row(
    "SD828",
    "piecewise-holder-upper",
    f"{_LL}, section 3; Dyn, Gregory & Levin 1995",
    w.PiecewiseHolderWitness,
    answers=q.HOLDER_UPPER,
    proves="holder-upper holder-root",
)
VALUE_AT_ZERO = row("SD829", "value-at-zero", f"{_AL}, section 2.5", w.ValueAtZeroWitness, proves="value-at-zero")


def rules() -> Mapping[str, Rule[Any]]:
    """Every row by its code."""
    return table(globals())
