"""The text report: whole pages against files, and what must hold on every page.

`UPDATE_GOLDEN=1 pytest tests/report` writes the files anew; read the difference before committing it.
"""

import os
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
import report_samples as samples
from hypothesis import given
from hypothesis import strategies as st

from subdiv_cli.model import Exponent, Finding, Problem, Result, Verdict
from subdiv_cli.report import FORMATS, renderer
from subdiv_cli.report.letters import width
from subdiv_cli.report.look import Look
from subdiv_cli.report.text import render

GOLDEN = Path(__file__).with_name("golden")
PAGES = {
    "four-point-80": ([samples.FOUR_POINT], Look(width=80)),
    "four-point-40": ([samples.FOUR_POINT], Look(width=40)),
    "four-point-120-witnesses": ([samples.FOUR_POINT], Look(width=120, verbosity=2)),
    "four-point-80-ascii": ([samples.FOUR_POINT], Look(width=80, unicode=False)),
    "several-100": (samples.ALL, Look()),
    "several-40-ascii": (samples.ALL, Look(width=40, unicode=False)),
    "several-quiet": (samples.ALL, Look(verbosity=-1)),
    "divergent-80-colour": ([samples.DIVERGENT], Look(width=80, colour=True)),
    "undecided-80": ([samples.UNDECIDED], Look(width=80)),
    "several-100-problems-elsewhere": (samples.ALL, Look(problems=False)),
    "invalid-80": ([samples.INVALID], Look(width=80)),
}


def same_as_golden(name, text):
    path = GOLDEN / name
    if os.environ.get("UPDATE_GOLDEN"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8")


@pytest.mark.parametrize("page", PAGES)
def test_page(page):
    results, look = PAGES[page]
    same_as_golden(f"{page}.txt", render(results, look))


def test_no_file_without_a_page():
    assert {path.stem for path in GOLDEN.glob("*.txt")} == set(PAGES)


@pytest.mark.parametrize("columns", [30, 40, 60, 80, 120])
@pytest.mark.parametrize("unicode", [True, False])
def test_no_line_is_wider_than_asked(columns, unicode):
    text = render(samples.ALL, Look(width=columns, unicode=unicode, verbosity=2))
    lines = [line for line in text.splitlines() if not re.match(r" *\d* \| ", line)]  # source lines are not wrapped
    assert max(map(width, lines)) <= columns


@pytest.mark.parametrize("columns", [25, 40, 80, 120])
def test_a_long_number_is_wrapped_and_never_cut(columns):
    number = Fraction(3**200, 2**300)
    finding = Finding(
        code="SD301", name="contractivity", verdict=Verdict.PROVED, statement=f"the norm is {number} < 1", source="Dyn"
    )
    facts = {"norm": number, "word": tuple(range(40))}
    text = render([replace(samples.FOUR_POINT, findings=(finding,), facts=facts)], Look(width=columns))
    flat = re.sub(r"\s+", "", text)
    assert flat.count(str(number)) == 2
    assert ",".join(map(str, range(40))) in flat


def test_a_number_too_long_for_str_is_printed():
    value = 10**5000 + 1
    text = render([replace(samples.FOUR_POINT, facts={"big": Fraction(value, 7)})], Look())
    assert "1" + "0" * 4999 + "1/7" in re.sub(r"\s+", "", text)


def test_without_colour_there_is_not_one_escape_and_with_it_the_same_text():
    plain = render(samples.ALL, Look(verbosity=1))
    coloured = render(samples.ALL, Look(verbosity=1, colour=True))
    assert "\x1b" not in plain
    assert coloured.count("\x1b[") > 50
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == plain


def test_a_verdict_is_always_a_word_and_a_sign():
    text = render(samples.ALL, Look(verbosity=1))
    for shown in ("✓ proved", "✗ refuted", "? undecided", "– skipped"):
        assert shown in text


def test_headlines():
    def first(result):
        return render([result], Look(width=500)).splitlines()[0]

    four = samples.FOUR_POINT
    exact = replace(four, holder=Exponent(lower=2.0, upper=2.0, exact=Fraction(2)))
    assert first(exact) == "✓ four-point scheme: C^1, not C^2 — convergence proved; Hölder exponent 2"
    below = replace(four, holder=Exponent(lower=1.5))
    assert first(below).endswith("; Hölder exponent ≥ 1.5")
    assert first(replace(four, holder=None)).endswith("convergence proved")
    assert first(replace(four, name=None)).startswith("✓ masks/scalar/four-point.toml: C^1")
    assert first(samples.DIVERGENT).startswith("✗ halved Chaikin: does not converge: the residue classes sum to")
    assert first(samples.INVALID) == "! masks/broken.toml: not checked: 2 errors"


def test_a_headline_does_not_stammer():
    said = replace(samples.DIVERGENT.findings[0], code="SD201", statement="S diverges: a(1) = 3")
    text = render([replace(samples.DIVERGENT, findings=(said,))], Look())
    assert text.splitlines()[0] == "✗ halved Chaikin: diverges: a(1) = 3"


@pytest.mark.parametrize(("upper", "labelled"), [(0.5, False), (0.0, True), (-1.0, True)])
def test_an_exponent_that_is_not_positive_is_labelled(upper, labelled):
    text = render([replace(samples.DIVERGENT, holder=Exponent(lower=-2.0, upper=upper))] * 2, Look())
    assert ("distributional" in text.splitlines()[2]) is labelled


def test_refuted_beside_proved_smoothness_is_not_said_to_be_proved_alone():
    row = next(line for line in render([samples.FOUR_POINT], Look()).splitlines() if line.startswith("  smoothness"))
    assert "SD302" in row
    assert "SD303" in row


def test_quiet_is_silent_when_all_passed():
    assert render([samples.FOUR_POINT] * 3, Look(verbosity=-1)) == ""


def test_quiet_leaves_out_what_passed():
    text = render(samples.ALL, Look(verbosity=-1))
    assert "four-point" not in text
    assert "halved Chaikin" in text
    assert "Deslauriers" in text
    assert "Deslauriers" not in render(samples.ALL, Look(verbosity=-1, allow_undecided=True))


def test_several_show_in_full_what_did_not_pass_and_verbose_shows_all():
    short, full = render(samples.ALL, Look()), render(samples.ALL, Look(verbosity=1))
    assert "no higher power" not in short
    assert "multiply by 2" in short
    assert "no higher power" in full
    assert "cofactor" not in full
    assert "cofactor" in render(samples.ALL, Look(verbosity=2))


def test_footer_counts():
    assert render(samples.ALL, Look()).splitlines()[-1] == "4 masks: 1 passed, 1 failed, 1 undecided, 1 invalid"
    allowed = render(samples.ALL, Look(allow_undecided=True)).splitlines()[-1]
    assert allowed == "4 masks: 1 passed, 1 failed, 1 undecided (allowed), 1 invalid"


anything = st.text(st.characters(exclude_categories=[]), max_size=60)


@given(anything, anything, anything, st.sampled_from(list(Verdict)), st.sampled_from(sorted(FORMATS)))
def test_any_text_is_printable_anywhere(name, statement, reason, verdict, form):
    finding = Finding(code="SD999", name="any", verdict=verdict, statement=statement, reason=reason, source=name)
    problem = Problem(code="SD001", message=statement, help=reason, file=name, line=1, column=2, source=statement)
    results = [
        Result(file=name, name=name, status="failed", findings=(finding,), facts={"fact": reason}),
        Result(file=name, status="invalid", problems=(problem,)),
    ]
    for columns in (20, 80):
        text = renderer(form)(results, Look(width=columns, unicode=False, verbosity=2))
        text.encode("ascii" if form != "json" else "utf-8")
        assert form == "json" or not re.search("[\x00-\x09\x0b-\x1f\x7f]", text)
        renderer(form)(results, Look(width=columns, verbosity=2)).encode("utf-8")


def test_an_escape_sequence_in_a_name_does_not_reach_the_terminal():
    text = render([replace(samples.FOUR_POINT, name="\x1b[2Jboo\u202e")], Look(colour=True))
    assert "\x1b[2J" not in text
    assert r"\x1b[2Jboo\u202e" in text
