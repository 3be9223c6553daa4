"""Uniform refinement of curves: p matrices A_i that turn a control polygon c into those of its pieces, A_i c.

Arranged as kind scalar is. Files are families of square matrices too, whose radius `subdiv jsr` encloses.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import PICTURES, Drawings, Kind, Portraits, late

_CURVES = Drawings(
    "curves",
    late("subdiv_cli.kinds.matrices.portrait.pictures:curves"),
    PICTURES,
    options=frozenset({"points", "levels", "samples"}),
    needs=frozenset({"points"}),
    points=late("subdiv_cli.maskfile.points:read_points"),
)
_COMPONENTS = Drawings(
    "components",
    late("subdiv_cli.kinds.matrices.portrait.pictures:functions"),
    PICTURES,
    options=frozenset({"samples"}),
    most=1,
)

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
    sections=late("subdiv_cli.kinds.matrices.portrait.pictures:sections"),
    portraits=Portraits(
        late("subdiv_cli.kinds.matrices.stages:analyse"),
        late("subdiv_cli.kinds.matrices.portrait.page:portrait"),
    ),
    drawings=(_CURVES, _COMPONENTS),
)
