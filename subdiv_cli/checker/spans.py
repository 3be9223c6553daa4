"""Trees of images of given vectors, and spaces that words applied to their leaves span: for kinds with such spaces."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm
from operator import mul

from subdiv_cli.checker.matrices import PRIME, RationalFamily, dependent_rows
from subdiv_cli.checker.reading import require


def scaled(row: Sequence[Fraction]) -> tuple[list[int], int]:
    """Rationals as numerators over their common denominator."""
    common = lcm(*(x.denominator for x in row))
    return [x.numerator * (common // x.denominator) for x in row], common


def are_independent(rows: Sequence[Sequence[int]]) -> bool:
    """Whether rows of integers are independent modulo a prime: then over Q as well."""
    return not dependent_rows(rows)


def depth_of(tree: Sequence[int], roots: int, letters: int) -> int:
    """The depth of the tree over so many roots: a 1 for each leaf, a 0 for each node with an image for each letter.

    Raises Rejected where it is not complete, or has nodes too many.
    """
    level, ahead, depth, at = roots, 0, 0, 0
    while level:
        require(at + level <= len(tree), "the tree is not complete")
        ahead = letters * sum(1 - flag for flag in tree[at : at + level])
        at += level
        level, depth = ahead, depth + 1
    require(at == len(tree), "the tree has nodes that are no images")
    return depth


def require_spanned(
    family: RationalFamily, leaves: Sequence[Sequence[Fraction]], words: Sequence[Sequence[int]]
) -> None:
    """Check that as many words as the order of the family, a leaf and letters each, give independent vectors.

    Raises Rejected where they do not.
    """
    n = family.order
    require(len(words) == n, "there are not as many words as the basis has rows")
    inverse = pow(family.denominator, -1, PRIME)
    images = []
    for word in words:
        require(len(word) > 0 and 0 <= word[0] < len(leaves), "a word has no leaf")
        require(all(0 <= letter < len(family.matrices) for letter in word[1:]), "a letter is not there")
        numerators, common = scaled(leaves[word[0]])
        require(common % PRIME != 0, "a denominator is 0 modulo 2^61 - 1")
        v = [x * pow(common, -1, PRIME) % PRIME for x in numerators]
        for letter in word[1:]:
            v = [sum(map(mul, row, v)) * inverse % PRIME for row in family.matrices[letter]]
        images.append(v)
    require(are_independent(images), "the words do not span the space modulo 2^61 - 1")
