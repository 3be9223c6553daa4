"""Whether a TOML file is meant as a mask: a search through a directory asks before it reads."""

from __future__ import annotations

import re

MARKS = ("kind", "mask", "matrices")
"""A mask file has one of these at its top level."""

_HEADER = re.compile(rb"\s*\[")
_MASK_HEADER = re.compile(rb"""\s*\[\s*["']?mask["']?\s*[\].]""")
_MARK = re.compile(rb"""\s*["']?(?:kind|mask|matrices)["']?\s*[.=]""")


def is_mask(data: bytes) -> bool:
    """Whether the bytes look like a mask file, broken ones included; decided line by line, never by parsing."""
    top = True
    for line in data.removeprefix(b"\xef\xbb\xbf").split(b"\n"):
        if _MASK_HEADER.match(line) or (top and _MARK.match(line)):
            return True
        if _HEADER.match(line) and b"=" not in line and line.split(b"#")[0].rstrip().endswith(b"]"):
            top = False
    return False
