"""A pool of processes for tasks. A process that dies costs the mask it was at work on, and another takes its place.

`concurrent.futures` gives up the whole pool when one process is killed and does not say at which task; here each
process has a pipe of its own and one task at a time.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from typing import Any, NamedTuple

from subdiv_cli.catalog.ordered import Numbered, Order
from subdiv_cli.catalog.task import Done, Settings, Task, invalid, perform
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.model import Result, Verdict, watch
from subdiv_cli.model.watch import At

MOST_TASKS = 1000
"""The tasks after which a process is replaced, so that what leaks does not add up."""
PATIENCE = (2.0, 5.0)
"""A factor and seconds: a process that is not done after the budget times the one plus the other is ended.

A mask over its budget ends by itself, with what is decided by then; such a one is in a step that nothing interrupts.
"""


class Worker:
    """A process, the pipe to it, and its task."""

    def __init__(self, settings: Settings, others: Sequence[Worker], watched: bool) -> None:
        context = _context()
        self.connection, theirs = context.Pipe()
        forked = context.get_start_method() == "fork"
        inherited = [self.connection, *(worker.connection for worker in others)] if forked else []
        self.process = context.Process(target=_work, args=(theirs, inherited, settings, watched), daemon=True)
        for stream in (sys.stdout, sys.stderr):
            with suppress(OSError, ValueError):
                stream.flush()  # else a forked process has it too
        self.process.start()
        theirs.close()
        self.task: tuple[int, Task] | None = None
        self.since = 0.0
        self.tasks = 0

    def begin(self, numbered: tuple[int, Task]) -> None:
        """Send a task. Raises OSError where the process is gone."""
        self.task, self.since = numbered, time.monotonic()
        self.tasks += 1
        self.connection.send(numbered[1])

    def end(self) -> None:
        """End the process, which has nothing more to do, or is not to do it."""
        self.connection.close()
        if self.process.is_alive():
            self.process.kill()
        self.process.join()


def _context() -> Any:
    """The way to start processes: forking is quick, and safe where nothing else runs in this process."""
    forks = sys.platform == "linux" and threading.active_count() == 1
    return get_context("fork" if forks else "spawn")


def _work(connection: Connection, inherited: Sequence[Connection], settings: Settings, watched: bool) -> None:
    """Perform tasks in the process until the pipe is closed. Ctrl-C is the parent's affair.

    What they are at is sent too where somebody watches.
    """
    watch.listen(connection.send if watched else None)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for other in inherited:  # a pipe that a sibling holds open would never end
        other.close()
    with suppress(EOFError, OSError):
        while True:
            connection.send(perform(connection.recv(), settings))
    os._exit(0)


class Pool:
    """A number of workers, and the tasks that none of them has yet."""

    def __init__(self, tasks: Numbered, settings: Settings, jobs: int) -> None:
        self.tasks, self.settings = tasks, settings
        self.jobs = min(jobs, len(tasks))
        self.workers: list[Worker] = []
        self.taken = 0
        self.done = 0

    def stream(self, order: Order) -> Iterator[tuple[int, Done]]:
        """The numbered results as they are done."""
        try:
            while self.done < len(self.tasks):
                self._hand_out(order)
                for number, done in self._collect():
                    self.done += 1
                    yield number, done
        finally:
            for worker in self.workers:
                worker.end()

    def _hand_out(self, order: Order) -> None:
        """Send a task to every worker without one, and start as many workers as are wanted."""
        while len(self.workers) < self.jobs and self.taken < len(self.tasks):
            self.workers.append(Worker(self.settings, self.workers, self.jobs == 1 and watch.is_heard()))
            self._next(self.workers[-1], order)
        for worker in self.workers:
            if worker.task is None:
                self._next(worker, order)

    def _next(self, worker: Worker, order: Order) -> None:
        if self.taken < len(self.tasks) and order.admits(self.tasks[self.taken][0]):
            numbered, self.taken = self.tasks[self.taken], self.taken + 1
            with suppress(OSError):  # it has died between two tasks: found out when its pipe is read
                worker.begin(numbered)

    def _collect(self) -> Iterator[tuple[int, Done]]:
        """The results that have come in by now, and those of tasks whose process ended; waits for the first."""
        busy = {worker.connection: worker for worker in self.workers if worker.task is not None}
        for ready in wait(list(busy), timeout=self._timeout()):
            worker = busy[ready]
            assert worker.task is not None
            number, task = worker.task
            try:
                done: Done | At = worker.connection.recv()
            except (EOFError, OSError):
                done = Done(_lost(task, worker), seconds=time.monotonic() - worker.since)
                self._remove(worker)
            else:
                if isinstance(done, At):
                    watch.tell(done)
                    continue
                worker.task = None
                if worker.tasks >= MOST_TASKS:
                    self._remove(worker)
            yield number, done
        yield from self._overdue()

    def _remove(self, worker: Worker) -> None:
        worker.end()
        self.workers.remove(worker)

    def _timeout(self) -> float | None:
        return None if self.settings.seconds is None else 0.2

    def _overdue(self) -> Iterator[tuple[int, Done]]:
        """The results of the tasks that the budget did not end, whose processes are ended."""
        if self.settings.seconds is None:
            return
        longest = self.settings.seconds * PATIENCE[0] + PATIENCE[1]
        for worker in list(self.workers):
            if worker.task is not None and time.monotonic() - worker.since > longest:
                self._remove(worker)
                number, task = worker.task
                yield number, Done(_stopped(task), seconds=longest)


class _Fate(NamedTuple):
    code: int | None

    def __str__(self) -> str:
        if self.code is None or self.code >= 0:
            return f"ended with exit code {self.code}"
        with suppress(ValueError):
            return f"was killed by {signal.Signals(-self.code).name}"
        return f"was killed by signal {-self.code}"


def _lost(task: Task, worker: Worker) -> Result:
    """The result of a mask whose worker died over it: nothing is known of the mask."""
    worker.process.join(1)
    return lost(task.file, f"the process that checked it {_Fate(worker.process.exitcode)}")


def lost(file: str, why: str) -> Result:
    """The result of a mask whose process is gone."""
    return invalid(file, (faults.WORKER_LOST.problem(f"not checked: {why}", file=file),))


def _stopped(task: Task) -> Result:
    """The undecided result of a mask that the budget ended before anything was decided."""
    known: dict[str, Any] = {"parameters": task.overrides, "varied": task.varied}
    return Result(file=task.file, status="undecided", stopped="budget", convergent=Verdict.UNDECIDED, **known)
