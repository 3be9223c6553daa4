"""Documents of the kind `matrices`: families of matrices, and the curves that they refine."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.checker.core import Rulebook, Step, Subject
from subdiv_cli.checker.curves import components, conclusions, convergence
from subdiv_cli.checker.numerals import UnreadableError
from subdiv_cli.checker.plain import PlainMask, PlainReaders, literal
from subdiv_cli.checker.radius.rules import FAMILY, ROOT, of_matrices, root, shown
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.checker.reading import Fields


def _space(value: object) -> object:
    """The space that a family acts on: `polygons`, e^⊥, or `curve`, V."""
    if value not in ("polygons", "curve"):
        raise UnreadableError("is not polygons or curve")
    return value


_NONE: tuple[Fields, ...] = ({},)
_VECTORS: tuple[Fields, ...] = ({"left": "rational[]", "right": "rational[]"},)
_HOLDS: Fields = {"holds": "boolean"}
_BOUND: Fields = {"length": "length", "bound": "rational"}
_PROPERTIES: Mapping[str, Fields] = {
    "family": {**FAMILY, "on": _space},
    "convergent": _HOLDS,
    "positive-columns": {"length": "natural"},
    "well-defined": _HOLDS,
    "polynomials": {"degree": "natural", "dimension": "natural"},
    "polynomial-curve": {"degree": "natural"},
    "derivative": {"order": "natural", **_HOLDS},
    "smooth": {"order": "natural"},
    "not-smooth": {"order": "natural"},
    "holder-lower": _BOUND,
    "holder-upper": _BOUND,
    "holder-root": ROOT,
    "holder-value": {"value": "natural"},
    **RADIUS.properties,
}
_COMPONENTS: Fields = {
    "words": "natural[][]",
    "annihilator": "rational[][]",
    "polygons": "rational[][]",
    "level": "natural",
    "weights": "rational[]",
}
_RULES = {
    "differences": Step(("family",), {"on": "polygons"}, _NONE, convergence.differences),
    "contracts": Step(("convergent",), {"holds": True}, _NONE, convergence.contracts),
    "expands": Step(("convergent",), {"holds": False}, _NONE, convergence.expands),
    "positive-columns": Step(("positive-columns",), {}, ({"steps": "work"},), convergence.positive_columns),
    "consecutive-columns": Step(("positive-columns",), {}, _NONE, convergence.consecutive_columns),
    "columns-converge": Step(("convergent",), {"holds": True}, _NONE, convergence.columns_converge),
    "meets": Step(("well-defined",), {}, _VECTORS, convergence.meets),
    "components": Step(("polynomials",), {}, (_COMPONENTS,), components.components),
    "annihilators": Step(
        ("family",), {"on": "curve"}, ({"basis": "rational[][]", "matrices": "family"},), components.annihilators
    ),
    "derivative": Step(("derivative",), {}, _VECTORS, components.derivative),
    "continuous": Step(("smooth",), {"order": 0}, _NONE, conclusions.continuous),
    "polynomial-curve": Step(("polynomial-curve",), {}, _NONE, conclusions.polynomial_curve),
    "smooth": Step(("smooth",), {}, _NONE, conclusions.smooth),
    "not-smooth": Step(("not-smooth",), {}, _NONE, conclusions.not_smooth),
    "corner": Step(("not-smooth",), {}, _NONE, conclusions.corner),
    "holder-lower": Step(("holder-lower",), {}, _NONE, conclusions.holder_lower),
    "holder-upper": Step(("holder-upper",), {}, _NONE, conclusions.holder_upper),
    "holder-root": Step(("holder-root",), {}, _NONE, conclusions.holder_root),
    "holder-value": Step(("holder-value",), {}, _NONE, conclusions.holder_value),
    **RADIUS.rules,
}


def in_words(statement: Mapping[str, Any], subject: Subject) -> str:
    """A statement on the family of the document, or on the curve of its matrices, as a phrase."""
    s, p = statement, subject.letters
    match s["property"]:
        case "convergent":
            return "all polygons converge" if s["holds"] else "not all polygons converge"
        case "positive-columns":
            return f"products of {s['length']} matrices have a positive column"
        case "well-defined":
            return "the pieces meet in one curve" if s["holds"] else "the pieces do not meet"
        case "polynomials":
            return f"{s['dimension']} components, polynomials of degree {s['degree']} among them"
        case "polynomial-curve":
            return f"the curve is a polynomial of degree {s['degree']}"
        case "derivative":
            return f"derivatives of order {s['order']} {'fit' if s['holds'] else 'do not fit'} at the joints"
        case "smooth" | "not-smooth":
            return f"the curve is {'not ' if s['property'] == 'not-smooth' else ''}C^{s['order']}"
        case "holder-lower" | "holder-upper":
            relation = ">=" if s["property"] == "holder-lower" else "<="
            return f"alpha {relation} -log{p}({shown(s['bound'])}){_divided(s)}"
        case "holder-root":
            return f"alpha = -log{p}({root(s)}){_divided(s)}"
        case "holder-value":
            return f"alpha = {s['value']}"
        case "family":
            on = "differences of control points" if s["on"] == "polygons" else "what annihilates polynomials"
            return f"family {s['family']}: on {on}"
    return of_matrices(statement)


def _divided(s: Mapping[str, Any]) -> str:
    return f"/{s['length']}" if s["length"] > 1 else ""


def _plain(matrices: object) -> PlainMask:
    return PlainMask("matrices", (tuple(tuple(tuple(map(literal, row)) for row in m) for m in matrices),))  # type: ignore[attr-defined]


def _of_file(document: Mapping[str, Any]) -> PlainMask | None:
    """The matrices of a file, lists in lists in a list."""
    given = document.get("matrices")
    nested = type(given) is list and all(type(m) is list and all(type(row) is list for row in m) for m in given)
    return _plain(given) if nested else None


RULEBOOK = Rulebook(
    RADIUS.fields,
    lambda parts: Subject(len(parts["matrices"].matrices), parts["matrices"], [parts["matrices"]]),
    _PROPERTIES,
    _RULES,
    in_words,
    PlainReaders(of_file=_of_file, of_certificate=lambda mask: _plain(mask["matrices"])),
)
