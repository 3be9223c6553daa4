"""The exit codes, by which a script learns the result of a run without reading it."""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from subdiv_cli.model import Status


class ExitCode(IntEnum):
    """An exit code: 2 beats 1 beats 3, and 130 beats all."""

    PASSED = 0
    """Every expectation is proved; or the command is done."""
    FAILED = 1
    """An expectation is refuted; or the answer is no."""
    ERROR = 2
    """The mask is not checked: usage, an unreadable or invalid mask, an internal error."""
    UNDECIDED = 3
    """Nothing is refuted, something undecided."""
    INTERRUPTED = 130
    """The run is ended by Ctrl-C."""


def exit_code(statuses: Iterable[Status], *, allow_undecided: bool = False, interrupted: bool = False) -> ExitCode:
    """The one exit code of a run over several masks."""
    seen = set(statuses)
    if interrupted:
        return ExitCode.INTERRUPTED
    if "invalid" in seen:
        return ExitCode.ERROR
    if "failed" in seen:
        return ExitCode.FAILED
    return ExitCode.UNDECIDED if "undecided" in seen and not allow_undecided else ExitCode.PASSED
