"""Masks that a mask file names by files beside it."""

from __future__ import annotations

from pathlib import Path

from subdiv_cli.kinds.scalar.text import Coefficients, body_of
from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.problems import Fault, MaskFileError, shown


def mask_in_file(name: str, beside: str | None) -> Coefficients:
    """The mask of another file at the defaults of its parameters. Raises Fault, the first of what is wrong there."""
    from subdiv_cli.kinds.reading import read_path

    file = Path(beside or "-").parent / name
    try:
        special = str(file) == "-" or (file.exists() and not file.is_file())  # a pipe or a device would block
    except (OSError, ValueError):
        special = False  # the reader says what is wrong with the name
    if special:
        raise Fault(
            faults.UNREADABLE_FILE, f'"{shown(name)}" is no regular file', "name a mask file, relative to this one"
        )
    try:
        return body_of(read_path(file, kind="scalar").scheme())
    except MaskFileError as error:
        first = error.problems[0]
        where = "" if first.line is None else f" on its line {first.line}"
        rule = faults.ROWS[first.code]
        help = "name a mask file, relative to this one" if rule is faults.UNREADABLE_FILE else first.help
        raise Fault(rule, f'in "{shown(name)}"{where}: {first.message}', help) from None
