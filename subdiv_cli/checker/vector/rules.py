"""Documents of the kind `vector`: what their masks are, what is stated of them, and by which rules."""

from __future__ import annotations

from collections.abc import Mapping

from subdiv_cli.checker.core import Rulebook, Step
from subdiv_cli.checker.plain import PlainReaders
from subdiv_cli.checker.radius.rules import FAMILY, ROOT
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.checker.reading import Fields
from subdiv_cli.checker.vector import conclusions, derived, masks, sequences, spaces
from subdiv_cli.checker.vector.words import in_words

_NONE: tuple[Fields, ...] = ({},)
PROPERTIES: Mapping[str, Fields] = {
    "constants": {"dimension": "natural"},
    "eigen-sequences": {"order": "natural"},
    "generation": {"degree": "natural"},
    "mean-matrix": {"holds": "boolean"},
    "limit-stencils": {"count": "natural"},
    "family": {**FAMILY, "order": "natural"},
    "convergent": {"holds": "boolean"},
    "smooth": {"order": "natural"},
    "not-smooth": {"order": "natural"},
    "holder-lower": {"length": "length", "bound": "rational"},
    "holder-upper": {"length": "length", "bound": "rational"},
    "holder-root": ROOT,
    "attained": {"holds": "boolean"},
    "derived": {"order": "natural"},
    "derived-norm": {"order": "natural", "level": "natural", "norm": "rational"},
    **RADIUS.properties,
}
SPACE = {"start": "start", "basis": "rational[][]", "matrices": "family", "tree": "flat", "leaves": "rational[][]"}
_ROWS = {"start": "start", "rows": "rational[][]"}
_SEQUENCES = {"sequences": "rational[][][]", "multipliers": "rational[]", "functional": "rational[]"}
DERIVED: Fields = {
    "transformation": "matrix",
    "dimension": "natural",
    "start": "start",
    "coefficients": masks.MATRICES,
}
RULES: Mapping[str, Step] = {
    "constants": Step(("constants",), {}, ({"basis": "rational[][]"},), sequences.constants),
    "eigen-sequences": Step(("eigen-sequences",), {}, (_SEQUENCES, {}), sequences.eigen_sequences),
    "generation": Step(("generation",), {}, _NONE, sequences.generation),
    "mean-matrix": Step(("mean-matrix",), {}, _NONE, sequences.mean_matrix),
    "limit-stencils": Step(("limit-stencils",), {}, (_ROWS,), sequences.limit_stencils),
    "decay": Step(("family",), {"order": 0}, ({**SPACE, "orthogonal": "rational[][]"},), spaces.decay),
    "stencil-differences": Step(("family",), {}, ({**SPACE, "words": "flat[]"},), spaces.stencil_differences),
    "converges": Step(("convergent",), {"holds": True}, _NONE, conclusions.converges),
    "diverges": Step(("convergent",), {"holds": False}, _NONE, conclusions.diverges),
    "fixed-diverges": Step(("convergent",), {"holds": False}, (_ROWS,), sequences.fixed_diverges),
    "continuous": Step(("smooth",), {"order": 0}, _NONE, conclusions.continuous),
    "smooth": Step(("smooth",), {}, _NONE, conclusions.smooth),
    "not-smooth": Step(("not-smooth",), {}, _NONE, conclusions.not_smooth),
    "holder-lower": Step(("holder-lower",), {}, _NONE, conclusions.holder_lower),
    "holder-upper": Step(("holder-upper",), {}, _NONE, conclusions.holder_upper),
    "holder-root": Step(("holder-root",), {}, _NONE, conclusions.holder_root),
    "attained": Step(("attained",), {"holds": True}, _NONE, conclusions.attained),
    "not-attained": Step(("attained",), {"holds": False}, _NONE, conclusions.not_attained),
    "derived": Step(("derived",), {}, (DERIVED,), derived.derived),
    "derived-norm": Step(("derived-norm",), {}, _NONE, derived.derived_norm),
    "derived-smooth": Step(("smooth",), {}, _NONE, derived.derived_smooth),
    **RADIUS.rules,
}
RULEBOOK = Rulebook(
    {"arity": "natural", "start": "start", "coefficients": masks.MATRICES},
    masks.subject,
    PROPERTIES,
    RULES,
    lambda statement, subject: in_words(statement, subject.letters),
    PlainReaders(masks.of_file, masks.of_certificate),
)
