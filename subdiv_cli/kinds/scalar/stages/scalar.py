"""The stages of scalar schemes in one variable, in order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from subdiv_cli.kinds.scalar.numbers.facts import facts as mask_facts
from subdiv_cli.kinds.scalar.numbers.hints import hints as mask_hints
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages import (
    attained,
    contractivity,
    convergence,
    derived,
    eigenvalues,
    generation,
    holder_lower,
    holder_upper,
    independence,
    joint_radius,
    next_smoothness,
    reduction,
    reproduction,
    residue_sums,
    smoothness,
    smoothness_spectrum,
    sobolev,
    stability,
    sum_rules,
)
from subdiv_cli.kinds.scalar.stages.stage import Stage
from subdiv_cli.model import Data, Effort, Finding

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


class Analysis(NamedTuple):
    """What there is to say about a scheme before anybody expects anything of it."""

    facts: Mapping[str, Data]
    hints: tuple[str, ...]
    findings: tuple[Finding, ...]
    """In the order of the stages: each speaks of what earlier ones introduced."""
    numbers: ScalarNumbers


def analyse(scheme: ScalarScheme, effort: Effort, more: Sequence[Stage] = ()) -> Analysis:
    """All stages under the effort, and after them some more."""
    numbers = ScalarNumbers(scheme, effort)
    found: dict[str, tuple[Finding, ...]] = {}
    for stage in (*SCALAR, *more):
        for finding in stage(numbers, found):
            found[finding.code] = (*found.get(finding.code, ()), finding)
    findings = tuple(finding for several in found.values() for finding in several)
    return Analysis(mask_facts(scheme), mask_hints(scheme), findings, numbers)
