"""Findings on convergence, smoothness and the Hölder exponent as claims."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import lcm

from subdiv_cli.certificate.claims import rational
from subdiv_cli.certificate.proof import Proof
from subdiv_cli.certificate.structure import eigen_condition, residue_sums
from subdiv_cli.certificate.witness import as_integer, as_rational, as_word
from subdiv_cli.model import Data, Finding, Verdict


def contractivity(proof: Proof, finding: Finding) -> list[int]:
    if finding.verdict is Verdict.PROVED:
        return [proof.contraction(proof.last, finding.witness)]
    return [proof.obstacle(proof.last, as_integer(finding.witness["nu"]) - 1, finding.witness)]


def convergence(proof: Proof, finding: Finding) -> list[int]:
    if finding.verdict is Verdict.PROVED:
        return [
            proof.add("converges", {"holds": True}, uses=[proof.contraction(0, finding.witness)], name="convergent")
        ]
    by = finding.witness["by"]
    if by == "SD301":
        reason = proof.obstacle(0, 0, finding.witness)
    else:
        (reason,) = {"SD101": residue_sums, "SD202": eigen_condition}[str(by)](proof, proof.found[str(by)])
    return [proof.add("diverges", {"holds": False}, uses=[reason], name="convergent")]


def smoothness(proof: Proof, finding: Finding) -> list[int]:
    if finding.verdict is Verdict.REFUTED:
        return _not_smooth(proof, 0, finding.witness)
    order = as_integer(finding.witness["order"])
    if finding.witness["by"] == "SD201":
        uses = [proof.contraction(0, proof.found["SD201"].witness)]
    else:
        uses = [proof.contraction(proof.last, proof.contractions[-1].witness), *proof.reductions]
    return [proof.add("smooth", {"order": order}, uses=uses)]


def next_smoothness(proof: Proof, finding: Finding) -> list[int]:
    return _not_smooth(proof, as_integer(finding.witness["order"]), finding.witness)


def _not_smooth(proof: Proof, order: int, witness: Mapping[str, Data]) -> list[int]:
    stable = proof.last_stable()
    obstacle = proof.obstacle(proof.last, order, witness)
    return [proof.add("not-smooth", {"order": order}, uses=[n, obstacle, *proof.reductions]) for n in stable]


def holder_lower(proof: Proof, finding: Finding) -> list[int]:
    k, level = as_integer(finding.witness["difference_order"]), as_integer(finding.witness["level"])
    norm = as_rational(finding.witness["norm"])
    uses = [proof.norm(proof.last, k, level, norm * proof.p ** ((k - 1) * level)), proof.sum_rules(proof.last)]
    statement = {"level": level, "norm": rational(norm)}
    below = proof.add("holder-lower", statement, uses=[*uses, *proof.reductions])
    if "word" not in finding.witness:
        return [below]
    word = as_word(finding.witness)
    length = lcm(len(word), level)
    above = _above(proof, word * (length // len(word)), norm ** (length // level))
    return [proof.add("holder-exact", statement, uses=[below, n], name="holder") for n in above] or [below]


def holder_upper(proof: Proof, finding: Finding) -> list[int]:
    if "word" in finding.witness:
        return _above(proof, as_word(finding.witness), as_rational(finding.witness["radius"]))
    k = as_integer(finding.witness["difference_order"])
    statement = {"length": 1, "radius": rational(Fraction(1, proof.p**k))}
    uses = [proof.sum_rules(proof.last), *proof.reductions]
    return [proof.add("holder-upper", statement, uses=[n, *uses]) for n in proof.last_stable()]


def _above(proof: Proof, word: Sequence[int], radius: Fraction) -> list[int]:
    uses = [proof.product(proof.last, word, radius), *proof.reductions]
    statement = {"length": len(word), "radius": rational(radius)}
    return [proof.add("holder-upper", statement, uses=[n, *uses]) for n in proof.last_stable()]
