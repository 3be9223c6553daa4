"""Lists as other programs print them, in the characters of the grammar: NumPy, MATLAB, JSON, CSV, Python.

Every step keeps the length of the text, so that an offset in the result is one in what was pasted. Blanks separate
where no comma does; as in MATLAB, `1 -2` is two numbers, and `1 - 2` and `1-2` are one.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.problems import Fault, shown

_STRING = re.compile(r'"""(?s:.*?)"""|\'\'\'(?s:.*?)\'\'\'|"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'')
_COMMENT = re.compile(r"#[^\n]*")
_HEADER = re.compile(r"^[ \t]*\[\[?[ \t]*[A-Za-z_][\w.-]*[ \t]*\]{0,2}[ \t\r]*$", re.MULTILINE)
_CALL = re.compile(r"(?<![\w.])(?:(?:np|numpy)\.)?(?:array|asarray|matrix|list|tuple|float(?:16|32|64)?)[ \t]*(?=\()")
_TYPE = re.compile(r",\s*dtype\s*=[^,()\[\]]*(?=\))")
_QUOTED = re.compile(r"""(["'])([^"'\[\];,\n]*)\1""")
_TRANSPOSED = re.compile(r"(?<=\])[ \t]*\.?'")
_ELEMENTWISE = re.compile(r"(?<=\])([ \t]*)\.(?=[*/])")
_CONTINUED = re.compile(r"\.\.\.[^\S\n]*\r?\n")
_LAST = re.compile(r"[,;](?=\s*\Z)")
_TOKEN = re.compile(r"\s+|[\[\](),;]|[^\s\[\](),;]+")
_NUMBERS = re.compile(r"[-+*/^().,;\s0-9eE]*")
_VARIABLE = re.compile(r"(?<![A-Za-z0-9_])z[0-9]*(?![A-Za-z0-9_])")
_DIVIDED_LAST = re.compile(r"\s*([+-]?[0-9]+(?:\s*,\s*[+-]?[0-9]+)+)\s*(/\s*[0-9]+)\s*")
_BRACKETS = "[1, 3, 3, 1]/4"


def is_toml(text: str) -> bool:
    """Whether a text is a mask file and no list or symbol.

    It is where it has "=" outside strings, the header of a table, or no code at all.
    """
    code = _TYPE.sub("", _COMMENT.sub("", _STRING.sub("''", text)))
    return "=" in code or not code.strip() or _HEADER.search(code) is not None


def is_list(text: str) -> bool:
    """Whether a plain text is a list and no symbol: it has brackets, or a comma and no variable."""
    return "[" in text or ("," in text and not _VARIABLE.search(text))


def plain(text: str) -> str:
    """The text with its list, if it is one, as the grammar of `--mask` wants it, at the same offsets.

    A list without brackets has commas alone. Raises Fault (SD008) for a matrix or a list with two readings.
    """
    if text.lstrip().startswith("{"):
        whole = re.search(r"\[[^{}\[\]]*\]", text)
        help = f"write the list alone: {shown(whole[0], 100) if whole else _BRACKETS}"
        raise Fault(faults.BAD_EXPRESSION, "braces are no list of coefficients", help, text.index("{"))
    text = _CONTINUED.sub(_blank, _unwrapped(_TYPE.sub(_blank, text)) if _CALL.search(text) else text)
    if "..." in text or "…" in text:
        at = text.index("..." if "..." in text else "…")
        help = "give all coefficients: numpy.set_printoptions(threshold=10000)"
        raise Fault(faults.BAD_EXPRESSION, "the list is abridged: coefficients are missing at the dots", help, at)
    text = _ELEMENTWISE.sub(r"\1 ", _TRANSPOSED.sub(_blank, text))
    text = _QUOTED.sub(lambda entry: f"({entry[2]})", text)
    if "[" not in text or text.rstrip().endswith(";"):
        text = _LAST.sub(" ", text)
    return _Separators(text).placed()


def _blank(match: re.Match[str]) -> str:
    return " " * len(match[0])


def _unwrapped(text: str) -> str:
    """The text without the names of calls that make lists and numbers: `np.array([0.25, 0.75])`."""
    pairs, stack = dict[int, int](), []
    for i, c in enumerate(text):
        if c == "(":
            stack.append(i)
        elif c == ")" and stack:
            pairs[stack.pop()] = i
    characters = list(text)
    for call in _CALL.finditer(text):
        first, last = call.end(), pairs.get(call.end(), 0)
        if last:
            characters[call.start() : first] = " " * (first - call.start())
            if text[first + 1 : last].lstrip().startswith("["):
                characters[first] = characters[last] = " "
    return "".join(characters)


class _Level(NamedTuple):
    """A bracket that is open, with what separates the values in it so far."""

    opening: str
    at: int
    called: bool
    """Whether a name stands directly before the bracket."""
    separators: list[tuple[str, int]]

    def places(self, kinds: str) -> list[int]:
        """The offsets of the separators of these kinds."""
        return [at for kind, at in self.separators if kind in kinds]


class _Separators:
    """A pass over a text that puts commas where values are separated by something else."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.characters = list(text)

    def placed(self) -> str:
        """The text with its commas. Raises Fault."""
        levels = [_Level("", 0, False, [])]
        before = ""
        for token in _TOKEN.finditer(self.text):
            word, at = token[0], token.start()
            if word.isspace():
                if self._separates(before, token.end()):
                    levels[-1].separators.append(("\n" if "\n" in word and len(levels) == 1 else " ", at))
                continue
            if word in "[(":
                levels.append(_Level(word, at, before[-1:].isalnum() and self.text[at - 1] == before[-1:], []))
            elif word in ")]" and len(levels) > 1:
                self._close(levels.pop(), at)
            elif word in ",;":
                levels[-1].separators.append((word, at))
            before = word
        for level in levels[1:]:  # never closed, which the grammar will say
            if level.opening == "[":
                self._close(level, len(self.text))
        if len(levels) == 1 and "[" not in self.characters:
            self._bare(levels[0])
        return "".join(self.characters)

    def _separates(self, before: str, end: int) -> bool:
        """Whether a blank up to `end` stands between two values."""
        after = self.text[end : end + 2]
        if not after or after[0] in "*/^),;]" or not before or before[-1] in "+-*/^(,;[":
            return False
        return after[0] not in "+-" or not after[1:].isspace()

    def _close(self, level: _Level, at: int) -> None:
        """Put the commas of a list that ends at `at`; a tuple gets brackets."""
        if level.opening == "(":
            if level.places(",") and not level.called and self.text[at] == ")":
                self.characters[level.at], self.characters[at] = "[", "]"
            return
        rows, inner = level.places(";"), level.places(",") or level.places(" ")
        if rows and inner:
            message = f"{shown(self.text[level.at : at + 1], 40)} is a matrix, as MATLAB writes it"
            help = f"a mask in two variables is lists in lists: {self._nested(level.at + 1, at, rows, inner)}"
            raise Fault(faults.BAD_EXPRESSION, message, help, rows[0])
        self._put(rows or inner)

    def _bare(self, level: _Level) -> None:
        """Put the commas of a list without brackets; a symbol, or a single number, stays as it is."""
        only_numbers = _NUMBERS.fullmatch(self.text) is not None
        commas = level.places(",")
        if _VARIABLE.search(self.text) or not (commas or only_numbers):
            return
        rows, inner = level.places(";\n"), commas or level.places(" ")
        if rows and inner:
            message = "are these one list or the rows of a matrix? Decimals have a point"
            nested = self._nested(0, len(self.text), rows, inner)
            help = f"put one list in brackets; a mask in two variables is {nested}"
            raise Fault(faults.BAD_EXPRESSION, message, help, rows[0])
        if divided := _DIVIDED_LAST.fullmatch(self.text):
            numbers, divisor = divided[1], divided[2]
            help = f"write [{shown(numbers, 80)}]{divisor} or [{shown(numbers + divisor, 80)}]"
            raise Fault(faults.BAD_EXPRESSION, "is the list divided, or its last number?", help, divided.start(2))
        self._put(rows or inner)

    def _nested(self, start: int, end: int, rows: list[int], inner: list[int]) -> str:
        """The part of the text as lists in lists, for a help."""
        self._put(inner)
        whole = "".join(self.characters)
        parts = (
            whole[i:j].strip(" \t\r\n;") for i, j in zip([start, *(k + 1 for k in rows)], [*rows, end], strict=True)
        )
        return shown("[" + ", ".join(f"[{part}]" for part in parts if part) + "]", 100)

    def _put(self, places: list[int]) -> None:
        for at in places:
            self.characters[at] = ","
