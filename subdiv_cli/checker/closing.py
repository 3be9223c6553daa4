"""The closed polytope: its vertices are words of the family applied to leading eigenvectors, and JSR^ℓ = Λ exactly.

Vertices are numbered as RADIUS.md says: the leaders, the tree, then their reflections.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.eigenvectors import Vector, enclosed, slope_bits
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.monotone import MonotoneBody, monotone_body, require_nonnegative
from subdiv_cli.checker.polytopes import Body, body, reflected, weight_count
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import Root, fraction_bits, isolated_root
from subdiv_cli.checker.trees import Smaller, Ties, Tree, read_tree, ties_work
from subdiv_cli.checker.vertices import HEADROOM, Vertices, leader_of, returns_of, weighted


def closing(c: Claim) -> None:
    """JSR^ℓ = Λ, and products of L matrices are at most a constant times σ^L, σ = Λ^(1/ℓ).

    Π x = sΛ x ≠ 0 for a product Π of ℓ matrices, so JSR^ℓ >= Λ. The hull P of all ±v is a body with M_i P ⊂ σ P: every
    M_i v_u / σ is a vertex (an edge of the tree), ± a leader (a return), a combination Σ c_k v_k with Σ |c_k| <= 1 (a
    tie, exactly so), or enclosed inside P.
    """
    polytope = _Polytope(c)
    polytope.check_insides(body)
    polytope.check_ties(None)


def monotone_closing(c: Claim) -> None:
    """The same with the monotone hull P of the v >= 0: |M_i z| <= M_i |z| is in σ P for all z in P.

    Every M_i v_u / σ is a vertex, a leader, enclosed inside P, or a tie: at most Σ c_k v_k with c >= 0, Σ c_k <= 1, in
    every coordinate, exactly so or certainly.
    """
    require_nonnegative(c.family())
    require(all(leader["sign"] == 1 for leader in c.witness["leaders"]), "a leader has the sign -1")
    require(all(x >= 0 for v in c.witness["extras"] for x in v), "an extra vertex has a negative coordinate")
    polytope = _Polytope(c)
    polytope.require_nonnegative_leaders()
    polytope.check_insides(monotone_body)
    polytope.check_ties(polytope.is_smaller)


class _Polytope:
    """Tree, returns, ties, leaders and enclosures of the vertices: what is checked of them all."""

    def __init__(self, c: Claim) -> None:
        self._c, self._family, self._root = c, c.family(), isolated_root(c)
        self._tree = read_tree(c, self._family)
        _count(c, self._family, self._root, self._tree)
        self._returns = returns_of(c, self._tree, c.statement["length"])
        self._ties = _tied(c, self._tree, self._returns)
        m, given = self._root.polynomial, c.witness["leaders"]
        self._leaders = [leader_of(c, self._family, leader, leader["sign"], m) for leader in given]
        slopes = (slope_bits(x, self._root.high) for x in self._leaders)
        self._vertices = Vertices(c, self._family, self._root, max(slopes))
        self._vertices.grow(self._tree, map(self._enclosed, self._leaders))
        self._hull = reflected(c, self._family, self._vertices.vectors)
        self._errors = self._vertices.errors * (len(self._hull) // len(self._vertices.errors))

    def _enclosed(self, x: Vector) -> tuple[list[int], int]:
        at, d = self._vertices.at, len(x.powers)
        self._c.spend(3 * self._family.order * d, x.bits + d * (at.low.bit_length() + at.scale.bit_length()))
        return enclosed(x, at, self._c.witness["bits"])

    def require_nonnegative_leaders(self) -> None:
        """Each coordinate is certainly positive, or zero: m, of a degree above that of its polynomial, divides it."""
        for x, v, error in zip(self._leaders, self._hull, self._errors, strict=False):
            positive = (y > error or not any(power[i] for power in x.powers) for i, y in enumerate(v))
            require(all(positive), "a coordinate of a leader may be negative")

    def check_insides(self, make: Callable[..., Body | MonotoneBody]) -> None:
        """All images but edges, returns and ties lie inside, by their weights."""
        w = self._c.witness
        hull = make(self._c, self._hull, self._errors, w["basis"], w["weight_bits"], w["bits"] + HEADROOM)
        for u, letter, weights in weighted(self._c, self._tree, {*self._tree.children, *self._returns, *self._ties}):
            middle, error = self._vertices.image(u, letter)
            where = f"the image of vertex {u} by letter {letter}"
            require(hull.contains(middle, 1, error, weights), f"{where} is not inside")

    def check_ties(self, smaller: Smaller | None) -> None:
        if not self._ties:
            return
        ties = Ties(self._c, self._family, self._root, self._tree, self._leaders, self._vertices.at)
        for tie in self._c.witness["ties"]:
            ties.check(tie, smaller)

    def is_smaller(self, tie: dict[str, Any], weights: Sequence[tuple[Fraction, Fraction]], coordinate: int) -> bool:
        """Whether this coordinate of the image is certainly at most that of the combination; weights are enclosed."""
        middle, error = self._vertices.image(tie["vertex"], tie["letter"])
        bits = sum(fraction_bits(x) for pair in weights for x in pair)
        self._c.spend(len(weights), self._c.witness["bits"] + HEADROOM + bits)
        total = Fraction(0)
        for share, (low, high) in zip(tie["weights"], weights, strict=True):
            least = self._hull[share["vertex"]][coordinate] - self._errors[share["vertex"]]
            total += min(low * least, high * least)
        return total >= middle[coordinate] + error


def _count(c: Claim, family: Family, root: Root, tree: Tree) -> None:
    n, order, length = len(tree.parents), family.order, c.statement["length"]
    work = tree.letters * n * order**2 + weight_count(c) * order + order**3
    work += len(c.witness["leaders"]) * (length + 1) * order**3
    work += ties_work(c, family, root, tree)
    c.count(work, max(family.bits, c.witness["bits"] + HEADROOM))


def _tied(c: Claim, tree: Tree, returns: set[int]) -> list[int]:
    ties = []
    for tie in c.witness["ties"]:
        require(tie["letter"] < tree.letters, "a tie is by a letter that is not there")
        ties.append(tie["vertex"] * tree.letters + tie["letter"])
    require(ties == sorted(set(ties)), "the ties are not in order")
    require(not any(image in tree.children or image in returns for image in ties), "a tie is an edge or a return")
    return ties
