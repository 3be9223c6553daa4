"""Exit codes: every combination of statuses, options and Ctrl-C."""

from itertools import chain, combinations, product

import pytest

from subdiv_cli.cli.exits import ExitCode, exit_code

STATUSES = ("passed", "failed", "undecided", "invalid")
SETS = list(chain.from_iterable(combinations(STATUSES, n) for n in range(5)))


@pytest.mark.parametrize(("seen", "allowed", "interrupted"), [*product(SETS, (False, True), (False, True))])
def test_precedence(seen, allowed, interrupted):
    ranked = [("invalid", 2), ("failed", 1), ("undecided", 0 if allowed else 3), ("passed", 0)]
    wanted = 130 if interrupted else next((code for status, code in ranked if status in seen), 0)
    assert exit_code(seen, allow_undecided=allowed, interrupted=interrupted) == wanted
    assert exit_code(reversed(seen * 2), allow_undecided=allowed, interrupted=interrupted) == wanted


def test_the_numbers_are_a_promise():
    assert {code.name: code.value for code in ExitCode} == {
        "PASSED": 0, "FAILED": 1, "ERROR": 2, "UNDECIDED": 3, "INTERRUPTED": 130,
    }  # fmt: skip
