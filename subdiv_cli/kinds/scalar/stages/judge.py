"""Expectations judged with closed forms compared exactly: equal ones are recognised however they are written."""

from __future__ import annotations

from subdiv_cli.exact.closed import compare
from subdiv_cli.model import Expectation, Result, Verdict
from subdiv_cli.model.judge import judge_by


def judge(expectation: Expectation, found: Result) -> Verdict:
    """Whether the findings prove or refute an expectation."""
    return judge_by(compare, expectation, found)
