"""The tree of a closed polytope's vertices, and its ties: images that are combinations of vertices exactly."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.eigenvectors import Vector, common_denominator, nonzero_coordinates
from subdiv_cli.checker.elements import Element, bounds, element_bits, is_zero, longest_numerator, power, times
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.reading import MAX_VERTICES, require, require_few
from subdiv_cli.checker.roots import Enclosure, Root


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
    require(len(pairs) % 2 == 0, "there is half an edge")
    require_few(leaders + len(pairs) // 2 <= MAX_VERTICES, "there are too many vertices")
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
    """n d N², and for each tie N g (g + its weights), g = d + the span of 0 and its e_k + the longest weight.

    With σ besides d² for every product: ℓ, and (1 + its weights) (the span of its e_k) for each tie.
    """
    d, order, sigma = len(root.polynomial) - 1, family.order, "sigma" in c.witness
    work = len(tree.parents) * d * order**2 if c.witness["ties"] else 0
    work += c.statement["length"] * d**2 if sigma else 0
    for tie in c.witness["ties"]:
        exponents, shares = [0, *_exponents(c, tree, tie)], tie["weights"]
        steps = max(exponents) - min(exponents)
        span = d + steps + max((len(share["weight"]) for share in shares), default=0)
        work += order * span * (span + len(shares)) + ((1 + len(shares)) * steps * d**2 if sigma else 0)
    return work


def _exponents(c: Claim, tree: Tree, tie: dict[str, Any]) -> list[int]:
    """The e_k with M_i X_u = Σ c_k Λ^(e_k) X_k where v = X/σ^depth: depth(u) + 1 - depth(k) = ℓ e_k; with σ for Λ

    where that is given, and then 1 for ℓ.
    """
    n, exponents = len(tree.parents), []
    length = 1 if "sigma" in c.witness else c.statement["length"]
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


Smaller = Callable[[dict[str, Any], Sequence[tuple[Fraction, Fraction]], int], bool]
"""Whether a coordinate of a tie's image is certainly at most that of the combination, whose weights are enclosed."""


class Ties:
    """The ties of a polytope, checked for polynomials in Λ modulo its m."""

    def __init__(self, c: Claim, family: Family, root: Root, tree: Tree, leaders: list[Vector], at: Enclosure) -> None:
        self._c, self._family, self._tree, self._at, self._m = c, family, tree, at, root.polynomial
        self._exact = _exact(c, family, tree, leaders)
        self._sigma: Element | None = c.witness.get("sigma")
        if self._sigma is not None:
            self._check_sigma(self._sigma, c.statement["length"])

    def _check_sigma(self, sigma: Element, length: int) -> None:
        require(0 < len(sigma) < len(self._m), "σ is no polynomial of a degree below that of m")
        self._spend_powers(length)
        difference = list(power(sigma, length, self._m)) + [Fraction(0)] * 2
        difference[1] -= 1
        require(is_zero(difference, self._m), "the power of σ is not Λ")
        require(self._bounds(sigma)[0] > 0, "σ may be negative")

    def _spend_powers(self, n: int) -> None:
        bits = element_bits(self._sigma or ()) + len(self._m) * max(map(abs, self._m)).bit_length()
        self._c.spend(n * len(self._m) ** 2, n * bits)

    def _bounds(self, x: Element) -> tuple[Fraction, Fraction]:
        self._c.spend(4 * len(x), len(x) * self._at.scale.bit_length() + element_bits(x))
        return bounds(x, self._at)

    def check(self, tie: dict[str, Any], smaller: Smaller | None) -> None:
        """M_i v_u / σ = Σ c_k v_k and Σ |c_k| <= 1.

        With `smaller` c_k >= 0, and the image may be smaller in a coordinate.
        """
        weights = [share["weight"] for share in tie["weights"]]
        ranges = [self._bounds(weight) for weight in weights]
        self._check_sum(weights, ranges)
        unequal = nonzero_coordinates(self._terms(tie, weights), self._m)
        where = f"vertex {tie['vertex']} by letter {tie['letter']}"
        if smaller is None:
            require(not unequal, f"the tie of {where} does not hold")
            return
        require(all(low >= 0 for low, _ in ranges), "a weight of a tie may be negative")
        require(all(smaller(tie, ranges, i) for i in unequal), f"the tie of {where} does not hold")

    def _check_sum(self, weights: Sequence[Element], ranges: Sequence[tuple[Fraction, Fraction]]) -> None:
        """Σ |c_k| - 1 is zero at Λ, or enclosed below."""
        require(all(low >= 0 or high <= 0 for low, high in ranges), "a weight of a tie may have both signs")
        excess = [Fraction(-1)] + [Fraction(0)] * (max(map(len, weights), default=1) - 1)
        for weight, (low, _) in zip(weights, ranges, strict=True):
            for k, x in enumerate(weight):
                excess[k] += x if low >= 0 else -x
        self._c.spend(len(excess) * len(self._m), element_bits(excess))
        few = is_zero(excess, self._m) or self._bounds(excess)[1] <= 0
        require(few, "the weights of a tie are more than 1")

    def _terms(self, tie: dict[str, Any], weights: Sequence[Element]) -> list[tuple[Element, Vector]]:
        """Both sides times a power of Λ, or of σ, where some e_k < 0; the left one with a minus."""
        c, n = self._c, len(self._tree.parents)
        exponents = _exponents(c, self._tree, tie)
        shift = -min([0, *exponents])
        image = self._exact[tie["vertex"]].image(self._family.matrices[tie["letter"]], self._family.denominator)
        terms = [(times([Fraction(-1)], self._power(shift)), image)]
        for share, weight, exponent in zip(tie["weights"], weights, exponents, strict=True):
            k = share["vertex"]
            x = self._exact[k] if k < n else self._exact[k - n].reflected()
            terms.append((times(weight, self._power(exponent + shift)), x))
        c.spend(sum(len(cs) for cs, _ in terms), sum(element_bits(cs) + x.bits for cs, x in terms))
        bits = common_denominator(terms).bit_length() + max(longest_numerator(cs) + x.bits for cs, x in terms)
        longest = max(len(cs) for cs, _ in terms)
        lead = longest * max(map(abs, self._m)).bit_length()
        c.spend(self._family.order * len(self._m) * (sum(len(cs) for cs, _ in terms) + longest), bits + lead)
        return terms

    def _power(self, exponent: int) -> Element:
        if self._sigma is None:
            return [Fraction(0)] * exponent + [Fraction(1)]
        self._spend_powers(exponent)
        return power(self._sigma, exponent, self._m)


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
