"""`subdiv smooth` as a user runs it: the new mask file, what is said of both masks, exit codes, bad input."""

import re

import pytest
from support import subdiv

from subdiv_cli.catalog import masks_directory
from subdiv_cli.kinds.reading import read_path, read_text
from subdiv_cli.model import Verdict
from subdiv_cli.pipeline import Checked

MASKS = masks_directory()
FOUR = MASKS / "scalar" / "four_point.toml"
KNOTS = MASKS / "vector" / "double_knot_cubic.toml"


def test_the_new_mask_and_what_is_said():
    run = subdiv("smooth", FOUR)
    assert run.returncode == 0
    assert (
        run.stdout
        == """\
# Made of four-point scheme, w = 1/16 by subdiv smooth.
# 1. the smoothing factor of Dyn, Levin 2002, section 4: times (1+z)/2
format = 1
name = "four-point scheme, w = 1/16, smoothed"
reference = "the smoothing factor of Dyn, Levin 2002, section 4; from: Dubuc 1986; Dyn, Gregory, Levin 1987"
kind = "scalar"

[mask]
arity = 2
start = -4
coefficients = ["-1/32", "-1/32", "9/32", "25/32", "25/32", "9/32", "-1/32", "-1/32"]

[expect]
convergent = true
smoothness = 2
holder = "3"
"""
    )
    assert run.stderr.splitlines() == [
        "  four-point scheme, w = 1/16: C^1, not C^2 — convergence proved; Hölder exponent 2, not attained; "
        "support -3 … 3",
        "✓ smoothed: C^2, not C^3 — convergence proved; Hölder exponent 3, not attained; support -4 … 3",
    ]
    assert read_text(run.stdout, file="a.toml").scheme() == read_path(FOUR.with_stem("four_point_smoothed")).scheme()


@pytest.mark.parametrize(
    ("source", "times", "target"),
    [
        ("scalar/four_point", 1, "scalar/four_point_smoothed"),
        ("scalar/bspline_ternary_degree_1", 2, None),
        ("vector/double_knot_cubic", 1, "vector/double_knot_cubic_smoothed"),
        ("vector/double_knot_cubic", 2, "vector/double_knot_cubic_smoothed_twice"),
        ("vector/dghm", 3, None),
        ("hermite/hermite_cubic", 1, "hermite/hermite_cubic_smoothed"),
        ("hermite/de_rham_cubic", 1, "hermite/de_rham_cubic_smoothed"),
        ("hermite/ternary_hermite_cubic", 2, None),
    ],
)
def test_a_file_that_check_passes(tmp_path, source, times, target):
    """It has the coefficients of the shipped one, and every expectation in it is proved."""
    out = tmp_path / "new.toml"
    run = subdiv("smooth", MASKS / f"{source}.toml", "-n", times, "-o", out)
    assert (run.returncode, run.stdout) == (0, "")
    new = read_path(out)
    assert new.name.endswith(", smoothed" + {1: "", 2: " twice", 3: " 3 times"}[times])
    assert len(re.findall(r"^# \d\.", out.read_text("utf-8"), re.MULTILINE)) == times
    if target is not None:
        shipped = read_path(MASKS / f"{target}.toml")
        assert new.scheme() == shipped.scheme()
        same = {e.key: e.lower for e in shipped.expectations}
        assert {e.key: e.lower for e in new.expectations}.items() <= same.items()
    jets = ["spectral"] if new.kind == "hermite" else []
    assert [e.key for e in new.expectations] == ["convergent", "smoothness", "holder", *jets]
    assert subdiv("check", out, "--no-cache").returncode == 0


def test_parameters_are_put_in():
    run = subdiv("smooth", FOUR, "-p", "w=1/20", "--inverse")
    assert run.returncode == 0
    new = read_text(run.stdout, file="new.toml")
    assert new.name == "four-point scheme, w = 1/20, derived"
    assert (new.parameters, new.scheme().start) == ({}, -2)
    several = subdiv("smooth", FOUR, "-p", "w=1/20", "-p", "w=1/16")
    assert (several.returncode, several.stdout) == (2, "")
    assert "takes one mask" in several.stderr


def test_the_derived_scheme_may_diverge():
    """S_2 of the four-point scheme does: it is written, held to that, and smoothing leads back."""
    run = subdiv("smooth", FOUR, "--inverse", "-n", 2)
    assert run.returncode == 0
    assert "✗ derived twice: does not converge" in run.stderr
    assert 'convergent = false\nholder = "0"\n' in run.stdout
    back = subdiv("smooth", "-", "-n", 2, stdin=run.stdout)
    assert back.returncode == 0
    assert read_text(back.stdout, file="a.toml").scheme() == read_path(FOUR).scheme()


def test_the_taylor_scheme_is_a_vector_mask():
    run = subdiv("smooth", MASKS / "hermite" / "hermite_quintic.toml", "--inverse")
    assert run.returncode == 0
    assert "# 1. the Taylor scheme of Moosmüller, Dyn 2018, section 5: φ = 0\n" in run.stdout
    assert 'kind = "vector"\n' in run.stdout
    assert 'convergent = true\nsmoothness = 0\nholder = "1"\n' in run.stdout
    assert subdiv("check", "-", stdin=run.stdout).returncode == 0


def test_a_mask_from_the_command_line_and_back_through_a_pipe():
    run = subdiv("smooth", "--mask", "[1, 2, 1]/2", "--start", -1, "-n", 2)
    assert 'name = "[1, 2, 1]/2, smoothed twice"' in run.stdout
    assert 'reference = "the smoothing factor of Dyn, Levin 2002, section 4"' in run.stdout
    assert 'coefficients = ["1/8", "1/2", "3/4", "1/2", "1/8"]' in run.stdout
    assert subdiv("check", "-", stdin=run.stdout).returncode == 0


@pytest.mark.parametrize(
    ("arguments", "why"),
    [
        (["--mask", "[1, 1, 1]/2"], "not smoothed: the coefficients sum to 3/2, which must be 2, the arity"),
        (
            [FOUR, "--inverse", "-n", 9],
            "there is no derived scheme: in step 5 the sums over the residue classes are 4, -2",
        ),
        (
            [MASKS / "vector/counterexamples/no_constants.toml"],
            "not smoothed: E_A = 0: no constant vector is reproduced",
        ),
        ([MASKS / "vector/counterexamples/not_semisimple.toml"], "not smoothed: the eigenvalue 1 of M_A"),
        (
            [MASKS / "hermite/hermite_septic.toml"],
            "not smoothed: procedure 40 is for a function with its first derivative",
        ),
        (
            [MASKS / "hermite/unseen_linear.toml", "--inverse"],
            "there is no derived scheme: the spectral condition fails",
        ),
        (["--mask", "[2, 0, 0, 0, -1, 1]"], "smoothed, not written: does not converge"),
    ],
)
def test_what_is_impossible(tmp_path, arguments, why):
    out = tmp_path / "new.toml"
    run = subdiv("smooth", *arguments, "-o", out)
    assert (run.returncode, run.stdout) == (1, "")
    assert run.stderr.splitlines()[-1].startswith("✗ ")
    assert why in run.stderr
    assert not out.exists()


def test_what_is_not_decided(tmp_path, monkeypatch):
    """A mask whose convergence is open is written, held to nothing, and the exit code says so."""
    from dataclasses import replace

    from subdiv_cli import pipeline

    def undecided(scheme, expectations, effort, check=pipeline.check):
        result = check(scheme, expectations, effort).result
        return Checked(
            replace(result, convergent=Verdict.UNDECIDED, smoothness=type(result.smoothness)(), holder=None), None
        )

    monkeypatch.setattr(pipeline, "check", undecided)
    out = tmp_path / "new.toml"
    run = subdiv("smooth", FOUR, "-o", out)
    assert run.returncode == 3
    assert "? smoothed: convergence undecided" in run.stderr
    assert "[expect]" not in out.read_text("utf-8")
    assert read_path(out).scheme() == read_path(FOUR.with_stem("four_point_smoothed")).scheme()


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        ([], "name a mask: a FILE or --mask, and not both"),
        (["nowhere.toml"], "error[SD002]"),
        ([MASKS / "multivariate/loop.toml"], "masks of kind multivariate cannot be smoothed yet"),
        ([MASKS / "matrices/koch.toml"], "masks of kind matrices cannot be smoothed yet"),
        (["--mask", "(1+z1)(1+z2)"], "masks of kind multivariate cannot be smoothed yet"),
        ([FOUR, "-n", 0], "Invalid value for '-n'"),
        ([FOUR, "-n", 65], "Invalid value for '-n'"),
        ([FOUR, "-n", "x"], "Invalid value for '-n'"),
        ([FOUR, "-o", "nowhere/new.toml"], "cannot be written: there is no directory"),
        (["-"], "error[SD"),
    ],
)
def test_bad_input(arguments, what):
    run = subdiv("smooth", *arguments, stdin="kind = 7\n")
    assert (run.returncode, run.stdout) == (2, "")
    assert what in run.stderr
    assert "Traceback" not in run.stderr


def test_a_mask_is_not_overwritten(tmp_path):
    mask = tmp_path / "mask.toml"
    mask.write_bytes(FOUR.read_bytes())
    run = subdiv("smooth", mask, "-o", mask)
    assert (run.returncode, run.stdout) == (2, "")
    assert "cannot be written: it exists; a mask is not overwritten" in run.stderr.replace("\n", " ")
    assert mask.read_bytes() == FOUR.read_bytes()


def test_a_result_that_is_too_large_for_a_mask_file():
    coefficients = ["1", *["0"] * 1997, "1"]
    run = subdiv("smooth", "--mask", f"[{','.join(coefficients)}]", "-n", 20)
    assert (run.returncode, run.stdout) == (2, "")
    assert "error[SD010]" in run.stderr
    assert "the limit is 2000" in run.stderr


def test_names_that_could_move_a_cursor(tmp_path):
    file = tmp_path / "name.toml"
    file.write_text('name = "a\\nb\\u001b[2J\\"c"\n[mask]\ncoefficients = [1, 1]\n', "utf-8")
    run = subdiv("smooth", file)
    assert run.returncode == 0
    assert "\x1b" not in run.output
    assert read_text(run.stdout, file="a.toml").name == 'a\nb\x1b[2J"c, smoothed'
    assert all(line.startswith("# ") for line in run.stdout.splitlines()[:2])


def test_the_same_bytes_each_time():
    assert subdiv("smooth", KNOTS, "-n", 2).stdout_bytes == subdiv("smooth", KNOTS, "-n", 2).stdout_bytes
