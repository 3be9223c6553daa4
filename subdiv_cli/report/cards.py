"""The cards of the HTML page, one for each mask: verdicts, exact numbers, stencils, the curve of φ, and findings."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from html import escape
from itertools import groupby

from subdiv_cli.model import Finding, Result
from subdiv_cli.model.blocks import (
    Block,
    Curve,
    Formula,
    Grid,
    Matrix,
    Picture,
    Planes,
    Section,
    Statements,
    Text,
    Words,
)
from subdiv_cli.model.closed import rational
from subdiv_cli.model.properties import PROPERTIES
from subdiv_cli.report import marks, svg, words
from subdiv_cli.report.blocks import put
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look
from subdiv_cli.report.notices import notices
from subdiv_cli.report.numbers import data
from subdiv_cli.report.page import Page, paint

MOST_WEIGHTS = 40
"""The most weights of a stencil that is shown: the numbers of a longer one are in the mask."""
_ORDER = re.compile(r"\bC\^(\d+|∞)")
_COLUMNS = 60
"""The columns of the stencils in several variables: half of a wide page."""


def text(words_: str) -> str:
    """A text from a file as HTML."""
    return escape(clean(words_))


def maths(words_: str) -> str:
    """A text with mathematics as HTML, the order of smoothness set as a power: C², not C^2."""
    return _ORDER.sub(r"C<sup>\1</sup>", text(words_))


def card(number: int, result: Result, look: Look) -> str:
    """The HTML of everything about one mask; its element is `mask-number`."""
    parts = [
        f'<article class="card" id="mask-{number}">',
        f"<h2>{_mark(result.status)} {text(words.name(result))}</h2>",
        f"<p>{maths(words.headline(result))}</p>",
        f'<p class="quiet">{_about(result)}</p>',
    ]
    remarks = list(notices(result, look))
    if remarks:
        items = (f'<li class="{_LEVELS[n.level]}">{maths(n.message)} <code>{text(n.code)}</code></li>' for n in remarks)
        parts.append(f"<ul>{''.join(items)}</ul>")
    if result.status != "invalid":
        parts.append('<div class="two"><div>')
        parts += [_properties(result), _expectations(result), "</div><div>"]
        parts += [*(_section(section, result) for section in result.sections), "</div></div>"]
        parts.append(_findings(result, look))
        if result.certificate is not None:
            parts.append(f"<p>proof: <code>{text(result.certificate)}</code></p>")
    return "".join([*parts, "</article>\n"])


_LEVELS = {"error": "bad", "warning": "open", "note": "quiet"}


def _mark(status: str) -> str:
    return f'<span class="{status}">{marks.of_status(status).text}</span>'


def _about(result: Result) -> str:
    """The HTML of file, kind, parameters, reference, then the facts."""
    items = [f"<code>{text(result.file)}</code>"]
    items += [text(result.kind)] if result.kind else []
    items += [f'<span class="exact">{text(name)} = {rational(x)}</span>' for name, x in result.parameters.items()]
    items += [text(result.reference)] if result.reference else []
    return " · ".join([*items, *map(text, words.facts(result))])


def _properties(result: Result) -> str:
    rows = []
    for row in PROPERTIES:
        verdict = row.form == "verdict"
        shown = _verdict(marks.of_verdict(getattr(result, row.key))) if verdict else _value(words.value(result, row))
        rows += [f"<tr><th>{row.title}</th><td>{shown}</td></tr>"] if shown else []
    return _table(rows)


def _expectations(result: Result) -> str:
    rows = []
    for judged in result.expectations:
        instead = words.actual_unless_proved(result, judged)
        ending = f" — found {maths(instead)}" if instead else ""
        expected = maths(words.expected(judged.expectation))
        rows.append(f"<tr><th>{expected}</th><td>{_verdict(marks.of_verdict(judged.verdict))}{ending}</td></tr>")
    return f"<h3>expected</h3>{_table(rows)}" if rows else ""


def _table(rows: Iterable[str]) -> str:
    return f"<table>{''.join(rows)}</table>"


def _verdict(mark: marks.Shown) -> str:
    return f'<span class="{mark.name}">{mark.text}</span>'


def _value(shown: str | None) -> str:
    return "" if shown is None else f'<span class="exact">{maths(shown)}</span>'


def _section(section: Section, result: Result) -> str:
    """The HTML of a section: curves as pictures, stencils as tables, and the rest in the words of the text report."""
    whole = any(isinstance(block, _AS_TEXT) for block in section.blocks)

    def shown(block: Block) -> Callable[[Sequence[Block], Result], str]:
        return (
            _rows if isinstance(block, Grid) else _figures if isinstance(block, Picture) else _pre if whole else _words
        )

    title = f"<h3>{text(section.title)}</h3>" if section.title else ""
    return title + "".join(show(list(blocks), result) for show, blocks in groupby(section.blocks, shown))


_AS_TEXT = Planes | Matrix | Formula | Statements | Words


def _pre(blocks: Sequence[Block], result: Result) -> str:
    page = Page(Look(width=_COLUMNS))
    put(page, blocks, result)
    return f"<pre>{escape(paint(page.lines))}</pre>"


def _words(blocks: Sequence[Block], result: Result) -> str:
    return "".join(f'<p class="{block.role}">{text(block.text)}</p>' for block in blocks if isinstance(block, Text))


def _figures(blocks: Sequence[Block], result: Result) -> str:
    """The HTML of graphs; other pictures are not drawn here."""
    parts = []
    for curve in (block for block in blocks if isinstance(block, Curve)):
        caption = f"<figcaption>{curve.title}, exact values at finitely many points</figcaption>"
        what = "the limit function" if curve.label else "the refinable function"
        parts.append(f"<figure>{svg.curve(curve, f'{what} {curve.title}')}{caption}</figure>")
    return "".join(parts)


def _rows(blocks: Sequence[Block], result: Result) -> str:
    """The HTML of one table of all grids."""
    rows = []
    for grid in (block for block in blocks if isinstance(block, Grid)):
        for name, numbers in grid.rows:
            used = [i for i, number in enumerate(numbers) if number]
            rows.append(f"<tr><th>{text(name)}</th><td>{_stencil(grid.nodes, numbers, used)}</td></tr>")
    return _table(rows)


def _stencil(nodes: Sequence[str], numbers: Sequence[str], used: Sequence[int]) -> str:
    if len(used) > MOST_WEIGHTS:
        return f"{len(used)} weights"
    if not used:
        return "0"
    where = " … ".join(nodes[i] for i in dict.fromkeys((used[0], used[-1])))
    shown = ", ".join(numbers[i] for i in used)
    return f'<span class="exact">{text(shown)}</span> <span class="quiet">on {text(where)}</span>'


def _findings(result: Result, look: Look) -> str:
    findings = look.shown(result.findings)
    items = [
        f"<li><code>{finding.code}</code> {text(finding.name)} {_verdict(marks.of_finding(result, finding))}"
        + f"<br>{maths(finding.statement)}"
        + (f" (because {maths(finding.reason)})" if finding.reason else "")
        + f'<br><span class="quiet">{text(finding.source)}</span>{_witness(finding) if look.verbosity > 1 else ""}</li>'
        for finding in findings
    ]
    meanings = words.legend(finding.statement for finding in findings)
    legend = f'<p class="quiet">{text(meanings)}</p>' if meanings else ""
    shown = f"<summary>{len(items)} findings</summary>{legend}<ol>{''.join(items)}</ol>"
    return f"<details>{shown}</details>" if items else ""


def _witness(finding: Finding) -> str:
    shown = (f"<br><code>{text(key)}: {text(data(value))}</code>" for key, value in finding.witness.items())
    return "".join(shown)
