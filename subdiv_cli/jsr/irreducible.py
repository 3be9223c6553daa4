"""The joint spectral radius of one family, not taken apart: candidates, invariant polytopes, bounds.

In order: of matrices that are equal up to sign one; the search for candidates; invariant polytopes from their leaders,
the shortest ones first, with a deeper search where none closes; and the bound that the polytope, or one for slightly
smaller matrices, proves as it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from flint import arb, ctx

from subdiv_cli.exact.enclosures import ball, bounds
from subdiv_cli.jsr.arrays import Array, Numbers
from subdiv_cli.jsr.balance import scales
from subdiv_cli.jsr.body import Polytope, Start
from subdiv_cli.jsr.closing import close
from subdiv_cli.jsr.eigenspaces import surrounding
from subdiv_cli.jsr.enclosing import RadiusBound, enclose
from subdiv_cli.jsr.family import Candidate, Family
from subdiv_cli.jsr.leaders import LONGEST_PRODUCT, Leader, Leaders, leaders, vector
from subdiv_cli.jsr.polytope import Grown, grow, grow_on, measured
from subdiv_cli.jsr.result import Radius, root_data
from subdiv_cli.jsr.search import candidates
from subdiv_cli.model import Data, Effort, Root

LARGEST_BLOCK = 60
"""The largest order of matrices for which polytopes are tried."""
_QUICK, _DEEP = 10, 24
"""The lengths of products in the first and in the second search."""
_QUICK_WORK = 1000
"""Gauges that are computed in the first polytope."""
_BRIEF_WORK = 100
"""Gauges for a polytope that nothing but boundedness depends on."""
_LONGEST_ROOT = 60_000
"""The most bits of the coefficients of a root's polynomial; an enclosure has short numbers instead."""
_ROUNDING = 1e-9
_MARGIN = 30
_SMALLEST = Fraction(1, 1 << 600)
"""The smallest radius, measured in the largest entry: polytopes for smaller ones have no double coordinates."""
_SLACK = Fraction(1, 64)
"""The share by which the matrices are scaled down first where the polytope at the candidate does not close."""


def irreducible_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius of one family, or a bound of it; None where the effort does not suffice for any.

    A quick look at the shortest candidates, and at all of them; a deeper search, and whatever the effort allows. Half
    of it goes to polytopes for the candidates themselves, and as much as all of it to bounds.
    """
    if not family.size:
        return zero_radius()
    if family.order > LARGEST_BLOCK:
        return None
    if family.order > 1 and len(family.distinct) < family.letters:
        return _of_distinct(family, effort)
    found = _affordable(family, candidates(family, _QUICK)[1])
    if not found:
        return None
    quick = effort.limited(_QUICK_WORK)
    shortest = [candidate for candidate in found if len(candidate.word) == len(found[0].word)]
    for some in (shortest, found) if len(shortest) < len(found) else (found,):
        attempt = _Attempt(family, some)
        if (radius := attempt.closed(quick)) is not None:
            return radius
    deep = _affordable(family, candidates(family, _DEEP)[1])
    if deep != found or (attempt.leaders is not None and attempt.leaders.has_both_signs):
        attempt = _Attempt(family, deep, squared=True)
    elif attempt.grown is not None and attempt.grown.closed:  # more effort would find the same
        return attempt.enclosed(effort)
    return attempt.closed(effort.limited(max(_QUICK_WORK, effort.work // 2))) or attempt.enclosed(effort)


def closed_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius of a family, irreducible or not, where a polytope of all of it closes quickly; None otherwise.

    The products are then bounded by powers of the radius, which that of diagonal blocks does not tell.
    """
    if not family.size or family.order > LARGEST_BLOCK or not (found := candidates(family, _QUICK)[1]):
        return None
    return _Attempt(family, _affordable(family, found)).closed(effort.limited(_BRIEF_WORK))


def _of_distinct(family: Family, effort: Effort) -> Radius | None:
    """The radius of the matrices that differ up to sign: their products are the products of all, up to sign."""
    letters = family.distinct
    found = irreducible_radius(Family([family.matrices[letter] for letter in letters]), effort)
    if found is None:
        return None
    said = {key: found.proof[key] for key in ("length", "root", "bound") if key in found.proof}
    proof: dict[str, Data] = {"rule": "distinct", "letters": letters, "part": found.proof, **said}
    word = None if found.word is None else tuple(letters[letter] for letter in found.word)
    return found._replace(word=word, proof=proof)


def _affordable(family: Family, found: Sequence[Candidate]) -> Sequence[Candidate]:
    """The candidates whose exact products have no very long numbers; if none, the letter of largest radius."""
    if not found or any(len(candidate.word) * family.bits <= LONGEST_PRODUCT for candidate in found):
        return [candidate for candidate in found if len(candidate.word) * family.bits <= LONGEST_PRODUCT]
    sizes = np.abs(np.linalg.eigvals(family.floats)).max(axis=1)
    return (Candidate((int(sizes.argmax()),)),)


def bounded(family: Family, limit: tuple[int, Fraction], effort: Effort) -> Radius | None:
    """A proof of ρ^n <= x for (n, x), by a polytope that closes quickly; None where there is none."""
    if not family.size:
        return zero_radius()
    length, bound = limit
    with ctx.workprec(128):
        sigma = bounds(ball(bound) ** (arb(1) / length))[0] * (1 - Fraction(1, 1 << _MARGIN))
    start = _leading_vector(family)
    body = Polytope(
        family.floats, float(sigma / family.unit), symmetric=bool(family.symmetry), starts=[Start((), start)]
    )
    grown = grow(body, effort.limited(_QUICK_WORK))
    found = enclose(family, grown, sigma) if grown.closed else None
    if found is None or found.upper**length > bound:
        return None
    return Radius(None, None, (1, found.upper), False, {"length": 1, "bound": found.upper, **found.witness})


def _leading_vector(family: Family) -> Array:
    """The real part of an eigenvector of the largest eigenvalue of any of the matrices: N doubles, of length 1."""
    values, vectors = np.linalg.eig(family.floats)
    k, j = np.unravel_index(int(np.abs(values).argmax()), values.shape)
    vector = vectors[k, :, j].real
    return np.asarray(vector / np.linalg.norm(vector))


def zero_radius() -> Radius:
    """The radius 0 of a family of zeros, with its proof."""
    return Radius(None, None, (1, Fraction(0)), True, {"rule": "zero", "length": 1, "bound": Fraction(0)})


class _Attempt:
    """The polytopes that grow from one set of candidates."""

    def __init__(self, family: Family, found: Sequence[Candidate], *, squared: bool = False) -> None:
        self.family = family
        self.leaders = leaders(family, found, squared=squared)
        if self.leaders is not None:
            with ctx.workprec(128):
                self.sigma = to_fraction_of_ball(self.leaders)
            if self.sigma < family.unit * _SMALLEST:
                self.leaders = None
        self.starts: list[Start] | None = None
        self.grown: Grown | None = None

    def closed(self, effort: Effort) -> Radius | None:
        """The radius where the polytope closes at exactly the candidate and that can be proved."""
        if self.leaders is None:
            return None
        if self.starts is None:
            self.starts = self._first(effort)
        if self.grown is None:
            self.grown = grow(self._body(self.starts, self.sigma), effort)
        else:
            self.grown = grow_on(self.grown, effort)
        root = self.leaders.root()
        if not self.grown.closed or root is None or _is_long(root[1]):
            return None
        if (witness := close(self.family, self.leaders, self.grown, effort)) is None:
            return None
        return _exactly(self.family, self.leaders, root, witness)

    def _first(self, effort: Effort) -> list[Start]:
        """The starts of the polytope: leaders in number and length as they go together best."""
        assert self.leaders is not None
        starts = [_start(self.family, leader) for leader in self.leaders.each]
        self.monotone = self.family.is_nonnegative and all(_is_nonnegative(start.vector) for start in starts)
        if not self.monotone and (more := self._surrounding(effort)) is not None:
            self.leaders = more
            return [_start(self.family, leader) for leader in more.each]
        return self._balanced(starts, effort) if len(starts) > 1 else starts

    def _body(self, starts: Sequence[Start], sigma: Fraction) -> Polytope:
        if self.monotone:
            starts = [start._replace(vector=np.maximum(start.vector, 0.0)) for start in starts]
        return Polytope(
            self.family.floats,
            float(sigma / self.family.unit),
            symmetric=bool(self.family.symmetry),
            starts=starts,
            monotone=self.monotone,
        )

    def _balanced(self, starts: Sequence[Start], effort: Effort) -> list[Start]:
        assert self.leaders is not None
        factors = scales(starts, lambda start: self._body([start], self.sigma), effort)
        pairs = zip(self.leaders.each, factors, strict=True)
        each = tuple(leader._replace(scale=leader.scale * factor) for leader, factor in pairs)
        self.leaders = self.leaders._replace(each=each)
        return [start._replace(vector=start.vector * float(x)) for start, x in zip(starts, factors, strict=True)]

    def _surrounding(self, effort: Effort) -> Leaders | None:
        assert self.leaders is not None
        return surrounding(self.family, self.leaders, lambda starts: self._body(starts, self.sigma), effort)

    def enclosed(self, effort: Effort) -> Radius | None:
        """The best bound of a polytope that is not closed, or that is for matrices scaled down a little."""
        if self.leaders is None:
            return None
        grown = self.grown
        if grown is not None and grown.closed and (bound := enclose(self.family, grown, self.sigma)) is not None:
            return self._at_most(bound)
        found = [] if grown is None else [(self.sigma, grown)]
        found += self._slackened(effort)
        found = [(scaled, measured(grown)) for scaled, grown in found]
        found.sort(key=lambda pair: float(pair[0]) * max(1.0, pair[1].value))
        bounds = (enclose(self.family, grown, scaled) for scaled, grown in found)
        best = next((bound for bound in bounds if bound is not None), None)
        return None if best is None else self._at_most(best)

    def _slackened(self, effort: Effort) -> list[tuple[Fraction, Grown]]:
        """The polytopes for matrices scaled down, each with the number that takes the place of σ.

        By less and less as long as they close, or by more until one does. No one takes more than the effort, and all
        together no more than twice of it.
        """
        assert self.leaders is not None
        real = [Start((), np.asarray(_start(self.family, leader).vector.real)) for leader in self.leaders.each]
        found: list[tuple[Fraction, Grown]] = []
        slack, left = _SLACK, 2 * effort.work
        while left > 0 and _SLACK**3 <= slack <= 1:
            scaled = self.sigma * (1 + slack)
            grown = grow(self._body(real, scaled), effort.limited(left))
            found.append((scaled, grown))
            left -= grown.spent
            if grown.closed is not found[0][1].closed:
                break
            slack = slack / 4 if grown.closed else slack * 4
        return found

    def _at_most(self, bound: RadiusBound) -> Radius:
        assert self.leaders is not None
        word = self.family.full_word(self.leaders.each[0].candidate)
        proof: dict[str, Data] = {"length": 1, "bound": bound.upper, **bound.witness}
        return Radius(word, None, (1, bound.upper), False, proof)


def _is_long(root: Root) -> bool:
    """Whether the polynomial of a root is longer than a checker would read."""
    return max(abs(c).bit_length() for c in root.coefficients) > _LONGEST_ROOT


def to_fraction_of_ball(found: Leaders) -> Fraction:
    """The candidate σ as a rational, for the float side: the midpoint of its ball."""
    low, high = bounds(found.sigma())
    return (low + high) / 2


def _start(family: Family, leader: Leader) -> Start:
    with ctx.workprec(256):
        entries = vector(family, leader).entries()
        if leader.eigenvalue.is_real:
            return Start(leader.candidate.word, np.array([float(x.mid()) for x in entries]))
        return Start(
            leader.candidate.word, np.array([complex(float(x.real.mid()), float(x.imag.mid())) for x in entries])
        )


def _is_nonnegative(vector: Numbers) -> bool:
    """Whether no entry of a vector is negative, as floats see it."""
    return not np.iscomplexobj(vector) and bool(vector.min() >= -_ROUNDING * np.abs(vector).max())


def _exactly(family: Family, found: Leaders, root: tuple[int, Root], proof: dict[str, Data]) -> Radius:
    length, number = root
    word = family.full_word(found.each[0].candidate)
    said: dict[str, Data] = {"length": length, "root": root_data(number)}
    return Radius(word, root, (length, number.high), True, {**proof, **said})
