"""Findings on the mask itself as claims: sum rules and polynomials, independence and stability, spectra."""

from __future__ import annotations

from subdiv_cli.certificate.claims import Json, polynomial
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.model import DECIDED, Finding, Verdict
from subdiv_cli.model.closed import rational


def residue_sums(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD101: the residue sums of the mask."""
    sums = [rational(s) for s in rules.RESIDUE_SUMS.witness_of(finding)["sums"]]
    return [proof.add("residue-sums", {"mask": 0, "sums": sums}, work=proof.degrees[0] + 1)]


def generation(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD103: the generation degree, or the sum rules that refute it."""
    if finding.verdict is Verdict.REFUTED:
        return [proof.sum_rules(0)]
    degree = rules.GENERATION.witness_of(finding)["degree"]
    return [proof.add("generation", {"degree": degree}, uses=[proof.sum_rules(0)])]


def reproduction(proof: Proof, finding: Finding) -> list[int]:
    """The claim of SD104: the reproduction degree, or the sum rules that refute it."""
    if finding.verdict is Verdict.REFUTED:
        return [proof.sum_rules(0)]
    degree = rules.REPRODUCTION.witness_of(finding)["degree"]
    work = (proof.degrees[0] + 1) * (degree + 2) ** 2
    return [proof.add("reproduction", {"degree": degree}, uses=[proof.sum_rules(0)], work=work)]


def derived_schemes(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD105: the sum rules, and the symbol of the last derived scheme."""
    if not proof.orders[0]:
        return [proof.sum_rules(0)]
    derived = rules.DERIVED_SCHEMES.witness_of(finding)
    symbol = polynomial(derived["starts"][-1], derived["masks"][-1])
    statement = {"mask": 0, "nu": len(derived["masks"]), "symbol": symbol}
    work = (proof.degrees[0] + 1) * (proof.orders[0] + 1) * proof.p
    return [proof.sum_rules(0), proof.add("derived", statement, uses=[proof.sum_rules(0)], work=work)]


def independence(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD401: the integer translates of φ are linearly independent, or are not."""
    statement, work = {"mask": 0, "holds": finding.verdict is Verdict.PROVED}, (proof.degrees[0] + 1) ** 2
    if finding.verdict is Verdict.PROVED:
        return proof.independent(0, proof.facts.witness(rules.STABILITY))
    witness = rules.INDEPENDENCE.witness_of(finding)
    hint: Json = {"factor": polynomial(0, witness["gcd"])} if "gcd" in witness else {"cycle": witness["cycle"]}
    return [proof.add("dependent", statement, hint, work=work, name="independent")]


def stability(proof: Proof, finding: Finding) -> list[int]:
    """The claims of SD402: the integer translates of φ are stable, or are not."""
    witness = rules.STABILITY.witness_of(finding)
    if finding.verdict is Verdict.PROVED:
        return proof.stable(0, witness)
    cycle = "cycle" in witness
    hint: Json = {"cycle": witness["cycle"]} if cycle else {"factor": polynomial(0, witness["circle_factor"])}
    work = (proof.degrees[0] + 1) ** 3
    return [proof.add("unstable", {"mask": 0, "holds": False}, hint, work=work, name="stable")]


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
    largest, k = rules.SMOOTHNESS_SPECTRUM.witness_of(finding)["nu"], proof.orders[0]
    if k < 2:
        return [proof.sum_rules(0)]
    following = [_spectral(proof, largest + 1, False)] if largest + 1 < k else []
    return [_spectral(proof, largest, True), *following] if largest else following


def _largest(proof: Proof) -> int:
    """The largest ν whose eigen-condition holds, 0 where that was not asked."""
    decided = proof.facts.verdict(rules.SMOOTHNESS_SPECTRUM) in DECIDED
    return proof.facts.witness(rules.SMOOTHNESS_SPECTRUM)["nu"] if decided else 0
