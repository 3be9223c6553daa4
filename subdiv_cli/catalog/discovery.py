"""Discovery: from arguments of the command line to mask files, in a stable order and once each."""

from __future__ import annotations

import os
import re
from collections.abc import Container, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from subdiv_cli.catalog.exclusion import Exclusion, ignored_by_git
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_FILE_BYTES
from subdiv_cli.maskfile.problems import unreadable
from subdiv_cli.maskfile.recognise import is_mask
from subdiv_cli.model import Problem

_PATTERN = re.compile(r"[*?\[]")
_ANYTHING = re.compile(r"\*\*/?$")


class Discovery(NamedTuple):
    """The files that the arguments name."""

    entries: tuple[str | Problem, ...]
    """The paths for `maskfile.read_path` ("-" is standard input), or problems, in the order of the arguments."""
    skipped: int = 0
    """The number of `*.toml` files met in directories that are no masks."""
    left_out: int = 0
    """The number of `*.toml` files and of directories that are excluded, or that git ignores."""


def discover(paths: Iterable[str | Path], exclude: Iterable[str] = ()) -> Discovery:
    """The files and problems of all arguments.

    A directory is searched recursively for `*.toml` that are meant as masks (`is_mask`), sorted by path; hidden files
    and directories are left out, and what `exclude` has a pattern for or git ignores; links are followed once. A
    pattern (`masks/**/*.toml`) names the files and directories that match. A file named explicitly is always an entry:
    whether it is a mask, the reader says (SD016).

    Problems: SD002 for what is missing or unreadable, SD014 for a directory without masks and a pattern that nothing
    matches. Never raises for what is on disk.
    """
    collection = _Collection(Exclusion(exclude))
    for path in map(str, paths):
        try:
            if not path:
                collection.entries.append(_NAMELESS)
            elif path != "-" and Path(path).is_dir():
                collection.search(path)
            elif _PATTERN.search(path) and not os.path.lexists(path):
                collection.match(path)
            else:
                collection.add(path, _identity(path))
        except OSError as error:
            collection.entries.append(unreadable(path, error))
        except ValueError:  # a null character in the name
            collection.entries.append(unreadable(path, FileNotFoundError()))
    return Discovery(entries=tuple(collection.entries), skipped=collection.skipped, left_out=collection.left_out)


_NAMELESS = faults.UNREADABLE_FILE.problem(
    "the name of a file is empty", "is it a variable that is not set? the directory here is .", file='""'
)
"""The problem of an empty name, which does not mean the directory here, as `Path("")` does."""


class _Collection:
    """The entries so far, with the identities of their files."""

    def __init__(self, exclusion: Exclusion) -> None:
        self.entries: list[str | Problem] = []
        self.skipped = self.left_out = 0
        self._exclusion = exclusion
        self._seen: set[object] = set()

    def add(self, path: str, identity: object) -> None:
        """Add a file, unless it is there under another name."""
        if identity not in self._seen:
            self._seen.add(identity)
            self.entries.append(path)

    def match(self, pattern: str) -> None:
        """Add what a pattern names, files and directories, by name; or the problem that it names nothing."""
        from glob import glob

        matches = sorted(glob(pattern, recursive=True))  # noqa: PTH207 (patterns may be absolute)
        for path in matches:
            if Path(path).is_dir():
                if not _ANYTHING.search(pattern):  # its files match too
                    self.search(path)
            else:
                self.add(path, _identity(path))
        if not any(not Path(path).is_dir() or not _ANYTHING.search(pattern) for path in matches):
            help = "patterns are as in a shell, ** for any depth; quote them to have them read here"
            self.entries.append(faults.NO_MASKS.problem("no file matches this", help, file=pattern))

    def search(self, directory: str) -> None:
        """Add the masks below a directory, or the problem that there are none."""
        masks = others = 0
        before = self.left_out
        for entry in self._below(Path(directory), set(), ignored_by_git(directory)):
            if isinstance(entry, Problem):
                self.entries.append(entry)
            elif _looks_like_mask(entry):
                masks += 1
                try:
                    self.add(str(entry), _identity(str(entry)))
                except OSError:  # a dangling link: the reader says so
                    self.entries.append(str(entry))
            else:
                others += 1
        self.skipped += others
        if not masks:
            self.entries.append(_without_masks(directory, others, self.left_out - before))

    def _below(self, directory: Path, visited: set[object], ignored: Container[Path]) -> Iterator[Path | Problem]:
        """The visible `*.toml`, files of a directory before its subdirectories, by name; no directory twice."""
        try:
            same = _identity(str(directory))
            if same in visited:
                return
            visited.add(same)
            with os.scandir(directory) as scan:
                children = sorted(entry.name for entry in scan if not entry.name.startswith("."))
        except OSError as error:
            yield unreadable(str(directory), error)
            return
        below = []
        for child in (directory / name for name in children):
            is_directory = child.is_dir()
            if not is_directory and child.suffix != ".toml":
                continue
            if child in ignored or self._exclusion.covers(child):
                self.left_out += 1
            elif is_directory:
                below.append(child)
            else:
                yield child
        for child in below:
            yield from self._below(child, visited, ignored)


def _identity(path: str) -> object:
    """A key that is equal for two names of one file. Raises OSError."""
    if path == "-":
        return path
    status = Path(path).stat()
    return status.st_dev, status.st_ino


def _looks_like_mask(path: Path) -> bool:
    """Whether a file looks like a mask; an unreadable one does: the reader then says why it cannot be read."""
    try:
        if not path.is_file() and path.exists():  # a pipe or a device would block
            return False
        with path.open("rb") as stream:
            return is_mask(stream.read(MAX_FILE_BYTES))
    except OSError:
        return True


def _without_masks(path: str, others: int, left_out: int) -> Problem:
    """The problem of a directory in which there are no masks."""
    if left_out:
        help = "a file or directory that is named itself is always checked"
        what = f"what was left out: {left_out} that git ignores, or exclude has a pattern for"
        return faults.NO_MASKS.problem(f"no mask files in this directory besides {what}", help, file=path)
    what = f" ({others} other TOML files)" if others > 1 else " (one other TOML file)" if others else ""
    help = "a mask file is a *.toml with kind or mask at the top; name another directory or a file"
    return faults.NO_MASKS.problem(f"no mask files in this directory{what}", help, file=path)
