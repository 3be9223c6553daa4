"""Scalar subdivision schemes in several variables: (S f)_α = Σ_β a_(α-Mβ) f_β, α in Z^s (Dyn 1992, 6.1, for any M)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from subdiv_cli.spaces.lattice import Index, IntMatrix, characteristic_polynomial, is_expanding


@dataclass(frozen=True, slots=True, kw_only=True)
class MultivariateScheme:
    """A finitely supported rational mask on Z^s, s >= 2, and an expanding integer dilation matrix M.

    The terms are sorted and not zero. Raises ValueError for an all-zero mask, indices of another dimension, and a
    matrix that is not square or not expanding; readers of files report all of them before they come here.
    """

    dilation: IntMatrix
    """The s rows of M; column j is M e_j."""
    terms: Mapping[Index, Fraction]
    """The coefficients: α -> a_α."""

    @property
    def kind(self) -> str:
        """The name of the kind, `multivariate`."""
        return "multivariate"

    def __post_init__(self) -> None:
        if not is_expanding(self.dilation):
            raise ValueError("the dilation matrix is not square or not expanding")
        terms = {index: value for index, value in sorted(self.terms.items()) if value}
        if not terms:
            raise ValueError("all coefficients are zero")
        if any(len(index) != self.dimension for index in terms):
            raise ValueError(f"an index is not one of Z^{self.dimension}")
        object.__setattr__(self, "terms", terms)

    @property
    def dimension(self) -> int:
        """The number s of variables."""
        return len(self.dilation)

    def bounds(self) -> tuple[Index, Index]:
        """The corners of the smallest box that contains the support: the lowest and the highest."""
        columns = list(zip(*self.terms, strict=True))
        return tuple(map(min, columns)), tuple(map(max, columns))


def base(mask: Mapping[str, Any], variables: Sequence[int] | None) -> tuple[int, int]:
    """The pair (|det M|, s) of a canonical mask, or of its factor in these variables."""
    rows = mask["dilation"]
    block = rows if variables is None else [[rows[i][j] for j in variables] for i in variables]
    return abs(characteristic_polynomial(block)[0]), len(block)
