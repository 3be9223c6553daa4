"""Published and recomputed values: every scalar row of the reference data, against the pipeline."""

import json
from fractions import Fraction
from pathlib import Path

import pytest
from support import answer, scheme

from subdiv_cli.model import Verdict

ROWS = json.loads((Path(__file__).parent / "data" / "reference_scalar.json").read_text(encoding="utf-8"))


def is_true(verdict):
    return {Verdict.PROVED: True, Verdict.REFUTED: False}.get(verdict)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
def test_reference_row(row):
    result = answer(scheme(row["coefficients"], start=row["start"], arity=row["arity"]))
    truth = row["truth"]
    assert is_true(result.convergent) is truth["converges"]
    assert is_true(result.stable) is truth["stable"]
    assert result.sum_rule_order == truth["sum_rule_order"]
    assert result.generation == truth["generation"]
    assert result.reproduction == truth["reproduction"]
    assert_smoothness(row["id"], result, truth["smoothness"])
    assert_holder(result, truth["holder_of_limits"])
    assert_sobolev(result, truth["sobolev_of_limits"])


PROVED_BY_NORMS = {"fourpt_19/100": 0, "sixpt_1/64": 2}
"""Rows whose order the norms stop short of; the rest, C^(n+1) included, is decided in full."""


def assert_smoothness(name, result, order):
    if name in PROVED_BY_NORMS:
        assert (result.smoothness.order, result.smoothness.sharp) == (PROVED_BY_NORMS[name], False)
        assert result.smoothness.order <= order
    else:
        assert result.smoothness.order == order
        assert result.smoothness.sharp is (order is not None)


def assert_holder(result, interval):
    if interval is None:
        assert result.holder is None
        return
    low, high = interval
    assert result.holder.lower <= high + 1e-6
    assert result.holder.upper >= low - 1e-6
    if isinstance(result.holder.exact, Fraction):
        assert low - 1e-6 <= result.holder.exact <= high + 1e-6


def assert_sobolev(result, value):
    if value is None:
        assert result.sobolev is None
        return
    assert result.sobolev.lower - 1e-6 <= value <= result.sobolev.upper + 1e-6
