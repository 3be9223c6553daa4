"""Masks of m×m matrices in one variable, of any arity: vector subdivision schemes; arranged as kind scalar is.

Masks, numbers, stages and claims speak of the scheme as it acts on vectors of data, whatever these mean; a kind whose
data are jets begins with them.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import PICTURES, Drawings, Kind, Portraits, Smoothing, late

_FUNCTIONS = Drawings(
    "functions",
    late("subdiv_cli.kinds.vector.portrait.curves:functions"),
    PICTURES,
    options=frozenset({"derivatives", "samples"}),
)
KIND = Kind(
    name="vector",
    read=late("subdiv_cli.kinds.vector.text:read"),
    body_of=late("subdiv_cli.kinds.vector.text:body_of"),
    spell=late("subdiv_cli.kinds.vector.text:spell"),
    canonical=late("subdiv_cli.kinds.vector.text:canonical"),
    rules=late("subdiv_cli.kinds.vector.rules:rules"),
    analyse=late("subdiv_cli.kinds.vector.stages:analyse"),
    proofs=late("subdiv_cli.kinds.vector.claims:claims_of"),
    base=lambda mask, _: (mask["arity"], 1),
    sections=late("subdiv_cli.kinds.vector.portrait.page:sections"),
    portraits=Portraits(
        late("subdiv_cli.kinds.vector.stages:analyse"),
        late("subdiv_cli.kinds.vector.portrait.page:portrait"),
    ),
    drawings=(_FUNCTIONS,),
    smoothing=Smoothing(
        late("subdiv_cli.kinds.vector.smoothing:smoother"),
        late("subdiv_cli.kinds.vector.smoothing:derived"),
    ),
)
