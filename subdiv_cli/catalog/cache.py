"""Results of earlier runs, kept in files: an entry is used only where the checker verifies its certificate again.

The key is a hash of the file's bytes, the overrides, the settings that decide what is found, and the version. An entry
is a line and a compressed text in one file, written whole and replaced at once, so runs at the same time do no harm to
each other. Whatever is wrong with an entry, it is not used; whatever keeps one from being written, the run goes on.
"""

from __future__ import annotations

import json
import os
import sys
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import subdiv_cli
from subdiv_cli.catalog.files import write_whole
from subdiv_cli.catalog.record import UnreadableRecordError, decode, encode
from subdiv_cli.model import Expectation, Result

MOST_BYTES = 128 << 20
"""The most bytes of an entry, unpacked: a file that swells to more is none of ours."""
_SUFFIX = ".entry"
_TAG = "CACHEDIR.TAG"
_TAG_TEXT = "Signature: 8a477f597d28d172789f06886806bc55\n# Results of subdiv; `subdiv clean` removes them.\n"
"""The line by which backup programs know a cache."""


class Entry(NamedTuple):
    """A result as the pipeline gave it, before file and name are put in, and the text of its certificate."""

    result: Result
    certificate: str


def directory(given: str | None = None) -> str | None:
    """The directory of results: the one that is given, else among the user's caches; None for a user without a home."""
    if given is not None:
        return given
    with suppress(RuntimeError):
        return str(_of_user())
    return None


def _of_user() -> Path:
    """The directory XDG_CACHE_HOME, or what is usual on the system. Raises RuntimeError without a home."""
    if base := os.environ.get("XDG_CACHE_HOME"):
        return Path(base) / "subdiv"
    if sys.platform == "win32" and (base := os.environ.get("LOCALAPPDATA")):
        return Path(base) / "subdiv" / "cache"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "subdiv"
    return Path.home() / ".cache" / "subdiv"


def key(
    data: bytes, overrides: Mapping[str, Fraction], work: int, required: Sequence[Expectation], *, kind: str = "check"
) -> str:
    """The name of an entry."""
    inputs = {
        "kind": kind,
        "version": _version(),
        "file": sha256(data).hexdigest(),
        "overrides": {name: f"{v.numerator:x}/{v.denominator:x}" for name, v in sorted(overrides.items())},
        "work": work,
        "required": [f"{e.key} {e.text}" for e in required],
    }
    return sha256(json.dumps(inputs).encode()).hexdigest()


@cache
def _version() -> str:
    """The version; in a checkout, where code changes and the version does not, with the dates of the source files."""
    package = Path(subdiv_cli.__file__).parent
    if not (package.parent / "pyproject.toml").exists():
        return subdiv_cli.__version__
    dates = sha256()
    for file in sorted(package.rglob("*.py")):
        with suppress(OSError):
            status = file.stat()
            dates.update(f"{file.name} {status.st_size} {status.st_mtime_ns}\n".encode())
    return f"{subdiv_cli.__version__}+{dates.hexdigest()[:16]}"


class Cache:
    """A directory of entries."""

    def __init__(self, directory: str | Path) -> None:
        self.directory = Path(directory)

    def _file(self, name: str) -> Path:
        return self.directory / name[:2] / f"{name}{_SUFFIX}"

    def find(self, name: str) -> Entry | None:
        """The entry as it was written, or None. The caller has to verify it: `trust.trusted`."""
        try:
            head, _, packed = self._file(name).read_bytes().partition(b"\n")
            if head != _head(name, packed):
                return None
            unpacker = zlib.decompressobj()
            body = unpacker.decompress(packed, MOST_BYTES)
            if not unpacker.eof or unpacker.unused_data:
                return None
            first, _, certificate = body.partition(b"\n")
            result = decode(json.loads(first))
            return Entry(result, certificate.decode("utf-8")) if isinstance(result, Result) else None
        except (OSError, ValueError, zlib.error, UnreadableRecordError, RecursionError):
            return None

    def keep(self, name: str, entry: Entry) -> None:
        """Write an entry. Raises OSError."""
        body = json.dumps(encode(entry.result)).encode() + b"\n" + entry.certificate.encode("utf-8")
        packed = zlib.compress(body, 1)
        file = self._file(name)
        file.parent.mkdir(parents=True, exist_ok=True)
        tag = self.directory / _TAG
        if not tag.exists():
            write_whole(tag, _TAG_TEXT, durable=False)
        write_whole(file, _head(name, packed) + b"\n" + packed, durable=False)

    def clean(self) -> tuple[int, int]:
        """Remove every entry, and the directory if nothing else is in it; the number of entries and of their bytes.

        Nothing that is not an entry is touched, whatever directory was named. Raises OSError.
        """
        count = size = 0
        for file in self._entries():
            size += file.stat().st_size
            file.unlink()
            count += 1
        with suppress(OSError):
            (self.directory / _TAG).unlink()
        for directory in (*self.directory.glob("[0-9a-f][0-9a-f]"), self.directory):
            with suppress(OSError):
                directory.rmdir()
        return count, size

    def _entries(self) -> Iterator[Path]:
        """The files of finished entries, and of those that a killed run left behind half written."""
        for directory in sorted(self.directory.glob("[0-9a-f][0-9a-f]")):
            yield from sorted(directory.glob(f"*{_SUFFIX}"))
            yield from sorted(directory.glob(f".*{_SUFFIX}.*.part"))


def _head(name: str, packed: bytes) -> bytes:
    """The first line of an entry: a mark, the entry's own name, so that a copy under another is none, and a digest.

    The digest is of the packed bytes: a flipped bit of a deflate stream may well unpack to the same text.
    """
    return f"subdiv-cache 2 {name} {sha256(packed).hexdigest()}".encode("ascii")
