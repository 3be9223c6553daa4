"""Families whose joint spectral radius is known, from the literature or by a short argument; each with its proof."""

import math
from fractions import Fraction

import pytest
from proved import exactly, kronecker, product_radius, products, proved, similar, transposed, words

PHI = (1 + 5**0.5) / 2
SHEAR = [[1, 1], [0, 1]]
GOLDEN = [SHEAR, [[1, 0], [1, 1]]]
ROTATION = [["3/5", "-4/5"], ["4/5", "3/5"]]
TURN = [[1, -1], [1, 1]]
"""√2 times a rotation by 45°."""


def shears(a):
    """Blondel, Theys & Vladimirov 2003, “An elementary counterexample to the finiteness conjecture”."""
    return [SHEAR, [[a, 0], [a, a]]]


def partitions(r):
    """Transition matrices of 1 + z + … + z^(r-1): partitions into powers of 2, each below r times (Reznick 1990)."""
    n = r - 1
    return [[[int(0 <= e + i - 2 * j + n - 1 <= n) for j in range(n)] for i in range(n)] for e in (0, 1)]


CLASSICS = {
    # name: (family, n, coefficients of m, ρ)
    "golden": (GOLDEN, 1, (-1, -1, 1), PHI),
    "golden backwards": (GOLDEN[::-1], 1, (-1, -1, 1), PHI),
    "a single matrix": ([[[1, 1], [1, 0]]], 1, (-1, -1, 1), PHI),
    "a single rotation": ([ROTATION], 2, (-1, 1), 1),
    "a single number": ([[["-7/3"]]], 1, (-7, 3), 7 / 3),
    "numbers": ([[[2]], [[-3]], [["5/2"]]], 1, (-3, 1), 3),
    "half shears": (shears("1/2"), 4, (1, -10, 4), 1.2441007926969905),
    "two thirds shears": (shears("2/3"), 3, (4, -24, 9), ((24 + 432**0.5) / 18) ** (1 / 3)),
    "nine tenths shears": (shears("9/10"), 2, (81, -270, 100), 0.9**0.5 * PHI),
    "a rotation of modulus 1": ([ROTATION, [["1/2", 0], [0, "1/3"]]], 2, (-1, 1), 1),
    "a rotation of modulus √2": ([TURN, [["1/2", 1], [0, "1/2"]]], 2, (-2, 1), 2**0.5),
    "complex of degree 4": ([[[0, 0, 0, -2], [1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0]]], 2, None, 1.3185806020065520),
    "a turn and a shear": ([TURN, SHEAR], 3, (2, -4, 1), (2 + 2**0.5) ** (1 / 3)),
    "Ando & Shih 1998": ([[[1, 0], [1, 0]], [[0, 1], [0, -1]]], 1, (-1, 1), 1),
    "permutations": ([[[0, 1, 0], [0, 0, 1], [1, 0, 0]], [[0, 1, 0], [1, 0, 0], [0, 0, 1]]], 1, (-1, 1), 1),
    "stochastic times two": ([[[1, 1, 0], [0, 1, 1], [1, 0, 1]], [[1, 0, 1], [1, 1, 0], [0, 1, 1]]], 1, (-2, 1), 2),
    "ranks of one": ([[[1, 2], [2, 4]], [[3, -1], [6, -2]]], 1, (-5, 1), 5),
    "nilpotent, but not together": ([[[0, 1], [0, 0]], [[0, 0], [1, 0]]], 1, (-1, 1), 1),
    "nilpotent, with a root": ([[[0, 2], [0, 0]], [[0, 0], [1, 0]]], 2, (-2, 1), 2**0.5),
    "two leaders": ([[[1, 1], [1, 0]], [[0, 1], [1, 1]]], 1, (-1, -1, 1), PHI),
    "three leaders": ([*GOLDEN, [[0, 1], [1, 1]]], 1, (-1, -1, 1), PHI),
    "three numbers": ([[[2, 0], [0, 1]], [[1, 0], [0, 2]], [[0, 2], [2, 0]]], 1, (-2, 1), 2),
    "a matrix and its negative": ([[[1, 1], [1, 0]], [[-1, -1], [-1, 0]]], 1, (-1, -1, 1), PHI),
    "one of two negated": ([SHEAR, [[-1, 0], [-1, -1]]], 1, (-1, -1, 1), PHI),
    "a matrix twice": ([SHEAR, SHEAR, GOLDEN[1]], 1, (-1, -1, 1), PHI),
    "a pair and its negatives": ([*GOLDEN, [[-1, -1], [0, -1]], [[-1, 0], [-1, -1]]], 1, (-1, -1, 1), PHI),
    "a rotation and its negative": ([ROTATION, [["-3/5", "4/5"], ["-4/5", "-3/5"]]], 2, (-1, 1), 1),
    "a triangle and its negative": (
        [[[2, 1, 3], [1, 1, 0], [0, 0, 1]], [[-2, -1, 5], [-1, -1, 1], [0, 0, 1]]],
        1,
        (1, -3, 1),
        PHI**2,
    ),
    "Euler's partitions below 2": (partitions(2), 1, (-1, 1), 1),
    "Euler's partitions below 3": (partitions(3), 1, (-1, -1, 1), PHI),
    "Euler's partitions below 4": (partitions(4), 1, (-2, 1), 2),
    "Euler's partitions below 6": (partitions(6), 1, (-3, 1), 3),
    "a Jordan block": ([SHEAR], 1, (-1, 1), 1),
    "a commuting pair": ([[[2, 0], [0, 2]], [[2, 1], [0, 2]]], 1, (-2, 1), 2),
    "a hidden triangle": ([[[2, 1], [-1, 0]], [[3, 2], [-2, -1]]], 1, (-1, 1), 1),
}


@pytest.mark.parametrize("name", CLASSICS)
def test_the_radius_is_exact_and_proved(name):
    family, n, polynomial, value = CLASSICS[name]
    found = proved(family)
    assert found.root is not None
    assert found.lower <= value * (1 + 1e-15)
    assert found.upper >= value * (1 - 1e-15)
    assert found.upper - found.lower <= 1e-15 * value
    if polynomial is not None:
        assert found.root == (n, polynomial)
    assert found.words
    for word in found.words:
        assert product_radius(family, word) == pytest.approx(value, rel=1e-7)


def test_words_that_attain():
    assert proved(GOLDEN).words == ((0, 1),)
    assert proved(shears("3/4")).words == ((0, 0, 1, 0, 1),)
    assert proved([TURN, SHEAR]).words == ((0, 1, 1),)


def test_bounded_products_are_claimed_only_where_a_body_proves_them():
    assert proved(GOLDEN).bounded
    assert proved([ROTATION]).bounded
    assert not proved([SHEAR]).bounded  # they grow like L
    assert not proved([[[2, 0], [0, 2]], [[2, 1], [0, 2]]]).bounded
    assert not proved([[[0, -1, 1, 0], [1, 0, 0, 1], [0, 0, 0, -1], [0, 0, 1, 0]]]).bounded  # a block of ±i twice


@pytest.mark.parametrize(
    "family",
    [
        [[[0, 0], [0, 0]]],
        [[[0]], [[0]]],
        [[[0, 1], [0, 0]]],
        [[[0, 1, 5], [0, 0, 2], [0, 0, 0]], [[0, -3, 1], [0, 0, 0], [0, 0, 0]]],
        [[[1, -1], [1, -1]], [[-2, 2], [-2, 2]]],  # nilpotent in a common basis
        similar(
            [[[0, 1, 5], [0, 0, 2], [0, 0, 0]], [[0, -3, 1], [0, 0, 1], [0, 0, 0]]], [[1, 2, 0], [0, 1, 3], [1, 0, 1]]
        ),
    ],
)
def test_zero(family):
    found = proved(family)
    assert (found.lower, found.upper) == (0.0, 0.0)
    assert found.words == ()


BASES = [
    [["1/2", 3, 0], [1, "-2/3", 1], [0, 1, 5]],
    [[1, 1, 1], [1, 2, 4], [1, 3, 9]],
    [[0, 0, 1], [0, 1, "1/7"], [1, "-3/11", 2]],
]


@pytest.mark.parametrize("basis", BASES)
@pytest.mark.parametrize(
    ("family", "value", "tied"),
    [
        ([[[1, 1, 7], [0, 1, "1/3"], [0, 0, 1]], [[1, 0, -2], [1, 1, 5], [0, 0, "-3/2"]]], PHI, False),
        ([[[1, 1, 7], [0, 1, "1/3"], [0, 0, 1]], [[1, 0, -2], [1, 1, 5], [0, 0, "-9/5"]]], 1.8, False),
        ([[["3/5", "-4/5", 1], ["4/5", "3/5", 2], [0, 0, 1]], [["1/2", 0, 4], [0, "1/3", 1], [0, 0, -1]]], 1, True),
        ([[[2, 1, 0], [0, 2, 1], [0, 0, 2]], [[1, 0, 1], [0, 1, 0], [0, 0, 1]]], 2, True),
    ],
)
def test_reducible_in_a_hidden_basis(family, value, tied, basis):
    """Where blocks share the radius no polytope closes across them, and they are taken apart."""
    found = proved(similar(family, basis))
    assert found.root is not None
    assert found.lower == pytest.approx(value, rel=1e-14)
    assert found.upper == pytest.approx(value, rel=1e-14)
    assert not tied or "blocks" in found.rules
    assert not tied or not found.bounded


FINITENESS = "749326546330/1000000000000"
"""Near the parameter of Hare, Morris, Sidorov & Theys 2011, for which no product attains the radius."""


def test_near_the_family_without_the_finiteness_property():
    found = proved(shears(FINITENESS))
    assert found.root is None
    assert found.lower < found.upper < found.lower + 1e-9
    assert set(found.rules) == {"monotone-polytope", "word"}
    assert found.upper <= products(exactly(shears(FINITENESS))).upper


@pytest.mark.parametrize(
    "family",
    [
        [ROTATION, [["5/13", "-12/13"], ["12/13", "5/13"]]],  # isometries: no polytope closes
        shears("4/5"),  # the end of the interval where the word 0 1 is best
    ],
)
def test_an_enclosure_where_no_polytope_closes(family):
    found = proved(family)
    assert found.upper - found.lower <= 4e-6
    value = next(v for v in (PHI, 1, 0.8**0.5 * PHI) if abs(v - found.lower) < 1e-6)
    assert found.lower <= value <= found.upper


@pytest.mark.parametrize("digits", [250, 900])
def test_long_numbers(digits):
    """Near the golden pair; a closed form of such coefficients is not spelled, but proved."""
    more = 1 + Fraction(1, 10**digits + 1)
    found = proved([[[more, 1], [0, 1]], [[1, 0], [1, 1]]])
    assert found.root is not None
    assert found.lower == pytest.approx(PHI, rel=1e-14)
    long = 10 ** (digits + 10)
    found = proved([[[0, Fraction(long + 1, long - 1)], [1, 0]], [[1, 0], [0, Fraction(1, long + 3)]]])
    assert found.lower <= 1 + 1e-15 <= found.upper + 2e-15


def circulant(order):
    """A circulant matrix with column sums 3, and E_00."""
    shift = [[int((i - j) % order in (0, 1, 5)) for j in range(order)] for i in range(order)]
    corner = [[int(i == j == 0) for j in range(order)] for i in range(order)]
    return [shift, corner]


@pytest.mark.parametrize("order", [61, 64])
def test_a_large_order_is_decided_by_a_vector(order):
    found = proved(circulant(order))
    assert found.root == (1, (-3, 1))
    assert found.rules == ["growing-vector", "common-vector", "meeting-bounds"]


def test_a_large_order_has_a_bound():
    """The same with signs, which hide the sums: there is no product beside the bound, which a checker could check."""
    shift, corner = circulant(61)
    signed = [[-x if (i - j) % 61 == 5 else x for j, x in enumerate(row)] for i, row in enumerate(shift)]
    found = proved([signed, corner], 4000)
    assert found.rules == ["ellipsoid"]
    assert found.lower == 0.0
    assert 2 <= found.upper <= 3


def test_vertices_that_floats_do_not_get_hold_of():
    found = proved([[[10**20, 1], [1, 1]], [[1, 10**20], [1, 0]]])
    assert 1e20 <= found.lower <= found.upper <= 1.0001e20


def test_little_effort_is_honest():
    """With little work there is a wider enclosure, or none, and never a wrong one."""
    value = (2 + 2**0.5) ** (1 / 3)
    for work in (4, 10, 30, 100, 300):
        found = proved([TURN, SHEAR], work)
        assert found.lower <= value * (1 + 1e-15)
        assert found.upper >= value * (1 - 1e-15)


@pytest.mark.parametrize("scale", [10**60, 10**400, Fraction(1, 10**60), Fraction(1, 10**400)])
def test_huge_and_tiny_matrices(scale):
    """Doubles need not reach the radius; the certificate does."""
    for family in (GOLDEN, [ROTATION], [[[2, 1], [0, 1]], [[1, 5], [0, -3]]]):
        plain, found = proved(family), proved([[[scale * x for x in row] for row in m] for m in exactly(family)])
        assert found.root is not None
        assert found.root[0] == plain.root[0]
        assert found.rules == plain.rules


@pytest.mark.parametrize("scale", [10**20, 10**100, 10**400])
def test_entries_of_very_different_sizes(scale):
    """Denominators beyond 64 bits, and vertices far from any circle."""
    small = Fraction(1, scale)
    assert proved([[[small, 1], [0, small]], [[1, 0], [small, 0]]]).root == (1, (-1, 1))
    assert proved([[[1, scale], [small, 1]], [[0, scale], [0, 1]]]).root == (1, (-2, 1))


def test_the_laws_for_the_golden_pair():
    """Scaled, transposed, in another basis, all products of three, and squared by Kronecker's product."""
    golden = exactly(GOLDEN)
    scaled = [[[Fraction(-7, 3) * x for x in row] for row in m] for m in golden]
    assert proved(scaled).root == (1, (-49, -21, 9))
    assert proved([transposed(m) for m in golden]).root == (1, (-1, -1, 1))
    assert proved(similar(GOLDEN, [[1, "1/2"], [3, 1]])).lower == pytest.approx(PHI, rel=1e-14)
    cubes = proved(words(GOLDEN, 3))
    assert cubes.lower == pytest.approx(PHI**3, rel=1e-9)
    assert cubes.upper == pytest.approx(PHI**3, rel=1e-9)
    squares = proved([kronecker(a, b) for a in golden for b in golden])
    assert squares.lower <= PHI**2 <= squares.upper * (1 + 1e-15)
    assert squares.upper - squares.lower <= 1e-5


def test_the_oracle_of_products_is_one():
    low, high = products(exactly(GOLDEN))
    assert low <= PHI <= high
    assert low == pytest.approx(PHI, rel=1e-9)
    assert high < 1.75
    assert math.isclose(products(exactly([[[0, 1], [0, 0]]])).lower, 0.0)
