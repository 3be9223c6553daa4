"""The closed polytope: its vertices are words of the family applied to leading eigenvectors, and JSR^ℓ = Λ exactly.

Vertices are numbered as RADIUS.md says: the leaders, the tree, then their reflections.
"""

from __future__ import annotations

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.eigenvectors import enclosed, slope_bits
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.polytopes import body, reflected, weight_count
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import Root, isolated_root
from subdiv_cli.checker.trees import Tree, check_ties, read_tree, ties_work
from subdiv_cli.checker.vertices import HEADROOM, Vertices, leader_of, returns_of, weighted


def closing(c: Claim) -> None:
    """JSR^ℓ = Λ, and products of L matrices are at most a constant times σ^L, σ = Λ^(1/ℓ).

    Π x = sΛ x ≠ 0 for a product Π of ℓ matrices, so JSR^ℓ >= Λ. The hull P of all ±v is a body with M_i P ⊂ σ P: every
    M_i v_u / σ is a vertex (an edge of the tree), ± a leader (a return), a combination Σ c_k v_k with Σ |c_k| <= 1 (a
    tie, exactly so), or enclosed inside P.
    """
    family, root = c.family(), isolated_root(c)
    tree = read_tree(c, family)
    _count(c, family, root, tree)
    returns = returns_of(c, tree, c.statement["length"])
    ties = _tied(c, tree, returns)
    leaders = [leader_of(c, family, leader, leader["sign"], root.polynomial) for leader in c.witness["leaders"]]
    vertices = Vertices(c, family, root, max(slope_bits(x, root.high) for x in leaders))
    d, at, bits = len(root.polynomial) - 1, vertices.at, c.witness["bits"]
    for x in leaders:
        c.spend(3 * family.order * d, x.bits + d * (at.low.bit_length() + at.scale.bit_length()))
    vertices.grow(tree, (enclosed(x, at, bits) for x in leaders))
    _check_insides(c, family, vertices, tree, {*tree.children, *returns, *ties})
    if ties:
        check_ties(c, family, root, tree, leaders)


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


def _check_insides(c: Claim, family: Family, vertices: Vertices, tree: Tree, taken: set[int]) -> None:
    """All images but those taken lie inside, by their weights."""
    w = c.witness
    hull = reflected(c, family, vertices.vectors)
    errors = vertices.errors * (len(hull) // len(vertices.errors))
    ball = body(c, hull, errors, w["basis"], w["weight_bits"], w["bits"] + HEADROOM)
    for u, letter, weights in weighted(c, tree, taken):
        middle, error = vertices.image(u, letter)
        require(ball.contains(middle, 1, error, weights), f"the image of vertex {u} by letter {letter} is not inside")
