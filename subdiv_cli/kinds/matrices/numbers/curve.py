"""The curve of p matrices: where its smoothness is decided, inside its pieces and at the joints between them.

A_0, …, A_(p-1) are n×n matrices whose rows sum to 1, B_i = A_i^T, e = (1, …, 1), and S maps a control polygon c to the
polygons A_i c of the p pieces. S converges if for all c and all digits x_1, x_2, … the polygons A_(x_ℓ) ⋯ A_(x_1) c
tend to a multiple of e. JSR is the joint spectral radius of B_0, …, B_(p-1) on a space that they map into itself.

Theorem 1 (convergence). S converges iff JSR(B | e^⊥) < 1, e^⊥ = {v : Σ v_i = 0}.

  For v in e^⊥, v·A_(x_ℓ) ⋯ A_(x_1) c = (B_(x_1) ⋯ B_(x_ℓ) v)·c. If: these numbers decay geometrically, uniformly; for
  v = e_i - e_j they are the differences of the control points, for the rows of A_i minus those of 1 the steps from
  level to level. Only if: on R^n/e all products A_(x_ℓ) ⋯ A_(x_1) tend to 0. For each sequence of digits one has a
  norm <= 1/2; as the sequences are a compact space, lengths up to some L are enough, so that JSR <= 2^(-1/L).

Theorem 2 (Micchelli & Prautzsch 1989, Theorem 3.1; continuity as in 3.2 and 5.1). Let S converge, f_i = B_i f_i with
e·f_i = 1. One function ψ: [0, 1] → R^n has c·ψ(x) as the limits for all c and all x = Σ x_j p^-j iff B_j f_0 =
B_(j-1) f_(p-1), 0 < j < p: the pieces meet. It is continuous, ψ(x) = B_i ψ(px - i) on piece i, and e·ψ = 1.

Let this be so. Ψ = {c·ψ} are the components of the curve, Σ = span ψ[0, 1] the smallest invariant space with f_0, dim
Ψ = dim Σ (Corollary 4.2 there). With q(x) also its parts q((x+i)/p) are in Ψ, and their differences: if Ψ has a
polynomial of degree d it has all π_d. Let d be the largest such degree, u_δ·ψ(x) = x^δ, u_0 = e, and V = {v in Σ :
u_0·v = … = u_d·v = 0}. V = 0 iff the curve is a polynomial, and then of degree d.

Lemma. For each k > d, V is spanned by the differences Δ^k ψ of order k on the grids p^-m Z in [0, 1], m >= m_0.

  The differences are in Σ and of polynomials u_δ·ψ they are 0. If c is orthogonal to all of them, c·ψ is a polynomial
  of degree < k on every grid, always the same one, so c·ψ is in π_(k-1) ∩ Ψ = π_d, and c in span u_δ + Σ^⊥.

Let ρ = JSR(B | V), V ≠ 0. For δ <= d with p^-δ > ρ there is one r_δ in Σ with B_0 r_δ = p^-δ r_δ and u_j·r_δ = δ! for
j = δ, otherwise 0, and one l_δ with B_(p-1) l_δ = p^-δ l_δ and u_j·l_δ = j!/(j-δ)!, 0 for j < δ: on Σ/V, the dual of
π_d, B_0 and B_(p-1) have the simple eigenvalues 1, p^-1, …, p^-d, with the derivatives of order δ at 0 and at 1. They
are ψ^(δ)(0) and ψ^(δ)(1). The derivatives of order δ fit if B_j r_δ = B_(j-1) l_δ for 0 < j < p, the condition (a) of
Micchelli & Prautzsch 1989, Theorem 5.2, at this step of the chain Σ = S^(0) ⊃ S^(1) ⊃ …, the v with u_j·v = 0, j < δ.

Theorem 3 (smoothness). ψ is C^n iff ρ < p^-n and the derivatives of order δ fit for all δ <= min(n, d). The Hölder
exponent, the largest α with ψ in C^(α-ε) for all ε > 0, is min(-log_p ρ, least δ <= d with p^-δ > ρ that does not fit).

  Let k be large, k > d, and p^L >= k. A difference of order k and step p^-(ℓ+L) lies in a piece B_w ψ of level ℓ =
  |w|, and is B_w g with g such a difference of step p^-L, or it straddles the joint of two pieces of level ℓ that
  follow each other. These are w i (p-1)^b and w (i+1) 0^b with |w| + 1 + b = ℓ, so the difference is B_w times
  z_b = B_i B_(p-1)^b v + B_(i+1) B_0^b v', with v = Σ c_j ψ(1 - j p^-L) over its points on the left and v' = Σ c_j
  ψ(j p^-L) over those on the right. Split Σ by the eigenvalues of B_(p-1) into the l_δ and a space on which powers of
  B_(p-1) are O((ρ+ε)^b), and by those of B_0 alike. The coordinates of v and v' at l_δ and r_δ are Σ c_j (-j p^-L)^δ/δ!
  and Σ c_j (j p^-L)^δ/δ!, by the u_j; their sum is 0, since the difference annihilates polynomials of degree < k. With
  a_δ the former, z_b = Σ a_δ p^-δb (B_i l_δ - B_(i+1) r_δ) + O((ρ+ε)^b), and z_b is in V, where B_w is O((ρ+ε)^|w|).
  From below: with σ the largest p^-δ that does not fit, differences of level ℓ are O(max(ρ+ε, σ)^ℓ). Such decay of all
  differences of order k > β gives C^β, p^-β = max(ρ+ε, σ) (local polynomials of degree < k differ by that much between
  levels). From above: if ψ is C^n, differences of order k > n are o(p^-nℓ). On V, which finitely many of them span, B_w
  is then o(p^-n|w|), so that ρ < p^-n. And where order δ <= n does not fit at joint i, a difference with one point on
  the left has a_δ ≠ 0, so that z_b is no o(p^-δb). If ψ is C^β, β < k, differences are O(p^-βℓ), so ρ <= p^-β.

No hypothesis on the degree, on nonnegative entries, or on dim Ψ = n is used. Of which polygons it speaks: those c with
c·ψ in C^β are a space, all of R^n iff β is allowed for ψ; so for all c outside of a proper subspace α is the exponent
of c·ψ itself, for all others at most better. A segment of a spline is a polynomial: smoothness is that on [0, 1].
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from math import factorial
from typing import NamedTuple

from flint import fmpq_mat

from subdiv_cli.exact.linalg import Vector, identity, matrix, nullspace, reduced, rows_of, solution
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.kinds.matrices.numbers.components import Components
from subdiv_cli.spaces.closure import InvariantSpace, invariant_space


class Jet(NamedTuple):
    """The derivatives of one order δ of the curve at its two ends, and whether they fit at all joints."""

    order: int
    left: Vector
    """The vector r_δ = ψ^(δ)(0)."""
    right: Vector
    """The vector l_δ = ψ^(δ)(1)."""
    joint: int | None
    """The first joint j, between pieces j-1 and j, where B_j r_δ ≠ B_(j-1) l_δ; None where they fit."""

    @property
    def fits(self) -> bool:
        """Whether there is no such joint."""
        return self.joint is None


class Annihilated(NamedTuple):
    """The space V of vectors that annihilate the polynomial components, and the family on it."""

    basis: fmpq_mat
    """The basis b_1, …, b_N as rows of integers."""
    matrices: tuple[fmpq_mat, ...]
    """For each B_i an N×N matrix: B_i b_j = Σ_l matrix[l, j] b_l."""


class RefinedCurve:
    """The curve ψ of a scheme that converges and whose pieces meet, by B_0, …, B_(p-1), f_0 and f_(p-1)."""

    def __init__(self, operators: Sequence[fmpq_mat], left: Vector, right: Vector) -> None:
        self.operators = operators
        self._ends = (left, right)

    @property
    def p(self) -> int:
        """The number of pieces."""
        return len(self.operators)

    @cached_property
    def span(self) -> InvariantSpace:
        """The space Σ, with a word for each vector of a basis."""
        span = invariant_space(self.operators, matrix([self._ends[0]]))
        assert span is not None, "the order is bounded"
        return span

    @cached_property
    def annihilator(self) -> tuple[Vector, ...]:
        """A basis of Σ^⊥: the polygons whose curve is 0."""
        return nullspace(self.span.basis)

    @cached_property
    def components(self) -> Components:
        """The polynomials in Ψ."""
        return Components(self.operators, self.span.basis)

    @cached_property
    def annihilated(self) -> Annihilated | None:
        """The space V; None where it is 0, and the curve a polynomial."""
        rows = nullspace(matrix([*self.components.polygons, *self.annihilator]))
        if not rows:
            return None
        basis = reduced(matrix(rows))
        to_coordinates = basis.transpose() * (basis * basis.transpose()).inv()
        family = tuple((basis * b.transpose() * to_coordinates).transpose() for b in self.operators)
        return Annihilated(basis, family)

    def jet(self, order: int) -> Jet:
        """The derivatives of an order δ <= d with p^-δ beyond the radius on V."""
        degrees = range(len(self.components.polygons))
        left = [Fraction(factorial(order)) if j == order else Fraction(0) for j in degrees]
        right = [Fraction(factorial(j), factorial(j - order)) if j >= order else Fraction(0) for j in degrees]
        r, l = self._eigenvector(0, order, left), self._eigenvector(self.p - 1, order, right)
        return Jet(order, r, l, first_misfit(self.operators, r, l))

    def _eigenvector(self, letter: int, order: int, moments: Sequence[Fraction]) -> Vector:
        """The vector f in Σ with B f = p^-δ f and u_j·f as given."""
        n = self.operators[0].nrows()
        shifted = self.operators[letter] - identity(n) * to_fmpq(Fraction(1, self.p**order))
        rows = [*rows_of(shifted), *self.components.polygons, *self.annihilator]
        eigenvector = solution(matrix(rows), [*[Fraction(0)] * n, *moments, *[Fraction(0)] * len(self.annihilator)])
        assert eigenvector is not None, "the eigenvalue is simple, with this eigenvector modulo V"
        return eigenvector


def first_misfit(operators: Sequence[fmpq_mat], left: Vector, right: Vector) -> int | None:
    """The least j > 0 with B_j left ≠ B_(j-1) right; None where there is none."""
    first, last = (fmpq_mat([[to_fmpq(x)] for x in v]) for v in (left, right))
    joints = range(1, len(operators))
    return next((j for j in joints if operators[j] * first != operators[j - 1] * last), None)


def fixed_vector(operator: fmpq_mat) -> Vector:
    """The vector f with B f = f whose entries sum to 1, for B with the simple eigenvalue 1 and columns that do."""
    n = operator.nrows()
    fixed = solution(matrix([*rows_of(operator - identity(n)), [Fraction(1)] * n]), [*[Fraction(0)] * n, Fraction(1)])
    assert fixed is not None, "S converges, so that e^⊥ has no eigenvalue 1"
    return fixed


def on_grid(operators: Sequence[fmpq_mat], left: Vector, right: Vector, level: int) -> list[fmpq_mat]:
    """The points ψ(j p^-level), 0 <= j <= p^level, as columns, of a curve with ψ(0) = left and ψ(1) = right."""
    ends = [fmpq_mat([[to_fmpq(x)] for x in v]) for v in (left, right)]
    points = ends
    for _ in range(level):
        points = [b * x for b in operators for x in points[:-1]] + ends[1:]
    return points
