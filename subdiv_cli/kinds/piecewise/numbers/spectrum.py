"""The spectral radius ρ of one rational matrix: exactly where its characteristic polynomial says it simply."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from math import gcd
from typing import NamedTuple

from flint import ctx, fmpq_mat, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated, negated, roots
from subdiv_cli.exact.enclosures import bounds
from subdiv_cli.model import Root
from subdiv_cli.model.closed import exact_root

_PRECISION = 128
_PLACES = 40
"""The bits of rational bounds behind the leading one."""
_TRIED = 20
"""The most rationals that are tried as a radius in which zeros are counted."""


class ExactRadius(NamedTuple):
    """The number ρ^length = Λ, and a rational r < ρ.

    All eigenvalues lie in |z| < r, but those of factors of degree 1, or of degree 2 with roots of one modulus, that say
    |λ| = ρ by their coefficients; or, where Λ is not rational, one real root of each factor with the root Λ or -Λ.
    """

    length: int
    root: Root
    inner: Fraction


class Spectrum:
    """The eigenvalues of an N×N matrix that is not nilpotent, N > 0."""

    def __init__(self, matrix: fmpq_mat) -> None:
        self.roots = tuple((x, n) for x, n in roots(matrix.charpoly()) if x.rational != 0)
        """The eigenvalues that are not 0, with multiplicities, by falling modulus as balls see it."""
        results = matrix.charpoly().numer().factor()[1]
        self.factors = tuple((tuple(map(int, f)), n) for f, n in sorted(results, key=_by_degree) if f[0] != 0)
        """The irreducible factors of the characteristic polynomial but z, the constant coefficient first."""

    def compare(self, r: Fraction) -> int:
        """The sign of ρ - r, exactly."""
        return max(x.compare_modulus(r) for x, _ in self.roots)

    @cached_property
    def exact(self) -> ExactRadius | None:
        """The radius exactly; None where no eigenvalue of largest modulus is of a simple form."""
        leader = self.roots[0][0]
        square = _square(leader.minimal_polynomial)
        if square is not None:
            length, root = _rational(square)
            others = [x for x, _ in self.roots if _square(x.minimal_polynomial) != square]
        elif leader.is_real:
            length, root = 1, isolated(leader if leader.region.real > 0 else negated(leader))
            ends = [leader, negated(leader)]
            others = [x for x, _ in self.roots if not any(_same(x, end) for end in ends)]
        else:
            return None
        with ctx.workprec(_PRECISION):
            ceiling, _ = bounds(leader.modulus())
            floor = max((bounds(x.modulus())[1] for x in others), default=Fraction(0))
        counted = [] if square is not None else [f for f, _ in self.factors if leader.minimal_polynomial in _signs(f)]
        for inner in _between(floor, ceiling):
            if inner**length < root.low and all(_are_counted(f, inner) for f in counted):
                return ExactRadius(length, root, inner)
        return None

    @cached_property
    def enclosure(self) -> tuple[Fraction, Fraction]:
        """Rationals low < ρ < high of some twelve digits, 0 < low."""
        with ctx.workprec(_PRECISION):
            pairs = [bounds(x.modulus()) for x, _ in self.roots]
        low, high = max(low for low, _ in pairs), max(high for _, high in pairs)
        unit = Fraction(2) ** (low.numerator.bit_length() - low.denominator.bit_length() - _PLACES)
        return (low // unit - 1) * unit, (high // unit + 1) * unit


def _square(f: fmpz_poly) -> Fraction | None:
    """The number |λ|² of the roots of f if it is of degree 1, or of degree 2 with roots of one modulus; else None."""
    c = [int(x) for x in f]
    if len(c) == 2:
        return Fraction(c[0], c[1]) ** 2
    if len(c) == 3 and (c[1] == 0 or c[1] ** 2 < 4 * c[0] * c[2]):
        return Fraction(abs(c[0]), abs(c[2]))
    return None


def _rational(square: Fraction) -> tuple[int, Root]:
    """The pair (1, ρ), or (2, ρ²) where ρ is not rational."""
    u, v = exact_root(square.numerator, 2), exact_root(square.denominator, 2)
    x = square if u is None or v is None else Fraction(u, v)
    return (2 if x is square else 1), Root((-x.numerator, x.denominator), x, x)


def _same(x: AlgebraicNumber, y: AlgebraicNumber) -> bool:
    """Whether two real or complex roots are the same, by isolating regions of one polynomial."""
    return x.minimal_polynomial == y.minimal_polynomial and x.region.overlaps(y.region)


def _between(low: Fraction, high: Fraction) -> Iterator[Fraction]:
    """Rationals of few digits in (low, high), if there are any."""
    unit = Fraction(1)
    for _ in range(_TRIED if low < high else 0):
        while (x := (low // unit + 1) * unit) >= high:
            unit /= 2
        yield x
        unit /= 2


def _signs(f: Sequence[int]) -> tuple[fmpz_poly, fmpz_poly]:
    """The polynomials f(z) and ± f(-z), with a leading coefficient > 0 if f has one."""
    mirrored = [x * (-1) ** (len(f) - 1 - i) for i, x in enumerate(f)]
    return fmpz_poly(list(f)), fmpz_poly(mirrored)


def _are_counted(f: Sequence[int], r: Fraction) -> bool:
    """Whether the steps of Schur & Cohn count the zeros of f in |z| < r: its outer coefficients never are as large."""
    u, v, n = r.numerator, r.denominator, len(f) - 1
    g = [c * u**i * v ** (n - i) for i, c in enumerate(f)]
    while len(g) > 1:
        low, top = g[0], g[-1]
        if abs(low) == abs(top):
            return False
        if abs(low) < abs(top):
            g = [top * x - low * y for x, y in zip(g[1:], g[-2::-1], strict=True)]
        else:
            g = [low * x - top * y for x, y in zip(g, g[::-1], strict=True)]
            while len(g) > 1 and not g[-1]:
                g.pop()
        common = gcd(*g)
        g = [x // common for x in g]
    return True


def _by_degree(factor: tuple[fmpz_poly, int]) -> tuple[int, list[int]]:
    return factor[0].degree(), [int(c) for c in factor[0]]
