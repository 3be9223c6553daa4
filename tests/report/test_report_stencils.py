"""Stencils as text: what they compute is the scheme, and nothing is lost on a narrow page."""

import re
from fractions import Fraction
from itertools import product
from math import lcm
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.kinds.multivariate.portrait.stencils import stencil_blocks, stencils
from subdiv_cli.kinds.reading import read_path
from subdiv_cli.model import Result
from subdiv_cli.report.blocks import put
from subdiv_cli.report.letters import width
from subdiv_cli.report.look import Look
from subdiv_cli.report.page import Page, paint
from subdiv_cli.spaces.lattice import Lattice

GOLDEN = Path(__file__).with_name("golden") / "stencils"
MASKS = Path(__file__).parents[2] / "masks" / "multivariate"
DILATIONS = [
    ((2, 0), (0, 2)),
    ((1, 1), (1, -1)),
    ((2, -1), (1, -2)),
    ((1, -2), (1, 0)),
    ((0, 3), (2, 1)),
    ((2, 0, 0), (0, 2, 0), (0, 0, 2)),
    ((0, 0, 2), (1, 0, 0), (0, 1, 0)),
    ((2, 1, 0, 0), (0, 2, 0, 0), (0, 0, 1, 1), (0, 0, 1, -1)),
]


def times(matrix, vector):
    return tuple(sum(x * k for x, k in zip(row, vector, strict=True)) for row in matrix)


def draw(terms, dilation, columns, unicode):
    page = Page(Look(width=columns, unicode=unicode))
    put(page, stencil_blocks(terms, Lattice(dilation)), Result(file="", status="undecided"))
    return paint(page.lines)


@st.composite
def masks(draw):
    dilation = draw(st.sampled_from(DILATIONS))
    indices = st.tuples(*[st.integers(-5, 5)] * len(dilation))
    values = st.fractions(max_denominator=10**8).filter(bool) | st.sampled_from([Fraction(1, 16), Fraction(-3, 8)])
    return draw(st.dictionaries(indices, values, min_size=1, max_size=12)), dilation


@settings(deadline=None)
@given(masks())
def test_the_stencils_are_the_scheme(mask):
    """Each term is in one stencil: a_α = weights[δ] of the coset γ with α = γ - Mδ."""
    terms, dilation = mask
    found = {}
    cosets = []
    for stencil in stencils(terms, Lattice(dilation)):
        cosets.append(stencil.coset)
        assert times(dilation, stencil.at) == stencil.coset
        for delta, weight in stencil.weights.items():
            index = tuple(g - x for g, x in zip(stencil.coset, times(dilation, delta), strict=True))
            assert index not in found
            found[index] = weight
    assert found == terms
    assert cosets[0] == (0,) * len(dilation)


@pytest.mark.parametrize("dilation", DILATIONS)
def test_the_cosets_are_all_of_them(dilation):
    """Every index near the origin is in one coset, whichever mask: a mask of one term says in which."""
    size = len(dilation)
    residues = [stencil.coset for stencil in stencils({(0,) * size: Fraction(1)}, Lattice(dilation))]
    for index in product(range(-2, 3) if size == 2 else range(2), repeat=size):
        holding = [s.coset for s in stencils({index: Fraction(1)}, Lattice(dilation)) if s.weights]
        assert len(holding) == 1
        assert holding[0] in residues


@settings(deadline=None)
@given(masks(), st.sampled_from([40, 80]), st.booleans())
def test_every_weight_is_shown_and_lines_fit(mask, columns, unicode):
    terms, dilation = mask
    text = draw(terms, dilation, columns, unicode)
    assert all(width(line) <= columns for line in text.splitlines())
    assert unicode or text.isascii()
    flat = re.sub(r"\s", "", text)
    for stencil in list(stencils(terms, Lattice(dilation)))[:16]:
        common = lcm(*(weight.denominator for weight in stencil.weights.values()))
        scale = common if common <= 10**6 else 1
        for weight in stencil.weights.values():
            assert str(weight * scale) in flat


def test_many_cosets_are_counted():
    text = draw({(0, 0): Fraction(1)}, ((9, 0), (0, 9)), 80, True)
    assert text.endswith("and 65 more cosets\n")


def test_long_numbers_are_listed():
    terms = {(0, 0): Fraction(10**80 + 1, 3), (2, 0): Fraction(1, 10**6)}
    text = draw(terms, ((2, 0), (0, 2)), 40, False)
    assert re.sub(r"\s", "", text).startswith(f"coset(0,0)attheoldpoints:(-1,0):1/1000000,(0,0):{10**80 + 1}/3")


def test_far_places_are_listed():
    text = draw({(0, 0): Fraction(1, 4), (2000, 2000): Fraction(3, 4)}, ((2, 0), (0, 2)), 80, True)
    assert text.splitlines()[0] == "    coset (0, 0) at the old points, in 1/4: (-1000, -1000): 3, (0, 0): 1"


@pytest.mark.parametrize(
    ("mask", "columns", "unicode"),
    [
        ("butterfly", 80, True),
        ("butterfly", 40, False),
        ("kobbelt_sqrt3", 80, True),
        ("tensor_six_point", 40, False),
        ("box_bcc_linear", 80, True),
    ],
)
def test_golden(mask, columns, unicode):
    scheme = read_path(MASKS / f"{mask}.toml").scheme()
    name = f"{mask}-{columns}{'' if unicode else '-ascii'}.txt"
    assert draw(scheme.terms, scheme.dilation, columns, unicode) == (GOLDEN / name).read_text(encoding="utf-8")
