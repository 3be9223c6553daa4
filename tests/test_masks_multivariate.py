"""The catalog in several variables: every file is read, and its terms are what the mask is known to be."""

import json
import re
import tomllib
from fractions import Fraction
from itertools import product
from math import comb, prod
from pathlib import Path

import pytest

from subdiv_cli.exact.closed import closed_interval
from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.kinds.writing import from_scheme, write
from subdiv_cli.spaces.lattice import characteristic_polynomial, is_expanding

HERE = Path(__file__).parent
MASKS = HERE.parent / "masks" / "multivariate"
FILES = sorted(MASKS.rglob("*.toml"))
ROWS = json.loads((HERE / "data" / "reference_multivariate.json").read_text(encoding="utf-8"))
FILE_OF = {
    "tensor2": "doo_sabin", "courant": "courant", "loop": "loop", "zp": "zwart_powell", "box221": "box_221",
    "tensor_dd4": "tensor_four_point", "butterfly_1/16": "butterfly", "butterfly_1/32": "butterfly_1_32",
    "sqrt3_kobbelt": "kobbelt_sqrt3", "quincunx2": "quincunx_interpolatory", "4-8": "velho_zorin", "bear1": "bear",
}  # fmt: skip


def residue(index, rows):
    """Equal for two indices iff they are in one coset of M Z^s: M^-1 α modulo Z^s, by Cramer's rule."""
    size = len(rows)
    determinant = abs(characteristic_polynomial(rows)[0])
    coordinates = []
    for j in range(size):
        columns = [[index[i] if k == j else rows[i][k] for k in range(size)] for i in range(size)]
        coordinates.append(laplace(columns) * (1 if laplace(rows) > 0 else -1) % determinant)
    return tuple(coordinates)


def laplace(rows):
    """A determinant along the first row."""
    if not rows:
        return 1
    rest = [[row[:j] + row[j + 1 :] for row in map(list, rows[1:])] for j in range(len(rows))]
    return sum((-1) ** j * rows[0][j] * laplace(rest[j]) for j in range(len(rows)))


def moments(scheme, powers):
    """Σ a_α α^μ over each coset."""
    sums = {}
    for index, value in scheme.terms.items():
        coset = residue(index, scheme.dilation)
        sums[coset] = sums.get(coset, 0) + value * prod(x**e for x, e in zip(index, powers, strict=True))
    missing = abs(characteristic_polynomial(scheme.dilation)[0]) - len(sums)
    return [*sums.values(), *[Fraction(0)] * min(missing, 1)]


def sum_rule_order(scheme, most=8):
    """The largest k such that the moments of degree below k are the same over every coset."""
    for degree in range(most):
        for powers in product(range(degree + 1), repeat=scheme.dimension):
            if sum(powers) == degree and len(set(moments(scheme, powers))) > 1:
                return degree
    return most


def up_to_a_shift(terms):
    lowest = [min(column) for column in zip(*terms, strict=True)]
    return {tuple(x - y for x, y in zip(index, lowest, strict=True)): value for index, value in terms.items()}


def document(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


def test_there_are_enough_masks_in_every_form():
    assert len(list(MASKS.glob("*.toml"))) >= 25
    assert len(list((MASKS / "counterexamples").glob("*.toml"))) >= 6
    masks = [document(path)["mask"] for path in FILES]
    for form in ("coefficients", "terms", "symbol", "box_spline", "tensor"):
        assert sum(form in mask for mask in masks) >= 3
    assert {len(read_path(path).scheme().dilation) for path in FILES} == {2, 3}
    names = [document(path)["name"] for path in FILES]
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_what_every_file_says(path):
    assert re.fullmatch(r"[a-z0-9]+(_[a-z0-9]+)*", path.stem)
    assert path.read_text(encoding="utf-8").startswith("# ")
    said = document(path)
    assert (said["format"], said["kind"]) == (1, "multivariate")
    assert said["name"].strip()
    assert said["reference"].strip()
    assert isinstance(said["expect"]["convergent"], bool)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_file_is_read_and_written(path):
    mask = read_path(path)
    scheme = mask.scheme()
    assert is_expanding(scheme.dilation)
    assert read_text(write(mask), file=mask.file) == mask
    assert read_text(write(from_scheme(scheme)), file="x").scheme() == scheme


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_sums_and_sum_rules_agree_with_the_expectations(path):
    """Convergence needs coset sums of 1; a stable mask generates polynomials of degree below its sum-rule order."""
    mask = read_path(path)
    scheme, expected = mask.scheme(), {e.key: e.lower for e in mask.expectations}
    sums = moments(scheme, (0,) * scheme.dimension)
    if expected["convergent"]:
        assert set(sums) == {1}
        assert sum(scheme.terms.values()) == abs(characteristic_polynomial(scheme.dilation)[0])
    if "generation" in expected:
        assert sum_rule_order(scheme) == expected["generation"] + 1
        assert expected.get("reproduction", 0) <= expected["generation"]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_reference_row_is_in_the_catalog(row):
    """The same terms up to a shift, and no expectation that contradicts the reference value."""
    mask = read_path(MASKS / f"{FILE_OF[row['id']]}.toml")
    scheme, truth = mask.scheme(), row["truth"]
    terms = {tuple(map(int, key.split(","))): Fraction(value) for key, value in row["terms"].items()}
    assert up_to_a_shift(scheme.terms) == up_to_a_shift(terms)
    assert [list(r) for r in scheme.dilation] == row["dilation"]
    assert sum_rule_order(scheme) == truth["sum_rule_order"]
    expected = {e.key: e for e in mask.expectations}
    assert expected["convergent"].lower is truth["converges"]
    assert expected["smoothness"].lower == truth["smoothness"]
    if "stable" in expected and truth["stable"] is not None:
        assert expected["stable"].lower is truth["stable"]
    low, high = truth["holder_of_limits"]
    if "holder" in expected:
        assert closed_interval(expected["holder"].lower).lower <= high + 1e-6
        assert expected["holder"].upper is None or closed_interval(expected["holder"].upper).upper >= low - 1e-6


@pytest.mark.parametrize("path", [p for p in FILES if "box_spline" in document(p)["mask"]], ids=lambda path: path.stem)
def test_box_splines_follow_the_combinatorial_rule(path):
    """α + 1 directions have to go before the others lie in a plane; stable iff all bases have determinant 1."""
    mask = read_path(path)
    directions = [d for d, m in zip(mask.body.directions, mask.body.multiplicities, strict=True) for _ in range(m)]
    size = len(directions[0])
    bases = [basis for basis in product(sorted(set(directions)), repeat=size) if laplace(list(basis))]
    flat = (
        [d for d in directions if not laplace([*picked, d])]
        for picked in product(directions, repeat=size - 1)
        if any(laplace([*picked, d]) for d in directions)
    )
    alpha = len(directions) - max(map(len, flat)) - 1
    expected = {e.key: e.lower for e in mask.expectations}
    if not expected["convergent"]:
        return
    assert expected["smoothness"] == alpha - 1
    assert expected["holder"] == alpha
    assert expected["stable"] is all(abs(laplace(list(basis))) == 1 for basis in bases)
    assert sum(mask.scheme().terms.values()) == mask.scheme().dilation[0][0] ** size


def test_the_factored_butterfly_is_the_butterfly():
    listed = read_path(MASKS / "butterfly.toml")
    factored = read_path(MASKS / "butterfly_1_12.toml")
    for w in (Fraction(1, 16), Fraction(-2, 7), Fraction(0)):
        assert listed.scheme({"w": w}).terms == factored.scheme({"w": w}).terms


def test_a_box_spline_of_one_direction_often_is_a_binomial():
    """(1+z1)^5 (1+z2) by its coefficients."""
    text = 'kind = "multivariate"\n[mask]\nbox_spline = {directions = [[1,0], [0,1]], multiplicities = [5, 1]}\n'
    terms = read_text(text, file="x").scheme().terms
    assert terms == {(i, j): Fraction(comb(5, i), 16) for i in range(6) for j in range(2)}
