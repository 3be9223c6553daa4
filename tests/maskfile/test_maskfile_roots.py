"""Roots of polynomials in expectations: every closed form that reports print is read, and equal numbers are equal."""

from __future__ import annotations

from fractions import Fraction as Q
from itertools import pairwise

import pytest
from flint import fmpq_poly, fmpz_poly
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from support import scheme

from subdiv_cli.exact.algebraic import isolated, roots
from subdiv_cli.exact.closed import compare, exponent
from subdiv_cli.maskfile.closed import certainly_less, read_closed_form, roots_between
from subdiv_cli.maskfile.option import parse_property
from subdiv_cli.maskfile.problems import Fault
from subdiv_cli.model import Effort, RootLog, Verdict
from subdiv_cli.model.closed import spelled
from subdiv_cli.pipeline import check

GOLDEN = "root(x^2-x-1, 1.61, 1.62)"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (f"-log2({GOLDEN})", "-log2(root(x^2-x-1, 1, 2))"),
        (f"-log2({GOLDEN})", "-log2(root(w^2 - w - 1, 8/5, 1.7))"),
        (f"-log2({GOLDEN})", "-log2(root(y^2-3*y+1, 2.6, 2.7))/2"),
        (f"-log2({GOLDEN})", "-log4(root(y^2-3*y+1, 2.6, 2.7))"),
        (f"-log2({GOLDEN})", "log2(root(x^2+x-1, 0.6, 0.7))"),
        (f"-log2({GOLDEN})", f"log2(1/{GOLDEN})"),
        (f"-log2({GOLDEN})", "-log2(-root(x^2+x-1, -1.7, -1.6))"),
        (f"-log2({GOLDEN})", "-log2(root((x^2-x-1)(x^2-2), 1.61, 1.62))"),
        (f"-log2({GOLDEN})", "-log2(2*root(4x^2-2x-1, 0.8, 0.81))"),
        (f"-log2({GOLDEN})", "-log2(root(x^2-2*x-4, 3.2, 3.3)/2)"),
        (f"-log2({GOLDEN})/3", "-1/3*log2(root(x^2-x-1, 1.61, 1.62))"),
        ("-log2(root(x^2-2, 1, 2))", "-1/2"),
        ("-log2(root(x^3-3, 1.4, 1.5))", "-log2(3)/3"),
        ("-log2(root(3x-1, 0.3, 1))", "log2(3)"),
        ("-log2(root((2x-1)(x^2-x-1), 1/4, 3/4))", "1"),
        (f"2-log2({GOLDEN})", "-log2(root(16x^2-4x-1, 0.40, 0.41))"),
        (f"-log2({GOLDEN})/3-1", f"-log2(8*{GOLDEN})/3"),
        ("log8(root(x^2-x-1, 1.61, 1.62))", f"log2({GOLDEN})/3"),
    ],
)
def test_one_number_in_two_spellings(one: str, other: str) -> None:
    assert compare(read_closed_form(one), read_closed_form(other)) == 0
    assert compare(read_closed_form(other), read_closed_form(one)) == 0


@pytest.mark.parametrize(
    ("smaller", "larger"),
    [
        (f"-log2({GOLDEN})", "-0.69"),
        (f"-log2({GOLDEN})", "-log2(root(x^2-x-1, 1.61, 1.62))/2"),
        (f"log3({GOLDEN})", f"log2({GOLDEN})"),
        ("-log2(root(x^2-x-1, 1.61, 1.62))", "-log2(809/500)"),
        ("log2(root(x^2-5*x+5, 1, 2))", "log2(root(x^2-5*x+5, 3, 4))"),
        ("log2(root(x^2-2*10^80*x+10^160-2, 10^80-2, 10^80))", "log2(10^80)"),
    ],
)
def test_different_numbers_are_told_apart(smaller: str, larger: str) -> None:
    assert compare(read_closed_form(smaller), read_closed_form(larger)) == -1
    assert compare(read_closed_form(larger), read_closed_form(smaller)) == 1
    assert not certainly_less(read_closed_form(larger), read_closed_form(smaller))


@pytest.mark.parametrize(
    ("text", "code", "message", "at"),
    [
        (GOLDEN, "SD012", "a root is no exponent", 0),
        ("log2(root(x^2-x-1))", "SD012", "a polynomial and two bounds", 17),
        ("log2(root(x^2-x-1, 1.61))", "SD012", "a polynomial and two bounds", 23),
        ("log2(root(x^2-x-1, 1.61, 1.62", "SD008", "never closed", 9),
        ("log2(root(x^2-x-1, 1.61, 1.62, 2))", "SD008", "stands where", 29),
        ("log2(root(x^2-y-1, 1.61, 1.62))", "SD012", "one variable", 14),
        ("log2(root(ab^2-1, 1.61, 1.62))", "SD012", "one variable", 10),
        ("log2(root(log2(3) x, 1, 2))", "SD008", "function call", 10),
        ("log2(root(x^2-x-1, x, 1.62))", "SD008", "not declared", 19),
        ("log2(root(x^2-x-1, 1.62, 1.61))", "SD012", "no bounds", 19),
        ("log2(root(x^2-x-1, -1, 2))", "SD012", "no bounds", 19),
        ("log2(root(x^2-x-1, -1, -0.5))", "SD012", "must be positive", 0),
        ("log2(root(x^2-x-1, 2, 3))", "SD012", "no root between 2 and 3", 10),
        ("log2(root(x^2-3x+1, 1/4, 3))", "SD012", "2 roots between", 10),
        ("log2(root((x^2-2)^2, 1, 2))", "SD012", "multiple one", 10),
        ("log2(root(5, 1, 2))", "SD012", "no root", 10),
        ("log2(root(x-x, 1, 2))", "SD012", "no root", 10),
        ("log2(root(x^65-2, 1, 2))", "SD010", "too large", 10),
        ("log2(root(x^2-10^999, 1, 10^999))", "SD010", "too long", 25),
        (f"log2({GOLDEN})*3", "SD012", "a multiple", 31),
        (f"log2({GOLDEN}) + 1/2", "SD012", "a sum with a root", 0),
        (f"log2({GOLDEN}) + 1025", "SD010", "too long", 0),
        (f"{GOLDEN}^2", "SD012", "a power of roots", 0),
        (f"log2({GOLDEN})*log2(3)", "SD012", "a product of logarithms", 31),
        (f"1/log2({GOLDEN})", "SD012", "a quotient of logarithms", 2),
        (f"log2(log2({GOLDEN}))", "SD012", "a logarithm of a logarithm", 0),
        (f"log2({GOLDEN})/257", "SD010", "divisor", 32),
        ("root", "SD008", "not declared", 0),
    ],
)
def test_what_is_no_closed_form(text: str, code: str, message: str, at: int) -> None:
    with pytest.raises(Fault) as caught:
        read_closed_form(text)
    assert (caught.value.code, caught.value.at) == (code, at)
    assert message in caught.value.message
    assert caught.value.help


def test_properties_of_the_command_line() -> None:
    found = parse_property(f"holder = -log2({GOLDEN}) .. log2({GOLDEN})")
    assert isinstance(found.lower, RootLog)
    assert isinstance(found.upper, RootLog)
    assert parse_property(f"sobolev>=log2({GOLDEN})/2").text == f">= log2({GOLDEN})/2"


integers = st.integers(-9, 9)
polynomials = st.lists(integers, min_size=2, max_size=7).filter(lambda f: f[-1] != 0)
bounds = st.fractions(-4, 4, max_denominator=6)


@settings(max_examples=300, deadline=None)
@given(polynomials, bounds, bounds)
def test_roots_are_counted(f: list[int], a: Q, b: Q) -> None:
    low, high = min(a, b), max(a, b)
    count = roots_between(f, low, high)
    real = {z for z, _ in roots_of(f)}
    expected = sum(1 for z in real if certainly_inside(z, low, high))
    assert count is None or count == expected


def roots_of(f: list[int]) -> list[tuple[float, int]]:
    """The real roots as doubles, rational ones rounded once."""
    return [(float(z.real.mid()), m) for z, m in fmpz_poly(f).complex_roots() if z.imag.is_zero()]


def certainly_inside(x: float, low: Q, high: Q) -> bool:
    return float(low) - 1e-12 <= x <= float(high) + 1e-12


@settings(max_examples=200, deadline=None)
@given(polynomials, st.integers(1, 6), st.sampled_from([2, 3, 4, 5, 8]))
def test_every_exponent_that_is_printed_is_read_again(f: list[int], length: int, p: int) -> None:
    positive = [x for x, _ in roots(fmpq_poly(f)) if x.is_real and x.region.real > 0]
    assume(positive)
    for number in positive:
        exact = exponent(p, length, isolated(number))
        text = spelled(exact)
        assert text is not None
        again = read_closed_form(text)
        assert compare(exact, again) == 0
        assert spelled(again) == text


@settings(max_examples=25, deadline=None)
@given(st.lists(integers, min_size=3, max_size=5), st.integers(0, 3))
def test_the_exponents_of_any_mask_are_read_again(q: list[int], order: int) -> None:
    """The report's `exact` as an expectation is proved."""
    assume(sum(q) != 0)
    mask = [Q(2 * c, sum(q)) for c in q]
    for _ in range(order + 1):
        mask = [(a + b) / 2 for a, b in pairwise([Q(0), *mask, Q(0)])]
    found = check(scheme(mask), (), Effort(2000)).result
    stated = [
        parse_property(f"{key} = {text}")
        for key, exact in (
            ("holder", found.holder and found.holder.exact),
            ("sobolev", found.sobolev and found.sobolev.exact),
        )
        if exact is not None and (text := spelled(exact)) is not None
    ]
    judged = check(scheme(mask), stated, Effort(2000)).result.expectations
    assert [j.verdict for j in judged] == [Verdict.PROVED] * len(stated)
