"""Uniform refinement of curves: p matrices that turn a control polygon into those of its p pieces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Matrix = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True, slots=True)
class MatrixFamily:
    """A family of square matrices of one order, by rows; at least one.

    As a scheme it has p >= 2 matrices A_0, …, A_(p-1) of order n >= 2, all of whose rows sum to 1: A_i c is the polygon
    of piece i of the curve of the polygon c (Micchelli & Prautzsch 1989). Readers of files report all that is wrong.
    """

    matrices: tuple[Matrix, ...]

    @property
    def kind(self) -> str:
        """The name of the kind, `matrices`."""
        return "matrices"


def base(mask: Mapping[str, Any], _: Sequence[int] | None) -> tuple[int, int]:
    """The pair (p, 1) of a canonical family: exponents are to the base p."""
    return len(mask["matrices"]), 1
