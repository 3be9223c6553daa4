"""The order of results: that of the tasks, whatever the order in which they are done."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from subdiv_cli.catalog.task import Done, Task

WINDOW = 200
"""The most masks that may be done before one that is not, and wait for it."""

Numbered = Sequence[tuple[int, Task]]
"""The tasks, each with its place in the order of the results."""


class Order:
    """The results that are done and wait, and the number of the next."""

    def __init__(self) -> None:
        self.next = 0
        """The number of the next result: everything before it has been handed on."""
        self._waiting: dict[int, Done] = {}

    def admits(self, number: int) -> bool:
        """Whether a task may begin: one too far ahead would have to be kept in memory."""
        return number < self.next + WINDOW

    def add(self, number: int, done: Done) -> None:
        """Add the result of a task."""
        self._waiting[number] = done

    def ready(self) -> Iterator[Done]:
        """The results that can be handed on now."""
        while self.next in self._waiting:
            done = self._waiting.pop(self.next)
            self.next += 1
            yield done

    def rest(self) -> Iterator[Done]:
        """The results that are done at an early end, in order, with gaps where one is not."""
        for number in sorted(self._waiting):
            yield self._waiting.pop(number)


def in_order(stream: Callable[[Order], Iterator[tuple[int, Done]]], on_done: Callable[[Done], None]) -> Iterator[Done]:
    """The results of a stream of numbered ones, in order; `on_done` is called with each as soon as it is done.

    Ctrl-C, here or thrown in by who iterates, ends the stream; what is done comes then, and KeyboardInterrupt last.
    """
    order = Order()
    source = stream(order)
    try:
        for number, done in source:
            order.add(number, done)
            on_done(done)
            yield from order.ready()
    except KeyboardInterrupt:
        source.close()  # type: ignore[attr-defined]
        yield from order.rest()
        raise
