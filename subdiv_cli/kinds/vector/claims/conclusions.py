"""Findings on polynomials, smoothness and exponents as claims."""

from __future__ import annotations

from fractions import Fraction

from subdiv_cli.certificate.claims import Json
from subdiv_cli.certificate.radius import root_fields
from subdiv_cli.kinds.vector import rules
from subdiv_cli.kinds.vector.claims.proof import VectorProof
from subdiv_cli.kinds.vector.witnesses import (
    EigenSequencesProof,
    SequenceRadiusProof,
    SequenceSpaceData,
    VectorAttainedProof,
    VectorDerivedProof,
    VectorDerivedWitness,
)
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.closed import rational, rationals
from subdiv_cli.model.findings import proof_of


def eigen_sequences(proof: VectorProof, finding: Finding) -> list[int]:
    """The claims of SD702: the order of the eigen-sequences, and the degree of generation."""
    k, r, p, m = rules.EIGEN_SEQUENCES.witness_of(finding)["order"], proof.dimension, proof.p, proof.size
    uses = [proof.constants()]
    if not r:
        return [proof.claims.prove("eigen-sequences", {"order": k}, uses=uses)]
    data = proof_of(finding, EigenSequencesProof)
    witness: Json = {
        "sequences": [
            [[rational(x) for coefficient in y for x in coefficient] for y in rows] for rows in data["sequences"]
        ],
        "multipliers": rationals(data["multipliers"]),
        "functional": rationals(data["functional"]),
    }
    work = (r + 1) * (k + 1) ** 3 * (p * m * m + proof.length) + proof.entries * (k + 1)
    claim = proof.claims.prove("eigen-sequences", {"order": k}, witness, uses, work)
    return [claim, proof.claims.prove("generation", {"degree": k - 1}, uses=[claim])]


def mean_matrix(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD703."""
    statement = {"holds": finding.verdict is Verdict.PROVED}
    work = proof.entries + proof.size**4
    return [proof.claims.prove("mean-matrix", statement, uses=[proof.constants()], work=work)]


def smoothness(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD708: all limits are C^n."""
    witness, uses = rules.SMOOTHNESS.witness_of(finding), [proof.convergent()]
    n = witness["order"]
    if witness["by"] == rules.CONVERGENCE.code:
        return [proof.claims.prove("continuous", {"property": "smooth", "order": n}, uses=uses)]
    return [proof.claims.prove("smooth", {"order": n}, uses=[*uses, *proof.growth()])]


def next_smoothness(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD709: not all limits are C^n."""
    witness = rules.NEXT_SMOOTHNESS.witness_of(finding)
    n, word = witness["order"], witness["word"]
    growth = proof.facts.witness(rules.STENCIL_RADIUS)
    k, uses = growth["order"], [proof.convergent()]
    if "root" in growth:
        x = growth["root"]["low"] * proof.p ** (min(n, k) * growth["length"])
        if x >= 1 if n < k else x > 1:
            return [proof.claims.prove("not-smooth", {"order": n}, uses=[*uses, *proof.growth()])]
    bound = Fraction(1, proof.p ** (n * len(word)))
    if n >= k:
        bound = proof.facts.witness(rules.HOLDER_UPPER)["radius"]
    below = proof.word(k, _growing(proof), word, bound)
    return [proof.claims.prove("not-smooth", {"order": n}, uses=[*uses, *below])]


def _growing(proof: VectorProof) -> SequenceSpaceData:
    """The space of differences of limit stencils."""
    return proof_of(proof.facts[rules.STENCIL_RADIUS], SequenceRadiusProof)["space"]


def holder_lower(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD710: the Hölder exponent from below, or what it is where the radius is known."""
    witness = rules.HOLDER_LOWER.witness_of(finding)
    if "root" in witness:
        return [_exponent(proof)]
    statement: Json = {"length": witness["length"], "bound": rational(witness["bound"])}
    return [proof.claims.prove("holder-lower", statement, uses=[proof.convergent(), *proof.growth()])]


def holder_upper(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD711: the Hölder exponent from above."""
    if "root" in proof.facts.witness(rules.HOLDER_LOWER):
        return [_exponent(proof)]
    witness, k = rules.HOLDER_UPPER.witness_of(finding), proof.facts.witness(rules.STENCIL_RADIUS)["order"]
    below = proof.word(k, _growing(proof), witness["word"], witness["radius"])
    statement: Json = {"length": witness["length"], "bound": rational(witness["radius"])}
    return [proof.claims.prove("holder-upper", statement, uses=[proof.convergent(), *below])]


def _exponent(proof: VectorProof) -> int:
    """The claim that says what α is."""
    witness = proof.facts.witness(rules.HOLDER_LOWER)
    statement = {"length": witness["length"], **root_fields(witness["root"])}
    return proof.claims.prove("holder-root", statement, uses=[proof.convergent(), *proof.growth()])


def attained(proof: VectorProof, finding: Finding) -> list[int]:
    """The claim of SD712: the Hölder exponent is attained, or is not."""
    witness, data = rules.HOLDER_ATTAINED.witness_of(finding), proof_of(finding, VectorAttainedProof)
    k, space = witness["order"], data["space"]
    holds = finding.verdict is Verdict.PROVED
    statement = {"property": "attained", "holds": holds}
    if not holds:
        grown = proof.defective(k, space, witness)
        return [proof.claims.prove("not-attained", statement, uses=[*grown, _exponent(proof)])]
    bounded = proof.radius(k, space, data["radius"])
    return [proof.claims.prove("attained", statement, uses=[*bounded, _exponent(proof)])]


def derived_schemes(proof: VectorProof, finding: Finding) -> list[int]:
    """The claims of SD713: derived schemes one after the other, the norm of the last one, and what follows."""
    witness = rules.DERIVED_SCHEMES.witness_of(finding)
    norm = derived_norm(proof, witness, proof_of(finding, VectorDerivedProof), proof.length)
    order = witness["order"]
    return [norm, proof.claims.prove("derived-smooth", {"property": "smooth", "order": order}, uses=[norm])]


def derived_norm(
    proof: VectorProof,
    witness: VectorDerivedWitness,
    data: VectorDerivedProof,
    length: int,
    rule: str = "derived",
    last: int | None = None,
) -> int:
    """The claim on the norm of a derived mask; those before are made by a rule, from a mask that the last one has."""
    m, p, before = proof.size, proof.p, length
    steps = zip(data["transformations"], data["dimensions"], data["starts"], data["masks"], strict=True)
    for n, step in enumerate(steps, 1):
        transformation, r, start, mask = step
        before, length = length, len(mask)
        work = (before + length + p + 2) * 4 * m**3 + (before * m * m + p * m * m) * (r + 1)
        hints: Json = {"transformation": rationals(transformation), "dimension": r, "start": start}
        hints["coefficients"] = rationals(mask)
        statement: Json = {"property": "derived", "order": n}
        last = proof.claims.prove(rule, statement, hints, [] if last is None else [last], work)
    assert last is not None
    n, level = witness["derivations"], witness["level"]
    size = (length - 1) * (p**level - 1) // (p - 1) + 1
    statement = {"order": n, "level": level, "norm": rational(witness["norm"])}
    work = 2 * m**3 * length * size + m * m * size
    return proof.claims.prove("derived-norm", statement, uses=[last], work=work)
