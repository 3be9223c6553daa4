"""What `subdiv jsr` says of a family of matrices."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from subdiv_cli.model import Data


@dataclass(frozen=True, slots=True, kw_only=True)
class FamilyRadius:
    """The joint spectral radius ρ of a family of matrices, as `subdiv jsr` says it."""

    order: int
    letters: int
    """How many matrices there are."""
    lower: float | None = None
    upper: float | None = None
    """Certified doubles, rounded outward; None where the effort did not suffice for any bound."""
    exact: str | None = None
    """ρ in closed form, where it is known and not too long: `2`, `root(x^2-x-1, 1.61803, 1.61804)`, `25^(1/3)`."""
    digits: str | None = None
    """The first decimals of an exact ρ."""
    words: tuple[tuple[int, ...], ...] = ()
    """Words of products that attain the lower bound: the spectrum-maximizing ones where ρ is exact."""
    method: str = ""
    """The rule that proves the upper bound: closing, polytope, monotone-closing, …, blocks, zero."""
    vertices: int | None = None
    """Of the polytopes."""
    bounded: bool = False
    """All products of L matrices have norms <= C ρ^L; False where that is not proved."""
    stopped: Literal["budget"] | None = None
    proof: Mapping[str, Data] = field(default_factory=dict)
    """Of the upper bound, or of ρ itself."""
    below: Mapping[str, Data] = field(default_factory=dict)
    """Of the lower bound, where ρ itself is not proved: `word` and `bound`, a rational below its spectral radius."""
