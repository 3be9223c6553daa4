"""The pipeline of schemes in several variables: findings, certified and checked, gathered into a result."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from subdiv_cli.certificate.multivariate import surface_certificate
from subdiv_cli.maskfile.canonical import canonical
from subdiv_cli.model import Effort, Expectation, Exponent, Finding, Judgement, Result, Smoothness, Verdict
from subdiv_cli.pipeline import Checked, status_of, verified
from subdiv_cli.schemes.multivariate import MultivariateScheme
from subdiv_cli.stages.judge import judge
from subdiv_cli.stages.multivariate.analysis import Analysis, analyse


def check_surface(scheme: MultivariateScheme, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """As `pipeline.check`. Raises DisagreementError where the checker says no."""
    return certified_surface(scheme, analyse(scheme, effort), expectations, effort)


def certified_surface(
    scheme: MultivariateScheme, analysis: Analysis, expectations: Sequence[Expectation], effort: Effort
) -> Checked:
    """As `pipeline.certified`. Raises DisagreementError."""
    findings = analysis.findings
    written = surface_certificate(dict(canonical(scheme)), findings)
    if written is not None and not verified(written.document):
        written = None
    if written is not None:
        pairs = zip(findings, written.claims, strict=True)
        findings = tuple(replace(finding, claims=claims) if claims else finding for finding, claims in pairs)
    found = {finding.code: finding for finding in findings}
    refinable = _smoothness(found)
    converges = found["SD611"].verdict
    order = analysis.numbers.order
    result = Result(
        file="",
        status="undecided",
        kind="multivariate",
        stopped="budget" if effort.struck else None,
        facts=analysis.facts,
        sum_rule_order=order,
        convergent=converges,
        smoothness=refinable if converges is Verdict.PROVED else Smoothness(),
        refinable=refinable,
        holder=_holder(found),
        stable=found["SD616"].verdict,
        generation=order - 1 if order else None,
        findings=findings,
    )
    judgements = tuple(Judgement(expectation=e, verdict=judge(e, result)) for e in expectations)
    result = replace(result, expectations=judgements, status=status_of(result, judgements))
    return Checked(result, None if written is None else written.document)


def _smoothness(found: Mapping[str, Finding]) -> Smoothness:
    first, following = found["SD612"], found.get("SD613")
    if first.verdict is not Verdict.PROVED:
        return Smoothness(sharp=first.verdict is Verdict.REFUTED)
    order = first.witness["order"]
    assert isinstance(order, int)
    return Smoothness(order=order, sharp=following is not None and following.verdict is Verdict.REFUTED)


def _holder(found: Mapping[str, Finding]) -> Exponent | None:
    """What is exact from below is the exponent where the bound from above is proved with it."""
    below, above = found["SD614"], found["SD615"]
    if below.verdict is Verdict.SKIPPED:
        return None
    lower = below.value.lower if below.value else None
    if below.closed is None or above.verdict is not Verdict.PROVED:
        return Exponent(lower=lower, upper=above.value.upper if above.value else None)
    return Exponent(lower=lower, upper=below.value.upper if below.value else None, exact=below.closed)
