"""The answer for a family of matrices: its joint spectral radius in outward doubles, in closed form, and the proof."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Literal

from flint import ctx

from subdiv_cli.exact.algebraic import number_of
from subdiv_cli.exact.closed import root_text
from subdiv_cli.exact.enclosures import ball, interval
from subdiv_cli.exact.linalg import matrix
from subdiv_cli.exact.rationals import whole
from subdiv_cli.exact.text import certain
from subdiv_cli.jsr.family import Family, Word
from subdiv_cli.jsr.irreducible import zero_radius
from subdiv_cli.jsr.products import WordProduct, radius_bound
from subdiv_cli.jsr.radius import joint_spectral_radius, rough_radius
from subdiv_cli.jsr.result import Radius
from subdiv_cli.jsr.weights import growing_bound
from subdiv_cli.model import Effort, Interval, Root, exact_root
from subdiv_cli.model.family import FamilyRadius
from subdiv_cli.model.proofs import LowerBound

_LARGEST_PRODUCT = 60
"""The largest order of a product that is a bound from below: its characteristic polynomial asks much of a checker."""
_LONGEST_POLYNOMIAL, _LONGEST_RATIONAL = 256, 4096
"""The most bits of a number in a closed form."""


def answer(matrices: Sequence[Sequence[Sequence[Fraction]]], effort: Effort, *, rough: bool = False) -> FamilyRadius:
    """The joint spectral radius of p >= 1 square matrices of one order, as far as the effort goes.

    Where `rough` is set, only the bound that takes next to nothing to prove.
    """
    family = Family([matrix(rows) for rows in matrices])
    if rough:
        return _answered(family, rough_radius(family, effort) if family.size else zero_radius(), effort)
    radius = joint_spectral_radius(family, effort)
    if radius is None or (radius.exact is None and radius.upper[1]):
        radius = _best(radius, rough_radius(family, Effort(effort.work)))
    return _answered(family, radius, effort)


def _answered(family: Family, radius: Radius | None, effort: Effort) -> FamilyRadius:
    stopped: Literal["budget"] | None = "budget" if effort.struck else None
    if radius is None:
        return FamilyRadius(order=family.order, letters=family.letters, stopped=stopped)
    below = None if radius.exact is not None or radius.word is None else _below(family, radius.word)
    if radius.exact is None and below is None and family.order > _LARGEST_PRODUCT:
        radius = radius._replace(word=None)
    bounds = _enclosed(radius, below)
    return FamilyRadius(
        order=family.order,
        letters=family.letters,
        lower=bounds.lower,
        upper=bounds.upper,
        exact=bounds.exact,
        digits=_digits(radius),
        words=() if radius.word is None else (_primitive(radius.word),),
        method=radius.method,
        vertices=radius.vertices,
        bounded=radius.bounded,
        stopped=stopped,
        proof=radius.proof,
        below=below,
    )


def _below(family: Family, word: Word) -> LowerBound | None:
    """The proof that the radius is at least that of a product; None where it is 0, or too dear for a checker."""
    if family.order > _LARGEST_PRODUCT:
        return growing_bound(family, word) if family.is_nonnegative else None
    product = WordProduct.of_word(family.matrices, word)
    return None if product.eigenvalue.rational == 0 else {"word": word, "bound": radius_bound(product)}


def _best(radius: Radius | None, rough: Radius | None) -> Radius | None:
    """The radius with the smaller bound, and the product of the first where it has one."""
    if radius is None or rough is None:
        return radius or rough
    return radius if radius.ceiling <= rough.ceiling else rough._replace(word=radius.word or rough.word)


def _primitive(word: tuple[int, ...]) -> tuple[int, ...]:
    """The word that a word is a power of: its product has the same spectral radius for each letter."""
    lengths = (d for d in range(1, len(word) + 1) if len(word) % d == 0)
    return next(word[:d] for d in lengths if word[:d] * (len(word) // d) == word)


def _enclosed(radius: Radius, below: LowerBound | None) -> Interval:
    length, bound = radius.upper
    with ctx.workprec(192):
        power = ball(1) / length
        if radius.exact is not None:
            root = radius.exact[1]
            value = interval(number_of(root).enclosure().real ** power)
            return Interval(lower=value.lower, upper=value.upper, exact=_closed_form(length, root))
        if bound == 0:
            return Interval(lower=0.0, upper=0.0, exact="0")
        upper = interval(ball(bound) ** power).upper
        if below is None:
            return Interval(lower=0.0, upper=upper)
        return Interval(lower=interval(ball(below["bound"]) ** (ball(1) / len(below["word"]))).lower, upper=upper)


def _closed_form(length: int, root: Root) -> str | None:
    """A closed form of ρ: `2`, `root(x^2-x-1, 1.61803, 1.61804)`, `25^(1/3)`, `root(…)^(1/2)`; None if it is long."""
    longest = max(abs(c).bit_length() for c in root.coefficients)
    if longest > (_LONGEST_POLYNOMIAL if root.low != root.high else _LONGEST_RATIONAL):
        return None
    if root.low != root.high:
        text = root_text(root)
        return text if length == 1 else f"{text}^(1/{length})"
    x = root.low
    for divisor in (d for d in range(length, 0, -1) if length % d == 0):
        parts = [exact_root(part, divisor) for part in x.as_integer_ratio()]
        if None not in parts:
            x, length = Fraction(parts[0] or 0, parts[1] or 1), length // divisor
            break
    text = whole(x)
    return text if length == 1 else f"{text}^(1/{length})" if x.denominator == 1 else f"({text})^(1/{length})"


def _digits(radius: Radius) -> str | None:
    if radius.exact is None:
        return None
    length, root = radius.exact
    return certain(lambda: number_of(root).enclosure().real ** (ball(1) / length), 15)
