"""Families of square matrices, whose joint spectral radius `subdiv jsr` encloses."""

from __future__ import annotations

from subdiv_cli.kinds.kind import Kind, late

KIND = Kind(
    name="matrices",
    keys=("matrices",),
    read=late("subdiv_cli.kinds.matrices.text:read"),
    body_of=late("subdiv_cli.kinds.matrices.text:body_of"),
    spell=late("subdiv_cli.kinds.matrices.text:spell"),
    canonical=late("subdiv_cli.kinds.matrices.text:canonical"),
    rules=dict,
)
