"""SD201: does S converge uniformly?

Theorem (Dyn 1992, Theorem 3.2, for any arity p): S converges uniformly iff its residue sums are 1 and
‖((1/p)S_1)^L‖∞ < 1 for some L. Both directions need no stability.

Proved by SD301 at any ν: contraction of (1/p)S_ν makes S_(ν-1), …, S_0 converge (Theorem 3.4), and the residue sums are
among its hypotheses. Refuted by the residue sums (SD101), by a product of transition matrices that keeps (1/p)S_1 from
contracting (SD301 at ν = 1), or by the eigen-condition (SD202).

Witness: `by`, the code of the finding that decides, with its own witness.
"""

from __future__ import annotations

from subdiv_cli.model import Finding, Verdict
from subdiv_cli.quantities.scalar import ScalarNumbers
from subdiv_cli.stages.stage import ContradictionError, Facts, integer, power, scaled


def run(numbers: ScalarNumbers, facts: Facts) -> tuple[Finding, ...]:
    contractivity = facts.get("SD301", ())
    conditions = [*facts.get("SD101", ()), *contractivity[:1], *facts.get("SD202", ())]
    against = next((finding for finding in conditions if finding.verdict is Verdict.REFUTED), None)
    proof = next((finding for finding in contractivity if finding.verdict is Verdict.PROVED), None)
    if against is not None and proof is not None:
        raise ContradictionError(f"S converges by {proof.code} and diverges by {against.code}")
    if proof is not None:
        norm = power(scaled(numbers.p, integer(proof, "nu")), integer(proof, "level"))
        return (_answer(Verdict.PROVED, f"S converges uniformly: the residue sums are 1 and {norm} < 1", proof),)
    if against is not None:
        return (_answer(Verdict.REFUTED, f"S diverges: {against.statement}", against),)
    reason = contractivity[0].reason if contractivity else None
    return (_answer(Verdict.UNDECIDED, "does S converge uniformly?", None, reason=reason),)


def _answer(answer: Verdict, statement: str, by: Finding | None, reason: str | None = None) -> Finding:
    return Finding(
        code="SD201",
        name="convergence",
        verdict=answer,
        statement=statement,
        source="Dyn 1992, Theorem 3.2" if by is None or by.code == "SD301" else by.source,
        reason=reason,
        witness={} if by is None else {"by": by.code, **by.witness},
    )
