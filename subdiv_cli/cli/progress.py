"""The progress of what takes long: a line on stderr, on a terminal only; and afterwards the masks that took longest."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from heapq import nlargest
from typing import TYPE_CHECKING, TextIO

from subdiv_cli.cli.streams import columns, emit, speaks_mathematics
from subdiv_cli.model import watch
from subdiv_cli.report.letters import letters

if TYPE_CHECKING:
    from subdiv_cli.catalog.task import Done
    from subdiv_cli.model.watch import At

SLOWEST = 5
"""The number of the slowest masks that are named under -v."""
PAUSE = 0.1
"""The seconds between two writings."""
PATIENCE = 1.0
"""The seconds that one mask may take before it is shown what it is at."""


class Progress:
    """The progress of a run, which is called for every mask that is done."""

    def __init__(self, stream: TextIO | None = None) -> None:
        self.stream = sys.stderr if stream is None else stream
        self.shown = self.stream.isatty() and os.environ.get("TERM") != "dumb"
        self.total = self.done = self.missed = self.cached = 0
        self.slowest: list[tuple[float, str]] = []
        self._written = 0
        self._last = 0.0
        self._began = time.monotonic()

    def begin(self, total: int) -> None:
        """Set the number of masks."""
        self.total = total

    def step(self, done: Done) -> None:
        """Count one more mask that is done."""
        self.done += 1
        self.missed += done.result.status != "passed"
        self.cached += done.cached
        self.slowest = nlargest(SLOWEST, [*self.slowest, (done.seconds, done.result.file)])
        self._began = time.monotonic()
        if self.shown and self.total > 1 and time.monotonic() - self._last >= PAUSE:
            self._last = time.monotonic()
            self._write(self.line())

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Show what the work inside is at, where it takes long; the line is gone when it is done."""
        if self.shown:
            watch.listen(self.hear)
        try:
            yield
        finally:
            watch.listen(None)
            self.close()

    def hear(self, at: At) -> None:
        """Show what the mask that is looked at is at, and for how long: `joint radius, 312 vertices, 4 s`."""
        now = time.monotonic()
        if now - self._began >= PATIENCE and now - self._last >= PAUSE:
            self._last = now
            text = f"{at}, {now - self._began:.0f} s"
            self._write(f"{self.line()}; {text}" if self.done else text)

    def line(self) -> str:
        """The line of the progress: `37/120 masks, 2 not passed, slowest six_point.toml 1.2 s`."""
        text = f"{self.done}/{self.total} masks"
        if self.missed:
            text += f", {self.missed} not passed"
        seconds, file = self.slowest[0]
        return f"{text}, slowest {file} {seconds:.1f} s"

    def _write(self, text: str) -> None:
        text = letters(text, speaks_mathematics(self.stream))[: max(columns(self.stream) - 1, 1)]
        self.stream.write("\r" + text.ljust(self._written))
        self.stream.flush()
        self._written = len(text)

    def close(self) -> None:
        """Wipe the line away."""
        if self._written:
            self.stream.write("\r" + " " * self._written + "\r")
            self.stream.flush()
            self._written = 0

    def tell(self) -> None:
        """Write, under -v, how many masks came from the cache, and which took longest."""
        if self.done < 2:
            return
        unicode = speaks_mathematics(self.stream)
        if self.cached:
            emit(f"{self.cached} of {self.done} masks from the cache, verified again\n", self.stream)
        for seconds, file in self.slowest:
            emit(letters(f"{seconds:8.3f} s  {file}", unicode) + "\n", self.stream)
