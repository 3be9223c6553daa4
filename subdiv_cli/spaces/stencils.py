"""The limit-stencil spaces of a mask of m×m matrices on Z^s: convergence and smoothness decided without stability.

S is the scheme of the mask, T_ε its transition operators (`transition`), M the dilation, JSR the joint spectral radius
of the T_ε on a space that they map into itself. S converges if for all bounded data c there is a continuous F with
S^n c(i) - F(M^-n i) -> 0 uniformly, and F ≠ 0 for some c; F = F_c is then called a limit.

Theorem 1 (convergence). With E_A = {u : A^ε u = u for all ε} and V_1 = {v on W : Σ v(α) ⊥ E_A}, the T_ε map V_1 into
itself, and S converges iff E_A ≠ 0 and JSR(T | V_1) < 1; all limits have values in E_A.

  Invariant: Σ_α (T_ε v)(α)·u = Σ_β v(β)·A^(ε-β) u = Σ_β v(β)·u for u in E_A.
  If: JSR(T | V_1) < 1, and T_0 is the identity on ℓ(W)/V_1, the dual of E_A, so that for a basis u_1, …, u_r of E_A
  there are w_i = T_0 w_i with Σ w_i · u_j = δ_ij. f_i(M^-n x) = (w_i * S^n c)(x) does not depend on n, as
  (w_i * S c)(M a) = (T_0 w_i * c)(a). Differences of w_i come into V_1 after some T_ε, so that those of f_i decay
  geometrically from level to level, uniformly: f_i is continuous. For x in Q^m the sequence x δ - Σ (x·u_i) w_i has a
  sum orthogonal to E_A, so x·S^n c - Σ (x·u_i) f_i -> 0: F = Σ f_i u_i. Constants c = u in E_A have F = u ≠ 0.
  Only if: S^(n+1) c is S of data that vary ever less, so that F = A^ε F for all ε: F has values in E_A, which is not
  0. For v in V_1, (v * S^n c)(x) -> Σ v(α)·F = 0 uniformly in x: for c = e_l δ these are the entries of T_word v, so
  that max over the words of length n of ‖T_word | V_1‖ -> 0.

Theorem 2 (limit stencils). If S converges, ker(T_0 - 1) on W has the dimension r = dim E_A, and a basis w_1, …, w_r
with Σ w_i · u_j = δ_ij gives the limits exactly: (w_i * S^n c)(x) = f_i(M^-n x), F = Σ f_i u_i. A kernel of higher
dimension therefore proves divergence. The dimension r alone proves nothing.

  T_0^n v tends to the sequence w with (w * c)(a) = Σ v(α)·F_c(a), which depends on Σ v modulo E_A^⊥ only; a fixed
  v is its own limit. So all w_i are limits of T_0^n x δ, and lie on any window that holds 0 and is mapped into itself.

Theorem 3 (smoothness). Let S converge, M be diagonalisable over C with all eigenvalues of modulus λ, and V_k(w) the
smallest space that holds all ∇^μ w_i, |μ| = k, and is mapped into itself by the T_ε. All limits are C^n iff
JSR(T | V_(n+1)(w)) < λ^-n. And α = -log_λ JSR(T | V_k(w)) is the Hölder exponent of the limits, the largest with
f_i in C^(α-ε) for all ε > 0 and data, as soon as this is below k; that or k, the smaller one, bounds it from below.

  By theorem 2 the entries of T_word ∇^μ w_i, the word of length L, are the differences ∇^μ f_i along M^-L e_1, …,
  M^-L e_s of the limits for c = e_l δ; the steps are comparable to λ^-L, and the grids M^-L Z^s are of bounded shape.
  Let the radius be below x. Then differences of order k at level L are O(x^L), so that local polynomials of degree
  < k through the grid differ by that much between levels: for x < λ^-n, n < k, they converge in C^n, and f_i is in
  C^β for all β < k with x <= λ^-β. Conversely let f_i be C^n for all data. Differences of order n+1 at level L are
  o(λ^-nL), uniformly, as the n-th derivatives are uniformly continuous; words applied to the ∇^μ w_i span V_(n+1)(w),
  so that max ‖T_word | V_(n+1)(w)‖ = o(λ^-nL) over the words of length L, which forces the radius below λ^-n. And f_i
  in C^β, β < k, makes differences of order k O(λ^-βL), so that the radius is at most λ^-β.

Theorem 4 (attained). With α as in theorem 3, k > α: if all products of L operators on V_k(w) are O(λ^-αL), differences
of order k are O(h^α): f_i is in Lip*(α), which is C^α where α is no integer. For k = α, f_i^(k-1) is Lipschitz. If
they are not, and α is no integer or is k, the limits are not all in C^α, or not in W^(k,∞).

Theorem 5 (jets). In one variable, m >= 2, let the data be c^n = D^-n S^n c, D = diag(1, 1/p, …, p^-(m-1)), and call S
Hermite convergent if for all bounded c there is a function f_c in C^(m-1), not 0 for some c, with
c^n_j(i) - f_c^(j)(p^-n i) -> 0 uniformly for all components j = 0, …, m-1. That is so iff S converges, E_A is spanned
by e_0, and JSR(T | U_j) < p^-j for j = 1, …, m-1, U_j the smallest space that holds e_j δ - ∇^j w and ∇^(j+1) w and is
mapped into itself by the T_ε; w the limit stencil with Σ w · e_0 = 1.

  If: V_(j+1)(w) lies in U_j, so that all f_c are C^j by theorem 3, and with h = p^-n the differences h^-j ∇^j f_c tend
  to f_c^(j), uniformly: f_c is a locally finite sum of shifts of m functions of compact support. These differences are
  p^jn (∇^j w * S^n c)(i) by theorem 2, and c^n_j(i) = p^jn (e_j δ * S^n c)(i); what is between them has the entries
  p^jn (T_word(e_j δ - ∇^j w) * c)(a), words of length n, and tends to 0. For j = 0: E_A says that f_c e_0 is the limit.
  Only if: c^n_j is bounded, so that S^n c tends to f_c e_0: S converges. Constants u in E_A are limits for the data u,
  hence multiples of e_0. For c = e_l δ the difference above tends to 0, so that T_word(e_j δ - ∇^j w) is o(p^-jn) over
  the words of length n; T_word ∇^(j+1) w is, as f_c is C^j. Words applied to these two span U_j, whence
  max ‖T_word | U_j‖ = o(p^-jn), which forces the radius below p^-j.

No hypothesis on the stability of the limits is used anywhere.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from itertools import product
from typing import NamedTuple

from flint import fmpq, fmpq_mat

from subdiv_cli.exact.linalg import eigenvectors, identity, nullspace
from subdiv_cli.exact.rationals import to_fmpq
from subdiv_cli.model import Look, no_clock
from subdiv_cli.spaces.closure import InvariantSpace, invariant_space
from subdiv_cli.spaces.lattice import Index, indices_of_degree
from subdiv_cli.spaces.transition import TransitionOperators

VectorSequence = dict[Index, list[fmpq]]
"""A finitely supported sequence of m-vectors, at the indices where it is not 0."""


class SequenceSpace(NamedTuple):
    """An invariant space of sequences of m-vectors on a window."""

    window: tuple[Index, ...]
    space: InvariantSpace
    """The space: its vectors have m entries for each index of the window, in order."""


class StencilSpaces:
    """The spaces of theorems 1 to 3 for one mask, each computed once; sequences lie on windows, index by index.

    What takes long looks at the clock, and raises what `look` raises.
    """

    def __init__(self, operators: TransitionOperators, look: Look = no_clock) -> None:
        self.operators, self._look = operators, look

    @cached_property
    def constants(self) -> fmpq_mat | None:
        """A basis u_1, …, u_r of E_A, r rows of m entries; None where it is 0."""
        return self.operators.constants

    @cached_property
    def decay(self) -> SequenceSpace | None:
        """The smallest T-invariant space with e_l ∇_j δ and x δ, x in a basis of E_A^⊥: its radius is that on V_1.

        All finite v with Σ v ⊥ E_A are finite combinations of shifts of these, and T_ε maps a shift of v to a shift of
        some T_ε' v: the growth on all of them is the same. None where it is too large.
        """
        s, m = self.operators.lattice.dimension, self.operators.size
        units = identity(m).tolist()
        dying = units if self.constants is None else [[to_fmpq(x) for x in row] for row in nullspace(self.constants)]
        first = [_times(difference(mu), x) for mu in indices_of_degree(s, 1) for x in units]
        return self._space([*first, *(_times({(0,) * s: 1}, x) for x in dying)])

    @cached_property
    def fixed(self) -> tuple[VectorSequence, ...] | None:
        """A basis of the kernel of T_0 - 1 on finitely supported sequences; None where the window is too large."""
        window = self.operators.window
        return None if window is None else self._fixed(window)

    def _fixed(self, indices: Iterable[Index]) -> tuple[VectorSequence, ...] | None:
        """A basis of the kernel of T_0 - 1 on the least invariant window with these indices; None as above."""
        window = self.operators.closed_window(indices, self._look)
        if window is None:
            return None
        kernel = eigenvectors(self.operators.on(window, self._look)[0], 1)
        return tuple(_sequence([to_fmpq(x) for x in row], window, self.operators.size) for row in kernel)

    @cached_property
    def stencils(self) -> tuple[VectorSequence, ...] | None:
        """The limit stencils w_1, …, w_r of a scheme that converges, Σ w_i · u_j = δ_ij, from the least window with 0.

        None where the window is too large, and where they are not r > 0, which excludes convergence.
        """
        fixed = self._fixed([(0,) * self.operators.lattice.dimension])
        if self.constants is None or fixed is None or len(fixed) != self.constants.nrows():
            return None
        sums = fmpq_mat([[sum(column, fmpq(0)) for column in zip(*w.values(), strict=True)] for w in fixed])
        dual = sums * self.constants.transpose()
        if dual.rank() < dual.nrows():
            return None
        return tuple(_combined(row, fixed) for row in dual.inv().tolist())

    def differences(self, k: int) -> SequenceSpace | None:
        """The space V_k(w); None without stencils, and where it is too large.

        That the dilation is as theorem 3 asks is the caller's to check.
        """
        if self.stencils is None:
            return None
        orders = list(indices_of_degree(self.operators.lattice.dimension, k))
        return self._space([_convolved(difference(mu), w) for w in self.stencils for mu in orders])

    def jet(self, j: int) -> SequenceSpace | None:
        """The space U_j of theorem 5; None without one stencil alone, and where it is too large."""
        if self.stencils is None or len(self.stencils) != 1:
            return None
        (w,), zero = self.stencils, (0,) * self.operators.lattice.dimension
        unit = {zero: [fmpq(int(l == j)) for l in range(self.operators.size)]}
        between = _combined([fmpq(1), fmpq(-1)], [unit, _convolved(difference((j,)), w)])
        return self._space([between, _convolved(difference((j + 1,)), w)])

    def _space(self, generators: Sequence[VectorSequence]) -> SequenceSpace | None:
        window = self.operators.closed_window((alpha for v in generators for alpha in v), self._look)
        if window is None:
            return None
        zero = [fmpq(0)] * self.operators.size
        rows = fmpq_mat([[x for alpha in window for x in v.get(alpha, zero)] for v in generators])
        space = invariant_space(self.operators.on(window, self._look), rows, self._look)
        return None if space is None else SequenceSpace(window, space)


def difference(mu: Index) -> dict[Index, int]:
    """The difference ∇^μ δ with ∇_j v = v - v(· - e_j)."""
    v = {(0,) * len(mu): 1}
    for j, times in enumerate(mu):
        for _ in range(times):
            shifted = {(*alpha[:j], alpha[j] + 1, *alpha[j + 1 :]): x for alpha, x in v.items()}
            v = {alpha: v.get(alpha, 0) - shifted.get(alpha, 0) for alpha in {**v, **shifted}}
    return v


def _times(v: Mapping[Index, int], x: Sequence[fmpq]) -> VectorSequence:
    """The sequence with the values v(α) x."""
    return {alpha: [value * entry for entry in x] for alpha, value in v.items()}


def _convolved(d: Mapping[Index, int], w: VectorSequence) -> VectorSequence:
    """The sequence Σ_α d(α) w(· - α)."""
    total: VectorSequence = {}
    for (alpha, factor), (beta, x) in product(d.items(), w.items()):
        at = tuple(map(sum, zip(alpha, beta, strict=True)))
        old = total.get(at, [fmpq(0)] * len(x))
        total[at] = [y + factor * z for y, z in zip(old, x, strict=True)]
    return _trimmed(total)


def _combined(weights: Sequence[fmpq], sequences: Sequence[VectorSequence]) -> VectorSequence:
    total: VectorSequence = {}
    for weight, w in zip(weights, sequences, strict=True):
        for at, x in w.items():
            old = total.get(at, [fmpq(0)] * len(x))
            total[at] = [y + weight * z for y, z in zip(old, x, strict=True)]
    return _trimmed(total)


def _sequence(row: Sequence[fmpq], window: Sequence[Index], m: int) -> VectorSequence:
    return _trimmed({alpha: list(row[m * i : m * i + m]) for i, alpha in enumerate(window)})


def _trimmed(w: VectorSequence) -> VectorSequence:
    return {alpha: x for alpha, x in sorted(w.items()) if any(x)}
