"""Findings on norms and on Gram sequences of masks on Z^s as claims."""

from __future__ import annotations

from fractions import Fraction
from math import prod
from typing import cast

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.radius import spelled
from subdiv_cli.certificate.witness import as_integer, as_rational, as_tuple
from subdiv_cli.model import Data, Finding
from subdiv_cli.model.closed import rational


def matrix_norm(claims: Claims, finding: Finding, sum_rules: int) -> int:
    """The number of the claim on the matrix norm; `sum_rules` is that of the claim on their order."""
    found = finding.witness
    statement = {
        "property": "matrix-norm",
        "order": found["order"],
        "level": found["level"],
        "norm": rational(as_rational(found["norm"])),
    }
    witness = {"power": found["power"], "entries": spelled(finding.proof["entries"])}
    return claims.add("matrix-norm", statement, witness, [sum_rules], as_integer(finding.proof["work"]))


def directional_norms(claims: Claims, finding: Finding, c: int) -> list[int]:
    """The numbers of the claims on the quotients by one directional factor, with the dilation cI."""
    numbers = []
    each = zip(*(as_tuple(finding.witness[key]) for key in ("directions", "levels", "norms")), strict=True)
    for (theta, level, norm), quotient in zip(each, as_tuple(finding.proof["quotients"]), strict=True):
        statement = {"direction": spelled(theta), "level": level, "norm": rational(as_rational(norm))}
        work = len(as_tuple(quotient)) * (2 * c + _length(quotient, c, as_integer(level)))
        numbers.append(claims.prove("directional-norm", statement, {"quotient": spelled(quotient)}, work=work))
    return numbers


def pair_norms(claims: Claims, finding: Finding, c: int) -> list[int]:
    """The numbers of the claims on the quotients by pairs of directional factors, with the dilation cI."""
    numbers = []
    each = zip(*(as_tuple(finding.witness[key]) for key in ("directions", "levels", "norms")), strict=True)
    for (directions, level, norm), quotient in zip(each, as_tuple(finding.proof["quotients"]), strict=True):
        statement = {
            "property": "pair-norm",
            "directions": spelled(directions),
            "level": level,
            "norm": rational(as_rational(norm)),
        }
        work = len(as_tuple(quotient)) * (c + c**2 + c + _length(quotient, c, as_integer(level)))
        numbers.append(claims.add("pair-norm", statement, {"quotient": spelled(quotient)}, uses=[], work=work))
    return numbers


def _length(quotient: Data, c: int, level: int) -> int:
    """The number of indices in the box of the iterated mask Π_(i<level) q(z^(c^i)), q a tuple of terms."""
    indices = [as_tuple(as_tuple(term)[0]) for term in as_tuple(quotient)]
    growth = (c**level - 1) // (c - 1)
    spans = [cast(int, max(column)) - cast(int, min(column)) for column in zip(*indices, strict=True)]
    return prod(span * growth + 1 for span in spans)


def gram_sequence(claims: Claims, finding: Finding, statement: Json, convergent: int, terms: int) -> int:
    """The number of the claim on the Gram sequence.

    `convergent` is the number of the claim that S converges, `terms` how many terms the mask has.
    """
    proof, uses = finding.proof, [convergent]
    g = as_tuple(proof["gram"])
    columns = list(zip(*(cast("tuple[tuple[int, ...], Fraction]", term)[0] for term in g), strict=True))
    work = terms**2 + as_integer(proof["correlations"]) * len(g)
    if "tree" not in proof:
        n = as_integer(finding.witness["order"])
        witness: Json = {"gram": spelled(g), "point": spelled(finding.witness["zero"]), "order": n}
        return claims.prove("gram-unstable", statement, witness, uses, work + len(g) + n**2)
    tree = as_tuple(proof["tree"])
    lengths = [2 * max(map(abs, column)) + 1 for column in columns]
    work += (len(tree) + 2 ** len(columns)) * prod(lengths) * max(lengths)
    return claims.prove("gram-stable", statement, {"gram": spelled(g), "tree": spelled(tree)}, uses, work)
