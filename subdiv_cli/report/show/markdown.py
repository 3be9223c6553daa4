"""The page of `subdiv show` as Markdown: tables for stencils, code for formulas and matrices."""

from __future__ import annotations

from collections.abc import Sequence

from subdiv_cli.model import Result
from subdiv_cli.model.blocks import Block, Formula, Grid, Matrix, Picture, Portrait, Text
from subdiv_cli.model.closed import rational
from subdiv_cli.report import words
from subdiv_cli.report.blocks import Draw, tabled
from subdiv_cli.report.letters import clean
from subdiv_cli.report.look import Look


def render(result: Result, portrait: Portrait, draw: Draw, look: Look) -> str:
    """The document."""
    parameters = [f"{name} = {rational(x)}" for name, x in result.parameters.items()]
    about = " · ".join(_escaped(item) for item in (result.file, *parameters, result.reference or "") if item)
    lines = [f"# {_escaped(words.name(result))}", "", _escaped(words.headline(result)), "", about]
    for section in portrait.sections:
        lines += ["", f"## {section.title}"]
        for block in section.blocks:
            for part in tabled(block, result):
                lines += ["", *_lines(part, draw)]
    return "\n".join(lines).rstrip() + "\n"


def _lines(block: Block, draw: Draw) -> list[str]:
    if isinstance(block, Text):
        return [_escaped(block.text)]
    if isinstance(block, Formula):
        return [f"`{block.left} = {block.right}`"]
    if isinstance(block, Grid):
        head = [block.corner, *block.nodes]
        rows = [[name, *numbers] for name, numbers in block.rows]
        return [_row(head), _row(["---:"] * len(head)), *map(_row, rows)]
    if isinstance(block, Matrix):
        widths = [max(len(row[i]) for row in block.rows) for i in range(len(block.rows[0]))]
        rows_ = ["  ".join(x.rjust(widths[i]) for i, x in enumerate(row)) for row in block.rows]
        return ["```text", f"{block.name} =", *(f"  {row}" for row in rows_), "```"]
    return ["```text", *draw(block), "```"] if isinstance(block, Picture) else []


def _row(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def _escaped(text: str) -> str:
    """Plain text in which Markdown finds nothing to set."""
    return "".join("\\" + c if c in "\\`*_{}[]<>#|~" else c for c in clean(text))
