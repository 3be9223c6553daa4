"""Masks in several variables -> the lines of their files, and what certificates embed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
from subdiv_cli.kinds.multivariate.text.bodies import BoxSplineMask, CoefficientGrid, LaurentSymbol, Tensor, Terms
from subdiv_cli.kinds.scalar.text import spelled_entries
from subdiv_cli.maskfile.expressions import literal
from subdiv_cli.maskfile.spelling import listed, nested, number, quoted
from subdiv_cli.model.closed import rational
from subdiv_cli.spaces.lattice import multiple_of_identity


def body_of(scheme: MultivariateScheme) -> Terms:
    """The literal terms of a scheme."""
    return Terms(scheme.dilation, tuple((index, literal(value)) for index, value in scheme.terms.items()))


def spell(body: BoxSplineMask | CoefficientGrid | LaurentSymbol | Tensor | Terms) -> list[str]:
    """The lines of the [mask] table."""
    if isinstance(body, Tensor):
        factors = [line for factor in body.factors for line in ("", "[[mask.tensor]]", *spelled_entries(factor))]
        return ["[mask]", *factors[1:]]
    rows, c = body.dilation, body.dilation[0][0]
    plain = rows == multiple_of_identity(c, len(rows)) and not isinstance(body, LaurentSymbol)
    lines = ["[mask]", f"dilation = {c if plain else nested(rows)}"]
    if isinstance(body, CoefficientGrid):
        return [*lines, f"start = {nested(body.start)}", *listed("coefficients", map(nested, body.coefficients))]
    if isinstance(body, Terms):
        terms = [f'"{",".join(map(str, index))}" = {number(value)}' for index, value in body.terms]
        return [*lines, "", "[mask.terms]", *terms]
    if isinstance(body, LaurentSymbol):
        return [*lines, f"symbol = {quoted(body.expression.text)}"]
    table = f"{{directions = {nested(body.directions)}, multiplicities = {nested(body.multiplicities)}}}"
    return [*lines, f"box_spline = {table}"]


def canonical(scheme: MultivariateScheme) -> Mapping[str, Any]:
    """The mask as certificates embed it, in one spelling, so that two masks are the same iff these are equal."""
    return {
        "kind": scheme.kind,
        "dilation": [list(row) for row in scheme.dilation],
        "terms": [[list(index), rational(value)] for index, value in scheme.terms.items()],
    }
