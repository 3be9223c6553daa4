"""Products of transition matrices: the search for one of large spectral radius.

Any product Π of ℓ matrices bounds the joint spectral radius from below by ρ(Π)^(1/ℓ). Which one is found is a matter
of luck and effort; what it proves rests on its exact characteristic polynomial.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import reduce
from typing import NamedTuple

from flint import ctx, fmpq_mat, fmpz_mat

from subdiv_cli.exact.algebraic import AlgebraicNumber, meets_circle, roots
from subdiv_cli.exact.enclosures import ball, bounds
from subdiv_cli.model import Effort, watch

_WORK_PER_WORD = 200
"""The cost of a word beside the entries of its matrix: about that of as many coefficients of a norm."""
_SQUARINGS = 4
_TIE = 1e-9
"""Logarithms of radii closer than this count as equal in the search."""


class WordProduct(NamedTuple):
    """A product Π = T_(w_ℓ) … T_(w_1) for the word w, and its eigenvalue λ that is largest as balls see it."""

    word: tuple[int, ...]
    matrix: fmpq_mat
    eigenvalue: AlgebraicNumber

    @classmethod
    def of_word(cls, matrices: Sequence[fmpq_mat], word: tuple[int, ...]) -> WordProduct:
        """The product of a word and its largest eigenvalue."""
        matrix = reduce(lambda product, letter: matrices[letter] * product, word[1:], matrices[word[0]])
        return cls(word, matrix, roots(matrix.charpoly())[0][0])

    def compare(self, r: Fraction) -> int:
        """The sign of |λ| - r^ℓ, exactly: >= 0 proves that the joint spectral radius is at least r. Needs r >= 0."""
        return self.eigenvalue.compare_modulus(r ** len(self.word))

    def closes(self, norm: Fraction, level: int) -> bool:
        """Whether Π has an eigenvalue λ with |λ|^(1/ℓ) = norm^(1/level), decided exactly.

        With `norm` that of all products of `level` matrices, the joint spectral radius then is this number. |λ| = r is
        asked of Π^level with the rational r = norm^ℓ: only a factor that is reciprocal in |z| = r meets that circle.
        """
        target = norm ** len(self.word)
        with ctx.workprec(64):
            gap = self.eigenvalue.modulus().log() * level - ball(target).log()
            if gap > 0 or gap < 0:
                return False
        if (rational := self.eigenvalue.rational) is not None and abs(rational) ** level == target:
            return True
        factors = (f for f, _ in (self.matrix**level).charpoly().numer().factor()[1])
        return any(meets_circle(f, target) for f in factors)


def radius_bound(product: WordProduct) -> Fraction:
    """The number |λ| where λ is rational, else a rational r <= |λ| of twenty digits. Needs λ ≠ 0."""
    if (rational := product.eigenvalue.rational) is not None:
        return abs(rational)
    with ctx.workprec(128):
        low, _ = bounds(product.eigenvalue.modulus())
    digits = 20 - math.floor(low.numerator.bit_length() * 0.30103 - low.denominator.bit_length() * 0.30103)
    unit = Fraction(10) ** -digits
    return low // unit * unit


def best_product(matrices: Sequence[fmpq_mat], effort: Effort) -> WordProduct | None:
    """The product with the largest |λ|^(1/ℓ) among short words in p N×N matrices; None without any.

    All are nilpotent then, or the effort is nil. The words are primitive and one of each rotation class.
    ‖Π^16‖^(1/16) >= ρ(Π) ranks them, so that few characteristic polynomials are needed. Ties go to the shortest word,
    then to the first.
    """
    integers, denominator = _over_common_denominator(matrices)
    order, bits = matrices[0].nrows(), max(int(x).bit_length() for m in integers for x in m.entries())
    ranked: list[tuple[float, tuple[int, ...], fmpz_mat]] = []
    spent = 0
    for tried, word in enumerate(lyndon_words(len(matrices))):
        spent += (_WORK_PER_WORD + order * order) * (1 + bits * len(word) // 64)
        watch.count(tried, "products")
        if not effort.allows(spent):
            break
        product = reduce(lambda product, letter: integers[letter] * product, word[1:], integers[word[0]])
        if (estimate := _log_radius_estimate(product) / len(word)) > -math.inf:
            ranked.append((estimate, word, product))
    ranked.sort(key=lambda entry: (-entry[0], len(entry[1]), entry[1]))
    best: tuple[float, WordProduct] | None = None
    for estimate, word, product in ranked:
        if best is not None and estimate < best[0] - _TIE:
            break
        exact = fmpq_mat(product) / denominator ** len(word)
        number = roots(exact.charpoly())[0][0]
        if number.rational == 0:
            continue
        size = float(number.region.__abs__().log().mid()) / len(word) + math.log(denominator)
        candidate = size, WordProduct(word, exact, number)
        if best is None or _better(candidate, best):
            best = candidate
    return None if best is None else best[1]


def _better(a: tuple[float, WordProduct], b: tuple[float, WordProduct]) -> bool:
    if abs(a[0] - b[0]) > _TIE:
        return a[0] > b[0]
    return (len(a[1].word), a[1].word) < (len(b[1].word), b[1].word)


def lyndon_words(letters: int) -> Iterator[tuple[int, ...]]:
    """The primitive words over 0, …, letters-1, the least of each rotation class, by length."""
    length = 1
    while letters > 1 or length == 1:
        yield from _lyndon_words_of_length(letters, length)
        length += 1


def _lyndon_words_of_length(letters: int, length: int) -> Iterator[tuple[int, ...]]:
    """The Lyndon words of exactly this length, by Duval's generation of all up to it, the shorter ones dropped."""
    word = [-1]
    while word:
        word[-1] += 1
        if len(word) == length:
            yield tuple(word)
        period = len(word)
        while len(word) < length:
            word.append(word[-period])
        while word and word[-1] == letters - 1:
            word.pop()


def _over_common_denominator(matrices: Sequence[fmpq_mat]) -> tuple[list[fmpz_mat], int]:
    pairs = [m.numer_denom() for m in matrices]
    denominator = math.lcm(*(int(d) for _, d in pairs))
    return [numerators * (denominator // int(d)) for numerators, d in pairs], denominator


def _log_radius_estimate(product: fmpz_mat) -> float:
    """The logarithm of ‖Π^16‖∞^(1/16) >= ρ(Π); -inf where Π^16 = 0."""
    for _ in range(_SQUARINGS):
        product = product * product
    norm = max(sum(abs(int(x)) for x in row) for row in product.table())
    return math.log(norm) / (1 << _SQUARINGS) if norm else -math.inf
