"""Wrapping and tables: everything fits, and nothing is lost."""

import re

from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.report.letters import width
from subdiv_cli.report.page import Cell, joined, led, paint, paragraph, table, wrap

texts = st.text(st.sampled_from("ab/φ中 "), max_size=80)


def flat(text):
    return re.sub(" |\n|─", "", text)


@given(texts, st.integers(2, 40))
def test_wrapped_lines_fit_and_keep_every_letter(text, columns):
    lines = wrap(text, columns)
    assert all(width(line) <= columns for line in lines)
    assert flat("".join(lines)) == flat(text)


@given(texts, texts, st.integers(15, 40), st.integers(0, 6), st.integers(0, 6))
def test_paragraphs_keep_every_letter(lead, text, columns, indent, hanging):
    shown = paint(paragraph(text, columns, indent=indent, hanging=hanging))
    assert flat(shown) == flat(text)
    assert all(width(line) <= columns for line in shown.splitlines())
    assert flat(paint(led([(lead, "head")], text, columns, hanging=hanging))) == flat(lead + text)


def test_a_paragraph_is_broken_between_words_and_hangs():
    assert paint(paragraph("one two three four", 11, indent=2, hanging=1)) == "  one two\n   three\n   four\n"


def test_a_long_formula_is_broken_after_an_operator():
    assert wrap("123456+7890*12", 10) == ["123456+", "7890*12"]


@given(st.lists(texts, max_size=5), st.integers(10, 40))
def test_items_in_a_row_keep_every_letter(items, columns):
    shown = paint(joined(items, "; ", columns))
    assert flat(shown).replace(";", "") == flat("".join(items))


@given(st.lists(st.lists(texts, min_size=3, max_size=3), min_size=1, max_size=3), st.integers(10, 100))
def test_tables_fit_and_keep_every_letter(rows, columns):
    cells = [[Cell(text) for text in row] for row in rows]
    shown = paint(table(("", "", ""), cells, columns, rule="─"))
    assert all(width(line) <= columns for line in shown.splitlines())
    assert sorted(flat(shown)) == sorted(flat("".join(map("".join, rows))))


def test_a_table_that_fits_is_aligned():
    shown = paint(table(("a", "bc"), [[Cell("one"), Cell("2")], [Cell(""), Cell("33")]], 20, rule="-"))
    assert shown == "a    bc\n---  --\none  2\n     33\n"


def test_a_table_that_does_not_fit_becomes_a_list():
    row = [Cell("name"), Cell("yes"), Cell("a long value"), Cell("")]
    assert paint(table(("", "", "", ""), [row], 12, rule="-")) == "name  yes\n  a long\n    value\n"


def test_such_a_list_names_its_columns_but_the_first_two_where_they_fit():
    row = [Cell("mask"), Cell("converges"), Cell("refuted"), Cell("")]
    header = ("a", "convergence", "stability", "file")
    assert paint(table(header, [row], 22, rule="-")) == "mask  converges\n  stability: refuted\n"
    assert (
        paint(table(header, [row], 14, rule="-")) == "mask\n  convergence:\n    converges\n  stability:\n    refuted\n"
    )
