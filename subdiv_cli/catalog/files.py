"""Writing of files, whole or not at all, and the names of certificates."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from subdiv_cli.model import Result
from subdiv_cli.model.closed import rational

_LONGEST = 200
"""The most bytes of a name for which the name of its unfinished file, which is longer, is one too."""


def write_whole(file: str | Path, content: str | bytes | Iterable[str], *, durable: bool = True) -> None:
    """Write a file so that it is the old one or the new one and never a part; after an OSError it is the old one.

    The content may come in pieces.
    What is not a plain file (a pipe, /dev/stdout) is written to as it is. `durable`: whole also after a power cut.
    """
    data: Iterable[bytes]
    if isinstance(content, bytes):
        data = (content,)
    else:
        texts = (content,) if isinstance(content, str) else content
        data = (text.encode("utf-8", "backslashreplace") for text in texts)
    path = Path(os.path.realpath(file))
    if path.exists() and not path.is_file():
        with path.open("wb") as there:
            there.writelines(data)
        return
    name = path.name if len(os.fsencode(path.name)) <= _LONGEST else path.name[:50]
    part = path.with_name(f".{name}.{os.getpid()}.part")
    try:
        with part.open("xb") as new:
            new.writelines(data)
            new.flush()
            if durable:
                os.fsync(new.fileno())
        if path.exists():
            part.chmod(path.stat().st_mode & 0o7777)
        part.replace(path)
    except BaseException:
        with suppress(OSError):
            part.unlink()
        raise


class CertificateDirectory:
    """A directory that takes one certificate for each mask of a run, named after the mask's file."""

    def __init__(self, directory: str) -> None:
        """Make the directory. Raises OSError."""
        self._directory = Path(directory)
        self._directory.mkdir(parents=True, exist_ok=True)
        self._taken: set[str] = set()

    def write(self, result: Result, text: str) -> str:
        """The name of the file to which the certificate of a mask is written. Raises OSError.

        It is that of the mask's file, with the parameters that vary in the run; masks of one name get numbers.
        """
        stem = {"-": "stdin", "--mask": "mask"}.get(result.file) or Path(result.file).stem
        stem += "".join(f"-{name}={rational(result.parameters[name])}" for name in result.varied).replace("/", "_")
        name, number = stem, 1
        while name in self._taken:
            number += 1
            name = f"{stem}-{number}"
        self._taken.add(name)
        path = self._directory / f"{name}.json"
        write_whole(path, text)
        return str(path)
