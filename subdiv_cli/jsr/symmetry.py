"""A hidden symmetry of a family, P M_i = τ M_(p-1-i) P, made the reversal J of the coordinates by a change of basis.

Then polytopes need half of their vertices (`Family.symmetry`). A mask with a_(c-α) = a_α has it, on every block of its
transition operators. With R in the algebra of the M_i, and R' what it is of the M_(p-1-i), P R = R' P where R is a sum
of products of two: P takes eigenvectors of R to those of R', and what words make of the one to ±what the mirrored words
make of the other. So it is found modulo a prime, from simple eigenvalues there, lifted and checked exactly.
"""

from __future__ import annotations

import random
from collections.abc import Sequence

from flint import fmpq_mat, fmpz_mod_ctx, fmpz_mod_mat

from subdiv_cli.exact.linalg import eigenvectors, identity, matrix, reduced
from subdiv_cli.exact.rationals import to_fmpq, to_fraction
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.subspace import MODULI, kernel, modulo, over_q
from subdiv_cli.model import exact_root

_TRIES = 6
_SMALLEST_ORDER = 3


def reversing(family: Family) -> fmpq_mat | None:
    """An N×N matrix C with C^-1 M_(p-1-i) C = ± J C^-1 M_i C J for all i; None where none is needed or appears."""
    if family.letters < 2 or family.order < _SMALLEST_ORDER or family.symmetry or family.is_nonnegative:
        return None
    p = _intertwining(family.matrices)
    return None if p is None else _reversed_basis(p)


def _intertwining(matrices: Sequence[fmpq_mat]) -> fmpq_mat | None:
    """An N×N matrix P ≠ 0 with P M_i = ± M_(p-1-i) P, None if the search fails.

    In an irreducible family it is the only one up to factors.
    """
    for modulus in MODULI:
        try:
            letters = [modulo(m, modulus) for m in matrices]
        except ZeroDivisionError:  # the prime divides a denominator
            continue
        if (pair := _eigenvectors(letters)) is None:
            return None
        for sign in (1, -1):
            rows = _spun(letters, *pair, sign)
            p = None if rows is None else over_q(rows)
            if p is not None and all(p * a == b * p * sign for a, b in zip(matrices, reversed(matrices), strict=True)):
                return p
    return None


def _eigenvectors(letters: Sequence[fmpz_mod_mat]) -> tuple[fmpz_mod_mat, fmpz_mod_mat] | None:
    """Eigenvectors of R and of R', as rows, for an eigenvalue that is simple for both; None where there is none."""
    generator, n, modulus = random.Random(len(letters)), letters[0].nrows(), fmpz_mod_ctx(letters[0].modulus())
    for _ in range(_TRIES):
        r = mirrored = letters[0] * 0
        for _ in range(3):
            i, j, c = (*generator.choices(range(len(letters)), k=2), generator.randint(1, 9))
            r = r + letters[i] * letters[j] * modulus(c)
            mirrored = mirrored + letters[-1 - i] * letters[-1 - j] * modulus(c)
        if r.charpoly() != mirrored.charpoly():
            return None
        if (value := next((x for x, times in r.charpoly().roots() if times == 1), None)) is not None:
            scalar = fmpz_mod_mat(n, n, [int(value) * (i == j) for i in range(n) for j in range(n)], modulus)
            return kernel(r - scalar)[0], kernel(mirrored - scalar)[0]
    return None


def _spun(letters: Sequence[fmpz_mod_mat], v: fmpz_mod_mat, w: fmpz_mod_mat, sign: int) -> fmpz_mod_mat | None:
    """The N×N matrix P with P v = w and P M_i = sign M_(p-1-i) P on all that words make of v, some entry 1.

    None if that does not span.
    """
    n, modulus, transposed = letters[0].nrows(), fmpz_mod_ctx(v.modulus()), [m.transpose() for m in letters]
    images, mirrored, k = [v], [w], 0
    while k < len(images) < n:
        for i, m in enumerate(transposed):
            image = images[k] * m
            rows = fmpz_mod_mat([x.tolist()[0] for x in (*images, image)], modulus)
            if rows.rank() > len(images):
                images.append(image)
                mirrored.append(mirrored[k] * transposed[-1 - i] * modulus(sign))
        k += 1
    if len(images) < n:
        return None
    before, after = (fmpz_mod_mat([x.tolist()[0] for x in rows], modulus) for rows in (images, mirrored))
    p = before.solve(after).transpose()
    first = next((x for x in p.entries() if x), None)
    return None if first is None else p * (1 / first)


def _reversed_basis(p: fmpq_mat) -> fmpq_mat | None:
    """A basis c_1, …, c_N, as columns, with P c_j proportional to c_(N+1-j), all by one factor.

    None unless P is ∝ some C J C^-1.
    """
    n, square = p.nrows(), p * p
    c = to_fraction(square[0, 0])
    if c <= 0 or square != identity(n) * to_fmpq(c):
        return None
    root = [exact_root(x, 2) for x in (c.numerator, c.denominator)]
    if root[0] is None or root[1] is None:
        return None
    p = p * root[1] / root[0]
    even, odd = eigenvectors(p, 1), eigenvectors(p, -1)
    if len(even) < len(odd):
        even, odd = odd, even
    if not len(odd) <= len(even) <= len(odd) + 1:
        return None
    u, w = (reduced(matrix(rows)).tolist() for rows in (even, odd))
    plus = [[x + y for x, y in zip(a, b, strict=True)] for a, b in zip(u, w, strict=False)]
    minus = [[x - y for x, y in zip(a, b, strict=True)] for a, b in zip(u, w, strict=False)]
    return fmpq_mat([*plus, *u[len(w) :], *reversed(minus)]).transpose()
