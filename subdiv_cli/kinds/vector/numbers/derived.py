"""The derived schemes of Moosmüller & Dyn 2018, section 4, for any arity, and the norms by which they contract.

A canonical transformation R of a mask has a basis of E_A in its first r columns; the others span the invariant space of
M_A = (1/p) Σ A_i for its eigenvalues other than 1, the image of M_A - 1 where 1 has the multiplicity r. With
Δ_r = diag(Δ I, I), Δ I of r components, and Ā_i = R^-1 A_i R there is a mask ∂A with Δ_r S_Ā = (1/p) S_∂A Δ_r, namely

    (∂A)(z) = p diag(z^-1 - 1, 1) Ā(z) diag(z^-p - 1, 1)^-1.

Theorem 9: S converges if ((1/p) S_∂A)^L has a norm below 1 for some L; the entries of Δ_r S^n c are then decaying. It
needs E_A alone to be spanned by the first r columns. Theorem 11: if S_∂A is C^n, then S is C^(n+1): p^n Δ_r S_Ā^n c
converges uniformly, and what it converges to are the derivatives of the first r components; the others are 0.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import lcm
from typing import NamedTuple

from flint import fmpq_mat, fmpq_poly, fmpz_poly

from subdiv_cli.exact.linalg import Vector, identity, matrix, nullspace, reduced
from subdiv_cli.model import Effort

Terms = Mapping[int, fmpq_mat]
"""The matrices of a mask by their indices."""
_LEVELS = 24
_WORK = 4000
"""The most work for the norms of one scheme."""


class DerivedScheme(NamedTuple):
    """A mask that is derived from the one before."""

    transformation: fmpq_mat
    """The canonical transformation R, m×m, of the mask before."""
    constants: int
    """The number r of its columns in E_A."""
    terms: Terms
    norm: tuple[int, Fraction] | None
    """The pair (L, ‖((1/p) S)^L‖) with a norm below 1; None where none was found."""


class Derivation(NamedTuple):
    """Masks derived one from the other: S is C^(n-1) if the n-th one contracts."""

    steps: tuple[DerivedScheme, ...]

    @property
    def contracting(self) -> int:
        """The number n of the last scheme that contracts; 0 where none does."""
        return max((n for n, step in enumerate(self.steps, 1) if step.norm is not None), default=0)

    def on_line(self, j: int) -> bool:
        """Whether the first mask has a canonical transformation, and its constants are the multiples of e_j."""
        if not self.steps or self.steps[0].constants != 1:
            return False
        columns = self.steps[0].transformation
        return not any(columns[i, 0] for i in range(columns.nrows()) if i != j)


def derivation(p: int, terms: Terms, most: int, effort: Effort) -> Derivation:
    """The derived schemes, at most so many, up to the first that is not seen to contract."""
    steps: list[DerivedScheme] = []
    while len(steps) < most and (r := canonical_transformation(p, terms)) is not None:
        transformation, constants = r
        terms = derived(p, terms, transformation, constants)
        steps.append(DerivedScheme(transformation, constants, terms, contraction(p, terms, effort.limited(_WORK))))
        if steps[-1].norm is None:
            break
    return Derivation(tuple(steps))


def canonical_transformation(p: int, terms: Terms) -> tuple[fmpq_mat, int] | None:
    """The transformation R of a mask and the dimension r of E_A; None where r = 0 or 1 has another multiplicity."""
    constants, mean = constants_and_mean(p, terms)
    m, r, f = mean.nrows(), len(constants), mean.charpoly()
    for _ in range(r):
        f = divmod(f, fmpq_poly([-1, 1]))[0]
    if not r or f(1) == 0:
        return None
    columns = reduced(_independent(matrix(constants))).tolist()
    if r < m:
        columns += reduced(_independent((mean - identity(m)).transpose())).tolist()
    return fmpq_mat(columns).transpose(), r


def constants_and_mean(p: int, terms: Terms) -> tuple[tuple[Vector, ...], fmpq_mat]:
    """A basis of E_A, and the matrix M_A."""
    unit = identity(next(iter(terms.values())).nrows())
    sums = [sum((a for i, a in terms.items() if i % p == epsilon), unit * 0) for epsilon in range(p)]
    constants = nullspace(fmpq_mat([row for a in sums for row in (a - unit).tolist()]))
    return constants, sum(sums, unit * 0) / p


def _independent(rows: fmpq_mat) -> fmpq_mat:
    """A basis of the span of the rows."""
    echelon, rank = rows.rref()
    return fmpq_mat(echelon.tolist()[:rank])


def derived(p: int, terms: Terms, transformation: fmpq_mat, r: int) -> dict[int, fmpq_mat]:
    """The mask ∂A, without zeros: rows of Δ_r Ā, and the first r columns divided by z^-p - 1."""
    inverse, m = transformation.inv(), transformation.nrows()
    moved = {i: inverse * a * transformation * p for i, a in terms.items()}
    low, high = min(moved) - 1, max(moved)
    zero = identity(m) * 0
    image: dict[int, fmpq_mat] = {}
    for i in range(high, low - 1, -1):
        here, above = moved.get(i, zero).tolist(), moved.get(i + 1, zero).tolist()
        rows = [[y - x for x, y in zip(here[k], above[k], strict=True)] if k < r else here[k] for k in range(m)]
        before = image.get(i + p, zero).tolist()
        image[i] = fmpq_mat([[before[k][l] - rows[k][l] if l < r else rows[k][l] for l in range(m)] for k in range(m)])
    return {i: a for i, a in sorted(image.items()) if any(a.entries())}


def contraction(p: int, terms: Terms, effort: Effort) -> tuple[int, Fraction] | None:
    """The first level L with ‖((1/p) S)^L‖∞ < 1, and that norm; None where the effort ends before one is met."""
    low, m = min(terms), next(iter(terms.values())).nrows()
    common = lcm(*(int(a.numer_denom()[1]) for a in terms.values()))
    scaled = [(terms[i] * common).tolist() if i in terms else None for i in range(low, max(terms) + 1)]
    entries = [[fmpz_poly([int(rows[k][l].p) if rows else 0 for rows in scaled]) for l in range(m)] for k in range(m)]
    power, length = entries, max(f.degree() for row in entries for f in row) + 1
    for level in range(1, _LEVELS + 1):
        norm = Fraction(_norm(power, p**level), (common * p) ** level)
        if norm < 1:
            return level, norm
        if not effort.allows(length * p ** (level + 1) * m * m):
            return None
        spread = [[_spread(f, p**level) for f in row] for row in entries]
        power = [
            [
                sum((x * y for x, y in zip(row, column, strict=True)), fmpz_poly())
                for column in zip(*spread, strict=True)
            ]
            for row in power
        ]
    return None


def _spread(f: fmpz_poly, step: int) -> fmpz_poly:
    """The polynomial f(z^step)."""
    coefficients = [0] * ((len(f) - 1) * step + 1) if len(f) else []
    coefficients[::step] = [int(c) for c in f]
    return fmpz_poly(coefficients)


def _norm(power: Sequence[Sequence[fmpz_poly]], step: int) -> int:
    """The largest sum of |coefficients| of one row and of indices of one class modulo the step."""
    return max(
        sum(sum(abs(int(c)) for c in list(f)[gamma::step]) for f in row) for row in power for gamma in range(step)
    )
