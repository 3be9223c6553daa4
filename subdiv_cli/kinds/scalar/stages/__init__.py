"""The stages of scalar schemes: a pure function `run(numbers, facts)` for each theorem, in the order in which they run.

`numbers` computes what is asked of it, each number once; `facts` are the verdicts of earlier stages. A finding that
asks for something that cannot be (a derivative of a φ that is not continuous) is skipped and says why.
"""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.kind import Analysis, Stage, run_stages
from subdiv_cli.kinds.scalar.numbers.facts import facts, hints
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages import (
    error_bounds,
    holder,
    joint_radius,
    smoothness,
    sobolev,
    spectra,
    stability,
    sum_rules,
    values,
)
from subdiv_cli.model import Effort

STAGES: tuple[Stage, ...] = (
    sum_rules.residue_sums,
    sum_rules.sum_rules,
    sum_rules.generation,
    sum_rules.reproduction,
    sum_rules.derived_schemes,
    stability.independence,
    stability.stability,
    stability.reduced_mask,
    spectra.of_scheme,
    joint_radius.joint_radius,
    smoothness.convergence,
    smoothness.contractivity,
    smoothness.smoothness,
    smoothness.next_smoothness,
    spectra.of_derived_schemes,
    holder.holder_lower,
    holder.holder_upper,
    holder.holder_attained,
    sobolev.run,
)
"""The stages of `check`, in the order in which they run."""


def analyse(scheme: ScalarScheme, effort: Effort, tolerance: Fraction | None = None) -> Analysis:
    """The findings of all stages under the effort; with a tolerance of error bounds also those that only `show` has."""
    numbers = ScalarNumbers(scheme, effort)
    stages = STAGES if tolerance is None else (*STAGES, *_more(tolerance))
    return Analysis(scheme, facts(scheme), run_stages(numbers, stages), numbers, hints(scheme))


def _more(tolerance: Fraction) -> tuple[Stage, ...]:
    """The stages of values, polynomials and error bounds."""
    return (
        values.integer_values,
        values.limit_stencils,
        values.quasi_interpolation,
        values.approximation_order,
        values.interpolatory_order,
        error_bounds.error_bound(tolerance),
        error_bounds.hermite_bound,
    )
