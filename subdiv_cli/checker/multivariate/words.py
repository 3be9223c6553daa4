"""Verified statements on masks on Z^s as phrases for the line that the checker prints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from subdiv_cli.checker import matrices
from subdiv_cli.checker.multivariate.lattice import DilationMatrix
from subdiv_cli.checker.radius.rules import on_radii, shown
from subdiv_cli.checker.scalar import words as scalar
from subdiv_cli.checker.scalar.words import exponent, sobolev

_PHRASES = {
    "coset-sums": "the coset sums are {holds}all 1",
    "total-sum-rules": "sum rules of total order {order}",
    "family": "family {family} belongs to differences of order {order}",
    "limit-stencil": "a limit stencil for the coset of ({coset})",
    "stencil-family": "family {family} belongs to differences of φ of order {order}",
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
    "sobolev-at-least": "s >= {exponent}",
    "sobolev-at-most": "s <= {exponent}",
    "stable": "φ is {holds}stable",
    "tensor-product": "φ is a tensor product in the variables {variables}",
    "of-factor": "{on_factor}, as for the factor in {variables}",
    "at-most-factor": "{exponent_of} is at most that of the factor in {variables}, {on_factor}",
    "box-spline": "φ is the box spline of {directions}",
    "directional-norm": "‖S_d^{level}‖ = {norm} for the factor in direction {direction}",
    "pair-norm": "‖S_cd^{level}‖ = {norm} for the factors in directions {directions}",
    "matrix-norm": "‖S_Q^{level}‖ = {norm} for differences of order {order}",
    "directional-decay": "ρ_{order}^{level} <= {norm} for differences of order {order}",
    "generation": "generation degree {degree}",
    "reproduction": "reproduction degree {degree}",
    "quasi-interpolation": "S^∞ Q = 1 on polynomials of total degree {degree}",
}


def in_words(statement: Mapping[str, Any], dilation: DilationMatrix) -> str:
    """A verified statement on a mask on Z^s as a phrase."""
    if statement["property"] not in _PHRASES:
        return on_radii(statement, f"family {statement['family']}")
    holds = statement.get("holds", True)
    words = {key: shown(value) for key, value in statement.items()}
    words |= {"holds": "" if holds else "not ", "converges": "converges" if holds else "diverges"}
    words["exponent"] = exponent(statement, *_base(dilation))
    words["sobolev"] = sobolev(statement, *_base(dilation))
    words["variables"] = _variables(statement)
    if "statement" in statement:
        words["on_factor"] = _on_factor(statement["statement"], statement["variables"], dilation)
        words["exponent_of"] = "s" if statement["statement"]["property"].startswith("sobolev") else "α"
    words["directions"] = _directions(statement.get("directions", ()))
    words["direction"] = f"({words.get('direction', '')})"
    return _PHRASES[statement["property"]].format(**words)


def _variables(statement: Mapping[str, Any]) -> str:
    """The variables as text: `(z1), (z2, z3)`."""
    parts = statement.get("parts") or [statement.get("variables", ())]
    return ", ".join(f"({', '.join(f'z{i + 1}' for i in part)})" for part in parts)


def _on_factor(statement: Mapping[str, Any], variables: tuple[int, ...], dilation: DilationMatrix) -> str:
    """A statement on the exponent of a factor, in the words of one on φ."""
    rows = [[dilation.rows[i][j] for j in variables] for i in variables]
    if len(rows) == 1:
        return scalar.in_words(statement, rows[0][0])
    b, scale = matrices.inverse(rows) or (rows, 1)
    return in_words(statement, DilationMatrix(rows, b, scale))


def _base(dilation: DilationMatrix) -> tuple[int, Fraction]:
    """The pair (b, f) with log_λ = f log_b, λ = m^(1/s): b the least integer of which m is a power."""
    s, m = dilation.dimension, dilation.cosets
    base, power = next((b, k) for b in range(2, m + 1) for k in range(1, 13) if b**k == m)
    return base, Fraction(s, power)


def _directions(directions: tuple[tuple[int, ...], ...]) -> str:
    counted = Counter(directions)
    members = [f"({', '.join(map(str, x))})" + (f" {n} times" if n > 1 else "") for x, n in list(counted.items())[:8]]
    return ", ".join(members) + (", …" if len(counted) > 8 else "")
