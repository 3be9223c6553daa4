"""Tasks on a Dask cluster, for more masks than one machine is for; the extra `dask` installs what this needs."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from importlib import import_module
from typing import Any

from subdiv_cli.catalog import ClusterError
from subdiv_cli.catalog.ordered import Numbered, Order
from subdiv_cli.catalog.pool import lost
from subdiv_cli.catalog.task import Done, Settings, Task, invalid, perform
from subdiv_cli.kinds.reading import load_path
from subdiv_cli.maskfile import MaskFileError

AHEAD = 4
"""The tasks under way for each thread of the cluster: enough that none waits for the network."""
TIMEOUT = 10
"""The seconds in which the scheduler must answer."""


class Cluster:
    """A Dask scheduler, its workers with the same version of this package."""

    def __init__(self, address: str, tasks: Numbered, settings: Settings) -> None:
        self.address, self.tasks, self.settings = address, tasks, settings

    def stream(self, order: Order) -> Iterator[tuple[int, Done]]:
        """The numbered results as they are done. Raises ClusterError."""
        try:
            distributed: Any = import_module("distributed")
        except ImportError:
            raise ClusterError("--dask needs the extra dask: pip install 'subdiv-cli[dask]'") from None
        try:
            client = distributed.Client(self.address, timeout=TIMEOUT, set_as_default=False)
        except (OSError, ValueError, TimeoutError) as error:
            raise ClusterError(f"no scheduler answers at {self.address}: {error}") from None
        try:
            run = _Run(client, self.settings, distributed.as_completed(loop=client.loop, raise_errors=False))
            yield from run.stream(self.tasks, order, max(1, sum(client.nthreads().values())) * AHEAD)
        finally:
            with suppress(Exception):
                client.close(timeout=TIMEOUT)


class _Run:
    """The tasks under way on the cluster, and those it has lost once."""

    def __init__(self, client: Any, settings: Settings, futures: Any) -> None:
        self.client, self.settings, self.futures = client, settings, futures
        self.running: dict[str, tuple[int, Task]] = {}
        self.suspects: list[tuple[int, Task]] = []
        """The tasks that were on a worker which died, all blamed by the scheduler: each is tried again, by itself."""

    def stream(self, tasks: Numbered, order: Order, width: int) -> Iterator[tuple[int, Done]]:
        """The results, at most `width` tasks at a time; then those of the suspects, which are run one by one."""
        taken = 0
        while True:
            while taken < len(tasks) and len(self.running) < width and order.admits(tasks[taken][0]):
                yield from self._submit(*tasks[taken])
                taken += 1
            if self.running:
                yield from self._collect(last=False)
            elif self.suspects:
                yield from self._submit(*self.suspects.pop(0))
                yield from self._collect(last=True)
            elif taken == len(tasks):
                return

    def _submit(self, number: int, task: Task) -> Iterator[tuple[int, Done]]:
        """The result of a task whose file cannot be read here; other tasks are sent with their bytes, without one."""
        try:
            if task.mask is None and task.data is None:
                task = task._replace(data=load_path(task.file))
        except MaskFileError as error:
            yield number, Done(invalid(task.file, error.problems))
            return
        future = self.client.submit(perform, task, self.settings, pure=False, retries=0)
        self.running[future.key] = (number, task)
        self.futures.add(future)

    def _collect(self, *, last: bool) -> Iterator[tuple[int, Done]]:
        """The result of the next task that ends, however it does."""
        future = next(self.futures)
        number, task = self.running.pop(future.key)
        if future.status == "finished":
            yield number, future.result()
        elif last:
            error = future.exception() if future.status == "error" else None
            why = type(error).__name__ if error else future.status
            yield number, Done(lost(task.file, f"the cluster lost it ({why})"))
        else:
            self.suspects.append((number, task))
