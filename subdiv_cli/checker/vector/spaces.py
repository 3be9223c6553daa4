"""The rules that introduce families: transition operators on an invariant space of sequences. See FORMAT.md.

The space U is spanned by the rows of a basis. Given sequences are replaced by their images, a tree whose leaves lie in
U: what products do to the sequences in the long run they do to the leaves.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb
from operator import mul

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily
from subdiv_cli.checker.reading import MAX_ORDER, require, require_few
from subdiv_cli.checker.roots import fraction_bits
from subdiv_cli.checker.spans import are_independent, depth_of, require_spanned, scaled
from subdiv_cli.checker.vector.masks import (
    MatrixMask,
    VectorSequence,
    lowest_terms,
    mask_of,
    nonzero,
    sequence,
    total,
)
from subdiv_cli.checker.vector.sequences import most_bits

_MAX_DIFFERENCES = 200
_MAX_NODES = 20_000
Generator = tuple[VectorSequence, int]
"""A sequence of numerators, and their denominator."""


def decay(c: Claim) -> None:
    """The new family is that of the T_ε on a space U in V_1 = {v : Σ v ⊥ E_A}, with the radius that they have on V_1.

    U holds images of the sequences e_l ∇δ and x δ, x in a basis of the complement of E_A, of whose shifts all of V_1
    are finite combinations; T_ε maps shifts to shifts.
    """
    a, m = mask_of(c), mask_of(c).size
    used = c.use("constants")
    constants, orthogonal = used.result, c.witness["orthogonal"]
    require(c.statement["order"] == 0, "the order is not 0")
    require(len(constants) > 0, "there are no constants")
    require(len(orthogonal) == m - len(constants), "the complement of E_A has another dimension")
    require(all(len(x) == m for x in orthogonal), "a vector has not m entries")
    units = [[int(i == j) for i in range(m)] for j in range(m)]
    generators: list[Generator] = [({0: unit, 1: [-x for x in unit]}, 1) for unit in units]
    for x in orthogonal:
        require(not any(sum(map(mul, u, x), Fraction(0)) for u in constants), "a vector is not orthogonal to E_A")
        numerators, denominator = scaled(x)
        generators.append(({0: numerators}, denominator))
    require(are_independent([v[0] for v, _ in generators[m:]]), "the vectors are dependent modulo 2^61 - 1")
    basis = invariant_space(c, a, generators)
    for number, row in enumerate(basis):
        sums = total(row, m)
        same = not any(sum(map(mul, u, sums), Fraction(0)) for u in constants)
        require(same, f"the sum of row {number} of the basis is not orthogonal to E_A")


def stencil_differences(c: Claim) -> None:
    """The new family is that of the T_ε on a space U of images of the ∇^k w_i, spanned by words applied to leaves.

    w are limit stencils, k > 0: if S converges, max ‖T_word | U‖ over words of length L is, up to constants, the size
    of the k-th differences of the limits with the step p^-L. N words of matrices on U, applied to leaves, are
    independent modulo a prime.
    """
    a, k = mask_of(c), c.statement["order"]
    require(k >= 1, "the order is not positive")
    require_few(k <= _MAX_DIFFERENCES, "the order is too large")
    stencils, denominator = c.use("limit-stencils").result
    generators = [lowest_terms(difference(w, k), denominator) for w in stencils]
    invariant_space(c, a, generators)
    require_spanned(c.witness["matrices"], c.witness["leaves"], c.witness["words"])


def difference(w: VectorSequence, k: int) -> VectorSequence:
    """The difference ∇^k w = Σ_i (-1)^i C(k,i) w(· - i), without zeros."""
    total: VectorSequence = {}
    for alpha, x in w.items():
        for i in range(k + 1):
            old = total.get(alpha + i, [0] * len(x))
            total[alpha + i] = [a + (-1) ** i * comb(k, i) * b for a, b in zip(old, x, strict=True)]
    return nonzero(total)


def invariant_space(c: Claim, a: MatrixMask, generators: list[Generator]) -> list[VectorSequence]:
    """The basis of the space of the witness, which is checked, and the family introduced."""
    witness, m = c.witness, a.size
    basis, family, tree, leaves = witness["basis"], witness["matrices"], witness["tree"], witness["leaves"]
    n = len(basis)
    require(n > 0, "the basis is empty")
    require_few(n <= MAX_ORDER, "the basis has too many rows")
    require_few(len(tree) <= _MAX_NODES, "the tree has too many nodes")
    width = len(basis[0])
    require(width > 0 and width % m == 0, "a row of the basis has not m entries for each index")
    require(all(len(row) == width for row in basis), "a row of the basis is of another length")
    require(all(x.denominator == 1 for row in basis for x in row), "the basis has an entry that is no integer")
    require(len(family.matrices) == a.arity and family.order == n, "the matrices are not p of the order of the basis")
    require(all(len(row) == n for row in leaves), "a leaf has not as many coordinates as the basis has rows")
    require(sum(tree) == len(leaves) and set(tree) <= {0, 1}, "the tree has not as many leaves")
    depth = depth_of(tree, len(generators), a.arity)
    longest = max(len(a.matrices), *(max(v) - min(v) for v, _ in generators if v), 0) + 2
    entry = max((fraction_bits(x) for row in basis for x in row), default=0)
    given = max(
        max((abs(x).bit_length() for values in v.values() for x in values), default=0) + denominator.bit_length()
        for v, denominator in generators
    )
    bits = given + depth * a.bits + entry + max(family.bits, most_bits(leaves)) + n.bit_length()
    work = len(tree) * longest * a.entries + len(leaves) * n * width + n * width * (n * (a.arity + 1) + a.entries // m)
    more = sum(map(len, witness["words"])) * n * n + n**3 if "words" in witness else n * m * m
    c.count(work + more, bits)
    rows = [[int(x) for x in row] for row in basis]
    require(are_independent(rows), "the basis is dependent modulo 2^61 - 1")
    sequences = [sequence(witness["start"], row, m) for row in rows]
    _invariant(a, sequences, rows, family, witness["start"])
    _grown(a, generators, tree, leaves, rows, witness["start"])
    c.introduce(c.statement["family"], family)
    return sequences


def _row(v: VectorSequence, start: int, width: int, m: int) -> list[int] | None:
    """The entries of a sequence on the window; None where it has others."""
    row = [0] * width
    for i, x in v.items():
        if any(x):
            if not 0 <= m * (i - start) < width:
                return None
            row[m * (i - start) : m * (i - start + 1)] = x
    return row


def _invariant(
    a: MatrixMask, sequences: Sequence[VectorSequence], rows: list[list[int]], family: RationalFamily, start: int
) -> None:
    """Check that T_ε b_i = Σ_j M_ε[j][i] b_j, at all indices."""
    columns = list(zip(*rows, strict=True))
    for i, v in enumerate(sequences):
        for letter, image in enumerate(a.images(v)):
            weights = [line[i] for line in family.matrices[letter]]
            combined = [a.denominator * sum(map(mul, weights, column)) for column in columns]
            row = _row(image, start, len(columns), a.size)
            same = row is not None and [family.denominator * x for x in row] == combined
            require(same, f"matrix {letter} does not give the image of row {i} of the basis")


def _grown(
    a: MatrixMask,
    generators: Sequence[Generator],
    tree: Sequence[int],
    leaves: Sequence[Sequence[Fraction]],
    rows: list[list[int]],
    start: int,
) -> None:
    """Check that the leaves of the tree of images of the generators have these coordinates."""
    columns, waiting, left = list(zip(*rows, strict=True)), list(generators), iter(leaves)
    for node, is_leaf in enumerate(tree):
        v, denominator = waiting[node]
        if not is_leaf:
            waiting += [lowest_terms(nonzero(image), denominator * a.denominator) for image in a.images(v)]
            continue
        numerators, common = scaled(next(left))
        row = _row(v, start, len(columns), a.size)
        same = row is not None and all(
            denominator * sum(map(mul, numerators, column)) == common * x
            for x, column in zip(row, columns, strict=True)
        )
        require(same, f"node {node} of the tree has other coordinates")
