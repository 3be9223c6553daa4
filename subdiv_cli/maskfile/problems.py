"""Problems of a file: faults as the parts raise them, and the one exception that leaves this folder."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from enum import Enum
from fractions import Fraction

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_PROBLEMS
from subdiv_cli.maskfile.rules import FaultRule
from subdiv_cli.model import Problem

KeyPath = tuple[str | int, ...]
"""The place of a value in a TOML document: ("mask", "coefficients", 3)."""


class MaskFileError(Exception):
    """Raised for a mask that cannot be read; `problems` has everything that is wrong, in the order of the file."""

    problems: tuple[Problem, ...]

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__(self.problems)

    def __str__(self) -> str:
        return "\n".join(f"{p.code}: {p.message}" for p in self.problems)


class Reason(Enum):
    """The nature of a fault, for the code that catches it and acts upon that; no code looks into a message."""

    UNDECLARED = "undeclared"
    """A name that is not declared, and the help is to declare it."""
    MISTAKEN = "mistaken"
    """A name that is not declared, and the help says what was probably meant."""
    NOT_QUOTED = "not quoted"
    """A fraction or an expression that must be a string in TOML."""


class Fault(Exception):  # noqa: N818 (most are recorded, not handled)
    """Raised for a fault at an offset (0-based) in a value's text; the caller knows the file and the key."""

    def __init__(
        self,
        rule: FaultRule,
        message: str,
        help: str | None = None,
        at: int = 0,
        *,
        reason: Reason | None = None,
        about: str | None = None,
    ) -> None:
        super().__init__(message)
        self.rule = rule
        """The row of `rules` that it is a case of."""
        self.message = message
        """The fault in one line: for readers, never for code."""
        self.help = rule.help if help is None else help
        """The mend in one line: that of its row where nothing else is given."""
        self.at = at
        self.reason = reason
        """The nature of the fault, where that matters to the code that catches it."""
        self.about = about
        """The name that it is about, where one report of it in a file is enough."""

    @property
    def code(self) -> str:
        """The code of its row."""
        return self.rule.code

    def problem(
        self,
        *,
        file: str | None = None,
        key: str | None = None,
        line: int | None = None,
        column: int | None = None,
        source: str | None = None,
    ) -> Problem:
        """The problem of this fault at a place."""
        return self.rule.problem(self.message, self.help, file=file, key=key, line=line, column=column, source=source)


class Source:
    """The text that positions refer to: a TOML file, or (toml=False) the text of an option.

    Two sources are always equal, so that masks compare by what they say and not by where it stands.
    """

    __slots__ = ("file", "text", "toml")

    def __init__(self, file: str | None, text: str, *, toml: bool = True) -> None:
        self.file = file
        self.text = text
        self.toml = toml

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Source)

    def __hash__(self) -> int:
        return 0

    def __repr__(self) -> str:
        return f"Source({self.file!r})"


class Collector:
    """The problems of one file. Near names and positions are computed only here, when something is wrong."""

    def __init__(self, source: Source) -> None:
        self._source = source
        self._faults: list[tuple[Fault, KeyPath, bool]] = []
        self._left_out = 0
        self._again: dict[tuple[str, str], int] = {}

    def __bool__(self) -> bool:
        return bool(self._faults)

    @property
    def file(self) -> str | None:
        """The file that the problems are about."""
        return self._source.file

    @property
    def full(self) -> bool:
        """Whether no problem that is added will be shown."""
        return len(self._faults) >= MAX_PROBLEMS

    def add(self, fault: Fault, path: KeyPath = (), *, of_key: bool = False) -> None:
        """Record a fault in the value at `path`, or (of_key) in the key itself; one `about` a name only once."""
        if fault.about is not None:
            same = (fault.message, fault.about)
            if same in self._again:
                self._again[same] += 1
                return
            self._again[same] = 0
        if not self.full:
            self._faults.append((fault, path, of_key))
        else:
            self._left_out += 1

    def raise_any(self) -> None:
        """Raise MaskFileError with everything recorded, sorted by position; return where there is nothing."""
        if not self._faults:
            return
        from subdiv_cli.maskfile.positions import Positions

        positions = Positions(self._source)
        problems = [
            self._counted(fault, positions.problem(fault, path, of_key)) for fault, path, of_key in self._faults
        ]
        problems.sort(key=lambda p: (p.line is None, p.line or 0, p.column or 0))
        if self._left_out:
            message = f"{self._left_out} more problems in this file are not shown"
            problems.append(faults.OUT_OF_BOUNDS.problem(message, file=self._source.file))
        raise MaskFileError(problems)

    def _counted(self, fault: Fault, problem: Problem) -> Problem:
        """The problem of a fault, with the number of places where the same was left out."""
        more = 0 if fault.about is None else self._again[fault.message, fault.about]
        if not more:
            return problem
        return replace(problem, message=f"{problem.message} (and in {more} more place{'s' if more > 1 else ''})")


def near(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate a misspelt name probably means."""
    if len(name) > 50:
        return None
    from difflib import get_close_matches

    options = {candidate.lower(): candidate for candidate in candidates}
    matches = get_close_matches(name.lower(), list(options), n=1, cutoff=0.6)
    return options[matches[0]] if matches else None


def shown(text: str, limit: int = 60) -> str:
    """Text from a file as a message may quote it: one line, no control characters, clipped."""
    clipped = text if len(text) <= limit else text[: limit - 1] + "…"
    return "".join(c if c.isprintable() else "\\n" if c == "\n" else f"\\u{ord(c):04x}" for c in clipped)


def shown_number(value: Fraction) -> str:
    """A rational as a message may quote it."""
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > 120:
        return "a long number"
    return str(value)


def shown_path(path: KeyPath) -> str:
    """A key path as a message quotes it: mask.coefficients[3]."""
    out = ""
    for part in path:
        if isinstance(part, int):
            out += f"[{part}]"
        else:
            bare = part.isascii() and part.replace("-", "_").replace("_", "a").isalnum()
            out += ("." if out else "") + (shown(part) if bare else f'"{shown(part)}"')
    return out


def unreadable(file: str, error: OSError) -> Problem:
    """The problem of a file that the system refuses to read."""
    if isinstance(error, FileNotFoundError):
        message, help = "there is no such file", "check the path, or use - to read standard input"
    elif isinstance(error, IsADirectoryError):
        message, help = "this is a directory, not a mask file", "name a file in it"
    elif isinstance(error, PermissionError):
        message, help = "permission to read this file is denied", f"allow it: chmod +r {file}"
    else:
        reason = error.strerror or type(error).__name__
        message, help = f"the file cannot be read: {reason}", "check the path and the disk"
    return faults.UNREADABLE_FILE.problem(message, help, file=file)


def internal_error(error: Exception, *, file: str | None = None) -> Problem:
    """The problem of an exception that nobody has foreseen, which is a mistake in this program."""
    return faults.INTERNAL_ERROR.problem(f"internal error: {type(error).__name__}: {error}", file=file)
