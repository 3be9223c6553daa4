"""B. Dong and Z. Shen, Pseudo-splines, wavelets and framelets, 2007: generation, reproduction, and regularity by order.

The symbol of type II and order (m, l), l < m, is that of cos^2m(ξ/2) Σ_(j<=l) C(m+l, j) sin^2j(ξ/2) cos^2(l-j)(ξ/2).
"""

from fractions import Fraction
from itertools import pairwise
from math import comb

import pytest
from support import answer, scheme

from subdiv_cli.exact.laurent import Laurent

COSINE = Laurent.from_coefficients(-1, [Fraction(1, 4), Fraction(1, 2), Fraction(1, 4)])
SINE = Laurent.from_coefficients(-1, [Fraction(-1, 4), Fraction(1, 2), Fraction(-1, 4)])


def power(f, exponent):
    total = Laurent.from_coefficients(0, [1])
    for _ in range(exponent):
        total = total * f
    return total


def pseudo_spline(m, l):
    terms = [power(SINE, j) * power(COSINE, m + l - j) for j in range(l + 1)]
    symbol = terms[0]
    for j, term in enumerate(terms[1:], 1):
        symbol = symbol + term.scale(comb(m + l, j))
    return scheme(symbol.scale(2).coefficients(), start=symbol.low)


@pytest.mark.parametrize(("m", "l"), [(m, l) for m in range(1, 6) for l in range(m)])
def test_degrees(m, l):
    """Generation 2m-1, reproduction 2l+1: from B-splines, l = 0, to interpolatory schemes, l = m-1."""
    result = answer(pseudo_spline(m, l))
    assert (result.generation, result.reproduction) == (2 * m - 1, 2 * l + 1)
    assert result.facts["interpolatory"] is (l == m - 1)


@pytest.mark.parametrize("m", range(2, 6))
def test_the_sobolev_exponent_falls_with_l_and_grows_with_m(m):
    exponents = [answer(pseudo_spline(m, l)).sobolev for l in range(m)]
    assert exponents[0].exact == 2 * m - Fraction(1, 2)
    assert all(a.lower > b.upper for a, b in pairwise(exponents))
    assert all(answer(pseudo_spline(m + 1, l)).sobolev.lower > exponents[l].upper for l in range(m))
