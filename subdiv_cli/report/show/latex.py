"""The page of `subdiv show` as a LaTeX document (amsmath, booktabs, tikz): it compiles as it is."""

from __future__ import annotations

from collections.abc import Iterator

from subdiv_cli.model import Result
from subdiv_cli.model.blocks import Block, Formula, Grid, Matrix, Picture, Portrait, Text
from subdiv_cli.model.closed import rational
from subdiv_cli.report import words
from subdiv_cli.report.blocks import Draw, tabled
from subdiv_cli.report.look import Look
from subdiv_cli.report.show.tex import formula, label, sentence
from subdiv_cli.report.show.tikz import picture

_LONG = 90
"""The letters of a formula beyond which it is set ragged right, to be broken."""

_HEAD = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{amsmath,amssymb,booktabs,tikz}
\setcounter{MaxMatrixCols}{20}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\begin{document}
"""


def render(result: Result, portrait: Portrait, draw: Draw, look: Look) -> str:
    """The document; its pictures are TikZ."""
    parameters = [f"{name} = {rational(x)}" for name, x in result.parameters.items()]
    about = ", ".join(
        filter(None, (label(result.file), *(sentence(item) for item in (*parameters, result.reference or ""))))
    )
    lines = [f"\\section*{{{sentence(words.name(result))}}}", sentence(words.headline(result)), "", about, ""]
    for section in portrait.sections:
        lines.append(f"\\subsection*{{{sentence(section.title)}}}")
        for block in section.blocks:
            for part in tabled(block, result):
                lines += [*_lines(part), ""]
    return _HEAD + "\n".join(lines) + "\\end{document}\n"


def _lines(block: Block) -> Iterator[str]:
    if isinstance(block, Text):
        yield sentence(block.text)
    elif isinstance(block, Formula):
        text = f"{formula(block.left)} = {formula(block.right)}"
        if len(block.right) <= _LONG:
            yield f"\\[ {text} \\]"
        else:
            yield f"{{\\raggedright ${text}$\\par}}"
    elif isinstance(block, Grid):
        yield f"\\begin{{center}}\\begin{{tabular}}{{r{'c' * len(block.nodes)}}}"
        yield " & ".join(map(_cell, (block.corner, *block.nodes))) + " \\\\ \\midrule"
        for name, numbers in block.rows:
            yield " & ".join(map(_cell, (name, *numbers))) + " \\\\"
        yield "\\end{tabular}\\end{center}"
    elif isinstance(block, Matrix):
        yield f"\\[ {formula(block.name)} = \\begin{{pmatrix}}"
        for row in block.rows:
            yield " & ".join(map(formula, row)) + " \\\\"
        yield "\\end{pmatrix} \\]"
    elif isinstance(block, Picture):
        yield from picture(block)


def _cell(text: str) -> str:
    return f"${formula(text)}$" if text else ""
