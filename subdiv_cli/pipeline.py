"""One scheme through the stages: findings, certified and checked, gathered into a result and held to expectations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from subdiv_cli.certificate import certificate, document_text, family_certificate
from subdiv_cli.checker import check_document
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages.figures import digits, estimate
from subdiv_cli.kinds.scalar.stages.judge import judge
from subdiv_cli.kinds.scalar.stages.scalar import Analysis, analyse
from subdiv_cli.model import Effort, Expectation, Exponent, Finding, Judgement, Result, Smoothness, Verdict
from subdiv_cli.model.judge import status

if TYPE_CHECKING:
    from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
    from subdiv_cli.model.family import FamilyRadius


class DisagreementError(Exception):
    """The independent checker does not accept the certificate: an error in this program, never in the input."""


class Checked(NamedTuple):
    """What was found, and the certificate that the checker has verified; None where it would ask too much of it."""

    result: Result
    document: Mapping[str, Any] | None

    def certificate_text(self) -> str | None:
        """The certificate as its file has it."""
        return None if self.document is None else document_text(self.document)


def check(scheme: ScalarScheme | MultivariateScheme, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """Decide what the stages can decide within the effort, and have every verdict checked independently.

    The caller adds file, name and parameters to the result. Raises DisagreementError where the checker says no.
    """
    if not isinstance(scheme, ScalarScheme):
        from subdiv_cli.surfaces import check_surface  # no scalar mask needs it

        return check_surface(scheme, expectations, effort)
    return certified(scheme, analyse(scheme, effort), expectations, effort)


def certified(scheme: ScalarScheme, analysis: Analysis, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """What the stages have found, with every verdict checked. Raises DisagreementError."""
    findings = analysis.findings
    written = certificate(scheme.arity, scheme.start, scheme.coefficients, findings)
    if written is not None and not verified(written.document):
        written = None
    claims = written.claims if written is not None else [()] * len(findings)
    findings = tuple(named(finding, numbers) for finding, numbers in zip(findings, claims, strict=True))
    found = {finding.code: finding for finding in findings}
    sharp = found["SD303"].verdict is Verdict.REFUTED
    refinable = Smoothness(order=_integer(found, "SD302", "order"), sharp=sharp)
    result = Result(
        file="",
        status="undecided",
        kind="scalar",
        stopped="budget" if effort.struck else None,
        facts=analysis.facts,
        hints=analysis.hints,
        sum_rule_order=_integer(found, "SD102", "order"),
        convergent=found["SD201"].verdict,
        smoothness=refinable if found["SD201"].verdict is Verdict.PROVED else Smoothness(),
        refinable=refinable,
        holder=_holder(found, analysis),
        sobolev=sobolev_exponent(found["SD321"]),
        stable=found["SD402"].verdict,
        linearly_independent=found["SD401"].verdict,
        generation=_integer(found, "SD103", "degree"),
        reproduction=_integer(found, "SD104", "degree"),
        findings=findings,
    )
    judgements = judged(expectations, result)
    result = replace(result, expectations=judgements, status=status(result.convergent, judgements))
    return Checked(result, None if written is None else written.document)


def judged(expectations: Sequence[Expectation], result: Result) -> tuple[Judgement, ...]:
    """Every expectation against a result, closed forms compared exactly."""
    return tuple(Judgement(expectation=e, verdict=judge(e, result)) for e in expectations)


def named(finding: Finding, claims: tuple[int, ...]) -> Finding:
    """With the numbers of its claims; its proof is in them, and is long."""
    return replace(finding, claims=claims, proof={}) if claims or finding.proof else finding


class CheckedRadius(NamedTuple):
    """A joint spectral radius, and the certificate that the checker has verified."""

    radius: FamilyRadius
    document: Mapping[str, Any] | None

    def certificate_text(self) -> str | None:
        """The certificate as its file has it."""
        return None if self.document is None else document_text(self.document)


def joint_spectral_radius(matrices: Sequence[Sequence[Sequence[Fraction]]], effort: Effort) -> CheckedRadius:
    """That of a family of square matrices of one order, checked independently.

    Raises DisagreementError where the checker says no.
    """
    from subdiv_cli.jsr.answer import answer  # numpy comes with it

    radius = answer(matrices, effort)
    document = family_certificate(matrices, radius)
    if document is not None and not verified(document):
        document = None
    return CheckedRadius(radius, document)


def verified(document: Mapping[str, Any]) -> bool:
    """Whether the checker verifies it; False where it asks more than the checker does. Raises DisagreementError."""
    outcome = check_document(document)
    if not outcome.verified and not outcome.exhausted:
        raise DisagreementError(f"the checker rejects the certificate: {outcome.line}")
    return outcome.verified


def _integer(found: dict[str, Finding], code: str, key: str) -> int | None:
    value = found[code].witness.get(key)
    return value if isinstance(value, int) else None


def _holder(found: dict[str, Finding], analysis: Analysis) -> Exponent | None:
    """None without sum rules. What is exact for D = S_(Δ^k) is the exponent of φ where φ is stable."""
    below, above = found["SD311"], found["SD312"]
    if below.verdict is Verdict.SKIPPED:
        return None
    lower = below.value.lower if below.value else None
    upper = above.value.upper if above.value else None
    if below.closed is None or above.verdict is not Verdict.PROVED:
        return Exponent(lower=lower, upper=upper, estimate=estimate(analysis.numbers, lower, upper))
    attained = {Verdict.PROVED: True, Verdict.REFUTED: False}.get(found["SD313"].verdict)
    upper = below.value.upper if below.value else upper
    return Exponent(lower=lower, upper=upper, exact=below.closed, attained=attained, digits=digits(below.closed))


def sobolev_exponent(finding: Finding) -> Exponent | None:
    """None without sum rules, or where the effort ended."""
    value, exact = finding.value, finding.closed
    if value is None:
        return None
    return Exponent(lower=value.lower, upper=value.upper, exact=exact, digits=None if exact is None else digits(exact))
