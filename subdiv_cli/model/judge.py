"""Judgement of expectations by results, and the status that follows: proved, refuted or undecided, never guessed.

Standard library only, because a result from the cache is judged anew; whoever judges says how closed forms are
compared.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from subdiv_cli.model import ClosedForm, Expectation, Exponent, Judgement, Log, Result, RootLog, Status, Verdict
from subdiv_cli.model.properties import BY_KEY

Compare = Callable[[ClosedForm, ClosedForm], int | None]
"""A function that gives the sign of a - b, or None where that is not known."""


def judge(compare: Compare, expectation: Expectation, result: Result) -> Verdict:
    """The verdict on an expectation: whether the result proves or refutes it."""
    value: Any = getattr(result, expectation.key)
    match BY_KEY[expectation.key].form:
        case "verdict":
            return _yes_or_no(value, expectation)
        case "smoothness":
            return _smoothness(expectation, result)
        case "exponent":
            return _exponent(compare, expectation, value)
        case "dimension":
            return _within(expectation, value, value)
        case "order" | "degree":
            none = value is None and result.sum_rule_order == 0  # not even the constants
            return _within(expectation, value, -1 if none else value)


def status(convergent: Verdict, judgements: Sequence[Judgement]) -> Status:
    """The status of a mask: every expectation must be proved; where a mask states none, convergence must."""
    verdicts = [judgement.verdict for judgement in judgements] or [convergent]
    if Verdict.REFUTED in verdicts:
        return "failed"
    return "passed" if all(v is Verdict.PROVED for v in verdicts) else "undecided"


def _yes_or_no(verdict: Verdict, expectation: Expectation) -> Verdict:
    if verdict is Verdict.PROVED:
        return Verdict.PROVED if expectation.lower else Verdict.REFUTED
    if verdict is Verdict.REFUTED:
        return Verdict.REFUTED if expectation.lower else Verdict.PROVED
    return Verdict.UNDECIDED


def _smoothness(expectation: Expectation, result: Result) -> Verdict:
    if result.convergent is Verdict.REFUTED:
        return Verdict.REFUTED
    order = result.smoothness.order
    return _within(expectation, order, order if result.smoothness.sharp else None)


def _within(expectation: Expectation, at_least: int | float | None, at_most: int | float | None) -> Verdict:
    """The verdict on an integer between two bounds, None for no bound, against the expected range."""
    low, high = expectation.lower, expectation.upper
    if isinstance(low, Log | RootLog) or isinstance(high, Log | RootLog):
        raise TypeError(f"{expectation.key} is an integer")
    if (at_most is not None and at_most < low) or (at_least is not None and high is not None and at_least > high):
        return Verdict.REFUTED
    reaches = at_least is not None and at_least >= low
    stays = high is None or (at_most is not None and at_most <= high)
    return Verdict.PROVED if reaches and stays else Verdict.UNDECIDED


def _exponent(compare: Compare, expectation: Expectation, exponent: Exponent | None) -> Verdict:
    if exponent is None:
        return Verdict.UNDECIDED
    low, high = _closed(expectation.lower), expectation.upper
    lower, upper = _ends(exponent)
    below = None if upper is None else compare(upper, low)
    above = None if high is None or lower is None else compare(lower, _closed(high))
    if below == -1 or above == 1:
        return Verdict.REFUTED
    reaches = lower is not None and compare(lower, low) in (0, 1)
    stays = high is None or (upper is not None and compare(upper, _closed(high)) in (-1, 0))
    return Verdict.PROVED if reaches and stays else Verdict.UNDECIDED


def _ends(exponent: Exponent) -> tuple[ClosedForm | None, ClosedForm | None]:
    if exponent.exact is not None:
        return exponent.exact, exponent.exact
    return (
        None if exponent.lower is None else Fraction(exponent.lower),
        None if exponent.upper is None else Fraction(exponent.upper),
    )


def _closed(x: bool | int | ClosedForm) -> ClosedForm:
    return Fraction(x) if isinstance(x, int) else x
