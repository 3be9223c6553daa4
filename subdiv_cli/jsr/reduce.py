"""Common invariant subspaces, exactly: a reducible family taken apart into diagonal blocks.

Products of block triangular matrices have the products of the blocks on their diagonal, so the joint spectral radius
is the largest of those of the blocks. Subspaces are found by the MeatAxe idea (Holt & Rees 1994): kernel vectors of
factors of the characteristic polynomial of a random element of the algebra, spun up under the family, and under its
transpose. Norton's criterion, which some element satisfies, proves that there are none over Q.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly

from subdiv_cli.exact.linalg import at_matrix, identity, nullspace
from subdiv_cli.jsr.family import Family

_TRIES = 12


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
    for m in _kernels(family):
        for vector in nullspace(m)[:1]:
            if (basis := _spin(family.matrices, vector)) is not None:
                return _blocks(family, _completed(basis, family.order), [len(basis), family.order - len(basis)])
        for vector in nullspace(m.transpose())[:1]:
            transposed = [x.transpose() for x in family.matrices]
            if (rows := _spin(transposed, vector)) is not None:
                kernel = nullspace(fmpq_mat([list(row) for row in rows]))
                basis = [[fmpq(x.numerator, x.denominator) for x in v] for v in kernel]
                return _blocks(family, _completed(basis, family.order), [len(basis), family.order - len(basis)])
    return None


def _kernels(family: Family) -> list[fmpq_mat]:
    """g(A) for random elements A of the algebra and irreducible factors g of their characteristic polynomials.

    Small factors first: their kernels are small, and the smaller a kernel the likelier it lies in a subspace.
    """
    generator = random.Random(family.order)
    found = []
    for _ in range(_TRIES):
        a = identity(family.order) * 0
        for m in family.matrices:
            a = a + m * generator.randint(-3, 3)
        for _ in range(2):
            a = a + generator.choice(family.matrices) * generator.choice(family.matrices) * generator.randint(1, 3)
        factors = [g for g, _ in a.charpoly().numer().factor()[1]]
        found += [(g.degree(), at_matrix(fmpq_poly(g), a)) for g in factors[:3]]
    return [m for _, m in sorted(found, key=lambda pair: pair[0])]


def _spin(matrices: Sequence[fmpq_mat], vector: Sequence[Fraction]) -> list[list[fmpq]] | None:
    """A basis of the smallest subspace that holds the vector and is mapped into itself; None where it is everything."""
    n = matrices[0].nrows()
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


def _normal(row: list[fmpq], basis: list[tuple[int, list[fmpq]]]) -> tuple[int, list[fmpq]] | None:
    """What is left of a row modulo echelon rows, scaled to a leading 1, with the place of that; None for nothing."""
    for pivot, other in basis:
        if row[pivot]:
            factor = row[pivot]
            row = [x - factor * y for x, y in zip(row, other, strict=True)]
    first = next((i for i, x in enumerate(row) if x), None)
    return None if first is None else (first, [x / row[first] for x in row])


def _completed(basis: Sequence[Sequence[fmpq]], n: int) -> fmpq_mat:
    """An invertible matrix whose first columns are the basis, the others unit vectors."""
    echelon, rank = fmpq_mat([list(row) for row in basis]).rref()
    pivots = {next(j for j in range(n) if echelon[i, j]) for i in range(rank)}
    units = [[fmpq(int(i == j)) for i in range(n)] for j in range(n) if j not in pivots]
    return fmpq_mat([list(column) for column in (*basis, *units)]).transpose()


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
