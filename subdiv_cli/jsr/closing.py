"""A closed polytope made into a proof that JSR = σ = |μ|^(1/ℓ), μ the eigenvalue that its leaders share.

The vertices are exact: words applied to the leaders, over powers of σ. Every image of a vertex is a vertex, a return
to a leader, a tie (see ties.py), or inside: it differs from a combination with rational weights by so short a vector
that it lies in the hull, which balls decide. So the scaled matrices map the hull into itself: JSR <= σ, all products of
L matrices are bounded by a constant times σ^L, and the leaders' products attain σ (Guglielmi, Wirth & Zennaro 2005).

The inequality is that of the checker's rules `closing` and `complex-closing` (certificate/RADIUS.md) with a little room
left for roundings, and in the complex case for real norms of complex vectors, which are at most twice as large.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from flint import acb, acb_mat, arb, arb_mat, ctx, fmpz

from subdiv_cli.exact.enclosures import ball
from subdiv_cli.jsr.body import EXTRA_BITS, Image
from subdiv_cli.jsr.discs import disc_data, has_disc
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.leaders import Ball, Balls, Leaders, vector
from subdiv_cli.jsr.measure import independent_columns
from subdiv_cli.jsr.polytope import Grown, push_out
from subdiv_cli.jsr.ties import Tie, Ties, Weight, coefficients
from subdiv_cli.model import Effort, Look
from subdiv_cli.model.proofs import LeaderData, RadiusProof

_WEIGHT_BITS = (14, 26, 39)
"""Weights are rounded to multiples of 2^-w, w the first of these that leaves room enough."""
_ROOM = 40
"""Every image stays 2^-40 away from the boundary: room for a checker that works with `bits` binary places."""
_MOST_PLACES = 4096
"""The most binary places of a certificate."""
_LARGEST_BITS = 63
"""The most bits of the integer part of a coordinate."""
_CLOSE = 1 - 1e-7
"""Images with a larger gauge may be ties."""


_PUSHES = (2.0**-7, 2.0**-10, 2.0**-14)
"""The shares by which images that stay on the boundary are moved beyond it."""


def close(family: Family, leaders: Leaders, grown: Grown, effort: Effort) -> RadiusProof | None:
    """The proof that the polytope is closed, as plain data.

    None where some image is not proved to lie inside. Where images on the boundary are no ties, the body grows by
    vertices beyond them. Raises ClockStruckError.
    """
    if not leaders.is_real and not has_disc(leaders.each[0].eigenvalue):
        return None
    for by in (*_PUSHES, None):
        places = _places(family, leaders, grown)
        with ctx.workprec(places + 64):
            proof = (_MonotoneClosing if grown.body.monotone else _Closing)(family, leaders, grown, effort.look)
            if not proof.spans or proof.is_large:
                return None
            for bits in _WEIGHT_BITS:
                decided, left = proof.images(bits, to_the_end=bits == _WEIGHT_BITS[-1])
                if not left:
                    places += proof.lost
                    return proof.witness(places, bits, decided) if places <= _MOST_PLACES else None
        if by is None or grown.body.complex or any(grown.body.images[pair].value < _CLOSE for pair in left):
            return None
        grown = push_out(grown.body, left, by, effort)
        if not grown.closed:
            return None
    return None


def _places(family: Family, leaders: Leaders, grown: Grown) -> int:
    """Binary places with which roundings grow to less than 2^-64 along the tree.

    An image's error is at most ‖M‖∞/σ times that of its vertex and a few units, as many more as 1/σ is small; a
    leader's is that of Horner's rule times its scale.
    """
    body = grown.body
    growth = max(1.0, 2.0 * float(np.abs(body.scaled).sum(axis=2).max()))
    scale = max(leader.scale for leader in leaders.each)
    start = max(0, scale.numerator.bit_length() - scale.denominator.bit_length()) + 8 * family.order + leaders.length
    start += family.unit.numerator.bit_length() - 1
    return 32 * math.ceil((64 + _ROOM + start + max(body.depths) * math.log2(growth)) / 32)


class _Closing:
    """Vertices in balls at the current precision, and the images decided with them."""

    def __init__(self, family: Family, leaders: Leaders, grown: Grown, look: Look) -> None:
        self._look = look
        self._family, self._leaders, self._body = family, leaders, grown.body
        self._ties = Ties(family, leaders, grown.body, self._smaller)
        self._known_ties: dict[tuple[int, int], Tie | None] = {}
        self._kind = arb_mat if leaders.is_real else acb_mat
        self._sigma = leaders.sigma()
        self._matrices = [self._kind(m) for m in family.matrices]
        self._vertices = self._enclosed()
        self._basis = self._independent()
        self._kappa = self._condition()

    @property
    def lost(self) -> int:
        """Binary places that the basis costs: errors grow by κ when they are measured in the hull."""
        assert self._kappa is not None
        return 32 * max(0, math.ceil(float(self._kappa.log().upper()) / (32 * math.log(2))))

    @property
    def spans(self) -> bool:
        """Whether the basis vertices are proved to be independent."""
        return self._kappa is not None

    @property
    def is_large(self) -> bool:
        """Whether a coordinate may be larger than certificates have them."""
        return any(not abs(x) < 1 << _LARGEST_BITS for v in self._vertices for x in v.entries())

    def _enclosed(self) -> list[Balls]:
        vertices: list[Balls] = []
        for u, parent in enumerate(self._body.parents):
            self._look()
            if parent is None:
                vertices.append(vector(self._family, self._leaders.each[u]))
            elif parent[0] < 0:
                vertices.append(self._kind([[arb(x) / (1 << EXTRA_BITS)] for x in self._body.extras[parent[1]]]))
            else:
                vertices.append(self._image(vertices[parent[0]], parent[1]))
        return vertices

    def _image(self, of: Balls, letter: int) -> Balls:
        return self._matrices[letter] * of / self._sigma

    def _vertex(self, number: int) -> list[Ball]:
        """The vertex with this number of the certificate: copy c of vertex u, as `Polytope` counts them, is u + c n."""
        copy, u = divmod(number, self._body.size)
        entries: list[Ball] = self._vertices[u].entries()
        if self._body.complex and copy % 2:
            entries = [x.conjugate() for x in entries]
        return entries[::-1] if self._body.symmetric and copy >= self._body.copies // 2 else entries

    def _independent(self) -> list[int]:
        """The numbers of N vertices that are a well-conditioned basis, as floats see it."""
        return self._body.numbers(independent_columns(self._body.columns))

    def _condition(self) -> arb | None:
        """The number κ = ‖V_B^(-1)‖₁, or None where it is not finite: a vector r lies in κ‖r‖₁ times the hull."""
        try:
            inverse = self._kind([list(row) for row in zip(*map(self._vertex, self._basis), strict=True)]).inv()
        except ZeroDivisionError:
            return None
        kappa = _largest([_norm(column) for column in zip(*inverse.table(), strict=True)])
        return kappa if kappa.is_finite() else None

    def images(self, bits: int, *, to_the_end: bool) -> tuple[list[tuple[int, ...] | Tie], list[tuple[int, int]]]:
        """The decisions on the images that are neither edges nor returns, and the images that are not decided.

        Weights have so many bits. Unless `to_the_end`, the first image that is not decided ends it.
        """
        decided: list[tuple[int, ...] | Tie] = []
        left: list[tuple[int, int]] = []
        for pair in sorted(self._body.images):
            self._look()
            answer = self._decide(self._body.images[pair], bits)
            if answer is None:
                left.append(pair)
                if not to_the_end:
                    break
            else:
                decided.append(answer)
        return decided, left

    def _decide(self, image: Image, bits: int) -> tuple[int, ...] | Tie | None:
        weights = self._weights(image)
        if image.value > _CLOSE and self._leaders.is_real:
            key = image.vertex, image.letter
            if key not in self._known_ties:
                self._known_ties[key] = self._ties.tie(image.vertex, image.letter, weights)
            if (tie := self._known_ties[key]) is not None:
                return tie
        return self._inside(image, weights, bits)

    def _smaller(self, vertex: int, letter: int, weights: Sequence[tuple[int, arb]], coordinate: int) -> bool:
        return False

    def _weights(self, image: Image) -> dict[int, complex]:
        """The weights of an image by the certificate's vertex numbers, copies of one vertex added up."""
        body, total = self._body, dict[int, complex]()
        for column, weight in zip(image.columns, image.weights, strict=True):
            u, copy = divmod(column, body.copies)
            number = u + body.size * copy
            total[number] = total.get(number, 0) + weight
        return total

    def _inside(self, image: Image, weights: dict[int, complex], bits: int) -> tuple[int, ...] | None:
        """The flat list of vertex numbers and integer weights that prove an image to be inside; None where they do not.

        A weight is the integer c, or the integers Re c and Im c where vertices are complex.
        """
        rest = self._image(self._vertices[image.vertex], image.letter).entries()
        flat: list[int] = []
        total = arb(0)
        for number, weight in sorted(weights.items()):
            parts = [
                round(x * (1 << bits)) for x in ([weight.real, weight.imag] if self._body.complex else [weight.real])
            ]
            if not any(parts):
                continue
            flat += [number, *parts]
            c = _scaled(parts, bits)
            total += abs(c) + (ball(1) / (1 << bits) if self._body.complex else 0)
            rest = [x - c * y for x, y in zip(rest, self._vertex(number), strict=True)]
        room = 1 - ball(1) / (1 << _ROOM) - total - self._distance(rest) * (1 + ball(1) / (1 << 20))
        return tuple(flat) if room > 0 else None

    def _distance(self, rest: Sequence[Ball]) -> arb:
        """A number t such that the vector lies in t times the hull."""
        assert self._kappa is not None
        return self._kappa * _norm(rest) * (2 if self._body.complex else 1)

    def witness(self, places: int, bits: int, decided: Sequence[tuple[int, ...] | Tie]) -> RadiusProof:
        """The certificate's witness of this polytope: numbers have so many binary places, weights so many bits."""
        parents = [parent for parent in self._body.parents if parent is not None]
        ties = [tie for tie in decided if isinstance(tie, Tie)]
        witness: RadiusProof = {
            "rule": "monotone-closing" if self._body.monotone else "closing",
            "symmetry": self._family.symmetry,
            "bits": places,
            "leaders": tuple(self._leader(number) for number in range(len(self._leaders.each))),
            "extras": tuple(self._body.extras),
            "tree": tuple(x for parent in parents for x in parent),
            "basis": tuple(self._basis),
            "weight_bits": bits,
            "images": tuple(flat for flat in decided if not isinstance(flat, Tie)),
            "ties": tuple(
                {
                    "vertex": tie.vertex,
                    "letter": tie.letter,
                    "weights": tuple({"vertex": k, "weight": _plain(c)} for k, c in tie.weights),
                }
                for tie in ties
            ),
        }
        if any(tie.by_sigma for tie in ties):
            witness["sigma"] = self._ties.sigma
        return witness

    def _leader(self, number: int) -> LeaderData:
        leader = self._leaders.each[number]
        data: LeaderData = {
            "word": leader.candidate.word,
            "reflected": leader.candidate.reflected,
            "column": _column(leader.start),
            "scale": leader.scale,
            "annihilator": leader.annihilator,
        }
        if leader.eigenvalue.is_real:
            return {**data, "sign": 1 if leader.eigenvalue.region.real > 0 else -1}
        return {**data, **disc_data(leader.eigenvalue)}


class _MonotoneClosing(_Closing):
    """A polytope with its proof in balls, as `_Closing`, for a monotone hull.

    `basis` has for each coordinate a vertex where it is large, and a vector r is below Σ_k max(r_k, 0)/(coordinate k of
    basis vertex k) times a convex combination of these.
    """

    def _independent(self) -> list[int]:
        return self._body.numbers(self._body.columns.argmax(axis=1).tolist())

    def _condition(self) -> arb | None:
        """The largest 1/x of the coordinates x that a checker must see to be positive; None where some x is not.

        These are those of the basis vertices, and of the leaders, where they are not proved to be zero.
        """
        self._floors = [self._vertex(number)[k] for k, number in enumerate(self._basis)]
        of_leaders = [
            x
            for u in range(len(self._leaders.each))
            for k, x in enumerate(self._vertices[u].entries())
            if x > 0 or not self._ties.is_zero(u, k)
        ]
        positive = [*self._floors, *of_leaders]
        return _largest([1 / x for x in positive]) if all(x > 0 for x in positive) else None

    def _distance(self, rest: Sequence[Ball]) -> arb:
        parts = [x.max(arb(0)) / floor for x, floor in zip(rest, self._floors, strict=True)]
        return sum(parts, arb(0))

    def _smaller(self, vertex: int, letter: int, weights: Sequence[tuple[int, arb]], coordinate: int) -> bool:
        image = self._image(self._vertices[vertex], letter)[coordinate, 0]
        bound = sum((self._vertex(k)[coordinate] * c for k, c in weights), arb(0))
        return bool(image < bound)


def _column(start: tuple[int, ...]) -> int | tuple[int, ...]:
    """The number of a unit vector in place of the vector; other vectors as they are."""
    return start.index(1) if 1 in start and start.count(0) == len(start) - 1 else start


def _plain(weight: Weight) -> Fraction | tuple[Fraction, ...]:
    """A weight as plain data: a fraction, or the coefficients of a polynomial in Λ."""
    if isinstance(weight, Fraction):
        return weight
    of_powers = coefficients(weight)
    return of_powers[0] if len(of_powers) == 1 else of_powers


def _scaled(parts: Sequence[int], bits: int) -> Ball:
    unit = arb(fmpz(1) << bits)
    return arb(parts[0]) / unit if len(parts) == 1 else acb(arb(parts[0]) / unit, arb(parts[1]) / unit)


def _norm(entries: Sequence[Ball]) -> arb:
    """The sum ‖·‖₁ of the moduli of the entries."""
    return sum((abs(x) for x in entries), arb(0))


def _largest(balls: Sequence[arb]) -> arb:
    """A ball above all of these balls."""
    return arb(max(x.upper() for x in balls))
