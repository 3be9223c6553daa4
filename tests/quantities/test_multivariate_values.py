"""φ on Z^s and M^-n Z^s: known values, the refinement equation at every point, the partition of unity, slices."""

from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest

from subdiv_cli.kinds.multivariate.numbers import values as multivariate_values
from subdiv_cli.kinds.multivariate.numbers.values import NoValuesError, at_fractions, at_integers, support_box
from subdiv_cli.kinds.option import from_option
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.spaces.lattice import Lattice

F = Fraction
MASKS = Path(__file__).parents[2] / "masks" / "multivariate"
CONTINUOUS = {file.stem: file for file in sorted(MASKS.glob("*.toml"))}
CONTINUOUS |= {name: MASKS / "counterexamples" / f"{name}.toml" for name in ("box_on_sublattice", "unstable_tensor")}
CORNERS = {(1, 1), (1, 0), (0, 1), (-1, 0), (0, -1), (-1, -1)}


def read(name):
    scheme = read_path(CONTINUOUS[name]).scheme()
    return scheme, Lattice(scheme.dilation)


def around(centre, middle, ring):
    x, y = centre
    return {centre: middle, **{(x + i, y + j): ring for i, j in CORNERS}}


@pytest.mark.parametrize(
    ("name", "values"),
    {
        "loop": around((2, 2), F(1, 2), F(1, 12)),
        "loop_ternary": around((2, 2), F(1, 2), F(1, 12)),
        "kobbelt_sqrt3": around((0, 0), F(1, 2), F(1, 12)),
        "courant": {(1, 1): 1},
        "courant_ternary": {(1, 1): 1},
        "bilinear": {(0, 0): 1},
        "trilinear": {(1, 1, 1): 1},
        "zwart_powell": dict.fromkeys([(1, 0), (1, 1), (2, 0), (2, 1)], F(1, 4)),
        "butterfly": {(0, 0): 1},
        "interpolatory_from_loop": {(0, 0): 1},
        "quincunx_interpolatory": {(0, 0): 1},
        "quincunx_linear": {(2, 1): 1},
        "catmull_clark": {
            (i, j): F(x * y, 36) for (i, x), (j, y) in product(zip((-1, 0, 1), (1, 4, 1), strict=True), repeat=2)
        },
    }.items(),
)
def test_values_that_are_known(name, values):
    assert at_integers(*read(name)) == values


def test_one_function_two_dilations():
    """The 4-8 scheme and the box spline over 2I: the same function."""
    assert at_integers(*read("velho_zorin")) == at_integers(*read("box_2222"))


@pytest.mark.parametrize("name", CONTINUOUS)
def test_the_refinement_equation_and_the_partition_of_unity(name):
    scheme, lattice = read(name)
    integers = at_integers(scheme, lattice)
    coarse, fine = (at_fractions(scheme, lattice, integers, level) for level in (1, 2))
    assert at_fractions(scheme, lattice, integers, 0) == integers
    step = [lattice.image(gamma) for gamma in scheme.terms]
    some = {tuple(b + g for b, g in zip(beta, gamma, strict=True)) for beta in coarse for gamma in step} | {*fine}
    for alpha in sorted(some)[:: 1 + len(some) // 500]:
        terms = zip(scheme.terms.values(), step, strict=True)
        asked = ((a, tuple(x - g for x, g in zip(alpha, gamma, strict=True))) for a, gamma in terms)
        assert fine.get(alpha, 0) == sum(a * coarse.get(index, 0) for a, index in asked)
    assert {lattice.image(lattice.image(alpha)): x for alpha, x in integers.items()}.items() <= fine.items()
    assert unity(lattice, fine) == {F(1)}
    box = support_box(scheme, lattice)
    rows = lattice.inverse_power(2)
    for alpha in list(fine)[:: 1 + len(fine) // 200]:
        point = [sum(x * y for x, y in zip(row, alpha, strict=True)) for row in rows]
        assert all(low <= x <= high for x, (low, high) in zip(point, box, strict=True))


def unity(lattice, fine):
    """The sums of φ over the translates by Z^s of each point of M^-2 Z^s."""
    rows, sums = lattice.inverse_power(2), {}
    for alpha, value in fine.items():
        key = tuple(sum(x * y for x, y in zip(row, alpha, strict=True)) % 1 for row in rows)
        sums[key] = sums.get(key, 0) + value
    assert len(sums) == lattice.index**2
    return set(sums.values())


@pytest.mark.parametrize("name", ["trilinear", "tricubic", "box_bcc_quintic", "box_fcc_cubic"])
def test_a_slice_is_what_it_is_cut_from(name):
    scheme, lattice = read(name)
    integers = at_integers(scheme, lattice)
    fine = at_fractions(scheme, lattice, integers, 2)
    for height in range(-8, 16, 3):
        expected = {alpha: x for alpha, x in fine.items() if alpha[2] == height}
        assert at_fractions(scheme, lattice, integers, 2, (height,)) == expected


@pytest.mark.parametrize("text", ["(1+z1)(1+z2)", "(1+z1)^2 (1+z2)^2/4"])
def test_where_the_equation_does_not_determine_it(text):
    """Haar: every split of the jumps is a solution. And a mask whose coefficients add up to 4 over 3I."""
    scheme = from_option(text, arity=2 if text[-1] == ")" else 3).scheme()
    with pytest.raises(NoValuesError, match="does not determine"):
        at_integers(scheme, Lattice(scheme.dilation))


def test_limits(monkeypatch):
    scheme, lattice = read("loop")
    integers = at_integers(scheme, lattice)
    with pytest.raises(NoValuesError, match="too many values at level 9"):
        at_fractions(scheme, lattice, integers, 9)
    monkeypatch.setattr(multivariate_values, "LARGEST_WINDOW", 18)
    with pytest.raises(NoValuesError, match="19 integers; the limit is 18"):
        at_integers(scheme, lattice)
    far = from_option("[[1,1],[1,1]]", start=(0, 0)).scheme()
    wide = type(far)(dilation=far.dilation, terms={(0, 0): F(2), (10**6, 10**6): F(2)})
    with pytest.raises(NoValuesError, match="too large"):
        at_integers(wide, Lattice(wide.dilation))
