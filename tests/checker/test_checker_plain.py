"""Plain mask files: what the checker reads itself is what subdiv reads, and it leaves alone what is not plain."""

from fractions import Fraction
from pathlib import Path

import pytest
from hand_made import ALL, text
from hand_made_multivariate import ALL_MULTIVARIATE
from hypothesis import given
from hypothesis import strategies as st
from support import canonical

from subdiv_cli.checker.__main__ import main
from subdiv_cli.checker.plain import PlainMask, certified_mask, mask_of, plain_mask
from subdiv_cli.checker.scalar.masks import plain
from subdiv_cli.kinds.reading import read_text

MASKS = sorted((Path(__file__).parents[2] / "masks").rglob("*.toml"))


def test_of_every_shipped_plain_file_it_reads_the_same():
    plain = 0
    for file in MASKS:
        content = file.read_text(encoding="utf-8")
        if (found := plain_mask(content)) is not None:
            plain += 1
            assert found == mask_of(canonical(read_text(content, file=str(file)).scheme()))
    assert plain > 20


numbers = st.one_of(
    st.integers(-50, 50).map(lambda n: (str(n), Fraction(n))),
    st.fractions(-9, 9, max_denominator=99).map(lambda x: (f'"{x}"', x)),
    st.integers(-999, 999).map(
        lambda n: (f"{'-' if n < 0 else ''}{abs(n) // 100}.{abs(n) % 100:02d}", Fraction(n, 100))
    ),
)


@given(st.lists(numbers, min_size=1, max_size=9), st.integers(-5, 5), st.integers(2, 4))
def test_literal_numbers(entries, start, arity):
    content = f"[mask]\narity = {arity}\nstart = {start}\ncoefficients = [{', '.join(s for s, _ in entries)}]\n"
    assert plain_mask(content) == plain(arity, start, [x for _, x in entries])


def test_a_mask_without_start_begins_at_zero():
    assert plain_mask("[mask]\ncoefficients = [1, 2]\n") == plain(2, 0, [Fraction(1), Fraction(2)])
    heading = 'kind = "multivariate"\n[mask]\n'
    for rows, start in (("[[1, 2]]", "[0, 0]"), ("[[[1, 2]]]", "[0, 0, 0]")):
        found = plain_mask(f"{heading}coefficients = {rows}\n")
        assert found is not None
        assert found == plain_mask(f"{heading}start = {start}\ncoefficients = {rows}\n")


@pytest.mark.parametrize(
    "content",
    [
        "",
        "[mask",
        'kind = "vector"\n[mask]\nstart = 0\ncoefficients = [1]\n',
        "[mask]\nstart = 0\n",
        "[mask]\nstart = 0\ncoefficients = [[1, 1]]\n",
        'kind = "multivariate"\n[mask]\ncoefficients = [1, 1]\n',
        'kind = "multivariate"\n[mask]\ncoefficients = ' + "[" * 9 + "1" + "]" * 9 + "\n",
        '[mask]\nsymbol = "1+z"\n',
        '[parameters]\nw = 1\n[mask]\nstart = 0\ncoefficients = [1, "w"]\n',
        '[mask]\nstart = 0\ncoefficients = [1, "1/0"]\n',
        "[mask]\nstart = 0\ncoefficients = [true, 1]\n",
        "[mask]\nstart = 0\ncoefficients = [nan, 1]\n",
        "[mask]\nstart = 0\ncoefficients = []\n",
        "[mask]\nstart = 0.5\ncoefficients = [1, 1]\n",
        '[mask]\nstart = 0\ncoefficients = [1, "1 + 1"]\n',
        'kind = "multivariate"\n[mask]\nsymbol = "1 + z1 z2"\n',
        'kind = "multivariate"\n[mask]\nbox_spline = {directions = [[1, 0], [0, 1]]}\n',
        'kind = "multivariate"\n[mask]\nterms = {}\n',
        'kind = "multivariate"\n[mask]\nterms = 1\n',
        'kind = "multivariate"\n[mask]\nterms = {"0, 0" = 1}\n',
        'kind = "multivariate"\n[mask]\nterms = {"0" = 1}\n',
        'kind = "multivariate"\n[mask]\nterms = {"0,00" = 1}\n',
        'kind = "multivariate"\n[mask]\nterms = {"0,0" = "w"}\n',
        'kind = "multivariate"\n[mask]\nterms = {"0,0" = "1/0"}\n',
        'kind = "multivariate"\n[mask]\nterms = {"0,0" = 1, "0,0,0" = 1}\n',
        'kind = "multivariate"\n[mask]\nterms = {"0,0" = 1}\nstart = [0, 0]\n',
        'kind = "multivariate"\n[mask]\ndilation = [[2]]\nterms = {"0,0" = 1}\n',
        'kind = "multivariate"\n[mask]\ndilation = "2"\nterms = {"0,0" = 1}\n',
        'kind = "multivariate"\n[mask]\ndilation = true\nterms = {"0,0" = 1}\n',
        'kind = "multivariate"\n[mask]\nstart = [0, 0]\ncoefficients = [1, 1]\n',
        'kind = "multivariate"\n[mask]\nstart = [0, 0]\ncoefficients = [[1], [1, 1]]\n',
        'kind = "multivariate"\n[mask]\nstart = [0, 0]\ncoefficients = [[[1]]]\n',
        'kind = "multivariate"\n[mask]\nstart = [0, 0]\ncoefficients = []\n',
        'kind = "multivariate"\n[mask]\nstart = 0\ncoefficients = [1, 1]\n',
    ],
)
def test_other_files_are_left_alone(content):
    assert plain_mask(content) is None


def test_the_module_compares_masks(tmp_path, capsys):
    proof, plain, other, symbol = (tmp_path / name for name in ("c.json", "plain.toml", "other.toml", "symbol.toml"))
    proof.write_text(text(ALL["chaikin"]()), encoding="utf-8")
    plain.write_text('[mask]\nstart = -1\ncoefficients = [0.25, 0.75, "3/4", "1/4"]\n', encoding="utf-8")
    other.write_text('[mask]\nstart = 0\ncoefficients = [0.25, 0.75, "3/4", "1/4"]\n', encoding="utf-8")
    symbol.write_text('[mask]\nsymbol = "(1+z)^3/4"\n', encoding="utf-8")
    assert main([str(proof), "--mask", str(plain)]) == 0
    assert capsys.readouterr().out.rstrip().endswith(f"(the mask of {plain})")
    assert main([str(proof), "--mask", str(other)]) == 1
    assert capsys.readouterr().out.startswith("NOT VERIFIED mask: ")
    assert main([str(proof), "--mask", str(symbol)]) == 2
    assert "no plain mask file" in capsys.readouterr().err
    assert main([str(proof), "--mask", str(tmp_path / "none.toml")]) == 2
    assert main([str(proof), "--mask"]) == 2


TERMS = (((-1, 0), Fraction(1, 2)), ((0, 0), Fraction(1)), ((1, -1), Fraction(-3, 4)))
HAT = PlainMask("multivariate", (((2, 0), (0, 2)), TERMS))


@pytest.mark.parametrize(
    "body",
    [
        'terms = {"1,-1" = -0.75, "0,0" = 1, "-1,0" = "1/2", "3,3" = 0}',
        'dilation = 2\nterms = {"1,-1" = "-3/4", "0,0" = 1, "-1,0" = "1/2"}',
        'dilation = [[2, 0], [0, 2]]\nstart = [-1, -1]\ncoefficients = [[0, "1/2"], [0, 1], ["-3/4", 0]]',
    ],
)
def test_masks_in_several_variables(body):
    assert plain_mask(f'kind = "multivariate"\n[mask]\n{body}\n') == HAT


def test_masks_in_three_variables_and_other_dilations():
    content = 'kind = "multivariate"\n[mask]\ndilation = 3\nstart = [0, 1, 2]\ncoefficients = [[[0, 1]], [[2, 3]]]\n'
    terms = (((0, 1, 3), Fraction(1)), ((1, 1, 2), Fraction(2)), ((1, 1, 3), Fraction(3)))
    assert plain_mask(content) == PlainMask("multivariate", (((3, 0, 0), (0, 3, 0), (0, 0, 3)), terms))
    content = 'kind = "multivariate"\n[mask]\ndilation = [[1, 1], [1, -1]]\nterms = {"0,0" = 1}\n'
    assert plain_mask(content) == PlainMask("multivariate", (((1, 1), (1, -1)), (((0, 0), Fraction(1)),)))


def test_the_mask_of_a_certificate_in_several_variables(tmp_path, capsys):
    made = ALL_MULTIVARIATE["quincunx"]()
    assert certified_mask(text(made)) == mask_of(made["mask"])
    proof, plain, other = (tmp_path / name for name in ("c.json", "plain.toml", "other.toml"))
    proof.write_text(text(made), encoding="utf-8")
    body = 'kind = "multivariate"\n[mask]\ndilation = [[1, 1], [1, %d]]\n'
    body += "start = [-1, -1]\ncoefficients = [[0, 0.25, 0], [0.25, 1, 0.25], [0, 0.25, 0]]\n"
    plain.write_text(body % -1, encoding="utf-8")
    other.write_text(body % 1, encoding="utf-8")
    assert main([str(proof), "--mask", str(plain)]) == 0
    assert capsys.readouterr().out.rstrip().endswith(f"(the mask of {plain})")
    assert main([str(proof), "--mask", str(other)]) == 1
    assert capsys.readouterr().out.startswith("NOT VERIFIED mask: ")


def test_plain_families_of_matrices():
    found = plain_mask('kind = "matrices"\nmatrices = [[[1, 0], ["2/3", "1/3"]], [["2/3", 0.25], [0, 1]]]\n')
    assert found == mask_of(
        {"kind": "matrices", "matrices": [[["1", "0"], ["2/3", "1/3"]], [["2/3", "1/4"], ["0", "1"]]]}
    )
    for other in ("[[[w]]]", '[[["w"]]]', "[[1]]", "[1]", "1", '"1"', "{}"):
        assert plain_mask(f'kind = "matrices"\nmatrices = {other}\n') is None
    assert plain_mask('kind = "matrices"\n') is None
