"""Piecewise uniform schemes in one variable: a mask on each side of 0, and special rules near it (A. Levin 2003, 3)."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from subdiv_cli.kinds.scalar.scheme import ScalarScheme

Row = tuple[tuple[int, Fraction], ...]
"""The weights of a new point, not zero: the index of an old point with its weight, indices rising."""


@dataclass(frozen=True, slots=True)
class PiecewiseScheme:
    """Two masks of one arity p: (S c)_i = Σ_j a_(i-pj) c_j, a the left mask for i < 0 and the right one for i >= 0.

    A special row replaces the rule of its point whole; rows that say what the mask says are dropped on construction.
    Old point i lies at i spacing[0] for i <= 0 and at i spacing[1] for i >= 0. Raises ValueError for masks of different
    arity, for a spacing that is not positive, and for a point with two special rows; readers of files report these.
    """

    left: ScalarScheme
    right: ScalarScheme
    spacing: tuple[Fraction, Fraction] = (Fraction(1), Fraction(1))
    special: tuple[tuple[int, Row], ...] = ()

    @property
    def kind(self) -> str:
        """The name of the kind, `piecewise`."""
        return "piecewise"

    @property
    def arity(self) -> int:
        """The arity p of both masks."""
        return self.left.arity

    def __post_init__(self) -> None:
        if self.left.arity != self.right.arity:
            raise ValueError("the masks are of different arity")
        if min(self.spacing) <= 0:
            raise ValueError("a spacing is not positive")
        rows = {i: tuple(sorted((j, weight) for j, weight in row if weight)) for i, row in self.special}
        if len(rows) < len(self.special):
            raise ValueError("a point has two special rows")
        kept = tuple((i, row) for i, row in sorted(rows.items()) if row != self.ordinary(i))
        object.__setattr__(self, "special", kept)

    def ordinary(self, i: int) -> Row:
        """The row that the mask of its side has for new point i."""
        mask = self.left if i < 0 else self.right
        p, last = mask.arity, mask.start + mask.degree
        reached = range(-(-(i - last) // p), (i - mask.start) // p + 1)
        return tuple((j, a) for j in reached if (a := mask.coefficients[i - p * j - mask.start]))

    def row(self, i: int) -> Row:
        """The row of new point i."""
        return dict(self.special).get(i) if i in dict(self.special) else self.ordinary(i)  # type: ignore[return-value]
