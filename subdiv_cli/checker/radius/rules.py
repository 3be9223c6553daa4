"""The rules on joint spectral radii, which all kinds have, and documents of the kind `matrices`, about one family."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import partial
from typing import Any

from subdiv_cli.checker.core import Rulebook, Step, Subject
from subdiv_cli.checker.numerals import fraction, long_integer
from subdiv_cli.checker.plain import PlainReaders
from subdiv_cli.checker.radius import closing, families, norms, polytopes
from subdiv_cli.checker.reading import MAX_DEGREE, MAX_ORDER, MAX_VERTICES, Fields, reader, record, several

MAX_COORDINATE = 40
"""The most decimal digits of a coordinate."""


def _column(value: object) -> int | tuple[int, ...]:
    """The number of a column, or the coefficients of a combination of columns."""
    kind = several("integer", MAX_ORDER) if type(value) is list else reader("natural")
    column: int | tuple[int, ...] = kind(value)
    return column


def _element(value: object) -> tuple[Fraction, ...]:
    """The coefficients of a polynomial in Λ, the constant first; a number is one."""
    return several(fraction, MAX_DEGREE)(value) if type(value) is list else (fraction(value),)


_NONE: tuple[Fields, ...] = ({},)
FAMILY = {"family": "natural"}
ROOT = {"length": "length", "polynomial": "root", "low": "rational", "high": "rational"}
_PROPERTIES: Mapping[str, Fields] = {
    "blocks": {**FAMILY, "parts": "natural[]"},
    "distinct": {**FAMILY, "part": "natural"},
    "transposed": {**FAMILY, "part": "natural"},
    "radius-lower": {**FAMILY, "length": "length", "bound": "rational"},
    "radius-upper": {**FAMILY, "length": "length", "bound": "rational"},
    "radius": {**FAMILY, **ROOT},
    "bounded": {**FAMILY, **ROOT},
    "defective": {**FAMILY, "length": "length", "value": "rational"},
}
_HULL = {"symmetry": "sign", "bits": "bits", "basis": "vertex[]", "weight_bits": "weight_bits", "images": "flat[]"}
_VERTICES: Fields = {
    **_HULL,
    "vertices": several(several(partial(long_integer, MAX_COORDINATE), MAX_ORDER), MAX_VERTICES),
}
_EIGENVECTOR: Fields = {
    "word": "natural[]",
    "reflected": "boolean",
    "column": _column,
    "scale": "rational",
    "annihilator": "rational[]",
}
_LEADER: Fields = {**_EIGENVECTOR, "sign": "sign"}
_COMPLEX_LEADER: Fields = {**_EIGENVECTOR, "factor": "root", "center": "rational[]", "distance": "rational"}
_SHARE: Fields = {"vertex": "vertex", "weight": _element}
_TIE: Fields = {"vertex": "vertex", "letter": "natural", "weights": several(record(_SHARE))}
_COMPLEX: Fields = {**_HULL, "leaders": several(record(_COMPLEX_LEADER)), "extras": "flat[]", "tree": "flat"}
_REAL: Fields = {**_COMPLEX, "leaders": several(record(_LEADER)), "ties": several(record(_TIE), MAX_VERTICES)}
_CLOSING: tuple[Fields, ...] = (_REAL, {**_REAL, "sigma": "rational[]"})
_CHAIN = {"word": "natural[]", "sign": "sign", "vector": "rational[]"}
_LEFT = {"left": "boolean", "vector": "rational[]"}
_ANY_RADIUS = ("radius-lower", "radius-upper", "radius", "bounded")
_RULES = {
    "blocks": Step(("blocks",), {}, ({"basis": "matrix", "sizes": "natural[]"},), families.blocks),
    "distinct": Step(("distinct",), {}, ({"letters": "natural[]"},), families.distinct),
    "of-distinct": Step(_ANY_RADIUS, {}, _NONE, families.of_distinct),
    "transposed": Step(("transposed",), {}, _NONE, families.transposed),
    "of-transposed": Step(_ANY_RADIUS, {}, _NONE, families.of_transposed),
    "word": Step(("radius-lower",), {}, ({"word": "natural[]"},), families.word),
    "growing-vector": Step(
        ("radius-lower",), {}, ({"word": "natural[]", "sign": "sign", **_LEFT},), norms.growing_vector
    ),
    "zero": Step(("radius-upper",), {}, _NONE, families.zero),
    "polytope": Step(("radius-upper",), {}, (_VERTICES,), polytopes.polytope),
    "monotone-polytope": Step(("radius-upper",), {}, (_VERTICES,), polytopes.monotone_polytope),
    "common-vector": Step(("radius-upper",), {}, (_LEFT,), norms.common_vector),
    "ellipsoid": Step(("radius-upper",), {}, ({"form": "flat", "words": several("natural[]")},), norms.ellipsoid),
    "meeting-bounds": Step(("radius", "bounded"), {}, _NONE, norms.meeting_bounds),
    "closing": Step(("radius", "bounded"), {}, _CLOSING, closing.closing),
    "monotone-closing": Step(("radius", "bounded"), {}, _CLOSING, closing.monotone_closing),
    "complex-closing": Step(("radius", "bounded"), {}, (_COMPLEX,), closing.complex_closing),
    "radius-of-blocks": Step(("radius",), {}, _NONE, families.radius_of_blocks),
    "upper-of-blocks": Step(("radius-upper",), {}, _NONE, families.upper_of_blocks),
    "lower-of-blocks": Step(("radius-lower",), {}, _NONE, families.lower_of_blocks),
    "defective": Step(("defective",), {}, (_CHAIN,), families.defective),
}


def of_matrices(statement: Mapping[str, Any]) -> str:
    """A statement on the family of the document, which needs no name, as a phrase."""
    return on_radii(statement, f"family {statement['family']}" if statement["family"] else "")


def on_radii(statement: Mapping[str, Any], name: str) -> str:
    """A statement on the joint spectral radius of the family with this name, as a phrase."""
    s = {key: shown(value) for key, value in statement.items()}
    power = f"^{s['length']}" if statement.get("length", 1) > 1 else ""
    s["jsr"] = f"JSR{'(' if name else ''}{name}{')' if name else ''}{power}"
    s["root"] = root(statement) if "polynomial" in statement else ""
    return {
        "blocks": "{of}block triangular: families {parts}",
        "distinct": "{of}up to signs, matrices of family {part}",
        "transposed": "{of}the transposes are family {part}",
        "radius-lower": "{jsr} >= {bound}",
        "radius-upper": "{jsr} <= {bound}",
        "radius": "{jsr} = {root}",
        "bounded": "{jsr} = {root}, and products are bounded by its powers",
        "defective": "{of}products grow like L·{value}^(L/{length})",
    }[statement["property"]].format(**s, of=f"{name}: " if name else "")


def root(s: Mapping[str, Any]) -> str:
    """The root of a polynomial as text, or the number where the polynomial is of degree 1."""
    m = s["polynomial"]
    if len(m) == 2 and m[1]:
        return shown(Fraction(-m[0], m[1]))
    if max(map(abs, m), default=0) >= 10**12 or len(m) > 8:
        return f"a root of degree {len(m) - 1} in [{shown(s['low'])}, {shown(s['high'])}]"
    terms = [(c, f"x^{k}" if k > 1 else "x" * k) for k, c in enumerate(m) if c][::-1]
    text = " ".join(f"{'-' if c < 0 else '+'} {'' if abs(c) == 1 and x else abs(c)}{x}" for c, x in terms)
    text = text.removeprefix("+ ").replace("- ", "-", 1) if text.startswith("-") else text.removeprefix("+ ")
    return f"the root of {text} in [{shown(s['low'])}, {shown(s['high'])}]"


def shown(value: object) -> str:
    """A value as short text, whatever its size: Python refuses to write long integers."""
    if isinstance(value, tuple):
        return ", ".join(map(shown, value[:8])) + (", …" if len(value) > 8 else "")
    if isinstance(value, Fraction | int) and max(abs(value.numerator), value.denominator) >= 10**40:
        return "a long fraction" if value.denominator > 1 else "a long number"
    return str(value) if isinstance(value, (int, str, Fraction)) else ""


RULEBOOK = Rulebook(
    {"matrices": "family"},
    lambda parts: Subject(len(parts["matrices"].matrices), None, [parts["matrices"]]),
    _PROPERTIES,
    _RULES,
    lambda statement, _: of_matrices(statement),
    PlainReaders(of_file=lambda _: None, of_certificate=lambda _: None),
)
