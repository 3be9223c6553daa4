"""Findings on norms and on Gram sequences of masks on Z^s as claims."""

from __future__ import annotations

from math import prod

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.radius import spelled
from subdiv_cli.kinds.multivariate import rules
from subdiv_cli.kinds.multivariate.witnesses import GramProof, MatrixNormsProof, PlacedNumbers, QuotientsProof
from subdiv_cli.model import Finding
from subdiv_cli.model.closed import rational
from subdiv_cli.model.findings import proof_of
from subdiv_cli.spaces.lattice import Index


def matrix_norm(claims: Claims, finding: Finding, sum_rules: int) -> int:
    """The number of the claim on the matrix norm; `sum_rules` is that of the claim on their order."""
    witness, proof = rules.MATRIX_NORMS.witness_of(finding), proof_of(finding, MatrixNormsProof)
    statement = {
        "property": "matrix-norm",
        "order": witness["order"],
        "level": witness["level"],
        "norm": rational(witness["norm"]),
    }
    hints = {"power": witness["power"], "entries": spelled(proof["entries"])}
    return claims.add("matrix-norm", statement, hints, [sum_rules], proof["work"])


def directional_norms(claims: Claims, finding: Finding, c: int) -> list[int]:
    """The numbers of the claims on the quotients by one directional factor, with the dilation cI."""
    numbers, witness = [], rules.DIRECTIONAL_NORMS.witness_of(finding)
    quotients = proof_of(finding, QuotientsProof)["quotients"]
    each = zip(witness["directions"], witness["levels"], witness["norms"], quotients, strict=True)
    for theta, level, norm, quotient in each:
        statement = {"direction": spelled(theta), "level": level, "norm": rational(norm)}
        work = len(quotient) * (2 * c + _length(quotient, c, level))
        numbers.append(claims.prove("directional-norm", statement, {"quotient": spelled(quotient)}, work=work))
    return numbers


def pair_norms(claims: Claims, finding: Finding, c: int) -> list[int]:
    """The numbers of the claims on the quotients by pairs of directional factors, with the dilation cI."""
    numbers, witness = [], rules.DIRECTIONAL_SMOOTHNESS.witness_of(finding)
    quotients = proof_of(finding, QuotientsProof)["quotients"]
    each = zip(witness["directions"], witness["levels"], witness["norms"], quotients, strict=True)
    for directions, level, norm, quotient in each:
        statement = {
            "property": "pair-norm",
            "directions": spelled(directions),
            "level": level,
            "norm": rational(norm),
        }
        work = len(quotient) * (c + c**2 + c + _length(quotient, c, level))
        numbers.append(claims.add("pair-norm", statement, {"quotient": spelled(quotient)}, uses=[], work=work))
    return numbers


def _length(quotient: PlacedNumbers, c: int, level: int) -> int:
    """The number of indices in the box of the iterated mask Π_(i<level) q(z^(c^i)), q a tuple of terms."""
    growth = (c**level - 1) // (c - 1)
    spans = [max(column) - min(column) for column in _columns(quotient)]
    return prod(span * growth + 1 for span in spans)


def _columns(terms: PlacedNumbers) -> list[Index]:
    """The indices of the terms, a tuple for each coordinate."""
    return list(zip(*(index for index, _ in terms), strict=True))


def gram_sequence(claims: Claims, finding: Finding, statement: Json, convergent: int, terms: int) -> int:
    """The number of the claim on the Gram sequence.

    `convergent` is the number of the claim that S converges, `terms` how many terms the mask has.
    """
    proof, uses = proof_of(finding, GramProof), [convergent]
    g, columns = proof["gram"], _columns(proof["gram"])
    work = terms**2 + proof["correlations"] * len(g)
    if "tree" not in proof:
        witness = rules.STABILITY.witness_of(finding)
        n = witness["order"]
        hints: Json = {"gram": spelled(g), "point": spelled(witness["zero"]), "order": n}
        return claims.prove("gram-unstable", statement, hints, uses, work + len(g) + n**2)
    tree = proof["tree"]
    lengths = [2 * max(map(abs, column)) + 1 for column in columns]
    work += (len(tree) + 2 ** len(columns)) * prod(lengths) * max(lengths)
    return claims.prove("gram-stable", statement, {"gram": spelled(g), "tree": spelled(tree)}, uses, work)
