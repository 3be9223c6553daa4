"""Masks and matrices with very long numbers: they keep their certificate, and nothing refuses to print them."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from itertools import pairwise

import pytest
from click.testing import CliRunner
from support import four_point, scheme, six_point

from subdiv_cli.checker import check_document
from subdiv_cli.cli import main
from subdiv_cli.model import Effort
from subdiv_cli.pipeline import check, joint_spectral_radius


def long_number(rng, digits):
    return rng.randrange(10 ** (digits - 1), 10**digits)


def near(x, digits, rng):
    """A rational near x with a denominator of so many digits."""
    q = long_number(rng, digits)
    return Fraction(round(x * q) + 1, q)


def cofactor_mask(length, digits, rng):
    q = [Fraction(rng.randrange(-(10**digits), 3 * 10**digits)) for _ in range(length)]
    mask = [2 * x / sum(q) for x in q]
    for _ in range(3):
        mask = [(a + b) / 2 for a, b in pairwise([Fraction(0), *mask, Fraction(0)])]
    return scheme(mask)


def test_ties_over_many_depths_are_within_the_bounds_of_the_checker():
    """Their weights have denominators of 300,000 bits together, and 10,000 over a common one."""
    assert check(six_point(Fraction(117, 4000)), (), Effort()).document is not None


@pytest.mark.parametrize("digits", [30, 100, 300])
def test_masks_with_long_numbers_keep_their_certificate(digits):
    rng = random.Random(digits)
    masks = [four_point(near(Fraction(1, 10), digits, rng)), six_point(near(Fraction(1, 64), digits, rng))]
    for mask in (*masks, cofactor_mask(5, digits, rng), cofactor_mask(8, digits, rng)):
        document = check(mask, (), Effort(2000)).document
        outcome = check_document(json.loads(json.dumps(document)))
        assert outcome.verified, outcome.line
        assert len(outcome.line) < 10_000


@pytest.mark.parametrize(("digits", "order"), [(400, 4), (950, 2), (950, 4), (3000, 2)])
def test_families_with_long_numbers(digits, order):
    """With a certificate or, where it would ask too much of the checker, no bound: never an internal error."""
    rng = random.Random(digits)
    signs = [1, -1] if digits == 400 else [1]

    def entry():
        return Fraction(rng.choice(signs) * long_number(rng, digits), long_number(rng, digits))

    family = [[[entry() for _ in range(order)] for _ in range(order)] for _ in range(2)]
    checked = joint_spectral_radius(family, Effort(500))
    assert (checked.radius.upper is None) == (checked.document is None)
    assert checked.document is not None or digits * order >= 3000
    assert checked.document is None or check_document(checked.document).line.startswith("VERIFIED")


@pytest.mark.parametrize("format_", ["text", "json"])
def test_reports_of_long_numbers(tmp_path, format_):
    rng = random.Random(1)
    file = tmp_path / "long.toml"
    file.write_text(f'matrices = [[["{long_number(rng, 950)}/{long_number(rng, 949)}"]], [["1/2"]]]\n')
    run = CliRunner().invoke(main, ["jsr", str(file), "--format", format_])
    assert run.exit_code == 0
    if format_ == "text":
        assert "a long fraction = 21.95464363" in run.stdout
    else:
        assert len(json.loads(run.stdout)["exact"]) > 1800
