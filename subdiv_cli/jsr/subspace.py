"""One common invariant subspace over Q, lifted from one modulo a prime and checked exactly.

The common kernel and the span of all images are looked at first: on the one, and modulo the other, all matrices are
zero. Others are sought by the MeatAxe idea (Holt & Rees 1994): kernel vectors of factors of the characteristic
polynomial of a random element of the algebra, spun up under the family, and under its transpose. The factors are those
over Q, so that a vector of the kernel modulo the prime is one over Q, reduced, and so is the space that it spans, which
is lifted to Q from its echelon form. Norton's criterion, modulo the prime, ends the search where there is none.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isqrt

from flint import fmpq_mat, fmpz_mod_ctx, fmpz_mod_mat, fmpz_poly

from subdiv_cli.exact.linalg import identity, matrix, nullspace
from subdiv_cli.model import Look, no_clock

_TRIES = 12
MODULI = (fmpz_mod_ctx((1 << 61) - 1), fmpz_mod_ctx((1 << 521) - 1))
"""The moduli, two primes; the second one is for subspaces of larger numbers."""


def invariant_subspace(matrices: Sequence[fmpq_mat], look: Look = no_clock) -> fmpq_mat | None:
    """A basis of a common invariant subspace, neither 0 nor everything: k rows of N, in reduced echelon form.

    All matrices M map it into itself by x -> M x. None where the search fails, which is no proof that there is none.
    Raises what `look` raises.
    """
    n = matrices[0].nrows()
    for rows in _candidates(matrices, look):
        look()
        echelon, rank = rows.rref()
        basis = fmpq_mat(echelon.tolist()[:rank])
        if 0 < rank < n and _is_invariant(matrices, basis):
            return basis
    return None


def _is_invariant(matrices: Sequence[fmpq_mat], basis: fmpq_mat) -> bool:
    columns = basis.transpose()
    functionals = matrix(nullspace(basis))
    return not any(any((functionals * (m * columns)).entries()) for m in matrices)


def _candidates(matrices: Sequence[fmpq_mat], look: Look) -> Iterator[fmpq_mat]:
    """Matrices whose rows may span an invariant subspace, or 0, or everything."""
    if kernel := nullspace(_stacked(matrices)):
        yield matrix(kernel)
    transposed = [m.transpose() for m in matrices]
    yield _stacked(transposed)
    for a, g in _elements(matrices):
        look()
        rows, nullity = _spun(matrices, a, g)
        if rows is not None:
            yield rows
        look()
        rows, _ = _spun(transposed, a.transpose(), g)
        if rows is not None:
            yield matrix(nullspace(rows))
        if nullity == g.degree():  # Norton's criterion: there is none, or it is of too large numbers
            return


def _spun(matrices: Sequence[fmpq_mat], a: fmpq_mat, g: fmpz_poly) -> tuple[fmpq_mat | None, int]:
    """The space that a vector of the kernel of g(a) spans under the matrices, and the dimension of that kernel.

    The space is None where it is everything or of too large numbers. Both answers are only likely, as all is modulo a
    prime.
    """
    nullity = 0
    for modulus in MODULI:
        try:
            letters = [modulo(m, modulus) for m in matrices]
            start, nullity = kernel(_at_matrix(g, modulo(a, modulus)))
        except ZeroDivisionError:  # the prime divides a denominator
            continue
        if not nullity or (rows := _spin(letters, start)) is None:
            break
        if (lifted := over_q(rows)) is not None:
            return lifted, nullity
    return None, nullity


def _stacked(matrices: Sequence[fmpq_mat]) -> fmpq_mat:
    return fmpq_mat([row for m in matrices for row in m.tolist()])


def _elements(matrices: Sequence[fmpq_mat]) -> Iterator[tuple[fmpq_mat, fmpz_poly]]:
    """Random N×N elements of the algebra, each with an irreducible factor of its characteristic polynomial.

    Small factors first: their kernels are small, and the smaller a kernel the likelier it lies in a subspace.
    """
    n = matrices[0].nrows()
    generator = random.Random(n)
    for _ in range(_TRIES):
        a = identity(n) * 0
        for m in matrices:
            a = a + m * generator.randint(-3, 3)
        for _ in range(2):
            a = a + generator.choice(matrices) * generator.choice(matrices) * generator.randint(1, 3)
        factors = sorted((g for g, _ in a.charpoly().numer().factor()[1]), key=lambda g: int(g.degree()))
        yield from ((a, g) for g in factors[:3])


def modulo(m: fmpq_mat, modulus: fmpz_mod_ctx) -> fmpz_mod_mat:
    """The matrix modulo a prime. Raises ZeroDivisionError where the prime divides the denominator."""
    numerators, denominator = m.numer_denom()
    return fmpz_mod_mat(numerators, modulus) * (1 / modulus(denominator))


def _at_matrix(f: fmpz_poly, a: fmpz_mod_mat) -> fmpz_mod_mat:
    modulus, n = fmpz_mod_ctx(a.modulus()), a.nrows()
    unit = fmpz_mod_mat(n, n, [int(i == j) for i in range(n) for j in range(n)], modulus)
    total = unit * 0
    for c in reversed(list(f)):
        total = total * a + unit * modulus(c)
    return total


def kernel(a: fmpz_mod_mat) -> tuple[fmpz_mod_mat, int]:
    """A vector of the kernel, as a row with a 1 in the first free place and 0 in the others; and the dimension."""
    echelon, rank = a.rref()
    n = a.ncols()
    pivots = [next(j for j in range(n) if echelon[i, j]) for i in range(rank)]
    row = [0] * n
    free = next((j for j in range(n) if j not in set(pivots)), None)
    if free is not None:
        row[free] = 1
        for i, pivot in enumerate(pivots):
            row[pivot] = -int(echelon[i, free])
    return fmpz_mod_mat([row], fmpz_mod_ctx(a.modulus())), n - rank


def _spin(letters: Sequence[fmpz_mod_mat], span: fmpz_mod_mat) -> fmpz_mod_mat | None:
    """The echelon form of all that a row spans under the matrices; None where that is everything."""
    transposed, rank = [letter.transpose() for letter in letters], 0
    modulus = fmpz_mod_ctx(span.modulus())
    while rank < span.nrows():
        rank = span.nrows()
        images = [row for letter in transposed for row in (span * letter).tolist()]
        echelon, size = fmpz_mod_mat([*span.tolist(), *images], modulus).rref()
        if size == span.ncols():
            return None
        span = fmpz_mod_mat(echelon.tolist()[:size], modulus)
    return span


def over_q(rows: fmpz_mod_mat) -> fmpq_mat | None:
    """The rows with the small fractions that their entries are modulo the prime; None where an entry is none."""
    prime = int(rows.modulus())
    known = {x: _fraction(x, prime) for x in {int(x) for x in rows.entries()}}
    if any(y is None for y in known.values()):
        return None
    return matrix([[known[int(x)] or 0 for x in row] for row in rows.tolist()])


def _fraction(x: int, prime: int) -> Fraction | None:
    """The fraction p/q ≡ x with |p| and q far below the square root of the prime; None where there is none.

    So few x have any, and none has two. By Euclid's algorithm (Wang 1981).
    """
    most = isqrt(prime) >> 8
    (r, s), (u, v) = (prime, x), (0, 1)
    while s > most:
        quotient = r // s
        (r, s), (u, v) = (s, r - quotient * s), (v, u - quotient * v)
    return Fraction(s, v) if abs(v) <= most else None
