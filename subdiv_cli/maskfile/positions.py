"""Where things stand in a file: a problem's line and column. Loaded only when there is a problem to show."""

from __future__ import annotations

import re

from subdiv_cli.maskfile.problems import Fault, KeyPath, Source, shown_path
from subdiv_cli.maskfile.scanner import Scan, scan
from subdiv_cli.model import Problem

_CONTINUATION = re.compile(r"\\[ \t]*\r?\n[ \t\r\n]*")
_ESCAPE_LENGTHS = {"u": 6, "U": 10, "x": 4}


class Positions:
    """Turns faults of one source into problems with positions; the text is scanned on first use."""

    def __init__(self, source: Source) -> None:
        self._source = source
        self._scan: Scan | None = None

    @property
    def scan(self) -> Scan:
        """The key paths of the text."""
        if self._scan is None:
            self._scan = scan(self._source.text)
        return self._scan

    def problem(self, fault: Fault, path: KeyPath = (), of_key: bool = False) -> Problem:
        """The problem of a fault in the value at `path` (or in its key); for an option, at its offset."""
        key = shown_path(path) or None
        if not self._source.toml:
            return self.at(fault.at if self._source.text else None, fault, key)
        spot = self.scan.spots.get(path)
        if spot is None:  # something is missing: the table where it should be
            spot, of_key = self.scan.spots.get(path[:-1]), True
        if spot is None:
            return self.at(None, fault, key)
        if of_key:
            return self.at(spot.key, fault, key)
        return self.at(spot.start + inner_offset(self._source.text[spot.start : spot.end], fault.at), fault, key)

    def at(self, offset: int | None, fault: Fault, key: str | None = None) -> Problem:
        """The problem of a fault at an offset of the text; None is nowhere in it."""
        line = column = source = None
        if offset is not None:
            line, column, source = line_and_column(self._source.text, offset)
        return fault.problem(file=self._source.file, key=key, line=line, column=column, source=source)


def line_and_column(text: str, offset: int) -> tuple[int, int, str]:
    """1-based line and column of an offset, and the text of that line."""
    start = text.rfind("\n", 0, offset) + 1
    end = text.find("\n", offset)
    return text.count("\n", 0, offset) + 1, offset - start + 1, text[start : end if end >= 0 else None].rstrip("\r")


def inner_offset(raw: str, n: int) -> int:
    """The offset in the TOML literal `raw` of the n-th character of the string it spells; 0 for other values."""
    if raw[:1] not in ('"', "'"):
        return 0
    quote = raw[:3] if raw[:3] in ('"""', "'''") else raw[0]
    i, end = len(quote), len(raw) - len(quote)
    if len(quote) == 3:
        i += raw.startswith("\n", i) + 2 * raw.startswith("\r\n", i)
    while i < end:
        if raw[0] == '"' and len(quote) == 3 and (found := _CONTINUATION.match(raw, i)):
            i = found.end()
            continue
        if n <= 0:
            break
        if raw[0] == '"' and raw[i] == "\\":
            i += _ESCAPE_LENGTHS.get(raw[i + 1], 2)
        else:
            i += 2 if raw.startswith("\r\n", i) else 1
        n -= 1
    return i
