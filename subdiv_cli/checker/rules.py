"""The closed lists for scalar masks: properties with the fields of their statements, rules with their witnesses."""

from __future__ import annotations

from typing import Any

from subdiv_cli.checker import conclusions, scalar
from subdiv_cli.checker.core import Kind, Rule, Subject
from subdiv_cli.checker.reading import read, require
from subdiv_cli.checker.words import in_words

MAX_ARITY = 64

_MASK = {"mask": "natural"}
PROPERTIES = {
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
}
_NONE: tuple[dict[str, str], ...] = ({},)
_BEZOUT = {"cofactors": "polynomial[]"}
_ZEROS = ({"factor": "polynomial"}, {"cycle": "natural"})
RULES = {
    "residue-sums": Rule("residue-sums", {}, _NONE, scalar.residue_sums),
    "sum-rules": Rule("sum-rules", {}, ({"quotient": "polynomial"},), scalar.sum_rules),
    "derived": Rule("derived", {}, _NONE, scalar.derived),
    "generation": Rule("generation", {}, _NONE, scalar.generation),
    "reproduction": Rule("reproduction", {}, _NONE, scalar.reproduction),
    "norm": Rule("norm", {}, _NONE, scalar.norm),
    "product": Rule("product", {}, _NONE, scalar.product),
    "eigen-condition": Rule("eigen-condition", {}, _NONE, scalar.eigen_condition),
    "independent": Rule("independent", {"holds": True}, (_BEZOUT,), scalar.independent),
    "dependent": Rule("independent", {"holds": False}, _ZEROS, scalar.dependent),
    "stable": Rule("stable", {"holds": True}, ({}, {"gcd": "polynomial", **_BEZOUT}), scalar.stable),
    "unstable": Rule("stable", {"holds": False}, _ZEROS, scalar.unstable),
    "reduction": Rule("reduction", {}, ({"factor": "polynomial", "mask": "polynomial"},), scalar.reduction),
    "converges": Rule("convergent", {"holds": True}, _NONE, conclusions.converges),
    "diverges": Rule("convergent", {"holds": False}, _NONE, conclusions.diverges),
    "smooth": Rule("smooth", {}, _NONE, conclusions.smooth),
    "not-smooth": Rule("not-smooth", {}, _NONE, conclusions.not_smooth),
    "holder-lower": Rule("holder-lower", {}, _NONE, conclusions.holder_lower),
    "holder-upper": Rule("holder-upper", {}, _NONE, conclusions.holder_upper),
    "holder-exact": Rule("holder", {}, _NONE, conclusions.holder_exact),
}


def scalar_mask(parts: dict[str, Any]) -> Subject:
    require(2 <= parts["arity"] <= MAX_ARITY, f"the arity is not one of 2, …, {MAX_ARITY}")
    symbol = read("polynomial", {key: parts[key] for key in ("start", "coefficients")}, "the mask")
    require(bool(symbol.numerators), "the mask is zero")
    return Subject(parts["arity"], mask=symbol)


_SCALAR_MASK = {"arity": "natural", "start": "any", "coefficients": "any"}
SCALAR = Kind(_SCALAR_MASK, scalar_mask, PROPERTIES, RULES, in_words)
