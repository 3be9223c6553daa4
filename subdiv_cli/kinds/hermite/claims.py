"""The claims of findings on Hermite schemes, as FORMAT.md in this kind's folder says; `claims_of` begins."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from subdiv_cli.certificate.claims import Json, Proofs, proofs
from subdiv_cli.kinds.hermite import rules
from subdiv_cli.kinds.hermite.witnesses import TaylorProof
from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.vector import rules as vector
from subdiv_cli.kinds.vector.claims import CLAIMS as OF_VECTORS
from subdiv_cli.kinds.vector.claims.conclusions import derived_norm
from subdiv_cli.kinds.vector.claims.proof import VectorProof
from subdiv_cli.kinds.vector.text import canonical
from subdiv_cli.kinds.vector.witnesses import SequenceRadiusProof
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.closed import rationals
from subdiv_cli.model.findings import proof_of


class HermiteProof(VectorProof):
    """A certificate under construction: each method returns the numbers of claims, made if there are none yet."""

    def __init__(self, mask: Json, findings: Sequence[Finding]) -> None:
        super().__init__(mask, findings)
        self._jets: dict[int, int] = {}

    def jet(self, finding: Finding) -> int:
        """The claim that introduces the operators on the space of a derivative."""
        j = rules.JET_RADIUS.witness_of(finding)["order"]
        if j not in self._jets:
            start = self.facts.witness(vector.LIMIT_STENCILS)["start"]
            space = proof_of(finding, SequenceRadiusProof)["space"]
            witness, work = self.spanned(space, abs(start) + self.stencil_width() + j + 3)
            uses = [self.constants(), self.stencils()]
            statement = {"property": "jet", "family": self.new_family(), "component": j}
            self._jets[j] = self.claims.prove("jet", statement, witness, uses, work)
        return self._jets[j]

    def jet_radius(self, finding: Finding) -> list[int]:
        """The claims on the radius of a derivative, and on its space."""
        proof = proof_of(finding, SequenceRadiusProof)
        return self.radius_on(self.jet(finding), proof["space"], proof["radius"])


def spectral_condition(proof: HermiteProof, finding: Finding) -> list[int]:
    """The claim of SD714."""
    witness = rules.SPECTRAL_CONDITION.witness_of(finding)
    k = witness["order"]
    statement = {"order": k, "holds": finding.verdict is Verdict.PROVED}
    work = (k + 1) ** 2 * (proof.entries + proof.p * proof.size)
    return [proof.claims.prove("spectral", statement, {"shifts": rationals(witness["shifts"])}, work=work)]


def hermite_convergence(proof: HermiteProof, finding: Finding) -> list[int]:
    """The claim of SD716: S is Hermite convergent, or is not."""
    witness, holds = rules.HERMITE_CONVERGENCE.witness_of(finding), finding.verdict is Verdict.PROVED
    radii, d, by = proof.facts.all(rules.JET_RADIUS), proof.size, witness["by"]
    statement: Json = {"property": "hermite-convergent", "order": witness["order"], "holds": holds}
    if holds:
        uses = [proof.convergent(), *(claim for each in radii for claim in proof.jet_radius(each))]
        return [proof.claims.prove("hermite-converges", statement, uses=uses, work=d)]
    if by == vector.CONSTANTS.code:
        uses = [proof.constants()]
    elif by == vector.CONVERGENCE.code:
        uses = [proof.convergent()]
    else:
        j, word = witness["derivative"], witness["word"]
        (each,) = (each for each in radii if each.witness.get("order") == j)
        bound = Fraction(1, proof.p ** (j * len(word)))
        uses = proof.word_on(proof.jet(each), proof_of(each, SequenceRadiusProof)["space"], word, bound)
    return [proof.claims.prove("hermite-diverges", statement, uses=uses, work=d)]


def taylor_scheme(proof: HermiteProof, finding: Finding) -> list[int]:
    """The claims of SD717: the Taylor mask, those derived from it, the norm of the last one, and what follows."""
    witness, data, d = rules.TAYLOR_SCHEME.witness_of(finding), proof_of(finding, TaylorProof), proof.size
    length = len(data["taylor"])
    hints: Json = {"start": data["start"], "coefficients": rationals(data["taylor"])}
    work = (proof.length + length + proof.p + 2) * 4 * d**3 + 2 * (length * d * d + proof.p * d * d)
    taylor = proof.claims.prove("taylor", {}, hints, [proof.constants()], work)
    norm = derived_norm(proof, witness, data, length, "taylor-derived", taylor)
    statement: Json = {"property": "hermite-convergent", "order": d - 1, "holds": True}
    smooth: Json = {"property": "smooth", "order": witness["order"]}
    return [
        norm,
        proof.claims.prove("taylor-converges", statement, uses=[norm]),
        proof.claims.prove("taylor-smooth", smooth, uses=[norm]),
    ]


CLAIMS: dict[str, Callable[[Any, Finding], list[int]]] = {
    **OF_VECTORS,
    rules.SPECTRAL_CONDITION.code: spectral_condition,
    rules.JET_RADIUS.code: HermiteProof.jet_radius,
    rules.HERMITE_CONVERGENCE.code: hermite_convergence,
    rules.TAYLOR_SCHEME.code: taylor_scheme,
}
"""For each code what makes the claims of a decided finding."""


def claims_of(analysis: Analysis) -> Proofs:
    """The claims that prove what was found of a Hermite mask."""
    mask: dict[str, Any] = dict(canonical(analysis.scheme))
    proof = HermiteProof(mask, analysis.findings)
    return proofs(proof.claims, mask, analysis.findings, lambda finding: CLAIMS[finding.code](proof, finding))
