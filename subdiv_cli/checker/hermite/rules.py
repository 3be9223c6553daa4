"""Documents of the kind `hermite`: those of kind `vector`, and what is stated of jets."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.checker.core import Rulebook, Step
from subdiv_cli.checker.hermite import jets, taylor
from subdiv_cli.checker.radius.rules import FAMILY
from subdiv_cli.checker.reading import Fields
from subdiv_cli.checker.vector import rules as vector
from subdiv_cli.checker.vector.masks import MATRICES
from subdiv_cli.checker.vector.words import in_words

PROPERTIES: Mapping[str, Fields] = {
    **vector.PROPERTIES,
    "spectral": {"order": "natural", "holds": "boolean"},
    "jet": {**FAMILY, "component": "natural"},
    "taylor": {},
    "hermite-convergent": {"order": "natural", "holds": "boolean"},
}
_NONE: tuple[Fields, ...] = ({},)
_MASK: Fields = {"start": "start", "coefficients": MATRICES}
RULES: Mapping[str, Step] = {
    **{name: step for name, step in vector.RULES.items() if name not in ("derived", "derived-smooth")},
    "spectral": Step(("spectral",), {}, ({"shifts": "rational[]"},), jets.spectral),
    "jet": Step(("jet",), {}, ({**vector.SPACE, "words": "flat[]"},), jets.jet),
    "hermite-converges": Step(("hermite-convergent",), {"holds": True}, _NONE, jets.hermite_converges),
    "hermite-diverges": Step(("hermite-convergent",), {"holds": False}, _NONE, jets.hermite_diverges),
    "taylor": Step(("taylor",), {}, (_MASK,), taylor.taylor),
    "taylor-derived": Step(("derived",), {}, (vector.DERIVED,), taylor.taylor_derived),
    "taylor-converges": Step(("hermite-convergent",), {"holds": True}, _NONE, taylor.taylor_converges),
    "taylor-smooth": Step(("smooth",), {}, _NONE, taylor.taylor_smooth),
}


def _in_words(statement: Mapping[str, Any], p: int) -> str:
    """A verified statement on a scheme of jets as a phrase."""
    match statement["property"]:
        case "spectral":
            return f"the spectral condition holds for degrees below {statement['order']}"
        case "jet":
            return f"family {statement['family']} belongs to derivative {statement['component']}"
        case "taylor":
            return "there is a Taylor mask"
        case "hermite-convergent":
            return f"S is {'' if statement['holds'] else 'not '}HC^{statement['order']}"
        case _:
            return in_words(statement, p)


RULEBOOK = Rulebook(
    vector.RULEBOOK.fields,
    jets.subject,
    PROPERTIES,
    RULES,
    lambda statement, subject: _in_words(statement, subject.letters),
    vector.RULEBOOK.plain,
)
