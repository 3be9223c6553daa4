"""`subdiv show` of a mask in several variables: as text, and as JSON in the envelope of `json.py`."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import subdiv_cli
from subdiv_cli.model import Result
from subdiv_cli.model.anatomy import SurfaceAnatomy
from subdiv_cli.report import findings, words
from subdiv_cli.report.json import as_data, plain, valid
from subdiv_cli.report.lattice import put_stencils, put_values, stencils
from subdiv_cli.report.layout import joined, paint
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import exact
from subdiv_cli.report.page import INDENT, Page
from subdiv_cli.report.show.formulas import combination, power

Index = tuple[int, ...]

_LONGEST = 40
"""Terms of a quotient that are written out."""


def render(form: str, result: Result, anatomy: SurfaceAnatomy, picture: Sequence[str], look: Look) -> str:
    """`form` is text or json."""
    return _json(result, anatomy, look) if form == "json" else _text(result, anatomy, picture, look)


def _text(result: Result, anatomy: SurfaceAnatomy, picture: Sequence[str], look: Look) -> str:
    page = Page(look)
    page.put(f"{words.name(result)}: {words.headline(result)}", "head", hanging=2)
    items = [result.file, result.kind or "", *(f"{name} = {exact(x)}" for name, x in result.parameters.items())]
    items = [page.say(item) for item in (*items, result.reference or "") if item]
    page.lines += joined(items, " · " if look.unicode else "; ", look.width, indent=INDENT, role="quiet")
    _head(page, "Mask")
    page.put(", ".join(words.facts(result)), indent=INDENT, hanging=2)
    page.put(f"a(z) = {symbol(anatomy)}", indent=INDENT, hanging=4)
    if anatomy.differences is not None:
        page.put(_differences(result, anatomy), indent=INDENT, hanging=2)
    _head(page, "Stencils")
    put_stencils(page, anatomy.terms, anatomy.dilation)
    if anatomy.values:
        _head(page, "Refinable function")
        page.lines += [[(" " * INDENT + line, "text")] for line in picture]
        if anatomy.centre is not None:
            page.put(f"centre of mass {_tuple(anatomy.centre)}", indent=INDENT)
        put_values(page, "φ at the integers", anatomy.values)
    _head(page, "Findings")
    findings.show(page, look.shown(result.findings))
    return paint(page.lines, colour=look.colour)


def _head(page: Page, title: str) -> None:
    page.blank()
    page.put(title, "head")


def _differences(result: Result, anatomy: SurfaceAnatomy) -> str:
    k = result.sum_rule_order
    return f"V_{k}, the space of the differences of order {k}, has dimension {anatomy.differences}"


def symbol(anatomy: SurfaceAnatomy) -> str:
    """`1/16 (1 + z1)^2 (1 + z2)^2 (1 + z1 z2)^2`; a quotient of several terms in brackets, a long one by its length."""
    c = anatomy.dilation[0][0]
    product = " ".join(_factor(theta, c) + (f"^{n}" if n > 1 else "") for theta, n in anatomy.factors.items())
    if len(anatomy.quotient) == 1:
        ((index, value),) = anatomy.quotient.items()
        return combination([(value, " ".join(filter(None, (_monomial(index), product))))])
    if len(anatomy.quotient) > _LONGEST:
        rest = f"{len(anatomy.quotient)} terms"
    else:
        rest = combination((value, _monomial(index)) for index, value in anatomy.quotient.items())
    return f"{product} ({rest})" if product else rest


def _factor(theta: Index, c: int) -> str:
    terms = [_monomial(tuple(i * x for x in theta)) for i in range(1, c)]
    return f"(1 + {' + '.join(terms if c < 5 else [terms[0], '…', terms[-1]])})"


def _monomial(index: Index) -> str:
    return " ".join(filter(None, (power(f"z{i}", x) for i, x in enumerate(index, 1))))


def _tuple(entries: Sequence[Any]) -> str:
    return f"({', '.join(map(exact, entries))})"


def _json(result: Result, anatomy: SurfaceAnatomy, look: Look) -> str:
    page = {
        "format": "subdiv-show",
        "version": 1,
        "tool": {"name": "subdiv", "version": subdiv_cli.__version__},
        "report": as_data(result, look),
        "mask": {"dilation": plain(anatomy.dilation), "terms": _terms(anatomy.terms)},
        "symbol": {
            "text": symbol(anatomy),
            "factors": [{"direction": plain(theta), "multiplicity": n} for theta, n in anatomy.factors.items()],
            "quotient": _terms(anatomy.quotient),
        },
        "cosets": list(_cosets(anatomy)),
        "difference_space": None
        if anatomy.differences is None
        else {"order": result.sum_rule_order, "dimension": anatomy.differences},
        "centre": plain(anatomy.centre),
        "values": _terms(anatomy.values) if anatomy.values else None,
    }
    return valid(json.dumps(page, ensure_ascii=False, indent=2, allow_nan=False) + "\n")


def _terms(values: Mapping[Index, Any]) -> list[Any]:
    """Pairs of an index and a number."""
    return [[plain(index), plain(value)] for index, value in sorted(values.items())]


def _cosets(anatomy: SurfaceAnatomy) -> Iterator[dict[str, Any]]:
    for stencil in stencils(anatomy.terms, anatomy.dilation):
        yield {"coset": plain(stencil.coset), "at": plain(stencil.at), "stencil": _terms(stencil.weights)}
