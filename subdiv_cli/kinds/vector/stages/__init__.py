"""The stages of vector schemes: a function `run(numbers, facts)` for each theorem, in order."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from subdiv_cli.kinds.kind import Analysis, Stage, run_stages
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers
from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.kinds.vector.stages import convergence, smoothness
from subdiv_cli.model import Data, Effort

STAGES: tuple[Stage, ...] = (
    convergence.constants,
    convergence.eigen_sequences,
    convergence.mean_matrix,
    convergence.decay_radius,
    convergence.convergence,
    convergence.limit_stencils,
    smoothness.stencil_radius,
    smoothness.smoothness,
    smoothness.holder,
    smoothness.holder_attained,
    smoothness.derived_schemes,
)


def analyse(scheme: VectorScheme, effort: Effort, _: Fraction | None = None) -> Analysis:
    """The findings of all stages under the effort."""
    numbers = VectorNumbers(scheme, effort)
    return Analysis(scheme, facts(scheme), run_stages(numbers, STAGES), numbers)


def facts(scheme: VectorScheme) -> Mapping[str, Data]:
    """The facts that are seen without a theorem."""
    last, m = scheme.start + len(scheme.coefficients) - 1, scheme.size
    at_multiples = [matrix for i, matrix in enumerate(scheme.coefficients, scheme.start) if not i % scheme.arity and i]
    centre = scheme.coefficients[-scheme.start] if scheme.start <= 0 <= last else ()
    unit = tuple(tuple(Fraction(int(k == l)) for l in range(m)) for k in range(m))
    return {
        "arity": scheme.arity,
        "support": (scheme.start, last),
        "size": m,
        "interpolatory": centre == unit and not any(any(map(any, matrix)) for matrix in at_multiples),
    }
