"""Exact values of φ for a picture: at the integers from the limit stencil, then at finer points by refinement."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import lcm

from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import Drawing, Stencil

POINTS = 512
"""A curve has at most so many points, unless its support has more integers."""
LONGEST = 64
"""For longer windows the exact values are not worth their cost in a picture."""


def drawing(scheme: ScalarScheme, *, converges: bool) -> Drawing:
    """The refinement rules of a scheme, and where it converges its limit stencil and the curve of φ."""
    rules = tuple(_trimmed(rule(scheme, epsilon)) for epsilon in range(scheme.arity))
    values = integer_values(scheme) if converges else None
    if values is None:
        return Drawing(rules=rules)
    betas = sorted(-x for x in values)
    limit = Stencil(betas[0], tuple(values[-beta] for beta in betas))
    return Drawing(rules=rules, limit=_trimmed(limit), curve=curve(scheme, values))


def rule(scheme: ScalarScheme, epsilon: int) -> Stencil:
    """(S f)_(pk+ε) = Σ_j a_(ε-pj) f_(k+j); no weights where the class has no coefficients."""
    p, last = scheme.arity, scheme.start + scheme.degree
    first = -((last - epsilon) // p)
    weights = tuple(
        scheme.coefficients[k]
        for j in range(first, -(-(epsilon - scheme.start) // p) + 1)
        if 0 <= (k := epsilon - p * j - scheme.start) <= scheme.degree
    )
    return Stencil(first, weights)


def integer_values(scheme: ScalarScheme) -> dict[int, Fraction] | None:
    """φ at the integers of its support, for a scheme that converges; None where the support is long.

    The left eigenvector v of A_0[α,β] = a_(α-pβ) for the eigenvalue 1 with Σv = 1 has v_β = φ(-β) (Dyn 4.3, 4.6).
    Convergence makes it unique.
    """
    p, s, n = scheme.arity, scheme.start, scheme.degree
    window = range((p - 1 - s - n) // (p - 1), -(s // (p - 1)) + 1)
    if len(window) > LONGEST:
        return None

    def a(k: int) -> Fraction:
        return scheme.coefficients[k - s] if s <= k <= s + n else Fraction(0)

    rows = [[a(alpha - p * beta) - (alpha == beta) for alpha in window] + [Fraction(0)] for beta in window]
    rows.append([Fraction(1)] * (len(window) + 1))
    v = _solution(rows, len(window))
    return None if v is None else {-beta: value for beta, value in zip(window, v, strict=True)}


def curve(scheme: ScalarScheme, integers: Mapping[int, Fraction]) -> tuple[tuple[float, float], ...]:
    """φ at ℓ p^-k over its support, by φ(x) = Σ_j a_j φ(px - j) from the integers on; the values are exact until here.

    Integers over the common denominator D of the mask times the powers that refinement brings.
    """
    p = scheme.arity
    mask_denominator = lcm(*(c.denominator for c in scheme.coefficients))
    mask = [int(c * mask_denominator) for c in scheme.coefficients]
    denominator = lcm(*(v.denominator for v in integers.values()))
    values = {x: int(v * denominator) for x, v in integers.items() if v}
    step = 1
    while (scheme.degree // (p - 1) + 1) * step * p <= POINTS:
        values = _refined(mask, scheme.start, p, values, step)
        step, denominator = step * p, denominator * mask_denominator
    low, high = scheme.start * step // (p - 1), -(-(scheme.start + scheme.degree) * step // (p - 1))
    return tuple((x / step, values.get(x, 0) / denominator) for x in range(low, high + 1))


def _refined(mask: Sequence[int], start: int, p: int, values: Mapping[int, int], step: int) -> dict[int, int]:
    """The numerators at ℓ/(p step) from those at ℓ/step: φ(ℓ/(p step)) = Σ_j a_j φ(ℓ/step - j)."""
    finer: dict[int, int] = {}
    for x, value in values.items():
        for i, c in enumerate(mask):
            if c:
                at = x + (start + i) * step
                finer[at] = finer.get(at, 0) + c * value
    return finer


def _trimmed(stencil: Stencil) -> Stencil:
    """Without the zeros at its ends; without any weight where all are zero."""
    used = [i for i, weight in enumerate(stencil.weights) if weight]
    if not used:
        return Stencil(0, ())
    return Stencil(stencil.first + used[0], stencil.weights[used[0] : used[-1] + 1])


def _solution(rows: list[list[Fraction]], unknowns: int) -> list[Fraction] | None:
    """The unique solution of linear equations [coefficients…, right side]; None where it is not unique."""
    for column in range(unknowns):
        pivot = next((i for i in range(column, len(rows)) if rows[i][column]), None)
        if pivot is None:
            return None
        rows[column], rows[pivot] = rows[pivot], rows[column]
        lead = rows[column]
        inverse = 1 / lead[column]
        rows[column] = lead = [x * inverse for x in lead]
        for i, row in enumerate(rows):
            if i != column and (factor := row[column]):
                rows[i] = [x - factor * y for x, y in zip(row, lead, strict=True)]
    return [row[-1] for row in rows[:unknowns]]
