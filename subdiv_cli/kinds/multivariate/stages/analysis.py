"""The stages of schemes in several variables, in order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from subdiv_cli.kinds.multivariate.lattice import Lattice
from subdiv_cli.kinds.multivariate.numbers.box_spline import box_spline
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.symmetries import facts
from subdiv_cli.kinds.multivariate.numbers.tensor import Factor, Part, Variables, tensor_factors
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.stages import (
    box_splines,
    convergence,
    coset_sums,
    difference_radius,
    directional_norms,
    directional_smoothness,
    exponent,
    matrix_norms,
    positive_mask,
    quasi_interpolation,
    reproduction,
    smoothness,
    sobolev,
    stability,
    tensor_products,
    total_sum_rules,
)
from subdiv_cli.kinds.multivariate.stages.rule import Stage
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages.scalar import Analysis as UnivariateAnalysis
from subdiv_cli.kinds.scalar.stages.scalar import analyse as analyse_univariate
from subdiv_cli.model import Data, Effort, Finding

MULTIVARIATE: tuple[Stage, ...] = (
    coset_sums.run,
    total_sum_rules.run,
    box_splines.run,
    tensor_products.run,
    directional_norms.run,
    difference_radius.run,
    positive_mask.run,
    directional_smoothness.run,
    matrix_norms.run,
    convergence.run,
    stability.run,
    smoothness.run,
    exponent.run,
    sobolev.run,
    reproduction.run,
    quasi_interpolation.run,
)


class Analysis(NamedTuple):
    """What there is to say about a scheme before anybody expects anything of it."""

    facts: Mapping[str, Data]
    findings: tuple[Finding, ...]
    numbers: MultivariateNumbers
    parts: tuple[PartAnalysis, ...] = ()
    """Of a tensor product that is no box spline, its factors."""


class PartAnalysis(NamedTuple):
    """A factor, and what its own stages have found."""

    variables: Variables
    scheme: ScalarScheme | MultivariateScheme
    analysis: UnivariateAnalysis | Analysis


def analyse(scheme: MultivariateScheme, effort: Effort) -> Analysis:
    """All stages under the effort, for each factor of a tensor product first."""
    lattice = Lattice(scheme.dilation)
    parts: tuple[PartAnalysis, ...] = ()
    if box_spline(scheme, lattice) is None:
        parts = tuple(_analysed(tensor_factors(scheme, lattice), effort))
    numbers = MultivariateNumbers(scheme, effort, tuple(map(_part, parts)))
    found: dict[str, tuple[Finding, ...]] = {}
    for stage in MULTIVARIATE:
        for finding in stage(numbers, found):
            found[finding.code] = (*found.get(finding.code, ()), finding)
    findings = tuple(finding for several in found.values() for finding in several)
    return Analysis(facts(numbers), findings, numbers, parts)


def _analysed(factors: Sequence[Factor], effort: Effort) -> Iterator[PartAnalysis]:
    """Equal ones once."""
    done: list[PartAnalysis] = []
    for variables, scheme in factors:
        known = next((part.analysis for part in done if part.scheme == scheme), None)
        if known is None:
            known = analyse_univariate(scheme, effort) if isinstance(scheme, ScalarScheme) else analyse(scheme, effort)
        done.append(PartAnalysis(variables, scheme, known))
    yield from done


def _part(part: PartAnalysis) -> Part:
    found: dict[str, Finding] = {}
    for finding in part.analysis.findings:
        found.setdefault(finding.code, finding)
    return Part(part.variables, part.scheme, found)
