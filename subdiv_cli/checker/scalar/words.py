"""Verified statements as phrases for the line that the checker prints."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from subdiv_cli.checker.radius.rules import on_radii, root, shown


def in_words(statement: Mapping[str, Any], p: int) -> str:
    """A verified statement on a scalar mask as a phrase."""
    s = {key: shown(value) for key, value in statement.items()}
    holds = "" if statement.get("holds", True) else "not "
    phrases = {
        "residue-sums": "residue sums {sums}",
        "sum-rules": "sum rules of order {order}",
        "derived": "S_{nu} exists",
        "generation": "generation degree {degree}",
        "reproduction": "reproduction degree {degree}",
        "norm": "‖((1/{p})S_{nu})^{level}‖ = {norm}",
        "product": "the product of the word {word} has an eigenvalue of modulus >= {radius}",
        "eigen-condition": "the eigen-condition for ν = {nu} is {holds}met",
        "independent": "the translates of φ are {holds}linearly independent",
        "stable": "φ is {holds}stable",
        "reduction": "φ of mask {from} is as smooth as that of mask {to}",
        "convergent": "S {converges}",
        "smooth": "φ is C^{order}",
        "not-smooth": "φ is not C^{order}",
        "holder-lower": "α >= {exponent}",
        "holder-upper": "α <= {exponent}",
        "holder": "α = {exponent}",
        "sobolev": "s = {sobolev}",
        "sobolev-at-least": "s >= {exponent}",
        "sobolev-at-most": "s <= {exponent}",
        "values": "values of φ^({order}) at the integers",
        "quasi-interpolation": "S^∞ Q = 1 on polynomials of degree {degree}",
        "error-bound": "‖S_{nu}^∞ g - S_{nu}^k g‖ <= {constant} · ({norm})^⌊k/{level}⌋ ‖Δg‖",
        "levels": "‖S^∞ f - S^k f‖ <= {tolerance} ‖Δf‖ at level k = {levels}",
        "hermite-bound": "‖S^∞ f - Q^k‖ <= {constant} · {p}^(-{order}k) ‖Δ^{order} f‖",
        "holder-root": "α = {exponent}",
        "attained": "the Hölder exponent is {holds}attained",
        "family": "family {family} belongs to S_(Δ^{nu})",
    }
    if statement["property"] not in phrases:
        return on_radii(statement, f"family {statement['family']}")
    phrase = phrases[statement["property"]]
    phrase += " (mask {mask})" if statement.get("mask") else ""
    converges = "diverges" if holds else "converges"
    s |= {"p": str(p), "holds": holds, "converges": converges, "exponent": exponent(statement, p)}
    s["sobolev"] = sobolev(statement, p)
    return phrase.format(**s)


def exponent(s: Mapping[str, Any], p: int, factor: Fraction | int = 1) -> str:
    """The number -factor log_p(x)/L as text, as a rational where x is a small power of p."""
    x, length = s.get("norm", s.get("radius", s.get("bound"))), s.get("level", s.get("length"))
    times = Fraction(factor) / length if length else Fraction(0)
    before = "" if times.numerator == 1 else f"{times.numerator} "
    after = "" if times.denominator == 1 else f"/{times.denominator}"
    if s["property"] == "holder-root":
        m = s["polynomial"]
        if len(m) != 2 or not m[1]:
            return f"-{before}log_{p}({root(s)}){after}"
        x = Fraction(-m[0], m[1])
    if not isinstance(x, Fraction) or x <= 0 or not length:
        return ""
    power, rest = 0, x if x > 1 else 1 / x
    rest = rest if rest.numerator.bit_length() < 1000 else Fraction(0)
    while rest > 1 and power < 64:
        power, rest = power + 1, rest / p
    if rest == 1:
        return str(times * (-power if x > 1 else power))
    return f"{before}log_{p}({shown(1 / x)}){after}"


def sobolev(s: Mapping[str, Any], p: int, factor: Fraction | int = 1) -> str:
    """The number -factor log_p(λ)/2 for λ in [low, high] as text."""
    if s["property"] not in ("sobolev", "sobolev-lower"):
        return ""
    if s["low"] == s["high"]:
        return exponent({"property": "holder-upper", "radius": s["low"], "length": 2}, p, factor)
    zero, times = "the zero of a polynomial", Fraction(factor) / 2
    before = "-" if times.numerator == 1 else f"-{times.numerator} "
    name = f"{before}log_{p}(λ)" + ("" if times.denominator == 1 else f"/{times.denominator}")
    if max(s["low"].denominator, s["high"].numerator).bit_length() > 1000:
        return f"{name}, λ {zero}"
    low, high = (f"{int(s[key] * 10**8):09}" for key in ("low", "high"))
    about = f" near {low[:-8]}.{low[-8:]}" if low == high else ""
    return f"{name}, λ {zero}{about}"
