"""A card for each mask of the HTML page: verdicts, exact numbers, stencils, the curve of φ, and the findings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from html import escape

from subdiv_cli.model import Drawing, Finding, LatticeMask, Result, Stencil, Verdict
from subdiv_cli.model.properties import PROPERTIES
from subdiv_cli.report import svg, words
from subdiv_cli.report.lattice import put_quasi_interpolation, put_stencils
from subdiv_cli.report.layout import paint
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import notices
from subdiv_cli.report.numbers import data, exact
from subdiv_cli.report.page import Page

MOST_WEIGHTS = 40
"""A stencil longer than this is left out: its numbers are in the mask."""
_COLUMNS = 60
"""Of the stencils in several variables: half of a wide page."""


def text(words_: str) -> str:
    """Somebody's words as HTML."""
    return escape(clean(words_))


def card(number: int, result: Result, look: Look) -> str:
    """Everything about one mask; its element is `mask-number`."""
    parts = [
        f'<article class="card" id="mask-{number}">',
        f"<h2>{_mark(result.status)} {text(words.name(result))}</h2>",
        f"<p>{text(words.headline(result))}</p>",
        f'<p class="quiet">{_about(result)}</p>',
    ]
    told = list(notices(result, look))
    if told:
        items = (f'<li class="{_LEVELS[n.level]}">{text(n.message)} <code>{text(n.code)}</code></li>' for n in told)
        parts.append(f"<ul>{''.join(items)}</ul>")
    if result.status != "invalid":
        parts.append('<div class="two"><div>')
        parts += [_properties(result), _expectations(result), "</div><div>"]
        parts += [*_pictures(result.drawing), *_grids(result.mask, result.findings), "</div></div>"]
        parts.append(_findings(look.shown(result.findings), look))
        if result.certificate is not None:
            parts.append(f"<p>proof: <code>{text(result.certificate)}</code></p>")
    return "".join([*parts, "</article>\n"])


_LEVELS = {"error": "bad", "warning": "open", "note": "quiet"}


def _mark(status: str) -> str:
    return f'<span class="{status}">{words.STATUS_MARKS[status]} {status}</span>'


def _about(result: Result) -> str:
    """File, kind, parameters, reference, then the facts."""
    items = [f"<code>{text(result.file)}</code>"]
    items += [text(result.kind)] if result.kind else []
    items += [f'<span class="exact">{text(name)} = {exact(value)}</span>' for name, value in result.parameters.items()]
    items += [text(result.reference)] if result.reference else []
    return " · ".join([*items, *map(text, words.facts(result))])


def _properties(result: Result) -> str:
    rows = []
    for row in PROPERTIES:
        shown = _verdict(getattr(result, row.key)) if row.form == "verdict" else _value(words.value(result, row))
        rows += [f"<tr><th>{row.title}</th><td>{shown}</td></tr>"] if shown else []
    return _table(rows)


def _expectations(result: Result) -> str:
    rows = []
    for judged in result.expectations:
        instead = words.found_instead(result, judged)
        found = f" — found {text(instead)}" if instead else ""
        asked = text(words.asked(judged.expectation))
        rows.append(f"<tr><th>{asked}</th><td>{_verdict(judged.verdict)}{found}</td></tr>")
    return f"<h3>expected</h3>{_table(rows)}" if rows else ""


def _table(rows: Iterable[str]) -> str:
    return f"<table>{''.join(rows)}</table>"


def _verdict(verdict: Verdict) -> str:
    return f'<span class="{verdict.value}">{words.mark(verdict)}</span>'


def _value(shown: str | None) -> str:
    return "" if shown is None else f'<span class="exact">{text(shown)}</span>'


def _pictures(drawing: Drawing | None) -> Iterator[str]:
    """The curve and the stencils, as far as there are any."""
    if drawing is None:
        return
    if drawing.curve:
        yield f"<figure>{svg.curve(drawing.curve, 'the refinable function φ')}"
        yield "<figcaption>φ, exact values at finitely many points</figcaption></figure>"
    else:
        yield '<p class="quiet">φ is drawn where convergence is proved.</p>'
    rows = [(f"(S f)_({len(drawing.rules)}k{f'+{e}' if e else ''})", rule) for e, rule in enumerate(drawing.rules)]
    if drawing.limit is not None:
        rows.append(("limit at k", drawing.limit))
    shown = [f"<tr><th>{name}</th><td>{_stencil(rule)}</td></tr>" for name, rule in rows]
    yield f"<h3>stencils</h3>{_table(shown)}"


def _grids(mask: LatticeMask | None, findings: Sequence[Finding]) -> Iterator[str]:
    """The stencils of a mask in several variables, as the text report has them."""
    if mask is None:
        return
    page = Page(Look(width=_COLUMNS))
    put_stencils(page, dict(mask.terms), mask.dilation)
    put_quasi_interpolation(page, findings)
    yield f"<h3>stencils</h3><pre>{escape(paint(page.lines))}</pre>"


def _stencil(stencil: Stencil) -> str:
    if len(stencil.weights) > MOST_WEIGHTS:
        return f"{len(stencil.weights)} weights"
    if not stencil.weights:
        return "0"
    last = stencil.first + len(stencil.weights) - 1
    where = " … ".join(map(_place, dict.fromkeys((stencil.first, last))))
    return f'<span class="exact">{", ".join(map(exact, stencil.weights))}</span> <span class="quiet">on {where}</span>'


def _place(offset: int) -> str:
    return f"f_(k{offset:+d})" if offset else "f_k"


def _findings(findings: Iterable[Finding], look: Look) -> str:
    items = [
        f"<li><code>{found.code}</code> {text(found.name)} {_verdict(found.verdict)}<br>{text(found.statement)}"
        + (f" (because {text(found.reason)})" if found.reason else "")
        + f'<br><span class="quiet">{text(found.source)}</span>{_witness(found) if look.verbosity > 1 else ""}</li>'
        for found in findings
    ]
    return f"<details><summary>{len(items)} findings</summary><ol>{''.join(items)}</ol></details>" if items else ""


def _witness(found: Finding) -> str:
    shown = (f"<br><code>{text(key)}: {text(data(value))}</code>" for key, value in found.witness.items())
    return "".join(shown)
