"""The stages of schemes in several variables: a function `run(numbers, facts)` for each theorem, in order."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from fractions import Fraction

from subdiv_cli.kinds.kind import Analysis, Part, Stage, run_stages
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.symmetries import facts
from subdiv_cli.kinds.multivariate.numbers.tensor import TensorFactor, tensor_factors
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.stages import exponents, norms, products, smoothness, stencils, sum_rules
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages import analyse as analyse_univariate
from subdiv_cli.model import ClockStruckError, Effort

STAGES: tuple[Stage, ...] = (
    sum_rules.coset_sums,
    sum_rules.sum_rules,
    products.box_spline,
    products.tensor_product,
    norms.stays_in_sublattice,
    norms.directional_norms,
    smoothness.difference_radius,
    norms.positive_mask,
    norms.directional_smoothness,
    norms.matrix_norms,
    smoothness.convergence,
    smoothness.stability,
    stencils.stencil_radius,
    smoothness.smoothness,
    exponents.holder,
    exponents.sobolev,
    sum_rules.reproduction,
    sum_rules.quasi_interpolation,
)


def analyse(scheme: MultivariateScheme, effort: Effort, _: Fraction | None = None) -> Analysis:
    """The findings of all stages under the effort, of each factor of a tensor product first."""
    numbers = MultivariateNumbers(scheme, effort)
    with suppress(ClockStruckError):  # then all that asks for the box spline, or for factors, is undecided
        if numbers.box is None:
            numbers.parts = _analysed(tensor_factors(scheme, numbers.lattice), effort)
    return Analysis(scheme, facts(numbers), run_stages(numbers, STAGES), numbers, parts=numbers.parts)


def _analysed(factors: Sequence[TensorFactor], effort: Effort) -> tuple[Part, ...]:
    """The factors with their findings; equal factors are analysed once."""
    done: list[Part] = []
    for variables, scheme in factors:
        known = next((part.analysis for part in done if part.scheme == scheme), None)
        done.append(Part(variables, known or _of_factor(scheme, effort)))
    return tuple(done)


def _of_factor(scheme: ScalarScheme | MultivariateScheme, effort: Effort) -> Analysis:
    if isinstance(scheme, MultivariateScheme):
        return analyse(scheme, effort)
    return analyse_univariate(scheme, effort)
