"""Hermite schemes: masks of matrices whose data are jets, a function and its derivatives; on top of kind vector.

They have the numbers, the stages and the claims of that kind for the limit itself; here are those on the derivatives.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import PICTURES, Drawings, Kind, Portraits, Smoothing, late

_FUNCTIONS = Drawings(
    "functions",
    late("subdiv_cli.kinds.hermite.portrait:functions"),
    PICTURES,
    options=frozenset({"derivatives", "samples"}),
)
KIND = Kind(
    name="hermite",
    read=late("subdiv_cli.kinds.hermite.text:read"),
    body_of=late("subdiv_cli.kinds.vector.text:body_of"),
    spell=late("subdiv_cli.kinds.vector.text:spell"),
    canonical=late("subdiv_cli.kinds.vector.text:canonical"),
    rules=late("subdiv_cli.kinds.hermite.rules:rules"),
    analyse=late("subdiv_cli.kinds.hermite.stages:analyse"),
    proofs=late("subdiv_cli.kinds.hermite.claims:claims_of"),
    base=lambda mask, _: (mask["arity"], 1),
    sections=late("subdiv_cli.kinds.hermite.portrait:sections"),
    portraits=Portraits(
        late("subdiv_cli.kinds.hermite.stages:analyse"),
        late("subdiv_cli.kinds.hermite.portrait:portrait"),
    ),
    drawings=(_FUNCTIONS,),
    smoothing=Smoothing(
        late("subdiv_cli.kinds.hermite.smoothing:smoother"),
        late("subdiv_cli.kinds.hermite.smoothing:derived"),
    ),
)
