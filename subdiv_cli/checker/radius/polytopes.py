"""Polytopes as unit balls: what lies inside, and the rules that bound a joint spectral radius by one.

A symmetric one is the hull of all ±v. A monotone one, for matrices >= 0, is all x with |x| below a convex combination
of vertices that are >= 0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.reading import Rejected, require
from subdiv_cli.checker.roots import fraction_bits

IN_ONE_NORM = "all matrices have norms of at most the bound"
"""The result of a claim that bounds a radius by one norm: then products are bounded by powers of the bound."""
_PLACES = 64
"""The binary places of quotients that are rounded up."""
_FIRST_PLACES = 64
"""The first places to which long coordinates are cut: a matrix is inverted faster, and κ is known well enough."""


class SymmetricBody(NamedTuple):
    """The convex hull P of all ±v, where every |vertices[k][i] - v_k[i]| <= errors[k], in some unit of length.

    Every vector r lies in factor ‖r‖₁ P.
    """

    vertices: list[list[int]]
    errors: list[int]
    factor: Fraction
    weight_bits: int

    def contains(self, image: Sequence[int], over: int, error: int, weights: Sequence[int]) -> bool:
        """Whether a vector is in P that differs from image/over by at most error/over in every coordinate.

        The weights are k_1, c_1, k_2, c_2, …: with r = image/over - Σ (c_k/2^w) v_k, up to the errors of all of them,
        it is in (Σ |c_k|/2^w + factor ‖r‖₁) P. All is multiplied by over 2^w.
        """
        numbers, cs, w = weights[::2], weights[1::2], self.weight_bits
        require(len(numbers) == len(cs) == len(set(numbers)), "a weight has no vertex, or a vertex has two")
        require(all(0 <= k < len(self.vertices) for k in numbers), "a weight is for a vertex that is not there")
        require(0 not in cs, "a weight is zero")
        columns = zip(*[self.vertices[k] for k in numbers], strict=True) if cs else ((),) * len(image)
        rest = sum(abs((x << w) - over * sum(map(mul, cs, column))) for x, column in zip(image, columns, strict=True))
        sizes = list(map(abs, cs))
        error = (error << w) + over * sum(map(mul, sizes, [self.errors[k] for k in numbers]))
        room = ((1 << w) - sum(sizes)) * over
        return bool((rest + len(image) * error) * self.factor.numerator <= room * self.factor.denominator)


def body(
    c: Claim, vertices: list[list[int]], errors: list[int], basis: Sequence[int], weight_bits: int, bits: int
) -> SymmetricBody:
    """The symmetric body of these vertices, with a basis of N of them that span, known as well as they are.

    With V the matrix of these columns, cut to their first binary places if that is enough, κ = ‖V^-1‖₁, and V + Δ the
    true one, |Δ_ij| <= ε, the column sums of V^-1 Δ are at most η = κ N ε. If η < 1, V + Δ = V (1 + V^-1 Δ) is
    invertible and ‖(V + Δ)^-1‖₁ <= κ/(1 - η). Here η <= 1/2. Raises Rejected where the basis does not span or is not
    known well enough.
    """
    order = len(vertices[0])
    require(len(basis) == order, "the basis has not as many vertices as coordinates")
    require(max(basis) < len(vertices), "the basis has a vertex that is not there")
    c.spend(order**3, order * bits)
    rows, error = list(zip(*(vertices[k] for k in basis), strict=True)), max(errors[k] for k in basis)
    longest = max(abs(x) for row in rows for x in row).bit_length()
    for cut in sorted({max(0, longest - _FIRST_PLACES), 0}, reverse=True):
        norm = matrices.inverse_norm([[x >> cut for x in row] for row in rows])
        if norm is not None:
            eta = norm * order * ((error >> cut) + 2 if cut else error)
            if 2 * eta <= 1:
                return SymmetricBody(vertices, errors, norm / (1 - eta) / (1 << cut), weight_bits)
    raise Rejected("the basis does not span" if norm is None else "the basis is not known well enough")


class MonotoneBody(NamedTuple):
    """The set P of all x with |x| <= Σ c_k v_k, c >= 0, Σ c_k <= 1, v_k >= 0, |vertices[k][i] - v_k[i]| <= errors[k].

    Coordinate i of some vertex b is at least floors[i] > 0: P is the unit ball of a norm, and an r >= 0 is below
    Σ_i r_i/floors[i] v_b.
    """

    vertices: list[list[int]]
    errors: list[int]
    floors: list[int]
    weight_bits: int

    def contains(self, image: Sequence[int], over: int, error: int, weights: Sequence[int]) -> bool:
        """Whether a vector >= 0 is in P that differs from image/over by at most error/over in every coordinate.

        The weights are k_1, c_1, k_2, c_2, …: with r_i the positive parts of image/over - Σ (c_k/2^w) v_k, up to the
        errors of all of them, it is below Σ c_k/2^w + Σ_i r_i/floors[i] times a convex combination. All is multiplied
        by over 2^w, and each quotient rounded up.
        """
        numbers, cs, w = weights[::2], weights[1::2], self.weight_bits
        require(len(numbers) == len(cs) == len(set(numbers)), "a weight has no vertex, or a vertex has two")
        require(all(0 <= k < len(self.vertices) for k in numbers), "a weight is for a vertex that is not there")
        require(all(c > 0 for c in cs), "a weight is not positive")
        columns = zip(*[self.vertices[k] for k in numbers], strict=True) if cs else ((),) * len(image)
        error = (error << w) + over * sum(map(mul, cs, [self.errors[k] for k in numbers]))
        rest = 0
        for x, column, floor in zip(image, columns, self.floors, strict=True):
            above = (x << w) - over * sum(map(mul, cs, column)) + error
            rest += -(-(above << _PLACES) // floor) if above > 0 else 0
        return bool(rest <= ((1 << w) - sum(cs)) * over << _PLACES)


def monotone_body(
    c: Claim, vertices: list[list[int]], errors: list[int], basis: Sequence[int], weight_bits: int, bits: int
) -> MonotoneBody:
    """The monotone body of vertices that are known not to be negative.

    `basis` has a vertex for each coordinate, positive there.
    """
    order = len(vertices[0])
    require(len(basis) == order, "the basis has not as many vertices as coordinates")
    require(max(basis) < len(vertices), "the basis has a vertex that is not there")
    c.spend(order, bits)
    floors = [vertices[k][i] - errors[k] for i, k in enumerate(basis)]
    require(all(floor > 0 for floor in floors), "a coordinate of a basis vertex may be zero")
    return MonotoneBody(vertices, errors, floors, weight_bits)


def require_nonnegative(family: RationalFamily) -> None:
    """Raise Rejected where a matrix of the family has a negative entry."""
    entries = (x for matrix in family.matrices for row in matrix for x in row)
    require(all(x >= 0 for x in entries), "a matrix has a negative entry")


def reflected(c: Claim, family: RationalFamily, vertices: list[list[int]]) -> list[list[int]]:
    """The vertices, and after them their reflections J v where the symmetry of the family is claimed."""
    if (sign := c.witness["symmetry"]) == 0:
        return vertices
    require(family.is_symmetric(sign), "the matrices do not have that symmetry")
    return [*vertices, *(v[::-1] for v in vertices)]


def weight_count(c: Claim) -> int:
    """The number of pairs of a vertex and a weight, over all images."""
    return sum(map(len, c.witness["images"])) // 2


def polytope(c: Claim) -> str:
    """JSR <= x: the hull P of all ±v has M_i P ⊂ x P, also by M_i J v = ± J M_(p-1-i) v where P = J P."""
    check_images(c, body)
    return IN_ONE_NORM


def monotone_polytope(c: Claim) -> str:
    """JSR <= x: |M_i z| <= M_i |z| is in x P for all z in the monotone hull P."""
    require_nonnegative(c.family())
    require(all(x >= 0 for v in c.witness["vertices"] for x in v), "a vertex has a negative coordinate")
    check_images(c, monotone_body)
    return IN_ONE_NORM


def check_images(c: Claim, make: Callable[..., SymmetricBody | MonotoneBody]) -> None:
    """Check that all images of the vertices, divided by x, lie in the body that `make` makes of them."""
    family, x, w = c.family(), c.statement["bound"], c.witness
    given, images, p, order = w["vertices"], w["images"], len(family.matrices), family.order
    require(c.statement["length"] == 1 and x > 0, "the length is not 1, or the bound is not positive")
    require(len(given) > 0 and all(len(v) == order for v in given), "the vertices do not have N coordinates")
    require(len(images) == p * len(given), "there are not p images for every vertex")
    bits = max(max(map(abs, v)) for v in given).bit_length()
    c.count(p * len(given) * order**2 + weight_count(c) * order + order**3, bits + family.bits + fraction_bits(x))
    vertices = reflected(c, family, given)
    ball = make(c, vertices, [0] * len(vertices), w["basis"], w["weight_bits"], bits)
    over = family.denominator * x.numerator
    for number, weights in enumerate(images):
        u, letter = divmod(number, p)
        image = [x.denominator * y for y in matrices.apply(family.matrices[letter], given[u])]
        require(ball.contains(image, over, 0, weights), f"the image of vertex {u} by letter {letter} is not inside")
