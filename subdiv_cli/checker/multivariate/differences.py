"""Families of a mask on Z^s: the transition operators on sequences that annihilate polynomials. See FORMAT.md.

(T_ε v)(α) = Σ_β a(ε+Mα-β) v(β); U_k: the finitely supported v with Σ v(α) p(α) = 0 for all p of degree below k.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from math import comb, lcm, prod
from operator import mul

from subdiv_cli.checker.core import Claim
from subdiv_cli.checker.matrices import RationalFamily, dependent_rows
from subdiv_cli.checker.multivariate.lattice import DilationMatrix, Index, Sparse, add, monomials, power
from subdiv_cli.checker.multivariate.masks import SparseMask, mask_of
from subdiv_cli.checker.multivariate.sum_rules import INDEX_BITS
from subdiv_cli.checker.reading import MAX_ENTRY, MAX_ORDER, require, require_few
from subdiv_cli.checker.roots import fraction_bits

Rows = Sequence[Sequence[int]]
_MAX_PAIRS = 1_000_000
"""The most pairs of a term of the mask and an index of the window."""


def differences(c: Claim) -> None:
    """The new family is that of the T_ε on a space V in U_k that contains ∇^μ δ for |μ| = k: its JSR is ρ_k.

    Every v in U_k is a finite combination of shifts of them, and T_ε maps shifts to shifts. V is spanned by the rows of
    the basis, zero outside of the window.
    """
    a, k, witness = mask_of(c), c.statement["order"], c.witness
    highest = c.use("total-sum-rules").statement["order"]
    require(1 <= k <= highest, f"the sum rules are of order {highest}")
    window, basis, family = witness["window"], witness["basis"], witness["matrices"]
    s, m, n = a.dilation.dimension, a.dilation.cosets, len(basis)
    require(n > 0, "the basis is empty")
    require_few(n <= MAX_ORDER, "the basis has too many rows")
    require(all(len(row) == len(window) for row in basis), "a row of the basis is not as long as the window")
    require_few(len(window) * len(a.terms) <= _MAX_PAIRS, "the window is too large for so many terms")
    require(
        len(family.matrices) == m and family.order == n, "the matrices are not m, or of another order than the basis"
    )
    generators, entry = comb(k + s - 1, s - 1), MAX_ENTRY.bit_length()
    each = (m + 1) * n + len(a.terms) + comb(k + s - 1, s) + generators
    most = max((fraction_bits(x) for row in witness["generators"] for x in row), default=0)
    bits = n.bit_length() + entry + max(a.bits + family.bits, INDEX_BITS * k, n * most)
    c.count(n * len(window) * each, bits)
    positions = positions_of(window, s)
    _annihilate(basis, window, k)
    dependent = next(iter(dependent_rows(basis)), None)
    require(dependent is None, f"row {dependent} of the basis depends on those before it, modulo 2^61 - 1")
    _generate(basis, positions, witness["generators"], k)
    require_invariant(a, witness["cosets"], basis, positions, family)
    c.introduce(c.statement["family"], family)


def positions_of(window: Sequence[Index], s: int) -> dict[Index, int]:
    """The place of each index in a window. Raises Rejected for no window, and for one that has an index twice."""
    require(len(window) > 0, "the window is empty")
    require(all(len(index) == s for index in window), f"an index of the window is not one of Z^{s}")
    positions = {index: i for i, index in enumerate(window)}
    require(len(positions) == len(window), "an index stands twice in the window")
    return positions


def _annihilate(basis: Rows, window: Sequence[Index], k: int) -> None:
    """Check that Σ b(α) α^μ = 0 for |μ| < k, for each row b of the basis."""
    for degree in range(k):
        for mu in monomials(len(window[0]), degree):
            values = [power(index, mu) for index in window]
            for i, row in enumerate(basis):
                require(not sum(map(mul, row, values)), f"row {i} of the basis does not annihilate the monomial {mu}")


def _generate(basis: Rows, positions: dict[Index, int], generators: Sequence[Sequence[Fraction]], k: int) -> None:
    """Check that Σ_i c_i b_i = ∇^μ δ, for all |μ| = k in lexicographic order."""
    columns = list(zip(*basis, strict=True))
    exponents = list(monomials(len(next(iter(positions))), k))
    require(len(generators) == len(exponents), "there are not as many generators as monomials of degree k")
    for mu, coordinates in zip(exponents, generators, strict=True):
        require(len(coordinates) == len(basis), "a generator has not as many coordinates as the basis has rows")
        values = [0] * len(positions)
        for index, value in difference(mu).items():
            require(index in positions, f"the window does not contain the support of the difference {mu}")
            values[positions[index]] = value
        common = lcm(*(x.denominator for x in coordinates))
        numerators = [x.numerator * (common // x.denominator) for x in coordinates]
        same = all(sum(map(mul, numerators, column)) == common * x for column, x in zip(columns, values, strict=True))
        require(same, f"the coordinates of the difference {mu} are others")


def difference(mu: Index) -> Sparse:
    """The difference ∇^μ δ = Π_j (1 - τ_j)^μ_j δ: Π_j (-1)^α_j C(μ_j, α_j) at 0 <= α <= μ."""
    corner = product(*(range(n + 1) for n in mu))
    return {index: (-1) ** sum(index) * prod(map(comb, mu, index)) for index in corner}


def require_invariant(
    a: SparseMask, cosets: Sequence[Index], basis: Rows, positions: dict[Index, int], family: RationalFamily
) -> None:
    """Check that T_(ε_e) b_i = Σ_j M_e[j][i] b_j, at all indices. Raises Rejected where it is not so."""
    size = len(positions)
    operators, slots = _operators(a, cosets, positions)
    columns = list(zip(*basis, strict=True))
    weights = [list(zip(*matrix, strict=True)) for matrix in family.matrices]
    for i, row in enumerate(basis):
        images = [0] * slots
        for v, column in zip(row, operators, strict=True):
            if v:
                for slot, numerator in column:
                    images[slot] += v * numerator
        require(not any(images[len(cosets) * size :]), f"the image of row {i} of the basis leaves the window")
        for letter, weight in enumerate(weights):
            image = [family.denominator * x for x in images[letter * size : (letter + 1) * size]]
            combined = [a.denominator * sum(map(mul, weight[i], column)) for column in columns]
            require(image == combined, f"matrix {letter} does not give the image of row {i} of the basis")


def _operators(
    a: SparseMask, cosets: Sequence[Index], positions: dict[Index, int]
) -> tuple[list[list[tuple[int, int]]], int]:
    """The slots and numerators a(x-β) for every β of the window, and the number of slots.

    x = ε_e + Mα has the slot of e and α: letter by letter the window, and then slots for the α outside of it.
    """
    dilation, size = a.dilation, len(positions)
    letters = letters_of(dilation, cosets)
    slots: dict[Index, int] = {}
    outside = len(cosets) * size
    operators = []
    for beta in positions:
        column = []
        for index, numerator in a.terms.items():
            x = add(index, beta)
            if x not in slots:
                letter, epsilon = letters[dilation.residue(x)]
                at = positions.get(dilation.divided([i - j for i, j in zip(x, epsilon, strict=True)]))
                slots[x] = outside if at is None else letter * size + at
                outside += at is None
            column.append((slots[x], numerator))
        operators.append(column)
    return operators, outside


def letters_of(dilation: DilationMatrix, cosets: Sequence[Index]) -> dict[Index, tuple[int, Index]]:
    """The number of each representative and the representative itself, by its residue.

    Raises Rejected where they are not one for each coset.
    """
    require(len(cosets) == dilation.cosets, "the representatives are not m")
    require(all(len(index) == dilation.dimension for index in cosets), "a representative has another dimension")
    letters = {dilation.residue(index): (number, index) for number, index in enumerate(cosets)}
    require(len(letters) == len(cosets), "two representatives are congruent")
    return letters
