"""The search for spectrum-maximizing products: Gripenberg's branch and bound in floats, with a bounded front.

Gripenberg (1996): a product whose norms fall below the best radius found so far, all scaled by their lengths, is no
beginning of a better one, because every maximizing product has a rotation all of whose beginnings stay above. What is
found is a suggestion; `products` decides what it proves.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import reduce

import numpy as np

from subdiv_cli.jsr.arrays import Array, Integers
from subdiv_cli.jsr.ellipsoids import coordinates
from subdiv_cli.jsr.family import Candidate, Family, Word
from subdiv_cli.model import UNHURRIED, Effort

_TIE = 1e-10
"""Radii that differ by less, relatively, are taken for equal."""
_FRONT = 48
"""The most products kept at each length."""
_CELLS = (0.02, 0.4)
"""Products whose entries differ by less than such a share of the largest one are alike: two searches."""
_SMALL = 8
"""The order up to which there are two of them."""


def candidates(
    family: Family, longest: int, front: int = _FRONT, effort: Effort = UNHURRIED
) -> tuple[float, tuple[Candidate, ...]]:
    """The largest ρ(Π)^(1/ℓ) met among products of length at most `longest`, and the candidates that attain it.

    Primitive words, the least of each rotation class, by length and then alphabetically; in a symmetric family one of
    each mirrored pair, and half of a word whose other half is its mirror image. (0, ()) where every product met is
    nilpotent. The radius is that of the matrices divided by `family.unit`. Where the clock strikes, fewer lengths.
    """
    return _searched(family, family.floats, longest, _front(front), effort)


def long_candidates(family: Family, rate: float, longest: int, effort: Effort) -> tuple[float, tuple[Candidate, ...]]:
    """As `candidates`, of much longer products, where the radius `rate` of a shorter one is known.

    In coordinates in which the matrices have small norms more products fall below the best radius. Of those that are
    alike up to a factor only the largest one is kept.
    """
    ellipsoid = coordinates(family.floats / rate)
    scaled = ellipsoid @ (family.floats / rate) @ np.linalg.inv(ellipsoid)
    with np.errstate(all="ignore"):
        each = [
            _searched(family, scaled, longest, _unlike_front(cell), effort)
            for cell in _CELLS[: 2 if family.order <= _SMALL else 1]
        ]
    best, contenders = max(each, key=lambda pair: pair[0])
    return best * rate, contenders


def _searched(
    family: Family, matrices: Array, longest: int, front: Callable[[Array, float, int], Integers], effort: Effort
) -> tuple[float, tuple[Candidate, ...]]:
    """The largest radius of products of matrices that are similar to those of the family, and the candidates."""
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
        kept = front(products, best, length)
        if not len(kept):
            break
        products, words = _children(matrices, products[kept], words[kept])
    if best == 0.0:
        return 0.0, ()
    classes = {representative(word, family) for rate, word in rated if rate >= best * (1 - _TIE)}
    return best, tuple(sorted(classes, key=lambda candidate: (len(candidate.word), candidate)))


def _front(most: int) -> Callable[[Array, float, int], Integers]:
    """The choice of at most so many products (of M×N×N) that may begin a better one, the largest norms first."""

    def chosen(products: Array, best: float, length: int) -> Integers:
        norms = np.linalg.norm(products, ord=2, axis=(1, 2)) ** (1 / length)
        order = np.argsort(-norms, kind="stable")
        return np.asarray(order[norms[order] > best * (1 + _TIE)][:most])

    return chosen


def _unlike_front(cell: float) -> Callable[[Array, float, int], Integers]:
    """The same choice of products no two of which are about multiples of each other."""

    def chosen(products: Array, best: float, length: int) -> Integers:
        kept = _front(len(products))(products, best, length)
        if not len(kept):
            return kept
        flat = products[kept].reshape(len(kept), -1)
        largest = flat[np.arange(len(kept)), np.abs(flat).argmax(axis=1)]
        _, first = np.unique(np.round(flat / (largest[:, None] * cell)), axis=0, return_index=True)
        return np.asarray(kept[np.sort(first)][: 2 * _FRONT])

    return chosen


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

    In a symmetric family it is the least one of the word and of its mirror image. Where one rotation has a half that is
    the mirror image of the other, all have: rotated by a half each is its own mirror image.
    """
    root = _primitive_root(word)
    rotations = _rotations(root)
    if not family.symmetry:
        return Candidate(min(rotations))
    mirrored, half = _mirrored(root, family), len(root) // 2
    if len(root) % 2 == 0 and root[half:] + root[:half] == mirrored:
        return Candidate(min(w[:half] for w in rotations), reflected=True)
    return Candidate(min(*rotations, *_rotations(mirrored)))


def _rotations(word: Word) -> list[Word]:
    return [word[i:] + word[:i] for i in range(len(word))]


def _mirrored(word: Word, family: Family) -> Word:
    return tuple(family.letters - 1 - letter for letter in word)


def _primitive_root(word: Word) -> Word:
    n = len(word)
    return next(word[:d] for d in range(1, n + 1) if n % d == 0 and word[:d] * (n // d) == word)
