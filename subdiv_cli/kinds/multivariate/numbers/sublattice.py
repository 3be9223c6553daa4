"""The lattice that a mask stays in: the smallest Γ that holds all α - β, a_α and a_β ≠ 0, with MΓ ⊂ Γ.

Theorem. If Γ is not all of Z^s, S does not converge uniformly to a limit that is not zero for some data.

Proof. Let a_t ≠ 0, so that a_α ≠ 0 only for α in t + Γ. The indices of the mask a^[L] of S^L are γ_0 + Mγ_1 + … +
M^(L-1) γ_(L-1), each γ_j in t + Γ, and all lie in one coset t_L + Γ, as MΓ ⊂ Γ. Suppose that S^L δ = a^[L] tends to
φ(M^-L ·) uniformly, φ continuous. Let x be in R^s. For each L there is an index α_L outside of t_L + Γ whose distance
to M^L x is at most a constant: among an index y and y + e_1, …, y + e_s one is outside, as otherwise all e_i, the
differences, would be in Γ, and so Z^s. M is expanding, so M^-L α_L tends
to x, and φ(x) = lim φ(M^-L α_L) = lim a^[L](α_L) = 0. So φ = 0, and the limit of any data, locally a finite sum of
shifts of φ by linearity, is 0.

Γ is spanned by the M^j (α - t), j < s (Cayley & Hamilton). Where it is not Z^s there are u and n with u·x = 0 modulo n
for all x in Γ, and u ≠ 0 modulo n: of a lattice of index n a column of the adjugate of a basis, as rows, and instead of
n its smallest prime factor; n = 2 where the rank is less than s, as then the rank modulo 2 is.
"""

from __future__ import annotations

from math import gcd
from typing import NamedTuple

from flint import fmpq_mat, fmpz_mat, nmod_mat

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.spaces.lattice import Index, Lattice

_LARGEST = 10_000
"""The largest modulus: the checker reads no larger numbers here."""


class Sublattice(NamedTuple):
    """A lattice Γ that is not Z^s: u·x = 0 modulo n for all its x, and u ≠ 0 modulo n."""

    cosets: int | None
    """The index of Γ in Z^s, the number of its cosets; None where that is not finite."""
    functional: Index
    """u."""
    modulus: int
    """n."""


def sublattice(scheme: MultivariateScheme, lattice: Lattice) -> Sublattice | None:
    """The lattice that the mask stays in; None where that is Z^s, or where its index has no small enough divisor."""
    s, first = lattice.dimension, min(scheme.terms)
    rows = [tuple(i - j for i, j in zip(alpha, first, strict=True)) for alpha in scheme.terms]
    every = list(rows)
    for _ in range(s - 1):
        rows = [lattice.image(alpha) for alpha in rows]
        every += rows
    if len(every) < s:
        every += [(0,) * s] * s
    basis = fmpz_mat([list(row) for row in every]).hnf()
    square = fmpz_mat([[int(x) for x in row] for row in basis.tolist()[:s]])
    index = abs(int(square.det()))
    if index == 1:
        return None
    if index == 0:
        kernel, _ = nmod_mat(s, s, [int(x) % 2 for x in square.entries()], 2).nullspace()
        return Sublattice(None, tuple(int(kernel[i, 0]) for i in range(s)), 2)
    adjugate = fmpq_mat(square).inv() * index  # up to its sign
    for column in adjugate.transpose().tolist():
        u = [int(x.p) for x in column]
        common = gcd(index, *u)
        n = index // common  # no prime factor of it divides all of u / common
        if (q := next((q for q in range(2, _LARGEST + 1) if n % q == 0), None)) is not None:
            return Sublattice(index, tuple(x // common % q for x in u), q)
    return None
