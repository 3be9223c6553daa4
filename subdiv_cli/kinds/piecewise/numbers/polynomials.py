"""The sequences whose limits are polynomials: S Q = Q σ, where Q on each side is that of its mask (A. Levin 2003, 3.3).

S q_d = p^-d q_d with q_d on each side, far from 0, the polynomial in the index that the mask of the side has for x^d:
then F is x^d for the data q_d, if S converges (Lemma 3.2), and Q x^d = q_d defines Q with S Q = Q σ, σ f = f(·/p). A
mask has such a polynomial, h^d i^d plus lower powers, iff the sums Σ a_γ γ^l over γ = ε mod p do not depend on ε for
l <= d, and one alone: with M_l these sums, coefficient m of S q is Σ_r c_r p^-r C(r, m) (-1)^(r-m) M_(r-m). q_d is that
of the sides where all cells of theorem 2 in `functionals` have their data, and what S makes of it beyond: what is open
are finitely many values, for which S q_d = p^-d q_d on the window is a linear system.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb, factorial

from flint import fmpq_mat

from subdiv_cli.exact.linalg import identity, solution
from subdiv_cli.exact.rationals import to_fmpq, to_fraction
from subdiv_cli.kinds.piecewise.numbers.functionals import Cells, Functionals
from subdiv_cli.kinds.scalar.scheme import ScalarScheme

Polynomial = tuple[Fraction, ...]
"""The coefficients of 1, t, t², …"""


def eigen_polynomials(mask: ScalarScheme, spacing: Fraction) -> tuple[Polynomial, ...]:
    """The polynomials q_0, q_1, … in the index with S q_d = p^-d q_d that lead (spacing t)^d, as many as there are."""
    p, sums, results = mask.arity, list[Fraction](), list[Polynomial]()
    while (total := _common_sum(mask, len(sums))) is not None and (sums or total == 1):
        sums.append(total)
        d = len(results)
        c = [Fraction(0)] * d + [spacing**d]
        for m in range(d - 1, -1, -1):
            rest = sum(
                (c[r] * comb(r, m) * (-1) ** (r - m) * sums[r - m] / p**r for r in range(m + 1, d + 1)), Fraction(0)
            )
            c[m] = rest / (Fraction(1, p**d) - Fraction(1, p**m))
        results.append(tuple(c))
    return tuple(results)


def _common_sum(mask: ScalarScheme, order: int) -> Fraction | None:
    """The sum Σ a_γ γ^order over each residue class; None where they are not the same for all."""
    sums = [Fraction(0)] * mask.arity
    for gamma, a in enumerate(mask.coefficients, mask.start):
        sums[gamma % mask.arity] += a * gamma**order
    return sums[0] if len(set(sums)) == 1 else None


def at(q: Sequence[Fraction], t: int) -> Fraction:
    """The value of a polynomial."""
    return sum((c * t**r for r, c in enumerate(q)), Fraction(0))


def sequences(functionals: Functionals) -> tuple[tuple[Fraction, ...], ...]:
    """The values of q_0, q_1, … on the window, as many as there are one after the other."""
    left, right = (eigen_polynomials(cells.mask, cells.spacing) for cells in functionals.cells)
    results: list[tuple[Fraction, ...]] = []
    for polynomials in zip(left, right, strict=False):
        values = _sequence(functionals, polynomials)
        if values is None:
            break
        results.append(values)
    return tuple(results)


def _sequence(functionals: Functionals, polynomials: Sequence[Polynomial]) -> tuple[Fraction, ...] | None:
    """The values of q_d, d the degree of the polynomials of both sides; None where there is no such sequence."""
    window, a = functionals.window, functionals.refinement
    given_twice = known_values(functionals.cells, polynomials)
    known = dict(given_twice)
    if any(known[i] != x for i, x in given_twice):
        return None
    degree, size = len(polynomials[0]) - 1, len(window)
    system = a - identity(size) * to_fmpq(Fraction(1, functionals.scheme.arity**degree))
    rows = system.tolist()
    open_places = [place for place, i in enumerate(window) if i not in known]
    given = [(place, known[i]) for place, i in enumerate(window) if i in known]
    right = [-sum((to_fraction(row[j]) * x for j, x in given if row[j]), Fraction(0)) for row in rows]
    if not open_places:
        return tuple(known[i] for i in window) if not any(right) else None
    solved = solution(fmpq_mat([[row[j] for j in open_places] for row in rows]), right)
    if solved is None:
        return None
    values = known | {window[place]: x for place, x in zip(open_places, solved, strict=True)}
    return tuple(values[i] for i in window)


def known_values(cells: Sequence[Cells], polynomials: Sequence[Polynomial]) -> list[tuple[int, Fraction]]:
    """The values of q_d where the cells of both sides have their data."""
    return [(i, at(q, i)) for side, q in zip(cells, polynomials, strict=True) for i in side.points]


def operator(polynomials: Sequence[Polynomial]) -> tuple[Fraction, ...]:
    """The coefficients c_d with Q f(i) = Σ c_d f^(d)(x_i) on polynomials, of a side alone: c_d = q_d(0)/d!."""
    return tuple(q[0] / factorial(d) for d, q in enumerate(polynomials))
