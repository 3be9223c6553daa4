"""The finding on the Sobolev exponent as a claim."""

from __future__ import annotations

from subdiv_cli.certificate.witness import as_polynomial, as_rational
from subdiv_cli.kinds.scalar.claims.proof import Proof
from subdiv_cli.model import Finding
from subdiv_cli.model.closed import rational


def sobolev(proof: Proof, finding: Finding) -> list[int]:
    """None where the witness of stability was too costly."""
    found, p = finding.witness, proof.p
    degree = proof.degrees[proof.last] - proof.orders[proof.last] * (p - 1)
    order = degree // (p - 1) + 1
    statement = {
        "polynomial": as_polynomial(0, found["polynomial"]),
        "low": rational(as_rational(found["low"])),
        "high": rational(as_rational(found["high"])),
    }
    hints = {"cofactor": as_polynomial(0, found["cofactor"])}
    uses = [proof.sum_rules(proof.last), *proof.reductions]
    work = (degree + 1) ** 2 + 4 * order**3 + 20
    return [proof.add("sobolev", statement, hints, uses=[n, *uses], work=work) for n in proof.last_stable()]
