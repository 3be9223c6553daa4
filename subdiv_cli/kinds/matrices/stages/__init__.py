"""The stages of schemes of matrices: a function `run(numbers, facts)` for each theorem, in order."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from subdiv_cli.kinds.kind import Analysis, Stage, run_stages
from subdiv_cli.kinds.matrices.numbers.matrices import MatrixNumbers
from subdiv_cli.kinds.matrices.scheme import MatrixFamily
from subdiv_cli.kinds.matrices.stages import convergence, smoothness
from subdiv_cli.model import Data, Effort

STAGES: tuple[Stage, ...] = (
    convergence.sign_patterns,
    convergence.convergence,
    convergence.well_defined,
    convergence.components,
    smoothness.radius,
    smoothness.joints,
    smoothness.smoothness,
    smoothness.holder,
)


def analyse(scheme: MatrixFamily, effort: Effort, _: Fraction | None = None) -> Analysis:
    """The findings of all stages under the effort."""
    numbers = MatrixNumbers(scheme, effort)
    return Analysis(scheme, _facts(numbers), run_stages(numbers, STAGES), numbers)


def _facts(numbers: MatrixNumbers) -> Mapping[str, Data]:
    return {"arity": numbers.p, "control_points": numbers.n, "stochastic": numbers.is_stochastic}
