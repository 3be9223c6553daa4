"""Scalar masks in one variable, of any arity.

`scheme` is the mask, `text` its file, `rules` the table of its codes; `numbers` computes, `stages` decide, `claims`
prove to the checker, `portrait` shows. FORMAT.md specifies the claims.
"""

from __future__ import annotations

from subdiv_cli.kinds.kind import PICTURES, Drawings, Kind, Portraits, Smoothing, late

_CURVES = Drawings(
    "curves",
    late("subdiv_cli.kinds.scalar.portrait.curves:curves"),
    PICTURES,
    options=frozenset({"points", "closed", "levels", "samples"}),
    needs=frozenset({"points"}),
    points=late("subdiv_cli.maskfile.points:read_points"),
)
_FUNCTIONS = Drawings(
    "functions",
    late("subdiv_cli.kinds.scalar.portrait.curves:functions"),
    PICTURES,
    options=frozenset({"derivatives", "samples"}),
)
KIND = Kind(
    name="scalar",
    read=late("subdiv_cli.kinds.scalar.text:read"),
    body_of=late("subdiv_cli.kinds.scalar.text:body_of"),
    spell=late("subdiv_cli.kinds.scalar.text:spell"),
    canonical=late("subdiv_cli.kinds.scalar.text:canonical"),
    rules=late("subdiv_cli.kinds.scalar.rules:rules"),
    analyse=late("subdiv_cli.kinds.scalar.stages:analyse"),
    proofs=late("subdiv_cli.kinds.scalar.claims:claims_of"),
    base=lambda mask, _: (mask["arity"], 1),
    sections=late("subdiv_cli.kinds.scalar.portrait.sections:sections"),
    portraits=Portraits(
        late("subdiv_cli.kinds.scalar.stages:analyse"),
        late("subdiv_cli.kinds.scalar.portrait.page:portrait"),
        options=frozenset({"tolerance"}),
    ),
    drawings=(_CURVES, _FUNCTIONS),
    norms=late("subdiv_cli.kinds.scalar.numbers.scalar:norms"),
    smoothing=Smoothing(
        late("subdiv_cli.kinds.scalar.smoothing:smoother"),
        late("subdiv_cli.kinds.scalar.smoothing:derived"),
    ),
)
