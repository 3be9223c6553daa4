"""A page of text laid out in columns: wrapping, tables, and colour at the very end. Nothing is ever cut off.

A line is a list of (text, role) spans. Roles are what a text is, not how it looks; `paint` gives them colours, and
is the only thing here that needs rich, which it loads only where there is colour.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from subdiv_cli.report.letters import letters, width
from subdiv_cli.report.look import Look

Line = list[tuple[str, str]]

STYLES = {
    "good": "green", "bad": "bold red", "open": "yellow", "none": "bright_black", "head": "bold",
    "quiet": "bright_black", "code": "cyan", "text": "",
}  # fmt: skip
GAP = 2
INDENT = 2


class Cell(NamedTuple):
    """A cell of a table."""

    text: str
    role: str = "text"


class Page:
    """The lines so far; every text goes through `say`, which knows what the console can print."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.lines: list[Line] = []

    def take(self) -> str:
        """The finished lines as text, which are put away; the last one stays, since `blank` looks at it."""
        done, self.lines = self.lines[:-1], self.lines[-1:]
        return paint(done, colour=self.look.colour)

    def say(self, text: str) -> str:
        """The text as it may be printed."""
        return letters(text, self.look.unicode)

    def cell(self, text: str | None, role: str = "text") -> Cell:
        """A cell of a table."""
        return Cell(self.say(text or ""), role)

    def put(self, text: str, role: str = "text", *, indent: int = 0, hanging: int = 0) -> None:
        """Add a paragraph."""
        self.lines += paragraph(self.say(text), self.look.width, role=role, indent=indent, hanging=hanging)

    def unbroken(self, text: str, *, indent: int = 0) -> None:
        """Add a line to be copied whole: not wrapped, however long it is."""
        self.lines.append([(" " * indent, ""), (self.say(text), "text")])

    def blank(self) -> None:
        """Add an empty line, unless there is one."""
        if self.lines and self.lines[-1]:
            self.lines.append([])

    def table(self, header: Sequence[str], rows: Sequence[Sequence[Cell]]) -> None:
        """Add a table, or lists where it does not fit."""
        header = [self.say(title) for title in header]
        self.lines += table(header, rows, self.look.width, rule=self.say("─"), indent=INDENT)


def wrap(text: str, columns: int) -> list[str]:
    """The text in lines of at most so many columns, broken at spaces, and inside a word only where it must be."""
    columns = max(columns, 1)
    if width(text) <= columns:
        return [text]
    lines, line = [], ""
    for word in text.split(" "):
        joined = f"{line} {word}" if line else word
        if width(joined) <= columns:
            line = joined
            continue
        if line:
            lines.append(line)
        while width(word) > columns:
            head = _fitting(word, columns)
            lines.append(word[:head])
            word = word[head:]
        line = word
    return [*lines, line] if line or not lines else lines


def _fitting(word: str, columns: int) -> int:
    """The number of characters of a word that fit, at least one, preferably up to where a formula may be broken."""
    end = 1
    while end < len(word) and width(word[: end + 1]) <= columns:
        end += 1
    for place in range(end, end // 2, -1):
        if word[place - 1] in "/*+,;_":
            return place
    return end


def led(lead: Line, text: str, columns: int, *, role: str = "text", hanging: int = 0) -> list[Line]:
    """The lines of a lead and a wrapped text after it; `hanging` is how far the text's later lines are indented."""
    text = text.strip(" ")
    first = wrap(text, columns - sum(width(span) for span, _ in lead))[0]
    rest = text[len(first) :].lstrip(" ")
    later = wrap(rest, columns - hanging) if rest else []
    return [[*lead, (first, role)], *([(" " * hanging, ""), (piece, role)] for piece in later)]


def paragraph(text: str, columns: int, *, role: str = "text", indent: int = 0, hanging: int = 0) -> list[Line]:
    """The lines of a wrapped paragraph; `hanging` is how much further its second and later lines are indented."""
    return led([(" " * indent, "")], text, columns, role=role, hanging=indent + hanging)


def joined(items: Sequence[str], separator: str, columns: int, *, indent: int = 0, role: str = "text") -> list[Line]:
    """The lines of items in a row, wrapped between them where that is possible."""
    lines: list[Line] = []
    row = ""
    for item in items:
        longer = f"{row}{separator}{item}" if row else item
        if row and width(longer) > columns - indent:
            lines += paragraph(row, columns, indent=indent, role=role)
            longer = item
        row = longer
    return lines + (paragraph(row, columns, indent=indent, hanging=GAP, role=role) if row else [])


def table(
    header: Sequence[str], rows: Sequence[Sequence[Cell]], columns: int, *, rule: str, indent: int = 0
) -> list[Line]:
    """The lines of rows under a header, cells wrapped to fit; where even that cannot fit, each row as a short list."""
    columns -= indent
    widths = _widths(header, rows, columns)
    if widths is None:
        return stacked(header, rows, columns, indent)
    lines = _row([Cell(title, "quiet") for title in header], widths, indent)
    lines.append([(" " * indent, ""), ((" " * GAP).join(rule * size for size in widths), "quiet")])
    for row in rows:
        lines += _row(row, widths, indent)
    return lines


def _widths(header: Sequence[str], rows: Sequence[Sequence[Cell]], columns: int) -> list[int] | None:
    """The width of each column, or None where they do not fit without breaking words."""
    texts = [[title, *(row[i].text for row in rows)] for i, title in enumerate(header)]
    natural = [max(map(width, column)) for column in texts]
    least = [_least(column) for column in texts]
    room = columns - GAP * (len(header) - 1)
    if sum(least) > room:
        return None
    spare = sum(natural) - room
    while spare > 0:
        size, widest = max((size, i) for i, size in enumerate(natural) if size > least[i])
        others = [other for i, other in enumerate(natural) if i != widest and other < size and other > least[i]]
        step = min(spare, size - least[widest], max(1, size - max(others, default=0)))
        natural[widest] -= step
        spare -= step
    return [max(wanted, smallest) for wanted, smallest in zip(natural, least, strict=True)]


def _least(column: Sequence[str]) -> int:
    """The width below which a column is no pleasure: short texts whole, long ones by the word."""
    words = (word for text in column for word in text.split(" "))
    return max(min(max(map(width, column)), 18), *(min(width(word), 36) for word in words))


def _row(cells: Sequence[Cell], widths: Sequence[int], indent: int) -> list[Line]:
    pieces = [wrap(text, size) for (text, _), size in zip(cells, widths, strict=True)]
    lines: list[Line] = []
    for i in range(max(map(len, pieces))):
        line: Line = [(" " * indent, "")]
        for (_, role), column, size in zip(cells, pieces, widths, strict=True):
            piece = column[i] if i < len(column) else ""
            line += [(piece, role), (" " * (size - width(piece) + GAP), "")]
        lines.append(line)
    return lines


def stacked(header: Sequence[str], rows: Sequence[Sequence[Cell]], columns: int, indent: int) -> list[Line]:
    """The lines of each row as a list: its first two cells, beside each other if they fit, and under them the rest.

    Those below are named by the header.
    """
    lines: list[Line] = []
    for (title, role), *others in rows:
        named = list(zip(header[1:], others, strict=True))
        lines += paragraph(title, columns + indent, role=role, indent=indent)
        if len(lines[-1]) and others and width(title) + GAP + width(others[0].text) <= columns:
            lines[-1] += [(" " * GAP, ""), named.pop(0)[1]]
        for name, (text, its) in named:
            if text:
                labelled = f"{name}: {text}" if name else text
                lines += paragraph(labelled, columns + indent, role=its, indent=indent + GAP, hanging=GAP)
    return lines


def paint(lines: Iterable[Line], *, colour: bool = False) -> str:
    """The lines as one string; trailing blanks dropped, and without `colour` not a single escape in it."""
    rows = ["".join(text for text, _ in line).rstrip() for line in lines] if not colour else _painted(lines)
    return "".join(row + "\n" for row in rows)


def _painted(lines: Iterable[Line]) -> list[str]:
    from rich.color import ColorSystem
    from rich.style import Style

    styles = {role: Style.parse(style) for role, style in STYLES.items() if style}
    rows = []
    for line in lines:
        end = len("".join(text for text, _ in line).rstrip())
        row, at = "", 0
        for text, role in line:
            text = text[: max(end - at, 0)]
            at += len(text)
            style = styles.get(role)
            row += style.render(text, color_system=ColorSystem.STANDARD) if style and text else text
        rows.append(row)
    return rows
