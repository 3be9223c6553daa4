"""The catalog of masks of matrices: what its files say, and that they are the masks that their names promise."""

import re
import tomllib
from fractions import Fraction
from pathlib import Path

import pytest
from matrix_masks import DGHM, HERMITE_CUBIC, blocked, diagonal, scalar, smoothed, spline

from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.kinds.writing import from_scheme, write

MASKS = Path(__file__).parents[1] / "masks" / "vector"
FILES = sorted(MASKS.rglob("*.toml"))
KEYS = {"format", "name", "reference", "kind", "parameters", "mask", "expect"}
FOUR_POINT = ("-1/16", 0, "9/16", 1, "9/16", 0, "-1/16")
THREE_QUARTERS = ("-3/4", 0, "5/4", 1, "5/4", 0, "-3/4")
FIFTH = ("-3/20", 0, "13/20", 1, "13/20", 0, "-3/20")
SIX_POINT = [Fraction(x, 256) for x in (3, 0, -25, 0, 150, 256, 150, 0, -25, 0, 3)]
HALF = Fraction(1, 2)
ONCE = smoothed(spline(3, 2), [[1, -1], [1, 1]], [[HALF, HALF], [-HALF, HALF]])
KNOWN = {
    "double_knot_quadratic": spline(2, 2),
    "double_knot_cubic": spline(3, 2),
    "double_knot_quartic": spline(4, 2),
    "triple_knot_cubic": spline(3, 3),
    "triple_knot_quartic": spline(4, 3),
    "ternary_double_knot_cubic": spline(3, 2, 3),
    "double_knot_linear": spline(1, 2),
    "double_knot_cubic_smoothed": ONCE,
    "double_knot_cubic_smoothed_twice": smoothed(
        ONCE, [[1, 2], [1, -3]], [[Fraction(3, 5), Fraction(2, 5)], [Fraction(1, 5), Fraction(-1, 5)]]
    ),
    "hermite_cubic": HERMITE_CUBIC,
    "dghm": DGHM,
    "chaikin_in_pairs": blocked(("1/4", "3/4", "3/4", "1/4"), -1, 2),
    "four_point_in_pairs": blocked(FOUR_POINT, -3, 2),
    "four_point_in_threes": blocked(FOUR_POINT, -3, 3),
    "four_point_3_20_in_pairs": blocked(FIFTH, -3, 2),
    "four_point_3_4_in_pairs": blocked(THREE_QUARTERS, -3, 2),
    "six_point_in_threes": blocked(SIX_POINT, -5, 3),
    "unstable_flat_in_pairs": blocked(("1/2",) * 4, 0, 2),
    "two_four_points": diagonal(scalar(FOUR_POINT, -3), scalar(FOUR_POINT, -3)),
    "stretched_chaikin_in_pairs": blocked([Fraction(x, 4) for x in (1, 0, 0, 3, 0, 0, 3, 0, 0, 1)], -4, 2),
}


def load(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


def test_there_are_enough_masks():
    assert len(list(MASKS.glob("*.toml"))) >= 20
    assert len(list((MASKS / "counterexamples").glob("*.toml"))) >= 8


def test_names_are_unique():
    assert len({path.stem for path in FILES}) == len({load(path)["name"] for path in FILES}) == len(FILES)
    assert all(re.fullmatch(r"[a-z0-9]+(_[a-z0-9]+)*", path.stem) for path in FILES)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_what_every_file_says(path):
    found = load(path)
    assert path.read_text(encoding="utf-8").startswith("# ")
    assert found.keys() <= KEYS
    assert (found["format"], found["kind"]) == (1, "vector")
    assert found["name"].strip()
    assert found["reference"].strip()
    expect = found["expect"]
    assert expect["convergent"] is (path.parent.name != "counterexamples")
    assert ("smoothness" in expect) is ("holder" in expect) is expect["convergent"]
    assert "dimension" in expect
    assert not any(isinstance(x, float) for a in found["mask"]["coefficients"] for row in a for x in row)


@pytest.mark.parametrize("name", KNOWN)
def test_the_masks_are_those_of_their_names(name):
    (path,) = (path for path in FILES if path.stem == name)
    scheme = read_path(path).scheme()
    rows = dict(enumerate(scheme.coefficients, scheme.start))
    known = {i: tuple(tuple(map(Fraction, row)) for row in a) for i, a in KNOWN[name].items()}
    zero = tuple((Fraction(0),) * scheme.size for _ in range(scheme.size))
    assert {i: a for i, a in rows.items() if a != zero} == {i: a for i, a in known.items() if a != zero}


@pytest.mark.parametrize("path", FILES[:6], ids=lambda path: path.stem)
def test_files_are_written_and_read_again(path):
    mask = read_path(path)
    assert read_text(write(mask), file=str(path)) == mask
    scheme = mask.scheme()
    assert read_text(write(from_scheme(scheme)), file="-").scheme() == scheme


def test_parameters_stand_in_matrices():
    text = 'kind = "vector"\n[parameters]\nw = "1/4"\n[mask]\nstart = 0\ncoefficients = [[["w", 0], [0, "1 - 2w"]]]\n'
    assert read_text(text, file="-").scheme({"w": Fraction(1, 3)}).coefficients == (
        ((Fraction(1, 3), 0), (0, Fraction(1, 3))),
    )
