"""The stages of `subdiv show`: those of `check`, then values, polynomials and error bounds."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.kinds.scalar.stages import (
    approximation_order,
    error_bound,
    hermite_bound,
    integer_values,
    interpolatory_order,
    limit_stencils,
    quasi_interpolation,
)
from subdiv_cli.kinds.scalar.stages.stage import Stage


def stages(tolerance: Fraction) -> tuple[Stage, ...]:
    """What comes after the stages of `scalar.py`."""
    return (
        integer_values.run,
        limit_stencils.run,
        quasi_interpolation.run,
        approximation_order.run,
        interpolatory_order.run,
        error_bound.stage(tolerance),
        hermite_bound.run,
    )
