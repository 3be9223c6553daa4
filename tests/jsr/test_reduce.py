"""Families taken apart: hidden blocks are found, exactly and with small numbers; of smaller ones bounds suffice."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction as Q

import pytest
from flint import fmpq_mat, fmpz_mat

from subdiv_cli.exact.linalg import reduced
from subdiv_cli.jsr.family import Family
from subdiv_cli.jsr.irreducible import bounded
from subdiv_cli.jsr.radius import joint_spectral_radius
from subdiv_cli.jsr.reduce import decomposed
from subdiv_cli.jsr.subspace import invariant_subspace
from subdiv_cli.model import Effort


def _hidden(sizes: Sequence[int], seed: int, scale: int = 4) -> list[fmpq_mat]:
    """Two block triangular matrices with entries in Z/4, in another basis of Z^N."""
    generator, n = random.Random(seed), sum(sizes)
    ends = [sum(sizes[: k + 1]) for k in range(len(sizes)) for _ in range(sizes[k])]
    turn = fmpz_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])
    for _ in range(3 * n):
        i, j = generator.sample(range(n), 2)
        rows, sign = turn.tolist(), generator.choice((-1, 1))
        rows[i] = [x + sign * y for x, y in zip(rows[i], rows[j], strict=True)]
        turn = fmpz_mat(rows)
    found = []
    for _ in range(2):
        entries = [generator.randint(-3, 3) if i < ends[j] else 0 for i in range(n) for j in range(n)]
        found.append(fmpq_mat(turn.inv()) * fmpq_mat(n, n, entries) * turn / scale)
    return found


@pytest.mark.parametrize("sizes", [(2, 3), (3, 1, 4), (5, 5), (1, 6, 2, 3)])
def test_hidden_blocks_are_found_with_the_denominators_of_the_matrices(sizes: tuple[int, ...]) -> None:
    family = Family(_hidden(sizes, seed=sum(sizes)))
    blocks = decomposed(family)
    assert blocks is not None
    assert abs(blocks.basis.det()) == 1
    assert sorted(part.order for part in blocks.parts) == sorted(sizes)
    for index, m in enumerate(family.matrices):
        product = 1
        for part in blocks.parts:
            product *= part.matrices[index].charpoly()
            assert 4 % int(part.matrices[index].numer_denom()[1]) == 0
        assert product == m.charpoly()


def test_a_subspace_is_invariant() -> None:
    matrices = _hidden((3, 4), seed=1)
    rows = invariant_subspace(matrices)
    assert rows is not None
    images = [(m * rows.transpose()).transpose().tolist() for m in matrices]
    assert fmpq_mat(rows.tolist() + images[0] + images[1]).rank() == rows.nrows() == 3


def test_subspaces_of_large_numbers_are_found_again_over_q() -> None:
    large = (1 << 40) + 13
    turn = fmpq_mat(3, 3, [1, 0, 0, large, 1, 0, large + 2, 5, 1])
    matrices = [turn * m * turn.inv() for m in (fmpq_mat(3, 3, [1, 1, 2, 0, 1, 2, 0, 3, 1]),)]
    matrices.append(turn * fmpq_mat(3, 3, [2, 3, 1, 0, 1, 1, 0, 1, 0]) * turn.inv())
    assert decomposed(Family(matrices)) is not None


def test_an_irreducible_family_stays_whole() -> None:
    assert decomposed(Family([fmpq_mat(2, 2, [1, 1, 0, 1]), fmpq_mat(2, 2, [1, 0, 1, 1])])) is None


def test_reduced_rows_span_all_integer_vectors() -> None:
    assert abs(reduced(fmpq_mat(2, 2, [3, 1, 1, 5])).det()) == 1
    assert reduced(fmpq_mat(1, 3, [Q(2, 3).numerator, 4, 6])).table() == fmpq_mat(1, 3, [1, 2, 3]).table()


def test_a_bound_is_proved_or_refused() -> None:
    family = Family([fmpq_mat(2, 2, [1, 1, 0, 1]), fmpq_mat(2, 2, [1, 0, 1, 1])])  # radius (1 + √5)/2
    proof = bounded(family, (2, Q(3)), Effort())
    assert proof is not None
    assert Q(13, 5) < proof.upper[1] ** 2 <= 3
    assert bounded(family, (2, Q(13, 5)), Effort()) is None


def test_the_largest_block_is_exact_and_the_others_are_bounded() -> None:
    small = [fmpq_mat(2, 2, [1, 1, 0, 1]) / 8, fmpq_mat(2, 2, [1, 0, 1, 1]) / 8]
    large = [fmpq_mat(2, 2, [1, 1, 0, 1]), fmpq_mat(2, 2, [1, 0, 1, 1])]
    summed = [
        fmpq_mat([[*a, 0, 0] for a in x.tolist()] + [[0, 0, *b] for b in y.tolist()])
        for x, y in zip(small, large, strict=True)
    ]
    radius = joint_spectral_radius(Family(summed), Effort())
    assert radius is not None
    assert radius.exact is not None
    assert radius.exact[1].coefficients == (-1, -1, 1)
    parts = radius.proof["parts"]
    assert isinstance(parts, tuple)
    assert sorted("bound" in part for part in parts if isinstance(part, dict)) == [False, True]


def test_a_block_without_a_bound_of_its_own_has_a_rough_one(monkeypatch):
    """As where the clock strikes in it: the blocks still say more than all of the matrices, with 1000 beside them."""
    monkeypatch.setattr("subdiv_cli.jsr.radius.irreducible_radius", lambda *_: None)
    family = Family([fmpq_mat([[1, -1, 1000], [1, 1, 1000], [0, 0, 1]]), fmpq_mat([[1, 1, 0], [-1, 1, 9], [0, 0, 1]])])
    found = joint_spectral_radius(family, Effort())
    assert found is not None
    assert found.upper[1] ** 2 <= 5 ** found.upper[0]
    assert found.upper[1] ** 2 >= 2 ** found.upper[0]
