"""The stages of scalar schemes: a pure function `run(numbers, facts)` for each theorem, in the order in which they run.

`numbers` computes what is asked of it, each number once; `facts` are the verdicts of earlier stages. A finding that
asks for something that cannot be (a derivative of a φ that is not continuous) is skipped and says why.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.kind import Analysis, Stage, run_stages
from subdiv_cli.kinds.scalar.numbers.facts import facts
from subdiv_cli.kinds.scalar.numbers.hints import hints
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages import (
    approximation_order,
    attained,
    contractivity,
    convergence,
    derived,
    eigenvalues,
    error_bound,
    generation,
    hermite_bound,
    holder_lower,
    holder_upper,
    independence,
    integer_values,
    interpolatory_order,
    joint_radius,
    limit_stencils,
    next_smoothness,
    quasi_interpolation,
    reduction,
    reproduction,
    residue_sums,
    smoothness,
    smoothness_spectrum,
    sobolev,
    stability,
    sum_rules,
)
from subdiv_cli.model import Effort

STAGES: tuple[Stage, ...] = (
    residue_sums.run,
    sum_rules.run,
    generation.run,
    reproduction.run,
    derived.run,
    independence.run,
    stability.run,
    reduction.run,
    eigenvalues.run,
    joint_radius.run,
    convergence.run,
    contractivity.run,
    smoothness.run,
    next_smoothness.run,
    smoothness_spectrum.run,
    holder_lower.run,
    holder_upper.run,
    attained.run,
    sobolev.run,
)
"""Those of `check`."""


def analyse(scheme: ScalarScheme, effort: Effort, tolerance: Fraction | None = None) -> Analysis:
    """What all stages find under the effort; with a tolerance of error bounds also those that only `show` has."""
    numbers = ScalarNumbers(scheme, effort)
    stages = STAGES if tolerance is None else (*STAGES, *_more(tolerance))
    return Analysis(scheme, facts(scheme), run_stages(numbers, stages), numbers, hints(scheme))


def _more(tolerance: Fraction) -> tuple[Stage, ...]:
    """Values, polynomials and error bounds."""
    return (
        integer_values.run,
        limit_stencils.run,
        quasi_interpolation.run,
        approximation_order.run,
        interpolatory_order.run,
        error_bound.stage(tolerance),
        hermite_bound.run,
    )
