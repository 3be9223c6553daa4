"""Vertices of closed polytopes, real or complex: leaders, the tree of what comes of them, in fixed point, and images.

σ = Λ^(1/n), n the length that the statement names. A complex vector is (Re, Im), a real one of twice the length, on
both halves of which the matrices act. An image is a pair (u, i), M_i v_u / σ, known by the number u p + i.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import lcm
from typing import Any, NamedTuple

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.polynomials import remainder
from subdiv_cli.checker.radius.eigenvectors import Vector, leading_eigenvector, size_of_leader
from subdiv_cli.checker.reading import MAX_VERTICES, Rejected, require, require_few
from subdiv_cli.checker.roots import RealRoot, enclose, fraction_bits, inverse_scale

HEADROOM = 64
"""The bits of a coordinate, which is below 2^64."""
EXTRA_BITS = 30
"""The binary places of an extra vertex, integers / 2^30."""


class Tree(NamedTuple):
    """The origins of the vertices, reflections aside: leaders first, then what comes of them and of extra vertices."""

    letters: int
    parents: list[int]
    """The parent of each vertex; -1 for a leader or an extra vertex."""
    by: list[int]
    """The letter that makes the vertex of its parent; of an extra vertex its number."""
    depths: list[int]
    """The edges from the leader; below zero for extra vertices and what comes of them."""
    children: dict[int, int]
    """The vertex that each image is, by the number of the image."""


def read_tree(c: Claim, family: RationalFamily) -> Tree:
    """The tree of the claim's witness. Raises Rejected for one that is not well formed, Exhausted for a large one."""
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


def returns_of(c: Claim, tree: Tree, length: int) -> set[int]:
    """The images that are a leader or its reflection, turned: by the last letter of its word after all others."""
    returns = set()
    for number, leader in enumerate(c.witness["leaders"]):
        word, u = leader["word"], number
        require(len(word) == length, f"the word of leader {number} is of another length")
        require(max(word) < tree.letters, f"the word of leader {number} has a letter that is not there")
        for letter in word[:-1]:
            require(u * tree.letters + letter in tree.children, f"the path of leader {number} is not in the tree")
            u = tree.children[u * tree.letters + letter]
        image = u * tree.letters + word[-1]
        require(image not in tree.children, f"the return of leader {number} is in the tree")
        returns.add(image)
    return returns


def leader_of(c: Claim, family: RationalFamily, leader: dict[str, Any], sign: int, m: Sequence[int]) -> Vector:
    """The vector x with Π x = sign γ x, exactly, γ any zero of m: g(Π) y = 0 and m(z) divides g(sign z).

    y = e_j or as given. The word has been looked at. Where the leader is reflected, Π is J times the word's product,
    and Π² = ± the product of the mirrored word times that. Raises Rejected where x is not such a vector.
    """
    order, g = family.order, leader["annihilator"]
    require(sign != 0 and leader["scale"] > 0, "the sign of a leader is not 1 or -1, or its scale not positive")
    start = _start(leader["column"], order)
    require(2 <= len(g) <= order + 1 and g[-1] != 0, "the annihilator of a leader is not of a degree 1, …, N")
    c.spend(1, sum(map(fraction_bits, g)))
    common = lcm(*(x.denominator for x in g))
    at_sign = [x.numerator * (common // x.denominator) * sign**k for k, x in enumerate(g)]
    sizes = size_of_leader(start, len(leader["word"]), family.bits, (*at_sign, common), leader["scale"], m)
    for operations, bits in sizes:
        c.spend(operations, bits)
    matrix, denominator = family.product(leader["word"])
    if leader["reflected"]:
        require(c.witness["symmetry"] != 0, "a leader is reflected, and nothing is symmetric")
        matrix = matrix[::-1]
    require(not remainder(at_sign, m), "the eigenvalue's polynomial does not divide the annihilator of a leader")
    x = leading_eigenvector((matrix, denominator), g, sign, start, leader["scale"], m)
    if x is None:
        raise Rejected("the annihilator of a leader does not vanish on its column")
    return x


def _start(column: int | tuple[int, ...], order: int) -> Sequence[int]:
    """The unit vector e_j, or the combination of these that is given, with N coordinates."""
    if isinstance(column, int):
        require(column < order, "the column of a leader is not there")
        return [int(i == column) for i in range(order)]
    require(len(column) == order, "the combination of columns of a leader does not have N coefficients")
    return column


class Vertices:
    """The vertices as integers / 2^bits, each with one error for all its coordinates, in units of 2^-bits."""

    def __init__(self, c: Claim, family: RationalFamily, root: RealRoot, more_bits: int = 0) -> None:
        """Enclose Λ in `at`, with so many more bits than the vertices have."""
        bits = c.witness["bits"]
        tiny = max(0, root.low.denominator.bit_length() - root.low.numerator.bit_length() + 1)
        self.at = enclose(c, root, bits + 2 * tiny + 2 + more_bits)
        scale = inverse_scale(c, self.at, c.statement["length"], bits)
        self._claim, self._family, self._bits = c, family, bits
        self._value, self._error = scale.value, scale.error
        self._below = family.denominator << bits
        self._rows = [max(sum(map(abs, row)) for row in matrix) for matrix in family.matrices]
        self.vectors: list[list[int]] = []
        self.errors: list[int] = []

    def grow(self, tree: Tree, leaders: Iterable[tuple[list[int], int]]) -> None:
        """Compute the leaders, none of which may be zero, and then the tree."""
        for v, error in leaders:
            require(max(map(abs, v)) > error, "a leader may be zero")
            self._add(v, error)
        size, count = len(self.vectors[0]), len(self.vectors)
        longest = self._bits + HEADROOM + self._family.bits + self._value.bit_length()
        self._claim.spend(tree.letters * len(tree.parents) * size, longest)
        for parent, by in zip(tree.parents[count:], tree.by[count:], strict=True):
            if parent < 0:
                extra = [(x << self._bits) >> EXTRA_BITS for x in self._claim.witness["extras"][by]]
                self._add(extra + [0] * (size - self._family.order), 1)
            else:
                self._add(*self.image(parent, by))

    def _add(self, v: list[int], error: int) -> None:
        limit = 1 << (self._bits + HEADROOM)
        require_few(max(map(abs, v)) < limit and error < limit, f"vertex {len(self.vectors)} is too large")
        self.vectors.append(v)
        self.errors.append(error)

    def image(self, u: int, letter: int) -> tuple[list[int], int]:
        """The vector M_letter v_u / σ, rounded down, and its error.

        With g = 1/σ in [G, G + γ]/2^bits, v = w + δ, |δ_i| <= ε: g M v - (G/2^bits) M w = g M δ + (g - G/2^bits) M w is
        at most g ‖M‖∞ ε + (γ/2^bits) max |M w|. One unit more for each of the two roundings.
        """
        v, order, matrix = self.vectors[u], self._family.order, self._family.matrices[letter]
        y = [x for k in range(0, len(v), order) for x in matrices.apply(matrix, v[k : k + order])]
        error = (self._value + self._error) * self._rows[letter] * self.errors[u] + self._error * max(map(abs, y))
        return [self._value * x // self._below for x in y], error // self._below + 2


def weighted(c: Claim, tree: Tree, taken: set[int]) -> Iterator[tuple[int, int, list[int]]]:
    """The triples (u, letter, weights) of all images but those taken, in order; each of them must have weights."""
    insides = [image for image in range(len(tree.parents) * tree.letters) if image not in taken]
    given = c.witness["images"]
    require(len(insides) == len(given), f"there are {len(insides)} images inside, not as many as weights")
    for image, weights in zip(insides, given, strict=True):
        yield *divmod(image, tree.letters), weights
