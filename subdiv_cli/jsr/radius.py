"""The joint spectral radius: enclosed always, exact where an invariant polytope closes.

A family is taken apart into blocks as far as can be. The one that seems largest comes first, and of the others only
bounds are asked that do not exceed it, where that is possible. What is found depends on the effort alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction

from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.jsr.enclosing import by_columns
from subdiv_cli.jsr.family import Family, Word
from subdiv_cli.jsr.irreducible import LARGEST_BLOCK, bounded, irreducible_radius, monotone_radius, zero_radius
from subdiv_cli.jsr.reduce import Blocks, by_pattern, decomposed
from subdiv_cli.jsr.result import Radius
from subdiv_cli.jsr.search import candidates, rate
from subdiv_cli.jsr.weights import weighted_radius
from subdiv_cli.model import HALF, UNHURRIED, Effort
from subdiv_cli.model.proofs import RadiusProof, root_data

RadiusOf = Callable[[Family, Effort], Radius | None]
"""A function that finds the radius of a part."""

LARGEST_ORDER = 120
_LEAST_ORDER = 10
"""The order below which a block takes no less time: what is done once for each block."""
_SHORT = 4
"""The length of the products that tell which block seems largest."""
_CLEARLY = math.log2(1 - 1e-3)
"""A block whose products stay below the largest radius by this factor may be bounded by it quickly."""


def joint_spectral_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius as far as the effort goes; None where it does not suffice for any bound."""
    if not family.size:
        return zero_radius()
    if family.order > LARGEST_ORDER or not effort.allows(family.order**2):
        return None
    part = effort.limited(effort.work, HALF)
    if family.is_nonnegative and (radius := part.in_time(lambda: _of_nonnegative(family, part))) is not None:
        return radius
    part = effort.limited(effort.work, HALF)
    if (blocks := part.in_time(lambda: decomposed(family, part.look))) is not None:
        return _of_blocks(blocks, effort, _some_radius)
    return irreducible_radius(family, effort)


def _some_radius(family: Family, effort: Effort) -> Radius | None:
    """The radius of a part, or a rough bound where the effort does not suffice for a better one."""
    return irreducible_radius(family, effort) or rough_radius(family, UNHURRIED)


def _of_nonnegative(family: Family, effort: Effort) -> Radius | None:
    """The radius of a family without negative entries where it is soon known exactly in the given coordinates.

    By one positive vector, or by monotone polytopes of its strong components; None otherwise.
    """
    if (radius := weighted_radius(family, effort)) is not None:
        return radius
    if (blocks := by_pattern(family)) is None:
        return monotone_radius(family, effort)
    radius = _of_blocks(blocks, effort, monotone_radius)
    return radius if radius is not None and radius.exact is not None else None


def rough_radius(family: Family, effort: Effort) -> Radius | None:
    """A bound where there is no better one: for large orders, or vertices that floats do not get hold of.

    For large orders no product stands beside it: its characteristic polynomial asks too much of a checker.
    """
    if not effort.allows(family.order**2):
        return None
    contenders = candidates(family, 2)[1] if family.order <= LARGEST_BLOCK else ()
    bound = by_columns(family)
    word = family.full_word(contenders[0]) if contenders else None
    return Radius(word, None, (1, bound.upper), False, {"length": 1, "bound": bound.upper, **bound.witness})


def _of_blocks(blocks: Blocks, effort: Effort, radius_of: RadiusOf) -> Radius | None:
    """The largest radius of the parts: exact where it is of one part and the bounds of the others do not exceed it.

    Bounded products are not claimed: of parts with one radius they need not be.
    """
    if (known := _of_parts(blocks.parts, effort, radius_of)) is None:
        return None
    top = max(known, key=lambda part: (part.exact is not None, part.ceiling))
    others = [part for part in known if part is not top]
    witness: RadiusProof = {
        "rule": "blocks",
        "basis": tuple(tuple(to_fraction(x) for x in row) for row in blocks.basis.table()),
        "sizes": tuple(part.order for part in blocks.parts),
        "parts": tuple(part.proof for part in known),
    }
    if top.exact is not None:
        length, root = top.exact
        below = [_at_most(part.upper, _floor(top)) for part in others]
        same = [part.exact == top.exact for part in others]
        if all(x or y for x, y in zip(below, same, strict=True)):
            proof: RadiusProof = {**witness, "length": length, "root": root_data(root)}
            return Radius(top.word, top.exact, top.upper, False, proof)
    highest = max(known, key=lambda part: part.ceiling)
    length, bound = highest.upper
    if any(not _at_most(part.upper, (length, bound)) for part in known):
        return None
    words = [part.word for part in known if part.word is not None]
    word = max(words, key=lambda word: _rate(blocks, word), default=None)
    return Radius(word, None, (length, bound), False, {**witness, "length": length, "bound": bound})


def _of_parts(parts: Sequence[Family], effort: Effort, radius_of: RadiusOf) -> list[Radius] | None:
    """The radius of every part, as far as it is known, or a bound that does not exceed the largest one.

    Each part has a share of the time, by its order, small ones as one of order `_LEAST_ORDER`. Where it gives no bound,
    its columns may have one that is small.
    """
    seems = [_logarithm(candidates(part, _SHORT)[0]) + _logarithm(part.unit) for part in parts]
    radii: dict[int, Radius] = {}
    top: Radius | None = None
    costs = [max(part.order, _LEAST_ORDER) ** 3 for part in parts]
    cost = sum(costs)
    for k in sorted(range(len(parts)), key=lambda k: (-seems[k], k)):
        radius, part = None, effort.limited(effort.work, costs[k] / cost)
        cost -= costs[k]
        if top is not None and seems[k] < _CLEARLY + _logarithm(top.upper[1]) / top.upper[0]:
            radius = bounded(parts[k], _floor(top), part)
        if radius is None and (radius := radius_of(parts[k], part)) is None:
            radius = rough_radius(parts[k], UNHURRIED)
            if radius is None or top is None or not _at_most(radius.upper, _floor(top)):
                return None
        radii[k] = radius
        if top is None or radius.ceiling > top.ceiling:
            top = radius
    return [radii[k] for k in range(len(parts))]


def _rate(blocks: Blocks, word: Word) -> float:
    """The logarithm of the spectral radius of a product, over its length, as floats see it."""
    rates = [rate(part, word) + _logarithm(part.unit) for part in blocks.parts if part.size]
    return max(rates, default=-math.inf)


def _logarithm(x: Fraction | float) -> float:
    """The logarithm to the base 2, also of numbers that are no doubles."""
    if not x:
        return -math.inf
    numerator, denominator = x.as_integer_ratio()
    return math.log2(numerator) - math.log2(denominator)


def _floor(radius: Radius) -> tuple[int, Fraction]:
    """A pair (n, x) with ρ^n >= x, close to that, where ρ is known; its bound otherwise."""
    return radius.upper if radius.exact is None else (radius.exact[0], radius.exact[1].low)


def _at_most(a: tuple[int, Fraction], b: tuple[int, Fraction]) -> bool:
    """Whether x^(1/n) <= y^(1/m) for (n, x) and (m, y)."""
    common = math.lcm(a[0], b[0])
    return bool(a[1] ** (common // a[0]) <= b[1] ** (common // b[0]))
