"""The stages of schemes in several variables, in order."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from subdiv_cli.model import Data, Effort, Finding
from subdiv_cli.quantities.multivariate import MultivariateNumbers
from subdiv_cli.quantities.symmetries import facts
from subdiv_cli.schemes.multivariate import MultivariateScheme
from subdiv_cli.stages.multivariate import (
    box_splines,
    convergence,
    coset_sums,
    difference_radius,
    directional_norms,
    directional_smoothness,
    exponent,
    matrix_norms,
    positive_mask,
    reproduction,
    smoothness,
    sobolev,
    stability,
    total_sum_rules,
)
from subdiv_cli.stages.multivariate.rule import Stage

MULTIVARIATE: tuple[Stage, ...] = (
    coset_sums.run,
    total_sum_rules.run,
    box_splines.run,
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
)


class Analysis(NamedTuple):
    """What there is to say about a scheme before anybody expects anything of it."""

    facts: Mapping[str, Data]
    findings: tuple[Finding, ...]
    numbers: MultivariateNumbers


def analyse(scheme: MultivariateScheme, effort: Effort) -> Analysis:
    """All stages under the effort."""
    numbers = MultivariateNumbers(scheme, effort)
    found: dict[str, tuple[Finding, ...]] = {}
    for stage in MULTIVARIATE:
        for finding in stage(numbers, found):
            found[finding.code] = (*found.get(finding.code, ()), finding)
    return Analysis(facts(numbers), tuple(finding for several in found.values() for finding in several), numbers)
