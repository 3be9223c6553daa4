"""The space V_k of differences of order k, and the transition operators T_ε on it.

V_k is the smallest space of sequences that holds all differences ∇^μ δ, |μ| = k, and is mapped into itself by the
transition operators (T_ε v)(α) = Σ_β a(ε+Mα-β) v(β) (Jia 1998; Han & Jia 1998).

Written for what the joint spectral radius ρ_k of the T_ε on V_k decides:

* Every finite v that annihilates π_(k-1) is a finite combination of shifts of the ∇^μ δ, |μ| = k: as Laurent
  polynomials these v are the ideal of those that vanish at 1 to order k, the k-th power of the one of order 1. And T_ε
  of a shift of v is a shift of some T_ε' v. So ρ_k is the growth rate on all such v, whatever finite space holds them.
* With sum rules of order k the T_ε map U_k, the v on a large window that annihilate π_(k-1), into itself, and on
  U_j / U_(j+1), j < k, they all act as one matrix, dual to p -> p(M^-1 ·) on homogeneous polynomials of degree j. So
  ρ_1 = max(ρ_k, ρ(M^-1)) for k > 1, and as M is expanding, ρ_1 < 1 iff ρ_k < 1.
* The ε may be any representatives of the cosets: with ε + Mη for ε the image is a shift. With ε + t for all ε the
  operators are those of the mask a(· + t). So t is the lowest corner of the mask's box, and the matrices are the same
  wherever the mask stands. V_k is most often smaller so than with the mask's middle at the origin.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import fmpq_mat

from subdiv_cli.exact.linalg import matrix, reduced
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.model import Effort
from subdiv_cli.spaces.closure import LARGEST_DIMENSION, LONGEST, longest
from subdiv_cli.spaces.lattice import Index, Lattice, indices_of_degree
from subdiv_cli.spaces.stencils import difference
from subdiv_cli.spaces.transition import TransitionOperators


@dataclass(frozen=True, slots=True, kw_only=True)
class DifferenceSpace:
    """A basis b_1, …, b_N of V_k, and the N×N matrices of the T_ε in it."""

    order: int
    """k."""
    cosets: tuple[Index, ...]
    """The coset representatives ε."""
    window: tuple[Index, ...]
    """The indices where some b_i is not zero."""
    basis: fmpq_mat
    """The basis as an N × window matrix of integers: row i is b_i."""
    matrices: tuple[fmpq_mat, ...]
    """An N×N matrix for each coset representative ε: T_ε b_i = Σ_j matrix[j, i] b_j."""
    generators: fmpq_mat
    """The differences ∇^μ δ, |μ| = k in lexicographic order, as rows of N coordinates."""


def difference_space(scheme: MultivariateScheme, lattice: Lattice, k: int, effort: Effort) -> DifferenceSpace | None:
    """The space V_k; None where it, or its window, is larger than is looked at, or has no short basis.

    Raises ClockStruckError.
    """
    starts = [difference(mu) for mu in indices_of_degree(lattice.dimension, k)]
    transition = TransitionOperators(lattice, {index: matrix([[x]]) for index, x in scheme.terms.items()})
    window = transition.closed_window({alpha for v in starts for alpha in v}, effort.look)
    if window is None:
        return None
    operators = transition.on(window, effort.look)
    places = {alpha: j for j, alpha in enumerate(window)}
    first = fmpq_mat([_row(v, places) for v in starts])
    span = _closure(first, operators, effort)
    if span is None:
        return None
    basis = reduced(span)
    used = [j for j in range(len(window)) if any(row[j] for row in basis.table())]
    coordinates = basis.transpose() * (basis * basis.transpose()).inv()
    return DifferenceSpace(
        order=k,
        cosets=transition.cosets,
        window=tuple(window[j] for j in used),
        basis=fmpq_mat([[row[j] for j in used] for row in basis.table()]),
        matrices=tuple((basis * t.transpose() * coordinates).transpose() for t in operators),
        generators=first * coordinates,
    )


def _row(v: Mapping[Index, int], places: Mapping[Index, int]) -> list[int]:
    row = [0] * len(places)
    for alpha, x in v.items():
        row[places[alpha]] = x
    return row


def _closure(rows: fmpq_mat, operators: Sequence[fmpq_mat], effort: Effort) -> fmpq_mat | None:
    """A basis of the smallest space that holds the given rows and is mapped into itself, as rows; None as above."""
    transposed = [t.transpose() for t in operators]
    span, rank = _echelon(rows), 0
    while rank < span.nrows():
        effort.look()
        rank = span.nrows()
        if rank > LARGEST_DIMENSION or longest(span) > LONGEST:
            return None
        images = [row for t in transposed for row in (span * t).tolist()]
        span = _echelon(fmpq_mat([*span.tolist(), *images]))
    return span


def _echelon(rows: fmpq_mat) -> fmpq_mat:
    echelon, rank = rows.rref()
    return fmpq_mat(echelon.tolist()[:rank])
