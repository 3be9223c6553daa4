"""Verified statements on masks of matrices as phrases for the line that the checker prints."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.checker.radius.rules import on_radii, shown
from subdiv_cli.checker.scalar.words import exponent

_PHRASES = {
    "constants": "E_A has dimension {dimension}",
    "eigen-sequences": "eigen-sequences of all degrees below {order}",
    "generation": "generation degree {degree}",
    "mean-matrix": "M_A has {holds}the spectrum of a convergent scheme",
    "convergent": "S {converges}",
    "limit-stencils": "limit stencils, {count}",
    "smooth": "all limits are C^{order}",
    "not-smooth": "not all limits are C^{order}",
    "holder-lower": "α >= {exponent}",
    "holder-upper": "α <= {exponent}",
    "holder-root": "α = {exponent}",
    "attained": "α is {holds}attained",
    "derived": "derived scheme {order}",
    "derived-norm": "‖((1/p)S)^{level}‖ = {norm} for derived scheme {order}",
}


def in_words(statement: Mapping[str, Any], p: int) -> str:
    """A verified statement on a mask of matrices as a phrase."""
    name = statement["property"]
    if name == "family":
        of = f"differences of order {statement['order']}" if statement["order"] else "sequences that die out"
        return f"family {statement['family']} belongs to {of}"
    if name not in _PHRASES:
        return on_radii(statement, f"family {statement['family']}")
    holds = statement.get("holds", True)
    words = {key: shown(value) for key, value in statement.items()}
    words |= {"holds": "" if holds else "not ", "converges": "converges" if holds else "diverges"}
    words["exponent"] = exponent(statement, p)
    return _PHRASES[name].format(**words)
