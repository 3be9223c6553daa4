"""The closed polytope of a complex leading eigenvalue μ: JSR^(2ℓ) = |μ|² = Λ exactly.

As in `closing`, with complex vertices: P is the hull of all e^(iθ) v, v a vertex, its conjugate or a reflection of
one of these. A complex vector z is the real one (Re z, Im z) of twice the length, on which the matrices act twice; P
contains the real hull of all ±v and ±iv, so what is inside by `polytopes.Body` is inside here.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.disc import modulus_is, read_disc
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.polytopes import Body, body
from subdiv_cli.checker.reading import require
from subdiv_cli.checker.roots import isolated_root
from subdiv_cli.checker.trees import Tree, read_tree
from subdiv_cli.checker.vertices import HEADROOM, Vertices, leader_of, returns_of, weighted


def complex_closing(c: Claim) -> None:
    """Π x = μ x ≠ 0 for a product Π of ℓ matrices and |μ|² = Λ, so JSR^(2ℓ) >= Λ; and M_i P ⊂ σ P, σ = Λ^(1/(2ℓ)).

    M_i commutes with e^(iθ) and with conjugation, so only the images of vertices themselves are looked at.
    """
    family, root, twice = c.family(), isolated_root(c), c.statement["length"]
    tree, leaders = read_tree(c, family), c.witness["leaders"]
    require(twice % 2 == 0, "the length is odd")
    _count(c, family, tree, twice // 2)
    first = {key: leaders[0][key] for key in ("factor", "center", "distance")}
    for leader in leaders:
        require(all(leader[key] == first[key] for key in first), "the leaders have different eigenvalues")
    disc = read_disc(c, **first)
    require(modulus_is(c, disc, root), "the eigenvalue does not have that modulus")
    returns = returns_of(c, tree, twice // 2)
    vectors = [leader_of(c, family, leader, 1, disc.polynomial) for leader in leaders]
    vertices = Vertices(c, family, root)
    vertices.grow(tree, (disc.enclosed(c, x, c.witness["bits"]) for x in vectors))
    _check_insides(c, family, vertices, tree, {*tree.children, *returns})


def _count(c: Claim, family: Family, tree: Tree, length: int) -> None:
    order, weights = family.order, sum(map(len, c.witness["images"])) // 3
    work = 2 * tree.letters * len(tree.parents) * order**2 + 4 * weights * order + 8 * order**3
    c.count(work + len(c.witness["leaders"]) * (length + 1) * order**3, max(family.bits, c.witness["bits"] + HEADROOM))


def _copies(c: Claim, family: Family, vertices: list[list[int]]) -> list[list[int]]:
    """The vertices, their conjugates, and the reflections of both where the symmetry of the family is claimed."""
    n = family.order
    both = vertices + [v[:n] + [-x for x in v[n:]] for v in vertices]
    if (sign := c.witness["symmetry"]) == 0:
        return both
    require(family.is_symmetric(sign), "the matrices do not have that symmetry")
    return both + [v[:n][::-1] + v[n:][::-1] for v in both]


def _check_insides(c: Claim, family: Family, vertices: Vertices, tree: Tree, taken: set[int]) -> None:
    """All images but those taken lie inside, by their weights."""
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

    body: Body
    vertices: int

    def contains(self, image: Sequence[int], error: int, weights: Sequence[int]) -> bool:
        """As `Body.contains`, weights k, Re c, Im c, …: c v = Re c · v + Im c · iv has the size |c| and no more."""
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
