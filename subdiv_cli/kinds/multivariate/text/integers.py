"""Lists of integers: indices, directions, rows of a matrix."""

from __future__ import annotations

import re

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_DIMENSION, MAX_INDEX
from subdiv_cli.maskfile.characters import mended
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, shown
from subdiv_cli.maskfile.values import described
from subdiv_cli.spaces.lattice import Index

_INDEX = re.compile(r"\s*[+-]?[0-9]{1,9}\s*(,\s*[+-]?[0-9]{1,9}\s*)*")


def integer_list(value: object, path: KeyPath, problems: Collector, what: str, help: str) -> tuple[int, ...] | None:
    """A list of integers within ±MAX_INDEX; None where it is none, which is recorded."""
    if not isinstance(value, list):
        problems.add(Fault(faults.WRONG_TYPE, f"{what} must be a list of integers, not {described(value)}", help), path)
        return None
    if len(value) > MAX_INDEX:
        problems.add(
            Fault(faults.OUT_OF_BOUNDS, f"{what} has {len(value)} entries; the limit is {MAX_INDEX}", help), path
        )
        return None
    entries: list[int] = []
    for i, entry in enumerate(value):
        if isinstance(entry, bool) or not isinstance(entry, int):
            given = f'the string "{shown(entry)}"' if isinstance(entry, str) else described(entry)
            problems.add(Fault(faults.WRONG_TYPE, f"an integer was expected, not {given}", help), (*path, i))
        elif abs(entry) > MAX_INDEX:
            given = str(entry) if entry.bit_length() < 64 else "a long number"
            problems.add(
                Fault(faults.OUT_OF_BOUNDS, f"{given} is beyond {MAX_INDEX} in size", "use smaller integers"),
                (*path, i),
            )
        else:
            entries.append(entry)
    return tuple(entries) if len(entries) == len(value) else None


def index_of_key(key: str) -> Index:
    """The index that a key such as "1,-1" spells. Raises Fault."""
    help = 'write an integer for each variable: "1,-1" = "1/16"'
    if not _INDEX.fullmatch(key):
        if _INDEX.fullmatch(plain := mended(key)):
            help = f'write it in plain characters: "{plain}"'
        raise Fault(faults.BAD_SHAPE, f'the key "{shown(key)}" is no index', help)
    index = tuple(map(int, key.split(",")))
    if max(map(abs, index)) > MAX_INDEX:
        raise Fault(faults.OUT_OF_BOUNDS, f"the index {shown(key)} is beyond {MAX_INDEX}", "shift the mask towards 0")
    if not 2 <= len(index) <= MAX_DIMENSION:
        plural = "" if len(index) == 1 else "s"
        message = (
            f'the index "{shown(key)}" has {len(index)} component{plural}; there are 2 to {MAX_DIMENSION} variables'
        )
        raise Fault(faults.BAD_SHAPE, message, help)
    return index
