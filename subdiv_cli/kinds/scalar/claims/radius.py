"""The joint spectral radius of the last difference scheme of a mask as claims (RADIUS.md)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from subdiv_cli.certificate.radius import Radii
from subdiv_cli.kinds.scalar.witnesses import JordanBlockWitness
from subdiv_cli.model.closed import rational
from subdiv_cli.model.proofs import RadiusProof

if TYPE_CHECKING:
    from subdiv_cli.kinds.scalar.claims.proof import Proof


def claims(proof: Proof, mask: int) -> list[int]:
    """The claims on the radius of D that a conclusion on this mask uses: a norm, or the radius and its family."""
    data, order = of_mask(proof, mask), proof.orders[mask]
    if data["rule"] == "norm":
        level = data["length"]
        scaled = data["bound"] * proof.p ** ((order - 1) * level)
        return [proof.norm(mask, order, level, scaled)]
    return claims_of(proof, mask, order, data)


def claims_of(proof: Proof, mask: int, nu: int, data: RadiusProof) -> list[int]:
    """The claims on the radius of S_(Δ^ν) of a mask, by a proof that is no norm, and on its family."""
    family = proof.family(mask, nu)
    number: int = proof.claims.statement(family)["family"]
    size = max(1, -(-(proof.degrees[mask] - nu * (proof.p - 1)) // (proof.p - 1)))
    uses = [family, proof.sum_rules(mask)] if data["rule"] == "positive-symbol" else []
    return [Radii(proof.claims, proof.families, proof.p, uses).claim(data, number, size), family]


def defective(proof: Proof, family: int, witness: JordanBlockWitness) -> int:
    """The claim that a product of a family has a Jordan block."""
    word, vector = list(witness["word"]), witness["vector"]
    statement = {
        "family": proof.claims.statement(family)["family"],
        "length": len(word),
        "value": rational(witness["value"]),
    }
    hints = {"word": word, "sign": witness["sign"], "vector": [rational(y) for y in vector]}
    order = len(vector)
    return proof.add("defective", statement, hints, work=len(word) * order**3 + 2 * order**2)


def of_mask(proof: Proof, mask: int) -> RadiusProof:
    """The proof that finding SD310 has for this mask, as plain data."""
    return proof.radius(mask)[1]
