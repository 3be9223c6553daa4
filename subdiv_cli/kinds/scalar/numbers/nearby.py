"""A mask with exact sum rules near one whose decimals are those of an irrational filter, cut or rounded."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from math import isqrt, lcm
from operator import mul
from typing import NamedTuple

from subdiv_cli.exact.laurent import Laurent, smoothing_factor
from subdiv_cli.exact.linalg import Vector, matrix, rows_of
from subdiv_cli.exact.text import decimal
from subdiv_cli.kinds.scalar.scheme import ScalarScheme

_FEWEST_PLACES = 4
"""The fewest decimals that tell something: to three, masks with more sum rules lie near most masks."""
_MOST_PLACES = 40
_MOST_COEFFICIENTS = 200
_MOST_RULES = 40
_MOST_GUARDS = 5
"""The most decimals, and one, that the cofactor has more than the mask."""
_UNITS = 2
"""How far, in units of the last place, a coefficient may be from the one that is given; half a unit is rounding."""
_DOUBLE = Fraction(1, 10**15)
"""How far off a double near 1 may be, after a few operations."""
_NEAR = Fraction(1, 1000)
"""The distance of residue sums from those of a known normalisation that decimals explain."""


class Nearby(NamedTuple):
    """A symbol (1 + … + z^(p-1))^k q(z) z^start with a(1) = p, near the mask that was given."""

    rules: int
    """The number k of sum rules."""
    exact: int
    """The number of those that the given mask has exactly, before it is scaled by an irrational number."""
    scale: str | None
    """The number by which that is multiplied first, `√2` or `2`; None for 1."""
    distance: Fraction
    """The largest change of a coefficient, after that."""
    symbol: str
    """The symbol, as `--mask` and files take it."""


def nearby(scheme: ScalarScheme) -> Nearby | None:
    """The mask of most sum rules that its decimals leave room for; None where that has no more than the mask itself.

    Every coefficient counts with as many decimals as the longest has; if nothing is near then, with its own.
    """
    own = _places(scheme.coefficients)
    scale, name = _normalisation(scheme)
    if not own or max(own) < _FEWEST_PLACES or not scale:
        return None
    given = tuple(scale * c for c in scheme.coefficients)
    order = 0 if name is not None and "√" in name else _order(scheme)
    for places in dict.fromkeys(((max(own),) * len(own), own)):
        units = [scale / 10**d + _DOUBLE for d in places]
        k, nearest = _of_most_rules(given, scheme.arity, order, units)
        for digits in range(max(own), max(own) + _MOST_GUARDS) if k > order else ():
            cofactor = _rounded(nearest, scheme.arity, k, digits)
            mask = (_factor(scheme.arity, k) * Laurent.from_coefficients(0, cofactor)).coefficients()
            if len(mask) == len(given) and all(
                abs(x - y) <= _UNITS * unit for x, y, unit in zip(mask, given, units, strict=True)
            ):
                distance = max(abs(x - y) for x, y in zip(mask, given, strict=True))
                return Nearby(k, order, name, distance, _spelled(scheme, k, cofactor, digits))
    return None


def _of_most_rules(
    given: Sequence[Fraction], p: int, order: int, units: Sequence[Fraction]
) -> tuple[int, Sequence[Fraction]]:
    """The number k of sum rules and the nearest mask with them, from `order` on as long as that is near enough.

    A mask whose decimals were cut lies within √n units of the last place of the one that is meant, and so does the
    nearest, each difference counted in the unit of its coefficient.
    """
    k, nearest = order, given
    while k < _MOST_RULES and (projection := _projected(given, p, k + 1, units)) is not None:
        off = ((x - y) / unit for x, y, unit in zip(projection, given, units, strict=True))
        if sum((x * x for x in off), Fraction(0)) > len(given):
            break
        k, nearest = k + 1, projection
    return k, nearest


def _places(coefficients: Sequence[Fraction]) -> tuple[int, ...]:
    """The numbers of decimals of the coefficients; none where there are too many for that, or fractions.

    One with less than half as many as the longest is exact: 0, 1, 0.5. It has as many as the longest.
    """
    common = lcm(*(c.denominator for c in coefficients))
    most = next((d for d in range(_MOST_PLACES + 1) if 10**d % common == 0), None)
    if most is None or len(coefficients) > _MOST_COEFFICIENTS:
        return ()
    own = (next(d for d in range(most + 1) if 10**d % c.denominator == 0) for c in coefficients)
    return tuple(d if 2 * d >= most else most for d in own)


def _normalisation(scheme: ScalarScheme) -> tuple[Fraction, str | None]:
    """The number that makes the residue sums nearly 1, and its name if it is not 1; zero where none does."""
    p = scheme.arity
    sums = [sum(scheme.coefficients[r::p], Fraction(0)) for r in range(p)]
    root = Fraction(isqrt(p * 10 ** (2 * _MOST_PLACES)), 10**_MOST_PLACES)
    for scale, name in ((Fraction(1), None), (root, f"√{p}"), (Fraction(p), str(p))):
        if all(abs(scale * s - 1) < _NEAR for s in sums):
            return scale, name
    return Fraction(0), None


def _order(scheme: ScalarScheme) -> int:
    """The number of sum rules that hold exactly."""
    a, factor, k = Laurent.from_coefficients(0, scheme.coefficients), smoothing_factor(scheme.arity), 0
    while k <= _MOST_RULES:
        a, remainder = a.divide(factor)
        if remainder.degree >= 0:
            break
        k += 1
    return k


def _projected(a: Sequence[Fraction], p: int, k: int, units: Sequence[Fraction]) -> Vector | None:
    """The nearest mask to a with k sum rules and a(1) = p; None where so many rules leave no room.

    The rules are that Σ_i i^j a_i, j < k, is the same over each residue class. With M the matrix of these conditions, t
    their right sides and U the diagonal matrix of the units it is a - U²Mᵀ(M U²Mᵀ)⁻¹(M a - t).
    """
    n = len(a)
    if (p - 1) * k >= n:
        return None
    powers = [[(i - n // 2) ** j for i in range(n)] for j in range(k)]
    rows = [[((i % p == r) - (i % p == 0)) * x[i] for i in range(n)] for x in powers for r in range(1, p)]
    rows.append([1] * n)
    conditions, given = matrix(rows), matrix([[x] for x in a])
    weights = [(unit / units[0]) ** 2 for unit in units]
    weighted = matrix([[weights[i] * row[i] for row in rows] for i in range(n)])
    wanted = matrix([[0]] * (len(rows) - 1) + [[p]])
    changes = weighted * (conditions * weighted).solve(conditions * given - wanted)
    return tuple(x for (x,) in rows_of(given - changes))


def _factor(p: int, k: int) -> Laurent:
    """The polynomial (1 + … + z^(p-1))^k/p^(k-1), whose value at 1 is p."""
    return reduce(mul, [smoothing_factor(p)] * k).scale(Fraction(1, p ** (k - 1)))


def _rounded(mask: Sequence[Fraction], p: int, k: int, digits: int) -> list[Fraction]:
    """The cofactor of a mask by its sum rules, rounded to decimals; its middle, one or two, makes the sum 1."""
    quotient, _ = Laurent.from_coefficients(0, mask).divide(_factor(p, k))
    rounded = [Fraction(round(c * 10**digits), 10**digits) for c in quotient.coefficients()]
    middle = {(len(rounded) - 1) // 2, len(rounded) // 2}
    missing = 1 - sum(rounded, Fraction(0))
    for i in middle:
        rounded[i] += missing / len(middle)
    return rounded


def _spelled(scheme: ScalarScheme, k: int, cofactor: Sequence[Fraction], digits: int) -> str:
    """The symbol as `--mask` and files take it."""
    p = scheme.arity
    terms = ""
    for i, c in enumerate(cofactor):
        if c:
            sign = (" - " if c < 0 else " + ") if terms else "-" if c < 0 else ""
            number = decimal(abs(c), digits + 1).rstrip("0").rstrip(".")
            terms += sign + number + ("" if i == 0 else "*z" if i == 1 else f"*z^{i}")
    shift = f"z^{scheme.start} * " if scheme.start else ""
    factor = " + ".join(["1", "z", *(f"z^{i}" for i in range(2, p))][:p])
    power = "" if k == 1 else f"^{k}"
    return f"{shift}({factor}){power} * ({terms})" + (f" / {p ** (k - 1)}" if k > 1 else "")
