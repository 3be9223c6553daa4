"""Tasks on a Dask cluster, for more masks than one machine is for; the extra `dask` installs what this needs."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from importlib import import_module
from typing import Any

from subdiv_cli.catalog.ordered import Numbered, Order
from subdiv_cli.catalog.pool import lost
from subdiv_cli.catalog.task import Done, Settings, Task, invalid, perform
from subdiv_cli.maskfile import MaskFileError, load_path

AHEAD = 4
"""Tasks under way for each thread of the cluster: enough that none waits for the network."""
TIMEOUT = 10
"""Seconds to find the scheduler."""


class ClusterError(Exception):
    """The cluster cannot be used; the text says why."""


class Cluster:
    """A scheduler somewhere, its workers with the same version of this package."""

    def __init__(self, address: str, tasks: Numbered, settings: Settings) -> None:
        self.address, self.tasks, self.settings = address, tasks, settings

    def stream(self, order: Order) -> Iterator[tuple[int, Done]]:
        """Numbered results as they are done. Raises ClusterError."""
        try:
            distributed: Any = import_module("distributed")
        except ImportError:
            raise ClusterError("--dask needs the extra dask: pip install 'subdiv-cli[dask]'") from None
        try:
            client = distributed.Client(self.address, timeout=TIMEOUT, set_as_default=False)
        except (OSError, ValueError, TimeoutError) as error:
            raise ClusterError(f"no scheduler answers at {self.address}: {error}") from None
        try:
            threads = sum(client.nthreads().values())
            yield from self._run(client, distributed.as_completed(raise_errors=False), order, max(1, threads) * AHEAD)
        finally:
            with suppress(Exception):
                client.close(timeout=TIMEOUT)

    def _run(self, client: Any, futures: Any, order: Order, width: int) -> Iterator[tuple[int, Done]]:
        running: dict[str, tuple[int, Task]] = {}
        taken = 0

        def submit() -> Iterator[tuple[int, Done]]:
            nonlocal taken
            while taken < len(self.tasks) and len(running) < width and order.admits(self.tasks[taken][0]):
                (number, task), taken = self.tasks[taken], taken + 1
                try:  # the file is here, and need not be there
                    task = task._replace(data=load_path(task.file)) if task.mask is None and task.data is None else task
                except MaskFileError as error:
                    yield number, Done(invalid(task.file, error.problems))
                    continue
                future = client.submit(perform, task, self.settings, pure=False, retries=0)
                running[future.key] = (number, task)
                futures.add(future)

        yield from submit()
        while running:
            future = next(futures)
            number, task = running.pop(future.key)
            yield number, self._result(future, task)
            yield from submit()

    def _result(self, future: Any, task: Task) -> Done:
        if future.status == "finished":
            done: Done = future.result()
            return done
        error = future.exception() if future.status == "error" else None
        return Done(lost(task.file, f"the cluster lost it ({type(error).__name__ if error else future.status})"))
