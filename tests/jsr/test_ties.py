"""Images on the boundary of a polytope whose leading eigenvalue is irrational: decided in its number field."""

from __future__ import annotations

import copy
import json
from fractions import Fraction as Q
from pathlib import Path

import jsonschema
import pytest
from flint import arb, fmpq_poly
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from subdiv_cli.checker import check_document
from subdiv_cli.exact.algebraic import roots
from subdiv_cli.exact.field import root_in_field, solve
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import joint_spectral_radius

SCHEMA = Path(__file__).parents[2] / "subdiv_cli" / "certificate" / "schema.json"
PAIR = [[[1, 1], [0, 1]], [["4/5", 0], ["4/5", "4/5"]]]
"""σ = (5 + √5)/5 is in Q(λ), λ = σ²; M_1 M_0² v is on the segment of two vertices, at an irrational place."""
SIGNED = [[[1, -1], [0, 1]], [["4/5", 0], ["-4/5", "4/5"]]]


def document(matrices):
    family = [[[Q(x) for x in row] for row in m] for m in matrices]
    return json.loads(json.dumps(joint_spectral_radius(family, Effort()).document))


@pytest.mark.parametrize(("matrices", "rule"), [(PAIR, "monotone-closing"), (SIGNED, "closing")])
def test_weights_may_be_irrational(matrices, rule):
    made = document(matrices)
    (closing,) = [c for c in made["claims"] if c["rule"] == rule]
    assert closing["statement"]["polynomial"] == ["16", "-60", "25"]
    assert closing["witness"]["sigma"] == ["2/5", "1/2"]
    assert any(isinstance(share["weight"], list) for tie in closing["witness"]["ties"] for share in tie["weights"])
    assert check_document(made).verified
    jsonschema.validate(made, json.loads(SCHEMA.read_text(encoding="utf-8")))


@pytest.mark.parametrize("factor", ["1/2", "3/5", "2/3", "7/10", "3/4", "7/9", "5/6", "9/10", "19/20"])
def test_the_whole_family_of_that_pair_closes(factor):
    family = [[[1, 1], [0, 1]], [[factor, 0], [factor, factor]]]
    radius = joint_spectral_radius([[[Q(x) for x in row] for row in m] for m in family], Effort(4000)).radius
    assert radius.exact is not None


def first_share(c):
    return next(tie["weights"] for tie in c["witness"]["ties"] if len(tie["weights"]) == 2)


FORGED = [
    lambda c: c["witness"].pop("sigma"),
    lambda c: c["witness"].update(sigma=["-2/5", "-1/2"]),
    lambda c: c["witness"].update(sigma=["2/5", "1/3"]),
    lambda c: c["witness"].update(sigma=["2/5", "1/2", "0"]),
    lambda c: c["witness"].update(sigma=[]),
    lambda c: first_share(c)[0].update(weight=["-7", "15/4", "1/1000"]),
    lambda c: first_share(c)[0].update(weight="1/2"),
    lambda c: first_share(c)[0].update(weight=[]),
    lambda c: first_share(c)[0].update(weight=[str(-Q(x)) for x in first_share(c)[0]["weight"]]),
    lambda c: first_share(c).pop(),
    lambda c: first_share(c)[0].update(vertex=first_share(c)[1]["vertex"]),
]


@pytest.mark.parametrize("matrices", [PAIR, SIGNED])
@pytest.mark.parametrize("number", range(len(FORGED)))
def test_a_forged_tie_is_rejected(matrices, number):
    made = copy.deepcopy(document(matrices))
    for c in made["claims"]:
        if c["rule"].endswith("closing"):
            FORGED[number](c)
    assert not check_document(made).verified


g = fmpq_poly([-1, -1, 0, 1])
elements = st.lists(st.integers(-4, 4), min_size=3, max_size=3).map(fmpq_poly)


@settings(max_examples=100, deadline=None)
@given(st.lists(st.lists(elements, min_size=3, max_size=3), min_size=1, max_size=3), st.data())
def test_equations_over_a_field(columns, data):
    x = [data.draw(elements) for _ in columns]
    target = [sum((a * c[i] for a, c in zip(x, columns, strict=True)), fmpq_poly()) % g for i in range(3)]
    found = solve(columns, target, g)
    assert found is None or found == x
    other = [*target[:2], target[2] + 1]
    if (wrong := solve(columns, other, g)) is not None:
        for i in range(3):
            image = sum((a * c[i] for a, c in zip(wrong, columns, strict=True)), fmpq_poly()) % g
            assert image == other[i] % g


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(-5, 5), min_size=2, max_size=4), st.integers(1, 3))
def test_roots_in_the_field(f, n):
    """Of Λ = x^n for a root x > 0 of f there is one; what is found is one."""
    assume(f[-1] != 0)
    positive = [x for x, _ in roots(fmpq_poly(f)) if x.is_real and x.region.real > 0]
    assume(positive)
    for number in positive:
        if (s := root_in_field(number, n)) is not None:
            value = number.enclosure().real
            total = sum((arb(s[k]) * value**k for k in range(len(list(s)))), arb(0))
            assert (total**n).overlaps(value)
            assert total > 0


def test_some_roots_are_in_the_field():
    """φ² = φ + 1 is a square in Q(√5), and 2 + √2 is none in Q(√2)."""
    largest = roots(fmpq_poly([1, -3, 1]))[0][0]
    assert root_in_field(largest, 2) == fmpq_poly([-1, 1])
    assert root_in_field(roots(fmpq_poly([2, -4, 1]))[0][0], 2) is None
