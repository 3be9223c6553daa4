"""JSON version 1 is a contract: the keys of DESIGN section 6, in that order, with additions at the end only."""

import json
import os
from dataclasses import replace
from fractions import Fraction
from math import inf, nan
from pathlib import Path

import report_samples as samples

import subdiv_cli
from subdiv_cli.model import Exponent, Interval, Log, Result
from subdiv_cli.report import renderer
from subdiv_cli.report.json import plain
from subdiv_cli.report.look import Look

render = renderer("json")

KEYS = {
    "": ["format", "version", "tool", "summary", "results"],
    "tool": ["name", "version"],
    "summary": ["files", "passed", "failed", "undecided", "invalid"],
    "results": [
        *("file", "name", "kind", "parameters", "status", "stopped", "errors", "facts", "sum_rule_order"),
        *("convergent", "smoothness", "holder", "sobolev", "stable", "linearly_independent"),
        *("generation", "reproduction", "dimension", "well_defined", "polynomials", "spectral", "holder_at_zero"),
        *("expectations", "findings", "certificate", "reference", "refinable_function", "hints", "derivatives"),
        "regressions",
    ],
    "errors": ["code", "message", "key", "line", "column", "help"],
    "convergent": ["verdict"],
    "smoothness": ["order", "sharp"],
    "refinable_function": ["order", "sharp"],
    "holder": ["lower", "upper", "exact", "attained", "estimate", "digits"],
    "sobolev": ["lower", "upper", "exact", "digits"],
    "stable": ["verdict"],
    "well_defined": ["verdict"],
    "linearly_independent": ["verdict"],
    "spectral": ["verdict"],
    "expectations": ["key", "expected", "verdict", "found", "line"],
    "findings": ["code", "name", "verdict", "statement", "value", "source", "reason", "why", "witness", "claims"],
    "value": ["exact", "lower", "upper"],
}
FREE = {"parameters", "facts", "witness"}
FULL = replace(samples.FOUR_POINT, sobolev=Exponent(lower=2.44, upper=2.45), problems=samples.INVALID.problems)


def report(*results):
    return json.loads(render(results, Look()))


def keys(value, at=""):
    """Every object of the report that is not free-form, as (where, its keys)."""
    if isinstance(value, dict):
        if at in FREE:
            return
        yield at, list(value)
        for key, item in value.items():
            yield from keys(item, key)
    elif isinstance(value, list):
        for item in value:
            yield from keys(item, at)


def test_key_order():
    seen = set()
    for where, found in keys(report(FULL, *samples.ALL)):
        assert found == KEYS[where], where
        seen.add(where)
    assert seen == set(KEYS)


def test_golden():
    path = Path(__file__).with_name("golden") / "report.json"
    text = render(samples.ALL, Look()).replace(subdiv_cli.__version__, "VERSION")
    if os.environ.get("UPDATE_GOLDEN"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8")


def test_the_look_changes_nothing():
    assert render(samples.ALL, Look()) == render(
        samples.ALL, Look(width=20, unicode=False, colour=True, verbosity=-1, allow_undecided=True)
    )


def test_an_empty_result_has_every_key():
    bare = report(Result(file="x", status="invalid"))["results"][0]
    assert bare["holder"] is None
    assert bare["sobolev"] is None
    assert bare["convergent"] == {"verdict": "skipped"}
    assert bare["smoothness"] == {"order": None, "sharp": False}
    assert bare["certificate"] is None
    assert list(bare) == KEYS["results"]


def test_what_was_found_of_an_expectation():
    shown = [(e["key"], e["found"]) for r in report(*samples.ALL)["results"] for e in r["expectations"]]
    assert shown == [
        ("convergent", "converges"), ("smoothness", "C^1, not C^2"), ("convergent", "not convergent"), ("holder", None),
        ("smoothness", "C^2 at least"),
    ]  # fmt: skip


def test_summary():
    assert report(*samples.ALL, samples.INVALID)["summary"] == {
        "files": 5, "passed": 1, "failed": 1, "undecided": 1, "invalid": 2,
    }  # fmt: skip


def test_exact_data():
    data = {"a": Fraction(-1, 16), "b": (Fraction(2), 3, None, True), "c": {"d": "x"}, "e": 10**5000}
    assert plain(data) == {"a": "-1/16", "b": ["2", 3, None, True], "c": {"d": "x"}, "e": "1" + "0" * 5000}


def test_only_finite_numbers():
    odd = replace(samples.FOUR_POINT, holder=Exponent(lower=-inf, upper=nan, exact=Log(base=2, argument=Fraction(3))))
    nothing = dict.fromkeys(("lower", "upper", "attained", "estimate", "digits"))
    assert report(odd)["results"][0]["holder"] == {**nothing, "exact": "log2(3)"}
    finding = replace(samples.FOUR_POINT.findings[0], value=Interval(upper=inf))
    shown = report(replace(samples.FOUR_POINT, findings=(finding,)))["results"][0]["findings"][0]
    assert shown["value"] == {"exact": None, "lower": None, "upper": None}


def test_doubles_come_back_as_they_were():
    value = 1.9999999999999998
    assert report(replace(FULL, holder=Exponent(lower=value)))["results"][0]["holder"]["lower"] == value


def test_letters_stay_letters_and_a_file_name_that_is_not_utf8_can_be_written():
    text = render([replace(samples.FOUR_POINT, name="φ½", file="b\udcffd.toml")], Look())
    assert '"φ½"' in text
    assert json.loads(text.encode("utf-8"))["results"][0]["file"] == "b\udcffd.toml"
    assert text.endswith("}\n")
