"""Verified statements on masks on Z^s as phrases for the line that the checker prints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from subdiv_cli.checker.lattice import Dilation
from subdiv_cli.checker.words import exponent, on_radii, shown, sobolev

_PHRASES = {
    "coset-sums": "the coset sums are {holds}all 1",
    "total-sum-rules": "sum rules of total order {order}",
    "family": "family {family} belongs to differences of order {order}",
    "convergent": "S {converges}",
    "smooth": "φ is C^{order}",
    "not-smooth": "φ is not C^{order}",
    "holder-lower": "α >= {exponent}",
    "holder-upper": "α <= {exponent}",
    "holder-root": "α = {exponent}",
    "holder-value": "α = {value}",
    "sobolev": "s = {sobolev}",
    "sobolev-lower": "s >= {sobolev}",
    "sobolev-value": "s = {value}",
    "stable": "φ is {holds}stable",
    "box-spline": "φ is the box spline of {directions}",
    "directional-norm": "‖S_d^{level}‖ = {norm} for the factor in direction {direction}",
    "pair-norm": "‖S_cd^{level}‖ = {norm} for the factors in directions {directions}",
    "matrix-norm": "‖S_Q^{level}‖ = {norm} for differences of order {order}",
    "generation": "generation degree {degree}",
    "reproduction": "reproduction degree {degree}",
}


def of_surfaces(statement: Mapping[str, Any], dilation: Dilation) -> str:
    if statement["property"] not in _PHRASES:
        return on_radii(statement, f"family {statement['family']}")
    holds = statement.get("holds", True)
    words = {key: shown(value) for key, value in statement.items()}
    words |= {"holds": "" if holds else "not ", "converges": "converges" if holds else "diverges"}
    words["exponent"] = exponent(statement, *_base(dilation))
    words["sobolev"] = sobolev(statement, *_base(dilation))
    words["directions"] = _directions(statement.get("directions", ()))
    words["direction"] = f"({words.get('direction', '')})"
    return _PHRASES[statement["property"]].format(**words)


def _base(dilation: Dilation) -> tuple[int, Fraction]:
    """b and f with log_λ = f log_b, λ = m^(1/s): b the least integer of which m is a power."""
    s, m = dilation.dimension, dilation.cosets
    base, power = next((b, k) for b in range(2, m + 1) for k in range(1, 13) if b**k == m)
    return base, Fraction(s, power)


def _directions(directions: tuple[tuple[int, ...], ...]) -> str:
    counted = Counter(directions)
    members = [f"({', '.join(map(str, x))})" + (f" {n} times" if n > 1 else "") for x, n in list(counted.items())[:8]]
    return ", ".join(members) + (", …" if len(counted) > 8 else "")
