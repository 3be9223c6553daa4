"""Scalar subdivision schemes in one variable, of any arity p >= 2: (S f)_α = Σ_β a_(α-pβ) f_β (Dyn 2.1)."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True, kw_only=True)
class ScalarScheme:
    """A finitely supported rational mask a_start, …, a_(start+n), both end coefficients non-zero.

    Zeros at the ends are dropped on construction. Raises ValueError for an all-zero mask and for an arity below 2;
    readers of files report both before they come here.
    """

    arity: int
    start: int
    coefficients: tuple[Fraction, ...]

    @property
    def kind(self) -> str:
        """The name of the kind, `scalar`."""
        return "scalar"

    def __post_init__(self) -> None:
        if self.arity < 2:
            raise ValueError(f"the arity must be at least 2, not {self.arity}")
        support = [i for i, c in enumerate(self.coefficients) if c]
        if not support:
            raise ValueError("all coefficients are zero")
        first, last = support[0], support[-1]
        object.__setattr__(self, "start", self.start + first)
        object.__setattr__(self, "coefficients", tuple(self.coefficients[first : last + 1]))

    @property
    def degree(self) -> int:
        """The degree n: the length of the support minus one."""
        return len(self.coefficients) - 1
