"""Common invariant subspaces, exactly: a reducible family taken apart into diagonal blocks.

Products of block triangular matrices have the products of the blocks on their diagonal, so the joint spectral radius
is the largest of those of the blocks. Subspaces are found by the MeatAxe idea (Holt & Rees 1994): kernel vectors of
factors of the characteristic polynomial of a random element of the algebra, spun up under the family, and under its
transpose. Norton's criterion ends the search where some element proves that there are none over Q.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly, fmpz_poly, nmod_mat

from subdiv_cli.exact.linalg import at_matrix, identity, matrix, nullspace, reduced
from subdiv_cli.jsr.family import Family

_TRIES = 12
_PRIME = (1 << 61) - 1


class Blocks(NamedTuple):
    """P^(-1) M_i P is block upper triangular for all i; the parts are the families of its diagonal blocks."""

    basis: fmpq_mat
    """P."""
    parts: tuple[Family, ...]


def by_pattern(family: Family) -> Blocks | None:
    """Blocks that a permutation of the coordinates shows: the strong components of the entries that are not zero."""
    components = _components(family)
    if len(components) < 2:
        return None
    order = [i for component in components for i in component]
    n = family.order
    basis = fmpq_mat(n, n, [int(order[j] == i) for i in range(n) for j in range(n)])
    return _blocks(family, basis, [len(component) for component in components])


def by_subspace(family: Family) -> Blocks | None:
    """Two blocks from a common invariant subspace over Q; None where none is found, which is no proof of none."""
    for a, g in _elements(family):
        kernel_of = at_matrix(fmpq_poly(g), a)
        kernel = nullspace(kernel_of)
        if (basis := _spin(family.matrices, kernel[0])) is not None:
            return _two_blocks(family, basis)
        transposed = [m.transpose() for m in family.matrices]
        if (rows := _spin(transposed, nullspace(kernel_of.transpose())[0])) is not None:
            return _two_blocks(family, matrix(nullspace(fmpq_mat([list(row) for row in rows]))).tolist())
        if len(kernel) == g.degree():  # Norton's criterion: there is none
            return None
    return None


def decomposed(family: Family) -> Blocks | None:
    """Blocks that cannot be taken apart further, as far as is found; None for a single one."""
    flag = _flag(family)
    if len(flag) < 2:
        return None
    return _blocks(family, _orthogonal(flag), [step.nrows() for step in flag])


def _flag(family: Family) -> list[fmpq_mat]:
    """Rows that span 0 ⊂ U_1 ⊂ U_2 ⊂ …, invariant subspaces, when the next ones are added to all before them."""
    blocks = by_pattern(family) or by_subspace(family)
    if blocks is None:
        return [identity(family.order)]
    steps, rows, start = [], blocks.basis.transpose().tolist(), 0
    for part in blocks.parts:
        lifted = fmpq_mat(rows[start : start + part.order])
        steps += [step * lifted for step in _flag(part)]
        start += part.order
    return steps


def _orthogonal(flag: Sequence[fmpq_mat]) -> fmpq_mat:
    """Short integer columns that span the flag, those of a step orthogonal to all before them.

    So the numbers of the blocks do not grow from step to step, and their float copies are well conditioned.
    """
    before: list[fmpq_mat] = []
    for step in flag:
        for rows in before:
            step = step - step * rows.transpose() * (rows * rows.transpose()).inv() * rows
        before.append(reduced(step))
    return fmpq_mat([row for rows in before for row in rows.tolist()]).transpose()


def _elements(family: Family) -> Iterator[tuple[fmpq_mat, fmpz_poly]]:
    """Random elements of the algebra, and irreducible factors of their characteristic polynomials.

    Small factors first: their kernels are small, and the smaller a kernel the likelier it lies in a subspace.
    """
    generator = random.Random(family.order)
    for _ in range(_TRIES):
        a = identity(family.order) * 0
        for m in family.matrices:
            a = a + m * generator.randint(-3, 3)
        for _ in range(2):
            a = a + generator.choice(family.matrices) * generator.choice(family.matrices) * generator.randint(1, 3)
        factors = sorted((g for g, _ in a.charpoly().numer().factor()[1]), key=lambda g: int(g.degree()))
        yield from ((a, g) for g in factors[:3])


def _spin(matrices: Sequence[fmpq_mat], vector: Sequence[Fraction]) -> list[list[fmpq]] | None:
    """A basis of the smallest subspace that holds the vector and is mapped into itself; None where it is everything."""
    n = matrices[0].nrows()
    if _spins_everything(matrices, vector):
        return None
    rows = [_normal([fmpq(x.numerator, x.denominator) for x in vector], [])]
    if rows[0] is None:
        return None
    basis: list[tuple[int, list[fmpq]]] = [rows[0]]
    queue = [basis[0][1]]
    while queue and len(basis) < n:
        column = fmpq_mat([[x] for x in queue.pop(0)])
        for m in matrices:
            image = _normal((m * column).entries(), basis)
            if image is not None:
                basis.append(image)
                queue.append(image[1])
    return [row for _, row in basis] if len(basis) < n else None


def _spins_everything(matrices: Sequence[fmpq_mat], vector: Sequence[Fraction]) -> bool:
    """Whether the images of a vector span everything modulo a prime: then they do over Q."""
    try:
        letters = [_modulo(m) for m in matrices]
        span = _modulo(matrix([vector]))
    except ValueError:
        return False
    rank = 0
    while rank < span.nrows() < span.ncols() or not rank:
        rank = span.nrows()
        images = [row for letter in letters for row in (span * letter.transpose()).tolist()]
        echelon, size = nmod_mat([*span.tolist(), *images], _PRIME).rref()
        span = nmod_mat(echelon.tolist()[:size], _PRIME)
    return bool(span.nrows() == span.ncols())


def _modulo(m: fmpq_mat) -> nmod_mat:
    """Raises ValueError where the prime divides the denominator."""
    numerators, denominator = m.numer_denom()
    return nmod_mat(numerators, _PRIME) * pow(int(denominator), -1, _PRIME)


def _normal(row: list[fmpq], basis: list[tuple[int, list[fmpq]]]) -> tuple[int, list[fmpq]] | None:
    """What is left of a row modulo echelon rows, scaled to a leading 1, with the place of that; None for nothing."""
    for pivot, other in basis:
        if row[pivot]:
            factor = row[pivot]
            row = [x - factor * y for x, y in zip(row, other, strict=True)]
    first = next((i for i, x in enumerate(row) if x), None)
    return None if first is None else (first, [x / row[first] for x in row])


def _completed(basis: Sequence[Sequence[fmpq]]) -> fmpq_mat:
    """An invertible matrix (B, C): the columns of B span the subspace; with L B = 0 those of C are dual to the rows of

    L. Short vectors in B and L keep the numbers of the blocks small and their float copies well conditioned.
    """
    inside = reduced(fmpq_mat([list(row) for row in basis]))
    functionals = reduced(matrix(nullspace(inside)))
    dual = (functionals * functionals.transpose()).inv() * functionals
    return fmpq_mat(inside.tolist() + dual.tolist()).transpose()


def _two_blocks(family: Family, basis: Sequence[Sequence[fmpq]]) -> Blocks:
    return _blocks(family, _completed(basis), [len(basis), family.order - len(basis)])


def _blocks(family: Family, basis: fmpq_mat, sizes: Sequence[int]) -> Blocks:
    """Raises ArithmeticError where the matrices are not block upper triangular in this basis."""
    inverse = basis.inv()
    turned = [(inverse * m * basis).table() for m in family.matrices]
    parts, start = [], 0
    for size in sizes:
        inside = range(start, start + size)
        if any(table[i][j] for table in turned for i in range(start + size, family.order) for j in inside):
            raise ArithmeticError("no common invariant subspace")
        parts.append(Family([fmpq_mat([[table[i][j] for j in inside] for i in inside]) for table in turned]))
        start += size
    return Blocks(basis, tuple(parts))


def _components(family: Family) -> list[list[int]]:
    """Strong components of the graph i -> j where some entry (i, j) is not zero, every arrow forwards.

    By transitive closure: i and j belong together if each reaches the other; components are sorted by how many they
    reach.
    """
    n = family.order
    tables = [m.table() for m in family.matrices]
    reach = [{j for j in range(n) if any(t[i][j] for t in tables)} | {i} for i in range(n)]
    for k in range(n):
        for i in range(n):
            if k in reach[i]:
                reach[i] |= reach[k]
    classes = {frozenset(j for j in reach[i] if i in reach[j]) for i in range(n)}
    return sorted((sorted(c) for c in classes), key=lambda c: (-len(reach[c[0]]), c))
