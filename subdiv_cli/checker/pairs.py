"""C^1 from directional factors of a mask on Z^s, dilation cI (Dyn 1992, Corollary 7.9). See MULTIVARIATE.md."""

from __future__ import annotations

from itertools import combinations

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.directional import quotient_norm
from subdiv_cli.checker.directions import determinant
from subdiv_cli.checker.reading import require


def pair_norm(c: Claim) -> None:
    """‖S_(cd)^L‖∞ = x with a(z) = d(z) G_θ(z) G_η(z), G_θ(z) = 1 + z^θ + … + z^((c-1)θ): ∇_θ ∇_η S = S_d ∇_θ ∇_η."""
    directions = c.statement["directions"]
    require(len(directions) == 2, "there are not two directions")
    quotient_norm(c, directions)


def directional_smooth(c: Claim) -> None:
    """φ is C^1: all pairs of s+1 directions, any s of determinant ±1, all factors of the mask; norms below 1."""
    a = c.lattice()
    s = a.dilation.dimension
    require(c.statement["order"] <= 1, "nothing is said of second derivatives")
    c.use("coset-sums", holds=True)
    pairs = []
    for _ in range(s * (s + 1) // 2):
        used = c.use("pair-norm").statement
        require(used["norm"] < 1, "a norm is not below 1")
        pairs.append(used["directions"])
    directions = sorted({x for pair in pairs for x in pair})
    require(sorted(map(sorted, pairs)) == [list(x) for x in combinations(directions, 2)], "they are not all pairs")
    require(len(directions) == s + 1, f"there are not {s + 1} directions")
    c.count((s + 1) * 24)
    require(all(abs(determinant(some)) == 1 for some in combinations(directions, s)), "some are not a basis of Z^s")
