"""The table of everything that can be wrong with an input: a row per code SD0xx, and no code stands elsewhere.

Faults are raised by the name of their row, `Fault(faults.UNKNOWN_KEY, message, help)`. A code has a page of the same
name under `explain/pages`, and is never given anew once it was.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from subdiv_cli.model import Problem


class FaultRule(NamedTuple):
    """A row of the table: one thing that can be wrong with an input."""

    code: str
    """The code, SD0nn."""
    name: str
    """The code in words, as the title of its page has it."""
    help: str | None = None
    """The mend in one line, where nothing better is given at the place."""

    def problem(self, message: str, help: str | None = None, **place: Any) -> Problem:
        """The problem of this code, with the help of the row where none is given; `place` are further fields of it."""
        return Problem(code=self.code, message=message, help=self.help if help is None else help, **place)


TOML_SYNTAX = FaultRule("SD001", "toml-syntax")
UNREADABLE_FILE = FaultRule("SD002", "unreadable-file")
FRACTION_NOT_QUOTED = FaultRule("SD003", "fraction-not-quoted")
UNKNOWN_KEY = FaultRule("SD004", "unknown-key")
MISSING_KEY = FaultRule("SD005", "missing-key")
WRONG_TYPE = FaultRule("SD006", "wrong-type")
BAD_NUMBER = FaultRule("SD007", "bad-number")
BAD_EXPRESSION = FaultRule("SD008", "bad-expression")
ZERO_MASK = FaultRule("SD009", "zero-mask")
OUT_OF_BOUNDS = FaultRule("SD010", "out-of-bounds")
BAD_PARAMETER = FaultRule("SD011", "bad-parameter")
BAD_EXPECTATION = FaultRule("SD012", "bad-expectation")
KIND_NOT_BUILT = FaultRule("SD013", "kind-not-built")
NO_MASKS = FaultRule("SD014", "no-masks")
DUPLICATE_KEY = FaultRule("SD015", "duplicate-key", "keep one of the two")
NOT_A_MASK = FaultRule("SD016", "not-a-mask")
SETTINGS = FaultRule("SD017", "settings")
BASELINE = FaultRule("SD018", "baseline")
WORKER_LOST = FaultRule(
    "SD019", "worker-lost", "check it alone; if that ends in the same way, lower --effort or report the mask"
)
NO_REPORT = FaultRule("SD020", "no-report", "write one with `subdiv check … --format json -o report.json`")
BAD_POINTS = FaultRule("SD021", "bad-points")
BAD_DILATION = FaultRule("SD022", "bad-dilation")
BAD_SHAPE = FaultRule("SD023", "bad-shape")
ROW_SUM = FaultRule("SD024", "row-sum")
INTERNAL_ERROR = FaultRule(
    "SD099",
    "internal-error",
    "this is a fault of subdiv and not of the mask: please report it with the mask file, the output of "
    "`subdiv --version` and what the same command with `--debug` prints",
)

ROWS: Mapping[str, FaultRule] = {row.code: row for row in list(globals().values()) if isinstance(row, FaultRule)}
"""The rows by their codes, in order."""
