"""A page: lines gathered so far, each text in letters the console can print."""

from __future__ import annotations

from collections.abc import Sequence

from subdiv_cli.report.layout import Cell, Line, paragraph, table
from subdiv_cli.report.letters import letters
from subdiv_cli.report.look import Look

INDENT = 2


class Page:
    """Lines gathered so far; every text goes through `say`, which knows what the console can print."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.lines: list[Line] = []

    def say(self, text: str) -> str:
        """The text as it may be printed."""
        return letters(text, self.look.unicode)

    def cell(self, text: str | None, role: str = "text") -> Cell:
        """A cell of a table."""
        return self.say(text or ""), role

    def put(self, text: str, role: str = "text", *, indent: int = 0, hanging: int = 0) -> None:
        """A paragraph."""
        self.lines += paragraph(self.say(text), self.look.width, role=role, indent=indent, hanging=hanging)

    def unbroken(self, text: str, *, indent: int = 0) -> None:
        """A line to be copied whole: not wrapped, however long it is."""
        self.lines.append([(" " * indent, ""), (self.say(text), "text")])

    def blank(self) -> None:
        """An empty line, unless there is one."""
        if self.lines and self.lines[-1]:
            self.lines.append([])

    def table(self, header: Sequence[str], rows: Sequence[Sequence[Cell]]) -> None:
        """A table, or lists where it does not fit."""
        header = [self.say(title) for title in header]
        self.lines += table(header, rows, self.look.width, rule=self.say("─"), indent=INDENT)
