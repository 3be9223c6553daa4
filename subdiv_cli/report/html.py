"""The report as one self-contained HTML page: a sortable table of the masks and a card for each; works offline."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import subdiv_cli
from subdiv_cli.model import Exponent, Result
from subdiv_cli.report import marks, words
from subdiv_cli.report.cards import card, maths, text
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import finite

_ASSETS = Path(__file__).parent / "assets"
_ALONE = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
"""The policy by which the page may load nothing at all."""
_TITLES = ("status", "mask", "convergence", "smoothness", "Hölder exponent", "sum rules", "file")


def pieces(results: Sequence[Result], look: Look) -> Iterator[str]:
    """The HTML page."""
    for piece in _page(results, look):
        yield piece if piece.isascii() else piece.encode("utf-8", "backslashreplace").decode("utf-8")


def _page(results: Sequence[Result], look: Look) -> Iterator[str]:
    title = text(words.footer(results, allow_undecided=look.allow_undecided))
    yield '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
    yield '<meta name="viewport" content="width=device-width, initial-scale=1">'
    yield f'<meta http-equiv="Content-Security-Policy" content="{_ALONE}">'
    yield f"<title>subdiv: {title}</title><style>{_asset('page.css')}</style></head><body>\n"
    yield f"<header><h1>Smoothness of subdivision schemes</h1><p>{title}</p>"
    yield f"{_remarks(look)}</header><main>"
    yield _find()
    yield '<div class="scroll"><table class="overview"><thead><tr>'
    yield "".join(f'<th scope="col"><button type="button">{name}</button></th>' for name in _TITLES)
    yield "</tr></thead><tbody>\n"
    yield from (_row(number, result) for number, result in _ordered(results))
    yield "</tbody></table></div>\n"
    yield from (card(number, result, look) for number, result in _ordered(results))
    yield f'<p class="quiet">subdiv {subdiv_cli.__version__}. Every verdict is a theorem: '
    yield "<code>subdiv explain CODE</code> says which.</p>"
    yield f"</main><script>{_asset('page.js')}</script></body></html>\n"


def _ordered(results: Sequence[Result]) -> Iterator[tuple[int, Result]]:
    """The results with their numbers, those that did not pass first."""
    for status in ("failed", "invalid", "undecided", "passed"):
        yield from ((number, result) for number, result in enumerate(results, 1) if result.status == status)


def _asset(name: str) -> str:
    return (_ASSETS / name).read_text(encoding="utf-8")


def _remarks(look: Look) -> str:
    remarks = []
    if look.interrupted:
        remarks.append("The run was interrupted: not all masks were checked.")
    if look.shard is not None:
        remarks.append(f"Part {look.shard[0]} of {look.shard[1]}.")
    if look.missing:
        remarks.append(f"Of the baseline, not checked: {', '.join(look.missing)}.")
    return "".join(f'<p class="open">{text(remark)}</p>' for remark in remarks)


def _find() -> str:
    options = "".join(f"<option>{status}</option>" for status in marks.STATUSES)
    return (
        '<div class="find" hidden><input id="text" type="search" placeholder="find a mask" aria-label="find a mask">'
        f'<select id="status" aria-label="status"><option value="">every status</option>{options}</select></div>\n'
    )


def _row(number: int, result: Result) -> str:
    name, order = words.name(result), result.refinable.order
    exponent = result.holder or Exponent()
    lower = finite(exponent.lower)
    cells = [
        (f'<span class="{result.status}">{marks.of_status(result.status).text}</span>', result.status),
        (f'<a href="#mask-{number}">{text(name)}</a>', name),
        (text(words.convergence(result)), words.convergence(result)),
        (
            maths(words.smoothness_or_that_of_phi(result) or ""),
            "" if order is None else str(order).replace("inf", "Infinity"),
        ),
        (text(words.holder(result) or ""), "" if lower is None else repr(lower)),
        (("" if result.sum_rule_order is None else str(result.sum_rule_order),) * 2),
        (f"<code>{text(result.file)}</code>", result.file),
    ]
    if result.status == "invalid":
        cells[2:6] = [(text(words.errors(result)), ""), ("", ""), ("", ""), ("", "")]
    shown = "".join(
        f'<td data-label="{title}" data-sort="{text(key)}">{cell}</td>'
        for title, (cell, key) in zip(_TITLES, cells, strict=True)
    )
    searchable = text(f"{name} {result.file}".lower())
    return f'<tr data-card="mask-{number}" data-status="{result.status}" data-text="{searchable}">{shown}</tr>\n'
