"""The joint spectral radius of a difference scheme, by the cheapest way that gives the number itself.

A symbol that is not negative on the circle; a norm that a short product attains; an invariant polytope. Where none of
them closes within the effort, the best bound of polytopes or norms.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import islice

from flint import fmpq_mat

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.products import Product, best_product
from subdiv_cli.jsr.result import Radius, root_data
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.operators import transition_matrices
from subdiv_cli.kinds.scalar.numbers.positive import positive_radius
from subdiv_cli.model import Data, Effort, Root

_FIRST_LEVELS = 4
_FIRST_WORK = 2000
"""For short products and norms, before a polytope is tried."""
_LARGE = 1 << 13
"""Bits of a coefficient from which on polytopes are not tried."""


def difference_radius(d: Laurent, p: int, effort: Effort) -> Radius | None:
    """The joint spectral radius of the scheme with symbol d; None where the effort does not suffice for any bound."""
    if (radius := positive_radius(d, p)) is not None:
        return radius
    matrices = transition_matrices(d, p)
    first = effort.limited(_FIRST_WORK)
    if (radius := _by_norms(d, p, best_product(matrices, first), first, _FIRST_LEVELS)) is not None and radius.exact:
        return radius
    numerators, denominator = d.integer_form()
    if max(numerators.height_bits(), denominator.bit_length()) < _LARGE:
        from subdiv_cli.jsr.radius import joint_spectral_radius  # numpy comes with it

        radius = joint_spectral_radius(Family(matrices), effort)
        if radius is not None and radius.exact:
            return radius
    return _better(radius, _by_norms(d, p, _product(matrices, radius, effort), effort, None))


def _product(matrices: Sequence[fmpq_mat], radius: Radius | None, effort: Effort) -> Product | None:
    if radius is not None and radius.word is not None:
        return Product.of_word(matrices, radius.word)
    return best_product(matrices, effort)


def _by_norms(d: Laurent, p: int, product: Product | None, effort: Effort, levels: int | None) -> Radius | None:
    """The best bound ‖S^L‖∞^(1/L), exact where the product attains it."""
    best: tuple[int, Fraction] | None = None
    for level, norm in enumerate(islice(power_norms(d, p, effort), levels), 1):
        if product is not None and product.closes(norm, level):
            return _norm_radius(product, level, norm, exact=True)
        if best is None or float(norm) ** (1 / level) < float(best[1]) ** (1 / best[0]):
            best = level, norm
    return None if best is None else _norm_radius(product, *best, exact=False)


def _norm_radius(product: Product | None, level: int, norm: Fraction, *, exact: bool) -> Radius:
    proof: dict[str, Data] = {"rule": "norm", "length": level, "bound": norm}
    root = Root((-norm.numerator, norm.denominator), norm, norm)
    if exact:
        proof["root"] = root_data(root)
    word = None if product is None else product.word
    return Radius(word, (level, root) if exact else None, (level, norm), exact, proof)


def _better(a: Radius | None, b: Radius | None) -> Radius | None:
    """The one with the smaller bound; it keeps the word of the first."""
    if a is None or b is None:
        return a or b
    return a if a.ceiling <= b.ceiling else b._replace(word=a.word or b.word)
