"""Masks in several variables: the five forms, parameters, files in tensor products, and the way back to text."""

from __future__ import annotations

import contextlib
import os
from fractions import Fraction as Q
from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support import canonical

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.kinds.writing import from_scheme, write
from subdiv_cli.maskfile import MaskFile, MaskFileError
from subdiv_cli.maskfile.laurent import BoundedLaurent, Work, exponents, packed, quotient, times

HEAD = 'kind = "multivariate"\n[mask]\n'
QUINCUNX = ((1, 1), (1, -1))
BILINEAR = {(i, j): Q(1, 2 ** (abs(i) + abs(j))) for i in (-1, 0, 1) for j in (-1, 0, 1)}


def read(mask: str, *, file: str = "x.toml", parameters: str = "") -> MaskFile:
    head = f"[parameters]\n{parameters}\n" if parameters else ""
    return read_text(f'kind = "multivariate"\n{head}[mask]\n{mask}\n', file=file)


@pytest.mark.parametrize(
    "mask",
    [
        'start = [-1, -1]\ncoefficients = [["1/4", 0.5, "1/4"], ["1/2", 1, "1/2"], ["1/4", "1/2", 0.25]]',
        '[mask.terms]\n"0,0" = 1\n'
        + "\n".join(f'"{i}, {j}" = "1/{2 ** (abs(i) + abs(j))}"' for i, j in BILINEAR if (i, j) != (0, 0)),
        'symbol = "z1^-1 z2^-1 ((1+z1)(1+z2)/2)^2"',
        'symbol = "(1+z1)(1-z1^2)/(1-z1) * (1+z2)^2 / (4 z1 z2)"\ndilation = [[2, 0], [0, 2]]',
        'tensor = [{symbol = "z^-1 (1+z)^2/2"}, {start = -1, coefficients = ["1/2", 1, "1/2"]}]\ndilation = 2',
    ],
)
def test_forms_of_one_mask(mask: str) -> None:
    scheme = read(mask).scheme()
    assert scheme == MultivariateScheme(dilation=((2, 0), (0, 2)), terms=BILINEAR)
    assert canonical(scheme) == {
        "kind": "multivariate",
        "dilation": [[2, 0], [0, 2]],
        "terms": [[[i, j], "1" if i == j == 0 else f"1/{2 ** (abs(i) + abs(j))}"] for i, j in sorted(BILINEAR)],
    }


def test_a_box_spline_begins_at_the_origin() -> None:
    mask = "box_spline = {directions = [[1,0],[0,1]], multiplicities = [2,2]}"
    assert read(mask).scheme().terms == {(i + 1, j + 1): value for (i, j), value in BILINEAR.items()}


def test_coefficients_of_three_variables() -> None:
    scheme = read("start = [0, -1, 2]\ndilation = 3\ncoefficients = [[[1, 2], [3, 0]], [[0, 0], [0, 5]]]").scheme()
    assert scheme.terms == {(0, -1, 2): 1, (0, -1, 3): 2, (0, 0, 2): 3, (1, 0, 3): 5}
    assert scheme.dilation == ((3, 0, 0), (0, 3, 0), (0, 0, 3))


def test_the_dilation_says_how_many_variables_a_symbol_has() -> None:
    scheme = read('dilation = [[1, -2], [1, 0]]\nsymbol = "(1+z1)^2/2"').scheme()
    assert scheme == MultivariateScheme(
        dilation=((1, -2), (1, 0)), terms={(0, 0): Q(1, 2), (1, 0): Q(1), (2, 0): Q(1, 2)}
    )
    assert read('symbol = "z3"').scheme().terms == {(0, 0, 1): 1}
    assert read('symbol = "z4^-2"').scheme().terms == {(0, 0, 0, -2): 1}


@pytest.mark.parametrize("c", [2, 3, 4])
@pytest.mark.parametrize(
    "directions", ["[[1,0],[0,1],[1,1]]", "[[1,0,0],[0,1,0],[0,0,1],[-1,-1,-1]]", "[[2,1],[1,-1]]"]
)
def test_a_box_spline_sums_to_the_determinant(c: int, directions: str) -> None:
    scheme = read(f"dilation = {c}\nbox_spline = {{directions = {directions}}}").scheme()
    assert sum(scheme.terms.values()) == c**scheme.dimension


@pytest.mark.parametrize(
    "mask",
    [
        'start = [0, 0]\ncoefficients = [["w", "1 - w"], [0, "w^2"]]',
        'terms = {"0,0" = "w", "0,1" = "1 - w", "1,1" = "w^2"}',
        'symbol = "w + (1-w) z2 + w^2 z1 z2"',
    ],
)
def test_parameters(mask: str) -> None:
    found = read(mask, parameters='w = "1/3"')
    for w in (Q(1, 3), Q(-5, 7)):
        assert found.scheme({"w": w}).terms == {(0, 0): w, (0, 1): 1 - w, (1, 1): w**2}
    assert found.scheme().terms[0, 0] == Q(1, 3)
    assert found.scheme({"w": Q(1)}).terms == {(0, 0): 1, (1, 1): 1}
    with pytest.raises(MaskFileError):
        found.scheme({"v": Q(1)})


def test_a_tensor_product_takes_files_beside_it_and_parameters(tmp_path) -> None:
    (tmp_path / "one.toml").write_text('[parameters]\nw = "1/4"\n[mask]\nstart = -1\ncoefficients = ["w", 1, "w"]\n')
    file = tmp_path / "sub" / "two.toml"
    file.parent.mkdir()
    text = HEAD.replace("[mask]", '[parameters]\nw = "1/8"\n[mask]')
    file.write_text(text + 'tensor = ["../one.toml", {symbol = "1 + w z"}]\n')
    mask = read_path(file)
    assert mask.scheme().terms == {
        (i, j): x * y for i, x in ((-1, Q(1, 4)), (0, Q(1)), (1, Q(1, 4))) for j, y in ((0, Q(1)), (1, Q(1, 8)))
    }
    assert mask.scheme({"w": Q(5)}).terms[-1, 1] == Q(5, 4)
    assert read_text(write(mask), file=str(file)) == mask


def test_what_is_wrong_in_a_file_of_a_tensor_product_is_said(tmp_path) -> None:
    bad = {
        "text.toml": ("[mask]\nstart = 0\ncoefficients = [1/2]\n", "SD003"),
        "open.toml": ('[parameters]\nw = ""\n[mask]\nsymbol = "1 + w z"\n', "SD011"),
        "plane.toml": (HEAD + 'tensor = ["plane.toml", "plane.toml"]\n', "SD013"),
        "empty.toml": ("", "SD016"),
    }
    os.mkfifo(tmp_path / "pipe.toml")
    for name, (text, code) in bad.items():
        (tmp_path / name).write_text(text)
        with pytest.raises(MaskFileError) as caught:
            read(f'tensor = ["{name}", {{symbol = "1+z"}}]', file=str(tmp_path / "x.toml"))
        (problem,) = caught.value.problems
        assert (problem.code, problem.key, problem.line) == (code, "mask.tensor[0]", 3)
        assert problem.message.startswith(f'in "{name}"')
    with pytest.raises(MaskFileError, match="no regular file"):
        read('tensor = ["pipe.toml", {symbol = "1+z"}]', file=str(tmp_path / "x.toml"))


def test_other_kinds_are_refused_where_one_variable_is_meant() -> None:
    text = 'kind = "multivariate"\n[mask]\nsymbol = "1 + z2"\n'
    with pytest.raises(MaskFileError) as caught:
        read_text(text, file="mask.toml", wanted="scalar")
    (problem,) = caught.value.problems
    assert (problem.code, problem.key, problem.line) == ("SD013", "kind", 1)


powers = st.tuples(*[st.integers(-9, 9)] * 3)
polynomials = st.dictionaries(powers, st.integers(-9, 9).filter(bool), min_size=1, max_size=6)


def laurent(terms: dict[tuple[int, ...], int]) -> BoundedLaurent:
    return BoundedLaurent({packed((0, *k)): int(n) for k, n in terms.items()})


@settings(max_examples=200, deadline=None)
@given(polynomials, polynomials)
def test_products_and_quotients_of_several_variables(
    a: dict[tuple[int, ...], int], b: dict[tuple[int, ...], int]
) -> None:
    expected: dict[tuple[int, ...], int] = {}
    for (j, m), (k, n) in product(a.items(), b.items()):
        key = tuple(x + y for x, y in zip(j, k, strict=True))
        expected[key] = expected.get(key, 0) + m * n
    found = times(laurent(a), laurent(b), Work())
    assert found.terms(3) == {k: n for k, n in expected.items() if n}
    again = quotient(found, laurent(b), Work())
    assert again is not None
    assert again.terms(3) == a
    more = laurent({**found.terms(3), (40, 0, 0): 1})
    assert (quotient(more, laurent(b), Work()) is None) is (len(b) > 1)


@given(st.lists(st.integers(-2_000_000, 2_000_000), min_size=5, max_size=5))
def test_exponents_are_read_off_as_they_were_packed(digits: list[int]) -> None:
    assert list(exponents(packed(digits))) == digits


DILATIONS = {
    2: [((2, 0), (0, 2)), ((3, 0), (0, 3)), QUINCUNX, ((2, -1), (1, -2)), ((2, 0), (0, 3))],
    3: [((2, 0, 0), (0, 2, 0), (0, 0, 2)), ((0, 0, 2), (1, 0, 0), (0, 1, 0))],
    4: [((2, 0, 0, 0), (0, 2, 0, 0), (0, 0, 2, 0), (0, 0, 0, 2))],
}


@st.composite
def schemes(draw: st.DrawFn) -> MultivariateScheme:
    s = draw(st.integers(2, 4))
    keys = st.tuples(*[st.integers(-99, 99)] * s)
    values = st.fractions(max_denominator=999).filter(bool)
    terms = draw(st.dictionaries(keys, values, min_size=1, max_size=20))
    return MultivariateScheme(dilation=draw(st.sampled_from(DILATIONS[s])), terms=terms)


@settings(max_examples=100, deadline=None)
@given(schemes())
def test_schemes_written_and_read(scheme: MultivariateScheme) -> None:
    mask = from_scheme(scheme, file="f", name="drawn", reference="none")
    again = read_text(write(mask), file="f")
    assert again == mask
    assert again.scheme() == scheme
    assert canonical(again.scheme()) == canonical(scheme)


numbers = st.sampled_from(["1", "0", "-3", '"1/2 + w"', '"-w"', "0.25", '"w^2 (1 - w)"', '"2w/3"'])


@st.composite
def masks(draw: st.DrawFn) -> str:
    form = draw(st.sampled_from(["coefficients", "terms", "symbol", "box_spline", "tensor"]))
    if form == "coefficients":
        columns = draw(st.integers(1, 4))
        rows = draw(st.lists(st.lists(numbers, min_size=columns, max_size=columns), min_size=1, max_size=4))
        said = ", ".join(f"[{', '.join(row)}]" for row in [*rows, ["1"] * columns])
        return f"dilation = [[1, 1], [1, -1]]\nstart = [{draw(st.integers(-9, 9))}, 0]\ncoefficients = [{said}]"
    if form == "terms":
        terms = draw(st.dictionaries(powers, numbers, max_size=9)) | {(0, 0, 10): "1"}
        return "dilation = 3\n[mask.terms]\n" + "\n".join(f'"{i},{j},{k}" = {x}' for (i, j, k), x in terms.items())
    if form == "symbol":
        factors = draw(
            st.lists(st.sampled_from(["(1+z1)", "(1+z2)^2", "(1 + z1 z3)", "z2^-3", "(1 + w z1)"]), min_size=1)
        )
        return f'symbol = "{" ".join(factors[:6])} (1+z3)"'
    if form == "box_spline":
        more = draw(st.lists(st.sampled_from(["[1,1]", "[1,-1]", "[2,1]"]), max_size=3))
        return f"dilation = {draw(st.integers(2, 4))}\nbox_spline = {{directions = [[1,0], [0,1], {', '.join(more)}]}}"
    return f'tensor = [{{symbol = "1+w+z"}}, {{start = 2, coefficients = [{draw(numbers)}, 1]}}, {{symbol = "1+z"}}]'


@settings(max_examples=150, deadline=None)
@given(masks())
def test_written_masks_read_back_equal(text: str) -> None:
    mask = read(text, parameters='w = "1/16"')
    again = read_text(write(mask), file=mask.file)
    assert again == mask
    assert write(again) == write(mask)
    assert again.scheme() == mask.scheme()


def test_writing_keeps_what_a_difference_would_show() -> None:
    text = HEAD + 'dilation = [[2, 0], [0, 3]]\nstart = [0, 1]\ncoefficients = [[1, 2], [3, "1/2"]]\n'
    for old, new in [("[0, 3]", "[1, 3]"), ("[0, 1]", "[1, 1]"), ('"1/2"', '"2/4"'), ("[1, 2]", "[2, 1]")]:
        assert read_text(text.replace(old, new), file="x") != read_text(text, file="x")


@settings(max_examples=300, deadline=None)
@given(masks(), st.integers(0, 200), st.integers(0, 5), st.text("w[]\"'=/^-+()12.\n{}z#,", max_size=4))
def test_any_text_is_read_or_refused(text: str, at: int, length: int, replacement: str) -> None:
    """Mutated masks: nothing but MaskFileError is raised, and a mask that is read is written and read again."""
    text = text[:at] + replacement + text[at + length :]
    with contextlib.suppress(MaskFileError):
        mask = read(text, parameters='w = "1/16"')
        scheme = mask.scheme()
        assert read_text(write(mask), file=mask.file).scheme() == scheme
