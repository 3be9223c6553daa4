"""An upper bound of the joint spectral radius from a polytope, whether it is closed or not.

With rational vertices that span, a rational x > 0 and for every image a rational combination such that Σ|c| + κ ‖M v
/ x - Σ c v‖₁ <= 1, κ = ‖V_B^(-1)‖₁ for a basis V_B of vertices, the matrices map the hull of ±V into x times itself:
JSR <= x. This is the rule `polytope` of certificate/RADIUS.md. A monotone body, of vectors that are not negative,
proves the same with inequalities: rule `monotone-polytope`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import arb, arb_mat, ctx

from subdiv_cli.exact.enclosures import ball
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.measure import independent_columns
from subdiv_cli.jsr.polytope import Grown
from subdiv_cli.model import Look, no_clock
from subdiv_cli.model.proofs import RadiusProof

_PLACES = 60
"""Binary places of the vertices."""
_LARGEST = 2.0**60
"""The largest coordinate: integers have at most 40 digits in a certificate."""
_WEIGHT_BITS = 39
_SLACK = (34, 31, 26, 16)
"""The bound is raised by a factor 1 + 2^-s, s the first of these that leaves room for the roundings."""
_PRECISION = 192


class RadiusBound(NamedTuple):
    """An upper bound JSR <= `upper`, and the rule, `polytope` or `monotone-polytope`, with its witness."""

    upper: Fraction
    witness: RadiusProof


def enclose(family: Family, grown: Grown, sigma: Fraction, look: Look = no_clock) -> RadiusBound | None:
    """The bound σ·(largest gauge of an image), raised a little; σ is what the body's matrices were divided by.

    None where roundings spoil it, or vertices are complex, or too large for a certificate. Raises what `look` raises.
    """
    if grown.body.complex or not math.isfinite(grown.value) or not (abs(grown.body.columns) < _LARGEST).all():
        return None
    with ctx.workprec(_PRECISION):
        try:
            proof = (_MonotoneEnclosing if grown.body.monotone else _Enclosing)(family, grown)
        except ZeroDivisionError:  # the rounded vertices do not span
            return None
        for slack in _SLACK:
            x = _short(sigma * max(Fraction(1), Fraction(grown.value)) * (1 + Fraction(1, 1 << slack)))
            if (images := proof.images(float(sigma / x), x, look)) is not None:
                return RadiusBound(x, proof.witness(images))
    return None


def by_columns(family: Family) -> RadiusBound:
    """The bound by the largest absolute column sum of a matrix, raised a little: the polytope of the vertices ±e_j.

    Weights are entries over the bound, so roundings to multiples of 2^-w cost N 2^-w at most. Needs a matrix ≠ 0.
    """
    n, tables = family.order, [m.transpose().table() for m in family.matrices]
    columns = [[[to_fraction(x) for x in table[j]] for table in tables] for j in range(n)]
    largest = max(sum(map(abs, column)) for each in columns for column in each)
    x = _short(largest * (1 + Fraction(n, 1 << (_WEIGHT_BITS - 1))))
    images = []
    for column in (column for each in columns for column in each):
        weights = ((k, round(entry / x * (1 << _WEIGHT_BITS))) for k, entry in enumerate(column))
        images.append(tuple(part for pair in weights if pair[1] for part in pair))
    corners = tuple(tuple(int(i == j) for i in range(n)) for j in range(n))
    witness: RadiusProof = {
        "rule": "polytope",
        "symmetry": 0,
        "bits": 0,
        "vertices": corners,
        "basis": tuple(range(n)),
        "weight_bits": _WEIGHT_BITS,
        "images": tuple(images),
    }
    return RadiusBound(x, witness)


def _short(x: Fraction) -> Fraction:
    """A number a little above x > 0 with 48 significant bits."""
    unit = Fraction(2) ** (x.numerator.bit_length() - x.denominator.bit_length() - 48)
    return -(-x // unit) * unit


class _Enclosing:
    def __init__(self, family: Family, grown: Grown) -> None:
        self._family, self._body = family, grown.body
        plain = self._body.columns[:, :: self._body.copies]
        self._integers = [[round(x * (1 << _PLACES)) for x in column] for column in plain.T.tolist()]
        self._vertices = [arb_mat([[ball(Fraction(x, 1 << _PLACES))] for x in column]) for column in self._integers]
        self._matrices = [arb_mat(m) for m in family.matrices]
        self._condition()

    def _condition(self) -> None:
        """Choose a basis of N vertices, and compute κ."""
        self._basis = self._body.numbers(independent_columns(self._body.columns))
        inverse = arb_mat([list(row) for row in zip(*map(self._vertex, self._basis), strict=True)]).inv()
        self._kappa = arb(max(sum(map(abs, column), arb(0)).upper() for column in zip(*inverse.table(), strict=True)))

    def _distance(self, rest: Sequence[arb]) -> arb:
        """A number t such that the vector lies in t times the hull."""
        return self._kappa * sum(map(abs, rest), arb(0))

    def _vertex(self, number: int) -> list[arb]:
        entries = self._vertices[number % self._body.size].entries()
        return entries if number < self._body.size else entries[::-1]

    def images(self, shrink: float, x: Fraction, look: Look) -> list[tuple[int, ...]] | None:
        """The weights of every image, for u = 0, 1, … and all letters; None where one is not proved to lie inside.

        Weights of images over σ are multiplied by `shrink` = σ/x.
        """
        weights = []
        for u in range(self._body.size):
            look()
            for letter in range(self._family.letters):
                flat = tuple(self._flat(u, letter, shrink))
                if not self._is_inside(u, letter, flat, x):
                    return None
                weights.append(flat)
        return weights

    def _flat(self, u: int, letter: int, shrink: float) -> list[int]:
        if (u, letter) in self._body.images:
            image = self._body.images[u, letter]
            numbers = self._body.numbers(image.columns)
            weights = [weight.real for weight in image.weights]
        else:
            numbers, weights = [self._body.target(u, letter)[0]], [self._body.target(u, letter)[1]]
        total = dict.fromkeys(sorted(numbers), 0.0)
        for number, weight in zip(numbers, weights, strict=True):
            total[number] += weight  # a degenerate basis may have a column twice
        rounded = ((k, round(c * shrink * (1 << _WEIGHT_BITS))) for k, c in total.items())
        return [entry for pair in rounded if pair[1] for entry in pair]

    def _is_inside(self, u: int, letter: int, flat: tuple[int, ...], x: Fraction) -> bool:
        rest = (self._matrices[letter] * self._vertices[u] / ball(x)).entries()
        total = arb(0)
        for number, weight in zip(flat[::2], flat[1::2], strict=True):
            c = arb(weight) / (1 << _WEIGHT_BITS)
            total += abs(c)
            rest = [y - c * z for y, z in zip(rest, self._vertex(number), strict=True)]
        return bool(total + self._distance(rest) < 1)

    def witness(self, images: list[tuple[int, ...]]) -> RadiusProof:
        return {
            "rule": "monotone-polytope" if self._body.monotone else "polytope",
            "symmetry": self._family.symmetry if self._body.symmetric else 0,
            "bits": _PLACES,
            "vertices": tuple(tuple(column) for column in self._integers),
            "basis": tuple(self._basis),
            "weight_bits": _WEIGHT_BITS,
            "images": tuple(images),
        }


class _MonotoneEnclosing(_Enclosing):
    """The same proof in a monotone hull, where `basis` has for each coordinate a vertex where it is large."""

    def _condition(self) -> None:
        self._basis = self._body.numbers(self._body.columns.argmax(axis=1).tolist())
        self._floors = [self._vertex(number)[k] for k, number in enumerate(self._basis)]

    def _distance(self, rest: Sequence[arb]) -> arb:
        return sum((x.max(arb(0)) / floor for x, floor in zip(rest, self._floors, strict=True)), arb(0))
