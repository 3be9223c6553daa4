"""The pipeline: one scheme through its stages, findings certified and checked, and the result judged.

It is the same for every kind, which is used through its `Kind` object.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from subdiv_cli.certificate import Certificate, Proofs, document_text, family_certificate
from subdiv_cli.checker import Outcome, check_document
from subdiv_cli.exact.closed import compare, digits
from subdiv_cli.kinds import kind_of
from subdiv_cli.kinds.kind import Analysis, Drawings, Kind, Options, Scheme, SmoothingStep, gather
from subdiv_cli.model import (
    DECIDED,
    UNHURRIED,
    Effort,
    Expectation,
    Exponent,
    Finding,
    Judgement,
    Result,
    Verdict,
    watch,
)
from subdiv_cli.model.family import FamilyRadius
from subdiv_cli.model.findings import OUT_OF_TIME, TOO_DEAR, UNWRITTEN, uncertified
from subdiv_cli.model.judge import judge, status

if TYPE_CHECKING:
    from subdiv_cli.model.blocks import Drawing, Portrait


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
    watch.begin("page")
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
        result = certified(kind, analysis, (), part).result
        watch.begin("picture")
        return analysis, result

    return drawings.make(scheme, effort, options, certify)


def check_steps(scheme: Scheme, steps: Sequence[SmoothingStep], effort: Effort) -> tuple[Result, Result]:
    """The results of a scheme and of what the last of several smoothing steps makes of it, checked independently.

    Raises DisagreementError where the checker says no, and where both converge and their exponents do not differ by the
    orders that the steps gain, or differ by more where a step promises no more.
    """
    before, after = check(scheme, (), effort).result, check(steps[-1].scheme, (), effort).result
    orders, one, other = sum(step.orders for step in steps), before.holder, after.holder
    both = before.convergent is after.convergent is Verdict.PROVED
    exactly = all(step.exactly for step in steps)
    if both and one and other and not (_reaches(other, -orders, one) and (_reaches(one, orders, other) or not exactly)):
        raise DisagreementError(f"the exponents of two schemes do not differ by {orders}")
    return before, after


def _reaches(one: Exponent, gain: int, other: Exponent) -> bool:
    """Whether the bounds admit that one exponent with a gain is at most the other."""
    return one.lower is None or other.upper is None or Fraction(one.lower) + gain <= Fraction(other.upper)


def certified(kind: Kind, analysis: Analysis, expectations: Sequence[Expectation], effort: Effort) -> Checked:
    """What the stages have found, every verdict of it checked; what cannot be certified is undecided.

    Raises DisagreementError.
    """
    assert kind.proofs is not None, "a kind that finds something proves it"
    watch.begin("certificate")
    proofs = kind.proofs(analysis)
    certificate = _verified(proofs, effort)
    dear = OUT_OF_TIME if effort.seconds_left() is not None else TOO_DEAR
    findings = certificate.findings if certificate is not None else analysis.findings
    claims = certificate.claims if certificate is not None else [()] * len(findings)
    gathered = gather(tuple(map(partial(_claimed, dear), findings, claims, proofs.numbers)))
    result = replace(
        gathered,
        kind=kind.name,
        stopped="budget" if effort.struck or any(f.reason == OUT_OF_TIME for f in gathered.findings) else None,
        facts=analysis.facts,
        hints=analysis.hints,
        holder=_with_digits(gathered.holder),
        sobolev=_with_digits(gathered.sobolev),
        holder_at_zero=_with_digits(gathered.holder_at_zero),
    )
    judgements = judged(expectations, result)
    result = replace(result, expectations=judgements, status=status(result.convergent, judgements))
    return Checked(result, None if certificate is None else certificate.document)


def _verified(proofs: Proofs, effort: Effort) -> Certificate | None:
    """The certificate, without the claims that the checker finds too dear and all that rests on them.

    Under a clock the claims are checked in the order of the questions, and those before the first that fails are kept.
    None where nothing is left. Raises DisagreementError.
    """
    dear, seconds = set[int](), effort.seconds_left()
    while (certificate := proofs.certificate(dear, seconds)) is not None:
        outcome = _outcome(certificate.document, effort)
        if outcome.verified:
            return certificate
        if outcome.claim is None:
            return None
        if seconds is not None:
            return certificate.first(outcome.claim)
        dear.add(certificate.made[outcome.claim])
    return None


def _outcome(document: Mapping[str, Any], effort: Effort) -> Outcome:
    """The checker's outcome: verified, or too much work. Raises DisagreementError where the checker says no."""
    watch.begin("checker")
    outcome = check_document(document, effort.time_to_check())
    if not outcome.verified and not outcome.exhausted:
        raise DisagreementError(f"the checker rejects the certificate: {outcome.line}")
    return outcome


def judged(expectations: Sequence[Expectation], result: Result) -> tuple[Judgement, ...]:
    """The judgements of expectations by a result, closed forms compared exactly, however they are written."""
    return tuple(Judgement(expectation=e, verdict=judge(compare, e, result)) for e in expectations)


def _claimed(dear: str, finding: Finding, claims: tuple[int, ...], made: Sequence[int]) -> Finding:
    """With the numbers of its claims, which have its proof, a long one; undecided where no verified claim says it.

    `made` are the claims that say it, verified or not, and `dear` is the reason where they are not.
    """
    if finding.verdict in DECIDED and not claims:
        return uncertified(finding, dear if made else UNWRITTEN)
    return replace(finding, claims=claims, proof={}, otherwise=()) if claims or finding.proof else finding


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

    Where the proof is too dear, what takes next to nothing to prove; nothing where that is too dear as well. Raises
    DisagreementError where the checker says no.
    """
    from subdiv_cli.jsr.answer import answer  # numpy comes with it

    watch.begin("joint spectral radius")
    radius = answer(matrices, effort)
    document = family_certificate(matrices, radius, effort.seconds_left())
    if not radius.proof or (document is not None and _outcome(document, effort).verified):
        return CheckedRadius(radius, document)
    why = TOO_DEAR
    if effort.seconds_left() is not None:
        why, radius = OUT_OF_TIME, replace(radius, stopped="budget")
    rough = answer(matrices, UNHURRIED, rough=True)
    document = family_certificate(matrices, rough)
    if document is None or not _outcome(document, UNHURRIED).verified:
        rough, document = FamilyRadius(order=radius.order, letters=radius.letters), None
    return CheckedRadius(replace(rough, left_out=why, stopped=radius.stopped), document)
