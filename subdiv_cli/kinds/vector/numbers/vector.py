"""The numbers of a vector scheme, each computed once."""

from __future__ import annotations

from functools import cached_property

from flint import fmpq_mat, fmpq_poly

from subdiv_cli.exact.linalg import Vector, matrix, rows_of
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.growth import SequenceGrowth, first_above, growth_on
from subdiv_cli.kinds.vector.numbers.derived import Derivation, derivation
from subdiv_cli.kinds.vector.numbers.eigen_sequences import EigenSequences, eigen_sequences
from subdiv_cli.kinds.vector.scheme import VectorScheme
from subdiv_cli.model import Effort
from subdiv_cli.spaces.lattice import Index, Lattice
from subdiv_cli.spaces.stencils import StencilSpaces, VectorSequence
from subdiv_cli.spaces.transition import TransitionOperators

LARGEST_WINDOW = 400
"""The most coordinates of a window: components times indices."""
_LONGEST = 2
"""The length of the products that tell whether the exponent is below k."""


class VectorNumbers:
    """The numbers of one scheme, under one effort; what no theorem needs is not computed.

    The operators are those of the mask moved so that its support begins at 0, whose limits are translates.
    """

    def __init__(self, scheme: VectorScheme, effort: Effort) -> None:
        self.scheme, self.effort = scheme, effort
        self.matrices = tuple(matrix(rows) for rows in scheme.coefficients)
        terms: dict[Index, fmpq_mat] = {(i,): a for i, a in enumerate(self.matrices)}
        self.operators = TransitionOperators(Lattice(((scheme.arity,),)), terms)
        self.spaces = StencilSpaces(self.operators, effort.look)

    @property
    def p(self) -> int:
        """The arity."""
        return self.scheme.arity

    @property
    def size(self) -> int:
        """The number m of components."""
        return self.scheme.size

    @cached_property
    def constants(self) -> tuple[Vector, ...]:
        """A basis of E_A = {u : A^ε u = u for every ε}, r vectors of m entries."""
        constants = self.spaces.constants
        return () if constants is None else rows_of(constants)

    @cached_property
    def mean(self) -> fmpq_mat:
        """The m×m matrix M_A = (1/p) Σ A_i, the mean of the A^ε."""
        return sum(self.matrices[1:], self.matrices[0]) / self.p

    @cached_property
    def mean_cofactor(self) -> fmpq_poly | None:
        """The polynomial g with det(x - M_A) = (x-1)^r g; None where 1 is a zero of g."""
        g = self.mean.charpoly()
        for _ in self.constants:
            g = divmod(g, fmpq_poly([-1, 1]))[0]
        return None if g(1) == 0 else g

    @cached_property
    def sequences(self) -> EigenSequences | None:
        """The polynomial eigen-sequences; None where E_A = 0."""
        if not self.constants:
            return None
        return eigen_sequences(self.p, self.scheme.start, self.matrices, self.constants)

    @cached_property
    def is_small(self) -> bool:
        """Whether the window W has few enough coordinates for this effort."""
        window = self.operators.window
        return window is not None and self.size * len(window) <= min(LARGEST_WINDOW, self.effort.work)

    @cached_property
    def fixed(self) -> tuple[VectorSequence, ...] | None:
        """A basis of the kernel of T_0 - 1 on finitely supported sequences; None where the window is too large."""
        return self.spaces.fixed if self.is_small else None

    @cached_property
    def stencils(self) -> tuple[VectorSequence, ...] | None:
        """The limit stencils, dual to the basis of E_A, where the scheme converges; None without them."""
        return self.spaces.stencils if self.is_small else None

    @cached_property
    def decay(self) -> SequenceGrowth | None:
        """The growth on the sequences that die out if the scheme converges: it does iff the radius is below 1."""
        return growth_on(0, self.spaces.decay, self.effort) if self.is_small and self.constants else None

    @cached_property
    def growth(self) -> SequenceGrowth | None:
        """The growth on V_k(w) of a scheme that converges, with k above the Hölder exponent; None where it is unknown.

        No k above the number of coordinates of the window is tried, as 1, p^-1, …, p^-n are eigenvalues of T_0 where
        all limits are C^n.
        """
        window = self.operators.window
        if window is None or self.sequences is None or self.stencils is None:
            return None
        orders = range(max(1, self.sequences.order), self.size * len(window) + 2)
        above = first_above(self.spaces, orders, _LONGEST)
        return None if above is None else growth_on(*above[:2], self.effort)

    def growth_of(self, k: int) -> SequenceGrowth | None:
        """The growth on V_k(w) for this k."""
        return growth_on(k, self.spaces.differences(k), self.effort)

    def bounded(self, growth: SequenceGrowth) -> Radius | None:
        """The radius of a growth, where its products are proved to be bounded by its powers; None elsewhere."""
        from subdiv_cli.jsr.irreducible import closed_radius  # numpy comes with it

        if growth.radius.bounded:
            return growth.radius
        return closed_radius(Family(growth.on.space.matrices), self.effort)

    def derivation(self, most: int) -> Derivation:
        """The derived schemes of Moosmüller & Dyn, at most so many, and the norms by which they contract."""
        return derivation(self.p, dict(enumerate(self.matrices, self.scheme.start)), most, self.effort)
