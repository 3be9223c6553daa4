"""Positions in a TOML text: the offsets of every key path, the line and column of a problem.

The module tomllib decides what is valid; the scanner only gives places, and the first place where it gets stuck, in
plainer words. It runs when there is something wrong, and once more as a guard where a line has suspiciously many dots.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import NamedTuple

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile import stuck
from subdiv_cli.maskfile.bounds import MAX_DIGITS, MAX_NESTING
from subdiv_cli.maskfile.problems import Fault, KeyPath, Source, shown_path
from subdiv_cli.model import Problem

_BLANK = re.compile(r"[ \t]*")
_LINE_END = re.compile(r"[ \t]*(?:#[^\n]*)?(?:\r?\n|\Z)")
_BLANK_LINES = re.compile(r"(?:[ \t]|\r?\n|#[^\n]*)*")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_BASIC = re.compile(r'"(?:[^"\\\n]|\\[^\n])*"')
_LITERAL = re.compile(r"'[^'\n]*'")
_LONG_BASIC = re.compile(r'"""(?:[^"\\]|\\.|"(?!""))*"""(?:"{0,2})', re.DOTALL)
_LONG_LITERAL = re.compile(r"'''(?:[^']|'(?!''))*'''(?:'{0,2})")
_STRINGS = {'"': _BASIC, "'": _LITERAL, '"""': _LONG_BASIC, "'''": _LONG_LITERAL}
_ESCAPE = re.compile(r"\\(?:u([0-9A-Fa-f]{4})|U([0-9A-Fa-f]{8})|x([0-9A-Fa-f]{2})|(.))")
_BAD_ESCAPE = re.compile(r"""(?:[^\\]|\\[btnfreuUx"\\\s])*\\[^btnfreuUx"\\\s]""")
_ESCAPED = {"b": "\b", "t": "\t", "n": "\n", "f": "\f", "r": "\r", "e": "\x1b"}
_SCALAR = re.compile(
    r"(?:true|false|[+-]?(?:inf|nan)"
    r"|[0-9]{4}-[0-9]{2}-[0-9]{2}(?:[Tt ][0-9]{2}:[0-9]{2}(?::[0-9]{2}(?:\.[0-9]+)?)?(?:[Zz]|[+-][0-9]{2}:[0-9]{2})?)?"
    r"|[0-9]{2}:[0-9]{2}(?::[0-9]{2}(?:\.[0-9]+)?)?"
    r"|0x[0-9A-Fa-f](?:_?[0-9A-Fa-f])*|0o[0-7](?:_?[0-7])*|0b[01](?:_?[01])*"
    r"|[+-]?(?:0|[1-9](?:_?[0-9])*)(?:\.[0-9](?:_?[0-9])*)?(?:[eE][+-]?[0-9](?:_?[0-9])*)?)"
)


class Spot(NamedTuple):
    """The offsets of a key (of an array's element: of the element) and of its value."""

    key: int
    start: int
    end: int


@dataclass(slots=True)
class Scan:
    """The offsets of all keys; where the scan got stuck those of the keys before that place."""

    spots: dict[KeyPath, Spot] = field(default_factory=dict)
    duplicates: list[tuple[KeyPath, int]] = field(default_factory=list)
    """The second declarations, with the offset of the key; `spots` has the first."""
    where: KeyPath = ()
    """The path of the value in which or after which it got stuck; () where it is a key or a header."""
    stuck: Fault | None = None
    """The fault where it got stuck, SD001, SD003 or SD010; its offset counts in the whole text."""


def scan(text: str) -> Scan:
    """The offsets of the keys of any text; never raises."""
    scanner = _Scanner(text)
    try:
        scanner.document()
    except Fault as fault:
        scanner.result.stuck = fault
        scanner.result.where = scanner.path
    return scanner.result


class _Scanner:
    """A pass over the text; `i` is the offset of the next character. Every method raises Fault where it is stuck."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.i = 0
        self.result = Scan()
        self._values: set[KeyPath] = set()
        self._headers: set[KeyPath] = set()
        self._arrays: dict[KeyPath, int] = {}
        self._depth = 0
        self.path: KeyPath = ()

    def document(self) -> None:
        """Scan a document: { table header | key "=" value }, a line each."""
        base: KeyPath = ()
        while True:
            self._skip(_BLANK_LINES)
            if self.i == len(self.text):
                return
            start = self.i
            if self.text[self.i] == "[":
                base = self._header()
            else:
                start = self._key_value(base)
            if not self._skip(_LINE_END):
                raise stuck.after_value(self.text, start, self._peek())

    def _skip(self, pattern: re.Pattern[str]) -> bool:
        match = pattern.match(self.text, self.i)
        self.i = match.end() if match else self.i
        return match is not None

    def _peek(self) -> int:
        """The offset of the next character that is not blank."""
        self._skip(_BLANK)
        return self.i

    def _next(self) -> str:
        return self.text[self.i : self.i + 1]

    def _header(self) -> KeyPath:
        self.path = ()
        opening = "[[" if self.text.startswith("[[", self.i) else "["
        closing = "]" * len(opening)
        self.i += len(opening)
        keys = self._keys()
        if not self.text.startswith(closing, self._peek()):
            raise stuck.header(self.text, self.i, closing)
        self.i += len(closing)
        path: KeyPath = ()
        for position, (name, offset) in enumerate(keys):
            path += (name,)
            last = position == len(keys) - 1
            self.result.spots.setdefault(path, Spot(offset, offset, offset))
            if last and opening == "[[":
                self._arrays[path] = self._arrays.get(path, -1) + 1
            if path in self._arrays and (not last or opening == "[["):
                path += (self._arrays[path],)
                self.result.spots.setdefault(path, Spot(offset, offset, offset))
        if opening == "[":
            if path in self._headers or path in self._values:
                self.result.duplicates.append((path, keys[-1][1]))
            self._headers.add(path)
        return path

    def _keys(self) -> list[tuple[str, int]]:
        """The keys of key { "." key }, with their offsets."""
        keys = []
        while True:
            keys.append(self._key())
            if not self.text.startswith(".", self._peek()):
                return keys
            if len(keys) >= MAX_NESTING:
                raise stuck.nesting("a dotted key", self.i)
            self.i += 1

    def _key(self) -> tuple[str, int]:
        start = self._peek()
        for pattern in (_BARE_KEY, _BASIC, _LITERAL):
            if match := pattern.match(self.text, start):
                self.i = match.end()
                raw = match.group()
                if raw[0] == '"':
                    return _ESCAPE.sub(_unescaped, raw[1:-1]), start
                return (raw if pattern is _BARE_KEY else raw[1:-1]), start
        raise stuck.key(self.text, start)

    def _key_value(self, base: KeyPath) -> int:
        """The offset of the value of a pair, which is scanned."""
        self.path = ()
        keys = self._keys()
        if not self.text.startswith("=", self.i):
            raise stuck.equals(self.text, keys[0][1], self.i)
        self.i += 1
        path = base
        for name, offset in keys[:-1]:
            path += (name,)
            self.result.spots.setdefault(path, Spot(offset, offset, offset))
        name, offset = keys[-1]
        path += (name,)
        start = self._peek()
        if path in self._values or path in self._headers:
            self.result.duplicates.append((path, offset))
            path = (*path, -1)  # a path that no document has
        self._values.add(path)
        self._value(path, offset)
        return start

    def _value(self, path: KeyPath, key: int | None = None) -> None:
        start = self.i
        c = self._next()
        self.path = path
        self.result.spots.setdefault(path, Spot(start if key is None else key, start, start))
        self._depth += 1
        if self._depth > MAX_NESTING:
            raise stuck.nesting("the value", start)
        if c in ('"', "'") and c:
            self._string()
        elif c == "[":
            self._array(path)
        elif c == "{":
            self._inline_table(path)
        else:
            self._scalar()
        self._depth -= 1
        if (spot := self.result.spots[path]).start == start:
            self.result.spots[path] = spot._replace(end=self.i)

    def _string(self) -> None:
        start, quote = self.i, self._next()
        long = self.text.startswith(quote * 3, start)
        pattern = _STRINGS[quote * 3 if long else quote]
        if not self._skip(pattern):
            raise stuck.string(self.text, start, quote * 3 if long else quote)
        if quote == '"' and (escape := _BAD_ESCAPE.match(self.text, start, self.i)):
            raise stuck.escape(self.text, escape.end() - 2)

    def _scalar(self) -> None:
        start = self.i
        if not self._skip(_SCALAR):
            raise stuck.value(self.text, start)
        if self.i - start > MAX_DIGITS + 10:
            message = f"the number has {self.i - start} digits; the limit is {MAX_DIGITS}"
            raise Fault(faults.OUT_OF_BOUNDS, message, "use a shorter number", start)
        if self._next() not in ("", " ", "\t", "\r", "\n", ",", "]", "}", "#"):
            raise stuck.after_value(self.text, start, self.i)

    def _array(self, path: KeyPath) -> None:
        opening = self.i
        self.i += 1
        index = 0
        while True:
            self._skip(_BLANK_LINES)
            if self._next() == "]":
                break
            if not self._next():
                self.path = path
                raise stuck.unclosed(opening, "[", "]")
            if self._next() == ",":
                raise Fault(
                    faults.TOML_SYNTAX,
                    "a value is missing before this comma",
                    "remove the comma or add a value",
                    self.i,
                )
            start = self.i
            self._value((*path, index))
            index += 1
            self._skip(_BLANK_LINES)
            if self._next() == ",":
                self.i += 1
            elif self._next() not in ("]", ""):
                self.path = path if "\n" in self.text[start : self.i] else self.path
                raise stuck.separator(self.text, opening, start, self.i, "]")
        self.i += 1

    def _inline_table(self, path: KeyPath) -> None:
        opening = self.i
        self.i += 1
        while True:
            self._skip(_BLANK_LINES)
            if self._next() == "}":
                break
            if not self._next():
                raise stuck.unclosed(opening, "{", "}")
            start = self._key_value(path)
            self._skip(_BLANK_LINES)
            if self._next() == ",":
                self.i += 1
            elif self._next() not in ("}", ""):
                raise stuck.separator(self.text, opening, start, self.i, "}")
        self.i += 1


def _unescaped(match: re.Match[str]) -> str:
    code = match.group(1) or match.group(2) or match.group(3)
    if code is None:
        return _ESCAPED.get(match.group(4), match.group(4))
    return chr(int(code, 16)) if int(code, 16) < 0x110000 else match.group()


_CONTINUATION = re.compile(r"\\[ \t]*\r?\n[ \t\r\n]*")
_ESCAPE_LENGTHS = {"u": 6, "U": 10, "x": 4}


class Positions:
    """The positions in one source, by which faults become problems; the text is scanned on first use."""

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
    """The 1-based line and column of an offset, and the text of that line."""
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
        if raw[0] == '"' and len(quote) == 3 and (continuation := _CONTINUATION.match(raw, i)):
            i = continuation.end()
            continue
        if n <= 0:
            break
        if raw[0] == '"' and raw[i] == "\\":
            i += _ESCAPE_LENGTHS.get(raw[i + 1], 2)
        else:
            i += 2 if raw.startswith("\r\n", i) else 1
        n -= 1
    return i
