"""A reducible family taken apart, exactly, into diagonal blocks along a flag of common invariant subspaces.

Products of block triangular matrices have the products of the blocks on their diagonal, so the joint spectral radius
is the largest of those of the blocks.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import fmpq_mat, fmpz_mat

from subdiv_cli.exact.linalg import identity, matrix, nullspace, reduced
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.subspace import invariant_subspace
from subdiv_cli.jsr.symmetry import reversing
from subdiv_cli.model import Look, no_clock

_BITS = 32
"""The bits of the weight of functionals against coordinates in lattice reduction."""


class Blocks(NamedTuple):
    """P^(-1) M_i P is block upper triangular for all i; the parts are the families of its diagonal blocks."""

    basis: fmpq_mat
    """The matrix P."""
    parts: tuple[Family, ...]


def decomposed(family: Family, look: Look = no_clock) -> Blocks | None:
    """The blocks that cannot be taken apart further, as far as is known; None for a single one.

    A block with a symmetry has a basis in which it is the reversal. Raises what `look` raises.
    """
    basis, sizes = _flag(family.matrices, look)
    if len(sizes) == 1:
        return None
    blocks = _blocks(family, basis, sizes)
    look()
    turns = [reversing(part) for part in blocks.parts]
    if all(turn is None for turn in turns):
        return blocks
    bases = [identity(size) if turn is None else turn for turn, size in zip(turns, sizes, strict=True)]
    return _blocks(family, basis * _diagonal_sum(bases), sizes)


def by_pattern(family: Family) -> Blocks | None:
    """The blocks that a permutation of the coordinates shows; None for a single one."""
    if (components := _by_pattern(family.matrices)) is None:
        return None
    basis = _units([i for component in components for i in component], family.order).transpose()
    return _blocks(family, basis, [len(component) for component in components])


def _flag(matrices: Sequence[fmpq_mat], look: Look) -> tuple[fmpq_mat, list[int]]:
    """A basis of Z^N, the columns of an N×N matrix, along a flag of invariant subspaces, and the blocks' sizes.

    The first columns span 0 ⊂ U_1 ⊂ U_2 ⊂ … in turn. As the basis is one of Z^N, the denominators of the blocks are no
    larger than those of the matrices.
    """
    n = matrices[0].nrows()
    if (components := _by_pattern(matrices)) is not None:
        basis = _units([i for component in components for i in component], n).transpose()
        steps = [len(component) for component in components]
    elif n > 1 and (rows := invariant_subspace(matrices, look)) is not None:
        basis, steps = _lattice_basis(rows), [rows.nrows(), n - rows.nrows()]
    else:
        return identity(n), [n]
    parts = [_flag(part, look) for part in _diagonal(matrices, basis, steps)]
    return basis * _diagonal_sum([part for part, _ in parts]), [size for _, sizes in parts for size in sizes]


def _units(places: Sequence[int], n: int) -> fmpq_mat:
    """The rows of the n×n identity at these places."""
    return fmpq_mat(len(places), n, [int(i == j) for i in places for j in range(n)])


def _diagonal_sum(parts: Sequence[fmpq_mat]) -> fmpq_mat:
    n, start = sum(part.nrows() for part in parts), 0
    rows = []
    for part in parts:
        rows += [[0] * start + row + [0] * (n - start - len(row)) for row in part.tolist()]
        start += part.nrows()
    return fmpq_mat(rows)


def _lattice_basis(subspace: fmpq_mat) -> fmpq_mat:
    """A basis of Z^N as columns: first of the integer vectors in the row space of `subspace`, then others, all short.

    With L a basis of the integer functionals that vanish there, the vectors (w L x, x) for x in Z^N are a lattice in
    which, for a large weight w, those with L x = 0 are the shortest: lattice reduction finds them first.
    """
    n, functionals = subspace.ncols(), reduced(matrix(nullspace(subspace)))
    values = functionals.numer_denom()[0].transpose().tolist()
    units, bits = identity(n).numer_denom()[0].tolist(), _BITS
    while True:
        rows = fmpz_mat([[x << bits for x in value] + unit for value, unit in zip(values, units, strict=True)]).lll()
        if not any(x for row in rows.tolist()[: subspace.nrows()] for x in row[:-n]):
            return fmpq_mat(fmpz_mat([row[-n:] for row in rows.tolist()]).transpose())
        bits += _BITS


def _blocks(family: Family, basis: fmpq_mat, sizes: Sequence[int]) -> Blocks:
    return Blocks(basis, tuple(Family(part) for part in _diagonal(family.matrices, basis, sizes)))


def _diagonal(matrices: Sequence[fmpq_mat], basis: fmpq_mat, sizes: Sequence[int]) -> list[list[fmpq_mat]]:
    """The diagonal blocks of all matrices. Raises ArithmeticError where these are not block upper triangular."""
    inverse, n = basis.inv(), basis.nrows()
    turned = [(inverse * m * basis).table() for m in matrices]
    parts, start = [], 0
    for size in sizes:
        inside = range(start, start + size)
        if any(table[i][j] for table in turned for i in range(start + size, n) for j in inside):
            raise ArithmeticError("no common invariant subspace")
        parts.append([fmpq_mat([[table[i][j] for j in inside] for i in inside]) for table in turned])
        start += size
    return parts


def _by_pattern(matrices: Sequence[fmpq_mat]) -> list[list[int]] | None:
    """The lists of coordinates of blocks that a permutation of the coordinates shows; None for a single one.

    They are the strong components of the graph i -> j where some entry (i, j) is not zero, every arrow forwards. By
    transitive closure: i and j belong together if each reaches the other; components are sorted by how many they reach.
    """
    n = matrices[0].nrows()
    tables = [m.table() for m in matrices]
    reach = [{j for j in range(n) if any(t[i][j] for t in tables)} | {i} for i in range(n)]
    for k in range(n):
        for i in range(n):
            if k in reach[i]:
                reach[i] |= reach[k]
    classes = {frozenset(j for j in reach[i] if i in reach[j]) for i in range(n)}
    components = sorted((sorted(c) for c in classes), key=lambda c: (-len(reach[c[0]]), c))
    return components if len(components) > 1 else None
