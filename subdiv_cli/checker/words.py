"""Verified statements as phrases for the line that the checker prints."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any


def in_words(statement: Mapping[str, Any], p: int) -> str:
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


def of_matrices(statement: Mapping[str, Any]) -> str:
    """The family of the document needs no name."""
    return on_radii(statement, f"family {statement['family']}" if statement["family"] else "")


def on_radii(statement: Mapping[str, Any], name: str) -> str:
    s = {key: shown(value) for key, value in statement.items()}
    power = f"^{s['length']}" if statement.get("length", 1) > 1 else ""
    s["jsr"] = f"JSR{'(' if name else ''}{name}{')' if name else ''}{power}"
    s["root"] = root(statement) if "polynomial" in statement else ""
    return {
        "blocks": "{of}block triangular: families {parts}",
        "distinct": "{of}up to signs, matrices of family {part}",
        "radius-lower": "{jsr} >= {bound}",
        "radius-upper": "{jsr} <= {bound}",
        "radius": "{jsr} = {root}",
        "bounded": "{jsr} = {root}, and products are bounded by its powers",
        "defective": "{of}products grow like L·{value}^(L/{length})",
    }[statement["property"]].format(**s, of=f"{name}: " if name else "")


def root(s: Mapping[str, Any]) -> str:
    """The root of a polynomial, or the number where the polynomial is of degree 1."""
    m = s["polynomial"]
    if len(m) == 2 and m[1]:
        return shown(Fraction(-m[0], m[1]))
    if max(map(abs, m), default=0) >= 10**12 or len(m) > 8:
        return f"a root of degree {len(m) - 1} in [{shown(s['low'])}, {shown(s['high'])}]"
    terms = [(c, f"x^{k}" if k > 1 else "x" * k) for k, c in enumerate(m) if c][::-1]
    text = " ".join(f"{'-' if c < 0 else '+'} {'' if abs(c) == 1 and x else abs(c)}{x}" for c, x in terms)
    text = text.removeprefix("+ ").replace("- ", "-", 1) if text.startswith("-") else text.removeprefix("+ ")
    return f"the root of {text} in [{shown(s['low'])}, {shown(s['high'])}]"


def exponent(s: Mapping[str, Any], p: int, factor: Fraction | int = 1) -> str:
    """-factor log_p(x)/L as a rational where x is a small power of p."""
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
    """-factor log_p(λ)/2 for λ in [low, high]."""
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


def shown(value: object) -> str:
    """Short, whatever the size: Python refuses to write long integers."""
    if isinstance(value, tuple):
        return ", ".join(map(shown, value[:8])) + (", …" if len(value) > 8 else "")
    if isinstance(value, Fraction | int) and max(abs(value.numerator), value.denominator) >= 10**40:
        return "a long fraction" if value.denominator > 1 else "a long number"
    return str(value) if isinstance(value, (int, str, Fraction)) else ""
