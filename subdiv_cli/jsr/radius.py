"""The joint spectral radius: enclosed always, exact where an invariant polytope closes.

In order: blocks, as far as the family can be taken apart; of matrices that are equal up to sign one; the search for
candidates; invariant polytopes from their leaders, the shortest ones first, with a deeper search where none closes; and
the bound that the polytope, or one for slightly smaller matrices, proves as it is. What is found depends on the effort
alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm

import numpy as np
from flint import ctx

from subdiv_cli.exact.enclosures import bounds
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.jsr.arrays import Numbers
from subdiv_cli.jsr.balance import scales
from subdiv_cli.jsr.body import Body, Start
from subdiv_cli.jsr.closing import close
from subdiv_cli.jsr.enclosing import Bound, by_columns, enclose
from subdiv_cli.jsr.family import Candidate, Family
from subdiv_cli.jsr.leaders import LONGEST_PRODUCT, Leader, Leaders, leaders, vector
from subdiv_cli.jsr.polytope import Grown, grow
from subdiv_cli.jsr.reduce import Blocks, decomposed
from subdiv_cli.jsr.result import Radius, root_data
from subdiv_cli.jsr.search import candidates
from subdiv_cli.model import Data, Effort, Root

LARGEST_ORDER = 120
LARGEST_BLOCK = 60
"""Of matrices for which polytopes are tried."""
_QUICK, _DEEP = 10, 24
"""Lengths of products in the first and in the second search."""
_QUICK_WORK = 1000
"""Gauges in the first polytope."""
_LONGEST_ROOT = 60_000
"""Bits of the coefficients of a root's polynomial; an enclosure has short numbers instead."""
_ROUNDING = 1e-9
_SLACK = (Fraction(1, 32), Fraction(1, 256), Fraction(1, 4096), Fraction(1, 1 << 20))
"""By how much the matrices are scaled down where the polytope at the candidate itself does not close."""


def joint_spectral_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius as far as the effort goes; None where it does not suffice for any bound."""
    if not family.size:
        return _zero()
    if family.order > LARGEST_ORDER or not effort.allows(family.order**2):
        return None
    if (blocks := decomposed(family)) is not None:
        return _of_blocks(blocks, effort)
    return _of_one_block(family, effort)


def _of_one_block(family: Family, effort: Effort) -> Radius | None:
    """A quick look at the shortest candidates, and at all of them; a deeper search, and whatever the effort allows."""
    if not family.size:
        return _zero()
    if family.order > LARGEST_BLOCK:
        return None
    if family.order > 1 and len(family.distinct) < family.letters:
        return _of_distinct(family, effort)
    found = _affordable(family, candidates(family, _QUICK)[1])
    if not found:
        return None
    quick = Effort(min(_QUICK_WORK, effort.work))
    shortest = [candidate for candidate in found if len(candidate.word) == len(found[0].word)]
    for some in (shortest, found) if len(shortest) < len(found) else (found,):
        if (radius := _Attempt(family, some, quick).closed()) is not None:
            return radius
    attempt = _Attempt(family, _affordable(family, candidates(family, _DEEP)[1]), effort)
    return attempt.closed() or attempt.enclosed()


def _affordable(family: Family, found: Sequence[Candidate]) -> Sequence[Candidate]:
    """Those whose exact products have no very long numbers; where none is left, the letter of largest radius."""
    if not found or any(len(candidate.word) * family.bits <= LONGEST_PRODUCT for candidate in found):
        return [candidate for candidate in found if len(candidate.word) * family.bits <= LONGEST_PRODUCT]
    sizes = np.abs(np.linalg.eigvals(family.floats)).max(axis=1)
    return (Candidate((int(sizes.argmax()),)),)


def _zero() -> Radius:
    return Radius(None, None, (1, Fraction(0)), True, {"rule": "zero", "length": 1, "bound": Fraction(0)})


def rough_radius(family: Family, effort: Effort) -> Radius | None:
    """A bound where there is no better one: for large orders, or vertices that floats do not get hold of.

    For large orders no product stands beside it: its characteristic polynomial asks too much of a checker.
    """
    if not effort.allows(family.order**2):
        return None
    found = candidates(family, 2)[1] if family.order <= LARGEST_BLOCK else ()
    bound = by_columns(family)
    proof: dict[str, Data] = {"rule": "polytope", "length": 1, "bound": bound.upper, **bound.witness}
    return Radius(family.full_word(found[0]) if found else None, None, (1, bound.upper), False, proof)


class _Attempt:
    """Polytopes from one set of candidates."""

    def __init__(self, family: Family, found: Sequence[Candidate], effort: Effort) -> None:
        self.family, self.found, self.effort = family, found, effort
        self.leaders = leaders(family, found)
        self.grown: Grown | None = None

    def closed(self) -> Radius | None:
        """The radius where the polytope closes at exactly the candidate and that can be proved."""
        if self.leaders is None:
            return None
        with ctx.workprec(128):
            self.sigma = to_fraction_of_ball(self.leaders)
        starts = [_start(self.family, leader) for leader in self.leaders.each]
        self.monotone = self.family.is_nonnegative and all(_is_nonnegative(start.vector) for start in starts)
        if len(starts) > 1 and not self.family.symmetry:
            starts = self._balanced(starts)
        self.grown = grow(self._body(starts, self.sigma), self.effort)
        root = self.leaders.root()
        if not self.grown.closed or root is None or _is_long(root[1]):
            return None
        if (witness := close(self.family, self.leaders, self.grown, self.effort)) is None:
            return None
        return _exactly(self.family, self.leaders, root, witness)

    def _body(self, starts: Sequence[Start], sigma: Fraction) -> Body:
        if self.monotone:
            starts = [start._replace(vector=np.maximum(start.vector, 0.0)) for start in starts]
        return Body(
            self.family.floats,
            float(sigma / self.family.unit),
            symmetric=bool(self.family.symmetry),
            starts=starts,
            monotone=self.monotone,
        )

    def _balanced(self, starts: Sequence[Start]) -> list[Start]:
        assert self.leaders is not None
        factors = scales(starts, lambda start: self._body([start], self.sigma), self.effort)
        pairs = zip(self.leaders.each, factors, strict=True)
        each = tuple(leader._replace(scale=leader.scale * factor) for leader, factor in pairs)
        self.leaders = self.leaders._replace(each=each)
        return [start._replace(vector=start.vector * float(x)) for start, x in zip(starts, factors, strict=True)]

    def enclosed(self) -> Radius | None:
        """The best bound of a polytope that is not closed, or that is for matrices scaled down a little."""
        if self.leaders is None:
            return None
        best = enclose(self.family, self.grown, self.sigma) if self.grown is not None else None
        for slack in _SLACK:
            scaled = self.sigma * (1 + slack)
            if best is not None and best.upper <= scaled:
                continue
            real = [Start((), np.asarray(_start(self.family, leader).vector.real)) for leader in self.leaders.each]
            grown = grow(self._body(real, scaled), self.effort)
            bound = enclose(self.family, grown, scaled)
            best = min((b for b in (best, bound) if b is not None), key=lambda b: b.upper, default=None)
            if not grown.closed:
                break
        return None if best is None else self._at_most(best)

    def _at_most(self, bound: Bound) -> Radius:
        assert self.leaders is not None
        word = self.family.full_word(self.leaders.each[0].candidate)
        proof: dict[str, Data] = {"length": 1, "bound": bound.upper, **bound.witness}
        return Radius(word, None, (1, bound.upper), False, proof)


def _is_long(root: Root) -> bool:
    """Whether the polynomial of a root is longer than a checker would read."""
    return max(abs(c).bit_length() for c in root.coefficients) > _LONGEST_ROOT


def to_fraction_of_ball(found: Leaders) -> Fraction:
    """σ as a rational, for the float side: its ball's midpoint."""
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
    """As floats see it."""
    return not np.iscomplexobj(vector) and bool(vector.min() >= -_ROUNDING * np.abs(vector).max())


def _exactly(family: Family, found: Leaders, root: tuple[int, Root], proof: dict[str, Data]) -> Radius:
    length, number = root
    word = family.full_word(found.each[0].candidate)
    said: dict[str, Data] = {"length": length, "root": root_data(number)}
    return Radius(word, root, (length, number.high), True, {**proof, **said})


def _of_blocks(blocks: Blocks, effort: Effort) -> Radius | None:
    """The largest radius of the parts: exact where it is of one part and the bounds of the others do not exceed it.

    Bounded products are not claimed: of parts with one radius they need not be.
    """
    parts = [_of_one_block(part, effort) for part in blocks.parts]
    known = [part for part in parts if part is not None]
    if len(known) < len(parts):
        return None
    top = max(known, key=lambda part: (part.exact is not None, part.ceiling))
    others = [part for part in known if part is not top]
    proof: dict[str, Data] = {
        "rule": "blocks",
        "basis": tuple(tuple(to_fraction(x) for x in row) for row in blocks.basis.table()),
        "sizes": tuple(part.order for part in blocks.parts),
        "parts": tuple(dict(part.proof) for part in known),
    }
    if top.exact is not None:
        length, root = top.exact
        below = [_at_most(part.upper, (length, root.low)) for part in others]
        same = [part.exact == top.exact for part in others]
        if all(x or y for x, y in zip(below, same, strict=True)):
            said: dict[str, Data] = {"length": length, "root": root_data(root)}
            return Radius(top.word, top.exact, top.upper, False, {**proof, **said})
    highest = max(known, key=lambda part: part.ceiling)
    length, bound = highest.upper
    if any(not _at_most(part.upper, (length, bound)) for part in known):
        return None
    word = max((part for part in known if part.word is not None), key=lambda part: part.ceiling, default=highest).word
    return Radius(word, None, (length, bound), False, {**proof, "length": length, "bound": bound})


def _of_distinct(family: Family, effort: Effort) -> Radius | None:
    """That of its matrices up to sign, whose products are the same up to sign."""
    letters = family.distinct
    found = _of_one_block(Family([family.matrices[letter] for letter in letters]), effort)
    if found is None:
        return None
    said = {key: found.proof[key] for key in ("length", "root", "bound") if key in found.proof}
    proof: dict[str, Data] = {"rule": "distinct", "letters": letters, "part": found.proof, **said}
    word = None if found.word is None else tuple(letters[letter] for letter in found.word)
    return found._replace(word=word, proof=proof)


def _at_most(a: tuple[int, Fraction], b: tuple[int, Fraction]) -> bool:
    """x^(1/n) <= y^(1/m) for (n, x) and (m, y)."""
    common = lcm(a[0], b[0])
    return bool(a[1] ** (common // a[0]) <= b[1] ** (common // b[0]))
