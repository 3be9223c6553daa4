"""A finite family of rational matrices, its symmetry, sign and size, and its scaled float copy for the search."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import TYPE_CHECKING, NamedTuple

from flint import fmpq, fmpq_mat

from subdiv_cli.exact.rationals import to_fraction

if TYPE_CHECKING:
    from subdiv_cli.jsr.arrays import Array

Word = tuple[int, ...]
"""Letters 0, …, p-1; the product of w_1 … w_ℓ is M_(w_ℓ) … M_(w_1)."""


class Candidate(NamedTuple):
    """A product whose spectral radius, to the power 1/ℓ, may be the joint one: that of the word, or J times it.

    In a symmetric family (J Π)² is ± the product of the word and its mirror image, so J Π counts as a product too.
    """

    word: Word
    reflected: bool = False

    def power(self, times: int, letters: int) -> Candidate:
        """The candidate whose product is that of this one, raised to the power `times`."""
        mirror = tuple(letters - 1 - letter for letter in self.word)
        blocks = [mirror if self.reflected and i % 2 else self.word for i in range(times)]
        return Candidate(tuple(x for block in blocks for x in block), self.reflected and times % 2 == 1)


class Family:
    """The p >= 1 matrices M_0, …, M_(p-1), all N×N with N >= 1. Raises ValueError for anything else."""

    def __init__(self, matrices: Sequence[fmpq_mat]) -> None:
        self.matrices = tuple(matrices)
        if not matrices or {(m.nrows(), m.ncols()) for m in matrices} != {(self.order, self.order)} or not self.order:
            raise ValueError("a family needs square matrices of one order, at least one")

    @property
    def order(self) -> int:
        """The number N of rows of each matrix."""
        return self.matrices[0].nrows()

    @property
    def letters(self) -> int:
        """The number p of matrices."""
        return len(self.matrices)

    @cached_property
    def symmetry(self) -> int:
        """The sign τ = ±1 with M_(p-1-i) = τ J M_i J for all i, J the reversal of coordinates; 0 if there is none."""
        tables = [m.table() for m in self.matrices]
        turned = [[row[::-1] for row in table[::-1]] for table in tables[::-1]]
        if tables == turned:
            return 1
        return -1 if tables == [[[-x for x in row] for row in table] for table in turned] else 0

    @cached_property
    def is_nonnegative(self) -> bool:
        """Whether no entry is negative."""
        return all(x >= 0 for m in self.matrices for x in m.entries())

    @cached_property
    def distinct(self) -> Word:
        """The first letter of each matrix up to sign: products of these are all products, up to sign."""
        seen: dict[tuple[fmpq, ...], int] = {}
        for letter, m in enumerate(self.matrices):
            entries = tuple(m.entries())
            if tuple(-x for x in entries) not in seen:
                seen.setdefault(entries, letter)
        return tuple(seen.values())

    @cached_property
    def size(self) -> Fraction:
        """The largest absolute entry; 0 for a family of zeros."""
        return max((abs(to_fraction(x)) for m in self.matrices for x in m.entries()), default=Fraction(0))

    @cached_property
    def bits(self) -> int:
        """The bits of the longest number, where the matrices have integer entries over one common denominator."""
        common = lcm(*(int(m.numer_denom()[1]) for m in self.matrices))
        return common.bit_length() + max(0, self.size.numerator.bit_length() - self.size.denominator.bit_length() + 1)

    @cached_property
    def unit(self) -> Fraction:
        """A power of two near `size`, by which the matrices are divided before they become floats."""
        if not self.size:
            return Fraction(1)
        return Fraction(2) ** (self.size.numerator.bit_length() - self.size.denominator.bit_length())

    @cached_property
    def floats(self) -> Array:
        """The matrices divided by `unit`, as a p×N×N array of doubles, each entry rounded once."""
        import numpy as np

        scaled = [[[float(to_fraction(x) / self.unit) for x in row] for row in m.table()] for m in self.matrices]
        return np.array(scaled)

    def transposed(self) -> Family:
        """The family of the transposes."""
        return Family([m.transpose() for m in self.matrices])

    def product(self, word: Word) -> fmpq_mat:
        """The exact N×N product M_(w_ℓ) … M_(w_1) of the word w."""
        total = self.matrices[word[0]]
        for letter in word[1:]:
            total = self.matrices[letter] * total
        return total

    def candidate(self, candidate: Candidate) -> fmpq_mat:
        """The exact N×N product of the word, its rows reversed where the candidate is reflected."""
        product = self.product(candidate.word)
        return fmpq_mat(product.tolist()[::-1]) if candidate.reflected else product

    def full_word(self, candidate: Candidate) -> Word:
        """A word whose product has the eigenvalues of the candidate's, or ± their squares."""
        return candidate.word if not candidate.reflected else candidate.power(2, self.letters).word
