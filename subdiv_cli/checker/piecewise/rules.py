"""Documents of the kind `piecewise`: what their masks are, what is stated of them, and by which rules."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from subdiv_cli.checker.core import Rulebook, Step, Subject
from subdiv_cli.checker.numerals import UnreadableError
from subdiv_cli.checker.piecewise import conclusions, masks, polynomials, sides, spaces, spectra
from subdiv_cli.checker.plain import PlainReaders
from subdiv_cli.checker.radius.rules import FAMILY, ROOT, on_radii, root, shown
from subdiv_cli.checker.radius.rules import RULEBOOK as RADIUS
from subdiv_cli.checker.reading import Fields, several


def _side(value: object) -> object:
    """The name of a side."""
    if value not in ("left", "right"):
        raise UnreadableError("is not left or right")
    return value


_NONE: tuple[Fields, ...] = ({},)
_HOLDS: Fields = {"holds": "boolean"}
_BOUND: Fields = {"length": "length", "bound": "rational"}
_FACTORS = several("root", 200)
_PROPERTIES: Mapping[str, Fields] = {
    "side": {"side": _side},
    "family": {**FAMILY, "order": "natural"},
    "vanishing": {"order": "natural"},
    "local-spectrum": {"points": "integer[]", "factors": _FACTORS},
    "convergent": _HOLDS,
    "generation": {"degree": "natural"},
    "value-at-zero": {"start": "start", "weights": "rational[]"},
    "smooth": {"order": "natural"},
    "not-smooth": {"order": "natural"},
    "holder-lower": _BOUND,
    "holder-upper": _BOUND,
    "holder-root": ROOT,
    "zero-lower": _BOUND,
    "zero-upper": _BOUND,
    "zero-root": ROOT,
    "zero-polynomial": {},
    **RADIUS.properties,
}
_RULES = {
    "side": Step(("side",), {}, ({"certificate": "any"},), sides.side),
    "functionals": Step(("family",), {}, _NONE, spaces.functionals),
    "vanishing": Step(("vanishing",), {}, _NONE, spaces.vanishing),
    "eigenvalues": Step(("radius",), {}, ({"factors": _FACTORS, "inner": "rational"},), spectra.eigenvalues),
    "inside": Step(("radius-upper",), {}, _NONE, spectra.inside),
    "local-spectrum": Step(("local-spectrum",), {}, _NONE, spectra.local_spectrum),
    "converges": Step(("convergent",), {"holds": True}, _NONE, conclusions.converges),
    "side-diverges": Step(("convergent",), {"holds": False}, _NONE, conclusions.side_diverges),
    "row-diverges": Step(("convergent",), {"holds": False}, ({"row": "integer"},), conclusions.row_diverges),
    "expands": Step(("convergent",), {"holds": False}, _NONE, conclusions.expands),
    "generation": Step(("generation",), {}, _NONE, polynomials.generation),
    "value-at-zero": Step(("value-at-zero",), {}, _NONE, spaces.value_at_zero),
    "continuous": Step(("smooth",), {"order": 0}, _NONE, conclusions.continuous),
    "smooth": Step(("smooth",), {}, _NONE, conclusions.smooth),
    "side-not-smooth": Step(("not-smooth",), {}, _NONE, conclusions.side_not_smooth),
    "zero-not-smooth": Step(("not-smooth",), {}, _NONE, conclusions.zero_not_smooth),
    "holder-lower": Step(("holder-lower",), {}, _NONE, conclusions.holder_lower),
    "side-above": Step(("holder-upper",), {}, _NONE, conclusions.side_above),
    "zero-above": Step(("holder-upper", "zero-upper"), {}, _NONE, conclusions.zero_above),
    "holder-root": Step(("holder-root",), {}, ({"by": "any"},), conclusions.holder_root),
    "zero-root": Step(("zero-root",), {}, _NONE, conclusions.zero_root),
    "zero-lower": Step(("zero-lower",), {}, _NONE, conclusions.zero_lower),
    "zero-polynomial": Step(("zero-polynomial",), {}, _NONE, conclusions.zero_polynomial),
    **RADIUS.rules,
}


def in_words(s: Mapping[str, Any], subject: Subject) -> str:
    """A statement on the scheme of the document, or on what it does near 0, as a phrase."""
    p, name = subject.letters, s["property"]
    divided = f"/{s['length']}" if s.get("length", 1) > 1 else ""
    match name:
        case "side":
            return f"the certificate of the {s['side']} mask"
        case "family":
            on = "rows that sum to 0" if not s["order"] else f"functionals of order {s['order']}"
            return f"family {s['family']}: on {on}"
        case "vanishing":
            return f"nothing is left of the functionals of order {s['order']}"
        case "local-spectrum":
            return f"{sum(len(f) - 1 for f in s['factors'])} eigenvalues near 0"
        case "convergent":
            return "S converges" if s["holds"] else "S does not converge"
        case "generation":
            return f"generation degree {s['degree']}"
        case "value-at-zero":
            return f"F(0) from {len(s['weights'])} data"
        case "smooth" | "not-smooth":
            return f"all limits are C^{s['order']}" if name == "smooth" else f"not all limits are C^{s['order']}"
        case "zero-polynomial":
            return "limits are polynomials near 0"
        case "holder-lower" | "holder-upper" | "zero-lower" | "zero-upper":
            at = " at 0" if name.startswith("zero") else ""
            return f"alpha{at} {'>=' if name.endswith('lower') else '<='} -log{p}({shown(s['bound'])}){divided}"
        case "holder-root" | "zero-root":
            return f"alpha{' at 0' if name == 'zero-root' else ''} = -log{p}({root(s)}){divided}"
    return on_radii(s, f"family {s['family']}")


RULEBOOK = Rulebook(
    masks.FIELDS,
    masks.subject,
    _PROPERTIES,
    _RULES,
    in_words,
    PlainReaders(masks.of_file, masks.of_certificate),
)
