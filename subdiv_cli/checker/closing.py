"""The closed polytope: its vertices are words of the family applied to leading eigenvectors, and JSR^ℓ = Λ exactly.

σ = Λ^(1/ℓ). Vertices are numbered as RADIUS.md says: the leaders, the tree, then their reflections. An image is a pair
(u, i), M_i v_u / σ, known by the number u p + i.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import isqrt, lcm
from typing import Any

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.eigenvectors import Vector, enclosed, leading_eigenvector, slope_bits
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.monotone import MonotoneBody, monotone_body, require_nonnegative
from subdiv_cli.checker.polynomials import remainder
from subdiv_cli.checker.polytopes import Body, body, reflected, weight_count
from subdiv_cli.checker.reading import Rejected, require, require_few
from subdiv_cli.checker.roots import Root, enclose, fraction_bits, inverse_scale, isolated_root
from subdiv_cli.checker.trees import Smaller, Ties, Tree, read_tree, ties_work

HEADROOM = 64
"""A coordinate is below 2^64."""
EXTRA_BITS = 30
"""An extra vertex is integers / 2^30."""


def closing(c: Claim) -> None:
    """JSR^ℓ = Λ, and products of L matrices are at most a constant times σ^L.

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
        self._leaders = [_leader(c, self._family, self._root, leader) for leader in c.witness["leaders"]]
        self._images = _Enclosures(c, self._family, self._root, self._tree, self._leaders)
        self._vertices = reflected(c, self._family, self._images.vertices)
        self._errors = self._images.errors * (len(self._vertices) // len(self._images.errors))

    def require_nonnegative_leaders(self) -> None:
        """Each coordinate is certainly positive, or zero: m, of a degree above that of its polynomial, divides it."""
        for x, v, error in zip(self._leaders, self._images.vertices, self._images.errors, strict=False):
            positive = (y > error or not any(power[i] for power in x.powers) for i, y in enumerate(v))
            require(all(positive), "a coordinate of a leader may be negative")

    def check_insides(self, make: Callable[..., Body | MonotoneBody]) -> None:
        """All images but edges, returns and ties lie inside, by their weights."""
        w, tree = self._c.witness, self._tree
        taken = {*tree.children, *self._returns, *self._ties}
        hull = make(self._c, self._vertices, self._errors, w["basis"], w["weight_bits"], w["bits"] + HEADROOM)
        insides = [image for image in range(len(tree.parents) * tree.letters) if image not in taken]
        require(len(insides) == len(w["images"]), f"there are {len(insides)} images inside, not as many as weights")
        for image, weights in zip(insides, w["images"], strict=True):
            u, letter = divmod(image, tree.letters)
            middle, error = self._images.of(u, letter)
            where = f"the image of vertex {u} by letter {letter}"
            require(hull.contains(middle, 1, error, weights), f"{where} is not inside")

    def check_ties(self, smaller: Smaller | None) -> None:
        if not self._ties:
            return
        ties = Ties(self._c, self._family, self._root, self._tree, self._leaders, self._images.at)
        for tie in self._c.witness["ties"]:
            ties.check(tie, smaller)

    def is_smaller(self, tie: dict[str, Any], weights: Sequence[tuple[Fraction, Fraction]], coordinate: int) -> bool:
        """Whether this coordinate of the image is certainly at most that of the combination; weights are enclosed."""
        middle, error = self._images.of(tie["vertex"], tie["letter"])
        bits = sum(fraction_bits(x) for pair in weights for x in pair)
        self._c.spend(len(weights), self._c.witness["bits"] + HEADROOM + bits)
        total = Fraction(0)
        for share, (low, high) in zip(tie["weights"], weights, strict=True):
            least = self._vertices[share["vertex"]][coordinate] - self._errors[share["vertex"]]
            total += min(low * least, high * least)
        return total >= middle[coordinate] + error


def _count(c: Claim, family: Family, root: Root, tree: Tree) -> None:
    n, order, length = len(tree.parents), family.order, c.statement["length"]
    work = tree.letters * n * order**2 + weight_count(c) * order + order**3
    work += len(c.witness["leaders"]) * (length + 1) * order**3
    work += ties_work(c, family, root, tree)
    c.count(work, max(family.bits, c.witness["bits"] + HEADROOM))


def returns_of(c: Claim, tree: Tree, length: int) -> set[int]:
    """The images that are ± a leader, or its reflection: by the last letter of its word after all others."""
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


def _tied(c: Claim, tree: Tree, returns: set[int]) -> list[int]:
    ties = []
    for tie in c.witness["ties"]:
        require(tie["letter"] < tree.letters, "a tie is by a letter that is not there")
        ties.append(tie["vertex"] * tree.letters + tie["letter"])
    require(ties == sorted(set(ties)), "the ties are not in order")
    require(not any(image in tree.children or image in returns for image in ties), "a tie is an edge or a return")
    return ties


def _leader(c: Claim, family: Family, root: Root, leader: dict[str, Any]) -> Vector:
    """x with Π x = sΛ x, in polynomials in Λ."""
    require(leader["sign"] != 0, "the sign of a leader is not 1 or -1")
    return eigenvector(c, family, leader, leader["sign"], root.polynomial)


def eigenvector(c: Claim, family: Family, leader: dict[str, Any], sign: int, m: Sequence[int]) -> Vector:
    """x with Π x = μ x for μ = s times a root of m, exactly, where g(Π) e_j = 0 and m(x) divides g(s x).

    Its word has been looked at. Where it is reflected, Π is J times the word's product, and Π² = ± the product of the
    mirrored word times that.
    """
    order, word, g = family.order, leader["word"], leader["annihilator"]
    require(leader["scale"] > 0 and leader["column"] < order, "the scale is not positive, or the column not there")
    require(2 <= len(g) <= order + 1 and g[-1] != 0, "the annihilator of a leader is not of a degree 1, …, N")
    common = lcm(*(x.denominator for x in g))
    at_sign = [x.numerator * (common // x.denominator) * sign**k for k, x in enumerate(g)]
    _spend_eigenvector(c, family, word, max(map(abs, at_sign)).bit_length() + common.bit_length(), len(g), m)
    require(not remainder(at_sign, m), "the polynomial of the eigenvalue does not divide the annihilator of a leader")
    matrix, denominator = family.product(word)
    if leader["reflected"]:
        require(c.witness["symmetry"] != 0, "a leader is reflected, and nothing is symmetric")
        matrix = matrix[::-1]
    x = leading_eigenvector((matrix, denominator), g, sign, leader["column"], leader["scale"], m)
    if x is None:
        raise Rejected("the annihilator of a leader does not vanish on its column")
    return x


def _spend_eigenvector(c: Claim, family: Family, word: Sequence[int], bits: int, terms: int, m: Sequence[int]) -> None:
    """Of `eigenvector`, an annihilator with so many terms, `bits` long; a product costs as its geometric mean squared.

    The word's product; remainders by m, which lengthen what is left by m; Horner's rule, which lengthens vectors by the
    product; a greatest common divisor for each of their coordinates.
    """
    order, by_m = family.order, max(map(abs, m)).bit_length()
    product = len(word) * (family.bits + order.bit_length())
    steps = max(0, terms - len(m)) + 1
    rest, vector = bits + steps * by_m, bits + terms * product
    c.spend(len(word) * order**3, product)
    c.spend(2 * steps * len(m), isqrt(rest * by_m))
    c.spend(terms * order**2, isqrt(vector * product))
    c.spend(2 * steps * order * len(m), isqrt((vector + steps * by_m) * by_m))
    c.spend(len(m) + order * terms, max(rest, vector + steps * by_m))


class _Enclosures:
    """Vertices as integers / 2^bits, each with one error for all its coordinates, in units of 2^-bits."""

    def __init__(self, c: Claim, family: Family, root: Root, tree: Tree, leaders: list[Vector]) -> None:
        bits, d = c.witness["bits"], len(root.polynomial) - 1
        tiny = max(0, root.low.denominator.bit_length() - root.low.numerator.bit_length() + 1)
        self.at = at = enclose(c, root, bits + 2 * tiny + 2 + max(slope_bits(x, root.high) for x in leaders))
        scale = inverse_scale(c, at, c.statement["length"], bits)
        self._matrices, self._value, self._error = family.matrices, scale.value, scale.error
        self._below = family.denominator << bits
        self._rows = [max(sum(map(abs, row)) for row in matrix) for matrix in family.matrices]
        self.vertices: list[list[int]] = []
        self.errors: list[int] = []
        images = tree.letters * len(tree.parents)
        c.spend(images * family.order, bits + HEADROOM + family.bits + scale.value.bit_length())
        for x in leaders:
            c.spend(3 * family.order * d, x.bits + d * (at.low.bit_length() + at.scale.bit_length()))
            v, error = enclosed(x, at, bits)
            require(max(map(abs, v)) > error, "a leader may be zero")
            self._add(v, error, bits)
        for parent, by in zip(tree.parents[len(leaders) :], tree.by[len(leaders) :], strict=True):
            if parent < 0:
                self._add([(x << bits) >> EXTRA_BITS for x in c.witness["extras"][by]], 1, bits)
            else:
                self._add(*self.of(parent, by), bits)

    def _add(self, v: list[int], error: int, bits: int) -> None:
        limit = 1 << (bits + HEADROOM)
        require_few(max(map(abs, v)) < limit and error < limit, f"vertex {len(self.vertices)} is too large")
        self.vertices.append(v)
        self.errors.append(error)

    def of(self, u: int, letter: int) -> tuple[list[int], int]:
        """M_letter v_u / σ, rounded down, and its error.

        With g = 1/σ in [G, G + γ]/2^bits, v = w + δ, |δ_i| <= ε: g M v - (G/2^bits) M w = g M δ + (g - G/2^bits) M w is
        at most g ‖M‖∞ ε + (γ/2^bits) max |M w|. One unit more for each of the two roundings.
        """
        y = matrices.apply(self._matrices[letter], self.vertices[u])
        error = (self._value + self._error) * self._rows[letter] * self.errors[u] + self._error * max(map(abs, y))
        return [self._value * x // self._below for x in y], error // self._below + 2
