"""The rules on constants, polynomial eigen-sequences and limit stencils of a mask of matrices. See FORMAT.md."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb
from operator import mul

from subdiv_cli.checker import matrices
from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import Matrix
from subdiv_cli.checker.reading import require, require_few
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.spans import are_independent, scaled
from subdiv_cli.checker.vector.masks import (
    MatrixMask,
    VectorSequence,
    mask_of,
    nonzero,
    rank,
    sequence,
    total,
)

Vectors = list[tuple[Fraction, ...]]
_MAX_DEGREE = 100


def constants(c: Claim) -> Vectors:
    """E_A = {u : A^ε u = u for all ε} has the dimension r: a basis, and m - r independent equations."""
    r, a = c.statement["dimension"], mask_of(c)
    c.count((a.entries + a.arity * a.size**2) * (r + 1), a.bits + most_bits(c.witness["basis"]))
    return check_constants(a, r, c.witness["basis"])


def check_constants(a: MatrixMask, r: int, basis: Sequence[Sequence[Fraction]]) -> Vectors:
    """The r vectors of the basis of E_A. Raises Rejected where they are none, or E_A is larger."""
    m, sums = a.size, a.sums()
    require(len(basis) == r and all(len(u) == m for u in basis), "the basis has not r vectors of m entries")
    integers = [scaled(u)[0] for u in basis]
    for number, u in enumerate(integers):
        same = all(matrices.apply(s, u) == [a.denominator * x for x in u] for s in sums)
        require(same, f"vector {number} is not reproduced as a constant")
    require(are_independent(integers), "the vectors are dependent modulo 2^61 - 1")
    equations = [
        [x - (a.denominator if i == j else 0) for j, x in enumerate(row)] for s in sums for i, row in enumerate(s)
    ]
    require(rank(equations) >= m - r, "the equations of E_A are of smaller rank modulo 2^61 - 1")
    return [tuple(u) for u in basis]


def mean_matrix(c: Claim) -> None:
    """det(x - M_A) = (x-1)^r g, all zeros of g inside the unit circle, or not; M_A = (1/p) Σ A_i, r = dim E_A > 0."""
    a, m = mask_of(c), mask_of(c).size
    c.count(a.entries + m**4, m * (a.bits + a.arity.bit_length()))
    r = c.use("constants").statement["dimension"]
    require(r > 0, "there are no constants")
    mean = [[sum(column) for column in zip(*rows, strict=True)] for rows in zip(*a.sums(), strict=True)]
    g, unit = matrices.characteristic_polynomial(mean), a.arity * a.denominator
    for _ in range(r):
        g, remainder = _divided(g, unit)
        require(remainder == 0, "1 is not an eigenvalue r times")
    inside = matrices.roots_lie_inside(g, Fraction(unit))
    require(inside is c.statement["holds"], f"it is {str(inside).lower()}")


def _divided(f: Sequence[int], x: int) -> tuple[list[int], int]:
    """The quotient of f by z - x, and the remainder, lowest power first."""
    quotient, carry = [], 0
    for coefficient in reversed(f):
        carry = coefficient + x * carry
        quotient.append(carry)
    return quotient[-2::-1], quotient[-1]


def eigen_sequences(c: Claim) -> None:
    """k is the largest order with sequences S y = p^-j y of every exact degree j < k that lead in all of E_A.

    With y(i) = Σ_l c_l i^l it is Σ_l C(l,t) (Σ_β (-β)^(l-t) A_(ε+pβ) - p^(t-j) ε^(l-t)) c_l = 0 for all ε, t; so c_j is
    in E_A. Of degree k the equations, with multipliers, add up to g·c_k = 0, g not 0 on E_A.
    """
    used, a, k = c.use("constants"), mask_of(c), c.statement["order"]
    r, basis = used.statement["dimension"], used.result
    if not r:
        c.count(1)
        require(k == 0 and not c.witness, "without constants the order is 0, and there is no witness")
        return
    require(bool(c.witness), "the witness is empty")
    require_few(k <= _MAX_DEGREE, "the order is too large")
    p, m, sequences = a.arity, a.size, c.witness["sequences"]
    functional, multipliers = c.witness["functional"], c.witness["multipliers"]
    bits = max(most_bits(rows) for rows in (*sequences, [functional, multipliers], basis))
    index = max(abs(a.start), abs(a.start + len(a.matrices))).bit_length() + p.bit_length()
    c.count((r + 1) * (k + 1) ** 3 * (p * m * m + len(a.matrices)) + a.entries * (k + 1), a.bits + bits + k * index)
    require(len(sequences) == k, "there are not sequences of every degree below the order")
    moments = _moments(a, k + 1)
    for j, rows in enumerate(sequences):
        require(len(rows) == r and all(len(y) == m * (j + 1) for y in rows), f"those of degree {j} are not r")
        for y in rows:
            for epsilon in range(p):
                for t in range(j + 1):
                    equation = _equation(a, moments, epsilon, t, j)
                    require(not any(matrices_times(equation, y)), f"one of degree {j} is no eigen-sequence")
        require(are_independent([scaled(y[-m:])[0] for y in rows]), f"those of degree {j} lead in dependent vectors")
    require(len(functional) == m and len(multipliers) == p * m * (k + 1), "the functional is of another length")
    sums, place = [Fraction(0)] * (m * (k + 1)), 0
    for epsilon in range(p):
        for t in range(k + 1):
            for row in _equation(a, moments, epsilon, t, k):
                if weight := multipliers[place]:
                    sums = [x + weight * y for x, y in zip(sums, row, strict=True)]
                place += 1
    require(sums == [*(Fraction(0),) * (m * k), *functional], "the equations do not add up to the functional")
    require(any(sum(map(mul, functional, u)) for u in basis), "the functional is 0 on E_A")


def _moments(a: MatrixMask, count: int) -> list[list[Matrix]]:
    """The numerators of Σ_β (-β)^n A_(ε+pβ) for every ε and n < count."""
    zero = [[0] * a.size for _ in range(a.size)]
    conditions = [[zero] * count for _ in range(a.arity)]
    for i, matrix in enumerate(a.matrices, a.start):
        beta, epsilon = divmod(i, a.arity)
        for n in range(count):
            conditions[epsilon][n] = [
                [x + (-beta) ** n * y for x, y in zip(*rows, strict=True)]
                for rows in zip(conditions[epsilon][n], matrix, strict=True)
            ]
    return conditions


def _equation(a: MatrixMask, moments: list[list[Matrix]], epsilon: int, t: int, j: int) -> list[list[Fraction]]:
    """The m rows of the equation of ε and t for sequences of degree j."""
    rows: list[list[Fraction]] = [[] for _ in range(a.size)]
    for l in range(j + 1):
        shift = Fraction(a.arity) ** (t - j) * epsilon ** (l - t) if l >= t else Fraction(0)
        for i, row in enumerate(rows):
            for column in range(a.size):
                entry = Fraction(moments[epsilon][l - t][i][column], a.denominator) if l >= t else Fraction(0)
                row.append(comb(l, t) * (entry - (shift if i == column else 0)))
    return rows


def matrices_times(rows: Sequence[Sequence[Fraction]], y: Sequence[Fraction]) -> list[Fraction]:
    """The products of rows with a vector."""
    return [sum(map(mul, row, y), Fraction(0)) for row in rows]


def generation(c: Claim) -> None:
    """S maps vector polynomials of degree k - 1 that lead in E_A to such ones, and not those of degree k."""
    c.count(1)
    order = c.use("eigen-sequences").statement["order"]
    require(order > 0 and c.statement["degree"] == order - 1, f"the eigen-sequences are of order {order}")


def limit_stencils(c: Claim) -> tuple[list[VectorSequence], int]:
    """T_0 w_i = w_i and Σ w_i · u_j = δ_ij: if S converges, these r sequences give its limits. Over a denominator."""
    a, start, rows = mask_of(c), c.witness["start"], c.witness["rows"]
    used = c.use("constants")
    r, basis = used.statement["dimension"], used.result
    require(c.statement["count"] == r == len(rows) > 0, "they are not as many as the constants")
    sequences, denominator = _fixed(c, a, start, rows)
    for i, w in enumerate(sequences):
        sums = total(w, a.size)
        for j, u in enumerate(basis):
            require(sum(map(mul, u, sums), Fraction(0)) == denominator * (i == j), f"stencil {i} is not dual to E_A")
    return sequences, denominator


def fixed_diverges(c: Claim) -> None:
    """S diverges: more independent sequences with T_0 v = v than E_A has dimensions, against theorem 2."""
    a, start, rows = mask_of(c), c.witness["start"], c.witness["rows"]
    r = c.use("constants").statement["dimension"]
    require(len(rows) == r + 1, "they are not one more than the constants")
    _fixed(c, a, start, rows)
    require(are_independent([scaled(row)[0] for row in rows]), "the sequences are dependent modulo 2^61 - 1")


def _fixed(c: Claim, a: MatrixMask, start: int, rows: Sequence[Sequence[Fraction]]) -> tuple[list[VectorSequence], int]:
    """The sequences, over one denominator. Raises Rejected where T_0 moves one of them."""
    m, length = a.size, len(rows[0])
    require(
        length > 0 and all(len(row) == length for row in rows) and length % m == 0,
        "the rows are not m entries for each index",
    )
    c.count(len(rows) * (length // m + 1) * a.entries + (len(rows) + a.size) ** 2 * length, a.bits + most_bits(rows))
    numerators, denominator = scaled([x for row in rows for x in row])
    sequences = [sequence(start, numerators[i : i + length], m) for i in range(0, len(numerators), length)]
    for number, w in enumerate(sequences):
        image = nonzero(a.images(w)[0])
        same = image == {i: [a.denominator * x for x in values] for i, values in w.items()}
        require(same, f"sequence {number} is not fixed")
    return sequences, denominator


def most_bits(rows: Sequence[Sequence[Fraction]]) -> int:
    """The bits of the longest entry, and as many again as a common denominator of a row may have."""
    return max((sum(map(fraction_bits, row)) for row in rows), default=0)
