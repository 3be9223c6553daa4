"""Recognition of TOML files that are meant as masks, for the search through directories."""

from __future__ import annotations

import re

from subdiv_cli.maskfile.problems import near

MARKS = ("kind", "mask", "matrices")
"""The keys of which a mask file has one at its top level."""

_OWN = re.compile(r"masks?|coef[a-z]*|symbol|expect")
"""The keys and tables by which a file is meant as a mask, `kind` as a key too: it may lack the marks by mistake."""
_SHARED = {"parameters", "start", "arity"}
"""The keys that other programs' files have as well: they count where nothing foreign stands beside them."""
_BESIDE = {"format", "name", "reference", "convergent", "smoothness", "holder", "generation", "reproduction", "stable"}
_INSIDE = re.compile(r"arity|coef[a-z]*|symbol")
"""The keys that count in a table whose name resembles mask."""

_NAME = rb"""["']?([A-Za-z_][A-Za-z0-9_-]*)["']?[ \t]*"""
_HEADER = re.compile(rb"\s*\[\[?[ \t]*" + _NAME + rb"([\].]|\s*\Z)")
_KEY = re.compile(rb"\s*" + _NAME + rb"[.=]")


def is_mask(data: bytes) -> bool:
    """Whether the bytes look like a mask file, broken ones included; decided line by line, never by parsing.

    An empty file does, comments or not, since a gate would pass over a mask that was lost. A family of matrices, which
    has no kind, does not: it is for `subdiv jsr`. Case does not count.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):  # the reader says that it is not UTF-8
        data = data.decode("utf-16", "replace").encode()
    table: str | None = None
    top: set[str] = set()
    empty = True
    for line in data.removeprefix(b"\xef\xbb\xbf").split(b"\n"):
        code = line.split(b"#")[0].strip()
        empty &= not code
        header = _HEADER.match(line)
        if header and _OWN.fullmatch(_lower(header)):
            return True
        if code.startswith(b"[") and code.endswith(b"]") and b"=" not in code:
            table = _lower(header) if header else ""
            top.add(table)
        elif key := _KEY.match(line):
            name = _lower(key)
            if table is None:
                if name == "kind" or _OWN.fullmatch(name):
                    return True
                top.add(name)
            elif _INSIDE.fullmatch(name) and near(table, ("mask",)):
                return True
    return empty or (bool(top & _SHARED) and top <= _SHARED | _BESIDE)


def _lower(match: re.Match[bytes]) -> str:
    return match[1].decode("ascii").lower()
