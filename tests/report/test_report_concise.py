"""The concise format: a line each, nothing wrapped."""

from dataclasses import replace

import report_samples as samples

from subdiv_cli.model import Result, Verdict
from subdiv_cli.report import renderer
from subdiv_cli.report.look import Look

render = renderer("concise")


def test_lines():
    assert render([samples.DIVERGENT, samples.INVALID], Look(width=10)).splitlines() == [
        "masks/scalar/half.toml: SD101 residue-sums refuted: the residue classes sum to 1/2, 1/2, must be 1 "
        "(normalised to a(1) = 1? multiply by 2)",
        "masks/scalar/half.toml: SD301 contractivity skipped: is (1/2)S_1 contractive? "
        "(S_1 does not exist: the residue sums are not 1)",
        "masks/scalar/half.toml: expected convergent = true: refuted, found not convergent",
        "masks/scalar/half.toml: expected holder in 1.99 .. 2.01: undecided",
        "masks/broken.toml:3:19: error[SD003] fraction not quoted: TOML has no fractions "
        '(write exact coefficients as strings: "-1/16")',
        "masks/broken.toml: error[SD005] the key `name` must be text",
        "2 masks: 1 failed, 1 invalid",
    ]


def test_a_line_per_finding_and_expectation():
    lines = render([samples.FOUR_POINT], Look()).splitlines()
    assert len(lines) == len(samples.FOUR_POINT.findings) + len(samples.FOUR_POINT.expectations)
    assert all(line.startswith("masks/scalar/four-point.toml: ") for line in lines)


def test_quiet():
    assert render([samples.FOUR_POINT], Look(verbosity=-1)) == ""
    assert "four-point" not in render(samples.ALL, Look(verbosity=-1))


def test_quiet_shows_what_did_not_pass_and_nothing_else():
    wrong = samples.judged("smoothness", "3", 3, Verdict.REFUTED, 3)
    right = samples.FOUR_POINT.expectations
    missed = replace(samples.FOUR_POINT, status="failed", expectations=(*right, wrong), hints=("w = 1/20?",))
    bare = replace(samples.FOUR_POINT, status="failed", convergent=Verdict.REFUTED, expectations=(), file="bare.toml")
    results = [samples.FOUR_POINT, missed, bare, samples.UNDECIDED, samples.INVALID]
    assert render(results, Look(verbosity=-1)).splitlines() == [
        "masks/scalar/four-point.toml: expected smoothness = 3: refuted, found C^1, not C^2",
        "masks/scalar/four-point.toml: hint: w = 1/20?",
        "bare.toml: failed: does not converge; φ is C^1, not C^2; Hölder 1.899 .. 2; no expectation stated",
        "masks/scalar/six-point.toml: expected smoothness >= 3: undecided, found C^2 at least",
        "masks/scalar/six-point.toml: stopped by the budget",
        "masks/broken.toml:3:19: error[SD003] fraction not quoted: TOML has no fractions "
        '(write exact coefficients as strings: "-1/16")',
        "masks/broken.toml: error[SD005] the key `name` must be text",
    ]
    assert render([samples.UNDECIDED], Look(verbosity=-1, allow_undecided=True)) == ""


def test_no_result_is_without_a_line():
    bare = Result(file="x.toml", status="undecided", convergent=Verdict.UNDECIDED)
    assert render([bare], Look()) == "x.toml: undecided\n"
