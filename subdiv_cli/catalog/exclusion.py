"""What a search of directories leaves out: what patterns exclude, and what git ignores. Nothing named is left out."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path

_TOKENS = re.compile(r"\*\*/|\*\*|\*|\?|\[[^]/]+\]|.", re.DOTALL)
_WILD = {"**/": "(?:.*/)?", "**": ".*", "*": "[^/]*", "?": "[^/]"}
_SECONDS = 60
"""The time that git may take."""


class Exclusion:
    """The patterns of names and of paths: `old_*.toml`, `drafts`, `masks/**/*_old.toml`.

    A pattern without a slash is for the name of a file or directory at any depth, one with a slash for its path from
    the working directory. `*` and `?` stand for anything but a slash, `**` for anything.
    """

    def __init__(self, patterns: Iterable[str]) -> None:
        names, paths = [], []
        for pattern in patterns:
            meant = pattern.replace(os.sep, "/").rstrip("/")
            if "/" in meant:
                paths.append(_expression(_absolute(meant)))
            elif meant:
                names.append(_expression(meant))
        self._names, self._paths = _any_of(names), _any_of(paths)

    def covers(self, path: Path) -> bool:
        """Whether a file or directory is excluded."""
        return bool(self._names.fullmatch(path.name) or self._paths.fullmatch(_absolute(str(path))))


def _absolute(path: str) -> str:
    return os.path.abspath(path).replace(os.sep, "/")  # noqa: PTH100 (links stay)


def _expression(pattern: str) -> str:
    """The regular expression of a pattern."""
    return "".join(map(_spelled, _TOKENS.findall(pattern)))


def _spelled(token: str) -> str:
    if token[0] == "[" and len(token) > 1:
        inner = token[1:-1].replace("\\", "\\\\")
        return f"[^{inner[1:]}]" if inner[0] == "!" else f"[{inner}]"
    return _WILD.get(token) or re.escape(token)


def _any_of(expressions: list[str]) -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{each})" for each in expressions) or "(?!)", re.DOTALL)


def ignored_by_git(directory: str) -> frozenset[Path]:
    """The files and directories below a directory that git ignores; none where there is no repository, or no git.

    A directory that is ignored itself was named, and has nothing that is ignored.
    """
    import subprocess  # a whole module for this alone

    options = ("-c", "core.fsmonitor=false")  # else a repository may name a program to be run
    wanted = ("ls-files", "-z", "--others", "--ignored", "--exclude-standard", "--directory")
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}  # those of a hook
    try:
        resolved = Path(directory).resolve()
        if not any((above / ".git").exists() for above in (resolved, *resolved.parents)):
            return frozenset()
        done = subprocess.run(
            ["git", *options, *wanted],
            cwd=directory, env=inherited, stdin=subprocess.DEVNULL, capture_output=True, check=True, timeout=_SECONDS,
        )  # fmt: skip
    except (OSError, subprocess.SubprocessError):
        return frozenset()
    names = (os.fsdecode(name) for name in done.stdout.split(b"\0") if name not in (b"", b"./"))
    return frozenset(Path(directory, name) for name in names)
