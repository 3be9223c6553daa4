"""Facts of a scalar mask, seen without a theorem: support, symmetry, interpolation, signs, gaps.

What the person who pasted a mask may have meant: hints, never verdicts.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import gcd

from subdiv_cli.exact.text import truncated
from subdiv_cli.kinds.scalar.numbers.nearby import nearby
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Data


def facts(scheme: ScalarScheme) -> dict[str, Data]:
    """The facts of a mask by name: arity, support, coefficients, symmetry, centre, type and so on.

    `support` is the first and the last index, `coefficients` their number; the others are interpolatory, nonnegative,
    gaps (indices of zero coefficients inside the support) and spacing (the gcd of index differences).
    """
    symmetry, centre = _symmetry(scheme)
    indices = [scheme.start + i for i, c in enumerate(scheme.coefficients) if c]
    inside = range(scheme.start, scheme.start + len(scheme.coefficients))
    return {
        "arity": scheme.arity,
        "support": (inside[0], inside[-1]),
        "coefficients": len(indices),
        "symmetry": symmetry,
        "centre": centre,
        "type": None if centre is None else "primal" if centre.denominator == 1 else "dual",
        "interpolatory": interpolation_shift(scheme) == 0,
        "nonnegative": all(c >= 0 for c in scheme.coefficients),
        "gaps": tuple(sorted(set(inside) - set(indices))),
        "spacing": gcd(*(i - indices[0] for i in indices)),
    }


def _symmetry(scheme: ScalarScheme) -> tuple[str | None, Fraction | None]:
    """The symmetry, `symmetric` or `antisymmetric`, and the centre, an integer or a half; None twice without any."""
    c = scheme.coefficients
    centre = Fraction(2 * scheme.start + scheme.degree, 2)
    if c == c[::-1]:
        return "symmetric", centre
    if c == tuple(-x for x in c[::-1]):
        return "antisymmetric", centre
    return None, None


def interpolation_shift(scheme: ScalarScheme) -> int | None:
    """The shift t with a_(t+pβ) = δ_(β,0): 0 for an interpolatory scheme, another for a shifted one; else None.

    Of several the one nearest to 0.
    """
    ones = [scheme.start + i for i, c in enumerate(scheme.coefficients) if c == 1]
    shifts = [t for t in ones if _alone_in_class(scheme, t)]
    return min(shifts, key=lambda t: (abs(t), t), default=None)


def _alone_in_class(scheme: ScalarScheme, index: int) -> bool:
    first = (index - scheme.start) % scheme.arity
    return sum(1 for c in scheme.coefficients[first :: scheme.arity] if c) == 1


_ROUNDED = Fraction(1, 2)
"""The share of the last decimal by which a rounded fraction is off at most."""
_DOUBLE = Fraction(1, 10**15)
"""How far off a double near 1 may be."""
_NEAR = Fraction(1, 1000)
"""Residue sums off by less than this come from cut decimals or from a root of the arity."""


def hints(scheme: ScalarScheme) -> tuple[str, ...]:
    """The sentences on what looks like a slip in a mask; none where nothing does."""
    decimals = tuple(_cut_decimals(scheme)) or tuple(_irrational(scheme))
    return (
        *_arity(scheme),
        *(() if decimals else _normalisation(scheme)),
        *decimals,
        *_shifted_interpolation(scheme),
    )


def _sums(scheme: ScalarScheme, coefficients: tuple[Fraction, ...]) -> list[Fraction]:
    return [sum(coefficients[r :: scheme.arity], Fraction(0)) for r in range(scheme.arity)]


def _arity(scheme: ScalarScheme) -> Iterator[str]:
    """A hint for a ternary mask without `arity = 3`: its classes mod 3 sum to 1."""
    if _sums(scheme, scheme.coefficients) == [1] * scheme.arity:
        return
    for p in range(2, 7):
        if p != scheme.arity and all(sum(scheme.coefficients[r::p], Fraction(0)) == 1 for r in range(p)):
            yield f"arity = {p} under [mask]? The residue classes mod {p} sum to 1, those mod {scheme.arity} do not."
            return


def _normalisation(scheme: ScalarScheme) -> Iterator[str]:
    """A hint for filters normalised to a(1) = 1 or to a(1) = √p, as they often are."""
    p, sums = scheme.arity, _sums(scheme, scheme.coefficients)
    common = sums[0]
    if common > 0 and all(abs(s * s * p - 1) < _NEAR for s in sums):
        yield f"normalised to a(1) = √{p}? Multiply by √{p} and write exact fractions: only rational masks are checked."
    elif common != 0 and sums == [common] * p and abs(common - 1) > _NEAR:
        yield f"normalised to a(1) = {p * common}? Multiply the mask by {1 / common}."


def _cut_decimals(scheme: ScalarScheme) -> Iterator[str]:
    """A hint for 0.333333 in place of 1/3: the sums miss 1 by little, and simple fractions nearby have right sums."""
    sums = _sums(scheme, scheme.coefficients)
    if any(abs(s - 1) > _NEAR for s in sums):
        return
    if all(s == 1 for s in sums):
        yield from _cut_decimals_with_right_sums(scheme)
        return
    for largest in (12, 64, 1024):
        simple = tuple(c.limit_denominator(largest) for c in scheme.coefficients)
        pairs = [(c, q) for c, q in zip(scheme.coefficients, simple, strict=True) if c != q]
        if _sums(scheme, simple) == [1] * scheme.arity and all(_is_spelled(c, q) for c, q in pairs):
            meant = ", ".join(f'{_decimal(c)} for "{q}"' for c, q in dict(pairs).items())
            yield f"cut decimals? {meant} would give residue sums of exactly 1."
            return


def _irrational(scheme: ScalarScheme) -> Iterator[str]:
    """A hint for the decimals of an irrational filter: a mask so near that these are its digits too, with sum rules."""
    near = nearby(scheme)
    if near is None:
        return
    rules = "1 sum rule holds" if near.rules == 1 else f"{near.rules} sum rules hold"
    times = "" if near.scale is None else f" times {near.scale}"
    yield (
        f"decimals of an irrational filter? {rules} to the digits given, {near.exact or 'none'} exactly. All hold for "
        f"a mask near this one{times}, whose coefficients differ by {truncated(near.distance, 3)} at most; its "
        f'exponents are those of the filter to some digits only: symbol = "{near.symbol}"'
    )


def _cut_decimals_with_right_sums(scheme: ScalarScheme) -> Iterator[str]:
    """A hint for decimals that are cut but sum to 1: four places or more, or three if rounded.

    0.333333 and 0.666667 make up 1, yet are hardly meant.
    """
    for c in scheme.coefficients:
        places, simple = _places(c), c.limit_denominator(12)
        if places is None or places < 3 or c == simple:
            continue
        off = abs(c - simple) * 10**places
        if off < 1 and (places > 3 or off <= _ROUNDED):
            yield f'cut decimals? {_decimal(c)} is close to "{simple}"; every number is taken as it is written.'
            return


def _is_spelled(decimal: Fraction, meant: Fraction) -> bool:
    """Whether a decimal is the other number rounded, or cut, to its places; doubles are off by a little more."""
    places = _places(decimal)
    return places is not None and abs(decimal - meant) < Fraction(1, 10**places) + _DOUBLE


def _places(x: Fraction) -> int | None:
    """The number of decimals that spell x; None where seventeen do not."""
    return next((places for places in range(18) if 10**places % x.denominator == 0), None)


def _decimal(x: Fraction) -> str:
    """A decimal that spells x, or x itself."""
    places = _places(x)
    return str(x) if places is None else f"{float(x):.{places}f}"


def _shifted_interpolation(scheme: ScalarScheme) -> Iterator[str]:
    shift = interpolation_shift(scheme)
    if shift:
        yield f"interpolatory with start = {scheme.start - shift}; with this start points are kept under other indices."
