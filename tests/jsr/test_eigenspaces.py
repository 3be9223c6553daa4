"""Leading eigenspaces of several dimensions: the polytope closes with leaders enough.

Each family is a projection, or a reflection and a projection, and a rotation times a factor below 1, in another basis:
their Euclidean norms say that the radius is 1.
"""

from fractions import Fraction

import pytest
from proved import proved, similar, times

from subdiv_cli.exact.linalg import matrix
from subdiv_cli.jsr.eigenspaces import surrounding
from subdiv_cli.jsr.family import Candidate, Family
from subdiv_cli.jsr.leaders import leaders
from subdiv_cli.jsr.radius import joint_spectral_radius
from subdiv_cli.model import Effort

BASES = {
    3: [[4, 1, -2], [0, 3, 1], [2, -1, 5]],
    4: [[3, 1, 0, -2], [1, 4, 2, 0], [0, -1, 5, 1], [2, 0, 1, 3]],
    5: [[5, 1, 0, 2, -1], [0, 4, 1, -2, 1], [1, 0, 3, 1, 0], [2, -1, 0, 6, 1], [0, 1, 2, 0, 4]],
}
PLANES = [(0, 1), (1, 2), (0, 2), (2, 3), (0, 3), (3, 4), (1, 4)]
TURNS = [(3, 4, 5), (5, 12, 13), (8, 15, 17), (4, 3, 5), (12, 5, 13), (15, 8, 17), (7, 24, 25)]


def rotation(n):
    """A rational one without invariant subspaces."""
    total = [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]
    for (i, j), (p, q, r) in zip([pair for pair in PLANES if max(pair) < n], TURNS, strict=False):
        turn = [[Fraction(int(a == b)) for b in range(n)] for a in range(n)]
        turn[i][i] = turn[j][j] = Fraction(p, r)
        turn[i][j], turn[j][i] = Fraction(q, r), -Fraction(q, r)
        total = times(total, turn)
    return total


def family(diagonal, factor):
    n = len(diagonal)
    first = [[Fraction(diagonal[i]) if i == j else Fraction(0) for j in range(n)] for i in range(n)]
    return similar([first, [[factor * x for x in row] for row in rotation(n)]], BASES[n])


@pytest.mark.parametrize("factor", [Fraction(1, 2), Fraction(3, 4), Fraction(9, 10)], ids=str)
@pytest.mark.parametrize(
    "diagonal",
    [
        (1, 1, "1/4"),
        (1, 1, "1/4", "-1/8"),
        (1, 1, 1, "1/3"),
        (1, 1, "1/4", "1/3", 0),
        (1, -1, "1/4"),
        (1, 1, -1, "1/3"),
    ],
    ids=str,
)
def test_the_polytope_closes(diagonal, factor):
    found = proved(family(diagonal, factor))
    assert found.root in ((1, (-1, 1)), (2, (-1, 1)))
    assert (found.lower, found.upper) == (1.0, 1.0)
    assert found.bounded


def test_two_jordan_blocks_are_not_surrounded():
    """There is no projection on the eigenspace along others, and products grow."""
    a = Family([matrix(similar([[[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]]], BASES[4])[0])])
    found = leaders(a, [Candidate((0,))])
    assert len(found.each) == 2
    assert surrounding(a, found, lambda starts: pytest.fail("a body"), Effort()) is None


def test_leaders_of_both_signs_are_squared_only_where_that_is_asked_for():
    a = Family([matrix(rows) for rows in family((1, -1, "1/4"), Fraction(1, 2))])
    plain, squared = leaders(a, [Candidate((0,))]), leaders(a, [Candidate((0,))], squared=True)
    assert plain.has_both_signs
    assert (plain.length, len(plain.each)) == (1, 1)
    assert not squared.has_both_signs
    assert (squared.length, len(squared.each)) == (2, 2)
    assert {leader.candidate.word for leader in squared.each} == {(0, 0)}


def test_hulls_that_no_margin_has_room_for_are_given_up():
    """Two projections with one plane in common: what comes back to a plane is as large as what left it."""
    found = proved(
        [
            [["-2/5", 0, 0], ["-7/5", 1, 0], ["-7/10", 0, 1]],
            [["1/4", "1/4", "3/8"], ["-1/8", "-1/4", "-1/8"], ["3/8", "1/4", "1/4"]],
            [[1, 0, "-7/10"], [0, 1, "-7/5"], [0, 0, "-2/5"]],
        ]
    )
    assert found.root == (1, (-1, 1))


@pytest.mark.parametrize("power", [12, 100])
def test_coordinates_of_very_different_scales(power):
    """diag(1, -1) and ((0, b/2), (1/(2b), 1/9)): in another scale a matrix with a norm below 1."""
    b = Fraction(10) ** power
    found = proved([[[1, 0], [0, -1]], [[0, b / 2], [1 / (2 * b), "1/9"]]])
    assert found.root == (1, (-1, 1))


@pytest.mark.parametrize("power", [200, 310, 1000])
def test_scales_beyond_doubles_are_no_error(power):
    b = Fraction(10) ** power
    family = Family([matrix([[1, 0], [0, -1]]), matrix([[0, b / 2], [1 / (2 * b), Fraction(1, 9)]])])
    radius = joint_spectral_radius(family, Effort())
    assert radius is None or radius.upper[1] >= 1
