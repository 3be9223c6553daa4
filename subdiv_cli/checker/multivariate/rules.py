"""Documents of the kind `multivariate`: what their masks are, what is stated of them, and by which rules."""

from __future__ import annotations

from collections.abc import Mapping

from subdiv_cli.checker.core import Rulebook, Step
from subdiv_cli.checker.multivariate import (
    box_splines,
    conclusions,
    differences,
    directional,
    masks,
    matrix_schemes,
    mean_squares,
    stability,
    stencils,
    sum_rules,
    tensor,
)
from subdiv_cli.checker.multivariate.words import in_words
from subdiv_cli.checker.plain import PlainReaders
from subdiv_cli.checker.radius.rules import FAMILY, ROOT
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.checker.reading import Fields

_NONE: tuple[Fields, ...] = ({},)
_ZERO = {"polynomial": "polynomial", "low": "rational", "high": "rational"}
_COFACTOR = {"cofactor": "polynomial"}
_PROPERTIES: Mapping[str, Fields] = {
    "coset-sums": {"holds": "boolean"},
    "total-sum-rules": {"order": "natural"},
    "family": {**FAMILY, "order": "natural"},
    "limit-stencil": {"coset": "index"},
    "stencil-family": {**FAMILY, "order": "natural"},
    "convergent": {"holds": "boolean"},
    "smooth": {"order": "natural"},
    "not-smooth": {"order": "natural"},
    "holder-lower": {"length": "length", "bound": "rational"},
    "holder-upper": {"length": "length", "bound": "rational"},
    "holder-root": ROOT,
    "holder-value": {"value": "natural"},
    "sobolev": _ZERO,
    "sobolev-lower": _ZERO,
    "sobolev-value": {"value": "rational"},
    "sobolev-at-least": {"length": "length", "bound": "rational"},
    "sobolev-at-most": {"length": "length", "bound": "rational"},
    "stable": {"holds": "boolean"},
    "tensor-product": {"parts": "index[]"},
    "of-factor": {"variables": "index", "statement": tensor.exponent},
    "at-most-factor": {"variables": "index", "statement": tensor.exponent},
    "box-spline": {"directions": "index[]", "scale": "natural"},
    "directional-norm": {"direction": "index", "level": "natural", "norm": "rational"},
    "pair-norm": {"directions": "index[]", "level": "natural", "norm": "rational"},
    "matrix-norm": {"order": "natural", "level": "natural", "norm": "rational"},
    "directional-decay": {"order": "natural", "level": "natural", "norm": "rational"},
    "generation": {"degree": "integer"},
    "reproduction": {"degree": "integer"},
    "quasi-interpolation": {"degree": "natural", "operator": "terms", "stencil": "terms"},
    **RADIUS.properties,
}
_SPACE = {
    "cosets": "index[]",
    "window": "index[]",
    "basis": "flat[]",
    "matrices": "family",
    "generators": "rational[][]",
}
_STENCIL_SPACE = {
    "cosets": "index[]",
    "window": "index[]",
    "basis": "flat[]",
    "matrices": "family",
    "tree": "flat",
    "breadth": "natural",
    "leaves": "rational[][]",
    "words": "flat[]",
}
_ZERO_POINT = {"gram": "terms", "point": "index", "order": "length"}
_PARTS = {"which": "natural[]", "certificates": "any[]"}
_RULES = {
    "coset-sums": Step(("coset-sums",), {}, _NONE, sum_rules.coset_sums),
    "total-sum-rules": Step(("total-sum-rules",), {}, _NONE, sum_rules.total_sum_rules),
    "differences": Step(("family",), {}, (_SPACE,), differences.differences),
    "converges": Step(("convergent",), {"holds": True}, _NONE, conclusions.converges),
    "diverges": Step(("convergent",), {"holds": False}, _NONE, conclusions.diverges),
    "smooth": Step(("smooth",), {}, _NONE, conclusions.smooth),
    "not-smooth": Step(("not-smooth",), {}, _NONE, conclusions.not_smooth),
    "holder-lower": Step(("holder-lower",), {}, _NONE, conclusions.holder_lower),
    "holder-upper": Step(("holder-upper",), {}, _NONE, conclusions.holder_upper),
    "holder-root": Step(("holder-root",), {}, _NONE, conclusions.holder_root),
    "sobolev-at-least": Step(("sobolev-at-least",), {}, _NONE, conclusions.sobolev_at_least),
    "sobolev-at-most": Step(("sobolev-at-most",), {}, _NONE, conclusions.sobolev_at_most),
    "limit-stencil": Step(("limit-stencil",), {}, ({"terms": "terms"},), stencils.limit_stencil),
    "stencil-differences": Step(("stencil-family",), {}, (_STENCIL_SPACE,), stencils.stencil_differences),
    "stencil-smooth": Step(("smooth",), {}, _NONE, stencils.smooth),
    "stencil-not-smooth": Step(("not-smooth",), {}, _NONE, stencils.not_smooth),
    "stencil-holder-lower": Step(("holder-lower",), {}, _NONE, stencils.holder_lower),
    "stencil-holder-upper": Step(("holder-upper",), {}, _NONE, stencils.holder_upper),
    "stencil-holder-root": Step(("holder-root",), {}, _NONE, stencils.holder_root),
    "holder-meets": Step(("holder-root",), {}, _NONE, stencils.holder_meets),
    "interpolatory-stable": Step(("stable",), {"holds": True}, _NONE, stability.interpolatory_stable),
    "gram-stable": Step(("stable",), {"holds": True}, ({"gram": "terms", "tree": "flat"},), stability.gram_stable),
    "gram-unstable": Step(("stable",), {"holds": False}, (_ZERO_POINT,), stability.gram_unstable),
    "tensor-product": Step(("tensor-product",), {}, (_PARTS,), tensor.tensor_product),
    "tensor-converges": Step(("convergent",), {}, _NONE, tensor.converges),
    "tensor-stable": Step(("stable",), {}, _NONE, tensor.stable),
    "tensor-smooth": Step(("smooth",), {}, _NONE, tensor.smooth),
    "tensor-not-smooth": Step(("not-smooth",), {}, _NONE, tensor.not_smooth),
    "of-factor": Step(("of-factor",), {}, ({}, {"between": "rational"}), tensor.of_factor),
    "at-most-factor": Step(("at-most-factor",), {}, _NONE, tensor.at_most_factor),
    "box-spline": Step(("box-spline",), {}, ({"power": "natural", "shift": "index"},), box_splines.box_spline),
    "box-smooth": Step(("smooth",), {}, _NONE, box_splines.smooth),
    "box-not-smooth": Step(("not-smooth",), {}, _NONE, box_splines.not_smooth),
    "box-holder": Step(("holder-value",), {}, _NONE, box_splines.holder),
    "box-sobolev": Step(("sobolev-value",), {}, _NONE, box_splines.sobolev),
    "box-stable": Step(("stable",), {}, _NONE, box_splines.stable),
    "directional-norm": Step(("directional-norm",), {}, ({"quotient": "terms"},), directional.directional_norm),
    "directional-converges": Step(("convergent",), {"holds": True}, _NONE, directional.directional_converges),
    "pair-norm": Step(("pair-norm",), {}, ({"quotient": "terms"},), directional.pair_norm),
    "directional-smooth": Step(("smooth",), {}, _NONE, directional.directional_smooth),
    "directional-decay": Step(("directional-decay",), {}, _NONE, directional.directional_decay),
    "positive-converges": Step(("convergent",), {"holds": True}, _NONE, directional.positive_converges),
    "sublattice-diverges": Step(
        ("convergent",),
        {"holds": False},
        ({"functional": "index", "modulus": "natural"},),
        directional.sublattice_diverges,
    ),
    "matrix-norm": Step(
        ("matrix-norm",), {}, ({"power": "natural", "entries": "term[][]"},), matrix_schemes.matrix_norm
    ),
    "generation": Step(("generation",), {}, _NONE, sum_rules.generation),
    "reproduction": Step(("reproduction",), {}, _NONE, sum_rules.reproduction),
    "surface-quasi-interpolation": Step(("quasi-interpolation",), {}, _NONE, sum_rules.quasi_interpolation),
    "surface-sobolev": Step(("sobolev", "sobolev-lower"), {}, (_COFACTOR,), mean_squares.sobolev),
    **RADIUS.rules,
}


RULEBOOK = Rulebook(
    {"dilation": "index[]", "terms": "terms"},
    masks.subject,
    _PROPERTIES,
    _RULES,
    lambda statement, subject: in_words(statement, subject.about.dilation),
    PlainReaders(masks.of_file, masks.of_certificate),
)
