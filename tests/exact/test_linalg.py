"""Nullspaces and eigenvectors over Q."""

from fractions import Fraction

import pytest
from flint import fmpq_mat, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.exact.linalg import (
    at_matrix,
    eigenvectors,
    identity,
    infinity_norm,
    matrix,
    minimal_polynomial,
    nullspace,
    rows_of,
)

entries = st.fractions(min_value=-4, max_value=4, max_denominator=5)


@given(st.integers(1, 4).flatmap(lambda n: st.lists(st.lists(entries, min_size=n, max_size=n), min_size=1, max_size=5)))
def test_the_nullspace_is_killed_and_has_the_right_dimension(rows):
    a = matrix(rows)
    basis = nullspace(a)
    for x in basis:
        assert all(sum(entry * value for entry, value in zip(row, x, strict=True)) == 0 for row in rows)
    assert len(basis) == a.ncols() - a.rank()
    if basis:
        assert matrix(basis).rank() == len(basis)


def test_eigenvectors_of_a_jordan_block_and_of_a_stochastic_matrix():
    assert eigenvectors(matrix([[2, 1], [0, 2]]), 2) == ((1, 0),)
    assert eigenvectors(identity(2), 1) == ((1, 0), (0, 1))
    stochastic = matrix([[Fraction(1, 2), Fraction(1, 2)], [Fraction(1, 4), Fraction(3, 4)]])
    assert eigenvectors(stochastic, 1) == ((1, 1),)
    assert eigenvectors(identity(2), 5) == ()


@given(st.integers(1, 4).flatmap(lambda n: st.lists(st.lists(entries, min_size=n, max_size=n), min_size=n, max_size=n)))
def test_the_minimal_polynomial_kills_and_no_smaller_one_does(rows):
    a = matrix(rows)
    f = minimal_polynomial(a)
    assert f[f.degree()] == 1
    assert not any(at_matrix(f, a).entries())
    assert divmod(a.charpoly(), f)[1] == fmpq_poly()
    powers = [identity(len(rows))]
    for _ in range(f.degree() - 1):
        powers.append(powers[-1] * a)
    assert fmpq_mat([power.entries() for power in powers]).rank() == f.degree()


@pytest.mark.parametrize("size", [18, 19, 20, 40])
def test_the_minimal_polynomial_of_small_numbers(size):
    a = matrix([[1, 0], [Fraction(1, 10**size), 0]])
    assert list(minimal_polynomial(a)) == [0, -1, 1]
    assert list(minimal_polynomial(identity(3) * 5)) == [-5, 1]


def test_rows_and_norm():
    a = matrix([[1, -2], [Fraction(1, 2), 0]])
    assert rows_of(a) == ((1, -2), (Fraction(1, 2), 0))
    assert infinity_norm(a) == 3
