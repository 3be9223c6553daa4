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

from subdiv_cli.checker import matrices
from subdiv_cli.checker.closing import EXTRA_BITS, HEADROOM, eigenvector, returns_of
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.disc import Disc, modulus_is, read_disc
from subdiv_cli.checker.matrices import Family
from subdiv_cli.checker.polytopes import Body, body
from subdiv_cli.checker.reading import require, require_few
from subdiv_cli.checker.roots import Root, enclose, inverse_scale, isolated_root
from subdiv_cli.checker.trees import Tree, read_tree


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
    images = _Enclosures(c, family, root, tree, disc)
    _check_insides(c, family, images, tree, {*tree.children, *returns})


def _count(c: Claim, family: Family, tree: Tree, length: int) -> None:
    order, weights = family.order, sum(map(len, c.witness["images"])) // 3
    work = 2 * tree.letters * len(tree.parents) * order**2 + 4 * weights * order + 8 * order**3
    c.count(work + len(c.witness["leaders"]) * (length + 1) * order**3, max(family.bits, c.witness["bits"] + HEADROOM))


class _Enclosures:
    """Vertices (Re, Im) as integers / 2^bits, each with one error for all its coordinates, in units of 2^-bits."""

    def __init__(self, c: Claim, family: Family, root: Root, tree: Tree, disc: Disc) -> None:
        bits, order = c.witness["bits"], family.order
        tiny = max(0, root.low.denominator.bit_length() - root.low.numerator.bit_length() + 1)
        at = enclose(c, root, bits + 2 * tiny + 2)
        scale = inverse_scale(c, at, c.statement["length"], bits)
        self._matrices, self._value, self._error = family.matrices, scale.value, scale.error
        self._below = family.denominator << bits
        self._rows = [max(sum(map(abs, row)) for row in matrix) for matrix in family.matrices]
        self.vertices: list[list[int]] = []
        self.errors: list[int] = []
        c.spend(2 * tree.letters * len(tree.parents) * order, bits + HEADROOM + family.bits + scale.value.bit_length())
        for leader in c.witness["leaders"]:
            x = eigenvector(c, family, leader, 1, disc.polynomial)
            v, error = disc.enclosed(c, x, bits)
            require(max(map(abs, v)) > error, "a leader may be zero")
            self._add(v, error, bits)
        leaders = len(self.vertices)
        for parent, by in zip(tree.parents[leaders:], tree.by[leaders:], strict=True):
            if parent < 0:
                real = [(x << bits) >> EXTRA_BITS for x in c.witness["extras"][by]]
                self._add(real + [0] * order, 1, bits)
            else:
                self._add(*self.of(parent, by), bits)

    def _add(self, v: list[int], error: int, bits: int) -> None:
        limit = 1 << (bits + HEADROOM)
        require_few(max(map(abs, v)) < limit and error < limit, f"vertex {len(self.vertices)} is too large")
        self.vertices.append(v)
        self.errors.append(error)

    def of(self, u: int, letter: int) -> tuple[list[int], int]:
        """M_letter v_u / σ on both halves, rounded down, and its error: that of `closing`."""
        v, order = self.vertices[u], len(self.vertices[u]) // 2
        y = [x for half in (v[:order], v[order:]) for x in matrices.apply(self._matrices[letter], half)]
        error = (self._value + self._error) * self._rows[letter] * self.errors[u] + self._error * max(map(abs, y))
        return [self._value * x // self._below for x in y], error // self._below + 2


def _copies(c: Claim, family: Family, vertices: list[list[int]]) -> list[list[int]]:
    """The vertices, their conjugates, and the reflections of both where the symmetry of the family is claimed."""
    n = family.order
    both = vertices + [v[:n] + [-x for x in v[n:]] for v in vertices]
    if (sign := c.witness["symmetry"]) == 0:
        return both
    require(family.is_symmetric(sign), "the matrices do not have that symmetry")
    return both + [v[:n][::-1] + v[n:][::-1] for v in both]


def _check_insides(c: Claim, family: Family, images: _Enclosures, tree: Tree, taken: set[int]) -> None:
    """All images but those taken lie inside, by their weights."""
    w, n = c.witness, family.order
    vertices = _copies(c, family, images.vertices)
    errors = images.errors * (len(vertices) // len(images.errors))
    turned = [[-x for x in v[n:]] + v[:n] for v in vertices]
    numbers = [*w["basis"], *(k + len(vertices) for k in w["basis"])]
    hull = _Hull(body(c, vertices + turned, errors * 2, numbers, w["weight_bits"], w["bits"] + HEADROOM), len(vertices))
    insides = [image for image in range(len(tree.parents) * tree.letters) if image not in taken]
    require(len(insides) == len(w["images"]), f"there are {len(insides)} images inside, not as many as weights")
    for image, weights in zip(insides, w["images"], strict=True):
        u, letter = divmod(image, tree.letters)
        middle, error = images.of(u, letter)
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
