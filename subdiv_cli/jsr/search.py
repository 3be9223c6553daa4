"""The search for spectrum-maximizing products: Gripenberg's branch and bound in floats, with a bounded front.

Gripenberg (1996): a product whose norms fall below the best radius found so far, all scaled by their lengths, is no
beginning of a better one, because every maximizing product has a rotation all of whose beginnings stay above. What is
found is a suggestion; `products` decides what it proves.
"""

from __future__ import annotations

import math
from functools import reduce

import numpy as np

from subdiv_cli.jsr.arrays import Array, Integers
from subdiv_cli.jsr.family import Candidate, Family, Word
from subdiv_cli.model import UNHURRIED, Effort

_TIE = 1e-10
"""Radii that differ by less, relatively, are taken for equal."""
_FRONT = 48
"""The most products kept at each length."""


def candidates(
    family: Family, longest: int, front: int = _FRONT, effort: Effort = UNHURRIED
) -> tuple[float, tuple[Candidate, ...]]:
    """The largest ρ(Π)^(1/ℓ) met among products of length at most `longest`, and the candidates that attain it.

    Primitive words, the least of each rotation class, by length and then alphabetically; in a symmetric family one of
    each mirrored pair, and half of a word whose other half is its mirror image. (0, ()) where every product met is
    nilpotent. The radius is that of the matrices divided by `family.unit`. Where the clock strikes, fewer lengths.
    """
    matrices = family.floats
    products: Array = matrices
    words: Integers = np.arange(family.letters)[:, None]
    best, rated = 0.0, []
    for length in range(1, longest + 1):
        radii = np.abs(np.linalg.eigvals(products)).max(axis=1)
        rates = radii ** (1 / length)
        top = float(rates.max())
        best = max(best, top)
        near = rates >= best * (1 - _TIE)
        rated += [(float(rate), tuple(map(int, word))) for rate, word in zip(rates[near], words[near], strict=True)]
        if length == longest or not effort.allows(0):
            break
        kept = _front(products, best, length, front)
        if not len(kept):
            break
        products, words = _children(matrices, products[kept], words[kept])
    if best == 0.0:
        return 0.0, ()
    classes = {representative(word, family) for rate, word in rated if rate >= best * (1 - _TIE)}
    return best, tuple(sorted(classes, key=lambda candidate: (len(candidate.word), candidate)))


def _front(products: Array, best: float, length: int, most: int) -> Integers:
    """The numbers of the M products (M×N×N) that may begin a better one, at most `most`, the largest norms first."""
    norms = np.linalg.norm(products, ord=2, axis=(1, 2)) ** (1 / length)
    order = np.argsort(-norms, kind="stable")
    return np.asarray(order[norms[order] > best * (1 + _TIE)][:most])


def _children(matrices: Array, products: Array, words: Integers) -> tuple[Array, Integers]:
    letters, order = len(matrices), matrices.shape[1]
    longer = (matrices[:, None] @ products[None]).reshape(-1, order, order)
    spelled = [np.column_stack([words, np.full(len(words), letter)]) for letter in range(letters)]
    return longer, np.concatenate(spelled)


def rate(family: Family, word: Word) -> float:
    """The number log2 ρ(Π)^(1/ℓ) of a product of the matrices divided by `family.unit`; -inf where floats see none."""
    product = reduce(lambda product, letter: family.floats[letter] @ product, word, np.eye(family.order))
    radius = float(np.abs(np.linalg.eigvals(product)).max())
    return math.log2(radius) / len(word) if radius > 0 else -math.inf


def representative(word: Word, family: Family) -> Candidate:
    """The candidate that stands for a word: the least rotation of its primitive root.

    In a symmetric family it is the least one of the word and of its mirror image.
    """
    root = _primitive_root(word)
    if not family.symmetry:
        return Candidate(min(_rotations(root)))
    rotations = [*_rotations(root), *_rotations(_mirrored(root, family))]
    half = len(root) // 2
    halves = [w[:half] for w in rotations if len(w) % 2 == 0 and w[half:] == _mirrored(w[:half], family)]
    return Candidate(min(halves), reflected=True) if halves else Candidate(min(rotations))


def _rotations(word: Word) -> list[Word]:
    return [word[i:] + word[:i] for i in range(len(word))]


def _mirrored(word: Word, family: Family) -> Word:
    return tuple(family.letters - 1 - letter for letter in word)


def _primitive_root(word: Word) -> Word:
    n = len(word)
    return next(word[:d] for d in range(1, n + 1) if n % d == 0 and word[:d] * (n // d) == word)
