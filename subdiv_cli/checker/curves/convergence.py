"""Rules on convergence: matrices A_i whose rows sum to 1, B_i their transposes, e = (1, …, 1). See FORMAT.md."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import lcm
from operator import mul
from typing import NamedTuple

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.radius.families import UPPER, bound_of
from subdiv_cli.checker.reading import require, require_few
from subdiv_cli.checker.roots import fraction_bits

LOWER = ("radius-lower", "radius", "bounded")
_MAX_PATTERNS = 1_000_000
Pattern = tuple[int, ...]
"""For each row the set of its positive columns, as bits."""


class Scaled(NamedTuple):
    """A rational vector: integers over one denominator > 0."""

    entries: list[int]
    denominator: int


def scaled(v: Sequence[Fraction]) -> Scaled:
    """The vector over its common denominator."""
    common = lcm(*(x.denominator for x in v))
    return Scaled([x.numerator * (common // x.denominator) for x in v], common)


def bits_of(rows: Iterable[Sequence[Fraction]]) -> int:
    """The bits of the entries of the longest row together, which bound those over a common denominator."""
    return max((sum(map(fraction_bits, row)) for row in rows), default=0)


def refinement(c: Claim) -> RationalFamily:
    """The matrices A_i of the document. Raises Rejected unless they refine polygons: p, n >= 2, and rows sum to 1."""
    family: RationalFamily = c.about
    require(len(family.matrices) >= 2 and family.order >= 2, "there are not two matrices of order 2")
    rows = [row for a in family.matrices for row in a]
    require(all(sum(row) == family.denominator for row in rows), "a row of a matrix does not sum to 1")
    return family


def differences(c: Claim) -> None:
    """The new family is that of the B_i on e^⊥, in the basis e_j - e_(j+1): coordinates are the sums of first entries.

    (B v)_1 + … + (B v)_i for v = e_j - e_(j+1) is Σ_(r<=i) A_jr - A_(j+1)r.
    """
    n = c.about.order
    c.count(len(c.about.matrices) * n**2, c.about.bits + n.bit_length())
    family = refinement(c)
    induced = []
    for a in family.matrices:
        steps = [[x - y for x, y in zip(row, after, strict=True)] for row, after in pairwise(a)]
        sums = [[sum(step[: i + 1]) for step in steps] for i in range(n - 1)]
        induced.append(sums)
    c.introduce(c.statement["family"], matrices.family(induced, family.denominator))


def contracts(c: Claim) -> None:
    """All polygons converge: JSR(B | e^⊥) < 1."""
    c.count(1)
    used = c.use(*UPPER).statement
    c.use("family", family=used["family"], on="polygons")
    require(bound_of(used) < 1, "the radius is not small enough")


def expands(c: Claim) -> None:
    """Some polygon does not converge: JSR(B | e^⊥) >= 1."""
    c.count(1)
    used = c.use(*LOWER).statement
    c.use("family", family=used["family"], on="polygons")
    require(bound_below(used) >= 1, "the radius is not large enough")


def bound_below(s: dict[str, Fraction]) -> Fraction:
    """The bound y with JSR^length >= y, of a claim that bounds a radius from below."""
    return s["bound" if s["property"] == "radius-lower" else "low"]


def _stochastic(c: Claim) -> list[Pattern]:
    family = refinement(c)
    require(min(min(row) for a in family.matrices for row in a) >= 0, "an entry of a matrix is negative")
    return [tuple(sum(1 << j for j, x in enumerate(row) if x) for row in a) for a in family.matrices]


def positive_columns(c: Claim) -> None:
    """All products of k of the stochastic matrices have a positive column.

    Patterns without one come from such patterns alone, since no row of a matrix is zero: those of products of 0, 1, 2,
    … matrices are listed, each once a length, until at length k there is none.
    """
    family: RationalFamily = c.about
    n, k, most = family.order, c.statement["length"], c.witness["steps"]
    require_few(most <= _MAX_PATTERNS, "there are too many patterns")
    c.count(len(family.matrices) * n**2 + most * n**2)
    signs = _stochastic(c)
    level, steps = {tuple(1 << i for i in range(n))}, 0
    for _ in range(k):
        steps += len(level) * len(signs)
        require(steps <= most, "there are more patterns than stated")
        level = {image for pattern in level for a in signs if _is_bad(image := _times(a, pattern))}
    require(not level, f"a product of {k} matrices has no positive column")


def consecutive_columns(c: Claim) -> None:
    """All products of n - 1 of the stochastic matrices have a positive column: consecutive rows shrink.

    In each matrix each r > 1 consecutive rows are positive in some of less than r consecutive columns. From all n rows
    on, a product of n - 1 matrices is traced back to one column.
    """
    family: RationalFamily = c.about
    n = family.order
    c.count(len(family.matrices) * n**4)
    require(c.statement["length"] == n - 1, f"the length is not {n - 1}")
    runs = [(first, size) for size in range(1, n + 1) for first in range(n - size + 1)]
    for number, a in enumerate(_stochastic(c)):
        for first, size in runs:
            rows = a[first : first + size]
            smaller = (((1 << width) - 1) << start for start, width in runs if width < size)
            require(size == 1 or any(all(row & bits for row in rows) for bits in smaller),
                    f"rows from {first} on of matrix {number} do not shrink")  # fmt: skip


def columns_converge(c: Claim) -> None:
    """All polygons converge: all products of k stochastic matrices have a positive column (MP, Theorem 2.1).

    The smallest positive entry a of such columns makes the spread of the control points fall by 1 - a in k steps.
    """
    c.count(1)
    c.use("positive-columns")


def _times(a: Pattern, b: Pattern) -> Pattern:
    product = []
    for bits in a:
        union = 0
        for j, row in enumerate(b):
            if bits >> j & 1:
                union |= row
        product.append(union)
    return tuple(product)


def _is_bad(pattern: Pattern) -> bool:
    common = -1
    for row in pattern:
        common &= row
    return not common


class Ends(NamedTuple):
    """The points ψ(0) and ψ(1) of the curve."""

    left: Scaled
    right: Scaled


def meets(c: Claim) -> Ends:
    """The limits make one curve iff B_j f_0 = B_(j-1) f_(p-1) for 0 < j < p, f_i = B_i f_i with e·f_i = 1.

    The f_i are determined, as all polygons converge. The curve is continuous then.
    """
    family: RationalFamily = c.about
    n, p = family.order, len(family.matrices)
    vectors = [c.witness["left"], c.witness["right"]]
    require(all(len(v) == n for v in vectors), "a vector is of another order")
    c.count(2 * p * n**2, family.bits + 2 * bits_of(vectors) + n.bit_length())
    c.use("convergent", holds=True)
    refinement(c)
    ends = Ends(*map(scaled, vectors))
    for letter, end in zip((0, p - 1), ends, strict=True):
        require(sum(end.entries) == end.denominator, "the entries of a vector do not sum to 1")
        image = image_of(family, letter, end.entries)
        require(image == [family.denominator * x for x in end.entries], "a vector is not fixed")
    require(joints_fit(family, *ends) is c.statement["holds"], "the joints say otherwise")
    return ends


def image_of(family: RationalFamily, letter: int, v: Sequence[int]) -> list[int]:
    """The vector B_letter v times the denominator of the family: combinations of rows of A."""
    return [sum(map(mul, column, v)) for column in zip(*family.matrices[letter], strict=True)]


def joints_fit(family: RationalFamily, left: Scaled, right: Scaled) -> bool:
    """Whether B_j left = B_(j-1) right for 0 < j < p."""
    for j in range(1, len(family.matrices)):
        one, other = image_of(family, j, left.entries), image_of(family, j - 1, right.entries)
        if [right.denominator * x for x in one] != [left.denominator * x for x in other]:
            return False
    return True
