"""Plain mask files: what the checker reads itself is what subdiv reads, and it leaves alone what is not plain."""

from fractions import Fraction
from pathlib import Path

import pytest
from hand_made import ALL, text
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.checker.__main__ import main
from subdiv_cli.checker.plain import mask, plain_mask
from subdiv_cli.maskfile.reader import read_text

MASKS = sorted((Path(__file__).parents[2] / "masks").rglob("*.toml"))


def test_of_every_shipped_plain_file_it_reads_the_same():
    plain = 0
    for file in MASKS:
        content = file.read_text(encoding="utf-8")
        if (found := plain_mask(content)) is not None:
            plain += 1
            scheme = read_text(content, file=str(file)).scheme()
            assert found == (scheme.arity, scheme.start, scheme.coefficients)
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
    assert plain_mask(content) == mask(arity, start, [x for _, x in entries])


@pytest.mark.parametrize(
    "content",
    [
        "",
        "[mask",
        'kind = "vector"\n[mask]\nstart = 0\ncoefficients = [1]\n',
        "[mask]\ncoefficients = [1, 1]\n",
        '[mask]\nsymbol = "1+z"\n',
        '[parameters]\nw = 1\n[mask]\nstart = 0\ncoefficients = [1, "w"]\n',
        '[mask]\nstart = 0\ncoefficients = [1, "1/0"]\n',
        "[mask]\nstart = 0\ncoefficients = [true, 1]\n",
        "[mask]\nstart = 0\ncoefficients = [nan, 1]\n",
        "[mask]\nstart = 0\ncoefficients = []\n",
        "[mask]\nstart = 0.5\ncoefficients = [1, 1]\n",
        '[mask]\nstart = 0\ncoefficients = [1, "1 + 1"]\n',
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
