"""Whether a result from the cache may be believed: the checker says so anew, of this mask, for every verdict.

A stale, foreign or altered entry must not lie. Its certificate is verified on every hit and is about the mask that the
file has now; each proved or refuted finding names claims of it that are of the right kind and say the same; and what
the result says in short, its exponents and its judgements of expectations must follow from its findings and from the
statements proved. The wording alone rests on the digest of the entry.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from subdiv_cli.catalog.numbers import numbers_are_proved
from subdiv_cli.checker import check_document
from subdiv_cli.checker.json_text import parse
from subdiv_cli.checker.reading import Rejected
from subdiv_cli.model import ClosedForm, Expectation, Finding, Judgement, Result, Verdict
from subdiv_cli.model.judge import judge_by, status
from subdiv_cli.model.order import compare

DECIDED = (Verdict.PROVED, Verdict.REFUTED)
_PROPERTIES = {
    "SD101": {"residue-sums"},
    "SD102": {"sum-rules"},
    "SD103": {"generation"},
    "SD104": {"reproduction"},
    "SD105": {"derived", "sum-rules"},
    "SD201": {"convergent"},
    "SD202": {"eigen-condition"},
    "SD302": {"smooth", "not-smooth"},
    "SD303": {"not-smooth"},
    "SD304": {"eigen-condition", "sum-rules"},
    "SD310": {"norm", "product", "family", "radius", "bounded", "radius-upper"},
    "SD311": {"holder-lower", "holder", "holder-root"},
    "SD312": {"holder-upper", "holder", "holder-root"},
    "SD313": {"attained"},
    "SD321": {"sobolev"},
    "SD401": {"independent"},
    "SD402": {"stable"},
    "SD601": {"coset-sums"},
    "SD602": {"total-sum-rules", "generation"},
    "SD603": {"box-spline"},
    "SD604": {"directional-norm"},
    "SD605": {"family", "radius", "bounded", "radius-upper"},
    "SD606": {"matrix-norm"},
    "SD607": {"smooth"},
    "SD608": {"convergent"},
    "SD609": {"tensor-product"},
    "SD611": {"convergent"},
    "SD612": {"smooth", "not-smooth"},
    "SD613": {"not-smooth"},
    "SD614": {"holder-lower", "holder-root", "holder-value", "radius", "bounded", "radius-upper", "of-factor"},
    "SD615": {"holder-upper", "holder-root", "holder-value", "of-factor", "at-most-factor"},
    "SD616": {"stable"},
    "SD617": {"sobolev", "sobolev-lower", "sobolev-value", "of-factor"},
    "SD618": {"reproduction"},
    "SD619": {"quasi-interpolation"},
}
"""What claims of these findings must be about; those of later codes must only be verified."""
_HOLDS = {"SD201", "SD202", "SD313", "SD401", "SD402", "SD601", "SD608", "SD611", "SD616"}
"""Findings whose claims say whether something holds, proved or refuted."""

_ANSWERS = {"scalar": ("SD201", "SD402", "SD401"), "multivariate": ("SD611", "SD616")}
"""The findings on convergence, stability and linear independence."""


def every_verdict_has_a_claim(result: Result) -> bool:
    """Whether the certificate covers all that the result decides; a result without that is not kept."""
    return all(finding.claims for finding in result.findings if finding.verdict in DECIDED)


def trusted(result: Result, certificate: str, mask: Mapping[str, Any], expectations: Sequence[Expectation]) -> bool:
    """Whether the entry is proved for this mask, in its canonical spelling, and answers these expectations.

    Never raises.
    """
    try:
        return _trusted(result, certificate, mask, expectations)
    except (Rejected, KeyError, TypeError, ValueError, IndexError, AttributeError, ArithmeticError):
        return False


def _trusted(result: Result, certificate: str, mask: Mapping[str, Any], expectations: Sequence[Expectation]) -> bool:
    if result.stopped or result.problems or tuple(j.expectation for j in result.expectations) != tuple(expectations):
        return False
    document: Any = parse(certificate)
    if not check_document(document).verified or document["mask"] != mask:
        return False
    statements = [claim["statement"] for claim in document["claims"]]
    if not all(_proved(finding, statements) for finding in result.findings):
        return False
    return _numbers(result, statements, mask) and _follows(result, statements)


def _numbers(result: Result, statements: Sequence[Mapping[str, Any]], mask: Mapping[str, Any]) -> bool:
    if mask["kind"] == "scalar":
        return numbers_are_proved(result, statements, mask["arity"])
    from subdiv_cli.catalog.surface_numbers import surface_numbers_are_proved

    return surface_numbers_are_proved(result, statements, mask)


def _proved(finding: Finding, statements: Sequence[Mapping[str, Any]]) -> bool:
    """Whether the claims that a decided finding names are there and say the same."""
    if finding.verdict not in DECIDED:
        return True
    said = [statements[number] for number in finding.claims if number >= 0]
    fitting = _PROPERTIES.get(finding.code)
    if not said or (fitting is not None and not all(statement["property"] in fitting for statement in said)):
        return False
    holds = finding.verdict is Verdict.PROVED
    return finding.code not in _HOLDS or all(statement["holds"] is holds for statement in said)


def _follows(result: Result, statements: Sequence[Mapping[str, Any]]) -> bool:
    """Whether the short answers are those of the findings, and the orders those of the statements."""
    found = {finding.code: finding for finding in result.findings}
    given = (result.convergent, result.stable, result.linearly_independent)
    answers = dict(zip(_ANSWERS[result.kind or "scalar"], given, strict=False))
    if any(code not in found or found[code].verdict is not verdict for code, verdict in answers.items()):
        return False
    if result.smoothness.order is not None and result.convergent is not Verdict.PROVED:
        return False
    return all(_orders(result, statements)) and _judged(result)


def _orders(result: Result, statements: Sequence[Mapping[str, Any]]) -> Iterator[bool]:
    def largest(name: str, key: str) -> int:
        return max((s[key] for s in statements if s["property"] == name), default=-1)

    def least(name: str, key: str) -> int:
        return min((s[key] for s in statements if s["property"] == name), default=1 << 30)

    for smooth in (result.smoothness, result.refinable):
        if smooth.order is not None:
            yield largest("smooth", "order") >= smooth.order
            yield not smooth.sharp or least("not-smooth", "order") <= smooth.order + 1
    if result.sum_rule_order:
        rules = ("sum-rules", "total-sum-rules")
        yield any(s["property"] in rules and s["order"] == result.sum_rule_order for s in statements)
    for name, degree in (("generation", result.generation), ("reproduction", result.reproduction)):
        if degree is not None:
            yield any(s["property"] == name and s["degree"] == degree for s in statements)


def _judged(result: Result) -> bool:
    """Whether every expectation is judged as the result says, and the status follows."""
    verdicts = all(_verdict(judged, result) is judged.verdict for judged in result.expectations)
    return verdicts and result.status == status(result.convergent, result.expectations)


def _verdict(said: Judgement, result: Result) -> Verdict:
    """By enclosures; where these do not tell, as with equal numbers, exactly: only that loads flint."""
    try:
        return judge_by(_sign, said.expectation, result)
    except _UntoldError:
        from subdiv_cli.pipeline import judged

        return judged((said.expectation,), result)[0].verdict


class _UntoldError(Exception):
    pass


def _sign(a: ClosedForm, b: ClosedForm) -> int:
    sign = compare(a, b)
    if sign is None:
        raise _UntoldError
    return sign
