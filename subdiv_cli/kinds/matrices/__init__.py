"""Uniform refinement of curves: p matrices A_i that turn a control polygon c into those of its pieces, A_i c.

Arranged as kind scalar is. Files are families of square matrices too, whose radius `subdiv jsr` encloses.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import Kind, late

KIND = Kind(
    name="matrices",
    keys=("matrices",),
    read=late("subdiv_cli.kinds.matrices.text:read"),
    read_family=late("subdiv_cli.kinds.matrices.text:read_family"),
    body_of=late("subdiv_cli.kinds.matrices.text:body_of"),
    spell=late("subdiv_cli.kinds.matrices.text:spell"),
    canonical=late("subdiv_cli.kinds.matrices.text:canonical"),
    rules=late("subdiv_cli.kinds.matrices.rules:rules"),
    analyse=late("subdiv_cli.kinds.matrices.stages:analyse"),
    proofs=late("subdiv_cli.kinds.matrices.claims:claims_of"),
    base=late("subdiv_cli.kinds.matrices.scheme:base"),
)
