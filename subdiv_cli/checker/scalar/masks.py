"""Scalar masks: the one that a document is about, those that claims reduce it to, and plain mask files."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from subdiv_cli.checker.core import Claim, Subject
from subdiv_cli.checker.plain import PlainMask, literal
from subdiv_cli.checker.polynomials import Polynomial
from subdiv_cli.checker.reading import read, require

MAX_ARITY = 64


class Symbols(list[Polynomial]):
    """The symbols of the document's mask, which is number 0, and of the masks that claims reduce it to."""


def subject(parts: dict[str, Any]) -> Subject:
    """The mask of a document, from its parts. Raises Rejected for an arity out of bounds and for zero."""
    require(2 <= parts["arity"] <= MAX_ARITY, f"the arity is not one of 2, …, {MAX_ARITY}")
    symbol = read("polynomial", {key: parts[key] for key in ("start", "coefficients")}, "the mask")
    require(bool(symbol.numerators), "the mask is zero")
    return Subject(parts["arity"], Symbols([symbol]))


def symbols_of(c: Claim) -> Symbols:
    """The symbols of the document that the claim is in."""
    symbols: Symbols = c.about
    return symbols


def symbol_of(c: Claim) -> Polynomial:
    """The symbol of the mask that the statement names, mask 0 where it names none."""
    symbols = symbols_of(c)
    number: int = next((c.statement[key] for key in ("mask", "from") if key in c.statement), 0)
    require(number < len(symbols), f"there is no mask {number}")
    return symbols[number]


def use_reductions(c: Claim, mask: int) -> list[Polynomial]:
    """The factors of the reductions 0 -> 1, …, mask-1 -> mask, which the claim uses."""
    used = [c.use("reduction", **{"from": i, "to": i + 1}) for i in range(mask)]
    return [proved.result for proved in used if proved.result is not None]


def plain(arity: int, start: int, coefficients: list[Fraction]) -> PlainMask:
    """The mask in its normal form, without zeros at its ends."""
    support = [i for i, c in enumerate(coefficients) if c] or [0]
    return PlainMask("scalar", (arity, start + support[0], tuple(coefficients[support[0] : support[-1] + 1])))


def of_file(document: Mapping[str, Any]) -> PlainMask | None:
    """The mask of a file: `coefficients`; `arity` and `start`, 2 and 0 if they are left out."""
    table = document.get("mask")
    if type(table) is not dict or not {"coefficients"} <= table.keys() <= {"arity", "start", "coefficients"}:
        return None
    arity, start, entries = table.get("arity", 2), table.get("start", 0), table["coefficients"]
    if type(arity) is not int or type(start) is not int or type(entries) is not list or not entries:
        return None
    return plain(arity, start, [literal(x) for x in entries])


def of_certificate(mask: Mapping[str, Any]) -> PlainMask:
    """The mask in its normal form, from the part of a verified certificate under `mask`."""
    return plain(mask["arity"], mask["start"], [Fraction(c) for c in mask["coefficients"]])
