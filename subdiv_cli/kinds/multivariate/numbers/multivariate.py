"""The numbers of a scheme in several variables, each computed once."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from math import floor, isfinite, log2, prod

from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.kind import Part
from subdiv_cli.kinds.multivariate.numbers.box_spline import BoxSpline, box_spline
from subdiv_cli.kinds.multivariate.numbers.difference_space import DifferenceSpace, difference_space
from subdiv_cli.kinds.multivariate.numbers.directional import (
    Contraction,
    PairContraction,
    contractions,
    pair_contractions,
)
from subdiv_cli.kinds.multivariate.numbers.gram import Gram, gram
from subdiv_cli.kinds.multivariate.numbers.matrix_norms import MatrixNorm, matrix_norm
from subdiv_cli.kinds.multivariate.numbers.mean_squares import MeanSquares, mean_squares
from subdiv_cli.kinds.multivariate.numbers.polynomials import (
    QuasiInterpolation,
    Reproduction,
    coset_sums,
    quasi_interpolation,
    reproduction,
    sum_rule_order,
)
from subdiv_cli.kinds.multivariate.numbers.stencil_growth import StencilGrowth, stencil_growth
from subdiv_cli.kinds.multivariate.numbers.sublattice import Sublattice, sublattice
from subdiv_cli.kinds.multivariate.numbers.symmetries import symmetries
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import HALF, Effort
from subdiv_cli.spaces.lattice import Index, IntMatrix, Lattice

_NEAR = 1e-6
"""An exponent that is nearer to an integer is taken for one, where nothing is decided by it."""


class MultivariateNumbers:
    """The numbers of one scheme, under one effort; what no theorem needs is not computed."""

    def __init__(self, scheme: MultivariateScheme, effort: Effort) -> None:
        self.scheme, self.effort = scheme, effort
        self.parts: tuple[Part, ...] = ()
        """The factors of a tensor product that is no box spline, with their findings."""
        self.lattice = Lattice(scheme.dilation)

    @property
    def dimension(self) -> int:
        """The number s of variables."""
        return self.lattice.dimension

    @cached_property
    def sums(self) -> tuple[Fraction, ...]:
        """The coset sums Σ_β a_(γ+Mβ) for the representatives γ."""
        return coset_sums(self.scheme, self.lattice)

    @cached_property
    def is_normalised(self) -> bool:
        """Whether a(1) = |det M|: there is a refinable function φ with integral 1."""
        return sum(self.scheme.terms.values()) == self.lattice.index

    @cached_property
    def order(self) -> int:
        """The order k of the sum rules of total degree."""
        return sum_rule_order(self.scheme, self.lattice, self.effort)

    @cached_property
    def is_interpolatory(self) -> bool:
        """Whether a_0 = 1 and a_(Mα) = 0 for α ≠ 0."""
        zero = (0,) * self.dimension
        return self._by_coset.get(self.lattice.coset(zero)) == {zero: Fraction(1)}

    @cached_property
    def is_shifted_interpolatory(self) -> bool:
        """Whether a(· + t) is interpolatory for some t: the coset of t has this coefficient alone, and it is 1."""
        return any([*some.values()] == [1] for some in self._by_coset.values())

    @cached_property
    def _by_coset(self) -> dict[Index, dict[Index, Fraction]]:
        """The terms of each coset that has any, by its key."""
        cosets: dict[Index, dict[Index, Fraction]] = {}
        for alpha, x in self.scheme.terms.items():
            cosets.setdefault(self.lattice.coset(alpha), {})[alpha] = x
        return cosets

    @cached_property
    def box(self) -> BoxSpline | None:
        """The box spline that φ is, if it is one."""
        return box_spline(self.scheme, self.lattice, self.effort) if self.is_normalised else None

    @cached_property
    def contractions(self) -> tuple[Contraction, ...] | None:
        """Directional difference schemes that contract and prove convergence; None without them."""
        if set(self.sums) != {Fraction(1)}:
            return None
        return contractions(self.scheme, self.lattice, self.effort)

    @cached_property
    def pair_contractions(self) -> tuple[PairContraction, ...] | None:
        """Quotients by pairs of directional factors that contract and prove C^1; None without them."""
        if set(self.sums) != {Fraction(1)}:
            return None
        return pair_contractions(self.scheme, self.lattice, self.effort)

    def matrix_norm(self, k: int, n: int) -> MatrixNorm | None:
        """A norm of a matrix scheme of differences of order k, at most that of the sum rules: ρ_k < λ^-n by it."""
        return matrix_norm(self.scheme, self.lattice, k, n, self.effort)

    @cached_property
    def is_positive_on_a_box(self) -> bool:
        """Whether the support is all of a box, the coefficients there are positive, M = cI and each side is >= c."""
        power, c = self.lattice.scalar_power or (0, 0)
        sides = [high - low for low, high in zip(*self.scheme.bounds(), strict=True)]
        terms = self.scheme.terms
        full = len(terms) == prod(side + 1 for side in sides) and min(terms.values()) > 0
        return power == 1 and c >= 2 and full and min(sides) >= c

    @cached_property
    def sublattice(self) -> Sublattice | None:
        """The lattice that the mask stays in, where that is not Z^s."""
        return sublattice(self.scheme, self.lattice)

    @cached_property
    def space(self) -> DifferenceSpace | None:
        """The space V_k for the order k >= 1 of the sum rules; None without any, or where it is too large."""
        if not (k := self.order):
            return None
        return self.effort.in_time(lambda: difference_space(self.scheme, self.lattice, k, self.effort))

    @cached_property
    def radius(self) -> Radius | None:
        """The joint spectral radius ρ_k of the transition operators on V_k."""
        from subdiv_cli.jsr.radius import joint_spectral_radius  # numpy comes with it

        if self.space is None:
            return None
        return joint_spectral_radius(Family(self.space.matrices), self.effort.limited(self.effort.work, HALF))

    @cached_property
    def stencil_growth(self) -> StencilGrowth | None:
        """The growth on V_k(w), where S converges; None where it is too large or not bounded.

        k is at least the order of the sum rules, and above the exponent that ρ_k of SD605 is seen to leave.
        """
        k, unit, known = max(1, self.order), log2(self.lattice.index) / self.dimension, None
        if self.radius is not None and isfinite(self.radius.ceiling):
            k = max(k, floor(-self.radius.ceiling / unit + _NEAR) + 1)
            if self.radius.exact is not None and self.radius.exact[1].low == self.radius.exact[1].high:
                known = self.radius.exact[0], self.radius.exact[1].low
        return self.effort.in_time(lambda: stencil_growth(self.scheme, self.lattice, k, known, self.effort))

    @cached_property
    def mean_squares(self) -> MeanSquares | None:
        """The growth of the mean squares of differences of order k >= 1; None where the operator is too large."""
        if not (k := self.order):
            return None
        return self.effort.in_time(lambda: mean_squares(self.scheme, self.lattice, k, self.effort))

    @cached_property
    def gram(self) -> Gram | None:
        """The Gram sequence of the translates of φ, where S converges; None where it is too long."""
        return self.effort.in_time(lambda: gram(self.scheme, self.lattice, self.effort))

    @property
    def mean_decay(self) -> Fraction | None:
        """A number x with ρ_k² <= x: m Λ, as ‖T_w v‖² is at most the sum over all words of one length.

        For isotropic M.
        """
        means = self.mean_squares if self.lattice.is_isotropic else None
        return None if means is None or means.growth is None else self.lattice.index * means.growth.high

    @cached_property
    def reproduction(self) -> Reproduction:
        """The polynomials that are reproduced, for k >= 1."""
        return reproduction(self.scheme, self.lattice, self.order - 1)

    @cached_property
    def symmetries(self) -> tuple[IntMatrix, ...]:
        """The symmetries of the mask that `symmetries` recognises."""
        return symmetries(self.scheme)

    @cached_property
    def quasi_interpolation(self) -> QuasiInterpolation:
        """The operator Q on the polynomials that are generated, for k >= 1 and S that converges."""
        return quasi_interpolation(self.scheme, self.lattice, self.order - 1, self.symmetries)

    @cached_property
    def product(self) -> WordProduct | None:
        """The product that bounds ρ_k from below."""
        if self.space is None or self.radius is None or self.radius.word is None:
            return None
        return WordProduct.of_word(self.space.matrices, self.radius.word)
