"""Nets refined and written as OBJ: planes stay planes, Loop's rules by hand, faces that are whole and turn one way."""

from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest

from subdiv_cli.kinds.multivariate.numbers import nets
from subdiv_cli.kinds.multivariate.numbers.multivariate import MultivariateNumbers
from subdiv_cli.kinds.multivariate.numbers.values import NoValuesError
from subdiv_cli.kinds.multivariate.portrait.pictures import graph, net
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Effort
from subdiv_cli.model.blocks import Net
from subdiv_cli.plot.obj import obj

F = Fraction
MASKS = Path(__file__).parents[2] / "masks" / "multivariate"
TRIANGLES = {"loop", "butterfly", "courant", "kobbelt_sqrt3", "box_211", "box_333", "loop_ternary"}
QUADRILATERALS = {
    "catmull_clark", "doo_sabin", "bilinear", "zwart_powell", "velho_zorin", "midedge", "tensor_four_point", "bear",
    "anisotropic_bilinear", "quincunx_linear", "biquadratic_ternary",
}  # fmt: skip


def read(name):
    return read_path(MASKS / f"{name}.toml").scheme()


def plane(size, height=lambda i, j: 2 * i - 3 * j + 1):
    return {(i, j): (F(i), F(j), F(height(i, j))) for i, j in product(range(size), repeat=2)}


def parsed(text):
    """Vertices and faces of an OBJ; every index is that of a vertex, none stands twice in a face."""
    vertices, faces = [], []
    for line in text.splitlines():
        kind, *rest = line.split()
        if kind == "v":
            vertices.append(tuple(map(float, rest)))
            assert len(rest) == 3
        elif kind == "f":
            faces.append(tuple(map(int, rest)))
        else:
            assert kind == "#"
    for face in faces:
        assert 3 <= len(set(face)) == len(face) <= 4
        assert all(1 <= index <= len(vertices) for index in face)
    return vertices, faces


def area(corners):
    """Of the shadow of a face in the plane, positive where it runs counterclockwise."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)) / 2


@pytest.mark.parametrize("name", sorted(TRIANGLES | QUADRILATERALS))
def test_a_plane_stays_that_plane(name):
    """And x, y stay a grid, each level finer by M; all faces of the same size turn the same way, without a gap."""
    scheme = read(name)
    levels = 2
    found = net(scheme, plane(12), levels)
    vertices, sides = parsed(obj(found, name))
    assert len(vertices) == len(found.vertices)
    assert all(z == 2 * x - 3 * y + 1 for x, y, z in found.vertices.values())
    assert all(abs(z - (2 * x - 3 * y + 1)) < 1e-12 for x, y, z in vertices)
    areas = {round(area([vertices[i - 1] for i in face]), 12) for face in sides}
    index = MultivariateNumbers(scheme, Effort()).lattice.index
    assert areas == {round(1 / index**levels / (2 if name in TRIANGLES else 1), 12)}
    assert {len(face) for face in sides} == {3 if name in TRIANGLES else 4}
    assert len(set(sides)) == len(sides) >= 30


def test_the_other_diagonal():
    """The mask of Courant's hat sheared: its third direction is (1, -1)."""
    scheme = read("courant")
    sheared = type(scheme)(dilation=scheme.dilation, terms={(i, -j): a for (i, j), a in scheme.terms.items()})
    found = net(sheared, plane(6), 1)
    assert (net(scheme, plane(6), 1).diagonal, found.diagonal) == ((1, 1), (1, -1))
    vertices, sides = parsed(obj(found, "sheared"))
    assert {round(area([vertices[i - 1] for i in face]), 12) for face in sides} == {0.125}


def test_loop_by_hand():
    """5/8 and six times 1/16 at the old vertices, 3/8 and 1/8 on the edges; nothing beyond what is determined."""

    def height(i, j):
        return i**3 - 2 * i * j + j**2 + (5 if (i, j) == (2, 2) else 0)

    heights = {place: vertex[2] for place, vertex in plane(5, height).items()}
    found = {place: vertex[2] for place, vertex in net(read("loop"), plane(5, height), 1).vertices.items()}
    six = [(1, 0), (0, 1), (1, 1), (-1, 0), (0, -1), (-1, -1)]
    edges = {(1, 0): ((0, -1), (1, 1)), (0, 1): ((-1, 0), (1, 1)), (1, 1): ((1, 0), (0, 1))}
    expected = {}
    for i, j in heights:
        ring = [(i + k, j + l) for k, l in six]
        if all(place in heights for place in ring):
            total = sum(heights[place] for place in ring)
            expected[2 * i + 2, 2 * j + 2] = F(5, 8) * heights[i, j] + F(1, 16) * total
        for (k, l), wings in edges.items():
            far, sides = (i + k, j + l), [(i + x, j + y) for x, y in wings]
            if all(place in heights for place in (far, *sides)):
                ends = heights[i, j] + heights[far]
                expected[2 * i + 2 + k, 2 * j + 2 + l] = F(3, 8) * ends + F(1, 8) * sum(heights[s] for s in sides)
    assert found == expected
    assert len(found) == 9 + 4 * 3 * 2 + 16


@pytest.mark.parametrize("name", ["loop", "catmull_clark", "quincunx_interpolatory", "kobbelt_sqrt3"])
def test_the_valid_region(name):
    """A vertex is there iff every control point of its rule is given: against the definition, index by index."""
    scheme, given = read(name), plane(4, lambda i, j: i * j)
    (a, b), (c, d) = scheme.dilation
    expected = {}
    for alpha in product(range(-9, 14), repeat=2):
        rule = {}
        for beta in product(range(-12, 17), repeat=2):
            shift = alpha[0] - a * beta[0] - b * beta[1], alpha[1] - c * beta[0] - d * beta[1]
            if shift in scheme.terms:
                rule[beta] = scheme.terms[shift]
        if all(beta in given for beta in rule):
            expected[alpha] = tuple(sum(x * given[beta][i] for beta, x in rule.items()) for i in range(3))
    assert net(scheme, given, 1).vertices == expected


@pytest.mark.parametrize("name", ["loop", "butterfly", "quincunx_linear", "anisotropic_bilinear", "kobbelt_sqrt3"])
def test_the_graph_of_phi(name):
    """Its vertices on Z^2 have the values at the integers, its rim is at height 0, and its volume is nearly 1."""
    scheme = read(name)
    levels = 4
    found = graph(MultivariateNumbers(scheme, Effort()), levels)
    vertices, sides = parsed(obj(found, name))
    volume = 0.0
    for face in sides:
        corners = [vertices[i - 1] for i in face]
        assert area(corners) > 0
        volume += area(corners) * sum(z for _, _, z in corners) / len(corners)
    assert volume == pytest.approx(1, abs=1e-9)


def test_too_small_and_too_large(monkeypatch):
    with pytest.raises(NoValuesError, match="determines no vertex of level 1"):
        net(read("loop"), plane(1), 1)
    with pytest.raises(NoValuesError, match="no vertex of level 2"):
        net(read("loop"), plane(2), 8)
    assert not list(net(read("butterfly"), plane(3), 1).faces())
    monkeypatch.setattr(nets, "MOST_PRODUCTS", 10_000)
    with pytest.raises(NoValuesError, match="the net of level 3 is too large"):
        net(read("loop"), plane(9), 3)


def test_level_zero_is_the_net_itself():
    assert net(read("loop"), plane(3), 0).vertices == plane(3)


def test_the_text_of_a_square():
    vertices = {(i, j): (F(i), F(j), F(1, 3)) for i, j in product(range(2), repeat=2)}
    third = repr(1 / 3)
    lines = ["# a", f"v 0.0 0.0 {third}", f"v 0.0 1.0 {third}", f"v 1.0 0.0 {third}", f"v 1.0 1.0 {third}"]
    assert obj(Net(vertices), "a").splitlines() == [*lines, "f 1 3 4 2"]
    assert obj(Net(vertices, turned=True), "a").splitlines() == [*lines, "f 2 4 3 1"]
    assert obj(Net(vertices, (1, 1)), "a").splitlines() == [*lines, "f 1 3 4", "f 1 4 2"]
    assert obj(Net(vertices, (1, -1)), "a").splitlines() == [*lines, "f 1 3 2", "f 3 4 2"]
