"""The tree of a closed polytope's vertices, and its ties: images that are combinations of vertices exactly."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.eigenvectors import Vector, nonzero_coordinates
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.reading import MAX_VERTICES, require
from subdiv_cli.checker.roots import Root, fraction_bits


class Tree(NamedTuple):
    """How the vertices arise, reflections aside: leaders first, then what comes of them and of extra vertices."""

    letters: int
    parents: list[int]
    """-1 for a leader or an extra vertex."""
    by: list[int]
    """The letter that makes the vertex of its parent; of an extra vertex its number."""
    depths: list[int]
    """Edges from the leader; below zero for extra vertices and what comes of them."""
    children: dict[int, int]
    """By image."""


def read_tree(c: Claim, family: Family) -> Tree:
    leaders, pairs, extras, p = len(c.witness["leaders"]), c.witness["tree"], c.witness["extras"], len(family.matrices)
    require(leaders > 0, "there is no leader")
    require(len(pairs) % 2 == 0 and leaders + len(pairs) // 2 <= MAX_VERTICES, "half an edge, or too many vertices")
    require(all(len(v) == family.order for v in extras), "an extra vertex does not have N coordinates")
    tree, extra = Tree(p, [-1] * leaders, [0] * leaders, [0] * leaders, {}), 0
    for number, (parent, by) in enumerate(zip(pairs[::2], pairs[1::2], strict=True), leaders):
        if parent == -1:
            require(by == extra < len(extras), f"vertex {number} is not the next extra vertex")
            extra += 1
        else:
            require(0 <= parent < number, f"vertex {number} does not come after its parent")
            require(0 <= by < p, f"vertex {number} is made by a letter that is not there")
            require(parent * p + by not in tree.children, f"vertex {number} is one that is there already")
            tree.children[parent * p + by] = number
        tree.parents.append(parent)
        tree.by.append(by)
        tree.depths.append(tree.depths[parent] + 1 if parent >= 0 and tree.depths[parent] >= 0 else -1)
    require(extra == len(extras), "an extra vertex is not in the tree")
    return tree


def ties_work(c: Claim, family: Family, root: Root, tree: Tree) -> int:
    """n d N², and for each tie N g (g + its weights), g = d + the span of 0 and its e_k."""
    d, order = len(root.polynomial) - 1, family.order
    work = len(tree.parents) * d * order**2 if c.witness["ties"] else 0
    for tie in c.witness["ties"]:
        exponents = [0, *_exponents(c, tree, tie)]
        span = d + max(exponents) - min(exponents)
        work += order * span * (span + len(tie["weights"]))
    return work


def _exponents(c: Claim, tree: Tree, tie: dict[str, Any]) -> list[int]:
    """The e_k with M_i X_u = Σ c_k Λ^(e_k) X_k where v = X/σ^depth: depth(u) + 1 - depth(k) = ℓ e_k."""
    n, length, exponents = len(tree.parents), c.statement["length"], []
    require(tie["vertex"] < n, "a tie is of a vertex that is not there")
    require(tree.depths[tie["vertex"]] >= 0, "a tie is of an extra vertex")
    for share in tie["weights"]:
        require(share["vertex"] < (2 * n if c.witness["symmetry"] else n), "a tie is with a vertex that is not there")
        depth = tree.depths[share["vertex"] % n]
        require(depth >= 0, "a tie is with an extra vertex")
        exponent, rest = divmod(tree.depths[tie["vertex"]] + 1 - depth, length)
        require(rest == 0, "a tie has depths that do not differ by a multiple of ℓ")
        exponents.append(exponent)
    return exponents


def check_ties(
    c: Claim,
    family: Family,
    root: Root,
    tree: Tree,
    leaders: list[Vector],
    smaller: Callable[[dict[str, Any], int], bool],
) -> None:
    """The identities of ties, for polynomials in Λ modulo its m: both sides times a power of Λ where some e_k < 0.

    They hold in every coordinate where the image is not `smaller`, if that suffices.
    """
    ties, n = c.witness["ties"], len(tree.parents)
    exact = _exact(c, family, tree, leaders)
    for tie in ties:
        weights = [share["weight"] for share in tie["weights"]]
        require(sum(map(abs, weights)) <= 1, "the weights of a tie are more than 1")
        exponents = _exponents(c, tree, tie)
        shift = -min([0, *exponents])
        image = exact[tie["vertex"]].image(family.matrices[tie["letter"]], family.denominator)
        terms = [(Fraction(-1), shift, image)]
        for share, weight, exponent in zip(tie["weights"], weights, exponents, strict=True):
            k = share["vertex"]
            terms.append((weight, exponent + shift, exact[k] if k < n else exact[k - n].reflected()))
        bits = sum(fraction_bits(weight) + x.bits for weight, _, x in terms)
        lead = (max(exponents, default=0) + shift) * max(map(abs, root.polynomial)).bit_length()
        c.spend(family.order * len(root.polynomial) * (len(terms) + max(exponents, default=0) + shift), bits + lead)
        where = f"vertex {tie['vertex']} by letter {tie['letter']}"
        unequal = nonzero_coordinates(terms, root.polynomial)
        require(all(smaller(tie, i) for i in unequal), f"the tie of {where} does not hold")


def _exact(c: Claim, family: Family, tree: Tree, leaders: list[Vector]) -> dict[int, Vector]:
    """X_u for the vertices in ties and those they come from, X a leader or M_letter X_parent."""
    n, needed = len(tree.parents), set()
    for tie in c.witness["ties"]:
        needed |= {tie["vertex"], *(share["vertex"] % n for share in tie["weights"])}
    for u in range(n - 1, -1, -1):
        if u in needed and tree.parents[u] >= 0:
            needed.add(tree.parents[u])
    exact: dict[int, Vector] = {}
    for u in sorted(needed):
        if (parent := tree.parents[u]) < 0:
            exact[u] = leaders[u]
        else:
            x = exact[parent]
            c.spend(len(x.powers) * family.order**2, max(family.bits, x.bits))
            exact[u] = x.image(family.matrices[tree.by[u]], family.denominator)
    return exact
