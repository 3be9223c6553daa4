"""The joint spectral radius of one family, not taken apart: candidates, invariant polytopes, bounds.

In order: of matrices that are equal up to sign one; the search for candidates; invariant polytopes from their leaders,
the shortest ones first, with a deeper search where none closes; and the bound that the polytope, or one for slightly
smaller matrices, proves as it is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial

import numpy as np
from flint import arb, ctx

from subdiv_cli.exact.enclosures import ball, bounds
from subdiv_cli.jsr.arrays import Array, Numbers
from subdiv_cli.jsr.balance import scales
from subdiv_cli.jsr.body import Polytope, Start
from subdiv_cli.jsr.closing import close
from subdiv_cli.jsr.eigenspaces import surrounding
from subdiv_cli.jsr.ellipsoids import common_ellipsoid, ellipsoid_bound
from subdiv_cli.jsr.enclosing import RadiusBound, enclose
from subdiv_cli.jsr.family import Candidate, Family
from subdiv_cli.jsr.leaders import LONGEST_PRODUCT, Leader, Leaders, leaders, vector
from subdiv_cli.jsr.polytope import Grown, grow, grow_on, measured
from subdiv_cli.jsr.result import Radius, carried
from subdiv_cli.jsr.search import candidates, long_candidates
from subdiv_cli.jsr.search import rate as _rate
from subdiv_cli.jsr.weights import weighted_radius
from subdiv_cli.model import HALF, Effort, Look, Root
from subdiv_cli.model.proofs import RadiusProof, root_data

LARGEST_BLOCK = 120
"""The largest order of matrices for which polytopes are tried."""
_LARGE = 60
"""The order beyond which only polytopes are grown that close soon."""
_QUICK, _DEEP, _LONG = 10, 24, 300
"""The lengths of products in the first and in the second search, and where orders are small."""
_THIN = 8
"""The order beyond which an ellipsoid proves more than most polytopes that are not closed: they are left out."""
_CLOSE = 0.03
"""The relative width of such an enclosure beyond which, up to a moderate order, they are measured all the same."""
_SMALL = 8
"""The order up to which long products are searched before the polytopes of short ones are grown far."""
_MODERATE, _SHORT = 30, 4
"""The order beyond which eigenvalues take long, and the length of the products that are searched there first."""
_QUICK_WORK = 1000
"""Gauges that are computed in the first polytope."""
_BRIEF_WORK = 100
"""Gauges for a polytope that nothing but boundedness depends on."""
_LONGEST_ROOT = 60_000
"""The most bits of the coefficients of a root's polynomial; an enclosure has short numbers instead."""
_ROUNDING = 1e-9
_MARGIN = 30
_HUGE = 1e12
"""Entries so much larger than the radius are not for floats."""
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
        return _of_distinct(family, effort, irreducible_radius)
    attempts: list[_Attempt] = []
    growing = effort.limited(effort.work, HALF)
    if (radius := growing.in_time(lambda: _closed(family, attempts, growing))) is not None:
        return radius
    return _enclosed(family, attempts, effort)


def _closed(family: Family, attempts: list[_Attempt], effort: Effort) -> Radius | None:
    """The radius where a polytope closes at exactly a candidate; the attempts are added to the list.

    Raises ClockStruckError.
    """
    shallow = _affordable(family, candidates(family, _QUICK, effort=effort)[1])
    shortest = [candidate for candidate in shallow if len(candidate.word) == len(shallow[0].word)]
    for some in (shortest, shallow) if len(shortest) < len(shallow) else (shallow,) if shallow else ():
        quick = effort.limited(_QUICK_WORK, HALF)
        attempts.append(_Attempt(family, some, effort.look))
        if (radius := quick.in_time(partial(attempts[-1].closed, quick))) is not None:
            return radius
    if not shallow:
        return None
    last = attempts[-1]
    rate = 2.0 ** _rate(family, family.full_word(shallow[0]))
    if (radius := common_ellipsoid(family, rate, shallow, effort)) is not None:
        return radius
    if (long := _long(family, shallow, effort)) is not None:
        attempts.append(_Attempt(family, long, effort.look))
        quick = effort.limited(max(_QUICK_WORK, effort.work // 4), HALF)
        if (radius := quick.in_time(partial(attempts[-1].closed, quick))) is not None:
            return radius
    if family.order > _LARGE:
        return None
    deep = _affordable(family, candidates(family, _DEEP, effort=effort)[1])
    if deep != shallow or (last.leaders is not None and last.leaders.has_both_signs):
        attempts.append(_Attempt(family, deep, effort.look, squared=True))
    elif last.has_closed:  # more of the same effort would find the same
        return None
    return attempts[-1].closed(effort.limited(max(_QUICK_WORK, effort.work // 2)))


def _long(family: Family, shallow: Sequence[Candidate], effort: Effort) -> Sequence[Candidate] | None:
    """The candidates among long products, where their radius is larger than that of the short ones."""
    longest = min(_LONG, effort.work // family.order**2)
    if longest <= _DEEP:
        return None
    rate = 2.0 ** _rate(family, family.full_word(shallow[0]))
    if not np.abs(family.floats).max() < rate * _HUGE:
        return None
    best, contenders = long_candidates(family, rate, longest, effort)
    return _affordable(family, contenders) if best > rate * (1 + _ROUNDING) else None


def _enclosed(family: Family, attempts: Sequence[_Attempt], effort: Effort) -> Radius | None:
    """The best bound of polytopes that close in floats; else of all, and of those for matrices scaled down a little.

    From below, the best product of all attempts. All of these there are with more effort too. None without any.
    """
    attempts = [attempt for attempt in attempts if attempt.leaders is not None]
    if not attempts:
        return None
    best = max(attempts, key=lambda attempt: attempt.sigma)
    assert best.leaders is not None
    word, ellipsoid = family.full_word(best.leaders.each[0].candidate), None
    if family.order > 1:
        ellipsoid = ellipsoid_bound(family, float(best.sigma / family.unit), effort)
    excess = math.inf
    if ellipsoid is not None and family.order > _THIN and not family.is_nonnegative:
        top, bottom = best.sigma.as_integer_ratio()
        excess = 2.0 ** (ellipsoid.ceiling - math.log2(top) + math.log2(bottom)) - 1
    states = [(attempt.sigma, state) for attempt in attempts for state in attempt.states]
    bound = _best_bound(family, [pair for pair in states if pair[1].closed], effort)
    if bound is None and (ellipsoid is None or family.order <= _LARGE):
        work = effort.work // 4 if excess < math.inf else effort.work
        slackened = attempts[-1].slackened(effort.limited(work, HALF), excess)
        states = [*states, *slackened]
        if excess < (_CLOSE if family.order <= _MODERATE else math.inf):
            states = [pair for pair in slackened if pair[1].closed]
        bound = _best_bound(family, states, effort)
    if bound is None or (ellipsoid is not None and ellipsoid.upper[1] < bound.upper**2):
        return ellipsoid and ellipsoid._replace(word=word)
    proof: RadiusProof = {"length": 1, "bound": bound.upper, **bound.witness}
    return Radius(word, None, (1, bound.upper), False, proof)


def _best_bound(family: Family, states: Sequence[tuple[Fraction, Grown]], effort: Effort) -> RadiusBound | None:
    """The best bound of polytopes, each with the number that its matrices are divided by; those are measured first.

    Where the clock strikes at one of them, it is the turn of those with at most half as many vertices.
    """
    measuring, polytopes = effort.limited(effort.work, HALF), list[tuple[Fraction, Grown]]()
    for sigma, state in sorted(states, key=lambda pair: len(pair[1].left)):
        if (known := measuring.in_time(partial(measured, state, measuring.look))) is not None:
            polytopes.append((sigma, known))
    polytopes.sort(key=lambda pair: float(pair[0]) * max(1.0, pair[1].value))
    largest = max((state.body.size for _, state in polytopes), default=0)
    for sigma, state in polytopes:
        if state.body.size <= largest:
            part = effort.limited(effort.work, HALF)
            if (bound := part.in_time(partial(enclose, family, state, sigma, part.look))) is not None:
                return bound
            largest = state.body.size // 2 if part.struck else largest
    return None


def closed_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius of a family, irreducible or not, where a polytope of all of it closes quickly; None otherwise.

    The products are then bounded by powers of the radius, which that of diagonal blocks does not tell.
    """
    if not family.size or family.order > LARGEST_BLOCK or not (contenders := candidates(family, _QUICK)[1]):
        return None
    brief = effort.limited(_BRIEF_WORK)
    return brief.in_time(lambda: _Attempt(family, _affordable(family, contenders), brief.look).closed(brief))


def monotone_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius of a family without negative entries, where a monotone polytope of it closes quickly.

    In the given coordinates, or of the transposes; None otherwise.
    """
    if not family.size or family.order > LARGEST_BLOCK:
        return zero_radius() if not family.size else None
    if family.order > 1 and len(family.distinct) < family.letters:
        return _of_distinct(family, effort, monotone_radius)
    if (radius := weighted_radius(family, effort)) is not None:
        return radius
    shallow = candidates(family, _QUICK if family.order <= _MODERATE else _SHORT, effort=effort)[1]
    if not (contenders := _affordable(family, shallow)):
        return None
    attempts = _both_ways(family, contenders, effort)
    if (radius := _closing(attempts, _BRIEF_WORK, effort)) is not None:
        return radius
    if family.order <= _SMALL and (long := _long(family, contenders, effort)) is not None:
        attempts = _both_ways(family, long, effort)
    return _closing(attempts, _QUICK_WORK, effort)


def _both_ways(family: Family, contenders: Sequence[Candidate], effort: Effort) -> tuple[_Attempt, _Attempt]:
    """Attempts at a family and at its transposes, whose words are reversed."""
    reversals = [Candidate(candidate.word[::-1], candidate.reflected) for candidate in contenders]
    return _Attempt(family, contenders, effort.look), _Attempt(family.transposed(), reversals, effort.look)


def _closing(attempts: tuple[_Attempt, _Attempt], work: int, effort: Effort) -> Radius | None:
    """The radius where the polytope of one of the two attempts closes, the second one at transposes."""
    for number, attempt in enumerate(attempts):
        quick = effort.limited(work, HALF)
        if (radius := quick.in_time(partial(attempt.closed, quick))) is not None:
            assert radius.word is not None
            return carried("transposed", radius, radius.word[::-1]) if number else radius
    return None


def _of_distinct(family: Family, effort: Effort, radius_of: Callable[[Family, Effort], Radius | None]) -> Radius | None:
    """The radius of the matrices that differ up to sign: their products are the products of all, up to sign."""
    letters = family.distinct
    radius = radius_of(Family([family.matrices[letter] for letter in letters]), effort)
    if radius is None:
        return None
    word = None if radius.word is None else tuple(letters[letter] for letter in radius.word)
    return carried("distinct", radius, word, letters)


def _affordable(family: Family, contenders: Sequence[Candidate]) -> Sequence[Candidate]:
    """The candidates whose exact products have no very long numbers; if none, the letter of largest radius."""
    if not contenders or any(len(candidate.word) * family.bits <= LONGEST_PRODUCT for candidate in contenders):
        return [candidate for candidate in contenders if len(candidate.word) * family.bits <= LONGEST_PRODUCT]
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
    enclosed = effort.in_time(partial(enclose, family, grown, sigma, effort.look)) if grown.closed else None
    if enclosed is None or enclosed.upper**length > bound:
        return None
    return Radius(None, None, (1, enclosed.upper), False, {"length": 1, "bound": enclosed.upper, **enclosed.witness})


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

    def __init__(self, family: Family, contenders: Sequence[Candidate], look: Look, *, squared: bool = False) -> None:
        self.family = family
        self.leaders = leaders(family, contenders, squared=squared, look=look)
        if self.leaders is not None:
            with ctx.workprec(128):
                self.sigma = to_fraction_of_ball(self.leaders)
            if self.sigma < family.unit * _SMALLEST:
                self.leaders = None
        self.starts: list[Start] | None = None
        self.monotone = False
        self.grown: Grown | None = None
        self.states: list[Grown] = []
        """The polytopes that bounds are taken from."""

    @property
    def has_closed(self) -> bool:
        """Whether the polytope closes, as floats see it."""
        return self.grown is not None and self.grown.closed

    def closed(self, effort: Effort) -> Radius | None:
        """The radius where the polytope closes at exactly the candidate and that can be proved.

        Raises ClockStruckError.
        """
        if self.leaders is None:
            return None
        if self.starts is None:
            self.starts = self._first(effort)
        if self.grown is None:
            self.grown = grow(self._body(self.starts, self.sigma), effort)
        else:
            self.grown = grow_on(self.grown, effort)
        self.states += [self.grown] if self.grown.closed else self.grown.states
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

    def slackened(self, effort: Effort, most: float = math.inf) -> list[tuple[Fraction, Grown]]:
        """The polytopes for matrices scaled down, each with the number that takes the place of σ.

        By less and less as long as they close, or by more until one does, but no more than `most`. No one takes more
        than the effort, and all together no more than twice of it.
        """
        assert self.leaders is not None
        real = [Start((), np.asarray(_start(self.family, leader).vector.real)) for leader in self.leaders.each]
        polytopes: list[tuple[Fraction, Grown]] = []
        closes: bool | None = None
        slack, left = _SLACK, 2 * effort.work
        while left > 0 and _SLACK**3 <= slack <= min(1, most):
            scaled = self.sigma * (1 + slack)
            grown = grow(self._body(real, scaled), effort.limited(left, HALF))
            polytopes += [(scaled, state) for state in ((grown,) if grown.closed else grown.states)]
            left -= grown.spent
            closes = grown.closed if closes is None else closes
            if grown.closed is not closes or not effort.allows(0):
                break
            slack = slack / 4 if grown.closed else slack * 4
        return polytopes


def _is_long(root: Root) -> bool:
    """Whether the polynomial of a root is longer than a checker would read."""
    return max(abs(c).bit_length() for c in root.coefficients) > _LONGEST_ROOT


def to_fraction_of_ball(leading: Leaders) -> Fraction:
    """The candidate σ as a rational, for the float side: the midpoint of its ball."""
    low, high = bounds(leading.sigma())
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


def _exactly(family: Family, leading: Leaders, root: tuple[int, Root], witness: RadiusProof) -> Radius:
    length, number = root
    word = family.full_word(leading.each[0].candidate)
    return Radius(word, root, (length, number.high), True, {**witness, "length": length, "root": root_data(number)})
