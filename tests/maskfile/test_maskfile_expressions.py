"""The grammar of expressions, and Laurent polynomials computed on two ways."""

from __future__ import annotations

from fractions import Fraction as Q

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.maskfile.expressions import evaluate
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Fault

Z = ("z", "w", "v")
VALUES = {"w": Q(1, 16), "v": Q(-3)}


def value(text: str) -> dict[int, Q]:
    return evaluate(parse(text, Z), VALUES, Work()).coefficients


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("0", {}),
        ("-1/16", {0: Q(-1, 16)}),
        ("0.1", {0: Q(1, 10)}),
        (".5", {0: Q(1, 2)}),
        ("2.", {0: Q(2)}),
        ("1.25e-3", {0: Q(1, 800)}),
        ("1E+2", {0: Q(100)}),
        ("+3", {0: Q(3)}),
        ("007", {0: Q(7)}),
        ("1/2/2", {0: Q(1, 4)}),
        ("8/4*2", {0: Q(4)}),
        ("1-2-3", {0: Q(-4)}),
        ("2*-3", {0: Q(-6)}),
        ("1 - -1", {0: Q(2)}),
        ("--1", {0: Q(1)}),
        ("1/-2", {0: Q(-1, 2)}),
        ("-z^2", {2: Q(-1)}),
        ("(-z)^2", {2: Q(1)}),
        ("2z", {1: Q(2)}),
        ("2 z^-3", {-3: Q(2)}),
        ("z^(-3)", {-3: Q(1)}),
        ("z^+2", {2: Q(1)}),
        ("(2z)^-2", {-2: Q(1, 4)}),
        ("z^0", {0: Q(1)}),
        ("0^0", {0: Q(1)}),
        ("w z", {1: Q(1, 16)}),
        ("w(1+z)", {0: Q(1, 16), 1: Q(1, 16)}),
        ("(1+z)(1-z)", {0: Q(1), 2: Q(-1)}),
        ("(1+z)^3", {0: Q(1), 1: Q(3), 2: Q(3), 3: Q(1)}),
        ("z/2 * v", {1: Q(-3, 2)}),
        ("z/(2 v)", {1: Q(-1, 6)}),
        ("(1+z)/z", {-1: Q(1), 0: Q(1)}),
        ("(1+z)/(1+z-1)", {-1: Q(1), 0: Q(1)}),
        ("((1-z^2)/(1-z))^2/8", {0: Q(1, 8), 1: Q(1, 4), 2: Q(1, 8)}),
        ("1/(1-z) * (1-z^2)", {0: Q(1), 1: Q(1)}),
        ("(1-z^2)^2 (1-z)^-2", {0: Q(1), 1: Q(2), 2: Q(1)}),
        ("(1-z^2)/(w - w z)", {0: Q(16), 1: Q(16)}),
        ("z/(2z-4)^-1", {2: Q(2), 1: Q(-4)}),
        ("(1-z)^3/(1-z)/(z-1)", {0: Q(-1), 1: Q(1)}),
        ("(z-z)/(1+z)", {}),
        ("(1-z^1500)/(1-z)", dict.fromkeys(range(1500), Q(1))),
        ("1/2*3 z", {1: Q(3, 2)}),
        ("1/(1-16w+1)", {0: Q(1)}),
        ("\t1\n+ 1 ", {0: Q(2)}),
    ],
)
def test_values(text: str, expected: dict[int, Q]) -> None:
    assert value(text) == expected


@pytest.mark.parametrize(
    "text",
    ["1/2 w", "1/(2) w", "z/w z", "1/z^2 w", "1/2 (1+z)", "w/2(1+z)", "1/-2 z"],
)
def test_juxtaposition_after_a_division_is_refused(text: str) -> None:
    with pytest.raises(Fault, match="directly after a division"):
        value(text)


def test_the_four_point_symbol_of_the_literature() -> None:
    symbol = "z^-3 (1+z)^2 (z^2/2 - w (z-1)^2 (1+z^2))"
    w = VALUES["w"]
    assert value(symbol) == {-3: -w, -1: Q(1, 2) + w, 0: Q(1), 1: Q(1, 2) + w, 3: -w}


def test_nesting_up_to_the_bound() -> None:
    assert value("(" * 32 + "1" + ")" * 32) == {0: Q(1)}
    with pytest.raises(Fault, match="nested more than 32"):
        value("(" * 33 + "1" + ")" * 33)
    assert value("(1)" * 1000) == {0: Q(1)}


def test_digits_up_to_the_bound() -> None:
    assert value("9" * 1000) == {0: Q(10**1000 - 1)}
    assert value("1e-1000 * 10^1000") == {0: Q(1)}
    for text in ("9" * 1001, "1e1001", "1e99999999999999999999", "10^1000 * 10^1000", "(1/10^999)^2"):
        with pytest.raises(Fault) as caught:
            value(text)
        assert caught.value.code == "SD010"


def test_long_sums_and_products_are_no_deep_trees() -> None:
    assert value("+".join(["z"] * 5000)) == {1: Q(5000)}
    assert value("-" * 5000 + "1") == {0: Q(1)}
    assert value("z*" * 5000 + "1") == {5000: Q(1)}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1/(1+z)", r"1 \+ z does not divide 1 exactly"),
        ("(1+z)^2/(1-z)", r"1 - z does not divide 1 \+ 2 z \+ z\^2 exactly"),
        ("(1+z)^2/(2+z)", r"2 \+ z does not divide"),
        ("(1+z)^9/(1-z)^8", "this divisor does not divide what stands before it exactly"),
        ("1/(1-z) - z/(1-z)", r"1 - z does not divide 1 exactly"),
    ],
)
def test_divisions_with_a_remainder(text: str, message: str) -> None:
    with pytest.raises(Fault, match=message):
        value(text)


@pytest.mark.parametrize("text", ["(1-z^1000000)/(1-z)", "(1+z^5000)/(3+z-z^2)", "(1-z)^1900/(1-2z+7z^2)^3"])
def test_divisions_are_bounded(text: str) -> None:
    with pytest.raises(Fault) as caught:
        value(text)
    assert caught.value.code in ("SD008", "SD010")


Poly = dict[int, Q]


def trim(p: Poly) -> Poly:
    return {k: c for k, c in p.items() if c}


def add(a: Poly, b: Poly, sign: int = 1) -> Poly:
    return trim({k: a.get(k, Q(0)) + sign * b.get(k, Q(0)) for k in {*a, *b}})


def mul(a: Poly, b: Poly) -> Poly:
    out: Poly = {}
    for j, x in a.items():
        for k, y in b.items():
            out[j + k] = out.get(j + k, Q(0)) + x * y
    return trim(out)


numbers = st.one_of(
    st.integers(0, 99).map(lambda n: (str(n), trim({0: Q(n)}))),
    st.tuples(st.integers(0, 99), st.integers(0, 999)).map(
        lambda t: (f"{t[0]}.{t[1]:03}", trim({0: Q(1000 * t[0] + t[1], 1000)}))
    ),
)
names = st.sampled_from([("z", {1: Q(1)}), ("w", {0: VALUES["w"]}), ("v", {0: VALUES["v"]})])
monomials = st.builds(lambda n, c: (f"({c}z^{n})", {n: Q(c)}), st.integers(-4, 4), st.integers(1, 5))
Printed = tuple[str, Poly]


def compound(children: st.SearchStrategy[Printed]) -> st.SearchStrategy[Printed]:
    """Bigger expressions, printed with parentheses round every part that needs them, and their polynomials."""
    pairs = st.tuples(children, children)
    return st.one_of(
        pairs.map(lambda t: (f"{t[0][0]} + {t[1][0]}", add(t[0][1], t[1][1]))),
        pairs.map(lambda t: (f"{t[0][0]} - ({t[1][0]})", add(t[0][1], t[1][1], -1))),
        pairs.map(lambda t: (f"({t[0][0]})*({t[1][0]})", mul(t[0][1], t[1][1]))),
        pairs.map(lambda t: (f"({t[0][0]}) ({t[1][0]})", mul(t[0][1], t[1][1]))),
        children.map(lambda c: (f"-({c[0]})^2", add({}, mul(c[1], c[1]), -1))),
        st.tuples(children, monomials).map(
            lambda t: (f"({t[0][0]})/{t[1][0]}", mul(t[0][1], {-k: 1 / c for k, c in t[1][1].items()}))
        ),
        st.tuples(monomials, st.integers(-3, 3)).map(
            lambda t: (f"{t[0][0]}^{t[1]}", {k * t[1]: Q(c) ** t[1] for k, c in t[0][1].items()})
        ),
    )


expressions = st.recursive(st.one_of(numbers, names, monomials), compound, max_leaves=12)


polynomials = st.dictionaries(st.integers(-6, 6), st.fractions(-9, 9, max_denominator=9), max_size=6).map(trim)


def written(p: Poly) -> str:
    return " + ".join(f"({c}) z^{k}" for k, c in p.items()) or "0"


@settings(max_examples=300, deadline=None)
@given(polynomials, polynomials.filter(bool), st.booleans())
def test_exact_divisions(a: Poly, b: Poly, spoil: bool) -> None:
    """a b / b = a; and (a b + z^40) / b is no Laurent polynomial, unless b is a monomial."""
    if not spoil or len(b) == 1:
        assert value(f"({written(mul(a, b))})/({written(b)})") == a
        return
    with pytest.raises(Fault, match="exactly"):
        value(f"({written(mul(a, b))} + z^40)/({written(b)})")


@settings(max_examples=300, deadline=None)
@given(expressions)
def test_printed_expressions_read_back_as_the_same_polynomial(printed: Printed) -> None:
    text, expected = printed
    assert value(text) == expected


@settings(max_examples=250, deadline=None)
@given(st.text("zwv0123456789+-*/^()., e", max_size=25))
def test_any_text_gives_a_value_or_a_fault_inside_it(text: str) -> None:
    found = None
    try:
        value(text)
    except Fault as fault:
        found = fault
    assert found is None or (0 <= found.at <= len(text) and found.help)
