"""The numbers of a Hermite scheme: those of its mask of matrices, and those of its jets."""

from __future__ import annotations

from functools import cached_property
from math import factorial
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly

from subdiv_cli.exact.linalg import Vector
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.kinds.growth import SequenceGrowth, growth_on
from subdiv_cli.kinds.hermite.taylor import taylor_mask
from subdiv_cli.kinds.vector.numbers.vector import VectorNumbers


class JetSequences(NamedTuple):
    """The jets y_j = (f_j, f_j', …, f_j^(d-1)), j < k, with S y_j = p^-j y_j; there is none of degree k."""

    order: int
    """The number k of degrees."""
    shifts: Vector
    """The numbers φ_0 = 1, φ_1, …, φ_(k-1): f_j = Σ_l φ_l x^(j-l)/(j-l)!; the first one also where k = 0."""


class HermiteNumbers(VectorNumbers):
    """The numbers of one scheme, under one effort; what no theorem needs is not computed."""

    @cached_property
    def jets(self) -> JetSequences:
        """The jets that the spectral condition asks for, of every degree that has one.

        With E_j(a) = Σ_β A_(ε+pβ) y_j(a-β) - p^-j y_j(ε+pa) the derivative of E_j is E_(j-1), as that of f_j is
        f_(j-1): given the lower degrees, S y_j = p^-j y_j iff E_j(0) = 0 for all ε, to which φ_j adds
        (1 - p^-j) φ_j e_0. So all φ are unique. It ends: y_j on a window is an eigenvector for p^-j of one matrix.
        """
        shifts = [fmpq(1)]
        if any(map(any, self._residuals(shifts, 0))):
            return JetSequences(0, (to_fraction(shifts[0]),))
        while True:
            j = len(shifts)
            first, *others = self._residuals(shifts, j)
            if any(first[1:]) or any(row != first for row in others):
                return JetSequences(j, tuple(map(to_fraction, shifts)))
            shifts.append(-first[0] / (1 - fmpq(1, self.p**j)))

    def _residuals(self, shifts: list[fmpq], j: int) -> list[list[fmpq]]:
        """The E_j(0) for each ε, φ_j = 0 where it is not among the shifts."""
        p, jet = self.p, [_polynomial(shifts, j - i) for i in range(self.size)]
        residuals = [_values(jet, epsilon) * fmpq(-1, p**j) for epsilon in range(p)]
        for i, a in enumerate(self.matrices, self.scheme.start):
            beta, epsilon = divmod(i, p)
            residuals[epsilon] += a * _values(jet, -beta)
        return [column.entries() for column in residuals]

    @cached_property
    def is_function(self) -> bool:
        """Whether E_A is spanned by e_0: limits of the scheme of vectors are functions f e_0."""
        return len(self.constants) == 1 and not any(self.constants[0][1:])

    @cached_property
    def has_function(self) -> bool:
        """Whether the function component is as smooth as all limits: E_A is a line that is not orthogonal to e_0."""
        return len(self.constants) == 1 and self.constants[0][0] != 0

    def jet_growth(self, j: int) -> SequenceGrowth | None:
        """The growth on the space U_j of theorem 5 of spaces/stencils.py; `order` is j. None where it is unknown."""
        if j not in self._jet_growths:
            self._jet_growths[j] = growth_on(j, self.spaces.jet(j), self.effort) if self.is_small else None
        return self._jet_growths[j]

    @cached_property
    def taylor(self) -> dict[int, fmpq_mat] | None:
        """The Taylor mask; None where there is none."""
        return taylor_mask(self.p, dict(enumerate(self.matrices, self.scheme.start)))

    @cached_property
    def _jet_growths(self) -> dict[int, SequenceGrowth | None]:
        return {}


def _polynomial(shifts: list[fmpq], j: int) -> fmpq_poly:
    """The polynomial f_j, without the φ that are not among the shifts; 0 where j is negative: f_j' is f_(j-1)."""
    return fmpq_poly([shifts[j - n] / factorial(n) if j - n < len(shifts) else fmpq(0) for n in range(j + 1)])


def _values(jet: list[fmpq_poly], x: int) -> fmpq_mat:
    """The column of the values at an integer."""
    return fmpq_mat([[f(x)] for f in jet])
