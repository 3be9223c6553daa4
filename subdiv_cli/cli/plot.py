"""`subdiv plot`: the refinable function and its derivatives, or curves of a control polygon; surfaces and nets."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING

import click

from subdiv_cli.cli import single
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.streams import emit, look_of, why_not
from subdiv_cli.cli.values import WholeType

if TYPE_CHECKING:
    from subdiv_cli.kinds.scalar.scheme import ScalarScheme
    from subdiv_cli.maskfile.points import Points
    from subdiv_cli.model import Effort, Result
    from subdiv_cli.plot.figure import Panel
    from subdiv_cli.plot.sampled import Line

_EPILOG = """\b
Examples:
  subdiv plot masks/scalar/four_point.toml
  subdiv plot masks/scalar/four_point.toml -o phi.svg
  subdiv plot masks/scalar/four_point.toml -p w=1/32 -p w=1/16 -p w=1/10 -o phi.pdf
  subdiv plot masks/scalar/four_point.toml --points polygon.csv --closed -o curve.svg
  subdiv plot masks/scalar/four_point.toml masks/scalar/six_point.toml --points polygon.csv
      -p w=.022 -p w=.04 -p theta=.002 -p theta=.014 -p theta=.02 -o figure.svg
  subdiv plot masks/multivariate/loop.toml --as contour -o loop.svg
  subdiv plot masks/multivariate/butterfly.toml -p w=1/16 -p w=1/32 -o butterfly.png
  subdiv plot masks/multivariate/loop.toml -o net.obj --points net.csv --levels 4

\b
Exit codes:
  0    drawn
  1    there is nothing to draw: no continuous refinable function, or no limit
  2    not drawn: usage, an unreadable or invalid mask, a file that cannot be written
  3    nothing to draw within the effort: neither proved nor refuted
"""

_POINTS = 600
_HEIGHT = 18
_MOST_LEVELS = 8
_DERIVATIVES = 4
"""Drawn unless more are asked for."""


@click.command("plot", epilog=_EPILOG, short_help="Draw the refinable function, its derivatives, and curves.")
@click.argument("files", nargs=-1, type=click.Path(), metavar="[FILE | -]...")
@single.options
@click.option(
    "-o",
    "--output",
    metavar="FILE",
    type=click.Path(),
    help="Write an .svg, .png or .pdf, or a net as .obj.  [default: draw here]",
)
@click.option(
    "--as",
    "style",
    type=click.Choice(["surface", "contour"]),
    help="How a function of two variables is drawn into a file.  [default: surface]",
)
@click.option(
    "--derivatives",
    type=click.IntRange(0),
    metavar="N",
    help="Derivatives to draw.  [default: those proved continuous, four at most]",
)
@click.option(
    "--points",
    "polygon",
    metavar="FILE.csv",
    type=click.Path(),
    help="Draw the limit of this control polygon: a point x,y in a line. Of an .obj the net: i,j,x,y,z.",
)
@click.option(
    "--closed/--open", "closed", default=None, help="Whether the polygon is closed.  [default: if its ends meet]"
)
@click.option(
    "--levels",
    type=click.IntRange(0, _MOST_LEVELS),
    metavar="K",
    help="Draw the control polygons up to level K too. Of an .obj: refine K times.  [default: 0; of an .obj 3]",
)
@click.option("--samples", type=WholeType(), metavar="N", help=f"Points of a curve, at least.  [default: {_POINTS}]")
@click.option("--debug", is_flag=True, help="Show the traceback of an internal error.")
def command(
    files: tuple[str, ...],
    parameters: tuple[str, ...],
    mask: str | None,
    start: tuple[int, ...] | None,
    arity: int | None,
    effort: int,
    output: str | None,
    style: str | None,
    derivatives: int | None,
    polygon: str | None,
    closed: bool | None,
    levels: int | None,
    samples: int | None,
    debug: bool,
) -> ExitCode:
    """Draw the refinable function and its derivatives, as far as they are proved continuous.

    With --points the limit curve of a control polygon. All values are exact, at points i/p^m. A parameter with several
    values, and several masks, give a curve each.

    Of a mask in two variables a surface, in more a slice of it through the centre. Into an .obj goes a net: the graph
    of the function, or with --points a control net, refined as far as it is determined.
    """
    _writable(output)
    family = single.read_family(single.Named("plot", files, mask, start, arity, parameters))
    from subdiv_cli.model import Effort

    kinds = {one.mask.kind for one in family}
    if len(kinds) > 1:
        raise click.UsageError("masks in one variable and in several are not drawn into one picture")
    if kinds == {"multivariate"}:
        from subdiv_cli.cli import plot_surfaces

        for name, value in (("--derivatives", derivatives), ("--closed, --open", closed), ("--samples", samples)):
            if value is not None:
                raise click.UsageError(f"{name} belongs to curves, those of masks in one variable")
        asked = plot_surfaces.Asked(output, style, polygon, levels)
        return plot_surfaces.plot(family, asked, Effort(effort), _nothing)
    _usage(output, style, polygon, closed, levels, derivatives)
    panels: list[Panel] | ExitCode
    points = min(samples or _POINTS, 10_000)
    if polygon is None:
        panels = _functions(family, Effort(effort), points, derivatives)
    else:
        panels = _curves(family, Effort(effort), points, _points(polygon), closed, levels or 0)
    if isinstance(panels, ExitCode):
        return panels
    return _terminal(panels) if output is None else _file(panels, output)


def _writable(output: str | None) -> None:
    from subdiv_cli.cli.plot_surfaces import OBJ
    from subdiv_cli.plot.figure import SUFFIXES

    if output is None:
        return
    if PurePath(output).suffix.lower() not in (*SUFFIXES, OBJ):
        raise click.BadParameter(f"{output!r} must end in {', '.join((*SUFFIXES, OBJ))}", param_hint="-o")
    if (reason := why_not(output)) is not None:
        raise click.BadParameter(f"{output!r} cannot be written: {reason}", param_hint="-o")


def _usage(
    output: str | None,
    style: str | None,
    polygon: str | None,
    closed: bool | None,
    levels: int | None,
    derivatives: int | None,
) -> None:
    """For masks in one variable."""
    if style is not None:
        raise click.UsageError("--as belongs to surfaces, those of masks in several variables")
    if output is not None and PurePath(output).suffix.lower() == ".obj":
        raise click.UsageError("an .obj is the net of a mask in two variables")
    if polygon is None and (closed is not None or levels):
        raise click.UsageError("--closed, --open and --levels belong to --points")
    if polygon is not None and derivatives is not None:
        raise click.UsageError("--derivatives are those of the refinable function: leave out --points")


def _points(file: str) -> Points:
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.points import read_points

    try:
        return read_points(file)
    except MaskFileError as error:
        single.complain(error.problems)


def _scheme(one: single.One) -> ScalarScheme:
    from subdiv_cli.kinds.scalar.scheme import ScalarScheme

    assert isinstance(one.scheme, ScalarScheme)
    return one.scheme


def _functions(
    family: Sequence[single.One], effort: Effort, samples: int, derivatives: int | None
) -> list[Panel] | ExitCode:
    """A panel for φ and one for each derivative, a line in it for each mask that has it."""
    from subdiv_cli.plot.figure import Panel
    from subdiv_cli.plot.sampled import graph
    from subdiv_cli.portrait import drawn

    rows: list[list[Line]] = []
    for one in family:
        result, curves, support = drawn(_scheme(one), effort, samples)
        label = one.title(family)
        if not curves:
            return _nothing(one, result, ("SD302",), "φ is not proved continuous")
        for curve in curves[: (_DERIVATIVES if derivatives is None else derivatives) + 1]:
            if curve.order == len(rows):
                rows.append([])
            rows[curve.order].append(graph(curve, label, support))
    title = family[0].title() if len(family) == 1 else "φ"
    names = (("φ" + "'" * order if order < 4 else f"φ^({order})") for order in range(len(rows)))
    return [
        Panel(f"{name} — {title}" if title != "φ" else name, tuple(lines))
        for name, lines in zip(names, rows, strict=True)
    ]


def _curves(
    family: Sequence[single.One], effort: Effort, samples: int, columns: Points, closed: bool | None, levels: int
) -> list[Panel] | ExitCode:
    """One panel: the control polygon, the refined ones of the first mask, and the limit curve of each mask."""
    from subdiv_cli.plot.figure import Panel
    from subdiv_cli.plot.sampled import plane
    from subdiv_cli.portrait import TooFewPointsError, traced

    meets = columns[0][0] == columns[0][-1] and columns[1][0] == columns[1][-1]
    closed = meets if closed is None else closed
    if closed and meets and len(columns[0]) > 2:
        columns = (columns[0][:-1], columns[1][:-1])
    lines = [plane("control polygon", *columns, closed=closed, polygon=True)]
    for number, one in enumerate(family):
        try:
            result, curves, refined = traced(
                _scheme(one), effort, columns, samples, closed=closed, levels=0 if number else levels
            )
        except TooFewPointsError as error:
            raise click.ClickException(f"{error}: give more, or --closed") from None
        if not curves:
            return _nothing(one, result, ("SD201",), "S is not proved to converge")
        for level, (x, y) in enumerate(refined, 1):
            lines.append(plane(f"level {level}", x, y, closed=closed, polygon=True))
        across, up = (curve.values for curve in curves)
        lines.append(plane(one.title(family), across, up, closed=False))
    title = family[0].title() if len(family) == 1 else "limit curves"
    return [Panel(title, tuple(lines), plane=True)]


def _nothing(one: single.One, result: Result, codes: Sequence[str], undecided: str) -> ExitCode:
    """Why there is nothing to draw, on stderr."""
    from subdiv_cli.model import Verdict
    from subdiv_cli.report.numbers import exact

    verdicts = {found.code: found for found in result.findings}
    found = next((verdicts[code] for code in codes if verdicts[code].verdict is Verdict.REFUTED), None)
    at = ", ".join(f"{name} = {exact(value)}" for name, value in one.parameters.items())
    name = f"{one.mask.name or one.mask.file}{f' at {at}' if at else ''}"
    why = undecided if found is None else found.statement
    emit(f"{name}: nothing to draw, {why}\n", sys.stderr)
    return ExitCode.UNDECIDED if found is None else ExitCode.FAILED


def _terminal(panels: Sequence[Panel]) -> ExitCode:
    """The panels drawn with letters; several lines in one are not told apart by colour."""
    from subdiv_cli.plot.terminal import draw
    from subdiv_cli.report.letters import letters

    look = look_of(sys.stdout)
    rows: list[str] = []
    for panel in panels:
        shown = (
            panel.lines if len(panel.lines) < 2 else [line for line in panel.lines if not line.polygon] or panel.lines
        )
        rows += ["", letters(panel.title, look.unicode)] if rows else [letters(panel.title, look.unicode)]
        rows += draw(shown, width=look.width, height=_HEIGHT, unicode=look.unicode)
    return single.print_rows(rows)


def _file(panels: Sequence[Panel], output: str) -> ExitCode:
    from subdiv_cli.plot.figure import picture

    return single.write_picture(output, lambda: picture(panels, PurePath(output).suffix.lower().lstrip(".")))
