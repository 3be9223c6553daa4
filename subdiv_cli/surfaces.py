"""The pipeline of schemes in several variables: findings, certified and checked, gathered into a result."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import cast

from subdiv_cli.certificate import certificate
from subdiv_cli.kinds.multivariate.claims.multivariate import surface_certificate
from subdiv_cli.kinds.multivariate.claims.tensor import PartCertificate
from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.stages.analysis import Analysis, analyse
from subdiv_cli.kinds.scalar.claims.writer import Certificate
from subdiv_cli.kinds.scalar.scheme import ScalarScheme
from subdiv_cli.kinds.scalar.stages.figures import digits
from subdiv_cli.maskfile.canonical import canonical
from subdiv_cli.model import Effort, Expectation, Exponent, Finding, Result, Smoothness, Verdict
from subdiv_cli.model.judge import status
from subdiv_cli.pipeline import Checked, judged, named, sobolev_exponent, verified


def check_surface(scheme: MultivariateScheme, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """As `pipeline.check`. Raises DisagreementError where the checker says no."""
    return certified_surface(scheme, analyse(scheme, effort), expectations, effort)


def certified_surface(
    scheme: MultivariateScheme, analysis: Analysis, expectations: Sequence[Expectation], effort: Effort
) -> Checked:
    """As `pipeline.certified`. Raises DisagreementError."""
    findings = analysis.findings
    written = _certificate(scheme, analysis)
    if written is not None and not verified(written.document):
        written = None
    claims = written.claims if written is not None else [()] * len(findings)
    findings = tuple(named(finding, numbers) for finding, numbers in zip(findings, claims, strict=True))
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
        sobolev=sobolev_exponent(found["SD617"]),
        stable=found["SD616"].verdict,
        generation=order - 1 if order else None,
        reproduction=analysis.numbers.reproduction.degree if order else None,
        findings=findings,
    )
    judgements = judged(expectations, result)
    result = replace(result, expectations=judgements, status=status(result.convergent, judgements))
    return Checked(result, None if written is None else written.document)


def _certificate(scheme: MultivariateScheme, analysis: Analysis) -> Certificate | None:
    """With those of its factors inside; None where one of them is too long."""
    parts = []
    for variables, factor, inner in analysis.parts:
        if isinstance(factor, ScalarScheme):
            written = certificate(factor.arity, factor.start, factor.coefficients, inner.findings)
        else:
            written = _certificate(factor, cast("Analysis", inner))
        if written is None:
            return None
        claims = written.document["claims"]
        said = {
            finding.code: [claims[number]["statement"] for number in numbers]
            for finding, numbers in zip(inner.findings, written.claims, strict=True)
            if numbers
        }
        parts.append(PartCertificate(variables, written.document, said))
    return surface_certificate(dict(canonical(scheme)), analysis.findings, parts)


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
    upper = below.value.upper if below.value else None
    return Exponent(lower=lower, upper=upper, exact=below.closed, digits=digits(below.closed))
