"""Findings on the mask itself as claims: sum rules and polynomials, independence and stability, spectra."""

from __future__ import annotations

from subdiv_cli.certificate.claims import Json
from subdiv_cli.certificate.witness import as_integer, as_polynomial, as_rationals, as_tuple
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.closed import rational


def residue_sums(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD101: the residue sums of the mask."""
    sums = [rational(s) for s in as_rationals(finding.witness["sums"])]
    return [proof.add("residue-sums", {"mask": 0, "sums": sums}, work=proof.degrees[0] + 1)]


def generation(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD103: the generation degree, or the sum rules that refute it."""
    if finding.verdict is Verdict.REFUTED:
        return [proof.sum_rules(0)]
    degree = as_integer(finding.witness["degree"])
    return [proof.add("generation", {"degree": degree}, uses=[proof.sum_rules(0)])]


def reproduction(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD104: the reproduction degree, or the sum rules that refute it."""
    if finding.verdict is Verdict.REFUTED:
        return [proof.sum_rules(0)]
    degree = as_integer(finding.witness["degree"])
    work = (proof.degrees[0] + 1) * (degree + 2) ** 2
    return [proof.add("reproduction", {"degree": degree}, uses=[proof.sum_rules(0)], work=work)]


def derived(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD105: the sum rules, and the symbol of the last derived scheme."""
    if not proof.orders[0]:
        return [proof.sum_rules(0)]
    start, mask = (as_tuple(finding.witness[key])[-1] for key in ("starts", "masks"))
    statement = {"mask": 0, "nu": len(as_tuple(finding.witness["masks"])), "symbol": as_polynomial(start, mask)}
    work = (proof.degrees[0] + 1) * (proof.orders[0] + 1) * proof.p
    return [proof.sum_rules(0), proof.add("derived", statement, uses=[proof.sum_rules(0)], work=work)]


def independence(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD401: the integer translates of φ are linearly independent, or are not."""
    statement, work = {"mask": 0, "holds": finding.verdict is Verdict.PROVED}, (proof.degrees[0] + 1) ** 2
    if finding.verdict is Verdict.PROVED:
        return proof.independent(0, proof.found[rules.STABILITY].witness)
    witness: Json = {"cycle": finding.witness.get("cycle")}
    if "gcd" in finding.witness:
        witness = {"factor": as_polynomial(0, finding.witness["gcd"])}
    return [proof.add("dependent", statement, witness, work=work, name="independent")]


def stability(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD402: the integer translates of φ are stable, or are not."""
    if finding.verdict is Verdict.PROVED:
        return proof.stable(0, finding.witness)
    witness: Json = {"cycle": finding.witness.get("cycle")}
    if "circle_factor" in finding.witness:
        witness = {"factor": as_polynomial(0, finding.witness["circle_factor"])}
    work = (proof.degrees[0] + 1) ** 3
    return [proof.add("unstable", {"mask": 0, "holds": False}, witness, work=work, name="stable")]


def _spectral(proof: Proof, nu: int, holds: bool) -> int:
    order = -(-proof.degrees[0] // (proof.p - 1)) + 1
    statement = {"nu": nu, "holds": holds}
    return proof.add("eigen-condition", statement, uses=[proof.sum_rules(0)], work=proof.p * order**4)


def eigen_condition(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD202: the eigen-condition for the largest ν for which it holds, which contains that for ν = 0."""
    if finding.verdict is not Verdict.PROVED:
        return [_spectral(proof, 0, False)]
    return [_spectral(proof, _largest(proof), True)]


def smoothness_spectrum(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD304: the largest ν for which the eigen-condition holds, and that it fails for the next."""
    largest, k = as_integer(finding.witness["nu"]), proof.orders[0]
    if k < 2:
        return [proof.sum_rules(0)]
    following = [_spectral(proof, largest + 1, False)] if largest + 1 < k else []
    return [_spectral(proof, largest, True), *following] if largest else following


def _largest(proof: Proof) -> int:
    found = proof.found[rules.SMOOTHNESS_SPECTRUM]
    return as_integer(found.witness["nu"]) if "nu" in found.witness else 0
