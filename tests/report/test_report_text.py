"""The text report: whole pages against files, and what must hold on every page.

`UPDATE_GOLDEN=1 pytest tests/report` writes the files anew; read the difference before committing it.
"""

import json
import os
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
import report_samples as samples
from hypothesis import given
from hypothesis import strategies as st
from report_samples import finding

from subdiv_cli.kinds.scalar.rules import rules
from subdiv_cli.model import UNKNOWN, Exponent, Finding, Log, Problem, Result, Verdict
from subdiv_cli.report import FOR_PEOPLE, FORMATS, renderer
from subdiv_cli.report.letters import width
from subdiv_cli.report.look import Look

render, render_json = renderer("text"), renderer("json")

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
    text = render([replace(samples.FOUR_POINT, findings=(finding,), facts=facts)], Look(width=columns, verbosity=1))
    flat = re.sub(r"\s+", "", text)
    assert flat.count(str(number)) == 2
    assert ",".join(map(str, range(40))) in flat


def test_a_number_too_long_for_str_is_printed():
    value = 10**5000 + 1
    text = render([replace(samples.FOUR_POINT, facts={"big": Fraction(value, 7)})], Look())
    assert "1" + "0" * 4999 + "1/7" in re.sub(r"\s+", "", text)


@pytest.mark.parametrize(("zeros", "kept"), [(250, True), (5000, False)])
def test_a_closed_form_too_long_to_read_is_left_to_its_digits(zeros, kept):
    """The JSON has it in full, up to what expectations read."""
    argument = Fraction(3 * 10**zeros + 1, 2 * 10**zeros)
    exponent = Exponent(lower=0.5849625007, upper=0.5849625008, exact=Log(2, argument))
    result = replace(samples.FOUR_POINT, holder=exponent)
    assert "Hölder exponent 0.584962500…" in render([result], Look())
    assert "log2(" not in render([result], Look(verbosity=-1))
    (found,) = json.loads(render_json([result], Look()))["results"]
    assert found["holder"]["exact"] == (f"log2(3{'0' * (zeros - 1)}1/2{'0' * zeros})" if kept else None)


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
    said = replace(
        samples.DIVERGENT.findings[0], code="SD201", statement="S does not converge uniformly: a(1) = 3", why="a(1) = 3"
    )
    text = render([replace(samples.DIVERGENT, findings=(said,))], Look())
    assert text.splitlines()[0] == "✗ halved Chaikin: does not converge: a(1) = 3"


@pytest.mark.parametrize(
    ("exponent", "shown"),
    [
        (Exponent(lower=-2.0, upper=0.5), "-2 .. 0.5"),
        (Exponent(lower=-2.0, upper=0.0), "-2 .. 0 (φ is not continuous)"),
        (Exponent(lower=0.0, upper=0.0, exact=Fraction(0)), "0 (φ is not continuous)"),
        (Exponent(lower=-2.0, upper=-1.0), "-2 .. -1, distributional"),
    ],
)
def test_an_exponent_that_is_not_positive_says_what_that_means(exponent, shown):
    line = render([replace(samples.DIVERGENT, holder=exponent)] * 2, Look(width=120)).splitlines()[2]
    assert line.endswith(f"  {shown}")


def test_the_bound_of_an_exponent_is_below_two_where_it_is():
    below = replace(samples.FOUR_POINT, holder=Exponent(lower=1.654, upper=1.999871))
    lines = render([below], Look(width=200)).splitlines()
    assert lines[0].endswith("Hölder exponent 1.653 .. 1.9999")
    assert next(line for line in lines if "Hölder, upper" in line).split()[4:6] == ["≤", "1.9999:"]


def test_smoothness_of_phi_where_the_scheme_diverges():
    phi = replace(samples.FOUR_POINT, convergent=Verdict.REFUTED, smoothness=UNKNOWN)
    row = next(line for line in render([phi], Look()).splitlines() if line.startswith("  smoothness"))
    assert "φ: C^1: ‖((1/2)S_2)^2‖∞ = 3/4 < 1" in row
    assert "; φ is C^1, not C^2; Hölder " in render([phi], Look()).splitlines()[-1]


def test_a_scheme_without_limits_has_no_smoothness_to_find():
    wrong = samples.judged("smoothness", "2", 2, Verdict.REFUTED, 2)
    text = render([replace(samples.DIVERGENT, expectations=(wrong,))], Look(verbosity=-1))
    assert "expected smoothness = 2: ✗ refuted, found not convergent\n" in text


def test_undecided_is_not_found_undecided():
    asked = samples.judged("convergent", "true", True, Verdict.UNDECIDED)
    unknown = replace(samples.UNDECIDED, convergent=Verdict.UNDECIDED, expectations=(asked,))
    assert "  expected convergent = true: ? undecided\n" in render([unknown], Look(verbosity=-1))
    assert "found" not in render([unknown], Look())


def test_the_table_has_reasons_and_codes_and_the_findings_their_sources():
    table, findings = render([samples.FOUR_POINT], Look(verbosity=1)).split("\n  expected")
    assert re.search(r"^  smoothness +✓ proved +C\^1: ‖\(\(1/2\)S_2\)\^2‖∞ = 3/4 < 1 +SD302$", table, re.MULTILINE)
    assert re.search(
        r"^  C\^2 +○ refuted +C\^2 would need an eigenvalue below 1/4 where .* +SD303$", table, re.MULTILINE
    )
    assert "Theorem" not in table
    assert "Dyn 1992, Theorem 3.4" in findings
    assert render([samples.FOUR_POINT], Look()).split("\n  expected")[0] == table
    assert "Theorem" not in render([samples.FOUR_POINT], Look())


def test_the_last_line_repeats_the_answer():
    def last(**changes):
        return render([replace(samples.FOUR_POINT, **changes)], Look()).splitlines()[-1]

    exact = Exponent(lower=2.0, upper=2.0, exact=Fraction(2), attained=False)
    assert last(holder=exact) == "✓ passed: C^1, not C^2; Hölder 2 (not attained); 2 of 2 expectations proved"
    assert last(holder=None, expectations=()) == "✓ passed: C^1, not C^2; no expectation stated"
    divergent = render([samples.DIVERGENT], Look()).splitlines()[-1]
    assert divergent == "✗ failed: does not converge; 0 of 2 expectations proved, 1 refuted, 1 undecided"
    *_, help, last_line = render([replace(samples.UNDECIDED, holder=None)], Look()).splitlines()
    assert last_line == "? undecided: C^2 at least; 0 of 1 expectation proved, 1 undecided"
    assert help == "  a higher --effort may decide what is undecided"


SHARP = finding(code="SD313", name="attained", verdict=Verdict.REFUTED, statement="not", why="no", source="Rioul 1992")
SERIES = finding(code="SD301", name="contractivity", verdict=Verdict.REFUTED, statement="½S_3 grows", source="Dyn 1992")
UNSTABLE = finding(code="SD402", name="stability", verdict=Verdict.REFUTED, statement="not", why="no", source="Jia")


@pytest.mark.parametrize(
    ("key", "crossed"),
    [(None, []), ("smoothness", ["SD303", "SD301"]), ("holder", ["SD313"]), ("generation", [])],
    ids=str,
)
def test_what_only_makes_a_property_sharp_has_a_neutral_mark(key, crossed):
    """Unless it refutes what is expected; an unstable φ is a cross always."""
    wrong = () if key is None else (samples.judged(key, "3", 3, Verdict.REFUTED, 3),)
    kept = samples.FOUR_POINT.findings[:-1]
    result = replace(samples.FOUR_POINT, findings=(*kept, SHARP, SERIES, UNSTABLE), expectations=wrong)
    text = render([result], Look(verbosity=1))
    signs = {code: sign for sign, code in re.findall(r"^  ([✓✗○]) (?:proved|refuted) +(SD\d+) ", text, re.MULTILINE)}
    assert {code for code, sign in signs.items() if sign == "✗"} == {*crossed, "SD402"}
    assert {code for code, sign in signs.items() if sign == "○"} == {"SD303", "SD301", "SD313"} - {*crossed}


def test_the_marks_of_a_scheme_that_diverges_are_crosses():
    result = replace(samples.FOUR_POINT, convergent=Verdict.REFUTED)
    assert "○" not in render([result], Look(verbosity=1))
    plain = render([samples.FOUR_POINT], Look(unicode=False))
    assert re.search(r"^  C\^2 +o refuted ", plain, re.MULTILINE)


def test_symbols_are_explained_where_they_are_used():
    (phi,) = (line for line in render([samples.FOUR_POINT], Look(width=300)).splitlines() if line.startswith("  (φ"))
    assert phi == (
        "  (φ: the refinable function; S_ν: the scheme of divided differences of order ν; "
        "T_ε: the transition matrices; ρ: the joint spectral radius)"
    )
    why = "T_0 keeps ρ_1 ≥ 1"
    said = replace(samples.DIVERGENT.findings[0], code="SD201", statement=f"S diverges: {why}", why=why)
    for look in (Look(width=300), Look(width=300, verbosity=-1)):
        text = render([replace(samples.DIVERGENT, findings=(said,))], look)
        assert "ρ_k: the joint spectral radius of S on differences of order k)" in text
    assert "joint spectral radius" not in render([samples.DIVERGENT], Look())


def test_of_several_the_failing_ones_say_why_in_a_few_lines():
    wrong = samples.judged("smoothness", "2", 2, Verdict.REFUTED, 2)._replace(line=14)
    low = samples.judged("smoothness", "0", 0, Verdict.REFUTED, 0)
    missed = replace(samples.FOUR_POINT, status="failed", expectations=(*samples.FOUR_POINT.expectations, wrong))
    passed = [samples.FOUR_POINT] * 328
    text = render([*passed, *[missed] * 72], Look())
    assert text.splitlines()[403:408] == [
        "✗ four-point scheme: C^1, not C^2 — convergence proved; Hölder exponent 1.899 .. 2",
        "  masks/scalar/four-point.toml · w = 1/16",
        "  expected smoothness = 2: ✗ refuted, found C^1, not C^2 (line 14)",
        "    C^2 refuted: C^2 would need an eigenvalue below 1/4 where T_0 has 1/4 (SD303)",
        "",
    ]
    assert len(text.splitlines()) == 2 + 400 + 72 * 5 + 4
    smoother = render([samples.FOUR_POINT, replace(missed, expectations=(low,))], Look())
    assert "\n    smoothness: ‖((1/2)S_2)^2‖∞ = 3/4 < 1 (SD302)\n" in smoother
    assert "SD303" not in smoother


def skipped(code, reason):
    answers = tuple((asked, None) for asked in rules()[code].answers)
    return replace(samples.DIVERGENT.findings[1], code=code, reason=reason, answers=answers)


def test_what_is_skipped_for_one_reason_is_one_block():
    no_sums = "S_1 does not exist"
    first, *_ = samples.DIVERGENT.findings
    findings = (first, skipped("SD102", no_sums), skipped("SD202", "of that"), skipped("SD302", no_sums))
    result = replace(samples.DIVERGENT, findings=findings, stable=Verdict.SKIPPED)
    every = ("SD",)
    text = render([result], Look(select=every))
    assert f"\n  – skipped    SD102, SD302: {no_sums}\n\n  – skipped    SD202 contractivity\n" in text
    assert text.count(no_sums) == 2, "in the table and below it"
    in_full = render([result], Look(verbosity=1))
    assert in_full.count(f"because {no_sums}") == 2
    for columns in (30, 59, 60):
        lines = render([result], Look(width=columns, select=every)).splitlines()
        assert max(map(width, lines)) <= columns


def test_a_reason_is_said_once_in_the_table():
    findings = tuple(skipped(code, "no φ") for code in ("SD102", "SD302", "SD402"))
    table = render([replace(samples.DIVERGENT, findings=findings)], Look()).split("\n  expected")[0]
    assert table.count("no φ") == 1
    assert table.count("– skipped") == 3


def series(*verdicts):
    return tuple(
        replace(samples.FOUR_POINT.findings[2], code="SD301", verdict=verdict, statement=f"statement {i}.")
        for i, verdict in enumerate(verdicts)
    )


@pytest.mark.parametrize(
    ("verdicts", "shown", "hidden"),
    [
        ([Verdict.PROVED] * 6, range(6), []),
        ([Verdict.PROVED] * 7, [0, 1, 5, 6], [3]),
        ([Verdict.PROVED] * 5 + [Verdict.REFUTED] * 6, [0, 1, 2, 3, 4, 5, 6, 9, 10], [2]),
        ([Verdict.PROVED] * 6 + [Verdict.REFUTED] * 20, [0, 1, 4, 5, 6, 7, 24, 25], [2, 16]),
    ],
)
def test_a_long_series_shows_its_ends(verdicts, shown, hidden):
    first, *_, last = samples.FOUR_POINT.findings
    result = replace(samples.FOUR_POINT, findings=(first, *series(*verdicts), last))
    text = render([result], Look(select=("SD",)))
    assert [int(i) for i in re.findall(r"statement (\d+)\.", text)] == list(shown)
    assert [int(n) for n in re.findall(r"… (\d+) more; -v shows them", text)] == hidden
    assert first.statement in text
    assert last.statement in text
    assert len(re.findall(r"statement \d+\.", render([result], Look(verbosity=1)))) == len(verdicts)
    in_json = renderer("json")([result], Look())
    assert len(re.findall(r"statement \d+\.", in_json)) == len(verdicts)


def test_quiet_says_what_a_reader_of_the_verdict_must_know():
    hinted = replace(samples.UNDECIDED, hints=("multiply the mask by 2",))
    text = render([hinted, replace(hinted, status="passed")], Look(verbosity=-1))
    assert text.count("  stopped by the budget: another run may find more or less\n") == 1
    assert text.count("  hint: multiply the mask by 2\n") == 1


def test_the_proof_is_named_in_one_piece():
    path = "proofs of mine/" * 20 + "a.json"
    lines = render([replace(samples.FOUR_POINT, certificate=path)], Look(width=40)).splitlines()
    assert lines[-1] == f"proof: {path}"


def test_quiet_is_silent_when_all_passed():
    assert render([samples.FOUR_POINT] * 3, Look(verbosity=-1)) == ""


def test_quiet_leaves_out_what_passed():
    text = render(samples.ALL, Look(verbosity=-1))
    assert "four-point" not in text
    assert "halved Chaikin" in text
    assert "Deslauriers" in text
    assert "Deslauriers" not in render(samples.ALL, Look(verbosity=-1, allow_undecided=True))


def test_several_say_why_some_did_not_pass_and_verbose_shows_all():
    short, full = render(samples.ALL, Look()), render(samples.ALL, Look(verbosity=1))
    assert "no higher power" not in short
    assert "multiply by 2" in short
    assert "Theorem" not in short
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
        text.encode("ascii" if form in FOR_PEOPLE else "utf-8")
        assert form in ("json", "jsonl") or not re.search("[\x00-\x09\x0b-\x1f\x7f]", text)
        renderer(form)(results, Look(width=columns, verbosity=2)).encode("utf-8")


def test_an_escape_sequence_in_a_name_does_not_reach_the_terminal():
    text = render([replace(samples.FOUR_POINT, name="\x1b[2Jboo\u202e")], Look(colour=True))
    assert "\x1b[2J" not in text
    assert r"\x1b[2Jboo\u202e" in text
