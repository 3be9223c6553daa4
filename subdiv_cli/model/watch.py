"""What a long computation is at, for those who wait for it.

Stages say that they begin, loops how far they are, and where the clock is looked at a listener hears of it. There is
none unless somebody waits at a terminal, and then a call costs next to nothing.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import NamedTuple

PAUSE = 0.1
"""The seconds between two tellings."""


class At(NamedTuple):
    """The place where a computation is: a stage, and how many things of a sort it has so far."""

    stage: str = ""
    number: int = 0
    things: str = ""

    def __str__(self) -> str:
        return f"{self.stage}, {self.number:,} {self.things}" if self.things else self.stage


Listener = Callable[[At], object]


class _Watch:
    """The one watch of the process."""

    def __init__(self) -> None:
        self.listener: Listener | None = None
        self.at = At()
        self.next = 0.0


_WATCH = _Watch()


def listen(listener: Listener | None) -> None:
    """Let a listener hear from now on what the computation is at; None ends that."""
    _WATCH.listener, _WATCH.at, _WATCH.next = listener, At(), 0.0


def is_heard() -> bool:
    """Whether there is a listener."""
    return _WATCH.listener is not None


def begin(stage: str) -> None:
    """Say that a stage begins."""
    tell(At(stage))


def count(number: int, things: str) -> None:
    """Say how many things of a sort the stage has so far, which is heard when the clock is looked at."""
    if _WATCH.listener is not None:
        _WATCH.at = At(_WATCH.at.stage, number, things)


def look() -> None:
    """Let the listener hear, unless it just has."""
    if _WATCH.listener is not None and time.monotonic() >= _WATCH.next:
        tell(_WATCH.at)


def tell(at: At) -> None:
    """Let the listener hear that the computation is here."""
    if _WATCH.listener is not None:
        _WATCH.at, _WATCH.next = at, time.monotonic() + PAUSE
        _WATCH.listener(at)
