"""Facts of masks, and hints for what people paste."""

from fractions import Fraction

import pytest
from support import b_spline, four_point, scheme

from subdiv_cli.kinds.kind import Facts
from subdiv_cli.kinds.scalar.numbers.facts import facts, hints
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.sum_rules import residue_sums
from subdiv_cli.model import Effort


def test_facts_of_the_four_point_scheme():
    assert facts(four_point("1/16")) == {
        "arity": 2,
        "support": (-3, 3),
        "coefficients": 5,
        "symmetry": "symmetric",
        "centre": 0,
        "type": "primal",
        "interpolatory": True,
        "nonnegative": False,
        "gaps": (-2, 2),
        "spacing": 1,
    }


def test_symmetries_and_types():
    assert facts(b_spline(2))["type"] == "dual"
    assert facts(scheme([1, 2, -2, -1]))["symmetry"] == "antisymmetric"
    lopsided = facts(scheme(["1/4", "2/3", "3/4", "1/3"]))
    assert (lopsided["symmetry"], lopsided["centre"], lopsided["type"]) == (None, None, None)
    assert facts(scheme([1, 0, 0, 2, 0, 0, 1], over=2))["spacing"] == 3
    assert facts(scheme([2]))["spacing"] == 0


_CDF_9_7 = [
    "-0.091271763114", "-0.057543526229", "0.591271763114", "1.11508705", "0.591271763114", "-0.057543526229",
    "-0.091271763114",
]  # fmt: skip
"""Irrational numbers: no simple fraction has these decimals."""


@pytest.mark.parametrize(
    ("coefficients", "fragments"),
    [
        (["1/8", "3/8", "3/8", "1/8"], ["a(1) = 1?", "by 2."]),
        ([1, 3, 3, 1], ["a(1) = 8?", "by 1/4."]),
        (["0.4829629131", "0.8365163037", "0.2241438680", "-0.1294095226"], ["√2"]),
        (["0.1667", "0.5", "0.6667", "0.5", "0.1667"], ["cut decimals?", '0.1667 for "1/6"', '0.6667 for "2/3"']),
        (["0.333333", "0.666667", "0.666667", "0.333333"], ["cut decimals?", 'close to "1/3"']),
        (["0.333", "0.667", "0.667", "0.333"], ["cut decimals?", 'close to "1/3"']),
        (["1/9", "1/3", "2/3", "7/9", "2/3", "1/3", "1/9"], ["arity = 3 under [mask]?"]),
        (["-0.0625", 0, "0.5625", 1, "0.5625", 0, "-0.0625"], ["interpolatory with start = -3"]),
    ],
)
def test_hints(coefficients, fragments):
    (hint,) = hints(scheme(coefficients))
    for fragment in fragments:
        assert fragment in hint


@pytest.mark.parametrize(
    "mask",
    [
        four_point("1/16"),
        b_spline(3),
        b_spline(2, 3),
        scheme([1, 1]),
        scheme(["0.546", "0.454", "0.454", "0.546"]),
        scheme(["0.125", "0.375", "0.375", "0.125"], over=Fraction(1, 2)),
    ],
)
def test_no_hint_for_a_good_mask(mask):
    assert hints(mask) == ()


def test_sums_that_are_nearly_one_say_how_far_off_they_are():
    (finding,) = residue_sums(ScalarNumbers(scheme(_CDF_9_7), Effort()), Facts())
    assert finding.statement.endswith("Σ a_(0+2β) = 1, Σ a_(1+2β) = 1 - 2.458…e-9")
