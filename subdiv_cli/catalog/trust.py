"""Trust in results from the cache: the checker verifies anew, for this mask, every verdict.

A stale, foreign or altered entry must not lie. Its certificate is verified on every hit and is about the mask that the
file has now; each proved or refuted finding names claims of it that are of the right kind and state the same; and the
short answers of the result, its exponents and its judgements of expectations must follow from its findings and from
the statements proved. The wording alone rests on the digest of the entry.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from subdiv_cli.catalog.numbers import numbers_are_proved
from subdiv_cli.checker import check_document
from subdiv_cli.checker.json_text import parse
from subdiv_cli.checker.reading import Rejected
from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.kind import GATHERED, ContradictionError, Kind, Scheme, gather
from subdiv_cli.model import (
    DECIDED,
    INFINITY,
    Answer,
    ClosedForm,
    Expectation,
    Exponent,
    Finding,
    Interval,
    Judgement,
    Result,
    Rule,
    Smoothness,
    Verdict,
)
from subdiv_cli.model.findings import NEXT_SMOOTHNESS, SMOOTHNESS, SUM_RULES, Question, answering
from subdiv_cli.model.judge import judge, status
from subdiv_cli.model.order import compare


def every_verdict_has_a_claim(result: Result) -> bool:
    """Whether the certificate covers all that the result decides; a result without that is not kept."""
    return all(finding.claims for finding in result.findings if finding.verdict in DECIDED)


def trusted(result: Result, certificate: str, scheme: Scheme, expectations: Sequence[Expectation]) -> bool:
    """Whether the entry is proved for the mask of this scheme, and answers these expectations. Never raises."""
    try:
        kind = kind_of(scheme)
        return _trusted(result, certificate, kind, kind.canonical(scheme), expectations)
    except (Rejected, KeyError, TypeError, ValueError, IndexError, AttributeError, ArithmeticError, ContradictionError):
        return False


def _trusted(
    result: Result, certificate: str, kind: Kind, mask: Mapping[str, Any], expectations: Sequence[Expectation]
) -> bool:
    if result.stopped or result.problems or tuple(j.expectation for j in result.expectations) != tuple(expectations):
        return False
    document: Any = parse(certificate)
    if not check_document(document).verified or document["mask"] != mask:
        return False
    statements = [claim["statement"] for claim in document["claims"]]
    rules = kind.rules()
    if not all(_proved(finding, rules[finding.code], statements) for finding in result.findings):
        return False
    base = kind.base
    if base is None or not numbers_are_proved(result, statements, rules, lambda variables: base(mask, variables)):
        return False
    return _is_gathered(result) and all(_orders(result, statements)) and _judged(result)


def _proved(finding: Finding, rule: Rule[Any], statements: Sequence[Mapping[str, Any]]) -> bool:
    """Whether a finding answers what its rule answers, and a decided one names claims that state the same."""
    if tuple(question for question, _ in finding.answers) != rule.answers:
        return False
    if not all(_answers(finding, answer) for _, answer in finding.answers):
        return False
    if finding.verdict not in DECIDED:
        return True
    stated = _stated(finding, statements)
    if not stated or not all(statement["property"] in rule.proves for statement in stated):
        return False
    if rule.answers and any(statement.get("mask", 0) for statement in stated):  # about a reduced mask
        return False
    holds = finding.verdict is Verdict.PROVED
    return not rule.holds or all(statement["holds"] is holds for statement in stated)


def _stated(finding: Finding, statements: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """The statements of the claims that a finding names."""
    return [statements[number] for number in finding.claims if number >= 0]


def _answers(finding: Finding, answer: Answer) -> bool:
    """Whether an answer is the one that the verdict and the value of its finding determine."""
    if isinstance(answer, Verdict):
        return answer is finding.verdict
    if isinstance(answer, Exponent):
        value = finding.value or Interval()
        return (answer.lower, answer.upper, answer.exact) == (value.lower, value.upper, finding.closed)
    return answer is None or finding.verdict in DECIDED or answer == Smoothness()


def _is_gathered(result: Result) -> bool:
    """Whether the short answers are those of the findings."""
    gathered = gather(result.findings)
    of_findings, given = ({name: _plain(getattr(each, name)) for name in GATHERED} for each in (gathered, result))
    return of_findings == given


def _plain(answer: object) -> object:
    """An answer, an exponent without the decimals, which are checked by themselves."""
    return answer._replace(digits=None) if isinstance(answer, Exponent) else answer


def _orders(result: Result, statements: Sequence[Mapping[str, Any]]) -> Iterator[bool]:
    def orders(question: Question, name: str) -> list[int]:
        """The orders in the claims of this name of the finding that answers a question."""
        finding = answering(result.findings, question)
        stated = () if finding is None else _stated(finding, statements)
        return [statement["order"] for statement in stated if statement["property"] == name]

    polynomial = any(statement["property"] == "polynomial-curve" for statement in statements)

    for smooth in (result.smoothness, result.refinable):
        if smooth.order == INFINITY:
            yield polynomial and smooth.sharp
            continue
        if smooth.order is not None:
            yield max(orders(SMOOTHNESS, "smooth"), default=-1) >= smooth.order
        if smooth.sharp:
            question = SMOOTHNESS if smooth.order is None else NEXT_SMOOTHNESS
            next_order = 0 if smooth.order is None else smooth.order + 1
            yield any(order <= next_order for order in orders(question, "not-smooth"))
    if result.sum_rule_order:
        rules = ("sum-rules", "total-sum-rules", "eigen-sequences")
        yield any(result.sum_rule_order in orders(SUM_RULES, name) for name in rules)
    for name in ("generation", "reproduction", "polynomials"):
        if (degree := getattr(result, name)) is not None:
            yield any(s["property"] == name and s["degree"] == degree for s in statements)
    if result.dimension is not None:
        yield any(s["property"] == "constants" and s["dimension"] == result.dimension for s in statements)
    if result.derivatives is not None:
        stated = (s for s in statements if s["property"] == "hermite-convergent")
        yield any(s["holds"] and s["order"] == result.derivatives for s in stated)


def _judged(result: Result) -> bool:
    """Whether every expectation has the verdict that follows from the result, and the status follows."""
    verdicts = all(_verdict(judged, result) is judged.verdict for judged in result.expectations)
    return verdicts and result.status == status(result.convergent, result.expectations)


def _verdict(judgement: Judgement, result: Result) -> Verdict:
    """The verdict by enclosures; where these do not decide, as with equal numbers, exactly: only that loads flint."""
    try:
        return judge(_sign, judgement.expectation, result)
    except _UntoldError:
        from subdiv_cli.pipeline import judged

        return judged((judgement.expectation,), result)[0].verdict


class _UntoldError(Exception):
    pass


def _sign(a: ClosedForm, b: ClosedForm) -> int:
    sign = compare(a, b)
    if sign is None:
        raise _UntoldError
    return sign
