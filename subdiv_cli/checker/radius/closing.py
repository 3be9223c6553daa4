"""The closed polytope: its vertices are words of the family applied to leading eigenvectors, and JSR^ℓ = Λ exactly.

Vertices are numbered as RADIUS.md says: the leaders, the tree, then their reflections.

A complex leading eigenvalue μ, JSR^(2ℓ) = |μ|² = Λ, has complex vertices: P is the hull of all e^(iθ) v, v a vertex,
its conjugate or a reflection of one of these. A complex vector z is the real one (Re z, Im z) of twice the length, on
which the matrices act twice; P contains the real hull of all ±v and ±iv, so what is inside by
`polytopes.SymmetricBody` is inside here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import isqrt
from operator import mul
from typing import Any, NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.radius.disc import modulus_is, read_disc
from subdiv_cli.checker.radius.eigenvectors import Vector, enclosed, slope_bits
from subdiv_cli.checker.radius.polytopes import (
    MonotoneBody,
    SymmetricBody,
    body,
    monotone_body,
    reflected,
    require_nonnegative,
    weight_count,
)
from subdiv_cli.checker.radius.ties import ExactTies, Smaller, ties_work
from subdiv_cli.checker.radius.vertices import HEADROOM, Tree, Vertices, leader_of, read_tree, returns_of, weighted
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import RealRoot, fraction_bits, isolated_root


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
    """JSR^ℓ = Λ, by the monotone hull P of the v >= 0: |M_i z| <= M_i |z| is in σ P for all z in P.

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
    """A closed polytope with its tree, returns, ties, leaders and enclosures of the vertices, as they are checked."""

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
        """Check that each coordinate of a leader is certainly positive, or zero.

        It is zero where m, of a degree above that of its polynomial, divides it.
        """
        for x, v, error in zip(self._leaders, self._hull, self._errors, strict=False):
            positive = (y > error or not any(power[i] for power in x.powers) for i, y in enumerate(v))
            require(all(positive), "a coordinate of a leader may be negative")

    def check_insides(self, make: Callable[..., SymmetricBody | MonotoneBody]) -> None:
        """Check that all images but edges, returns and ties lie inside, by their weights."""
        w = self._c.witness
        hull = make(self._c, self._hull, self._errors, w["basis"], w["weight_bits"], w["bits"] + HEADROOM)
        for u, letter, weights in weighted(self._c, self._tree, {*self._tree.children, *self._returns, *self._ties}):
            middle, error = self._vertices.image(u, letter)
            where = f"the image of vertex {u} by letter {letter}"
            require(hull.contains(middle, 1, error, weights), f"{where} is not inside")

    def check_ties(self, smaller: Smaller | None) -> None:
        if not self._ties:
            return
        ties = ExactTies(self._c, self._family, self._root, self._tree, self._leaders, self._vertices.at)
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


def _count(c: Claim, family: RationalFamily, root: RealRoot, tree: Tree) -> None:
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


def complex_closing(c: Claim) -> None:
    """Π x = μ x ≠ 0 for a product Π of ℓ matrices and |μ|² = Λ, so JSR^(2ℓ) >= Λ; and M_i P ⊂ σ P, σ = Λ^(1/(2ℓ)).

    M_i commutes with e^(iθ) and with conjugation, so only the images of vertices themselves are looked at.
    """
    family, root, twice = c.family(), isolated_root(c), c.statement["length"]
    tree, leaders = read_tree(c, family), c.witness["leaders"]
    require(twice % 2 == 0, "the length is odd")
    _count_complex(c, family, tree, twice // 2)
    first = {key: leaders[0][key] for key in ("factor", "center", "distance")}
    for leader in leaders:
        require(all(leader[key] == first[key] for key in first), "the leaders have different eigenvalues")
    disc = read_disc(c, **first)
    require(modulus_is(c, disc, root), "the eigenvalue does not have that modulus")
    returns = returns_of(c, tree, twice // 2)
    vectors = [leader_of(c, family, leader, 1, disc.polynomial) for leader in leaders]
    vertices = Vertices(c, family, root)
    vertices.grow(tree, (disc.enclosed(c, x, c.witness["bits"]) for x in vectors))
    _check_complex_insides(c, family, vertices, tree, {*tree.children, *returns})


def _count_complex(c: Claim, family: RationalFamily, tree: Tree, length: int) -> None:
    order, weights = family.order, sum(map(len, c.witness["images"])) // 3
    work = 2 * tree.letters * len(tree.parents) * order**2 + 4 * weights * order + 8 * order**3
    c.count(work + len(c.witness["leaders"]) * (length + 1) * order**3, max(family.bits, c.witness["bits"] + HEADROOM))


def _copies(c: Claim, family: RationalFamily, vertices: list[list[int]]) -> list[list[int]]:
    """The vertices, their conjugates, and the reflections of both where the symmetry of the family is claimed."""
    n = family.order
    both = vertices + [v[:n] + [-x for x in v[n:]] for v in vertices]
    if (sign := c.witness["symmetry"]) == 0:
        return both
    require(family.is_symmetric(sign), "the matrices do not have that symmetry")
    return both + [v[:n][::-1] + v[n:][::-1] for v in both]


def _check_complex_insides(c: Claim, family: RationalFamily, vertices: Vertices, tree: Tree, taken: set[int]) -> None:
    """Check that all images but those taken lie inside, by their weights."""
    w, n = c.witness, family.order
    copies = _copies(c, family, vertices.vectors)
    errors = vertices.errors * (len(copies) // len(vertices.errors))
    turned = [[-x for x in v[n:]] + v[:n] for v in copies]
    numbers = [*w["basis"], *(k + len(copies) for k in w["basis"])]
    hull = _Hull(body(c, copies + turned, errors * 2, numbers, w["weight_bits"], w["bits"] + HEADROOM), len(copies))
    for u, letter, weights in weighted(c, tree, taken):
        middle, error = vertices.image(u, letter)
        require(hull.contains(middle, error, weights), f"the image of vertex {u} by letter {letter} is not inside")


class _Hull(NamedTuple):
    """The hull of all e^(iθ) v; the body has the vertices v and after them all iv."""

    body: SymmetricBody
    vertices: int

    def contains(self, image: Sequence[int], error: int, weights: Sequence[int]) -> bool:
        """Whether an image is inside, as in `SymmetricBody`, by weights k, Re c, Im c, ….

        c v = Re c · v + Im c · iv has the size |c| and no more.
        """
        numbers, re, im, w = weights[::3], weights[1::3], weights[2::3], self.body.weight_bits
        require(len(numbers) == len(re) == len(im) == len(set(numbers)), "a weight is not complete, or stands twice")
        require(all(0 <= k < self.vertices for k in numbers), "a weight is for a vertex that is not there")
        members = [*numbers, *(k + self.vertices for k in numbers)]
        cs = [*re, *im]
        columns = zip(*[self.body.vertices[k] for k in members], strict=True) if cs else ((),) * len(image)
        rest = sum(abs((x << w) - sum(map(mul, cs, column))) for x, column in zip(image, columns, strict=True))
        sizes = sum(1 + isqrt(a * a + b * b) for a, b in zip(re, im, strict=True))
        error = (error << w) + sum(map(mul, map(abs, cs), [self.body.errors[k] for k in members]))
        factor: Fraction = self.body.factor
        return bool((rest + len(image) * error) * factor.numerator <= ((1 << w) - sizes) * factor.denominator)
