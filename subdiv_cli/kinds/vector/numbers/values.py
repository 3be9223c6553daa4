"""Exact values of limits and of their derivatives, at the mask's own indices, by stencils.

With T_0 of the mask where it stands, not moved, w = T_0 w are the limit stencils at the integers: the limit F of data c
has there the coordinates f_i(a) = (w_i * c)(a) in the basis u of E_A, and f_i(p^-n a) = (w_i * S^n c)(a). Where all
limits are C^j, the j-th derivatives have the stencils d_i = lim p^(jn) T_0^n ∇^j w_i, as T_0^n ∇^j w_i is the j-th
difference of f_i with the step p^-n at a, a+p^-n, …. On the space that the T_0^n ∇^j w_i span the eigenvalue p^-j is
simple at most and all others are smaller: d_i = q(T_0) ∇^j w_i / q(p^-j), (x - p^-j) q(x) the minimal polynomial there,
or 0 where that has no such factor.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly

from subdiv_cli.exact.linalg import eigenvectors, matrix, nullspace
from subdiv_cli.exact.rationals import to_fmpq, to_fraction
from subdiv_cli.kinds.vector.numbers.vector import LARGEST_WINDOW, VectorNumbers
from subdiv_cli.model.blocks import Curve

MOST_VALUES = 20_000
"""The most values of one curve, about."""


class Stencils(NamedTuple):
    """A sequence of m-vectors for each i = 1 … r, on one interval of indices."""

    start: int
    each: tuple[fmpq_mat, ...]
    """For each i a matrix with a row of m entries for each index."""


def stencils(numbers: VectorNumbers, order: int = 0) -> Stencils | None:
    """The stencils of the derivatives of this order at the integers, of limits that are in C^order.

    None where the window is too large.
    """
    p, start, m = numbers.p, numbers.scheme.start, numbers.size
    last = start + len(numbers.matrices) - 1
    window = range(-(-start // (p - 1)) - 1, last // (p - 1) + order + 1)
    if m * len(window) > LARGEST_WINDOW or not numbers.constants:
        return None
    entries = [[fmpq(0)] * (m * len(window)) for _ in range(m * len(window))]
    for i, alpha in enumerate(window):
        for j, beta in enumerate(window):
            if 0 <= (k := p * alpha - beta - start) < len(numbers.matrices):
                rows = numbers.matrices[k].tolist()
                for a in range(m):
                    for b in range(m):
                        entries[m * i + a][m * j + b] = rows[b][a]
    operator = fmpq_mat(entries)
    kernel = matrix(eigenvectors(operator, 1))
    sums = fmpq_mat([[sum(row[a::m], fmpq(0)) for a in range(m)] for row in kernel.tolist()])
    dual = sums * matrix(numbers.constants).transpose()
    if dual.nrows() != dual.ncols() or dual.rank() < dual.nrows():
        return None
    each = (dual.inv() * kernel).tolist()
    rows = [_derived(operator, _difference(row, m, order), Fraction(1, p**order)) for row in each] if order else each
    shaped = tuple(fmpq_mat([list(row[i : i + m]) for i in range(0, len(row), m)]) for row in rows)
    return Stencils(window[0], shaped)


def _difference(row: Sequence[fmpq], m: int, order: int) -> list[fmpq]:
    """The backward difference of a sequence that is zero at the end of its window."""
    values = list(row)
    for _ in range(order):
        values = [x - (values[i - m] if i >= m else 0) for i, x in enumerate(values)]
    return values


def _derived(operator: fmpq_mat, v: Sequence[fmpq], eigenvalue: Fraction) -> list[fmpq]:
    """The part of a vector in the eigenspace of this eigenvalue, of which it has no other generalised eigenvectors."""
    columns = [fmpq_mat([[x] for x in v])]
    while True:
        krylov = fmpq_mat([column.entries() for column in columns])
        if relation := nullspace(krylov.transpose()):
            break
        columns.append(operator * columns[-1])
    minimal, x = fmpq_poly([to_fmpq(c) for c in relation[0]]), to_fmpq(eigenvalue)
    if minimal(x) != 0:
        return [fmpq(0)] * len(v)
    q = divmod(minimal, fmpq_poly([-x, 1]))[0]
    total = sum((column * c for column, c in zip(columns, list(q), strict=False)), columns[0] * 0)
    return [entry / q(x) for entry in total.entries()]


def limit_curves(numbers: VectorNumbers, order: int, points: int) -> tuple[Curve, ...]:
    """The coordinates f_i of the limits for the data e_l δ, and their derivatives, up to this order, l by l.

    All limits must be C^order. Empty where the window is too large.
    """
    p, m, start = numbers.p, numbers.size, numbers.scheme.start
    last = start + len(numbers.matrices) - 1
    support, r = (Fraction(start, p - 1) - 1, Fraction(last, p - 1) + 1), len(numbers.constants)
    level, length = 0, support[1] - support[0]
    while length * p**level < points and length * p ** (level + 1) <= MOST_VALUES:
        level += 1
    curves = []
    each = [stencils(numbers, j) for j in range(order + 1)]
    for unit in range(m):
        fine, low = refined(numbers, unit, level)
        for j, stencil in enumerate(each):
            if stencil is None:
                return ()
            for i, w in enumerate(stencil.each):
                values = _paired(w, fine) * p ** (j * level)
                name, label = ("f" if r == 1 else f"f_{i + 1}"), (f"e_{unit + numbers.scheme.first}" if m > 1 else "")
                curves.append(_curve(p, level, low + stencil.start, values, j, name, label))
    return tuple(curves)


def _curve(p: int, level: int, low: int, values: fmpq_poly, order: int, name: str, label: str) -> Curve:
    """The curve of these values, without zeros at its ends."""
    coefficients = [to_fraction(x) for x in values] or [Fraction(0)]
    first = next((i for i, x in enumerate(coefficients) if x), 0)
    support = (Fraction(low + first - 1, p**level), Fraction(low + len(coefficients), p**level))
    return Curve(p, level, low + first, tuple(coefficients[first:]), support, order, name, label)


def refined(numbers: VectorNumbers, unit: int, level: int) -> tuple[list[fmpq_poly], int]:
    """The components of S^level (e_l δ), as polynomials, and the index of their first coefficients."""
    p, m, matrices = numbers.p, numbers.size, numbers.matrices
    symbol = [[fmpq_poly([a[k, l] for a in matrices]) for l in range(m)] for k in range(m)]
    data, low = [fmpq_poly([int(k == unit)]) for k in range(m)], 0
    for _ in range(level):
        spread = [_spread(f, p) for f in data]
        data = [sum((a * f for a, f in zip(row, spread, strict=True)), fmpq_poly([0])) for row in symbol]
        low = p * low + numbers.scheme.start
    return data, low


def _spread(f: fmpq_poly, p: int) -> fmpq_poly:
    coefficients = [fmpq(0)] * (p * len(f))
    coefficients[::p] = list(f)
    return fmpq_poly(coefficients)


def _paired(w: fmpq_mat, data: Sequence[fmpq_poly]) -> fmpq_poly:
    """The convolution Σ_j w(j)·c(· - j)."""
    columns = w.transpose().tolist()
    return sum((fmpq_poly(list(column)) * f for column, f in zip(columns, data, strict=True)), fmpq_poly([0]))
