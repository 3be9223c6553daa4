"""Linear equations over a number field Q(γ) = Q[x]/(g), its elements polynomials modulo an irreducible g."""

from __future__ import annotations

from collections.abc import Sequence

from flint import acb, fmpq_mat, fmpq_poly, fmpz_poly

from subdiv_cli.exact.algebraic import AlgebraicNumber, isolated_roots
from subdiv_cli.exact.enclosures import decide


def solve(columns: Sequence[Sequence[fmpq_poly]], target: Sequence[fmpq_poly], g: fmpq_poly) -> list[fmpq_poly] | None:
    """The only list x of rationals-modulo-g with Σ x_j columns_j = target; None where there is none, or more than one.

    `columns` are n columns of m field elements, `target` is one of m, and the answer has n; g is irreducible.
    """
    rows = [[*row, y] for *row, y in zip(*columns, target, strict=True)]
    unknowns = len(columns)
    for j in range(unknowns):
        pivot = next((i for i in range(j, len(rows)) if rows[i][j]), None)
        if pivot is None:
            return None
        rows[j], rows[pivot] = rows[pivot], rows[j]
        inverse = _inverse(rows[j][j], g)
        rows[j] = [(x * inverse) % g for x in rows[j]]
        for i, row in enumerate(rows):
            if i != j and row[j]:
                factor = row[j]
                rows[i] = [(x - factor * y) % g for x, y in zip(row, rows[j], strict=True)]
    if any(row[unknowns] for row in rows[unknowns:]):
        return None
    return [row[unknowns] for row in rows[:unknowns]]


def _inverse(x: fmpq_poly, g: fmpq_poly) -> fmpq_poly:
    """The inverse of a non-zero field element, a polynomial x modulo g."""
    common, inverse, _ = x.xgcd(g)
    return inverse / common[0]


def root_in_field(number: AlgebraicNumber, n: int) -> fmpq_poly | None:
    """The polynomial S with S(γ) = γ^(1/n) > 0 for a real γ > 0; None where this root is not in Q(γ).

    The root σ is one of f(x^n), f the minimal polynomial of γ. It is in Q(γ) iff its own degree is that of γ; then the
    powers of γ = σ^n are a basis of Q(σ), in which σ is written.
    """
    f, d = number.minimal_polynomial, number.minimal_polynomial.degree()
    stretched = fmpz_poly([0 if k % n else f[k // n] for k in range(n * d + 1)])
    factors = [h for h, _ in stretched.factor()[1]]

    def ask() -> fmpz_poly | None:
        root = number.enclosure().real.root(n)
        meeting = [h for h in factors for z in isolated_roots(h) if z.overlaps(acb(root))]
        return meeting[0] if len(meeting) == 1 else None

    if (h := decide(ask)).degree() != d:
        return None
    power, rows = fmpq_poly([1]), []
    for _ in range(d):
        rows.append([power[k] for k in range(d)])
        power = (power * fmpq_poly([0] * n + [1])) % fmpq_poly(h)
    sigma = fmpq_poly([0, 1]) % fmpq_poly(h)
    inverse = fmpq_mat(rows).inv()
    written = fmpq_mat([[sigma[k] for k in range(d)]]) * inverse
    return fmpq_poly(written.entries())
