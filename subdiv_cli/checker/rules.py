"""The closed lists of each kind: properties with the fields of their statements, rules with their witnesses."""

from __future__ import annotations

from typing import Any

from subdiv_cli.checker import (
    bounds,
    box_splines,
    closing,
    complex_closing,
    conclusions,
    differences,
    directional,
    exponents,
    gram,
    matrix_schemes,
    mean_squares,
    multivariate,
    pairs,
    polytopes,
    positive,
    quasi_interpolation,
    radius,
    scalar,
    sobolev,
    surfaces,
    tensor,
    values,
)
from subdiv_cli.checker.core import Kind, Rule, Subject
from subdiv_cli.checker.lattice import lattice_mask
from subdiv_cli.checker.reading import read, require
from subdiv_cli.checker.surface_words import of_surfaces
from subdiv_cli.checker.words import in_words, of_matrices

MAX_ARITY = 64

_NONE: tuple[dict[str, str], ...] = ({},)
_FAMILY = {"family": "natural"}
_ROOT = {"length": "length", "polynomial": "root", "low": "rational", "high": "rational"}
_HULL = {"symmetry": "sign", "bits": "bits", "basis": "vertex[]", "weight_bits": "weight_bits", "images": "flat[]"}
RADIUS_PROPERTIES = {
    "blocks": {**_FAMILY, "parts": "natural[]"},
    "distinct": {**_FAMILY, "part": "natural"},
    "radius-lower": {**_FAMILY, "length": "length", "bound": "rational"},
    "radius-upper": {**_FAMILY, "length": "length", "bound": "rational"},
    "radius": {**_FAMILY, **_ROOT},
    "bounded": {**_FAMILY, **_ROOT},
    "defective": {**_FAMILY, "length": "length", "value": "rational"},
}
_PLAIN = {**_HULL, "leaders": "leader[]", "extras": "flat[]", "tree": "flat", "ties": "tie[]"}
_CLOSING = (_PLAIN, {**_PLAIN, "sigma": "rational[]"})
_COMPLEX = {**_HULL, "leaders": "complex_leader[]", "extras": "flat[]", "tree": "flat"}
_CHAIN = {"word": "natural[]", "sign": "sign", "vector": "rational[]"}
RADIUS_RULES = {
    "blocks": Rule(("blocks",), {}, ({"basis": "matrix", "sizes": "natural[]"},), radius.blocks),
    "distinct": Rule(("distinct",), {}, ({"letters": "natural[]"},), radius.distinct),
    "of-distinct": Rule(("radius-lower", "radius-upper", "radius", "bounded"), {}, _NONE, radius.of_distinct),
    "word": Rule(("radius-lower",), {}, ({"word": "natural[]"},), radius.word),
    "zero": Rule(("radius-upper",), {}, _NONE, radius.zero),
    "polytope": Rule(("radius-upper",), {}, ({**_HULL, "vertices": "vertices[]"},), polytopes.polytope),
    "monotone-polytope": Rule(
        ("radius-upper",), {}, ({**_HULL, "vertices": "vertices[]"},), polytopes.monotone_polytope
    ),
    "closing": Rule(("radius", "bounded"), {}, _CLOSING, closing.closing),
    "monotone-closing": Rule(("radius", "bounded"), {}, _CLOSING, closing.monotone_closing),
    "complex-closing": Rule(("radius", "bounded"), {}, (_COMPLEX,), complex_closing.complex_closing),
    "radius-of-blocks": Rule(("radius",), {}, _NONE, radius.radius_of_blocks),
    "upper-of-blocks": Rule(("radius-upper",), {}, _NONE, radius.upper_of_blocks),
    "lower-of-blocks": Rule(("radius-lower",), {}, _NONE, radius.lower_of_blocks),
    "defective": Rule(("defective",), {}, (_CHAIN,), radius.defective),
}
_MASK = {"mask": "natural"}
_ZERO = {"polynomial": "polynomial", "low": "rational", "high": "rational"}
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
    "sobolev": _ZERO,
    "values": {"order": "natural", "values": "polynomial"},
    "quasi-interpolation": {"degree": "natural", "operator": "rational[]", "stencil": "polynomial"},
    "error-bound": {"nu": "natural", "level": "natural", "norm": "rational", "constant": "rational"},
    "levels": {"tolerance": "rational", "levels": "natural"},
    "hermite-bound": {"order": "natural", "constant": "rational"},
    "holder-root": _ROOT,
    "attained": {"holds": "boolean"},
    "family": {**_FAMILY, **_MASK, "nu": "natural"},
    **RADIUS_PROPERTIES,
}
_BEZOUT = {"cofactors": "polynomial[]"}
_SQUARES = {"squares": "polynomial", "rest": "polynomial", "power": "natural"}
_COFACTOR = {"cofactor": "polynomial"}
_ZEROS = ({"factor": "polynomial"}, {"cycle": "natural"})
RULES = {
    "residue-sums": Rule(("residue-sums",), {}, _NONE, scalar.residue_sums),
    "sum-rules": Rule(("sum-rules",), {}, ({"quotient": "polynomial"},), scalar.sum_rules),
    "derived": Rule(("derived",), {}, _NONE, scalar.derived),
    "generation": Rule(("generation",), {}, _NONE, scalar.generation),
    "reproduction": Rule(("reproduction",), {}, _NONE, scalar.reproduction),
    "norm": Rule(("norm",), {}, _NONE, scalar.norm),
    "product": Rule(("product",), {}, _NONE, scalar.product),
    "eigen-condition": Rule(("eigen-condition",), {}, _NONE, scalar.eigen_condition),
    "independent": Rule(("independent",), {"holds": True}, (_BEZOUT,), scalar.independent),
    "dependent": Rule(("independent",), {"holds": False}, _ZEROS, scalar.dependent),
    "stable": Rule(("stable",), {"holds": True}, ({}, {"gcd": "polynomial", **_BEZOUT}), scalar.stable),
    "unstable": Rule(("stable",), {"holds": False}, _ZEROS, scalar.unstable),
    "reduction": Rule(("reduction",), {}, ({"factor": "polynomial", "mask": "polynomial"},), scalar.reduction),
    "converges": Rule(("convergent",), {"holds": True}, _NONE, conclusions.converges),
    "diverges": Rule(("convergent",), {"holds": False}, _NONE, conclusions.diverges),
    "smooth": Rule(("smooth",), {}, _NONE, conclusions.smooth),
    "not-smooth": Rule(("not-smooth",), {}, _NONE, conclusions.not_smooth),
    "holder-lower": Rule(("holder-lower",), {}, _NONE, conclusions.holder_lower),
    "holder-upper": Rule(("holder-upper",), {}, _NONE, conclusions.holder_upper),
    "holder-exact": Rule(("holder",), {}, _NONE, conclusions.holder_exact),
    "holder-root": Rule(("holder-root",), {}, _NONE, exponents.holder_root),
    "attained-bounded": Rule(("attained",), {"holds": True}, _NONE, exponents.attained_bounded),
    "attained-norm": Rule(("attained",), {"holds": True}, _NONE, exponents.attained_norm),
    "not-attained": Rule(("attained",), {"holds": False}, _NONE, exponents.not_attained),
    "transition": Rule(("family",), {}, _NONE, radius.transition),
    "positive-symbol": Rule(("radius", "bounded"), {}, (_SQUARES,), radius.positive_symbol),
    "sobolev": Rule(("sobolev",), {}, (_COFACTOR,), sobolev.sobolev),
    "values": Rule(("values",), {}, ({}, {"values": "polynomial"}), values.values),
    "quasi-interpolation": Rule(("quasi-interpolation",), {}, _NONE, values.quasi_interpolation),
    "error-bound": Rule(("error-bound",), {}, _NONE, bounds.error_bound),
    "levels": Rule(("levels",), {}, _NONE, bounds.levels),
    "hermite-bound": Rule(("hermite-bound",), {}, _NONE, bounds.hermite_bound),
    **RADIUS_RULES,
}


def scalar_mask(parts: dict[str, Any]) -> Subject:
    require(2 <= parts["arity"] <= MAX_ARITY, f"the arity is not one of 2, …, {MAX_ARITY}")
    symbol = read("polynomial", {key: parts[key] for key in ("start", "coefficients")}, "the mask")
    require(bool(symbol.numerators), "the mask is zero")
    return Subject(parts["arity"], mask=symbol)


_SCALAR_MASK = {"arity": "natural", "start": "any", "coefficients": "any"}
SCALAR = Kind(
    _SCALAR_MASK, scalar_mask, PROPERTIES, RULES, lambda statement, subject: in_words(statement, subject.letters)
)
MATRICES = Kind(
    {"matrices": "family"},
    lambda parts: Subject(len(parts["matrices"].matrices), family=parts["matrices"]),
    RADIUS_PROPERTIES,
    RADIUS_RULES,
    lambda statement, _: of_matrices(statement),
)

SURFACE_PROPERTIES = {
    "coset-sums": {"holds": "boolean"},
    "total-sum-rules": {"order": "natural"},
    "family": {**_FAMILY, "order": "natural"},
    "convergent": {"holds": "boolean"},
    "smooth": {"order": "natural"},
    "not-smooth": {"order": "natural"},
    "holder-lower": {"length": "length", "bound": "rational"},
    "holder-upper": {"length": "length", "bound": "rational"},
    "holder-root": _ROOT,
    "holder-value": {"value": "natural"},
    "sobolev": _ZERO,
    "sobolev-lower": _ZERO,
    "sobolev-value": {"value": "rational"},
    "stable": {"holds": "boolean"},
    "tensor-product": {"parts": "index[]"},
    "of-factor": {"variables": "index", "statement": "exponent"},
    "at-most-factor": {"variables": "index", "statement": "exponent"},
    "box-spline": {"directions": "index[]", "scale": "natural"},
    "directional-norm": {"direction": "index", "level": "natural", "norm": "rational"},
    "pair-norm": {"directions": "index[]", "level": "natural", "norm": "rational"},
    "matrix-norm": {"order": "natural", "level": "natural", "norm": "rational"},
    "generation": {"degree": "integer"},
    "reproduction": {"degree": "integer"},
    "quasi-interpolation": {"degree": "natural", "operator": "terms", "stencil": "terms"},
    **RADIUS_PROPERTIES,
}
_SPACE = {
    "cosets": "index[]",
    "window": "index[]",
    "basis": "flat[]",
    "matrices": "family",
    "generators": "rational[][]",
}
_ZERO_POINT = {"gram": "terms", "point": "index", "order": "length"}
_PARTS = {"which": "natural[]", "certificates": "any[]"}
SURFACE_RULES = {
    "coset-sums": Rule(("coset-sums",), {}, _NONE, multivariate.coset_sums),
    "total-sum-rules": Rule(("total-sum-rules",), {}, _NONE, multivariate.total_sum_rules),
    "differences": Rule(("family",), {}, (_SPACE,), differences.differences),
    "converges": Rule(("convergent",), {"holds": True}, _NONE, surfaces.converges),
    "diverges": Rule(("convergent",), {"holds": False}, _NONE, surfaces.diverges),
    "smooth": Rule(("smooth",), {}, _NONE, surfaces.smooth),
    "not-smooth": Rule(("not-smooth",), {}, _NONE, surfaces.not_smooth),
    "holder-lower": Rule(("holder-lower",), {}, _NONE, surfaces.holder_lower),
    "holder-upper": Rule(("holder-upper",), {}, _NONE, surfaces.holder_upper),
    "holder-root": Rule(("holder-root",), {}, _NONE, surfaces.holder_root),
    "interpolatory-stable": Rule(("stable",), {"holds": True}, _NONE, multivariate.interpolatory_stable),
    "gram-stable": Rule(("stable",), {"holds": True}, ({"gram": "terms", "tree": "flat"},), gram.gram_stable),
    "gram-unstable": Rule(("stable",), {"holds": False}, (_ZERO_POINT,), gram.gram_unstable),
    "tensor-product": Rule(("tensor-product",), {}, (_PARTS,), tensor.tensor_product),
    "tensor-converges": Rule(("convergent",), {}, _NONE, tensor.converges),
    "tensor-stable": Rule(("stable",), {}, _NONE, tensor.stable),
    "tensor-smooth": Rule(("smooth",), {}, _NONE, tensor.smooth),
    "tensor-not-smooth": Rule(("not-smooth",), {}, _NONE, tensor.not_smooth),
    "of-factor": Rule(("of-factor",), {}, ({}, {"between": "rational"}), tensor.of_factor),
    "at-most-factor": Rule(("at-most-factor",), {}, _NONE, tensor.at_most_factor),
    "box-spline": Rule(("box-spline",), {}, ({"power": "natural", "shift": "index"},), box_splines.box_spline),
    "box-smooth": Rule(("smooth",), {}, _NONE, box_splines.smooth),
    "box-not-smooth": Rule(("not-smooth",), {}, _NONE, box_splines.not_smooth),
    "box-holder": Rule(("holder-value",), {}, _NONE, box_splines.holder),
    "box-sobolev": Rule(("sobolev-value",), {}, _NONE, box_splines.sobolev),
    "box-stable": Rule(("stable",), {}, _NONE, box_splines.stable),
    "directional-norm": Rule(("directional-norm",), {}, ({"quotient": "terms"},), directional.directional_norm),
    "directional-converges": Rule(("convergent",), {"holds": True}, _NONE, directional.directional_converges),
    "pair-norm": Rule(("pair-norm",), {}, ({"quotient": "terms"},), pairs.pair_norm),
    "directional-smooth": Rule(("smooth",), {}, _NONE, pairs.directional_smooth),
    "positive-converges": Rule(("convergent",), {"holds": True}, _NONE, positive.positive_converges),
    "matrix-norm": Rule(
        ("matrix-norm",), {}, ({"power": "natural", "entries": "term[][]"},), matrix_schemes.matrix_norm
    ),
    "generation": Rule(("generation",), {}, _NONE, multivariate.generation),
    "reproduction": Rule(("reproduction",), {}, _NONE, multivariate.reproduction),
    "surface-quasi-interpolation": Rule(
        ("quasi-interpolation",), {}, _NONE, quasi_interpolation.surface_quasi_interpolation
    ),
    "surface-sobolev": Rule(("sobolev", "sobolev-lower"), {}, (_COFACTOR,), mean_squares.surface_sobolev),
    **RADIUS_RULES,
}


def surface(parts: dict[str, Any]) -> Subject:
    mask = lattice_mask(parts["dilation"], parts["terms"])
    return Subject(mask.dilation.cosets, lattice=mask)


def _of_surface(statement: dict[str, Any], subject: Subject) -> str:
    return of_surfaces(statement, subject.lattice.dilation) if subject.lattice else ""


MULTIVARIATE = Kind({"dilation": "index[]", "terms": "terms"}, surface, SURFACE_PROPERTIES, SURFACE_RULES, _of_surface)
