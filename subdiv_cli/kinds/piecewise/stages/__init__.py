"""The stages of piecewise schemes: a function `run(numbers, facts)` for each theorem, in order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from subdiv_cli.kinds.kind import Analysis, Stage, run_stages
from subdiv_cli.kinds.piecewise.numbers.piecewise import PiecewiseNumbers
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.kinds.piecewise.stages import near_zero, smoothness
from subdiv_cli.model import Data, Effort

STAGES: tuple[Stage, ...] = (
    near_zero.sides,
    near_zero.local_spectrum,
    near_zero.convergence,
    near_zero.value_at_zero,
    near_zero.generation,
    smoothness.at_zero,
    smoothness.smoothness,
    smoothness.holder,
)


def analyse(scheme: PiecewiseScheme, effort: Effort, _: Fraction | None = None) -> Analysis:
    """The findings of all stages under the effort."""
    numbers = PiecewiseNumbers(scheme, effort)
    return Analysis(scheme, _facts(numbers), run_stages(numbers, STAGES), numbers, tuple(_hints(scheme)))


def _facts(numbers: PiecewiseNumbers) -> Mapping[str, Data]:
    scheme = numbers.scheme
    facts: dict[str, Data] = {"arity": numbers.p, "spacings": scheme.spacing}
    for name, mask in (("left_support", scheme.left), ("right_support", scheme.right)):
        facts[name] = (mask.start, mask.start + mask.degree)
    facts["special_rows"] = tuple(i for i, _ in scheme.special)
    if numbers.window is not None:
        facts["determined_by"] = numbers.closed_set
    return facts


def _hints(scheme: PiecewiseScheme) -> Iterator[str]:
    """What stands out: a special row where the mask of the side reads its own points alone."""
    for i, _ in scheme.special:
        read = [j for j, _ in scheme.ordinary(i)]
        if read and (min(read) > 0 if i >= 0 else max(read) < 0):
            side = "right" if i >= 0 else "left"
            yield f"special row {i} stands in for the {side} mask where that reads points of its own side alone"
