"""Rules on the components of a curve: its span, its polynomials, what annihilates them, derivatives. See FORMAT.md."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb, factorial
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker.core import Claim, Proved
from subdiv_cli.checker.curves.convergence import (
    Ends,
    Scaled,
    bits_of,
    image_of,
    joints_fit,
    scaled,
)
from subdiv_cli.checker.matrices import RationalFamily, dependent_rows
from subdiv_cli.checker.radius.families import UPPER, bound_of
from subdiv_cli.checker.reading import MAX_ORDER, require, require_few
from subdiv_cli.checker.roots import fraction_bits

_MAX_POINTS = 10_000


class Span(NamedTuple):
    """The span of a curve, and the polynomials among its components."""

    annihilator: list[list[int]]
    """The vectors a with a·v = 0 for exactly the v of the span."""
    polygons: list[list[int]]
    """The polygons u_0, …, u_d with u_δ·ψ(x) = x^δ, over one denominator."""
    denominator: int


def components(c: Claim) -> Span:
    """The span Σ of the curve has dimension m, and the polynomials among its components are those of degree <= d.

    Σ is the span of B_w ψ(0) for m words w: they are independent, and n - m independent vectors a with a·v = 0 for them
    have a·B_i v = 0 as well, so that Σ is invariant. u_δ·ψ(x) = x^δ: A_i u_δ = p^-δ Σ_j C(δ,j) i^(δ-j) u_j on Σ. The
    degree is no higher: d + 1 = m, or points of a grid satisfy a relation that x^(d+1) does not; with a polynomial of
    any higher degree Ψ would have x^(d+1) too.
    """
    family: RationalFamily = c.about
    n, p, witness = family.order, len(family.matrices), c.witness
    m, d = c.statement["dimension"], c.statement["degree"]
    words, weights, level = witness["words"], witness["weights"], witness["level"]
    require(1 <= m <= n and len(words) == m, "the words are not as many as the dimension")
    require(len(witness["annihilator"]) == n - m, "the annihilator has not the complementary dimension")
    require(0 <= d < m and len(witness["polygons"]) == d + 1, "the polygons are not d + 1, or more than the dimension")
    vectors = [*witness["annihilator"], *witness["polygons"]]
    require(all(len(v) == n for v in vectors), "a vector is of another order")
    longest = max(map(len, words))
    require_few(longest <= MAX_ORDER and level <= MAX_ORDER, "a word or a level is too long")
    points = p**level + 1 if weights else 0
    require_few(points <= _MAX_POINTS, "there are too many points")
    steps = m * (longest + p * (n - m + d + 1)) + 2 * points
    bits = max(longest, level) * (family.bits + n.bit_length()) + (d + 1) * p.bit_length() * 2 + bits_of(vectors)
    c.count(steps * n**2 + (m + n) ** 3, 2 * bits + bits_of([weights]))
    ends: Ends = c.use("well-defined", holds=True).result
    span = [_image_of_word(family, word, ends.left.entries) for word in words]
    annihilator = [scaled(v).entries for v in witness["annihilator"]]
    independent(span)
    independent(annihilator)
    for v in span:
        for image in (v, *(image_of(family, letter, v) for letter in range(p))):
            require(not any(sum(map(mul, a, image)) for a in annihilator), "the span is not invariant")
    polygons, denominator = _over_one(witness["polygons"])
    require(polygons[0] == [denominator] * n, "the first polygon is not constant")
    for letter in range(p):
        _refines(family, letter, polygons, span)
    if weights:
        _excluded(family, ends, weights, level, d + 1)
    else:
        require(d + 1 == m, "no relation excludes a higher degree")
    return Span(annihilator, polygons, denominator)


def _image_of_word(family: RationalFamily, word: Sequence[int], v: list[int]) -> list[int]:
    """A multiple of B_(w_ℓ) ⋯ B_(w_1) v."""
    for letter in word:
        require(letter < len(family.matrices), "a letter is not there")
        v = image_of(family, letter, v)
    return v


def _over_one(rows: Sequence[Sequence[Fraction]]) -> tuple[list[list[int]], int]:
    """The rows over one common denominator."""
    flat = scaled([x for row in rows for x in row])
    n = len(rows[0])
    return [flat.entries[i * n : (i + 1) * n] for i in range(len(rows))], flat.denominator


def independent(rows: Sequence[Sequence[int]]) -> None:
    """Check that the rows have full rank modulo a prime: then over Q as well."""
    dependent = next(iter(dependent_rows(rows)), None)
    require(dependent is None, f"vector {dependent} depends on those before it, modulo 2^61 - 1")


def _refines(family: RationalFamily, letter: int, polygons: list[list[int]], span: list[list[int]]) -> None:
    """Check that p^δ A u_δ = Σ_j C(δ,j) i^(δ-j) u_j on the span, i the letter."""
    p = len(family.matrices)
    for order, u in enumerate(polygons):
        image = [p**order * sum(map(mul, row, u)) for row in family.matrices[letter]]
        for j, lower in enumerate(polygons[: order + 1]):
            factor = family.denominator * comb(order, j) * letter ** (order - j)
            image = [x - factor * y for x, y in zip(image, lower, strict=True)]
        require(not any(sum(map(mul, image, v)) for v in span), f"polygon {order} does not give x^{order}")


def _excluded(family: RationalFamily, ends: Ends, weights: Sequence[Fraction], level: int, power: int) -> None:
    """Check that Σ μ_j ψ(j p^-level) = 0 and Σ μ_j (j p^-level)^power ≠ 0."""
    p = len(family.matrices)
    require(len(weights) == p**level + 1, "there are not as many weights as points")
    points = [ends.left.entries]
    scale = family.denominator**level
    for _ in range(level):
        points = [image_of(family, letter, x) for letter in range(p) for x in points]
    points = [[ends.right.denominator * x for x in v] for v in points]
    points.append([scale * ends.left.denominator * x for x in ends.right.entries])
    mu = scaled(weights).entries
    total = [sum(map(mul, mu, column)) for column in zip(*points, strict=True)]
    require(not any(total), "the points do not satisfy the relation")
    require(sum(w * j**power for j, w in enumerate(mu)) != 0, f"x^{power} satisfies the relation")


def annihilators(c: Claim) -> None:
    """The new family is that of the B_i on V, where all u_δ·v = 0 for v in Σ.

    Its dimension is m - d - 1, as the u_δ are independent on Σ: V is spanned by differences of the curve, of any order
    k > d.
    """
    family: RationalFamily = c.about
    n, p, basis, restriction = family.order, len(family.matrices), c.witness["basis"], c.witness["matrices"]
    size, shaped = len(basis), len(restriction.matrices) == p and restriction.order == len(basis)
    require(all(len(row) == n for row in basis), "a vector is of another order")
    require(shaped, "the matrices are not p, or of another order than the basis")
    bits = family.bits + restriction.bits + 2 * bits_of(basis) + n.bit_length()
    c.count(size * n * (n + p * (n + size)) + n * size**2, bits)
    used = c.use("polynomials")
    known: Span = used.result
    dimension = used.statement["dimension"] - used.statement["degree"] - 1
    require(size == dimension, f"the space has dimension {dimension}")
    rows = [scaled(row) for row in basis]
    independent([row.entries for row in rows])
    for row in rows:
        for a in (*known.annihilator, *known.polygons):
            require(not sum(map(mul, a, row.entries)), "a vector of the basis is not in the space")
    _is_on(family, _over_one(basis)[0], restriction)
    c.introduce(c.statement["family"], restriction)


def _is_on(family: RationalFamily, basis: list[list[int]], restriction: RationalFamily) -> None:
    """Check that B_i b_j = Σ_l M_i[l][j] b_l."""
    columns = list(zip(*basis, strict=True))
    for letter, matrix in enumerate(restriction.matrices):
        for b, weights in zip(basis, zip(*matrix, strict=True), strict=True):
            image = [restriction.denominator * x for x in image_of(family, letter, b)]
            combined = [family.denominator * sum(map(mul, weights, column)) for column in columns]
            require(image == combined, f"matrix {letter} does not give the image of the basis")


def derivative(c: Claim) -> None:
    """The derivatives of order δ of the curve at its ends, scaled by p^-δ, fit at all joints or not.

    p^-δ > ρ, the radius on V. The eigenvectors r of B_0 and l of B_(p-1) for p^-δ in Σ with u_j·r = δ! for j = δ, else
    0, and u_j·l = j!/(j-δ)!, 0 for j < δ, are determined then. They fit iff B_j r = B_(j-1) l for 0 < j < p.
    """
    family: RationalFamily = c.about
    n, p, order = family.order, len(family.matrices), c.statement["order"]
    vectors = [c.witness["left"], c.witness["right"]]
    require(all(len(v) == n for v in vectors), "a vector is of another order")
    require_few(order <= MAX_ORDER, "the order is too large")
    c.count(2 * (p + n) * n**2, family.bits + 2 * bits_of(vectors) + order * (p.bit_length() + MAX_ORDER.bit_length()))
    used, length, bound = decay(c)
    require(1 <= order <= used.statement["degree"], "no polynomial component has such a derivative")
    c.spend(1, fraction_bits(bound) + order * length * p.bit_length())
    require(bound * p ** (order * length) < 1, "the radius is not small enough")
    known: Span = used.result
    degrees = range(len(known.polygons))
    left, right = map(scaled, vectors)
    _is_jet(family, known, left, 0, order, [factorial(order) if j == order else 0 for j in degrees])
    moments = [factorial(j) // factorial(j - order) if j >= order else 0 for j in degrees]
    _is_jet(family, known, right, p - 1, order, moments)
    require(joints_fit(family, left, right) is c.statement["holds"], "the joints say otherwise")


def _is_jet(family: RationalFamily, known: Span, v: Scaled, letter: int, order: int, moments: list[int]) -> None:
    """Check that v is in Σ, p^δ B v = v, and u_j·v is the given moment."""
    p = len(family.matrices)
    image = [p**order * x for x in image_of(family, letter, v.entries)]
    require(image == [family.denominator * x for x in v.entries], "a vector is no eigenvector")
    require(not any(sum(map(mul, a, v.entries)) for a in known.annihilator), "a vector is not in the span")
    for u, moment in zip(known.polygons, moments, strict=True):
        require(sum(map(mul, u, v.entries)) == moment * known.denominator * v.denominator, "a vector is no derivative")


def decay(c: Claim) -> tuple[Proved, int, Fraction]:
    """The claim on polynomials, and a pair (ℓ, x) with ρ^ℓ <= x for the radius on V."""
    used = c.use("polynomials")
    radius = c.use(*UPPER).statement
    on_curve(c, used, radius["family"])
    return used, radius["length"], bound_of(radius)


def on_curve(c: Claim, used: Proved, number: int) -> None:
    """Check that the family is that on V, or that on e^⊥ where that is the same."""
    s = c.use("family", family=number).statement
    if s["on"] != "curve":
        whole = (used.statement["dimension"], used.statement["degree"]) == (c.about.order, 0)
        require(whole, "the family is that of all polygons")
