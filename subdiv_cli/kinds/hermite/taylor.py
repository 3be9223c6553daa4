"""The Taylor scheme of a Hermite scheme, by which the literature proves Hermite convergence; any arity, any order.

With d components let (T c)_j = Δ c_j - Σ_(l>j) c_l/(l-j)! for j < d-1, Δ c(i) = c(i+1) - c(i), and (T c)_(d-1) =
c_(d-1): what Taylor's formula leaves of data h^j f^(j), and the last derivative. The Taylor mask B, if any, has

    T S_A = p^-(d-1) S_B T.

Theorem (Merrien & Sauer 2012, Theorem 21; for d = 2 Moosmüller & Dyn 2018, Theorem 34 and Lemma 35). Let E_A be spanned
by e_0, and S_B converge to limits in C^n, with E_B spanned by e_(d-1). Then S_A is HC^(d-1), with limits in C^(d-1+n).

Proof. Let c be finitely supported, c^k = D^-k S_A^k c and h = p^-k. Then S_B^k T c = h^-(d-1) T S_A^k c converges
uniformly, to ψ e_(d-1) as limits have values in E_B (theorem 1 of spaces/stencils.py). The last component says that
c^k_(d-1) tends to ψ, which is in C^n. Let components l > j tend to f_l, and j < d-1. Component j says that
h^j Δ c^k_j = Σ_(l>j) h^l c^k_l/(l-j)! + o(h^(d-1)), so that Δ c^k_j/h tends to f_(j+1), uniformly. As supports are
bounded, sums of the differences from the left show that c^k_j tends to the integral f_j of f_(j+1). So the components
tend to f_0 and its derivatives; by locality those of all bounded c do. For the constants e_0 the limit is 1, and not 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import factorial

from flint import fmpq, fmpq_mat

Terms = Mapping[int, fmpq_mat]
"""The d×d matrices of a mask by their indices."""


def taylor_mask(p: int, terms: Terms) -> dict[int, fmpq_mat] | None:
    """The mask B, without zeros, with T S_A = p^-(d-1) S_B T; None where there is none of finite support.

    With T c(i) = U c(i+1) - V c(i) it is p^(d-1) (U A_(i+1) - V A_i) = B_(i+p) U - B_i V, which gives the columns of B
    one after the other, from the last index down.
    """
    d = next(iter(terms.values())).nrows()
    ahead, here = _taylor_operator(d)
    low, high = min(terms) - 1, max(terms)
    zero = fmpq_mat(d, d)
    mask: dict[int, fmpq_mat] = {}
    for i in range(high, low - p - 1, -1):
        image = (ahead * terms.get(i + 1, zero) - here * terms.get(i, zero)) * p ** (d - 1)
        rest = mask.get(i + p, zero) * ahead - image
        columns = fmpq_mat(d, d)
        for l in range(d):
            sign = 1 if l < d - 1 else -1  # that of the diagonal of V
            for k in range(d):
                before = sum((columns[k, q] * here[q, l] for q in range(l)), fmpq(0))
                columns[k, l] = sign * (rest[k, l] - before)
        if any(columns.entries()):
            mask[i] = columns
    return None if any(i < low for i in mask) else dict(sorted(mask.items()))


def _taylor_operator(d: int) -> tuple[fmpq_mat, fmpq_mat]:
    """The matrices U and V with T c(i) = U c(i+1) - V c(i)."""
    ahead, here = fmpq_mat(d, d), fmpq_mat(d, d)
    for j in range(d):
        ahead[j, j] = int(j < d - 1)
        for l in range(j, d):
            here[j, l] = fmpq(1, factorial(l - j)) if j < d - 1 else -1
    return ahead, here
