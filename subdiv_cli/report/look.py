"""How a report is to look: what the formats need to know of the place they are printed to."""

from __future__ import annotations

from typing import NamedTuple

UNWRAPPED = 1_000_000
"""A width at which nothing is wrapped."""


class Look(NamedTuple):
    """The place a report goes to, as far as a format minds. A file is the default: UTF-8, no colour, 100 columns."""

    width: int = 100
    """Columns; text is wrapped to it, never cut."""
    unicode: bool = True
    """False where only ASCII can be written."""
    colour: bool = False
    verbosity: int = 0
    """-1: what failed; 0: a line each and what did not pass in full; 1: everything in full; 2: witnesses as well."""
    problems: bool = True
    """Whether the text report shows what is wrong with an invalid file; the command line puts it on stderr instead."""
    allow_undecided: bool = False
    """Whether undecided counts as passed; it is said in the footer."""
