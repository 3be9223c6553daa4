"""Convergence of positive masks on boxes in Z^s, dilation cI (Dyn 1992, Theorem 6.4). See MULTIVARIATE.md."""

from __future__ import annotations

from math import prod

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.reading import require


def positive_converges(c: Claim) -> None:
    """S converges: coset sums 1, and the indices with a_α ≠ 0 are a box with all sides >= c, a_α > 0 there."""
    a = c.lattice()
    c.count(len(a.terms) * a.dilation.dimension)
    c.use("coset-sums", holds=True)
    factor = a.dilation.factor
    require(factor > 1, "the dilation is not a multiple of the identity")
    sides = [max(column) - min(column) for column in zip(*a.terms, strict=True)]
    require(min(sides) >= factor, f"a side of the box is shorter than {factor}")
    require(len(a.terms) == prod(side + 1 for side in sides), "the support is not a whole box")
    require(min(a.terms.values()) > 0, "a coefficient is negative")
