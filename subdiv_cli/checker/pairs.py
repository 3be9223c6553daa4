"""C^1 from directional factors of a mask on Z^s, dilation cI (Dyn 1992, Corollary 7.9). See MULTIVARIATE.md."""

from __future__ import annotations

from itertools import combinations

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.directional import largest_class_sum
from subdiv_cli.checker.directions import determinant
from subdiv_cli.checker.lattice import geometric, multiply, over_one
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.scalar import MAX_LEVEL


def pair_norm(c: Claim) -> None:
    """‖S_(cd)^L‖∞ = x with a(z) = d(z) G_θ(z) G_η(z), G_θ(z) = 1 + z^θ + … + z^((c-1)θ): ∇_θ ∇_η S = S_d ∇_θ ∇_η."""
    a, directions, level = c.lattice(), c.statement["directions"], c.statement["level"]
    s, factor = a.dilation.dimension, a.dilation.factor
    d, denominator = over_one(c.witness["quotient"])
    require(factor > 1, "the dilation is not a multiple of the identity")
    require(len(directions) == 2, "there are not two directions")
    require(all(len(x) == s and any(x) for x in directions), f"a direction is zero or not one of Z^{s}")
    require(all(len(x) == s for x in d), f"an index of the quotient is not one of Z^{s}")
    require(1 <= level <= MAX_LEVEL, f"the level is not one of 1, …, {MAX_LEVEL}")
    bits = max(map(abs, d.values())).bit_length() + denominator.bit_length()
    c.count(len(d) * (factor + factor**2), a.bits + bits)
    product = multiply(multiply(d, geometric(directions[0], factor)), geometric(directions[1], factor))
    same = product.keys() == a.terms.keys()
    same = same and all(a.denominator * value == denominator * a.terms[x] for x, value in product.items())
    require(same, "the quotient times the directional factors is not the mask")
    largest = factor**level * largest_class_sum(c, d, factor, level)
    x = c.statement["norm"]
    require(x.numerator * denominator**level == largest * x.denominator, "the norm is another")


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
