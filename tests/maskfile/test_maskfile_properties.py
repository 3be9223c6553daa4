"""The grammar of expectations: one for files and for the command line."""

from __future__ import annotations

import contextlib
import math
from fractions import Fraction as Q

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from subdiv_cli.maskfile import MaskFileError
from subdiv_cli.maskfile.closed import certainly_less, read_closed_form
from subdiv_cli.maskfile.option import parse_expectation, parse_property
from subdiv_cli.maskfile.problems import Fault
from subdiv_cli.model import ClosedForm, Expectation, Log


def number(x: ClosedForm) -> float:
    if isinstance(x, Log):
        return math.log(x.argument) / math.log(x.base) / x.divisor
    return float(x)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2", Q(2)),
        ("1.99", Q(199, 100)),
        ("-1/2", Q(-1, 2)),
        ("log2(8)", Q(3)),
        ("log4(2)", Q(1, 2)),
        ("log2(9)/2", Log(base=2, argument=Q(3))),
        ("log2(64/9)", Log(base=2, argument=Q(64, 9))),
        ("log3(11)/2", Log(base=3, argument=Q(11), divisor=2)),
        ("2 - log2(3)", Log(base=2, argument=Q(4, 3))),
        ("-log2(3/4)", Log(base=2, argument=Q(4, 3))),
        ("3 log9(2)", Log(base=3, argument=Q(8), divisor=2)),
        ("log2(3) + log4(9)", Log(base=2, argument=Q(9))),
        ("log2(3) - log2(3)", Q(0)),
        ("log2(3)*0", Q(0)),
        ("log2(1/3) + 1/2", Log(base=2, argument=Q(2, 9), divisor=2)),
    ],
)
def test_closed_forms_are_canonical(text: str, expected: ClosedForm) -> None:
    assert read_closed_form(text) == expected


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("log2(3)*log2(3)", "SD012"),
        ("1/log2(3)", "SD012"),
        ("log2(3)^2", "SD012"),
        ("log2(log2(3))", "SD012"),
        ("log2(3)+log3(2)", "SD012"),
        ("log1(3)", "SD012"),
        ("log0(3)", "SD012"),
        ("log2(0)", "SD012"),
        ("log2(3)/0", "SD007"),
        ("0^-1", "SD007"),
        ("log2(3)/1000", "SD010"),
        ("log2(3)*1000000", "SD010"),
        ("log2(3) + 1/1000", "SD010"),
        ("log2(3) + 1000000", "SD010"),
        ("2^2000", "SD010"),
        ("log2(2^999*3^999)", "SD010"),
        ("log9999999(3)", "SD012"),
        ("log(3)", "SD008"),
        ("ln(3)", "SD008"),
        ("z", "SD008"),
    ],
)
def test_what_is_no_closed_form(text: str, code: str) -> None:
    with pytest.raises(Fault) as caught:
        read_closed_form(text)
    assert caught.value.code == code
    assert caught.value.help


logs = st.tuples(st.integers(2, 12), st.fractions(Q(1, 50), 50, max_denominator=50), st.integers(1, 4)).map(
    lambda t: f"log{t[0]}({t[1]})/{t[2]}"
)
rationals = st.fractions(-5, 5, max_denominator=9).map(lambda q: f"({q})")


@settings(max_examples=200, deadline=None)
@given(st.one_of(logs, rationals), st.one_of(logs, rationals), rationals)
def test_closed_forms_agree_with_floats(x: str, y: str, q: str) -> None:
    a, b, c = read_closed_form(x), read_closed_form(y), read_closed_form(q)
    assert number(read_closed_form(f"{x} * {q}")) == pytest.approx(number(a) * number(c), abs=1e-9)
    with contextlib.suppress(Fault):  # two bases
        assert number(read_closed_form(f"{x} - {y}")) == pytest.approx(number(a) - number(b), abs=1e-9)
    if certainly_less(a, b):
        assert number(a) < number(b) + 1e-12
        assert not certainly_less(b, a)
    elif number(a) < number(b) - 1:
        raise AssertionError("numbers this far apart are told apart")


@pytest.mark.parametrize(
    ("text", "key", "lower", "upper"),
    [
        ("C1", "smoothness", 1, None),
        ("HC1", "smoothness", 1, None),
        ("C^2", "smoothness", 2, None),
        ("C0", "smoothness", 0, None),
        ("C(2)", "smoothness", 2, None),
        ("smoothness >= C1", "smoothness", 1, None),
        ("smoothness = C^1", "smoothness", 1, 1),
        ("smoothness = C1 .. C2", "smoothness", 1, 2),
        ("convergent", "convergent", True, True),
        ("convergent = false", "convergent", False, False),
        ("stable=true", "stable", True, True),
        ("smoothness=1", "smoothness", 1, 1),
        ("smoothness == 1", "smoothness", 1, 1),
        (" holder>=1.5 ", "holder", Q(3, 2), None),
        ("holder >= log2(3)", "holder", Log(base=2, argument=Q(3)), None),
        ("holder=1.99 .. 2.01", "holder", Q(199, 100), Q(201, 100)),
        ("holder = 1..2", "holder", Q(1), Q(2)),
        ("holder = 2..2", "holder", Q(2), Q(2)),
        ("generation = 1 .. 3", "generation", 1, 3),
        ("reproduction >= 2", "reproduction", 2, None),
    ],
)
def test_properties(text: str, key: str, lower: object, upper: object) -> None:
    found = parse_property(text)
    assert (found.key, found.lower, found.upper) == (key, lower, upper)
    assert type(found.lower) is type(lower)
    in_file = found.lower if isinstance(found.lower, bool) else found.text
    assert parse_expectation(found.key, in_file) == found


@pytest.mark.parametrize(
    ("text", "message", "column"),
    [
        ("", "is no property", None),
        ("1.5", "is no property", 1),
        ("C", 'no property "C"', 1),
        ("C-1", "is no property", 1),
        ("hoelder>=1", 'no property "hoelder"', 1),
        ("sobolev", "sobolev needs a number", 8),
        ("holder", "holder needs a number", 7),
        ("holder>=", "a number is missing", 9),
        ("holder>1", "no comparison", 7),
        ("holder<=1", "no comparison", 7),
        ("holder===1", "no comparison", 7),
        ("convergent>=1", "is true or false", 11),
        ("stable=maybe", "is true or false", 7),
        ("smoothness=-1", "cannot be negative", 12),
        ("smoothness>=1/2", "is an integer", 13),
        ("holder=1 .. x", '"x" is not declared', 13),
        ("C9999999", "too large", 2),
    ],
)
def test_bad_properties(text: str, message: str, column: int | None) -> None:
    with pytest.raises(MaskFileError) as caught:
        parse_property(text)
    (problem,) = caught.value.problems
    assert message in problem.message
    assert problem.column == column
    assert problem.help


def test_the_text_of_an_expectation_is_as_it_was_spelled() -> None:
    assert parse_expectation("holder", ">=log2(64/9)") == Expectation(
        key="holder", text=">= log2(64/9)", lower=Log(base=2, argument=Q(64, 9))
    )
    assert parse_expectation("holder", " 1.990 .. 2.01 ").text == "1.990 .. 2.01"


@settings(max_examples=300, deadline=None)
@given(st.text("C1holder>=<. log2()/-+*^9", max_size=20))
def test_any_property_is_read_or_refused(text: str) -> None:
    problems = None
    try:
        parse_property(text)
    except MaskFileError as error:
        problems = error.problems
    assert problems is None or problems[0].help
