"""Schemes in one variable that change their rules: a mask on each side of 0, and special rows near it.

Arranged as kind scalar is, which decides the masks of both sides.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import PICTURES, Drawings, Kind, Portraits, late

_LIMITS = Drawings(
    "limits",
    late("subdiv_cli.kinds.piecewise.portrait.pictures:functions"),
    PICTURES,
    options=frozenset({"samples"}),
    most=1,
)
KIND = Kind(
    name="piecewise",
    keys=("left", "right", "spacing", "special", "shear"),
    read=late("subdiv_cli.kinds.piecewise.text:read"),
    body_of=late("subdiv_cli.kinds.piecewise.text:body_of"),
    spell=late("subdiv_cli.kinds.piecewise.text:spell"),
    canonical=late("subdiv_cli.kinds.piecewise.text:canonical"),
    rules=late("subdiv_cli.kinds.piecewise.rules:rules"),
    analyse=late("subdiv_cli.kinds.piecewise.stages:analyse"),
    proofs=late("subdiv_cli.kinds.piecewise.claims:claims_of"),
    base=lambda mask, _: (mask["arity"], 1),
    sections=late("subdiv_cli.kinds.piecewise.portrait.page:sections"),
    portraits=Portraits(
        late("subdiv_cli.kinds.piecewise.stages:analyse"),
        late("subdiv_cli.kinds.piecewise.portrait.page:portrait"),
    ),
    drawings=(_LIMITS,),
)
