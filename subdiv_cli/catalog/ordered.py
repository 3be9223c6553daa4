"""Results in the order of the tasks, whatever the order in which they are done."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from subdiv_cli.catalog.task import Done, Task

WINDOW = 200
"""So many masks may be done before one that is not, and wait for it."""

Numbered = Sequence[tuple[int, Task]]
"""Tasks, each with its place in the order of the results."""


class Order:
    """What is done, and what comes next."""

    def __init__(self) -> None:
        self.next = 0
        """Everything before it has been handed on."""
        self._waiting: dict[int, Done] = {}

    def admits(self, number: int) -> bool:
        """Whether a task may begin: one too far ahead would have to be kept in memory."""
        return number < self.next + WINDOW

    def add(self, number: int, done: Done) -> None:
        """A task is done."""
        self._waiting[number] = done

    def ready(self) -> Iterator[Done]:
        """What can be handed on now."""
        while self.next in self._waiting:
            done = self._waiting.pop(self.next)
            self.next += 1
            yield done

    def rest(self) -> Iterator[Done]:
        """At an early end: what is done, in order, with gaps where something is not."""
        for number in sorted(self._waiting):
            yield self._waiting.pop(number)


def in_order(stream: Callable[[Order], Iterator[tuple[int, Done]]], on_done: Callable[[Done], None]) -> Iterator[Done]:
    """The results of a stream of numbered ones, in order; `on_done` hears of each as soon as it is done.

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
