"""One scheme through the stages: findings, certified and checked, gathered into a result and held to expectations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.certificate import certificate, document_text
from subdiv_cli.checker import check_document
from subdiv_cli.model import (
    Anatomy,
    Curve,
    Effort,
    Expectation,
    Exponent,
    Finding,
    Judgement,
    Result,
    Smoothness,
    Status,
    Verdict,
    logarithm,
)
from subdiv_cli.schemes.scalar import ScalarScheme
from subdiv_cli.stages.anatomy import anatomy
from subdiv_cli.stages.curves import TooFewPointsError as TooFewPointsError
from subdiv_cli.stages.curves import limit, polygons, refinable, support
from subdiv_cli.stages.judge import judge
from subdiv_cli.stages.picture import stages as picture_stages
from subdiv_cli.stages.scalar import Analysis, analyse


class DisagreementError(Exception):
    """The independent checker does not accept the certificate: an error in this program, never in the input."""


Vertices = tuple[tuple[Fraction, ...], ...]
"""The coordinates of the vertices of a polygon, one sequence for each coordinate."""


class Checked(NamedTuple):
    """What was found, and the certificate that the checker has verified; None where it would ask too much of it."""

    result: Result
    document: Mapping[str, Any] | None

    def certificate_text(self) -> str | None:
        """The certificate as its file has it."""
        return None if self.document is None else document_text(self.document)


def check(scheme: ScalarScheme, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """Decide what the stages can decide within the effort, and have every verdict checked independently.

    The caller adds file, name and parameters to the result. Raises DisagreementError where the checker says no.
    """
    return _certified(scheme, analyse(scheme, effort), expectations, effort)


def _certified(
    scheme: ScalarScheme, analysis: Analysis, expectations: Sequence[Expectation], effort: Effort
) -> Checked:
    findings = analysis.findings
    written = certificate(scheme.arity, scheme.start, scheme.coefficients, findings)
    if written is not None:
        outcome = check_document(written.document)
        if not outcome.verified:
            raise DisagreementError(f"the checker rejects the certificate: {outcome.line}")
        pairs = zip(findings, written.claims, strict=True)
        findings = tuple(replace(finding, claims=claims) if claims else finding for finding, claims in pairs)
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
        holder=_holder(found, scheme.arity),
        sobolev=_sobolev(found, scheme.arity),
        stable=found["SD402"].verdict,
        linearly_independent=found["SD401"].verdict,
        generation=_integer(found, "SD103", "degree"),
        reproduction=_integer(found, "SD104", "degree"),
        findings=findings,
    )
    judgements = tuple(Judgement(expectation=e, verdict=judge(e, result)) for e in expectations)
    result = replace(result, expectations=judgements, status=_status(result, judgements))
    return Checked(result, None if written is None else written.document)


def _status(result: Result, judgements: Sequence[Judgement]) -> Status:
    """Every expectation must be proved; where a mask states none, convergence must."""
    verdicts = [judgement.verdict for judgement in judgements] or [result.convergent]
    if Verdict.REFUTED in verdicts:
        return "failed"
    return "passed" if all(v is Verdict.PROVED for v in verdicts) else "undecided"


def _integer(found: dict[str, Finding], code: str, key: str) -> int | None:
    value = found[code].witness.get(key)
    return value if isinstance(value, int) else None


def _holder(found: dict[str, Finding], p: int) -> Exponent | None:
    """None without sum rules. What is exact for D = S_(Δ^k) is the exponent of φ where φ is stable."""
    below, above = found["SD311"], found["SD312"]
    if below.verdict is Verdict.SKIPPED:
        return None
    lower = below.value.lower if below.value else None
    upper = above.value.upper if above.value else None
    norm, level = below.witness.get("norm"), below.witness.get("level")
    closed = "word" in below.witness and above.verdict is Verdict.PROVED
    if not closed or not isinstance(norm, Fraction) or not isinstance(level, int):
        return Exponent(lower=lower, upper=upper)
    upper = below.value.upper if below.value else upper
    return Exponent(lower=lower, upper=upper, exact=logarithm(p, 1 / norm, level))


def _sobolev(found: dict[str, Finding], p: int) -> Exponent | None:
    """None without sum rules, or where the effort ended."""
    finding = found["SD321"]
    if finding.value is None:
        return None
    radius = finding.witness.get("radius")
    exact = logarithm(p, 1 / radius, 2) if isinstance(radius, Fraction) else None
    return Exponent(lower=finding.value.lower, upper=finding.value.upper, exact=exact)


def portrait(scheme: ScalarScheme, tolerance: Fraction, effort: Effort) -> tuple[Checked, Anatomy]:
    """What `check` finds and, certified and checked alike, values, stencils, Q and error bounds; the mask taken apart.

    `tolerance` is that of the error bound. Raises DisagreementError where the checker says no.
    """
    analysis = analyse(scheme, effort, picture_stages(tolerance))
    return _certified(scheme, analysis, (), effort), anatomy(analysis)


def drawn(
    scheme: ScalarScheme, effort: Effort, points: int
) -> tuple[Result, tuple[Curve, ...], tuple[Fraction, Fraction]]:
    """The result of `check`; φ and its derivatives up to the proved order, with about so many points; their support.

    No curves where φ is not proved continuous.
    """
    analysis = analyse(scheme, effort)
    result = _certified(scheme, analysis, (), effort).result
    order = result.refinable.order
    curves = () if order is None else refinable(analysis.numbers, order, points)
    return result, curves, support(analysis.numbers)


def traced(
    scheme: ScalarScheme, effort: Effort, columns: Vertices, points: int, *, closed: bool, levels: int
) -> tuple[Result, tuple[Curve, ...], tuple[Vertices, ...]]:
    """The result of `check`; the limit of a polygon, a curve for each coordinate; the polygons of levels 1 to `levels`.

    No curves where S is not proved to converge. Raises TooFewPointsError for an open polygon that determines no limit.
    """
    analysis = analyse(scheme, effort)
    result = _certified(scheme, analysis, (), effort).result
    if result.convergent is not Verdict.PROVED:
        return result, (), ()
    curves = limit(analysis.numbers, columns, points, closed=closed)
    refined = (polygons(analysis.numbers, columns, level, closed=closed) for level in range(1, levels + 1))
    return result, curves, tuple(refined)
