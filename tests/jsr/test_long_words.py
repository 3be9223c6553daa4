"""Maximizing products of many letters, and families from the literature, with the values published for them."""

from __future__ import annotations

import tomllib
from fractions import Fraction
from pathlib import Path

import pytest
from proved import proved

FAMILIES = Path(__file__).parents[1] / "data" / "jsr"
WORD_OF_119 = (
    "010110101101011011010110101101101011010110101101101011010110"
    "11010110101101101011010110101101101011010110110101101011011"
)


def family(name):
    with (FAMILIES / f"{name}.toml").open("rb") as file:
        return tomllib.load(file, parse_float=Fraction)["matrices"]


def test_a_word_of_119_letters():
    """Mejstrik 2020, the pair with the longest product in the gallery of the ttoolboxes."""
    found = proved(family("mejstrik_119"))
    assert found.root is not None
    assert found.root[0] == 119
    assert found.lower == pytest.approx(1.011793560033504, rel=1e-14)
    (word,) = found.words
    assert "".join(map(str, word)) in 2 * WORD_OF_119 or "".join(map(str, word[::-1])) in 2 * WORD_OF_119


@pytest.mark.parametrize("size", [2, 5, 15, 25, 40])
def test_a_shear_and_a_matrix_of_rank_one(size):
    """((1, 1), (0, 1)) and ((0, 0), (1/n, 0)): a product has the radius Π k_i/n, k_i the lengths of runs of shears."""
    best = max(range(1, 40 * size), key=lambda k: (k / size) ** (1 / (k + 1)))
    found = proved([[[1, 1], [0, 1]], [[0, 0], [Fraction(1, size), 0]]])
    value = Fraction(best, size)
    assert found.lower == pytest.approx(max(1.0, float(value) ** (1 / (best + 1))), rel=1e-13)
    assert found.root == (best + 1, (-value.numerator, value.denominator))


def test_overlap_free_words():
    """Jungers, Protasov & Blondel 2009: 2.5179340409; the product M_1 M_0."""
    found = proved(family("overlap20"))
    polynomial = (-32, 102, -153, 4, 173, -139, 23, 73, -72, 15, 16, -9, 1)
    assert found.root == (2, polynomial)
    assert found.lower == pytest.approx(2.517934040867249, rel=1e-14)
    assert len(found.words[0]) == 2


def test_consensus_is_exactly_one():
    assert proved(family("consensus")).root == (1, (-1, 1))


def test_a_common_ellipse():
    assert proved(family("sel1")).root == (2, (-4, 1))
