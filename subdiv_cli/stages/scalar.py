"""The stages of scalar schemes in one variable, in order."""

from __future__ import annotations

from collections.abc import Mapping

from subdiv_cli.model import Data, Effort, Finding
from subdiv_cli.quantities.facts import facts as mask_facts
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.schemes.scalar import ScalarScheme
from subdiv_cli.stages import (
    contractivity,
    convergence,
    derived,
    eigenvalues,
    generation,
    holder_lower,
    holder_upper,
    independence,
    next_smoothness,
    reduction,
    reproduction,
    residue_sums,
    smoothness,
    smoothness_spectrum,
    stability,
    sum_rules,
)
from subdiv_cli.stages.stage import Stage

SCALAR: tuple[Stage, ...] = (
    residue_sums.run,
    sum_rules.run,
    generation.run,
    reproduction.run,
    derived.run,
    independence.run,
    stability.run,
    reduction.run,
    eigenvalues.run,
    contractivity.run,
    convergence.run,
    smoothness.run,
    next_smoothness.run,
    smoothness_spectrum.run,
    holder_lower.run,
    holder_upper.run,
)


def analyse(scheme: ScalarScheme, effort: Effort) -> tuple[Mapping[str, Data], tuple[Finding, ...]]:
    """The facts of the mask, and what all stages find under the effort."""
    numbers = ScalarNumbers(scheme, effort)
    found: dict[str, tuple[Finding, ...]] = {}
    for stage in SCALAR:
        for finding in stage(numbers, found):
            found[finding.code] = (*found.get(finding.code, ()), finding)
    return mask_facts(scheme), tuple(finding for findings in found.values() for finding in findings)
