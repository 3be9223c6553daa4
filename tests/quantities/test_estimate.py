"""Exponents in figures: certain digits of exact ones, and estimates that say they are estimates."""

from __future__ import annotations

import json
import math
import subprocess
import sys

import pytest
from click.testing import CliRunner
from mpmath import mp
from support import answer, four_point, scheme

from subdiv_cli.cli import main
from subdiv_cli.kinds.scalar.numbers.estimate import extrapolated_exponent
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.model import Effort

HARD = [-1, 9, 6, -3, 1, 9, -3, 1, 4]


def hard():
    """A cofactor for which a small effort gives bounds only."""
    mask = [2 * c for c in HARD]
    for _ in range(3):
        mask = [a + b for a, b in zip([0, *mask], [*mask, 0], strict=True)]
    return scheme(mask, over=8 * sum(HARD))


@pytest.mark.parametrize(
    ("mask", "exact"),
    [
        (four_point("1/10"), None),
        (four_point("1/32"), -math.log2((2 + math.sqrt(2)) / 8)),
        (scheme([1, 3, 3, 1], over=4), 2.0),
    ],
)
def test_norms_extrapolate_to_the_exponent(mask, exact):
    numbers = ScalarNumbers(mask, Effort())
    found = extrapolated_exponent(numbers.difference(numbers.order), 2, len(numbers.product.word), Effort())
    assert found is not None
    value, places = found
    truth = answer(mask).holder
    assert abs(value - truth.lower) <= 2 * 10.0**-places
    assert exact is None or truth.lower == pytest.approx(exact, abs=1e-12)


def test_an_estimate_stands_beside_bounds_and_nothing_exact():
    holder, better = answer(hard(), 80).holder, answer(hard()).holder
    assert holder.exact is None
    assert holder.digits is None
    assert holder.upper - holder.lower > 0.01
    places = len(holder.estimate.partition(".")[2])
    assert abs(float(holder.estimate) - better.lower) <= 2 * 10.0**-places
    assert better.estimate is None


def test_exact_exponents_have_many_digits():
    """A second route: the root of 2048 x² - 40 x - 1 in the arithmetic of mpmath."""
    result = answer(four_point("1/16"))
    assert result.holder.digits is None
    with mp.workdps(60):
        truth = mp.nstr(-mp.log((40 + mp.sqrt(9792)) / 4096, 2) / 2, 50)
    assert truth.startswith(result.sobolev.digits.rstrip("…"))
    assert len(result.sobolev.digits) == 43


def run(*arguments):
    return CliRunner().invoke(main, [*arguments]).stdout


def test_where_they_are_shown():
    mask = ["check", "--mask", str([f"{c}" for c in hard().coefficients]).replace("'", ""), "--effort", "80"]
    text = " ".join(run(*mask).split())
    assert "extrapolated from norms: an estimate, which proves nothing" in text
    holder = json.loads(run(*mask, "--format", "json"))["results"][0]["holder"]
    assert holder["exact"] is None
    assert float(holder["estimate"])
    six = ["--mask", "[3, 0, -25, 0, 150, 256, 150, 0, -25, 0, 3]/256"]
    assert "Hölder exponent 2.8300749985576876370925221121043669824803…" in run("check", *six, "-v")
    assert "2.83007499855768763709252211210" not in run("check", *six)
    assert "2.8300749985576876370925221121043669824803…" in run("show", *six)
    exponents = json.loads(run("check", *six, "--format", "json"))["results"][0]
    assert exponents["holder"]["digits"] == "2.8300749985576876370925221121043669824803…"
    assert exponents["sobolev"]["digits"].startswith("3.1751315")


def test_mpmath_is_loaded_for_estimates_only():
    code = (
        "import sys\nfrom subdiv_cli.cli import main\n"
        "try: main(['check', '--mask', '[-1, 0, 6, 10, 6, 0, -1]/10', '--format', 'concise'])\n"
        "except SystemExit: pass\nprint('mpmath' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == "False"
