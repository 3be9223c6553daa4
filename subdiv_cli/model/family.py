"""The result of `subdiv jsr` for a family of matrices."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from subdiv_cli.model.proofs import LowerBound, RadiusProof


@dataclass(frozen=True, slots=True, kw_only=True)
class FamilyRadius:
    """The joint spectral radius ρ of a family of matrices, with its bounds, closed form and proof."""

    order: int
    letters: int
    """The number of matrices."""
    lower: float | None = None
    upper: float | None = None
    """The bounds as certified doubles, rounded outward; None where the effort did not suffice for any bound."""
    exact: str | None = None
    """The closed form of ρ if known and short: `2`, `root(x^2-x-1, 1.61803, 1.61804)`, `25^(1/3)`."""
    digits: str | None = None
    """The first decimals of an exact ρ."""
    words: tuple[tuple[int, ...], ...] = ()
    """The words of products that attain the lower bound: the spectrum-maximizing ones where ρ is exact."""
    method: str = ""
    """The rule that proves the upper bound: closing, polytope, monotone-closing, …, blocks, zero."""
    vertices: int | None = None
    """The number of vertices of the polytopes."""
    bounded: bool = False
    """Whether it is proved that all products of L matrices have norms <= C ρ^L."""
    stopped: Literal["budget"] | None = None
    proof: RadiusProof | None = None
    """The proof of the upper bound, or of ρ itself."""
    left_out: str | None = None
    """The reason why a better bound is not here, where there is one that the checker has not verified."""
    below: LowerBound | None = None
    """The proof of the lower bound, where ρ itself is not proved."""

    @property
    def width(self) -> float:
        """The width of the enclosure relative to its upper end: 0 where ρ is exact, 1 where nothing is known."""
        if self.exact is not None or self.upper == 0:
            return 0.0
        return 1.0 if self.upper is None or self.lower is None else (self.upper - self.lower) / self.upper
