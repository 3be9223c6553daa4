"""Box splines, recognised by their mask and decided by their directions. See FORMAT.md.

Sources: de Boor, Höllig & Riemenschneider, Box Splines (1993); Dahmen & Micchelli 1983.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations
from math import comb
from operator import mul

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.multivariate.lattice import (
    MAX_POWER,
    Index,
    Sparse,
    determinant,
    factor_of,
    geometric,
    multiply,
)
from subdiv_cli.checker.multivariate.masks import mask_of
from subdiv_cli.checker.reading import require

_MINOR = 24
"""The products in a determinant of order 4."""


def box_spline(c: Claim) -> None:
    """φ is the box spline of the directions ξ_1, …, ξ_n, up to a shift.

    M^r = cI and Π_(i<r) a(z^(M^i)) = c^(s-n) z^t Π_j (1 + z^ξ_j + … + z^((c-1)ξ_j)): the transform of φ is the product
    over l >= 1 of the left side, over m^r, at c^-l ω, and that of the box spline is the one of the right side, t = 0.
    The sum of a must be m as well: for even r the identity does not see the sign of a.
    """
    a, directions, scale = mask_of(c), c.statement["directions"], c.statement["scale"]
    shift, s, n = c.witness["shift"], a.dilation.dimension, len(directions)
    _require_directions(directions, s)
    require(len(shift) == s, f"the shift is not one of Z^{s}")
    c.count(n * scale, n * scale.bit_length())
    require(breadth(c, directions) > 0, "the directions do not span the space")
    require(a.sum_is_m(), "the coefficients do not add up to m")
    left, right = _orbit(c, scale), [{shift: 1}, *(geometric(x, scale) for x in directions)]
    bits = len(left) * (a.bits + 2 * len(a.terms).bit_length()) + n * scale.bit_length()
    done, f = _multiplied(c, left, 0, bits)
    _, g = _multiplied(c, right, done, bits)
    above, below = scale ** (n - s), a.denominator ** len(left)
    same = f.keys() == g.keys() and all(above * value == below * g[at] for at, value in f.items())
    require(same, "the mask is not that of the box spline")


def _require_directions(directions: tuple[Index, ...], s: int) -> None:
    require(len(directions) >= s, "there are not enough directions")
    require(all(len(x) == s and any(x) for x in directions), f"a direction is zero or not one of Z^{s}")
    require(list(directions) == sorted(directions), "the directions are not sorted")


def _orbit(c: Claim, scale: int) -> list[Sparse]:
    """The symbols a(z), a(z^M), …, a(z^(M^(r-1))), for M^r = cI."""
    a, r = mask_of(c), c.witness["power"]
    require(1 <= r <= MAX_POWER, f"the power is not one of 1, …, {MAX_POWER}")
    c.spend(r * (len(a.terms) + 64), 0)
    m, factors = a.dilation.rows, [a.terms]
    for _ in range(r - 1):
        factors.append({tuple(matrices.apply(a.dilation.rows, x)): value for x, value in factors[-1].items()})
        m = matrices.multiply(a.dilation.rows, m)
    require(factor_of(m) == scale > 1, "the power of the dilation is not the multiple of the identity")
    return factors


def _multiplied(c: Claim, factors: list[Sparse], done: int, bits: int) -> tuple[int, Sparse]:
    """The product of all factors, and how many products of two terms there are then with those that are done."""
    product = factors[0]
    for factor in factors[1:]:
        done += len(product) * len(factor)
        c.count(done, bits)
        product = multiply(product, factor)
    return done, product


def smooth(c: Claim) -> None:
    """φ is C^(d-2)."""
    d = _breadth(c)
    require(c.statement["order"] <= d - 2, f"φ is not so smooth: d = {d}")


def not_smooth(c: Claim) -> None:
    """φ is not C^(d-1)."""
    d = _breadth(c)
    require(c.statement["order"] >= d - 1, f"φ is smoother: d = {d}")


def holder(c: Claim) -> None:
    """α = d - 1, d >= 1: derivatives of order d - 2 are Lipschitz, those of order d - 1 are bounded and have jumps."""
    d = _breadth(c)
    require(c.statement["value"] == d - 1 >= 0, f"d = {d}")


def sobolev(c: Claim) -> None:
    """The Sobolev exponent is d - 1/2: derivatives of order d - 1 are piecewise polynomials, of which some jump."""
    d = _breadth(c)
    require(c.statement["value"] == d - Fraction(1, 2), f"d = {d}")


def stable(c: Claim) -> None:
    """The translates are stable, and linearly independent, iff all determinants are -1, 0 or 1."""
    directions = c.use("box-spline").statement["directions"]
    holds = is_unimodular(c, directions)
    require(holds == c.statement["holds"], "the directions are " + ("unimodular" if holds else "not unimodular"))


def _breadth(c: Claim) -> int:
    return breadth(c, c.use("box-spline").statement["directions"])


def breadth(c: Claim, directions: Sequence[Index]) -> int:
    """The least number d of directions whose removal leaves a set that does not span R^s; 0 if they do not span it.

    That is how many there are less the largest number in a hyperplane through 0. If they span R^s, a hyperplane with
    the largest number is spanned by s - 1 of them: otherwise another direction could be added to those in it.
    """
    s, n = len(directions[0]), len(directions)
    lines = sorted({max(x, tuple(-t for t in x)) for x in directions})
    subsets = comb(len(lines), s - 1)
    c.count(subsets * (s * _MINOR + s * n))
    normals = {_normal(subset) for subset in combinations(lines, s - 1)}
    return min((sum(1 for x in directions if sum(map(mul, normal, x))) for normal in normals if any(normal)), default=0)


def _normal(rows: Sequence[Index]) -> Index:
    """A vector perpendicular to s - 1 vectors; zero iff they are dependent."""
    s = len(rows) + 1
    return tuple((-1) ** i * determinant([[*row[:i], *row[i + 1 :]] for row in rows]) for i in range(s))


def is_unimodular(c: Claim, directions: Sequence[Index]) -> bool:
    """Whether every determinant of s of the directions is -1, 0 or 1: those of repeated ones are 0."""
    s = len(directions[0])
    different = sorted(set(directions))
    c.count(comb(len(different), s) * s * _MINOR)
    return all(abs(determinant(subset)) <= 1 for subset in combinations(different, s))
