"""The numbers of a piecewise scheme, each computed once."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from subdiv_cli.exact.linalg import Vector, rows_of
from subdiv_cli.kinds.piecewise.numbers.functionals import (
    Cells,
    Functionals,
    RowSpace,
    attractor,
    cells_of,
    stencil,
    window_of,
)
from subdiv_cli.kinds.piecewise.numbers.polynomials import Polynomial, eigen_polynomials, sequences
from subdiv_cli.kinds.piecewise.numbers.sides import DecayRate, Side, rational_rate
from subdiv_cli.kinds.piecewise.numbers.spectrum import Spectrum
from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
from subdiv_cli.model import Effort


class FunctionalGrowth(NamedTuple):
    """The space 𝓕_k, its recurrent part, and the eigenvalues of A on it."""

    order: int
    """The order k, 0 for all rows that sum to 0."""
    dimension: int
    spectrum: Spectrum | None
    """The eigenvalues; None where the recurrent part is 0."""

    def is_below(self, x: Fraction) -> bool:
        """Whether the spectral radius is below x > 0."""
        return self.spectrum is None or self.spectrum.compare(x) < 0

    @property
    def radius(self) -> DecayRate | None:
        """The spectral radius, where it is known exactly and not 0."""
        exact = None if self.spectrum is None else self.spectrum.exact
        return (
            None if exact is None else DecayRate(exact.length, exact.root.low, exact.root.high, exact.root.coefficients)
        )

    @property
    def upper(self) -> DecayRate:
        """The spectral radius, or a bound of it from above."""
        if self.spectrum is None:
            return rational_rate(Fraction(0))
        return self.radius or rational_rate(self.spectrum.enclosure[1])

    def below(self, p: int) -> DecayRate:
        """What bounds the exponent at 0 from below: the radius, and k where it has eigenvalues."""
        least = rational_rate(Fraction(1, p**self.order))
        return least if self.spectrum is not None and self.upper.at_most(least.low, 1) else self.upper

    def above(self, p: int) -> DecayRate | None:
        """What bounds the exponent at 0 from above: the radius, if it is above p^-k; None where it is not."""
        if self.spectrum is None:
            return None
        lower = self.radius or rational_rate(self.spectrum.enclosure[0])
        return lower if lower.low * p ** (self.order * lower.length) > 1 else None


class PiecewiseNumbers:
    """The numbers of one scheme, under one effort; what no theorem needs is not computed."""

    def __init__(self, scheme: PiecewiseScheme, effort: Effort) -> None:
        self.scheme, self.effort = scheme, effort
        self.cells: tuple[Cells, Cells] = cells_of(scheme)

    @property
    def p(self) -> int:
        """The arity."""
        return self.scheme.arity

    @cached_property
    def left(self) -> Side:
        """The left mask."""
        return Side(self.scheme.left, self.effort.limited(self.effort.work, 0.4))

    @cached_property
    def right(self) -> Side:
        """The right mask; the same object where it is the left one."""
        if self.scheme.right == self.scheme.left:
            return self.left
        return Side(self.scheme.right, self.effort.limited(self.effort.work, 0.6))

    @property
    def sides(self) -> tuple[tuple[str, Side], tuple[str, Side]]:
        """Both sides by their names."""
        return ("left", self.left), ("right", self.right)

    @cached_property
    def window(self) -> range | None:
        """The window W; None where it is too large for this effort."""
        window = window_of(self.scheme, self.cells)
        return window if window is not None and self.effort.allows(len(window) ** 2) else None

    @cached_property
    def functionals(self) -> Functionals | None:
        """The spaces of functionals; None without a window."""
        if self.window is None:
            return None
        return Functionals(self.scheme, self.cells, self.window, self.effort.look)

    @cached_property
    def stencils(self) -> tuple[Vector, Vector]:
        """The limit stencils of both masks, which converge: the weights of the data from `low` of their cells on."""
        left, right = (stencil(cells) for cells in self.cells)
        assert left is not None, "a mask that converges has one"
        assert right is not None, "a mask that converges has one"
        return rows_of(left)[0], rows_of(right)[0]

    @cached_property
    def closed_set(self) -> tuple[int, ...]:
        """The closed set that determines the limits; needs a window."""
        assert self.window is not None
        return attractor(self.scheme, self.window)

    @cached_property
    def wrong_row(self) -> tuple[int, Fraction] | None:
        """A special row that does not sum to 1, with its sum; None without one."""
        sums = ((i, sum((weight for _, weight in row), Fraction(0))) for i, row in self.scheme.special)
        return next(((i, total) for i, total in sums if total != 1), None)

    @cached_property
    def local(self) -> Spectrum | None:
        """The eigenvalues of A but 0; None where A is nilpotent. Needs a window."""
        assert self.functionals is not None
        return _spectrum(self.functionals.all_rows)

    @cached_property
    def decay(self) -> FunctionalGrowth | None:
        """What A does to rows that sum to 0, where all rows of S sum to 1; None without a window."""
        if self.functionals is None:
            return None
        space = self.functionals.differences
        return FunctionalGrowth(0, space.dimension, _spectrum(space))

    @cached_property
    def growth(self) -> FunctionalGrowth:
        """What A does to 𝓕_k, where S converges, with k above the exponent at 0 or no eigenvalue left but 0.

        k starts from the order of the sums that both masks have in common, and ends with the number of points: a larger
        exponent at 0 is only bounded from below.
        """
        assert self.functionals is not None
        first = max(1, min(map(len, self.polynomials)))
        for k in range(first, max(first + 1, len(self.functionals.window))):
            growth = self.growth_of(k)
            if growth.spectrum is None or growth.above(self.p) is not None:
                break
        return growth

    def growth_of(self, k: int) -> FunctionalGrowth:
        """What A does to 𝓕_k, where S converges."""
        assert self.functionals is not None
        space = self.functionals.annihilating(k)
        return FunctionalGrowth(k, space.dimension, _spectrum(space))

    @cached_property
    def polynomials(self) -> tuple[tuple[Polynomial, ...], tuple[Polynomial, ...]]:
        """The eigen-polynomials of both masks."""
        left, right = self.cells
        return eigen_polynomials(left.mask, left.spacing), eigen_polynomials(right.mask, right.spacing)

    @cached_property
    def sequences(self) -> tuple[tuple[Fraction, ...], ...]:
        """The values on the window of the sequences q_0, q_1, … with S q_d = p^-d q_d; needs a window."""
        assert self.functionals is not None
        return sequences(self.functionals)


def _spectrum(space: RowSpace) -> Spectrum | None:
    return Spectrum(space.matrix) if space.dimension else None
