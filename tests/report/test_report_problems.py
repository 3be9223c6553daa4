"""Problems: the place, the line, the caret."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.model import Problem
from subdiv_cli.report.letters import width
from subdiv_cli.report.look import UNWRAPPED, Look
from subdiv_cli.report.problems import excerpt, render

FRACTION = Problem(
    code="SD003",
    message="fraction not quoted: TOML has no fractions",
    help='write exact coefficients as strings: "-1/16"',
    file="masks/four_point.toml",
    key="mask.coefficients[0]",
    line=13,
    column=19,
    source='coefficients = [-1/16, 0, "9/16"]',
)


def test_all_there_is_to_say():
    assert render([FRACTION], Look()) == (
        "error[SD003] fraction not quoted: TOML has no fractions\n"
        "   --> masks/four_point.toml:13:19 in mask.coefficients[0]\n"
        "   |\n"
        '13 | coefficients = [-1/16, 0, "9/16"]\n'
        "   |                   ^\n"
        '   = help: write exact coefficients as strings: "-1/16"\n'
        "   = more: subdiv explain SD003\n"
    )


def test_as_little_as_there_is():
    assert render([Problem(code="SD001", message="nothing")], Look()) == (
        "error[SD001] nothing\n  = more: subdiv explain SD001\n"
    )


@pytest.mark.parametrize(
    ("where", "shown"),
    [
        ({"file": "a.toml"}, "a.toml"),
        ({"file": "a.toml", "line": 3}, "a.toml:3"),
        ({"file": "a.toml", "line": 3, "column": 4}, "a.toml:3:4"),
        ({"file": "a.toml", "key": "mask"}, "a.toml in mask"),
        ({"key": "mask"}, "mask"),
        ({"key": "-p", "line": 1, "column": 5}, "-p:1:5"),
    ],
)
def test_place(where, shown):
    assert render([Problem(code="SD001", message="m", **where)], Look()).splitlines()[1] == f"  --> {shown}"


def test_several_are_apart():
    assert render([FRACTION, FRACTION], Look()).count("\n\nerror[SD003]") == 1
    assert render([], Look()) == ""


def test_long_messages_are_wrapped_only_where_there_is_a_width():
    problem = Problem(code="SD001", message="word " * 60, help="help " * 60)
    assert max(map(len, render([problem], Look(width=40)).splitlines())) <= 40
    assert len(render([problem], Look(width=UNWRAPPED)).splitlines()) == 3


@given(
    st.text(st.characters(codec="utf-8", exclude_characters="\r\n"), min_size=1, max_size=300),
    st.integers(1, 300),
    st.integers(20, 100),
    st.booleans(),
)
def test_an_excerpt_fits_and_its_caret_is_inside(source, column, room, unicode):
    shown, caret = excerpt(source, column, room, unicode=unicode)
    assert caret is not None
    assert width(shown) <= room
    assert 0 <= caret <= room
    if not unicode:
        assert shown.isascii()


@given(st.integers(0, 250), st.integers(0, 250), st.integers(30, 100))
def test_the_caret_points_at_the_character_however_the_line_is_cut(before, after, room):
    source = "a" * before + "!" + "b" * after
    shown, caret = excerpt(source, before + 1, room)
    assert shown[caret] == "!"
    assert len(shown) <= room
    assert shown.startswith(("…", source[: caret + 1]))
    if before + after + 1 <= room:
        assert shown == source
    else:
        assert shown.count("…") in (1, 2)


def test_tabs_and_wide_letters_move_the_caret():
    shown, caret = excerpt("\t中 = x", 6, 80)
    assert shown == "    中 = x"
    assert caret == width("    中 = ")


def test_a_caret_behind_the_end():
    assert excerpt("start =", 8, 80) == ("start =", 7)
    assert excerpt("start =", 99, 80) == ("start =", 7)


def test_no_caret_without_a_column():
    problem = Problem(code="SD001", message="m", file="a", line=2, source="x = 1")
    assert "^" not in render([problem], Look())
    assert "2 | x = 1" in render([problem], Look())
