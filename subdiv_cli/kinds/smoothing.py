"""Schemes -> smoother schemes, and back to derived ones, step by step, each by the procedure of its kind."""

from __future__ import annotations

from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.kind import NotSmoothedError, Scheme, SmoothingStep


def smoothing_steps(scheme: Scheme, times: int, *, inverse: bool = False) -> tuple[SmoothingStep, ...]:
    """The steps by which a scheme is smoothed so many times, or derived if `inverse`; its kind declares `smoothing`.

    Raises NotSmoothedError where a hypothesis of a procedure fails.
    """
    steps: list[SmoothingStep] = []
    while len(steps) < times:
        smoothing = kind_of(scheme).smoothing
        assert smoothing is not None, "a mask of a kind that cannot be smoothed is not read"
        try:
            steps.append((smoothing.derived if inverse else smoothing.smoother)(scheme))
        except NotSmoothedError as error:
            raise NotSmoothedError(f"in step {len(steps) + 1} {error}" if times > 1 else str(error)) from None
        scheme = steps[-1].scheme
    return tuple(steps)
