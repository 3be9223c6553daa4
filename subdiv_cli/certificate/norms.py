"""Findings on norms of masks on Z^s as claims: matrix schemes of differences, quotients by two directional factors."""

from __future__ import annotations

from math import prod
from typing import cast

from subdiv_cli.certificate.claims import Claims, rational
from subdiv_cli.certificate.radius import spelled
from subdiv_cli.certificate.witness import as_integer, as_rational, as_tuple
from subdiv_cli.model import Finding


def matrix_norm(claims: Claims, finding: Finding, sum_rules: int) -> int:
    """The number of the claim on it; `sum_rules` is that of the claim on their order."""
    found = finding.witness
    statement = {
        "property": "matrix-norm",
        "order": found["order"],
        "level": found["level"],
        "norm": rational(as_rational(found["norm"])),
    }
    witness = {"power": found["power"], "entries": spelled(finding.proof["entries"])}
    return claims.add("matrix-norm", statement, witness, [sum_rules], as_integer(finding.proof["work"]))


def pairs(claims: Claims, finding: Finding, order: int, coset_sums: int, s: int, c: int) -> int:
    """The number of the claim that φ is C^order, order <= 1, in s variables with the dilation cI."""
    found, uses = finding.witness, [coset_sums]
    each = zip(*(as_tuple(found[key]) for key in ("directions", "levels", "norms")), strict=True)
    for (directions, level, norm), quotient in zip(each, as_tuple(finding.proof["quotients"]), strict=True):
        terms = as_tuple(quotient)
        indices = [as_tuple(as_tuple(term)[0]) for term in terms]
        spans = [cast(int, max(column)) - cast(int, min(column)) for column in zip(*indices, strict=True)]
        growth = (c ** as_integer(level) - 1) // (c - 1)
        work = len(terms) * (c + c**2 + c + prod(span * growth + 1 for span in spans))
        statement = {
            "property": "pair-norm",
            "directions": spelled(directions),
            "level": level,
            "norm": rational(as_rational(norm)),
        }
        uses.append(claims.add("pair-norm", statement, {"quotient": spelled(quotient)}, uses=[], work=work))
    return claims.add("directional-smooth", {"property": "smooth", "order": order}, {}, uses, 24 * (s + 1))
