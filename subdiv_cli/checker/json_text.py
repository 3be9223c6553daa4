"""The reader of JSON text, as strict as can be: no floats, no constants, no long integers, no key twice."""

from __future__ import annotations

import json

from subdiv_cli.checker.numerals import shown
from subdiv_cli.checker.reading import MAX_BYTES, Rejected, require, require_few


def parse(text: str) -> object:
    """The value of a JSON text. Raises Rejected for floats, constants, long integers and duplicate keys."""
    require_few(len(text) <= MAX_BYTES, "the file is too large")
    try:
        return json.loads(
            text, object_pairs_hook=_object, parse_int=_small, parse_float=_no_float, parse_constant=_no_float
        )
    except ValueError as error:
        raise Rejected(f"not JSON: {error}"[:200]) from None
    except RecursionError:
        raise Rejected("nested too deeply") from None


def _object(pairs: list[tuple[str, object]]) -> dict[str, object]:
    result = dict(pairs)
    require(len(result) == len(pairs), "an object has a key twice")
    return result


def _small(digits: str) -> int:
    require(len(digits.lstrip("-")) <= 12 and digits != "-0", "an integer is too long")
    return int(digits)


def _no_float(digits: str) -> int:
    raise Rejected(f"{shown(digits)} is not an exact number")
