"""One number changed anywhere in a true certificate: rejected, or every claim still accepted is true all the same.

The truth is computed here from the mask, naively with Fractions and by numpy, or known of these few masks by hand.
"""

from __future__ import annotations

import functools
import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np
import pytest
from hand_made import ALL, naive_norm, naive_product, numbers, q, text
from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.checker import check_document, check_text


class Facts(NamedTuple):
    """What is known of a hand-made certificate's mask."""

    alpha: float
    smooth: int
    convergent: bool
    eigen: int
    """The largest ν whose eigen-condition holds."""
    stable: tuple[bool, ...]
    independent: tuple[bool, ...]
    reproduction: int
    sobolev: float = math.nan
    extra: tuple[tuple[int, ...], ...] = ()
    """Masks 1, 2, … as (start, denominator, numerators…)."""


FACTS = {
    "chaikin": Facts(2, 1, True, 2, (True,), (True,), 1, 2.5),
    "four_point": Facts(2, 1, True, 1, (True,), (True,), 3, 2.4407654450703506),
    "unstable": Facts(1, 0, True, 0, (False, True), (False, True), 0, 1.5, ((0, 2, 1, 2, 1),)),
    "cycle": Facts(0, -1, False, -1, (False, True), (False, True), 0, 0.5, ((5, 1, 1, 1),)),
    "off_circle": Facts(1, 0, True, 0, (True,), (False,), 1),
    "divergent": Facts(-9, -1, False, -1, (), (), -1),
    "overshooting": Facts(math.log2(2 / 3), -1, False, -1, (True,), (True,), 0),
    "cubic": Facts(3, 2, True, 3, (True,), (True,), 1, 3.5),
    "ternary": Facts(2, 1, True, 1, (True,), (True,), 1, 2.5),
}


VALUES = {
    "unstable": [{1: "1/2", 2: "1/2"}],
    "cubic": [{-1: "1/6", 0: "2/3", 1: "1/6"}, {-1: "1/2", 1: "-1/2"}, {-1: "1", 0: "-2", 1: "1"}],
}
"""φ, φ', φ'' at the integers."""


def divide_by_sigma(a, p):
    """The quotient, or None."""
    rest, quotient = list(a), []
    while len(rest) >= p:
        top = rest.pop()
        quotient.append(top)
        for i in range(1, p):
            rest[-i] -= top
    return None if any(rest) or not quotient else quotient[::-1]


def order_and_quotients(a, p):
    quotients = [a]
    while sum(a) == p and (quotient := divide_by_sigma(quotients[-1], p)) is not None:
        quotients.append(quotient)
    return len(quotients) - 1, quotients


def largest_eigenvalue(quotient, p, word):
    n = len(quotient) - 1
    order = max(1, math.ceil(n / (p - 1)))
    d = dict(enumerate(map(float, quotient)))
    total = np.eye(order)
    for e in word:
        section = [[d.get(e + i - p * j + (p - 1) * (order - 1), 0.0) for j in range(order)] for i in range(order)]
        total = np.array(section) @ total
    return max(abs(np.linalg.eigvals(total)))


@functools.cache
def masks_of(name):
    certificate, facts = ALL[name](), FACTS[name]
    mask = certificate["mask"]
    masks = [(mask["start"], [Fraction(c) for c in mask["coefficients"]])]
    masks += [(start, [Fraction(c, over) for c in numerators]) for start, over, *numerators in facts.extra]
    return mask["arity"], masks


def is_true(s, name):
    """Whether a statement on the masks of this hand-made certificate is true."""
    facts, (p, masks) = FACTS[name], masks_of(name)
    start, a = masks[s.get("mask", 0)]
    order, quotients = order_and_quotients(a, p)
    log = {
        key: -math.log(Fraction(s[key]), p) for key in ("norm", "radius", "bound") if key in s and Fraction(s[key]) > 0
    }

    def derived():
        z, symbol = Fraction(3, 7), s["symbol"]
        value = sum(Fraction(c) * z ** (symbol["start"] + i) for i, c in enumerate(symbol["coefficients"]))
        left = value * sum(z**i for i in range(p)) ** s["nu"]
        mask = sum(c * z ** (start + i) for i, c in enumerate(a))
        return 1 <= s["nu"] <= order and left == p ** s["nu"] * z ** ((p - 1) * s["nu"]) * mask

    def norm():
        c = [x * p ** (s["nu"] - 1) for x in quotients[s["nu"]]]
        return naive_norm(c, p, s["level"]) == Fraction(s["norm"])

    def sums():
        return [q(sum(c for i, c in enumerate(a, start) if i % p == r)) for r in range(p)]

    def sobolev():
        """Exactly one zero in the interval, and the exponent is that of it."""
        f, (low, high) = s["polynomial"], (float(Fraction(s[key])) for key in ("low", "high"))
        zeros = np.roots([float(Fraction(c)) for c in f["coefficients"][::-1]])
        real = [z.real for z in zeros if abs(z.imag) < 1e-12 and low - 1e-12 <= z.real <= high + 1e-12]
        return len(real) == 1 and abs(-math.log(real[0], p) / 2 - facts.sobolev) < 1e-9

    def terms(polynomial):
        pairs = ((i, Fraction(c)) for i, c in enumerate(polynomial["coefficients"], polynomial["start"]))
        return {i: c for i, c in pairs if c}

    def values():
        known = VALUES[name]
        asked = {i: Fraction(c) for i, c in known[s["order"]].items()} if s["order"] < len(known) else None
        return terms(s["values"]) == asked

    def quasi_interpolation():
        operator = list(map(Fraction, s["operator"]))
        if operator != [1, 0, Fraction(-1, 6), 0][: s["degree"] + 1]:
            return False
        moments = [sum(c * i**power for i, c in terms(s["stencil"]).items()) for power in range(len(operator))]
        return moments == [math.factorial(power) * x for power, x in enumerate(operator)]

    def error_bound():
        """At least what the terms of the cubic B-spline's S and S_2 are seen to be, E = 1/4 and 1/2, norms 2^-i."""
        e, mu, level = {0: Fraction(1, 4), 2: Fraction(1, 2)}.get(s["nu"], 99), Fraction(s["norm"]), s["level"]
        sums = [sum(e / 2**i for i in range(k, 60)) for k in range(9)]
        return all(Fraction(s["constant"]) * mu ** (k // level) >= sums[k] - Fraction(1, 10**9) for k in range(9))

    return {
        "values": values,
        "quasi-interpolation": quasi_interpolation,
        "error-bound": error_bound,
        "levels": lambda: Fraction(s["tolerance"]) >= Fraction(1, 2 ** (s["levels"] + 1)),
        "hermite-bound": lambda: s["order"] == 2 and Fraction(s["constant"]) >= Fraction(1, 8),
        "sobolev": sobolev,
        "sobolev-at-least": lambda: log["bound"] / s["length"] <= facts.sobolev + 1e-9,
        "sobolev-at-most": lambda: log["bound"] / s["length"] >= facts.sobolev - 1e-9,
        "residue-sums": lambda: s["sums"] == sums(),
        "sum-rules": lambda: s["order"] == order,
        "derived": derived,
        "generation": lambda: s["degree"] == order - 1,
        "reproduction": lambda: s["degree"] == facts.reproduction,
        "norm": norm,
        "product": lambda: largest_eigenvalue(quotients[-1], p, s["word"]) >= float(Fraction(s["radius"])) - 1e-9,
        "eigen-condition": lambda: s["holds"] == (s["nu"] <= facts.eigen),
        "independent": lambda: s["holds"] == facts.independent[s["mask"]],
        "stable": lambda: s["holds"] == facts.stable[s["mask"]],
        "reduction": lambda: (s["from"], s["to"]) == (0, 1) and len(masks) == 2,
        "convergent": lambda: s["holds"] == facts.convergent,
        "smooth": lambda: s["order"] <= facts.smooth,
        "not-smooth": lambda: s["order"] > facts.smooth,
        "holder-lower": lambda: log["norm"] / s["level"] <= facts.alpha + 1e-9,
        "holder-upper": lambda: log["radius"] / s["length"] >= facts.alpha - 1e-9,
        "holder": lambda: abs(log["norm"] / s["level"] - facts.alpha) < 1e-9,
    }[s["property"]]()


def with_small_goal(name):
    """Only one statement in the goal, so that the goal does not save the checker's other rules."""
    certificate = ALL[name]()
    del certificate["goal"][1:]
    return certificate


HARMLESS = {
    "unstable": {
        ("claims", 1, "witness", "factor", "start"),  # what divides a polynomial divides its shifts
        ("claims", 2, "witness", "factor", "start"),
        ("claims", 11, "witness", "cofactors", 0, "start"),  # zero has no start
    },
    "four_point": {("claims", 1, "witness", "cofactors", 1, "start")},
    "cycle": {("claims", 3, "witness", "cofactors", 0, "start")},
    "off_circle": {
        ("claims", 0, "witness", "factor", "start"),
        ("claims", 1, "witness", "cofactors", 0, "start"),
    },
    "ternary": {("claims", 4, "witness", "cofactors", 0, "start")},
}
"""Numbers of a witness that may be others."""
PATHS = {name: list(numbers(with_small_goal(name))) for name in ALL}


def change(name, path, new):
    certificate = with_small_goal(name)
    place = certificate
    for key in path[:-1]:
        place = place[key]
    old = place[path[-1]]
    place[path[-1]] = new if isinstance(old, int) else q(new)
    return certificate, old != place[path[-1]]


def true_or_rejected(name, path, new):
    """Whether the changed certificate is verified; then all it says must be true."""
    certificate, changed = change(name, path, new)
    outcome = check_document(certificate)
    assert "fails on it" not in outcome.line
    if outcome.verified:
        assert path[0] == "claims" or not changed
        for c in certificate["claims"]:
            assert is_true(c["statement"], name), c["statement"]
    return outcome.verified and changed


@pytest.mark.parametrize("name", ALL)
def test_the_truth_says_that_the_true_certificates_are_true(name):
    certificate = with_small_goal(name)
    assert check_text(text(certificate)).verified
    assert all(is_true(c["statement"], name) for c in certificate["claims"])


@pytest.mark.parametrize("name", ALL)
def test_every_number_changed_a_little(name):
    accepted = []
    for path in PATHS[name]:
        place = with_small_goal(name)
        for key in path:
            place = place[key]
        old = Fraction(place)
        small = range(20) if "uses" in path else range(-1, 6)
        news = {old + 1, old - 1, -old, 2 * old, old / 2, old + Fraction(1, 10**6), old - Fraction(1, 10**6), *small}
        for new in news:
            if isinstance(place, str) or (new.denominator == 1):
                exact = Fraction(new) if isinstance(place, str) else int(new)
                if true_or_rejected(name, path, exact):
                    accepted.append(path)
    allowed = {
        "work",
        "uses",
        "radius",
        "order",
        "nu",
        "word",
        "level",
        "low",
        "high",
        "cofactor",
        "tolerance",
        "levels",
    }
    others = {path for path in accepted if not allowed & set(path)}
    assert others == HARMLESS.get(name, set())


@settings(max_examples=400, deadline=None)
@given(st.data())
def test_any_number_changed_to_anything(data):
    name = data.draw(st.sampled_from(sorted(ALL)))
    path = data.draw(st.sampled_from(PATHS[name]))
    place = with_small_goal(name)
    for key in path:
        place = place[key]
    if isinstance(place, int):
        new = data.draw(st.integers(-5, 40) | st.integers(-(10**12), 10**12))
    else:
        new = data.draw(st.fractions(max_denominator=1000) | st.fractions())
    true_or_rejected(name, path, new)


def test_the_oracle_knows_falsehood():
    assert not is_true({"property": "smooth", "order": 2}, "chaikin")
    assert not is_true({"property": "norm", "mask": 0, "nu": 2, "level": 2, "norm": "1/2"}, "chaikin")
    assert not is_true({"property": "product", "mask": 0, "word": [0, 1], "radius": "1/63"}, "four_point")
    assert not is_true({"property": "holder-upper", "length": 1, "radius": "1/3"}, "chaikin")
    assert naive_product([1, 1], [1, -1]) == [1, 0, -1]
