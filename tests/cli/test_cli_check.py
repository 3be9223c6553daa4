"""`subdiv check`, its options, streams and exit codes, against a stand-in for the catalog."""

import json
import os
from fractions import Fraction
from itertools import chain, combinations

import pytest
from cli_samples import PROBLEM, result

from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.model import DEFAULT_EFFORT

DEFAULTS = {
    "overrides": {},
    "work": DEFAULT_EFFORT,
    "seconds": None,
    "debug": False,
    "jobs": len(os.sched_getaffinity(0)),
    "cache": os.environ["SUBDIV_CACHE_DIR"],
    "required": (),
}


def test_what_the_catalog_is_asked_by_default(run, catalog):
    assert run("check", "b", "a", "-").exit_code == 0
    assert catalog.asked == (["b", "a", "-"], DEFAULTS)


def test_what_the_catalog_is_asked(run, catalog, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("check", "a", "--effort", "7", "--budget", "1.5", "--debug").exit_code == 0
    assert catalog.asked == (["a"], {**DEFAULTS, "work": 7, "seconds": 1.5, "debug": True})
    options = ("--jobs", "3", "--no-cache", "--shard", "2/5", "--dask", "tcp://x:1", "--require", "C1", "-o", "r.html")
    assert run("check", "a", *options).exit_code == 0
    asked = catalog.asked[1]
    assert asked.pop("required")[0].text == ">= 1"
    assert asked.pop("sections") is True
    expected = {**DEFAULTS, "jobs": 3, "cache": None, "shard": (2, 5), "cluster": "tcp://x:1"}
    assert asked == {key: value for key, value in expected.items() if key != "required"}


def test_stencils_and_pictures_are_made_only_for_what_shows_them(run, catalog, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for arguments in (["-v"], ["-vv"], ["--format", "html"], ["--format", "json", "-o", "html:page"]):
        assert run("check", "a", *arguments).exit_code == 0
        assert catalog.asked[1]["sections"] is True
    for arguments in ([], ["-q"], ["--format", "concise", "-v"], ["--format", "json", "-vv"]):
        assert run("check", "a", *arguments).exit_code == 0
        assert "sections" not in catalog.asked[1]


@pytest.mark.parametrize(
    "statuses",
    [*chain.from_iterable(combinations(("passed", "failed", "undecided", "invalid"), n) for n in range(1, 5))],
)
def test_exit_code(run, catalog, statuses):
    catalog.results = [result(status) for status in statuses]
    wanted = 2 if "invalid" in statuses else 1 if "failed" in statuses else 3 if "undecided" in statuses else 0
    for form in ("text", "concise", "json"):
        assert run("check", "x", "--format", form).exit_code == wanted
    assert run("check", "x", "--allow-undecided").exit_code == (0 if wanted == 3 else wanted)
    assert run("check", "x", "-q").exit_code == wanted


def test_ctrl_c_reports_what_is_done(run, catalog):
    catalog.results, catalog.error = [result("failed"), result("invalid")], KeyboardInterrupt()
    shown = run("check", "x", "--format", "json")
    assert shown.exit_code == 130
    assert json.loads(shown.stdout)["summary"]["files"] == 2
    assert "interrupted: 2 masks checked" in shown.stderr


def test_an_internal_error_is_not_a_finding(run, catalog):
    catalog.error = ZeroDivisionError("boom")
    shown = run("check", "x")
    assert shown.exit_code == 2
    assert "error[SD099] internal error: ZeroDivisionError: boom" in shown.stderr
    assert "please report" in shown.stderr
    assert "Traceback" not in shown.output
    assert "Traceback" in run("check", "x", "--debug").stderr


def test_errors_of_invalid_masks_are_on_stderr_in_the_text_format(run, catalog):
    catalog.results = [result("passed"), result("invalid")]
    shown = run("check", "x")
    assert f"error[SD003] {PROBLEM.message}" in shown.stderr
    assert "error[" not in shown.stdout
    assert "invalid" in shown.stdout
    for form in ("concise", "json"):
        shown = run("check", "x", "--format", form)
        assert PROBLEM.message in shown.stdout
        assert shown.stderr == ""


@pytest.mark.parametrize(
    ("args", "said"),
    [
        ([], "nothing to check"),
        (["--mask", "1", "a"], "leave out the files"),
        (["a", "--start", "-3"], "--start belongs to --mask"),
        (["a", "--arity", "3"], "--arity belongs to --mask"),
        (["a", "-q", "-v"], "contradict"),
        (["a", "--effort", "0"], "'0' is not a positive whole number"),
        (["a", "--effort", "-3"], "'-3' is not a positive whole number"),
        (["a", "--effort", "abc"], "'abc' is not a positive whole number"),
        (["a", "--effort", "1.5"], "'1.5' is not a positive whole number"),
        (["a", "--budget", "abc"], "'abc' is not a positive number of seconds"),
        (["a", "--budget", "0"], "positive"),
        (["a", "--budget", "-1"], "positive"),
        (["a", "--budget", "nan"], "positive"),
        (["a", "--budget", "inf"], "positive"),
        (["a", "--format", "xml"], "xml"),
        (["a", "-o", "json:"], "names no file"),
        (["a", "-o", "foo:r.q"], "no format 'foo'; there are text, concise, json, jsonl, junit"),
        (["a", "-o", "JSON:r.json"], "no format 'JSON'; there are text, concise, json, jsonl, junit"),
        (["a", "-o", "r.yaml"], "no format .yaml; there are text, concise, json, jsonl, junit"),
        (["a", "-o", "r.PDF"], "no format .pdf; there are text, concise, json"),
        (["a", "-o", "r.csv"], "-o text:r.csv"),
        (["a", "-o", "-"], "names no file"),
        (["a", "-o", "/no/such/place/x.json"], "no directory"),
        (["a", "-o", "/"], "is a directory"),
        (["a", "--nonsense"], "--nonsense"),
    ],
)
def test_usage_errors(run, catalog, args, said):
    shown = run("check", *args)
    assert shown.exit_code == 2
    assert said in shown.stderr
    assert shown.stdout == ""
    assert catalog.asked is None


def test_an_unknown_command_has_a_near_name(run):
    shown = run("chek")
    assert shown.exit_code == 2
    assert "did you mean 'check'?" in shown.stderr


def test_a_file_without_a_command(run, catalog, tmp_path):
    for name in ("four-point.toml", "no such file.toml", str(tmp_path)):
        shown = run(name)
        assert shown.exit_code == 2
        quoted = f"'{name}'" if " " in name else name
        assert f"did you mean `subdiv check {quoted}`?" in shown.stderr
    assert catalog.asked is None


def test_parameters(run, catalog):
    assert run("check", "a", "-p", "w=-1/20", "-p", "v=2", "-p", "v=2").exit_code == 0
    assert catalog.asked[1]["overrides"] == {"w": (Fraction(-1, 20),), "v": (Fraction(2),)}
    assert run("check", "a", "-p", "w=1", "-p", "w=2", "-p", "w=2/2").exit_code == 0
    assert catalog.asked[1]["overrides"] == {"w": (Fraction(1), Fraction(2))}


def test_bad_parameters(run, catalog):
    shown = run("check", "a", "-p", "w", "-p", "v")
    assert shown.exit_code == 2
    assert shown.stderr.count("error[SD011]") == 2
    assert catalog.asked is None


def test_mask_from_the_command_line(run, catalog):
    assert run("check", "--mask", "[-1,2]", "--start", "-3", "--arity", "3").exit_code == 0
    (mask,) = catalog.asked[0]
    assert mask.scheme() == ScalarScheme(arity=3, start=-3, coefficients=(Fraction(-1), Fraction(2)))
    assert run("check", "--mask", "1+z").exit_code == 0
    (mask,) = catalog.asked[0]
    assert mask.scheme() == ScalarScheme(arity=2, start=0, coefficients=(Fraction(1), Fraction(1)))


def test_a_mask_from_the_command_line_may_use_the_names_of_p(run, catalog):
    assert run("check", "--mask", "[-w,0,1/2+w,1,1/2+w,0,-w]", "-p", "w=1/16").exit_code == 0
    (mask,), overrides = catalog.asked[0], catalog.asked[1]["overrides"]
    assert overrides == {"w": (Fraction(1, 16),)}
    assert mask.scheme({"w": Fraction(1, 16)}).coefficients[0] == Fraction(-1, 16)
    assert run("check", "--mask", "[w]", "-p", "v=1/16").exit_code == 2


def test_a_bad_mask_is_an_invalid_result(run, catalog):
    shown = run("check", "--mask", "[1, sqrt(3)]", "--format", "json")
    assert shown.exit_code == 2
    report = json.loads(shown.stdout)["results"][0]
    assert (report["file"], report["status"], report["errors"][0]["code"]) == ("--mask", "invalid", "SD008")
    assert catalog.asked is None


def test_verbosity(run, catalog):
    catalog.results = [result("passed"), result("passed")]
    assert "½S_1" not in run("check", "x").stdout
    assert "½S_1" in run("check", "x", "-v").stdout
    assert run("check", "x", "-q").output == ""


def test_outputs(run, catalog, tmp_path):
    catalog.results = [result("failed")]
    names = ("a.json", "b.json", "c.txt", "d.log", "e", "f.yaml")
    one, two, three, four, five, six = (tmp_path / name for name in names)
    shown = run(
        *("check", "x", "--format", "concise"),
        *("-o", str(one), "-o", f"concise:{two}", "-o", str(three), "-o", str(four), "-o", str(five)),
        *("-o", f"text:{six}"),
    )
    assert shown.exit_code == 1
    assert json.loads(one.read_text("utf-8"))["format"] == "subdiv-report"
    assert {path.read_text("utf-8") for path in (two, three, four, five)} == {shown.stdout}
    assert "✗ the failed mask" in six.read_text("utf-8")
    assert sorted(path.name for path in tmp_path.iterdir()) == list(names)


def test_a_file_may_have_a_colon_in_its_name(run, catalog, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("check", "x", "-o", "./foo:r", "-o", "c:r").exit_code == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["c:r", "foo:r"]


def test_a_text_file_has_the_errors_of_invalid_masks(run, catalog, tmp_path):
    catalog.results = [result("invalid")]
    run("check", "x", "-o", str(tmp_path / "r.txt"))
    assert "error[SD003]" in (tmp_path / "r.txt").read_text("utf-8")


def test_a_file_that_cannot_be_written_in_the_end(run, catalog, tmp_path, monkeypatch):
    def full(file, text):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("subdiv_cli.catalog.files.write_whole", full)
    shown = run("check", "x", "-o", str(tmp_path / "r.json"))
    assert shown.exit_code == 2
    assert "r.json cannot be written: No space left on device" in shown.stderr
    assert "converg" in shown.stdout
