"""The pipeline: one scheme through its stages, findings certified and checked, and the result judged.

It is the same for every kind, which is used through its `Kind` object.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from subdiv_cli.certificate import document_text, family_certificate
from subdiv_cli.checker import check_document
from subdiv_cli.exact.closed import compare, digits
from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.kind import Analysis, Drawings, Kind, Options, Scheme, gather
from subdiv_cli.model import Effort, Expectation, Exponent, Finding, Judgement, Result
from subdiv_cli.model.judge import judge, status

if TYPE_CHECKING:
    from subdiv_cli.model.blocks import Drawing, Portrait
    from subdiv_cli.model.family import FamilyRadius


class DisagreementError(Exception):
    """Raised where the checker does not accept the certificate: an error in this program, never in the input."""


class Checked(NamedTuple):
    """The result, and the certificate that the checker has verified; None where it would be too long for it."""

    result: Result
    document: Mapping[str, Any] | None

    def certificate_text(self) -> str | None:
        """The certificate as its file has it."""
        return None if self.document is None else document_text(self.document)


def check(scheme: Scheme, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """The result of a scheme within the effort, every verdict checked independently.

    The caller adds file, name and parameters to the result. Raises DisagreementError where the checker says no.
    """
    kind = kind_of(scheme)
    assert kind.analyse is not None, "a mask of a kind that is not decided is not read"
    return certified(kind, kind.analyse(scheme, effort), expectations, effort)


def show(scheme: Scheme, tolerance: Fraction, effort: Effort) -> tuple[Checked, Portrait]:
    """The result of `check` with the findings of `show`, certified and checked alike, and the mask taken apart.

    `tolerance` is that of error bounds. Raises DisagreementError where the checker says no.
    """
    kind = kind_of(scheme)
    assert kind.portraits is not None, "a mask of a kind that is not taken apart is not read"
    analysis = kind.portraits.analyse(scheme, effort, tolerance)
    checked = certified(kind, analysis, (), effort)
    return checked, kind.portraits.make(analysis, checked.result)


def draw(scheme: Scheme, drawings: Drawings, options: Options, effort: Effort) -> Drawing:
    """The picture of one of the sorts that the kind of the scheme declares; its hypotheses are certified and checked.

    Raises NotDrawnError where it cannot be drawn, DisagreementError where the checker says no.
    """
    kind = kind_of(scheme)
    analyse = kind.analyse
    assert analyse is not None, "a kind that draws decides"

    def certify(part: Effort) -> tuple[Analysis, Result]:
        analysis = analyse(scheme, part)
        return analysis, certified(kind, analysis, (), part).result

    return drawings.make(scheme, effort, options, certify)


def certified(kind: Kind, analysis: Analysis, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """The findings of the stages, with every verdict checked. Raises DisagreementError."""
    assert kind.certificate is not None, "a kind that finds something proves it"
    findings = analysis.findings
    written = kind.certificate(analysis)
    if written is not None and not verified(written.document):
        written = None
    claims = written.claims if written is not None else [()] * len(findings)
    findings = tuple(_named(finding, numbers) for finding, numbers in zip(findings, claims, strict=True))
    gathered = gather(findings)
    result = replace(
        gathered,
        kind=kind.name,
        stopped="budget" if effort.struck else None,
        facts=analysis.facts,
        hints=analysis.hints,
        holder=_with_digits(gathered.holder),
        sobolev=_with_digits(gathered.sobolev),
    )
    judgements = judged(expectations, result)
    result = replace(result, expectations=judgements, status=status(result.convergent, judgements))
    return Checked(result, None if written is None else written.document)


def judged(expectations: Sequence[Expectation], result: Result) -> tuple[Judgement, ...]:
    """The judgements of expectations by a result, closed forms compared exactly, however they are written."""
    return tuple(Judgement(expectation=e, verdict=judge(compare, e, result)) for e in expectations)


def _named(finding: Finding, claims: tuple[int, ...]) -> Finding:
    """The finding with the numbers of its claims, and without its proof, which is in them, and is long."""
    return replace(finding, claims=claims, proof={}) if claims or finding.proof else finding


def _with_digits(exponent: Exponent | None) -> Exponent | None:
    """The exponent with decimals, where it is exact and irrational."""
    if exponent is None or exponent.exact is None:
        return exponent
    return exponent._replace(digits=digits(exponent.exact))


class CheckedRadius(NamedTuple):
    """A joint spectral radius, and the certificate that the checker has verified."""

    radius: FamilyRadius
    document: Mapping[str, Any] | None

    def certificate_text(self) -> str | None:
        """The certificate as its file has it."""
        return None if self.document is None else document_text(self.document)


def joint_spectral_radius(matrices: Sequence[Sequence[Sequence[Fraction]]], effort: Effort) -> CheckedRadius:
    """The joint spectral radius of a family of square matrices of one order, checked independently.

    Raises DisagreementError where the checker says no.
    """
    from subdiv_cli.jsr.answer import answer  # numpy comes with it

    radius = answer(matrices, effort)
    document = family_certificate(matrices, radius)
    if document is not None and not verified(document):
        document = None
    return CheckedRadius(radius, document)


def verified(document: Mapping[str, Any]) -> bool:
    """Whether the checker verifies a document; False where it is too much work. Raises DisagreementError."""
    outcome = check_document(document)
    if not outcome.verified and not outcome.exhausted:
        raise DisagreementError(f"the checker rejects the certificate: {outcome.line}")
    return outcome.verified
