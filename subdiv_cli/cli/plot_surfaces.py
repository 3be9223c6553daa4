"""`subdiv plot` for masks in several variables: φ as a surface, a map of contours or letters, and nets as OBJ."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, NamedTuple

import click

from subdiv_cli.cli import single
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.streams import look_of

if TYPE_CHECKING:
    from fractions import Fraction

    from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme
    from subdiv_cli.model import Effort, Result
    from subdiv_cli.model.blocks import Net, Surface
    from subdiv_cli.plot.relief import Relief

OBJ = ".obj"
_LEVELS = 3
"""Of a net, where none are asked for."""
_HEIGHT = 28
_MOST_PANELS = 6


class Asked(NamedTuple):
    """What the command line asks for."""

    output: str | None
    style: str | None
    net: str | None
    levels: int | None

    @property
    def is_obj(self) -> bool:
        return self.output is not None and PurePath(self.output).suffix.lower() == OBJ

    def check(self, family: Sequence[single.One]) -> None:
        """Raise a usage error for options that do not go together."""
        if not self.is_obj and (self.net is not None or self.levels is not None):
            raise click.UsageError("of a mask in several variables --points and --levels belong to -o NET.obj")
        if self.style is not None and (self.output is None or self.is_obj):
            raise click.UsageError("--as belongs to -o FILE.svg, .png or .pdf")
        if self.is_obj and len(family) > 1:
            raise click.UsageError("an .obj is the net of one mask")
        if self.is_obj and _scheme(family[0]).dimension > 2:
            raise click.UsageError("an .obj is the net of a mask in two variables")
        if len(family) > _MOST_PANELS:
            raise click.UsageError(f"these are {len(family)} surfaces; {_MOST_PANELS} are drawn at most")


def plot(family: Sequence[single.One], asked: Asked, effort: Effort, nothing: Nothing) -> ExitCode:
    """Draw all of them; `nothing` says why one has nothing to draw."""
    from subdiv_cli.relief import NoValuesError

    asked.check(family)
    try:
        return _net(family[0], asked, effort, nothing) if asked.is_obj else _pictures(family, asked, effort, nothing)
    except NoValuesError as error:
        raise click.ClickException(f"not drawn: {error}") from None


Nothing = Callable[[single.One, "Result", Sequence[str], str], ExitCode]


def _scheme(one: single.One) -> MultivariateScheme:
    from subdiv_cli.kinds.multivariate.scheme import MultivariateScheme

    assert isinstance(one.scheme, MultivariateScheme)
    return one.scheme


def _pictures(family: Sequence[single.One], asked: Asked, effort: Effort, nothing: Nothing) -> ExitCode:
    from subdiv_cli.relief import drawn_surface

    surfaces: list[tuple[str, Surface]] = []
    for one in family:
        result, surface = drawn_surface(_scheme(one), effort)
        if surface is None:
            return nothing(one, result, ("SD612",), "φ is not proved continuous")
        surfaces.append((_title(one, family, surface), surface))
    if asked.output is None:
        return _letters(surfaces)
    from subdiv_cli.plot.relief import relief

    return _file([relief(surface, title) for title, surface in surfaces], asked.output, asked.style or "surface")


def _title(one: single.One, family: Sequence[single.One], surface: Surface) -> str:
    """`φ(x, y, 3/2) — tricubic`: the slice that is drawn is said."""
    from subdiv_cli.report.numbers import exact

    where = f"φ(x, y, {', '.join(map(exact, surface.at))})" if surface.at else "φ"
    return f"{where} — {one.title(family if len(family) > 1 else ())}"


def _letters(surfaces: Sequence[tuple[str, Surface]]) -> ExitCode:
    from subdiv_cli.plot.heights import draw_heights
    from subdiv_cli.report.letters import letters

    look = look_of(sys.stdout)
    rows: list[str] = []
    for title, surface in surfaces:
        rows += [""] if rows else []
        rows += [letters(title, look.unicode)]
        rows += draw_heights(surface, width=look.width, height=_HEIGHT, unicode=look.unicode)
    return single.print_rows(rows)


def _file(panels: Sequence[Relief], output: str, style: str) -> ExitCode:
    from subdiv_cli.plot.reliefs import reliefs

    form = PurePath(output).suffix.lower().lstrip(".")
    return single.write_picture(output, lambda: reliefs(panels, form, style))


def _net(one: single.One, asked: Asked, effort: Effort, nothing: Nothing) -> ExitCode:
    """The graph of φ, or the control net that is given, refined."""
    from subdiv_cli.plot.obj import faces, obj
    from subdiv_cli.relief import graph_net, net

    assert asked.output is not None
    levels = _LEVELS if asked.levels is None else asked.levels
    found: Net | None
    if asked.net is None:
        result, found = graph_net(_scheme(one), effort, levels)
        if found is None:
            return nothing(one, result, ("SD612",), "φ is not proved continuous")
    else:
        found = net(_scheme(one), _points(asked.net), levels)
        if next(faces(found), None) is None:
            raise click.ClickException(f"not drawn: the net is too small: it determines no face of level {levels}")
    what = "the graph of phi" if asked.net is None else "a control net"
    from subdiv_cli.report.letters import letters

    try:
        text = obj(found, f"{letters(one.title(), unicode=False)}: {what} at level {levels}")
    except OverflowError:
        raise click.ClickException("not written: a coordinate is larger than any double") from None
    return single.write_picture(asked.output, lambda: text.encode("ascii"))


def _points(file: str) -> dict[tuple[int, ...], tuple[Fraction, ...]]:
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.points import read_net

    try:
        return read_net(file)
    except MaskFileError as error:
        single.complain(error.problems)
