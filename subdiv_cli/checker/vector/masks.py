"""Masks of matrices: the one that a document is about, moved to begin at 0; sequences of vectors; plain mask files.

(T_ε v)(α) = Σ_β A_(ε+pα-β)^T v(β), ε = 0 … p-1, for finitely supported sequences v of m-vectors.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from operator import mul
from typing import Any, NamedTuple

from subdiv_cli.checker.core import Claim, Subject
from subdiv_cli.checker.matrices import Matrix, RationalFamily, dependent_rows
from subdiv_cli.checker.plain import PlainMask, literal
from subdiv_cli.checker.reading import require, require_few, several

MAX_ARITY = 64
MAX_SIZE = 16
MAX_MATRICES = 1000
MATRICES = several("matrix", MAX_MATRICES)
"""The reader of a list of square matrices, each over a denominator of its own."""

VectorSequence = dict[int, list[int]]
"""A sequence of m-vectors of integers at the indices where it may not be 0."""


class MatrixMask(NamedTuple):
    """The matrices A_start, A_(start+1), … of order m, as numerators over one common denominator > 0."""

    arity: int
    start: int
    matrices: list[Matrix]
    denominator: int

    @property
    def size(self) -> int:
        """The order m."""
        return len(self.matrices[0])

    @property
    def bits(self) -> int:
        """The bits of the longest numerator and of the denominator, and of a sum of products with all matrices."""
        largest = max(max(map(abs, row)) for matrix in self.matrices for row in matrix)
        return (largest * len(self.matrices) * self.size).bit_length() + self.denominator.bit_length()

    @property
    def entries(self) -> int:
        """The number of entries of all matrices: what an image of a sequence costs for each index."""
        return len(self.matrices) * self.size**2

    def sums(self) -> list[Matrix]:
        """The numerators of the p matrices A^ε = Σ_β A_(ε+pβ)."""
        total = [[[0] * self.size for _ in range(self.size)] for _ in range(self.arity)]
        for i, matrix in enumerate(self.matrices, self.start):
            epsilon = i % self.arity
            total[epsilon] = [
                [x + y for x, y in zip(a, b, strict=True)] for a, b in zip(total[epsilon], matrix, strict=True)
            ]
        return total

    def images(self, v: VectorSequence) -> list[VectorSequence]:
        """The numerators of T_ε v for each ε, of the mask moved to begin at 0, over the mask's denominator."""
        images: list[VectorSequence] = [{} for _ in range(self.arity)]
        columns = [list(zip(*matrix, strict=True)) for matrix in self.matrices]
        for beta, x in v.items():
            for gamma, transposed in enumerate(columns):
                alpha, epsilon = divmod(beta + gamma, self.arity)
                image = [sum(map(mul, column, x)) for column in transposed]
                if any(image):
                    old = images[epsilon].get(alpha)
                    images[epsilon][alpha] = image if old is None else [a + b for a, b in zip(old, image, strict=True)]
        return images


def matrix_mask(arity: int, start: int, families: Sequence[RationalFamily]) -> MatrixMask:
    """The mask of these matrices. Raises Rejected for an arity or sizes out of bounds, and where all are zero."""
    require(2 <= arity <= MAX_ARITY, f"the arity is not one of 2, …, {MAX_ARITY}")
    require(len(families) > 0, "there is no matrix")
    order = families[0].order
    require(all(family.order == order for family in families), "the matrices are of two orders")
    require_few(order <= MAX_SIZE, "the matrices are too large")
    common = lcm(*(family.denominator for family in families))
    matrices = [
        [[x * (common // family.denominator) for x in row] for row in family.matrices[0]] for family in families
    ]
    require(any(any(row) for matrix in matrices for row in matrix), "the mask is zero")
    return MatrixMask(arity, start, matrices, common)


def subject(parts: dict[str, Any]) -> Subject:
    """The mask of a document, from its parts. Raises Rejected where it is none."""
    return Subject(parts["arity"], matrix_mask(parts["arity"], parts["start"], parts["coefficients"]))


def mask_of(c: Claim) -> MatrixMask:
    """The mask that the document is about."""
    mask: MatrixMask = c.about
    return mask


def sequence(start: int, row: Sequence[int], m: int) -> VectorSequence:
    """The sequence with these entries, m for each index from `start` on, without zeros."""
    each = {start + i: list(row[m * i : m * i + m]) for i in range(len(row) // m)}
    return {i: x for i, x in each.items() if any(x)}


def total(v: VectorSequence, m: int) -> list[int]:
    """The sum Σ v(α)."""
    return [sum(x[k] for x in v.values()) for k in range(m)]


def nonzero(v: VectorSequence) -> VectorSequence:
    """The sequence without zeros."""
    return {i: x for i, x in v.items() if any(x)}


def rank(rows: Sequence[Sequence[int]]) -> int:
    """The rank of rows of integers modulo a prime: at most that over Q."""
    return len(rows) - len(dependent_rows(rows))


def plain(kind: str, arity: int, start: int, matrices: Sequence[Sequence[Sequence[Fraction]]]) -> PlainMask:
    """The mask in its normal form, without zeros at its ends."""
    rows = [tuple(map(tuple, matrix)) for matrix in matrices]
    support = [i for i, matrix in enumerate(rows) if any(map(any, matrix))] or [0]
    return PlainMask(kind, (arity, start + support[0], tuple(rows[support[0] : support[-1] + 1])))


def of_file(document: Mapping[str, Any]) -> PlainMask | None:
    """The mask of a file: `arity`, which may be left out, `start` and `coefficients`."""
    table = document.get("mask")
    if type(table) is not dict or not {"start", "coefficients"} <= table.keys() <= {"arity", "start", "coefficients"}:
        return None
    arity, start, matrices = table.get("arity", 2), table["start"], table["coefficients"]
    if type(arity) is not int or type(start) is not int or not _are_square(matrices):
        return None
    return plain(document["kind"], arity, start, [[[literal(x) for x in row] for row in matrix] for matrix in matrices])


def _are_square(matrices: object) -> bool:
    """Whether these are lists of lists of lists, all square and of one order."""
    if type(matrices) is not list or not matrices or not all(type(a) is list and a for a in matrices):
        return False
    m = len(matrices[0])
    return all(len(a) == m and all(type(row) is list and len(row) == m for row in a) for a in matrices)


def of_certificate(mask: Mapping[str, Any]) -> PlainMask:
    """The mask in its normal form, from the part of a verified certificate under `mask`."""
    matrices = [[[Fraction(x) for x in row] for row in matrix] for matrix in mask["coefficients"]]
    return plain(mask["kind"], mask["arity"], mask["start"], matrices)


def lowest_terms(v: VectorSequence, denominator: int) -> tuple[VectorSequence, int]:
    """The sequence over this denominator, both divided by what they have in common."""
    common = gcd(denominator, *(x for values in v.values() for x in values))
    return {i: [x // common for x in values] for i, values in v.items()}, denominator // common
