"""The command `subdiv sweep`: orders, exponents and norms along a family, as a table and as a picture."""

from __future__ import annotations

import re
import sys
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING

import click

from subdiv_cli.cli import options, single
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import complain, emit, look_of, put, put_file, why_not

if TYPE_CHECKING:
    from fractions import Fraction

    from subdiv_cli.catalog.sweep import ParameterFamily
    from subdiv_cli.model.sweep import Column, Sweep

_EPILOG = """\b
Examples:
  subdiv sweep masks/scalar/four_point.toml w=-1/2:1/2:1/8
  subdiv sweep masks/scalar/four_point.toml w=1/16,1/20,1/32 --columns holder,sobolev
  subdiv sweep masks/scalar/four_point.toml w=0:1/8:1/100 --columns norm:1:2,norm:2:2
  subdiv sweep masks/scalar/four_point.toml w=-1/2:1/2:1/100 --plot alpha.svg
  subdiv sweep masks/scalar/six_point.toml theta=0:1/50:1/500 -p w=1/16 --format csv
  subdiv sweep --mask "[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]" w=0:1/8:1/32 --format json

\b
Columns are the properties of [expect] and of JSON reports: convergent, smoothness, holder,
sobolev, stable, generation, reproduction, … and norm:N:L, the exact norm of ((1/p) S_N)^L, of
scalar masks of arity p: S_N is the scheme of divided differences of order N.

\b
Exit codes:
  0    every column is decided at every value that makes a mask
  2    no table: usage, an unreadable file, no value that makes a mask, an internal error
  3    a column is undecided at a value, or encloses an exponent within no less than a tenth
"""
_DEFAULT = "convergent,smoothness,holder"
_NORM = re.compile(r"norm:([0-9]{1,4}):([0-9]{1,4})", re.ASCII)


class _Values(Progress):
    """The progress of a sweep, whose results are values and no masks that could fail."""

    def line(self) -> str:
        """The line of the progress: `37/120 values`."""
        return f"{self.done}/{self.total} values" + (f", {self.cached} from the cache" if self.cached else "")


@click.command("sweep", epilog=_EPILOG, short_help="A table or picture of exponents and norms along a family.")
@click.argument("words", nargs=-1, type=click.Path(), metavar="[FILE | -] NAME=FROM:TO:STEP")
@single.options
@click.option("--columns", default=_DEFAULT, show_default=True, metavar="NAME,...", help="What is asked at each value.")
@click.option(
    "--format", "form", type=click.Choice(["table", "csv", "json"]), default="table", show_default=True,
    help="Format on stdout; csv and json have numbers exactly, and between doubles.",
)  # fmt: skip
@click.option("--plot", metavar="FILE", type=click.Path(), help="Draw exponents and norms: .svg, .png or .pdf.")
@options.jobs
@options.kept
@options.debug
def command(
    words: tuple[str, ...],
    parameters: tuple[str, ...],
    mask: str | None,
    start: tuple[int, ...] | None,
    arity: int | None,
    effort: int,
    columns: str,
    form: str,
    plot: str | None,
    jobs: int,
    no_cache: bool,
    cache_dir: str | None,
    debug: bool,
) -> ExitCode:
    """Orders, exponents and norms of a mask at many values of a parameter.

    NAME=FROM:TO:STEP is FROM, FROM + STEP, ... up to TO, exactly; NAME=1/16,1/20 are these values. Other parameters
    are set with -p. Values are checked as `check` does it, in parallel, and results are kept for both.

    A value at which there is no mask is a row with the reason. --plot draws exponents and norms: a line joins exact
    values, a band lower and upper bounds, both certified at the values, not between them. It is grey between two values
    where the product of matrices is another one that attains the Hoelder exponent.
    """
    wanted = _columns(columns)
    if plot is not None:
        _drawable(plot, wanted)
    family, values = _family(words, single.Named("sweep", "analyse", words[:-1], mask, start, arity, parameters))
    from subdiv_cli.catalog import cache
    from subdiv_cli.catalog.sweep import rows
    from subdiv_cli.model.sweep import Sweep

    progress = _Values()
    kept = None if no_cache else cache.directory(cache_dir)
    run = rows(
        family, values, wanted, effort, jobs=jobs, cache=kept, debug=debug, on_total=progress.begin,
        on_done=progress.step,
    )  # fmt: skip
    with progress.watching():
        done = tuple(run)
    source = family.mask
    sweep = Sweep(
        source.file if mask is None else mask, source.name, source.kind, family.parameter, family.fixed, wanted, done
    )
    written = put(_report(sweep, form), encoding=None if form == "table" else "utf-8")
    if plot is not None:
        written &= _draw(sweep, plot)
    return _code(sweep, written)


def _columns(text: str) -> tuple[Column, ...]:
    """The columns of these names. Raises a usage error for one that does not exist."""
    from subdiv_cli.maskfile.problems import near, shown
    from subdiv_cli.model.properties import BY_KEY
    from subdiv_cli.model.sweep import Column

    columns: dict[str, Column] = {}
    for name in filter(None, map(str.strip, text.split(","))):
        norm = _NORM.fullmatch(name)
        if name in BY_KEY:
            columns[name] = Column(name, BY_KEY[name])
        elif norm and int(norm[1]) and int(norm[2]):
            columns[name] = Column(f"norm:{int(norm[1])}:{int(norm[2])}", None, int(norm[1]), int(norm[2]))
        else:
            guess = near(name, BY_KEY)
            help = f"did you mean {guess}?" if guess else f"there are {', '.join(BY_KEY)}, and norm:1:2"
            raise click.BadParameter(f"no column {shown(name)!r}: {help}", param_hint="--columns")
    if not columns:
        raise click.BadParameter(f"names no column; write for instance {_DEFAULT}", param_hint="--columns")
    return tuple(columns.values())


def _drawable(plot: str, columns: tuple[Column, ...]) -> None:
    """Raise a usage error for a picture that cannot be drawn or written."""
    from subdiv_cli.plot.figure import SUFFIXES
    from subdiv_cli.plot.sweep import is_drawn

    reason = why_not(plot)
    if PurePath(plot).suffix.lower() not in SUFFIXES:
        raise click.BadParameter(f"{plot!r} must end in {', '.join(SUFFIXES)}", param_hint="--plot")
    if reason is not None:
        raise click.BadParameter(f"{plot!r} cannot be written: {reason}", param_hint="--plot")
    if not any(map(is_drawn, columns)):
        raise click.UsageError("--plot draws exponents and norms: add holder, sobolev or norm:1:2 to --columns")


def _family(words: tuple[str, ...], meant: single.Named) -> tuple[ParameterFamily, tuple[Fraction, ...]]:
    """The mask, its parameter and the values. Ends the command where one of them cannot be read."""
    if not words or "=" not in words[-1]:
        example = "subdiv sweep four_point.toml w=0:1/4:1/100"
        raise click.UsageError(f"name a FILE, then the values of a parameter, as in `{example}`")
    if len(meant.files) > 1:
        raise click.UsageError(f"one mask and one parameter, and {len(words)} are named; set others with -p")
    meant.usage()
    from subdiv_cli.catalog.sweep import ParameterFamily
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.mask import no_such_parameter
    from subdiv_cli.maskfile.option import parse_override, parse_values

    try:
        name, values = parse_values(words[-1])
        fixed: dict[str, Fraction] = {}
        for other, value in map(parse_override, meant.parameters):
            if other == name or other in fixed:
                raise click.UsageError(f"{other} is given twice: one parameter is swept, -p sets each other one once")
            fixed[other] = value
        (mask,) = single.read_masks(meant, (name, *fixed))
    except MaskFileError as error:
        single.complain(error.problems)
    if strange := [each for each in (name, *fixed) if each not in mask.parameters]:
        single.complain([replace(no_such_parameter(each, mask.parameters), file=mask.file) for each in strange])
    return ParameterFamily(mask, name, fixed), values


def _report(sweep: Sweep, form: str) -> str:
    """The rows in a format."""
    from subdiv_cli.report import sweep as report

    if form == "table":
        return report.table(sweep, look_of(sys.stdout))
    return report.as_csv(sweep) if form == "csv" else report.as_json(sweep)


def _draw(sweep: Sweep, plot: str) -> bool:
    """Whether the picture could be drawn and written; if not, the reason is on stderr."""
    from subdiv_cli.plot.figure import INSTALL, MissingExtraError
    from subdiv_cli.plot.sweep import picture

    try:
        drawn = picture(sweep, PurePath(plot).suffix.lower().lstrip("."))
    except MissingExtraError:
        emit(f"error: drawing into a file needs matplotlib, which is not installed: {INSTALL}\n", sys.stderr)
        return False
    return put_file(plot, drawn)


def _code(sweep: Sweep, written: bool) -> ExitCode:
    """The exit code, after what was wrong with values is written to stderr."""
    from subdiv_cli.maskfile.rules import INTERNAL_ERROR, WORKER_LOST
    from subdiv_cli.report.sweep import summary

    if (text := summary(sweep)) is not None:
        emit(f"note: {text}\n", sys.stderr)
    ours = [p for row in sweep.rows for p in row.result.problems if p.code in (INTERNAL_ERROR.code, WORKER_LOST.code)]
    complain(ours[:1])
    empty = all(row.result.status == "invalid" for row in sweep.rows)
    if ours or empty or not written:
        return ExitCode.ERROR
    return ExitCode.UNDECIDED if any(row.undecided for row in sweep.rows) else ExitCode.PASSED
