"""Masks on Z^s: the one that a document is about, and plain mask files."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim, Subject
from subdiv_cli.checker.multivariate.lattice import DilationMatrix, Index, Sparse, over_one
from subdiv_cli.checker.plain import PlainMask, literal
from subdiv_cli.checker.reading import Rejected, require

MAX_COSETS = 4096
_INDEX = re.compile(r"(0|-?[1-9][0-9]{0,8})(,(0|-?[1-9][0-9]{0,8})){1,3}")
_MAX_DEPTH = 4
"""The most levels of nested coefficients: a mask has no more variables."""


class SparseMask(NamedTuple):
    """A mask on Z^s, numerators over one common denominator > 0, none of them zero, and its dilation."""

    dilation: DilationMatrix
    terms: Sparse
    denominator: int

    @property
    def bits(self) -> int:
        """The bits of the longest numerator and of the denominator together."""
        return max(map(abs, self.terms.values())).bit_length() + self.denominator.bit_length()

    def sum_is_m(self) -> bool:
        """Whether the coefficients add up to m: φ with ∫φ = 1 exists."""
        return sum(self.terms.values()) == self.dilation.cosets * self.denominator

    def by_coset(self) -> list[list[tuple[Index, int]]]:
        """The terms of each of the m cosets, in any order."""
        groups: dict[Index, list[tuple[Index, int]]] = {}
        for index, numerator in self.terms.items():
            groups.setdefault(self.dilation.residue(index), []).append((index, numerator))
        return [*groups.values(), *([] for _ in range(self.dilation.cosets - len(groups)))]


def multivariate_mask(rows: Sequence[Index], terms: Sequence[tuple[Index, Fraction]]) -> SparseMask:
    """The mask with these rows of M and these terms. Raises Rejected where M is not expanding or shapes differ."""
    s = len(rows)
    require(
        2 <= s <= 4 and all(len(row) == s for row in rows), "the dilation is not a square matrix of order 2, 3 or 4"
    )
    require(all(len(index) == s for index, _ in terms), f"an index is not one of Z^{s}")
    matrix = [list(row) for row in rows]
    if (inverted := matrices.inverse(matrix)) is None:
        raise Rejected("the dilation is singular")
    f = matrices.characteristic_polynomial(matrix)
    require(matrices.roots_lie_inside(f[::-1], Fraction(1)), "the dilation is not expanding")
    require(abs(inverted[1]) <= MAX_COSETS, f"the determinant of the dilation is larger than {MAX_COSETS}")
    return SparseMask(DilationMatrix(matrix, *inverted), *over_one(terms))


def subject(parts: dict[str, Any]) -> Subject:
    """The mask of a document, from its parts. Raises Rejected where it is none."""
    mask = multivariate_mask(parts["dilation"], parts["terms"])
    return Subject(mask.dilation.cosets, mask)


def mask_of(c: Claim) -> SparseMask:
    """The mask that the document is about."""
    mask: SparseMask = c.about
    return mask


def plain(dilation: Iterable[Iterable[int]], terms: Iterable[tuple[Iterable[int], Fraction]]) -> PlainMask:
    """The mask in its normal form: sorted; without zeros if the terms are."""
    return PlainMask("multivariate", (tuple(map(tuple, dilation)), tuple(sorted((tuple(x), c) for x, c in terms))))


def of_file(document: Mapping[str, Any]) -> PlainMask | None:
    """The mask of a file: `terms = {"0,1" = 1}`, or `coefficients` nested by the number of variables.

    These begin at `start`, at zero if it is left out.
    """
    table = document.get("mask")
    if type(table) is not dict:
        return None
    keys = table.keys() - {"dilation"}
    if keys == {"terms"} and type(table["terms"]) is dict:
        if not all(_INDEX.fullmatch(key) for key in table["terms"]):
            return None
        terms = {tuple(map(int, key.split(","))): literal(x) for key, x in table["terms"].items()}
    elif {"coefficients"} <= keys <= {"start", "coefficients"}:
        start = table.get("start", [0] * _depth(table["coefficients"]))
        if not _is_index(start):
            return None
        terms = dict(_entries(table["coefficients"], tuple(start)))
    else:
        return None
    s = len(next(iter(terms), ()))
    dilation = table.get("dilation", 2)
    if type(dilation) is int:
        dilation = [[dilation if i == j else 0 for j in range(s)] for i in range(s)]
    square = type(dilation) is list and len(dilation) == s >= 2 and all(_is_index(x) and len(x) == s for x in dilation)
    if not square or any(len(index) != s for index in terms):
        return None
    return plain(dilation, ((x, c) for x, c in terms.items() if c))


def _is_index(value: object) -> bool:
    return type(value) is list and 2 <= len(value) <= _MAX_DEPTH and all(type(i) is int for i in value)


def _depth(nested: object) -> int:
    """The number of lists in lists at the first entry, counted up to one more than there can be variables."""
    depth = 0
    while type(nested) is list and nested and depth <= _MAX_DEPTH:
        nested, depth = nested[0], depth + 1
    return depth


def _entries(nested: object, start: Index) -> Iterator[tuple[Index, Fraction]]:
    """The pairs of an index and a number: a_(start + (i, j, …)) = nested[i][j]… for nested lists.

    Raises ValueError where lists side by side are not of one length.
    """
    if not start:
        yield (), literal(nested)
        return
    if type(nested) is not list or not nested:
        raise ValueError("not nested as deep as there are variables")
    if len(start) > 1 and len({len(member) if type(member) is list else -1 for member in nested}) != 1:
        raise ValueError("lists of different lengths")
    for i, member in enumerate(nested, start[0]):
        for rest, value in _entries(member, start[1:]):
            yield (i, *rest), value


def of_certificate(mask: Mapping[str, Any]) -> PlainMask:
    """The mask in its normal form, from the part of a verified certificate under `mask`."""
    return plain(mask["dilation"], ((index, Fraction(c)) for index, c in mask["terms"]))
