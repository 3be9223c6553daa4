"""The growth of differences of the limit φ of a scheme that converges, by its limit stencil: stable or not.

a is a mask on Z^s, M its dilation, S the scheme, (T_ε v)(α) = Σ_β a(ε+Mα-β) v(β) for representatives ε of Z^s/MZ^s.
Hypotheses: S converges; M is diagonalisable over C with all eigenvalues of modulus λ > 1, so that some norm of R^s has
|M x| = λ |x| for all x: M/λ is an isometry of it. φ is the limit of S^L δ, and all limits are Σ c(β) φ(· - β).

The stencil. The kernel of T_0 - 1 is spanned by one w with Σ w = 1 (spaces/stencils.py, theorem 2, for the mask moved
so that its support begins at 0), and (w * S^L δ)(i) = φ(M^-L i) exactly, for all L >= 0 and i in Z^s. Hence
(T_word ∇^μ w)(a), the word ε_1, …, ε_L and i = ε_1 + M ε_2 + … + M^(L-1) ε_L + M^L a, is the difference ∇^μ φ at
M^-L i with the steps M^-L e_1, …, M^-L e_s; and every i has its word and its a. Let d_k(L) be the largest of these,
over |μ| = k and i.

From below. Let X be a finite-dimensional space that the T_ε map into itself and that holds all T_word ∇^μ w, |μ| = k,
of some length, ρ its joint spectral radius, ρ < x. Then d_k(L) <= C x^L. Let Q be a quasi-interpolant of the grid Z^s
with tensor products of B-splines of degree k+1, exact on π_(k-1), and Q_L f = Q(f(M^-L ·))(M^L ·), local operators that
read f on M^-L Z^s. A function on the integers of a box of sides >= k is as near to π_(k-1) there, up to a constant, as
its differences of order k in it are to 0 (Newton: where these are 0 it is such a polynomial). So g_L = Q_(L+1) φ -
Q_L φ has |g_L| <= C d_k(L+1) <= C x^L and |D^n g_L| <= C λ^(nL) x^L, n <= k, and φ = Q_0 φ + Σ g_L, as φ is uniformly
continuous:
  * x < λ^-n, n < k: the sum converges in C^n, so φ is C^n.
  * x = λ^-β, 0 < β < k: differences of order k with steps of length h are at most
    C h^k + C Σ_L min(λ^-βL, h^k λ^((k-β)L)) <= C h^β: φ is in the class B^β_(∞,∞).
So φ is C^n for ρ < λ^-n, n < k, and α >= min(k, -log_λ ρ).

From above. Let X be *spanned* by words applied to the ∇^μ w, |μ| = k. A basis of X are T_v ∇^μ w for finitely many
words v, so that the largest ‖T_word | X‖ over words of length L is at most C max d_k(L + |v|).
  * φ in C^n, n < k: d_k(L) = o(λ^-nL), since ∇^μ is a difference of order k-n >= 1 of derivatives of order n, which are
    uniformly continuous, along vectors of length C λ^-L. So the norms are o(λ^-nL): for some L they are below λ^-nL,
    and ρ < λ^-n. For n >= k, d_k(L) = O(λ^-kL): ρ <= λ^-k.
  * φ in B^β_(∞,∞), 0 < β < k: d_k(L) = O(λ^-βL), as ∇^μ is a combination of differences of order k with one step each
    (Kemperman's identity), of length C λ^-L: ρ <= λ^-β.
So ρ >= λ^-n, n < k, excludes C^n, and ρ > λ^-k excludes C^k and says α <= -log_λ ρ. Then α = -log_λ ρ.

Nothing here asks that translates of φ are stable, or that some function is not 0: X holds only what words of the
operators make of differences of φ, and what they make of these are differences of φ again.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm
from typing import NamedTuple

from flint import fmpq_mat

from subdiv_cli.exact.linalg import matrix
from subdiv_cli.exact.rationals import to_fraction
from subdiv_cli.jsr.family import Word
from subdiv_cli.jsr.products import WordProduct, radius_bound
from subdiv_cli.jsr.result import Radius
from subdiv_cli.kinds.growth import first_above, growth_on
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.witnesses import PlacedNumbers
from subdiv_cli.model import HALF, Effort
from subdiv_cli.spaces.lattice import Index, Lattice
from subdiv_cli.spaces.stencils import SequenceSpace, StencilSpaces
from subdiv_cli.spaces.transition import TransitionOperators

_MOST_ORDERS = 8
"""The most orders k that are tried."""
_LONGEST = 6
"""The length of the products that tell whether the exponent is below k: letters, and pairs, may all be nilpotent."""
_LONGEST_POWER = 60
"""The most letters of a power of such a product that is compared with another bound."""


class StencilGrowth(NamedTuple):
    """The growth on V_k(w), with what it belongs to."""

    cosets: tuple[Index, ...]
    """The representatives ε of the operators T_ε, as the mask stands; w is fixed by the first."""
    stencil: PlacedNumbers
    """The limit stencil w."""
    order: int
    """k."""
    on: SequenceSpace
    """The space V_k(w)."""
    word: Word | None
    """A product that bounds the radius from below."""
    least: Fraction
    """A number y <= ρ^length, length that of the word; 0 without one."""
    radius: Radius | None
    """The joint spectral radius; None where the product keeps it at what another bound of the exponent says."""

    @property
    def product(self) -> WordProduct | None:
        """The product of the word."""
        return None if self.word is None else WordProduct.of_word(self.on.space.matrices, self.word)


def stencil_growth(
    scheme: MultivariateScheme, lattice: Lattice, least: int, known: tuple[int, Fraction] | None, effort: Effort
) -> StencilGrowth | None:
    """The growth on V_k(w) of a scheme that converges, k >= `least`; None where it is too large, or no bound is found.

    `known` is a pair (ℓ, Λ) with α >= -log_λ(Λ)/ℓ, which need only be met by a product. Raises ClockStruckError.
    """
    operators = TransitionOperators(lattice, {index: matrix([[x]]) for index, x in scheme.terms.items()})
    spaces = StencilSpaces(operators, effort.look)
    if spaces.stencils is None:
        return None
    (w,) = spaces.stencils
    stencil = tuple((alpha, to_fraction(x)) for alpha, (x,) in w.items())
    if (above := first_above(spaces, range(least, least + _MOST_ORDERS), _LONGEST)) is None:
        return None
    k, on, words = above
    if known is not None and (met := _meeting(on.space.matrices, words, *known)) is not None:
        return StencilGrowth(operators.cosets, stencil, k, on, *met, None)
    growth = growth_on(k, on, effort.limited(effort.work, HALF))
    if growth is None:
        return None
    word, bound = (None, Fraction(0)) if growth.product is None else (growth.product.word, radius_bound(growth.product))
    return StencilGrowth(operators.cosets, stencil, k, on, word, bound, growth.radius)


def _meeting(
    matrices: Sequence[fmpq_mat], words: Sequence[Word], length: int, value: Fraction
) -> tuple[Word, Fraction] | None:
    """A power of one of the words, of length N, and value^(N/length), where the product has that spectral radius."""
    for word in words:
        whole = lcm(length, len(word))
        power, bound = word * (whole // len(word)), value ** (whole // length)
        if whole <= _LONGEST_POWER and _has_radius(matrices, power, bound):
            return power, bound
    return None


def _has_radius(matrices: Sequence[fmpq_mat], word: Word, value: Fraction) -> bool:
    return WordProduct.of_word(matrices, word).eigenvalue.compare_modulus(value) == 0
