"""The numbers of one scalar scheme, each computed once, however many stages use it."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property

from flint import fmpq_mat, fmpz_poly

from subdiv_cli.exact.laurent import Laurent
from subdiv_cli.jsr.products import WordProduct
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.scalar.numbers.norms import power_norms
from subdiv_cli.kinds.scalar.numbers.operators import (
    difference_symbol,
    refinement_matrices,
    symbol,
    transition_matrices,
)
from subdiv_cli.kinds.scalar.numbers.polynomials import residue_sums, sum_rules
from subdiv_cli.kinds.scalar.numbers.radius import difference_radius
from subdiv_cli.kinds.scalar.numbers.sobolev import Growth, mean_square_growth, transfer_order
from subdiv_cli.kinds.scalar.numbers.spectra import Spectrum, spectrum
from subdiv_cli.kinds.scalar.numbers.stability import (
    ReductionStep,
    bezout_cofactors,
    circle_factors,
    cycles,
    polyphase_gcd,
    reduction,
)
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Effort


class ScalarNumbers:
    """The numbers of one scheme under one effort."""

    def __init__(self, scheme: ScalarScheme, effort: Effort, name: str = "S") -> None:
        self.scheme = scheme
        self.effort = effort
        self.p = scheme.arity
        self.name = name
        """The name that findings use: S, or S0 for a reduced scheme."""

    @cached_property
    def symbol(self) -> Laurent:
        """The symbol a(z) = Σ a_i z^i."""
        return symbol(self.scheme)

    @cached_property
    def residue_sums(self) -> tuple[Fraction, ...]:
        """The p sums Σ_β a_(γ+pβ), γ = 0, …, p-1."""
        return residue_sums(self.symbol, self.p)

    @cached_property
    def is_normalised(self) -> bool:
        """Whether a(1) = p, so that a refinable distribution φ with ∫φ = 1 exists."""
        return sum(self.residue_sums) == self.p

    @cached_property
    def sum_rules(self) -> tuple[int, Laurent, Laurent]:
        """The largest k with a = (1+z+…+z^(p-1))^k q, this q, and the remainder by one more factor."""
        return sum_rules(self.symbol, self.p)

    @cached_property
    def reduction(self) -> tuple[ReductionStep, ...]:
        """The steps to a stable mask; none where φ is stable, or where a(1) ≠ p and there is no φ."""
        return reduction(self.symbol, self.p) if self.is_normalised else ()

    @cached_property
    def reduced(self) -> ScalarNumbers:
        """The numbers of the stable mask whose φ0 is as smooth as φ; these numbers themselves where φ is stable."""
        if not self.reduction:
            return self
        symbol = self.reduction[-1].symbol
        scheme = ScalarScheme(arity=self.p, start=symbol.low, coefficients=symbol.coefficients())
        return ScalarNumbers(scheme, self.effort, "S0")

    @property
    def order(self) -> int:
        """The sum-rule order k; 0 where a(1) ≠ p."""
        return self.sum_rules[0] if self.is_normalised else 0

    @cached_property
    def _differences(self) -> list[Laurent]:
        """The symbols of S_(Δ^0) = S, S_(Δ^1), … that are known, each computed from the one before."""
        return [self.symbol]

    def difference(self, nu: int) -> Laurent:
        """The symbol of S_(Δ^ν), 0 <= ν <= k."""
        known = self._differences
        while len(known) <= nu:
            known.append(difference_symbol(known[-1], self.p, 1))
        return known[nu]

    @cached_property
    def transition_order(self) -> int:
        """The order N of the transition matrices of S_(Δ^k)."""
        return max(1, -(-self.scheme.degree // (self.p - 1)) - self.order)

    @cached_property
    def radius(self) -> Radius | None:
        """The joint spectral radius of D = S_(Δ^k), k >= 1; None where the effort does not suffice for any bound."""
        if self.order < 1 or not self.effort.allows(self.p * self.transition_order**2 * self.weight):
            return None
        return difference_radius(self.difference(self.order), self.p, self.effort)

    @cached_property
    def product(self) -> WordProduct | None:
        """The product of transition matrices of D that bounds the radius from below; None where none is known."""
        if self.radius is None or self.radius.word is None:
            return None
        return WordProduct.of_word(transition_matrices(self.difference(self.order), self.p), self.radius.word)

    @cached_property
    def _norms(self) -> dict[int, tuple[Fraction, ...]]:
        return {}

    def norms(self, nu: int) -> tuple[Fraction, ...]:
        """The norms ‖((1/p) S_ν)^L‖∞ for L = 1, 2, …, to the first below 1 or to the end of the effort."""
        if nu not in self._norms:
            self._norms[nu] = tuple(self._needed_norms(nu))
        return self._norms[nu]

    def _needed_norms(self, nu: int) -> Iterator[Fraction]:
        for norm in self.every_norm(nu):
            yield norm
            if norm < 1:
                return

    def every_norm(self, nu: int) -> Iterator[Fraction]:
        """The norms ‖((1/p) S_ν)^L‖∞ for L = 1, 2, …, ν <= k, to the end of the effort."""
        return power_norms(self.difference(nu).scale(self.p ** (nu - 1)), self.p, self.effort)

    @cached_property
    def growth(self) -> Growth | None:
        """The growth λ of the mean squares of D = S_(Δ^k), k >= 1, of a stable mask; None where G is too large."""
        d = self.difference(self.order)
        if self.order < 1 or not self.effort.allows(transfer_order(d.degree, self.p) ** 3 * self.weight**2 // 4):
            return None
        return mean_square_growth(d, self.p)

    @cached_property
    def refinement_matrices(self) -> tuple[fmpq_mat, ...]:
        """The refinement matrices A_0, …, A_(p-1), with the indices of their window."""
        return refinement_matrices(self.scheme)

    @cached_property
    def spectra(self) -> tuple[Spectrum, ...] | None:
        """The spectra of A_0, …, A_(p-1); None where they are too large for the effort."""
        order = -(-self.scheme.degree // (self.p - 1)) + 2
        if not self.effort.allows(self.p * order**3 * self.weight // 8):
            return None
        return tuple(spectrum(matrix) for matrix in self.refinement_matrices)

    @cached_property
    def polyphase_gcd(self) -> Laurent:
        """The monic gcd of the polyphase components a_0, …, a_(p-1)."""
        return polyphase_gcd(self.symbol, self.p)

    @cached_property
    def bezout_cofactors(self) -> tuple[Laurent, ...] | None:
        """Of the polyphase components; None where they would cost more than the effort."""
        affordable = self.effort.allows(len(self.scheme.coefficients) ** 2 * self.weight // 16)
        return bezout_cofactors(self.symbol, self.p) if affordable else None

    @cached_property
    def weight(self) -> int:
        """The cost of an operation on a coefficient: 1, and more for coefficients of more than 64 bits."""
        numerators, denominator = self.symbol.integer_form()
        return 1 + max(numerators.height_bits(), denominator.bit_length()) // 64

    @cached_property
    def circle_factors(self) -> tuple[fmpz_poly, ...]:
        """The irreducible factors of that gcd that have a zero on |z| = 1."""
        return circle_factors(self.polyphase_gcd)

    @cached_property
    def cycle(self) -> int | None:
        """The smallest n whose cycle of n-th roots of unity makes the translates dependent."""
        return next(cycles(self.symbol, self.p), None)


def norms(scheme: ScalarScheme, nu: int, effort: Effort) -> Iterator[Fraction] | None:
    """The norms ‖((1/p) S_ν)^L‖∞ for L = 1, 2, …, to the end of the effort; None where there is no S_ν, ν >= 1."""
    numbers = ScalarNumbers(scheme, effort)
    return numbers.every_norm(nu) if nu <= numbers.order else None
