"""`subdiv show` of a mask in several variables: as text, as JSON in the envelope of `json.py`, and by its sections."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import subdiv_cli
from subdiv_cli.model import Result
from subdiv_cli.model.blocks import SurfaceAnatomy
from subdiv_cli.report import findings, words
from subdiv_cli.report.json import as_data, plain, valid
from subdiv_cli.report.lattice import QUASI_TITLE, put_stencils, put_values, stencils
from subdiv_cli.report.layout import joined, paint
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import exact
from subdiv_cli.report.page import INDENT, Page
from subdiv_cli.report.show import latex, markdown
from subdiv_cli.report.show.content import Text
from subdiv_cli.report.show.surface import differences, inversion, sections, symbol
from subdiv_cli.report.show.tikz import relief

Index = tuple[int, ...]


def render(form: str, result: Result, anatomy: SurfaceAnatomy, picture: Sequence[str], look: Look) -> str:
    """`form` is one of the formats of `subdiv show`."""
    if form == "json":
        return _json(result, anatomy, look)
    if form == "markdown":
        return markdown.page(result, sections(result, anatomy), picture)
    if form == "latex":
        return latex.page(result, sections(result, anatomy), tuple(relief(anatomy.surface)) if anatomy.surface else ())
    return _text(result, anatomy, picture, look)


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
        page.put(differences(result, anatomy), indent=INDENT, hanging=2)
    _head(page, "Stencils")
    put_stencils(page, anatomy.terms, anatomy.dilation)
    if anatomy.values:
        _head(page, "Refinable function")
        page.lines += [[(" " * INDENT + line, "text")] for line in picture]
        if anatomy.centre is not None:
            page.put(f"centre of mass {_tuple(anatomy.centre)}", indent=INDENT)
        put_values(page, "φ at the integers", anatomy.values)
    if anatomy.operator:
        _head(page, "Polynomials")
        _put_polynomials(page, anatomy)
    _head(page, "Findings")
    findings.show(page, look.shown(result.findings))
    return paint(page.lines, colour=look.colour)


def _head(page: Page, title: str) -> None:
    page.blank()
    page.put(title, "head")


def _put_polynomials(page: Page, anatomy: SurfaceAnatomy) -> None:
    for block in inversion(anatomy):
        text = block.text if isinstance(block, Text) else f"{block.left} = {block.right}"
        page.put(text, indent=INDENT, hanging=4)
    if len(anatomy.quasi_stencil) > 1:
        put_values(page, QUASI_TITLE, anatomy.quasi_stencil)


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
        "quasi_interpolation": None if not anatomy.operator else _quasi(result, anatomy),
    }
    return valid(json.dumps(page, ensure_ascii=False, indent=2, allow_nan=False) + "\n")


def _quasi(result: Result, anatomy: SurfaceAnatomy) -> dict[str, Any]:
    return {
        "degree": result.generation,
        "moments": _terms(anatomy.moments),
        "operator": _terms(anatomy.operator),
        "stencil": _terms(anatomy.quasi_stencil),
    }


def _terms(values: Mapping[Index, Any]) -> list[Any]:
    """Pairs of an index and a number."""
    return [[plain(index), plain(value)] for index, value in sorted(values.items())]


def _cosets(anatomy: SurfaceAnatomy) -> Iterator[dict[str, Any]]:
    for stencil in stencils(anatomy.terms, anatomy.dilation):
        yield {"coset": plain(stencil.coset), "at": plain(stencil.at), "stencil": _terms(stencil.weights)}
