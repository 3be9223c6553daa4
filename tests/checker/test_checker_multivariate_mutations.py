"""One number changed anywhere in a true certificate of a mask on Z^s: rejected, or all that is accepted is true.

The truth is known of these masks by hand, or computed here naively.
"""

from __future__ import annotations

import copy
import math
from fractions import Fraction
from itertools import product
from typing import NamedTuple

import numpy as np
import pytest
from hand_made import numbers, q
from hand_made_multivariate import ALL_MULTIVARIATE, MASKS, norm, pair_norm, pair_quotient, quotient
from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.checker import check_document
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS


class Facts(NamedTuple):
    """What is known of a mask."""

    order: int
    """Of the sum rules."""
    convergent: bool | None
    alpha: float
    smooth: int
    stable: bool
    s: float
    """The Sobolev exponent."""
    reproduction: int
    directions: list[list[int]] | None = None


RADIUS_RULES = RADIUS.rules
GOLDEN = (1 + math.sqrt(5)) / 2
FACTS = {
    "bilinear": Facts(2, True, 1, 0, True, 1.5, 1, [[0, 1], [0, 1], [1, 0], [1, 0]]),
    "courant": Facts(2, True, 1, 0, True, 1.5, 1, [[0, 1], [1, 0], [1, 1]]),
    "zwart_powell": Facts(2, True, 2, 1, False, 2.5, 1, [[0, 1], [1, -1], [1, 0], [1, 1]]),
    "quincunx": Facts(2, True, 2 - 2 * math.log2(GOLDEN), 0, True, 1.5776445337925926, 1),
    "four_eight": Facts(
        4, True, 5, 4, False, 5.5, 1, [[0, 1], [0, 1], [1, -1], [1, -1], [1, 0], [1, 0], [1, 1], [1, 1]]
    ),
    "butterfly": Facts(4, True, 2, 1, True, 2.4407654450703506, 3),
    "chaikin_hat": Facts(2, True, 1, 0, True, 1.5, 1),
    "loop": Facts(4, True, 3, 2, True, 3.5, 1),
    "haar": Facts(1, False, 0, -1, True, 0.5, 0, [[0, 1], [1, 0]]),
    "apart": Facts(2, False, 1, 0, False, 1.5, 1),
    "flat": Facts(0, False, math.nan, -1, False, math.nan, -1),
    "trilinear": Facts(
        2, True, 1, 0, True, 1.5, 1, [[0, 0, 1], [0, 0, 1], [0, 1, 0], [0, 1, 0], [1, 0, 0], [1, 0, 0]]
    ),
    "trapezoids": Facts(1, True, 1, 0, False, 1.5, 0),
}  # fmt: skip
MADE = {name: make() for name, make in ALL_MULTIVARIATE.items()}


def is_true(s, name):
    facts, (matrix, _) = FACTS[name], MASKS[name]
    scale = round(abs(np.linalg.det(matrix))) ** (1 / len(matrix))

    def exponent():
        return -math.log(Fraction(s["bound"]), scale) / s["length"]

    def root():
        zeros = np.roots([int(c) for c in s["polynomial"][::-1]])
        low, high = float(Fraction(s["low"])), float(Fraction(s["high"]))
        (zero,) = (z.real for z in zeros if abs(z.imag) < 1e-12 and low - 1e-12 <= z.real <= high + 1e-12)
        return abs(-math.log(zero, scale) / s["length"] - facts.alpha) < 1e-9

    def sobolev():
        zeros = np.roots([float(Fraction(c)) for c in s["polynomial"]["coefficients"][::-1]])
        low, high = float(Fraction(s["low"])), float(Fraction(s["high"]))
        (zero,) = (z.real for z in zeros if abs(z.imag) < 1e-12 and low - 1e-12 <= z.real <= high + 1e-12)
        return -math.log(zero, scale) / 2

    def of_factor():
        said = s["statement"]
        if said["property"] == "sobolev":
            return (
                s["variables"] == [1]
                and abs(-math.log2(-Fraction(said["polynomial"]["coefficients"][0])) / 2 - facts.s) < 1e-9
            )
        return s["variables"] == [1] and -math.log2(Fraction(said["norm"])) / said["level"] == facts.alpha

    def directional():
        return norm(quotient(name, *s["direction"]), 2, s["level"]) == Fraction(s["norm"])

    def pair():
        return pair_norm(pair_quotient(name, *map(tuple, s["directions"])), s["level"]) == Fraction(s["norm"])

    def decay():
        """ρ_k = λ^-α for α < k, and larger for smaller orders only by powers of 1/λ."""
        return scale ** (-min(facts.alpha, s["order"]) * s["level"]) <= Fraction(s["norm"]) + Fraction(1, 10**9)

    return {
        "coset-sums": lambda: s["holds"] == (facts.order > 0),
        "total-sum-rules": lambda: s["order"] == facts.order,
        "generation": lambda: s["degree"] == facts.order - 1,
        "family": lambda: (s["family"], s["order"]) == (0, facts.order),
        "limit-stencil": lambda: facts.convergent and s["coset"] == [0] * len(matrix),
        "stencil-family": lambda: (s["family"], s["order"]) == (0, math.floor(facts.alpha) + 1),
        "convergent": lambda: s["holds"] == facts.convergent,
        "smooth": lambda: s["order"] <= facts.smooth,
        "not-smooth": lambda: s["order"] > facts.smooth,
        "holder-lower": lambda: exponent() <= facts.alpha + 1e-9,
        "holder-upper": lambda: exponent() >= facts.alpha - 1e-9,
        "holder-root": root,
        "holder-value": lambda: s["value"] == facts.alpha,
        "sobolev": lambda: abs(sobolev() - facts.s) < 1e-9,
        "sobolev-lower": lambda: sobolev() <= facts.s + 1e-9,
        "sobolev-value": lambda: Fraction(s["value"]) == facts.s,
        "reproduction": lambda: s["degree"] == facts.reproduction,
        "quasi-interpolation": lambda: inverts(s, name) and s["degree"] < facts.order,
        "stable": lambda: s["holds"] == facts.stable,
        "tensor-product": lambda: s["parts"] == [[0], [1]],
        "of-factor": of_factor,
        "at-most-factor": of_factor,
        "box-spline": lambda: (s["directions"], s["scale"]) == (facts.directions, 2),
        "directional-norm": directional,
        "pair-norm": pair,
        "matrix-norm": decay,
        "directional-decay": decay,
        "sobolev-at-least": lambda: exponent() <= facts.s + 1e-9,
        "sobolev-at-most": lambda: exponent() >= facts.s - 1e-9,
    }[s["property"]]()


def inverts(s, name):
    """Whether S maps the samples that the stencil takes of f to those of f(M^-1 ·), and is Q: by monomials."""
    matrix, mask = MASKS[name]
    operator, stencil = ({tuple(index): Fraction(x) for index, x in s[key]} for key in ("operator", "stencil"))
    inverse = [[Fraction(round(x * 2**8), 2**8) for x in row] for row in np.linalg.inv(matrix)]
    dimension = len(matrix)
    grid = list(product(range(s["degree"] + 2), repeat=dimension))

    def data(f, alpha):
        return sum(x * f([i + j for i, j in zip(alpha, index, strict=True)]) for index, x in stencil.items())

    def apart(x):
        return [sum(a * b for a, b in zip(row, x, strict=True)) for row in inverse]

    for mu in product(range(s["degree"] + 1), repeat=dimension):
        if sum(mu) > s["degree"]:
            continue

        def f(x, mu=mu):
            return math.prod(a**n for a, n in zip(x, mu, strict=True))

        if data(f, (0,) * dimension) != operator.get(mu, 0) * math.prod(map(math.factorial, mu)):
            return False
        for alpha in grid:
            olds = ((apart([i - j for i, j in zip(alpha, delta, strict=True)]), x) for delta, x in mask.items())
            refined = sum(x * data(f, beta) for beta, x in olds if all(i.denominator == 1 for i in beta))
            if refined != data(lambda x, f=f: f(apart(x)), alpha):
                return False
    return operator.get((0,) * dimension) == 1 and all(sum(mu) <= s["degree"] for mu in operator)


def own(made):
    """The claims that are not of the rules on radii."""
    return [c for c in made["claims"] if c["rule"] not in RADIUS_RULES]


def paths(name):
    """Of all numbers but those of claims on radii, which have their own tests, and of a mask that little is said of."""
    made = MADE[name]
    found = numbers({**made, "goal": made["goal"][:1], "mask": [] if name == "flat" else made["mask"]})
    return [path for path in found if path[0] != "claims" or made["claims"][path[1]]["rule"] not in RADIUS_RULES]


PATHS = {name: paths(name) for name in ALL_MULTIVARIATE}


def true_or_rejected(name, path, change):
    """Whether the certificate with another number there is verified; then all it says must be true."""
    made = copy.deepcopy(MADE[name])
    del made["goal"][1:]
    place = made
    for key in path[:-1]:
        place = place[key]
    old = place[path[-1]]
    new = change(Fraction(old))
    place[path[-1]] = int(new) if isinstance(old, int) else q(new)
    outcome = check_document(made)
    assert "fails on it" not in outcome.line
    if place[path[-1]] == old:
        return False
    if outcome.verified:
        assert path[0] == "claims", path
        for c in own(made):
            assert is_true(c["statement"], name), c["statement"]
    return outcome.verified


@pytest.mark.parametrize("name", ALL_MULTIVARIATE)
def test_the_truth_says_that_the_true_certificates_are_true(name):
    assert all(is_true(c["statement"], name) for c in own(MADE[name]))


CHANGES = {
    "one more": lambda x: x + 1,
    "one less": lambda x: x - 1,
    "the opposite": lambda x: -x,
    "half": lambda x: x / 2,
    "a little more": lambda x: x + Fraction(1, 10**6),
    "a little less": lambda x: x - Fraction(1, 10**6),
}
FREE = {
    "work", "uses", "order", "degree", "low", "high", "bound", "cosets", "polynomial", "cofactor", "point", "words",
    "breadth",
}  # fmt: skip
"""What may be another in some claim: more work, another claim of the same statement, a weaker statement, another
representative of a coset whose operator is zero, a multiple of a polynomial, a point of the torus by other angles,
other words that span, more breadth.
"""


@pytest.mark.parametrize("name", ["haar", "flat", "zwart_powell"])
def test_every_number_changed_a_little(name):
    for path in PATHS[name]:
        for change in CHANGES.values():
            if true_or_rejected(name, path, change):
                assert FREE & set(path), path


@settings(max_examples=150)
@given(st.data())
def test_any_number_changed(data):
    name = data.draw(
        st.sampled_from(
            ["bilinear", "courant", "quincunx", "four_eight", "butterfly", "loop", "trilinear", "trapezoids"]
        )
    )
    path = data.draw(st.sampled_from(PATHS[name]))
    change = data.draw(st.one_of(st.sampled_from(list(CHANGES.values())), st.fractions().map(lambda x: lambda _: x)))
    if true_or_rejected(name, path, change):
        assert FREE & set(path), path


def places(value, path=()):
    """The paths of everything in a document."""
    yield path
    members = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, member in members:
        yield from places(member, (*path, key))


PLACES = {name: [path for path in places(MADE[name]) if path] for name in ("bilinear", "zwart_powell", "haar")}
JUNK = [None, [], {}, "", 0, -1, 1, 10**11, True, [[]], [[0, 0]], [0, 0], "x", "1/3", {"start": 0}, [[["1"]]], 0.5]


@settings(max_examples=200)
@given(st.sampled_from(sorted(PLACES)), st.data(), st.sampled_from(JUNK))
def test_anything_anywhere_is_answered(name, data, junk):
    path = data.draw(st.sampled_from(PLACES[name]))
    made = copy.deepcopy(MADE[name])
    place = made
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = junk
    assert "fails on it" not in check_document(made).line
