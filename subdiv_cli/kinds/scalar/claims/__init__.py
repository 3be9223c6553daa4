"""The certificate of a scalar mask: every finding that is proved or refuted becomes a claim (see FORMAT.md)."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from subdiv_cli.certificate.claims import Proofs, proofs
from subdiv_cli.kinds.kind import Analysis
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.claims import smoothness, structure, values
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.kinds.scalar.text import canonical
from subdiv_cli.model import Finding

CLAIMS: Mapping[str, Callable[[Proof, Finding], list[int]]] = {
    rules.RESIDUE_SUMS.code: structure.residue_sums,
    rules.SUM_RULES.code: lambda proof, _: [proof.sum_rules(0)],
    rules.GENERATION.code: structure.generation,
    rules.REPRODUCTION.code: structure.reproduction,
    rules.DERIVED_SCHEMES.code: structure.derived_schemes,
    rules.CONVERGENCE.code: smoothness.convergence,
    rules.EIGEN_CONDITION.code: structure.eigen_condition,
    rules.CONTRACTIVITY.code: smoothness.contractivity,
    rules.SMOOTHNESS.code: smoothness.smoothness,
    rules.NEXT_SMOOTHNESS.code: smoothness.next_smoothness,
    rules.SMOOTHNESS_SPECTRUM.code: structure.smoothness_spectrum,
    rules.JOINT_RADIUS.code: smoothness.joint_radius,
    rules.HOLDER_LOWER.code: smoothness.holder_lower,
    rules.HOLDER_UPPER.code: smoothness.holder_upper,
    rules.HOLDER_ATTAINED.code: smoothness.attained,
    rules.SOBOLEV.code: smoothness.sobolev,
    rules.INDEPENDENCE.code: structure.independence,
    rules.STABILITY.code: structure.stability,
    rules.REDUCTION.code: lambda proof, _: list(proof.reductions),
    rules.INTEGER_VALUES.code: values.integer_values,
    rules.LIMIT_STENCILS.code: values.stencils,
    rules.QUASI_INTERPOLATION.code: values.quasi_interpolation,
    rules.APPROXIMATION_ORDER.code: values.approximation_order,
    rules.INTERPOLATORY_ORDER.code: values.interpolatory_order,
    rules.ERROR_BOUND.code: values.error_bound,
    rules.HERMITE_BOUND.code: values.hermite_bound,
}
"""The functions that make the claims of a decided finding, by code; they make none where a witness is missing."""


def claims_of(analysis: Analysis) -> Proofs:
    """The claims that prove what was found of a scalar mask."""
    scheme, findings = analysis.scheme, analysis.findings
    proof = Proof(scheme.arity, scheme.degree, findings)
    return proofs(proof.claims, canonical(scheme), findings, lambda finding: CLAIMS[finding.code](proof, finding))
