"""The numbers of a scheme of matrices, each computed once."""

from __future__ import annotations

from functools import cached_property

from flint import fmpq_mat

from subdiv_cli.exact.linalg import Vector, matrix
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.matrices.numbers.components import Relation, smallest_level
from subdiv_cli.kinds.matrices.numbers.curve import RefinedCurve, first_misfit, fixed_vector, on_grid
from subdiv_cli.kinds.matrices.numbers.patterns import Patterns, patterns
from subdiv_cli.kinds.matrices.scheme import MatrixFamily
from subdiv_cli.model import Effort

_FINER = 3
"""The levels beyond the coarsest one at which relations of points are looked for."""
_MOST_POINTS = 2000
"""The most points among which a relation is looked for."""


class MatrixNumbers:
    """The numbers of one scheme, under one effort; what no theorem needs is not computed."""

    def __init__(self, scheme: MatrixFamily, effort: Effort) -> None:
        self.scheme, self.effort = scheme, effort
        self.p, self.n = len(scheme.matrices), len(scheme.matrices[0])
        self.operators = tuple(matrix(rows).transpose() for rows in scheme.matrices)
        """The matrices B_i = A_i^T."""

    @property
    def is_stochastic(self) -> bool:
        """Whether no entry is negative; the rows sum to 1."""
        return all(x >= 0 for a in self.scheme.matrices for row in a for x in row)

    @cached_property
    def differences(self) -> tuple[fmpq_mat, ...]:
        """The B_i on e^⊥, in the basis e_j - e_(j+1): coordinates are the sums of the first entries."""
        n = self.n
        basis = fmpq_mat(n, n - 1, [(i == j) - (i == j + 1) for i in range(n) for j in range(n - 1)])
        sums = fmpq_mat(n - 1, n, [int(j <= i) for i in range(n - 1) for j in range(n)])
        return tuple(sums * b * basis for b in self.operators)

    @cached_property
    def decay(self) -> Radius | None:
        """The joint spectral radius on e^⊥."""
        return self._radius(self.differences)

    @cached_property
    def patterns(self) -> Patterns | None:
        """What sign patterns say of a stochastic family."""
        return patterns(self.scheme.matrices, self.effort)

    @cached_property
    def ends(self) -> tuple[Vector, Vector]:
        """The vectors f_0 and f_(p-1), where S converges."""
        return fixed_vector(self.operators[0]), fixed_vector(self.operators[-1])

    @cached_property
    def misfit(self) -> int | None:
        """The first joint where the pieces do not meet, where S converges; None where all do."""
        return first_misfit(self.operators, *self.ends)

    @cached_property
    def curve(self) -> RefinedCurve:
        """The curve, where S converges and the pieces meet."""
        return RefinedCurve(self.operators, *self.ends)

    @cached_property
    def relation(self) -> Relation | None:
        """A relation of points of the curve that shows that it has no polynomial component of a higher degree."""
        first = smallest_level(self.p, self.curve.span.dimension + 1)
        for level in range(first, first + _FINER):
            if self.p**level > _MOST_POINTS:
                break
            self.effort.look()
            if (relation := self.curve.components.excluding(self.points(level), level)) is not None:
                return relation
        return None

    def points(self, level: int) -> list[fmpq_mat]:
        """The points ψ(j p^-level) as columns."""
        return on_grid(self.operators, *self.ends, level)

    @property
    def is_whole(self) -> bool:
        """Whether V is all of e^⊥: the curve has n independent components and no polynomial but the constants."""
        return self.curve.span.dimension == self.n and not self.curve.components.degree

    @cached_property
    def radius(self) -> Radius | None:
        """The joint spectral radius on V ≠ 0."""
        space = self.curve.annihilated
        assert space is not None, "a polynomial has none"
        return self.decay if self.is_whole else self._radius(space.matrices)

    @cached_property
    def product(self) -> WordProduct | None:
        """The product that bounds the radius on V from below."""
        space = self.curve.annihilated
        if space is None or self.radius is None or self.radius.word is None:
            return None
        return WordProduct.of_word(self.differences if self.is_whole else space.matrices, self.radius.word)

    def _radius(self, family: tuple[fmpq_mat, ...]) -> Radius | None:
        from subdiv_cli.jsr.radius import joint_spectral_radius  # numpy comes with it

        return joint_spectral_radius(Family(family), self.effort)
