"""Readers of findings' witnesses, which are plain data, with the types that claims need. They raise TypeError."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from subdiv_cli.certificate.claims import Json, polynomial
from subdiv_cli.model import Data


def as_integer(x: Data) -> int:
    """The integer that a witness has. Raises TypeError for anything else."""
    if not isinstance(x, int):
        raise TypeError(f"a witness has {x!r} for an integer")
    return x


def as_rational(x: Data) -> Fraction:
    """The rational that a witness has. Raises TypeError for anything else."""
    return x if isinstance(x, Fraction) else Fraction(as_integer(x))


def as_tuple(x: Data) -> tuple[Data, ...]:
    """The tuple that a witness has. Raises TypeError for anything else."""
    if not isinstance(x, tuple):
        raise TypeError(f"a witness has {x!r} for a tuple")
    return x


def as_rationals(x: Data) -> tuple[Fraction, ...]:
    """The rationals in a tuple of a witness. Raises TypeError for anything else."""
    return tuple(as_rational(c) for c in as_tuple(x))


def as_word(witness: Mapping[str, Data]) -> tuple[int, ...]:
    """The word of a witness, a tuple of letters. Raises TypeError for anything else."""
    return tuple(as_integer(letter) for letter in as_tuple(witness["word"]))


def as_polynomial(start: Data, coefficients: Data) -> Json:
    """The polynomial with this start and these coefficients, as statements have it."""
    return polynomial(as_integer(start), as_rationals(coefficients))


def as_cofactors(witness: Mapping[str, Data]) -> list[Any]:
    """The cofactors of a witness, one polynomial for each polyphase component."""
    pairs = zip(as_tuple(witness["starts"]), as_tuple(witness["cofactors"]), strict=True)
    return [as_polynomial(start, coefficients) for start, coefficients in pairs]
