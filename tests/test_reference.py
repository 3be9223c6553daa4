"""Published and recomputed values: every scalar row of the reference data, against the pipeline."""

import json
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
    for key in ("generation", "reproduction"):  # null where there is none
        assert getattr(result, key) == (truth[key] if truth[key] >= 0 else None)
    assert result.smoothness.order == truth["smoothness"]
    assert result.smoothness.sharp is (truth["smoothness"] is not None)
    assert_holder(result, truth["holder_of_limits"])
    assert_sobolev(result, truth["sobolev_of_limits"])


def assert_holder(result, interval):
    if interval is None:
        assert result.holder is None
        return
    low, high = interval
    assert low - 1e-6 <= result.holder.lower <= result.holder.upper <= high + 1e-6
    assert result.holder.exact is not None
    assert result.holder.upper - result.holder.lower < 1e-9


def assert_sobolev(result, value):
    if value is None:
        assert result.sobolev is None
        return
    assert result.sobolev.lower - 1e-6 <= value <= result.sobolev.upper + 1e-6
