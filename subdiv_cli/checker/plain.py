"""The mask of a plain mask file, read with the standard library alone: literal numbers and nothing to expand.

Each kind has the readers of its own files; what they share is here.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.checker import KINDS

_LITERAL = re.compile(r"[+-]?[0-9]{1,1000}(/[0-9]{1,1000}|\.[0-9]{1,1000})?")


class PlainMask(NamedTuple):
    """A mask of any kind in its normal form: two of them are equal iff they are the same mask."""

    kind: str
    data: tuple[object, ...]


class PlainReaders(NamedTuple):
    """The two readers by which masks of a kind are read."""

    of_file: Callable[[Mapping[str, Any]], PlainMask | None]
    """Reads a parsed mask file; returns None, or raises ValueError, where its numbers are not literal."""
    of_certificate: Callable[[Mapping[str, Any]], PlainMask | None]
    """Reads the part of a verified certificate under `mask`."""


def plain_mask(text: str) -> PlainMask | None:
    """The mask of a file whose coefficients are literal numbers: 3, 0.25, "-1/16".

    None for every other file, readable or not: it has parameters in use, a symbol, another kind, or a mistake.
    """
    import tomllib

    try:
        document = tomllib.loads(text, parse_float=str)
        kind = document.get("kind", "scalar")
        return KINDS[kind].plain.of_file(document) if type(kind) is str and kind in KINDS else None
    except (ValueError, ZeroDivisionError, RecursionError):
        return None


def mask_of(about: Mapping[str, Any]) -> PlainMask | None:
    """The mask of a certificate, from the part under `mask`; None for a family of matrices."""
    return KINDS[about["kind"]].plain.of_certificate(about)


def certified_mask(text: str) -> PlainMask | None:
    """The mask that a verified certificate is about, from its text."""
    return mask_of(json.loads(text)["mask"])


def literal(x: object) -> Fraction:
    """The value of a literal number. Raises ValueError for anything else."""
    if type(x) is int or (type(x) is str and _LITERAL.fullmatch(x)):
        return Fraction(x)
    raise ValueError("no literal number")
