"""SD201: does S converge uniformly, to a limit that is not zero for some data (Dyn 1992, section 2)?

Theorem (Dyn 1992, Theorem 3.2, for any arity p): S converges uniformly iff its residue sums are 1 and
‖((1/p)S_1)^L‖∞ < 1 for some L. Both directions need no stability, and the mask judged is S's own, never a reduced one.

Proved by the contraction of (1/p)S_ν at any ν <= k: it makes S_(ν-1), …, S_0 converge (Theorem 3.4), and the residue
sums are among its hypotheses. Refuted by the residue sums (SD101), by a product of transition matrices that keeps
(1/p)S_1 from contracting, or by the eigen-condition (SD202).

Witness: `by`, the code of the condition that decides, with its witness.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import ContradictionError, Facts
from subdiv_cli.kinds.scalar import rules
from subdiv_cli.kinds.scalar.numbers.scalar import ScalarNumbers
from subdiv_cli.kinds.scalar.stages.contractivity import contraction
from subdiv_cli.kinds.scalar.stages.stage import text
from subdiv_cli.model import Finding, Verdict
from subdiv_cli.model.findings import Witness

RULE = rules.CONVERGENCE


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    first = [contraction(numbers, 1)] if numbers.order else []
    conditions = (*facts.all(rules.RESIDUE_SUMS), *first, *facts.all(rules.EIGEN_CONDITION))
    against = next((finding for finding in conditions if finding.verdict is Verdict.REFUTED), None)
    proof = next((finding for finding in first if finding.verdict is Verdict.PROVED), None)
    if against is None and proof is None:
        later = (contraction(numbers, nu) for nu in range(2, numbers.order + 1))
        proof = next((finding for finding in later if finding.verdict is Verdict.PROVED), None)
    if against is not None and proof is not None:
        raise ContradictionError(f"S converges by {proof.code} and does not by {against.code}")
    if proof is not None:
        condition = text(proof, "condition")
        return (RULE.proved(f"S converges uniformly: the residue sums are 1 and {condition}", _witness(proof)),)
    if against is not None:
        limit = " to a non-zero limit" if against.code == rules.RESIDUE_SUMS.code else ""
        return (RULE.refuted(f"S does not converge uniformly{limit}: {against.statement}", _witness(against)),)
    return (RULE.undecided("does S converge uniformly?", first[0].reason or ""),)


def _witness(by: Finding) -> Witness:
    return {"by": by.code, **by.witness}
