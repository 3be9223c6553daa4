"""`subdiv show` as a LaTeX document (amsmath, booktabs, tikz): it compiles as it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from subdiv_cli.model import Result
from subdiv_cli.model.anatomy import Anatomy, Curve
from subdiv_cli.report import words
from subdiv_cli.report.look import Look
from subdiv_cli.report.numbers import exact
from subdiv_cli.report.show.content import Block, Drawing, Formula, Grid, Matrix, Text, sections
from subdiv_cli.report.show.tex import formula, sentence

_WIDTH, _HEIGHT = 12, 5
"""Centimetres of the picture."""
_POINTS = 200
"""Of the picture, about."""
_LONG = 90
"""Letters of a formula beyond which it is set ragged right, to be broken."""

_HEAD = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{amsmath,amssymb,booktabs,tikz}
\setcounter{MaxMatrixCols}{20}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\begin{document}
"""


def render(result: Result, anatomy: Anatomy, picture: Sequence[str], look: Look) -> str:
    parameters = [f"{name} = {exact(x)}" for name, x in result.parameters.items()]
    about = ", ".join(sentence(item) for item in (result.file, *parameters, result.reference or "") if item)
    lines = [f"\\section*{{{sentence(words.name(result))}}}", sentence(words.headline(result)), "", about, ""]
    for section in sections(result, anatomy):
        lines.append(f"\\subsection*{{{sentence(section.title)}}}")
        for block in section.blocks:
            lines += [*_lines(block, anatomy), ""]
    return _HEAD + "\n".join(lines) + "\\end{document}\n"


def _lines(block: Block, anatomy: Anatomy) -> Iterator[str]:
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
    elif isinstance(block, Drawing) and anatomy.curve is not None:
        yield from _drawing(anatomy.curve, anatomy.support)


def _cell(text: str) -> str:
    return f"${formula(text)}$" if text else ""


def _drawing(curve: Curve, support: tuple[Fraction, Fraction]) -> Iterator[str]:
    """φ and the axis of x, scaled to the page."""
    first, last = map(float, support)
    step = 1.0 / curve.arity**curve.level
    every = max(1, len(curve.values) // _POINTS)
    inner = ((curve.start + i) * step for i in range(0, len(curve.values), every))
    points = [(first, 0.0), *zip(inner, map(float, curve.values[::every]), strict=True), (last, 0.0)]
    low, high = min(y for _, y in points), max(y for _, y in points)
    x_unit, y_unit = _WIDTH / (last - first), _HEIGHT / (high - low)
    yield f"\\begin{{center}}\\begin{{tikzpicture}}[x={x_unit:.5f}cm,y={y_unit:.5f}cm]"
    yield f"\\draw[gray] ({first:.5g},0) -- ({last:.5g},0);"
    yield "\\draw plot coordinates {" + " ".join(f"({x:.6g},{y:.6g})" for x, y in points) + "};"
    yield f"\\node[below] at ({first:.5g},0) {{${first:.4g}$}}; \\node[below] at ({last:.5g},0) {{${last:.4g}$}};"
    yield "\\end{tikzpicture}\\end{center}"
