"""The page of `subdiv show` for a terminal: stencils drawn as stencils, matrices as matrices, φ with letters."""

from __future__ import annotations

from subdiv_cli.model import Result
from subdiv_cli.model.blocks import Portrait
from subdiv_cli.model.closed import rational
from subdiv_cli.report import words
from subdiv_cli.report.blocks import Draw, put
from subdiv_cli.report.look import Look
from subdiv_cli.report.page import INDENT, Page, joined, paint


def render(result: Result, portrait: Portrait, draw: Draw, look: Look) -> str:
    """The text of the page."""
    page = Page(look)
    page.put(f"{words.name(result)}: {words.headline(result)}", "head", hanging=2)
    items = [result.file, result.kind or "", *(f"{name} = {rational(x)}" for name, x in result.parameters.items())]
    items = [page.say(item) for item in (*items, result.reference or "") if item]
    page.lines += joined(items, " · " if look.unicode else "; ", look.width, indent=INDENT, role="quiet")
    for hint in result.hints:
        page.put(f"hint: {hint}", "open", indent=INDENT, hanging=6)
    for section in portrait.sections:
        page.blank()
        page.put(section.title, "head")
        put(page, section.blocks, result, draw)
    return paint(page.lines, colour=look.colour)
