"""Spectra of the refinement matrices A_0, …, A_(p-1), and how many eigen-conditions they meet (Dyn 4.2, 4.12)."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq_mat

from subdiv_cli.exact.algebraic import AlgebraicNumber, roots
from subdiv_cli.exact.linalg import Vector, eigenvectors

Spectrum = tuple[tuple[AlgebraicNumber, int], ...]
"""Eigenvalues with their algebraic multiplicities, by falling modulus."""


def spectrum(matrix: fmpq_mat) -> Spectrum:
    """The eigenvalues of a square matrix with their algebraic multiplicities, by falling modulus."""
    return roots(matrix.charpoly())


def eigen_condition(eigenvalues: Spectrum, p: int, nu: int) -> bool:
    """Whether 1, 1/p, …, 1/p^ν are simple eigenvalues and all others have modulus < 1/p^ν, decided exactly."""
    powers = [Fraction(1, p**j) for j in range(nu + 1)]
    polynomial_ones = [multiplicity for number, multiplicity in eigenvalues if number.rational in powers]
    others = (number for number, _ in eigenvalues if number.rational not in powers)
    return polynomial_ones == [1] * (nu + 1) and all(number.compare_modulus(powers[-1]) < 0 for number in others)


def limit_stencil(matrix: fmpq_mat) -> Vector | None:
    """The left eigenvector of A_0 for 1 with entries summing to 1 (Dyn 4.3); None unless it is unique."""
    basis = eigenvectors(matrix.transpose(), 1)
    if len(basis) != 1 or not (total := sum(basis[0])):
        return None
    return tuple(x / total for x in basis[0])
