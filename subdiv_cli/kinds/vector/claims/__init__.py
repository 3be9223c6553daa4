"""The claims of findings on vector schemes, as FORMAT.md in this kind's folder says; `claims_of` begins."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from subdiv_cli.certificate.claims import Proofs, proofs
from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.vector import rules
from subdiv_cli.kinds.vector.claims import conclusions
from subdiv_cli.kinds.vector.claims.proof import VectorProof
from subdiv_cli.kinds.vector.text import canonical
from subdiv_cli.model import Finding

CLAIMS: dict[str, Callable[[VectorProof, Finding], list[int]]] = {
    rules.CONSTANTS.code: lambda proof, _: [proof.constants()],
    rules.EIGEN_SEQUENCES.code: conclusions.eigen_sequences,
    rules.MEAN_MATRIX.code: conclusions.mean_matrix,
    rules.DECAY_RADIUS.code: lambda proof, _: proof.decay(),
    rules.CONVERGENCE.code: lambda proof, _: [proof.convergent()],
    rules.LIMIT_STENCILS.code: lambda proof, _: [proof.stencils()],
    rules.STENCIL_RADIUS.code: lambda proof, _: proof.growth(),
    rules.SMOOTHNESS.code: conclusions.smoothness,
    rules.NEXT_SMOOTHNESS.code: conclusions.next_smoothness,
    rules.HOLDER_LOWER.code: conclusions.holder_lower,
    rules.HOLDER_UPPER.code: conclusions.holder_upper,
    rules.HOLDER_ATTAINED.code: conclusions.attained,
    rules.DERIVED_SCHEMES.code: conclusions.derived_schemes,
}
"""For each code what makes the claims of a decided finding."""


def claims_of(analysis: Analysis) -> Proofs:
    """The claims that prove what was found of a mask of matrices."""
    mask: dict[str, Any] = dict(canonical(analysis.scheme))
    proof = VectorProof(mask, analysis.findings)
    return proofs(proof.claims, mask, analysis.findings, lambda finding: CLAIMS[finding.code](proof, finding))
