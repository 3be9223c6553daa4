"""Documents of the kind `scalar`: what their masks are, what is stated of them, and by which rules."""

from __future__ import annotations

from collections.abc import Mapping

from subdiv_cli.checker.core import Rulebook, Step
from subdiv_cli.checker.plain import PlainReaders
from subdiv_cli.checker.radius.rules import FAMILY, ROOT
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.checker.reading import Fields
from subdiv_cli.checker.scalar import bounds, conclusions, families, masks, sobolev, symbols, values
from subdiv_cli.checker.scalar.words import in_words

_NONE: tuple[Fields, ...] = ({},)
_MASK = {"mask": "natural"}
_ZERO = {"polynomial": "polynomial", "low": "rational", "high": "rational"}
_PROPERTIES: Mapping[str, Fields] = {
    "residue-sums": {**_MASK, "sums": "rational[]"},
    "sum-rules": {**_MASK, "order": "natural"},
    "derived": {**_MASK, "nu": "natural", "symbol": "polynomial"},
    "generation": {"degree": "integer"},
    "reproduction": {"degree": "integer"},
    "norm": {**_MASK, "nu": "natural", "level": "natural", "norm": "rational"},
    "product": {**_MASK, "word": "natural[]", "radius": "rational"},
    "eigen-condition": {"nu": "natural", "holds": "boolean"},
    "independent": {**_MASK, "holds": "boolean"},
    "stable": {**_MASK, "holds": "boolean"},
    "reduction": {"from": "natural", "to": "natural"},
    "convergent": {"holds": "boolean"},
    "smooth": {"order": "natural"},
    "not-smooth": {"order": "natural"},
    "holder-lower": {"level": "natural", "norm": "rational"},
    "holder-upper": {"length": "natural", "radius": "rational"},
    "holder": {"level": "natural", "norm": "rational"},
    "sobolev": _ZERO,
    "sobolev-at-least": {"length": "natural", "bound": "rational"},
    "sobolev-at-most": {"length": "natural", "bound": "rational"},
    "values": {"order": "natural", "values": "polynomial"},
    "quasi-interpolation": {"degree": "natural", "operator": "rational[]", "stencil": "polynomial"},
    "error-bound": {"nu": "natural", "level": "natural", "norm": "rational", "constant": "rational"},
    "levels": {"tolerance": "rational", "levels": "natural"},
    "hermite-bound": {"order": "natural", "constant": "rational"},
    "holder-root": ROOT,
    "attained": {"holds": "boolean"},
    "family": {**FAMILY, **_MASK, "nu": "natural"},
    **RADIUS.properties,
}
_BEZOUT = {"cofactors": "polynomial[]"}
_SQUARES = {"squares": "polynomial", "rest": "polynomial", "power": "natural"}
_COFACTOR = {"cofactor": "polynomial"}
_ZEROS = ({"factor": "polynomial"}, {"cycle": "natural"})
_RULES = {
    "residue-sums": Step(("residue-sums",), {}, _NONE, symbols.residue_sums),
    "sum-rules": Step(("sum-rules",), {}, ({"quotient": "polynomial"},), symbols.sum_rules),
    "derived": Step(("derived",), {}, _NONE, symbols.derived),
    "generation": Step(("generation",), {}, _NONE, symbols.generation),
    "reproduction": Step(("reproduction",), {}, _NONE, symbols.reproduction),
    "norm": Step(("norm",), {}, _NONE, symbols.norm),
    "product": Step(("product",), {}, _NONE, symbols.product),
    "eigen-condition": Step(("eigen-condition",), {}, _NONE, symbols.eigen_condition),
    "independent": Step(("independent",), {"holds": True}, (_BEZOUT,), symbols.independent),
    "dependent": Step(("independent",), {"holds": False}, _ZEROS, symbols.dependent),
    "stable": Step(("stable",), {"holds": True}, ({}, {"gcd": "polynomial", **_BEZOUT}), symbols.stable),
    "unstable": Step(("stable",), {"holds": False}, _ZEROS, symbols.unstable),
    "reduction": Step(("reduction",), {}, ({"factor": "polynomial", "mask": "polynomial"},), symbols.reduction),
    "converges": Step(("convergent",), {"holds": True}, _NONE, conclusions.converges),
    "diverges": Step(("convergent",), {"holds": False}, _NONE, conclusions.diverges),
    "smooth": Step(("smooth",), {}, _NONE, conclusions.smooth),
    "not-smooth": Step(("not-smooth",), {}, _NONE, conclusions.not_smooth),
    "holder-lower": Step(("holder-lower",), {}, _NONE, conclusions.holder_lower),
    "holder-upper": Step(("holder-upper",), {}, _NONE, conclusions.holder_upper),
    "holder-exact": Step(("holder",), {}, _NONE, conclusions.holder_exact),
    "holder-root": Step(("holder-root",), {}, _NONE, families.holder_root),
    "attained-bounded": Step(("attained",), {"holds": True}, _NONE, families.attained_bounded),
    "attained-norm": Step(("attained",), {"holds": True}, _NONE, families.attained_norm),
    "not-attained": Step(("attained",), {"holds": False}, _NONE, families.not_attained),
    "transition": Step(("family",), {}, _NONE, families.transition),
    "positive-symbol": Step(("radius", "bounded"), {}, (_SQUARES,), families.positive_symbol),
    "sobolev": Step(("sobolev",), {}, (_COFACTOR,), sobolev.sobolev),
    "sobolev-at-least": Step(("sobolev-at-least",), {}, _NONE, conclusions.sobolev_at_least),
    "sobolev-at-most": Step(("sobolev-at-most",), {}, _NONE, conclusions.sobolev_at_most),
    "values": Step(("values",), {}, ({}, {"values": "polynomial"}), values.values),
    "quasi-interpolation": Step(("quasi-interpolation",), {}, _NONE, values.quasi_interpolation),
    "error-bound": Step(("error-bound",), {}, _NONE, bounds.error_bound),
    "levels": Step(("levels",), {}, _NONE, bounds.levels),
    "hermite-bound": Step(("hermite-bound",), {}, _NONE, bounds.hermite_bound),
    **RADIUS.rules,
}


RULEBOOK = Rulebook(
    {"arity": "natural", "start": "any", "coefficients": "any"},
    masks.subject,
    _PROPERTIES,
    _RULES,
    lambda statement, subject: in_words(statement, subject.letters),
    PlainReaders(masks.of_file, masks.of_certificate),
)
