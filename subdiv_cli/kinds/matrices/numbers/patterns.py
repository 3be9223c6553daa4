"""Sign patterns of products of stochastic matrices: which entries are positive.

Theorem (Micchelli & Prautzsch 1989, Theorem 2.1). Stochastic A_0, …, A_(p-1) converge iff for some k all products of k
of them have a positive column.

A column of A_i C is positive if one of C is, as no row of A_i is 0: bad patterns, those without a positive column, come
from bad ones. The patterns of products are finitely many, and which follow is seen from the pattern alone. So either
the graph of bad patterns has a cycle, with matrices A = A_(w_ℓ) … A_(w_1) that lead from the pattern of a product C to
itself: then no A^j C has a positive column, nor has a limit of them, which so has not equal rows. Or the longest path
from the identity has k - 1 steps, and all products of k matrices have a positive column.

Corollary 2.3 there: if for each matrix and all consecutive rows R, more than one, the rows in R are positive in some
column of a set C of consecutive indices with |C| < |R|, then k <= n - 1. Corollary 2.4, two neighbouring positive
entries in each column but one, is a case of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from subdiv_cli.kinds.matrices.scheme import Matrix
from subdiv_cli.model import Effort

Pattern = tuple[int, ...]
"""For each row the set of its positive columns, as bits."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Patterns:
    """What the bad patterns say: a cycle, or the length from which on there are none."""

    length: int | None
    """The k from which on all products have a positive column; None where there is a cycle."""
    steps: int
    """The number of pairs of a bad pattern and a matrix."""
    cycle: tuple[int, ...] = ()
    """The word w of a product that no power of has a positive column."""
    corollary: str | None = None
    """The corollary that says it without the graph."""


def patterns(matrices: Sequence[Matrix], effort: Effort) -> Patterns | None:
    """What sign patterns say of stochastic matrices; None where there are too many for the effort."""
    family = [_pattern(a) for a in matrices]
    n = len(family[0])
    if all(_has_neighbours(a) for a in family):
        return Patterns(length=n - 1, steps=0, corollary="2.4")
    if all(_shrinks(a) for a in family):
        return Patterns(length=n - 1, steps=0, corollary="2.3")
    return _of_graph(family, effort)


def _of_graph(family: Sequence[Pattern], effort: Effort) -> Patterns | None:
    """A walk in depth over the bad patterns; the longest path from each is known when it is left."""
    n = len(family[0])
    start: Pattern = tuple(1 << i for i in range(n))
    longest: dict[Pattern, int] = {}
    path: list[tuple[Pattern, int]] = [(start, 0)]  # a pattern, and the next matrix to follow
    places = {start: 0}
    steps = 0
    while path:
        pattern, letter = path[-1]
        if letter == len(family):
            path.pop()
            del places[pattern]
            images = (times(a, pattern) for a in family)
            longest[pattern] = 1 + max((longest[image] for image in images if is_bad(image)), default=0)
            continue
        path[-1] = (pattern, letter + 1)
        steps += 1
        if not effort.allows(steps * n):
            return None
        following = times(family[letter], pattern)
        if not is_bad(following) or following in longest:
            continue
        if following in places:
            word = tuple(taken - 1 for _, taken in path[places[following] :])
            return Patterns(length=None, steps=steps, cycle=word)
        places[following] = len(path)
        path.append((following, 0))
    return Patterns(length=longest[start], steps=steps)


def _pattern(a: Matrix) -> Pattern:
    return tuple(sum(1 << j for j, x in enumerate(row) if x > 0) for row in a)


def times(a: Pattern, b: Pattern) -> Pattern:
    """The pattern of a product of matrices with these patterns."""
    rows = []
    for bits in a:
        union = 0
        for j, row in enumerate(b):
            if bits >> j & 1:
                union |= row
        rows.append(union)
    return tuple(rows)


def is_bad(pattern: Pattern) -> bool:
    """Whether no column is positive."""
    common = -1
    for row in pattern:
        common &= row
    return not common


def _has_neighbours(a: Pattern) -> bool:
    """Corollary 2.4: entries (i, i), (i+1, i) are positive for all i < n, or (i-1, i), (i, i) for all i > 1."""
    n = len(a)
    down = all(a[i] >> i & a[i + 1] >> i & 1 for i in range(n - 1))
    return down or all(a[i - 1] >> i & a[i] >> i & 1 for i in range(1, n))


def _shrinks(a: Pattern) -> bool:
    """Corollary 2.3, for one matrix."""
    n = len(a)
    runs = [((1 << size) - 1) << first for size in range(1, n) for first in range(n - size + 1)]
    return all(
        any(c.bit_count() < size and all(row & c for row in a[first : first + size]) for c in runs)
        for size in range(2, n + 1)
        for first in range(n - size + 1)
    )
