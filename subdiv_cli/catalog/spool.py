"""Long sequences in little memory: all but the first values lie in a temporary file, and are read again when asked for.

The file has no name, or loses it at once, so that nothing of it is left however the program ends.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from os import SEEK_END
from typing import IO, Generic, TypeVar, overload

T = TypeVar("T")
U = TypeVar("U")

KEPT = 64
"""The most values that are kept in memory: most runs need no file."""


class _Lazy(Sequence[T]):
    """A sequence whose values are made one by one, by `_at`."""

    def _at(self, index: int) -> T:
        raise NotImplementedError

    @overload
    def __getitem__(self, index: int) -> T: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[T]: ...
    def __getitem__(self, index: int | slice) -> T | Sequence[T]:
        places = range(len(self))[index]
        return self._at(places) if isinstance(places, int) else [self._at(place) for place in places]

    def __iter__(self) -> Iterator[T]:
        return map(self._at, range(len(self)))


class Spool(_Lazy[T]):
    """A sequence that grows at its end, of values that can be pickled."""

    def __init__(self) -> None:
        self._places: list[tuple[int, int] | tuple[T]] = []
        """For each value its place and its size in the file, or the value itself."""
        self._file: IO[bytes] | None = None

    def append(self, value: T) -> None:
        """Add a value, in memory where it is among the first or the disk is full."""
        if len(self._places) >= KEPT:
            with suppress(OSError):
                self._places.append(self._written(value))
                return
        self._places.append((value,))

    def _written(self, value: T) -> tuple[int, int]:
        """The place in the file to which a value was written, and its size there. Raises OSError."""
        import pickle  # like the others only where there are many

        if self._file is None:
            from tempfile import TemporaryFile
            from weakref import finalize

            self._file = TemporaryFile(prefix="subdiv-", buffering=0)  # noqa: SIM115 (closed in the next line)
            finalize(self, self._file.close)
        data = pickle.dumps(value, pickle.HIGHEST_PROTOCOL)
        place = self._file.seek(0, SEEK_END)
        if self._file.write(data) < len(data):
            raise OSError("the disk is full")
        return place, len(data)

    def _at(self, index: int) -> T:
        match self._places[index]:
            case (value,):
                return value
            case (place, size):
                import pickle

                assert self._file is not None
                self._file.seek(place)
                read: T = pickle.loads(self._file.read(size))
                return read

    def __len__(self) -> int:
        return len(self._places)


class Mapped(_Lazy[U], Generic[T, U]):
    """The values of a sequence under a function, which is called whenever one is asked for."""

    def __init__(self, function: Callable[[T], U], values: Sequence[T]) -> None:
        self._function, self._values = function, values

    def _at(self, index: int) -> U:
        return self._function(self._values[index])

    def __len__(self) -> int:
        return len(self._values)
