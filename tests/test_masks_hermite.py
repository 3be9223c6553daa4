"""The catalog of Hermite masks: what its files say, and that they are the masks that their names promise."""

import re
import tomllib
from fractions import Fraction
from pathlib import Path

import pytest
from matrix_masks import (
    UNSEEN,
    conjugated,
    de_rham,
    hermite_interpolation,
    merrien,
    smoothed_jets,
)

from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.kinds.writing import from_scheme, write

MASKS = Path(__file__).parents[1] / "masks" / "hermite"
FILES = sorted(MASKS.rglob("*.toml"))
KEYS = {"format", "name", "reference", "kind", "parameters", "mask", "expect"}
CUBIC, QUINTIC = hermite_interpolation(2), hermite_interpolation(3)
KNOWN = {
    "hermite_cubic": CUBIC,
    "hermite_quintic": QUINTIC,
    "hermite_septic": hermite_interpolation(4),
    "ternary_hermite_cubic": hermite_interpolation(2, 3),
    "merrien_8_1": merrien("-1/8", -1),
    "merrien_8_half": merrien("-1/8", "1/2"),
    "merrien_10": merrien("-1/10", "-1/2"),
    "merrien_4": merrien("-1/4", "-1/2"),
    "merrien_8_2": merrien("-1/8", 2),
    "hermite_cubic_smoothed": smoothed_jets(CUBIC),
    "de_rham_cubic": de_rham(CUBIC),
    "de_rham_cubic_smoothed": smoothed_jets(de_rham(CUBIC)),
    "de_rham_quintic": de_rham(QUINTIC),
    "unseen_linear": UNSEEN,
    "twice_the_derivative": conjugated(CUBIC, [[1, 0], [0, Fraction(1, 2)]], [[1, 0], [0, 2]]),
}


def load(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


def test_there_are_enough_masks():
    assert len(FILES) >= 16
    assert len(list((MASKS / "counterexamples").glob("*.toml"))) >= 4


def test_names_are_unique():
    assert len({path.stem for path in FILES}) == len({load(path)["name"] for path in FILES}) == len(FILES)
    assert all(re.fullmatch(r"[a-z0-9]+(_[a-z0-9]+)*", path.stem) for path in FILES)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_what_every_file_says(path):
    found = load(path)
    assert path.read_text(encoding="utf-8").startswith("# ")
    assert found.keys() <= KEYS
    assert (found["format"], found["kind"]) == (1, "hermite")
    assert found["name"].strip()
    assert found["reference"].strip()
    expect = found["expect"]
    assert expect["convergent"] is (path.parent.name != "counterexamples")
    assert ("smoothness" in expect) is expect["convergent"]
    assert {"spectral", "generation"} <= expect.keys()
    assert not any(isinstance(x, float) for a in found["mask"]["coefficients"] for row in a for x in row)


@pytest.mark.parametrize("name", KNOWN)
def test_the_masks_are_those_of_their_names(name):
    (path,) = (path for path in FILES if path.stem == name)
    scheme = read_path(path).scheme()
    rows = dict(enumerate(scheme.coefficients, scheme.start))
    known = {i: tuple(tuple(map(Fraction, row)) for row in a) for i, a in KNOWN[name].items()}
    zero = tuple((Fraction(0),) * scheme.size for _ in range(scheme.size))
    assert {i: a for i, a in rows.items() if a != zero} == {i: a for i, a in known.items() if a != zero}
    assert scheme.kind == "hermite"


@pytest.mark.parametrize("path", FILES[:6], ids=lambda path: path.stem)
def test_files_are_written_and_read_again(path):
    mask = read_path(path)
    assert read_text(write(mask), file=str(path)) == mask
    scheme = mask.scheme()
    written = write(from_scheme(scheme))
    assert 'kind = "hermite"' in written
    assert read_text(written, file="-").scheme() == scheme
