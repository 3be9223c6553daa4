"""The command `subdiv plot`: the refinable function and its derivatives, curves of a polygon, surfaces and nets."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

import click

from subdiv_cli.cli import single
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.options import debug as debug_option
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import emit, look_of, put, put_file, why_not
from subdiv_cli.cli.values import WHOLE

if TYPE_CHECKING:
    from subdiv_cli.kinds.kind import Drawings
    from subdiv_cli.model.blocks import Drawing, Net
    from subdiv_cli.plot.panels import Drawn

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
_MOST_POINTS = 10_000
_MOST_LEVELS = 8
_OBJ = ".obj"
_UNPROVED = {"smoothness": "φ is not proved continuous", "convergence": "S is not proved to converge"}
"""The reason why nothing is drawn, by the question that is not decided."""


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
@click.option("--samples", type=WHOLE, metavar="N", help=f"Points of a curve, at least.  [default: {_POINTS}]")
@debug_option
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
    family = single.read_family(single.Named("plot", "drawings", files, mask, start, arity, parameters))
    options: dict[str, Any] = {
        "style": style, "derivatives": derivatives, "points": polygon, "closed": closed, "levels": levels,
        "samples": samples,
    }  # fmt: skip
    given = {name for name, value in options.items() if value is not None}
    drawings = _drawings(family, given, "" if output is None else PurePath(output).suffix.lower())
    options["samples"] = min(samples or _POINTS, _MOST_POINTS)
    if polygon is not None:
        options["points"] = _points(drawings[0], polygon)
    with Progress().watching():
        drawn = _drawn(family, drawings, options, effort)
    if isinstance(drawn, ExitCode):
        return drawn
    return _terminal(drawn) if output is None else _file(drawn, output, style or "surface")


def _writable(output: str | None) -> None:
    from subdiv_cli.plot.figure import SUFFIXES

    if output is None:
        return
    if PurePath(output).suffix.lower() not in (*SUFFIXES, _OBJ):
        raise click.BadParameter(f"{output!r} must end in {', '.join((*SUFFIXES, _OBJ))}", param_hint="-o")
    if (reason := why_not(output)) is not None:
        raise click.BadParameter(f"{output!r} cannot be written: {reason}", param_hint="-o")


def _drawings(family: Sequence[single.One], given: set[str], suffix: str) -> list[Drawings]:
    """The sorts of pictures for each mask, all of one name. Raises a usage error for options that do not go with it."""
    from subdiv_cli.kinds import kind_of

    chosen: list[Drawings] = []
    for one in family:
        sorts = kind_of(one.scheme).drawings or ()
        meant = next((sort for sort in sorts if suffix in sort.suffixes and sort.needs <= given), None)
        if meant is None:
            raise click.UsageError(_nowhere(one, sorts, suffix))
        single.refuse_others(given, meant.options)
        chosen.append(meant)
    if len(names := sorted({sort.name for sort in chosen})) > 1:
        raise click.UsageError(f"{' and '.join(names)} are not drawn into one picture")
    if (most := chosen[0].most) is not None and len(family) > most:
        raise click.UsageError(f"these are {len(family)} {chosen[0].name}, and one picture takes {most} at most")
    return chosen


def _nowhere(one: single.One, sorts: Sequence[Drawings], suffix: str) -> str:
    """The reason why no sort of pictures fits: the file, or an option that is missing."""
    needed = sorted(option for sort in sorts if suffix in sort.suffixes for option in sort.needs)
    if needed:
        return f"of a mask of kind {one.mask.kind} something is drawn only with --{needed[0]}"
    return "an .obj is the net of a mask in two variables"


def _points(drawings: Drawings, file: str) -> Any:
    from subdiv_cli.maskfile import MaskFileError

    assert drawings.points is not None, "what takes points reads them"
    try:
        return drawings.points(file)
    except MaskFileError as error:
        single.complain(error.problems)


def _drawn(
    family: Sequence[single.One], drawings: Sequence[Drawings], options: dict[str, Any], effort: int
) -> list[Drawn] | ExitCode:
    """The blocks of each mask, control polygons only once; an exit code where one has nothing to draw."""
    from subdiv_cli.kinds.kind import NotDrawnError
    from subdiv_cli.model import Effort
    from subdiv_cli.model.blocks import Polygon
    from subdiv_cli.pipeline import draw
    from subdiv_cli.plot.panels import Drawn

    drawn: list[Drawn] = []
    for one, sort in zip(family, drawings, strict=True):
        try:
            drawing = draw(one.scheme, sort, options, Effort(effort))
        except NotDrawnError as error:
            raise click.ClickException(f"not drawn: {error}") from None
        if not drawing.blocks:
            return _nothing(one, drawing)
        blocks = tuple(b for b in drawing.blocks if not (drawn and isinstance(b, Polygon) and b.control))
        drawn.append(Drawn(one.title(family if len(family) > 1 else ()), one.title(family), blocks))
        options = options | {"levels": None}  # those of the first mask are enough
    return drawn


def _nothing(one: single.One, drawing: Drawing) -> ExitCode:
    """The exit code of a drawing without blocks; the reason is written to stderr."""
    from subdiv_cli.model import Verdict
    from subdiv_cli.model.closed import rational
    from subdiv_cli.model.findings import CONVERGENCE, answering

    assert drawing.result is not None, "what is missing rests on a verdict"
    assert drawing.question is not None
    finding = answering(drawing.result.findings, drawing.question)
    if finding is None or finding.verdict is Verdict.SKIPPED:  # there is no φ to ask of
        finding = answering(drawing.result.findings, CONVERGENCE)
    refuted = finding is not None and finding.verdict is Verdict.REFUTED
    at = ", ".join(f"{name} = {rational(value)}" for name, value in one.parameters.items())
    name = f"{one.mask.name or one.mask.file}{f' at {at}' if at else ''}"
    why = finding.statement if finding is not None and refuted else _UNPROVED[drawing.question.name]
    emit(f"{name}: nothing to draw, {why}\n", sys.stderr)
    return ExitCode.FAILED if refuted else ExitCode.UNDECIDED


def _terminal(drawn: Sequence[Drawn]) -> ExitCode:
    """The exit code after the panels are drawn with letters."""
    from subdiv_cli.plot.panels import panels, rows
    from subdiv_cli.report.letters import letters

    look = look_of(sys.stdout)
    lines: list[str] = []
    for panel in panels(drawn):
        lines += [""] if lines else []
        lines += [letters(panel.title, look.unicode), *rows(panel, width=look.width, unicode=look.unicode)]
    return ExitCode.PASSED if put("\n".join(lines) + "\n") else ExitCode.ERROR


def _file(drawn: Sequence[Drawn], output: str, style: str) -> ExitCode:
    from subdiv_cli.model.blocks import Net
    from subdiv_cli.plot.figure import INSTALL, MissingExtraError
    from subdiv_cli.plot.panels import figure, panels

    for block in drawn[0].blocks:
        if isinstance(block, Net):
            return _net(block, drawn[0].title, output)
    try:
        picture = figure(panels(drawn), PurePath(output).suffix.lower().lstrip("."), style)
    except MissingExtraError:
        emit(f"error: drawing into a file needs matplotlib, which is not installed: {INSTALL}\n", sys.stderr)
        return ExitCode.ERROR
    return ExitCode.PASSED if put_file(output, picture) else ExitCode.ERROR


def _net(net: Net, title: str, output: str) -> ExitCode:
    from subdiv_cli.plot.obj import obj
    from subdiv_cli.report.letters import letters

    try:
        text = obj(net, letters(f"{title}: {net.title}", unicode=False))
    except OverflowError:
        raise click.ClickException("not written: a coordinate is larger than any double") from None
    return ExitCode.PASSED if put_file(output, text) else ExitCode.ERROR
