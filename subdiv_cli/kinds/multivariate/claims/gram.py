"""Findings on stability by the Gram sequence of a mask on Z^s as claims."""

from __future__ import annotations

from fractions import Fraction
from math import prod
from typing import cast

from subdiv_cli.certificate.claims import Claims, Json
from subdiv_cli.certificate.radius import spelled
from subdiv_cli.certificate.witness import as_integer, as_tuple
from subdiv_cli.model import Finding


def gram_sequence(claims: Claims, finding: Finding, statement: Json, convergent: int, terms: int) -> int:
    """The number of the claim on it, from the number of that on convergence and of the terms of the mask."""
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
