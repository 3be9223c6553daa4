"""One number changed anywhere in a true certificate of radii: rejected, or all that it still says is true.

The truth is decided here: the radii of these families are known, those of blocks are computed from the witness, and
statements on masks are compared with the exponents that the masks are known to have.
"""

from __future__ import annotations

import copy
import functools
import itertools
import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np
import pytest
from closings import closing, polytope
from hand_made import claim, q
from hand_made_radius import ALL_RADIUS, matrices_document, of_family
from hypothesis import given, settings
from hypothesis import strategies as st
from test_checker_mutations import largest_eigenvalue, naive_product, numbers

from subdiv_cli.checker import check_document

PHI = (1 + 5**0.5) / 2


class Family(NamedTuple):
    """What is known of family 0 of a document."""

    radius: float
    bounded: bool
    defective: bool = False
    """At its radius."""


class Scheme(NamedTuple):
    """What is known of a mask: α, whether it is attained, the order of its sum rules; its α-th differences."""

    alpha: float
    attained: bool
    order: int


FAMILIES = {
    "golden": Family(PHI, True),
    "monotone": Family(PHI, True),
    "monotone_enclosed": Family(1.40924722212, True),
    "one_vertex": Family(PHI, True),
    "signed": Family(PHI, True),
    "rotation": Family(1.0, True),
    "triangular": Family(3.0, False),
    "nilpotent": Family(0.0, False),
    "enclosed": Family(1.40924722212, True),
    "lower_of_blocks": Family(2.0, True),
    "swap": Family(1.0, True),
    "weighted": Family(1.0, True),
    "column_sums": Family(1.0, True),
    "ellipse": Family(2.0, True),
    "tree_of_words": Family(1.0, True),
    "swap_and_halve": Family(1.0, True),
    "golden_in_two_letters": Family(PHI, True),
    "two_leaders": Family(2.0, True),
    "golden_from_above": Family(PHI, True),
    "jordan": Family(1.0, False, True),
    "irrational_weights": Family(1 + 5**-0.5, True),
    "plane": Family(1.0, True),
}
TENTH = [Fraction(c) for c in ("-1/10", "1/5", "3/10", "1/5", "-1/10")]
"""a/(1+z)² of the four-point scheme with w = 1/10."""


def radius_of_words(quotient, longest=6):
    """The largest ρ(Π)^(1/ℓ) over words of two letters."""
    words = (word for n in range(1, longest + 1) for word in itertools.product(range(2), repeat=n))
    return max(largest_eigenvalue(quotient, 2, word) ** (1 / len(word)) for word in words)


SCHEMES = {
    "four_point_attained": Scheme(2.0, False, 4),
    "four_point_polytope": Scheme(-math.log2(radius_of_words(TENTH)), True, 2),
    "quadratic": Scheme(2.0, True, 3),
}


def leader(word, annihilator, column=0, reflected=False, sign=1):
    said = {"word": word, "reflected": reflected, "column": column, "scale": "1"}
    return {**said, "annihilator": [q(c) for c in annihilator], "sign": sign}


def closed(matrices, length, polynomial, low, high, leaders, **options):
    """A document with one claim, its witness found by the tests' own search."""
    matrices = [[[Fraction(x) for x in row] for row in m] for m in matrices]
    root = {"length": length, "polynomial": [q(c) for c in polynomial], "low": q(low), "high": q(high)}
    witness = closing(matrices, root, leaders, **options)
    made = claim("closing", property="bounded", family=0, witness=witness, **root)
    return matrices_document([[[q(x) for x in row] for row in m] for m in matrices], [made])


def swap_and_halve():
    """A swap and diag(1, 1/2): ties at a rational Λ."""
    return closed([[[0, 1], [1, 0]], [[1, 0], [0, "1/2"]]], 1, [-1, 1], 1, 1, [leader([1], ["1/2", "-3/2", 1])])


def golden_in_two_letters():
    return closed(
        [[[1, 1], [0, 1]], [[1, 0], [1, 1]]], 2, [1, -3, 1], 2, 3, [leader([0, 1], [1, -3, 1], 1)], extras=[(2**29, 0)]
    )


def two_leaders():
    """diag(2, 1) and diag(1, -2): eigenvectors e_0 of 2 and e_1 of -2."""
    leaders = [leader([0], [2, -3, 1]), leader([1], [-2, 1, 1], 1, sign=-1)]
    return closed([[[2, 0], [0, 1]], [[1, 0], [0, -2]]], 1, [-2, 1], 2, 2, leaders)


def golden_from_above():
    matrices = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]
    witness = polytope(matrices, Fraction(17, 10), [(1, 0), (0, 1)], symmetry=1)
    made = claim("polytope", property="radius-upper", family=0, length=1, bound="17/10", witness=witness)
    return matrices_document([[[q(x) for x in row] for row in m] for m in matrices], [made])


def jordan():
    witness = {"word": [0], "sign": 1, "vector": ["0", "1"]}
    made = claim("defective", family=0, length=1, value="1", witness=witness)
    return matrices_document([[["1", "1"], ["0", "1"]]], [made])


def irrational_weights():
    """A tie with weights in Q(λ) and σ in Q(λ): test_ties.py has more of them."""
    return of_family([[[1, -1], [0, 1]], [["4/5", 0], ["-4/5", "4/5"]]])


def plane():
    """The identity and a rotation times 3/4: every vector is a leader, here (3, 1), (2, 3), (0, 3) and (-2, 2)."""
    turn = [["9/20", "-3/5"], ["3/5", "9/20"]]
    leaders = [leader([0], [-1, 1], column=y) for y in ([3, 1], [2, 3], [0, 3], [-2, 2])]
    return closed([[[1, 0], [0, 1]], turn], 1, [-1, 1], 1, 1, leaders)


OWN = (swap_and_halve, golden_in_two_letters, two_leaders, golden_from_above, jordan, irrational_weights, plane)
MADE = {**ALL_RADIUS, **{make.__name__: make for make in OWN}}


@functools.cache
def certificate(name):
    """With one statement in the goal, so that the goal does not save the checker's rules."""
    made = MADE[name]()
    del made["goal"][1:]
    return made


def radius_rules(name):
    """The numbers of the claims that may be changed: those that test_checker_mutations.py does not know."""
    ours = {"transition", "positive-symbol", "holder-root", "attained-bounded", "attained-norm", "not-attained"}
    claims = certificate(name)["claims"]
    return [i for i, c in enumerate(claims) if name in FAMILIES or c["rule"] in ours | {"closing", "defective"}]


def parts_of(matrices, witness):
    """The diagonal blocks in the witness's basis, or None where it shows none."""
    p = np.array([[Fraction(x) for x in row] for row in witness["basis"]], dtype=object)
    changed = [solved(p, np.array(m, dtype=object).dot(p)) for m in matrices]
    if any(m is None for m in changed):
        return None
    ends = list(np.cumsum(witness["sizes"]))
    for m in changed:
        for first, end in zip([0, *ends], ends, strict=False):
            if m[end:, first:end].any():
                return None
    spans = zip([0, *ends], ends, strict=False)
    return [[m[first:end, first:end].tolist() for m in changed] for first, end in spans]


def negative(matrix):
    return [[-x for x in row] for row in matrix]


def solved(p, right):
    """P^-1 times a matrix, over Fractions."""
    rows, n = np.concatenate([p, right], axis=1), len(p)
    for k in range(n):
        pivot = next((i for i in range(k, n) if rows[i, k]), None)
        if pivot is None:
            return None
        rows[[k, pivot]] = rows[[pivot, k]]
        rows[k] = rows[k] / rows[k, k]
        for i in range(n):
            if i != k:
                rows[i] = rows[i] - rows[i, k] * rows[k]
    return rows[:, n:]


def known(document, name):
    """What is known of every family that the document has, by its number; blocks here are numbers."""
    if name in SCHEMES:
        scheme, families = SCHEMES[name], {}
        for c in document["claims"]:
            s = c["statement"]
            if s["property"] == "family":
                assert s["family"] == len(families)
                assert 1 <= s["nu"] <= scheme.order
                radius = max(2.0 ** -s["nu"], 2.0**-scheme.alpha)
                lost = s["nu"] == scheme.alpha and not scheme.attained
                families[s["family"]] = Family(radius, not lost, lost)
        return families
    families = {0: FAMILIES[name]}
    matrices = [[[Fraction(x) for x in row] for row in m] for m in document["mask"]["matrices"]]
    for c in document["claims"]:
        if c["rule"] == "distinct":
            kept = [matrices[letter] for letter in c["witness"]["letters"]]
            assert all(any(m in (k, negative(k)) for k in kept) for m in matrices)
            assert c["statement"] == {"property": "distinct", "family": 0, "part": 1}
            families[1] = families[0]
        if c["rule"] == "transposed":
            assert c["statement"] == {"property": "transposed", "family": 0, "part": 1}
            families[1] = families[0]
        if c["rule"] == "blocks":
            parts = parts_of(matrices, c["witness"])
            assert c["statement"]["family"] == 0
            assert parts is not None
            assert c["statement"]["parts"] == list(range(len(families), len(families) + len(parts)))
            for part in parts:
                assert all(len(m) == 1 for m in part)
                families[len(families)] = Family(float(max(abs(m[0][0]) for m in part)), True)
    return families


def is_true(s, families, name):
    """Whether a statement on radii is true; what it says of masks otherwise is not changed."""
    scheme = SCHEMES.get(name)
    if s["property"] == "holder-root":
        value = root_value(s)
        return value is not None and abs(-math.log2(value) / s["length"] - scheme.alpha) < 1e-8
    if s["property"] == "attained":
        return s["holds"] == scheme.attained
    if "family" not in s or s["property"] in ("family", "blocks", "distinct", "transposed"):
        return True
    family = families[s["family"]]
    power = family.radius ** s["length"]
    room = 1e-8 * max(1.0, power)
    if s["property"] == "radius-lower":
        return float(Fraction(s["bound"])) <= power + room
    if s["property"] == "radius-upper":
        return float(Fraction(s["bound"])) >= power - room
    if s["property"] == "defective":
        value = float(Fraction(s["value"]))
        return value < power - room or (value < power + room and family.defective)
    value = root_value(s)
    if value is None or abs(value - power) > room:
        return False
    return s["property"] == "radius" or family.bounded


def root_value(s):
    """The only root in the interval; None where there is none, or several."""
    low, high = (float(Fraction(s[key])) for key in ("low", "high"))
    roots = np.roots([float(Fraction(c)) for c in s["polynomial"][::-1]])
    real = [z.real for z in roots if abs(z.imag) < 1e-12 and low - 1e-12 <= z.real <= high + 1e-12]
    return real[0] if len(real) == 1 else None


def all_true(document, name):
    families = known(document, name)
    original = certificate(name)
    for number, c in enumerate(document["claims"]):
        assert is_true(c["statement"], families, name), (number, c["statement"])
        if number not in radius_rules(name):
            assert c == original["claims"][number]


@pytest.mark.parametrize("name", MADE)
def test_the_truth_says_that_the_true_certificates_are_true(name):
    outcome = check_document(certificate(name))
    assert outcome.verified, outcome.line
    all_true(certificate(name), name)


def test_the_witnesses_are_of_all_kinds():
    """Ties, irrational ones too, extras, several leaders, reflections and complex ones are among what is changed."""
    witnesses = [c["witness"] for name in MADE for c in certificate(name)["claims"] if "closing" in c["rule"]]
    assert any(w.get("ties") for w in witnesses)
    assert any("sigma" in w for w in witnesses)
    assert any(w["extras"] for w in witnesses)
    assert any(len(w["leaders"]) > 1 for w in witnesses)
    assert any(w["symmetry"] for w in witnesses)
    assert any(leader["reflected"] for w in witnesses for leader in w["leaders"])
    assert any("factor" in leader for w in witnesses for leader in w["leaders"])


def test_the_oracle_knows_falsehood():
    mask = ["-1/10", 0, "3/5", 1, "3/5", 0, "-1/10"]
    assert naive_product(naive_product(TENTH, [1, 1]), [1, 1]) == [Fraction(c) for c in mask]
    said = {"property": "bounded", "family": 0, "length": 1, "polynomial": ["-1", "-1", "1"], "low": "1", "high": "2"}
    assert is_true(said, {0: FAMILIES["golden"]}, "golden")
    assert not is_true({**said, "length": 2}, {0: FAMILIES["golden"]}, "golden")
    assert not is_true({**said, "low": "17/10"}, {0: FAMILIES["golden"]}, "golden")
    assert not is_true({**said, "polynomial": ["-3", "1"]}, {0: FAMILIES["golden"]}, "golden")
    three = {"property": "bounded", "family": 0, "length": 1, "polynomial": ["-3", "1"], "low": "3", "high": "3"}
    assert not is_true(three, {0: FAMILIES["triangular"]}, "triangular")
    assert is_true({**three, "property": "radius"}, {0: FAMILIES["triangular"]}, "triangular")
    upper = {"property": "radius-upper", "family": 0, "length": 2, "bound": "13/5"}
    assert not is_true(upper, {0: FAMILIES["golden"]}, "golden")
    lower = {"property": "radius-lower", "family": 0, "length": 2, "bound": "27/10"}
    assert not is_true(lower, {0: FAMILIES["golden"]}, "golden")
    full = [[[Fraction(1), Fraction(1)], [Fraction(1), Fraction(0)]]]
    assert parts_of(full, {"basis": [[1, 0], [0, 1]], "sizes": [1, 1]}) is None


def paths_of(name):
    ours = set(radius_rules(name))
    return [path for path in numbers(certificate(name)) if path[0] == "claims" and path[1] in ours]


def at(document, path):
    for key in path:
        document = document[key]
    return document


def true_or_rejected(name, path, new):
    """Whether the changed certificate is verified; then all that it says must be true."""
    document = copy.deepcopy(certificate(name))
    place, old = at(document, path[:-1]), at(document, path)
    place[path[-1]] = new if isinstance(old, int) else q(new)
    if place[path[-1]] == old:
        return False
    if path[2] == "statement":
        document["goal"] = [document["claims"][path[1]]["statement"]]
    outcome = check_document(document)
    assert "fails on it" not in outcome.line, (path, new)
    if outcome.verified:
        all_true(document, name)
    return outcome.verified


EXACT = {"word", "annihilator", "factor", "sign", "polynomial", "sigma", "sizes", "parts", "tree"}
"""Keys of numbers that no change leaves true: there is one witness with them, or a change makes another statement."""


@pytest.mark.parametrize("name", MADE)
def test_every_number_changed_a_little(name):
    accepted = set()
    for path in paths_of(name):
        place = at(certificate(name), path)
        old, tiny = Fraction(place), Fraction(1, 10**6)
        small = range(len(certificate(name)["claims"])) if "uses" in path else range(-1, 4)
        for new in {old + 1, old - 1, -old, 2 * old, old / 2, old + tiny, old - tiny, *map(Fraction, small)}:
            if isinstance(place, str) or new.denominator == 1:
                exact = new if isinstance(place, str) else int(new)
                if true_or_rejected(name, path, exact):
                    accepted.add(path)
    assert not [path for path in accepted if EXACT & set(path)]


@settings(max_examples=300)
@given(st.data())
def test_any_number_changed_to_anything(data):
    name = data.draw(st.sampled_from(sorted(MADE)))
    path = data.draw(st.sampled_from(paths_of(name)))
    if isinstance(at(certificate(name), path), int):
        new = data.draw(st.integers(-5, 40) | st.integers(-(10**12), 10**12))
    else:
        new = data.draw(st.fractions(max_denominator=1000) | st.fractions())
    true_or_rejected(name, path, new)
