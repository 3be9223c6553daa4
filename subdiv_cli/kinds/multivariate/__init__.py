"""Scalar masks in several variables, with any expanding integer dilation; arranged as kind scalar is."""

from __future__ import annotations

from subdiv_cli.kinds.kind import PICTURES, Drawings, Kind, Portraits, late

_NETS = Drawings(
    "nets",
    late("subdiv_cli.kinds.multivariate.portrait.pictures:nets"),
    frozenset({".obj"}),
    options=frozenset({"points", "levels"}),
    points=late("subdiv_cli.maskfile.points:read_net"),
    most=1,
)
_SURFACES = late("subdiv_cli.kinds.multivariate.portrait.pictures:surfaces")
KIND = Kind(
    name="multivariate",
    read=late("subdiv_cli.kinds.multivariate.text.reading:read"),
    body_of=late("subdiv_cli.kinds.multivariate.text.writing:body_of"),
    spell=late("subdiv_cli.kinds.multivariate.text.writing:spell"),
    canonical=late("subdiv_cli.kinds.multivariate.text.writing:canonical"),
    rules=late("subdiv_cli.kinds.multivariate.rules:rules"),
    analyse=late("subdiv_cli.kinds.multivariate.stages:analyse"),
    proofs=late("subdiv_cli.kinds.multivariate.claims.proof:claims_of"),
    base=late("subdiv_cli.kinds.multivariate.scheme:base"),
    sections=late("subdiv_cli.kinds.multivariate.portrait.stencils:sections"),
    portraits=Portraits(
        late("subdiv_cli.kinds.multivariate.stages:analyse"),
        late("subdiv_cli.kinds.multivariate.portrait.page:portrait"),
    ),
    drawings=(
        _NETS,
        Drawings("surfaces", _SURFACES, frozenset({""}), most=6),
        Drawings("surfaces", _SURFACES, PICTURES - {""}, frozenset({"style"}), most=6),
    ),
)
