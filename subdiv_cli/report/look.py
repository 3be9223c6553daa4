"""The look of a report: what the formats need to know beside the results."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from subdiv_cli.model import Finding

UNWRAPPED = 1_000_000
"""A width at which nothing is wrapped."""


class Look(NamedTuple):
    """The place that a report goes to, as far as a format minds, and the options of the reader.

    A file is the default: UTF-8, no colour, 100 columns.
    """

    width: int = 100
    """The columns; text is wrapped to them, never cut."""
    unicode: bool = True
    """Whether other letters than ASCII can be written."""
    colour: bool = False
    verbosity: int = 0
    """-1: what failed; 0: a screen, or of several a line each and why; 1: every finding; 2: witnesses as well."""
    problems: bool = True
    """Whether the text report shows what is wrong with an invalid file; the command line puts it on stderr instead."""
    allow_undecided: bool = False
    """Whether undecided counts as passed; the footer says so."""
    select: tuple[str, ...] = ()
    """The codes, or beginnings of codes, of the findings to be shown; none are all."""
    ignore: tuple[str, ...] = ()
    """The codes, or beginnings of codes, of findings not to be shown, among those selected."""
    shard: tuple[int, int] | None = None
    """The pair (i, n): this is part i of n, every n-th mask from the i-th on."""
    missing: tuple[str, ...] = ()
    """The masks of the baseline that this run has not."""
    interrupted: bool = False
    """Whether not all masks were checked."""

    def shown(self, findings: Sequence[Finding]) -> tuple[Finding, ...]:
        """The findings to be shown. What a verdict is and the exit code do not depend on it."""
        if not self.select and not self.ignore:
            return tuple(findings)
        return tuple(
            finding
            for finding in findings
            if (not self.select or finding.code.startswith(self.select)) and not finding.code.startswith(self.ignore)
        )
