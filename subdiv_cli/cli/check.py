"""`subdiv check`: masks in, a report out, an exit code that says what was proved."""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import click

from subdiv_cli.cli.exits import ExitCode, exit_code
from subdiv_cli.cli.outputs import Output, OutputType
from subdiv_cli.cli.streams import Progress, UnwritableError, emit, look_of
from subdiv_cli.cli.values import SecondsType, WholeType
from subdiv_cli.model import DEFAULT_EFFORT, Problem, Result
from subdiv_cli.report import FOR_PEOPLE, FORMATS, renderer
from subdiv_cli.report.look import UNWRAPPED, Look

if TYPE_CHECKING:
    from subdiv_cli.maskfile import MaskFile

_EPILOG = """\b
Examples:
  subdiv check four-point.toml
  subdiv check four-point.toml -p w=1/20
  subdiv check masks/ -q
  subdiv check masks/ --format concise -o json:report.json
  subdiv check masks/ --certificate proofs/ && subdiv verify proofs/
  subdiv check --mask "[-1, 0, 9, 16, 9, 0, -1]/16" --start -3
  subdiv check --mask "[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]" -p w=1/16
  generate | subdiv check - --allow-undecided

\b
Exit codes:
  0    every expectation proved (convergence, where a mask states none)
  1    an expectation refuted
  2    not checked: usage, an unreadable or invalid mask, an internal error
  3    nothing refuted, something undecided (0 with --allow-undecided)
  130  interrupted; the masks checked so far are reported
  Of several, 2 beats 1 beats 3, and 130 beats all.

\b
The report is on stdout. Progress is on stderr, and so are the errors of invalid
masks in the text format; concise and json have them in the report.
"""


@click.command("check", epilog=_EPILOG)
@click.argument("targets", nargs=-1, type=click.Path(), metavar="[FILE | DIR | -]...")
@click.option(
    "-p",
    "--parameter",
    "parameters",
    multiple=True,
    metavar="NAME=VALUE",
    help="Set a mask's parameter: w=1/20. Repeatable.",
)
@click.option(
    "--mask", metavar="MASK", help="Check this mask instead of a file: a list, [1, 3, 3, 1]/4, or a symbol, (1+z)^3/4."
)
@click.option("--start", type=int, metavar="INDEX", help="Index of the first coefficient of --mask.  [default: 0]")
@click.option("--arity", type=int, metavar="P", help="Arity of --mask.  [default: 2]")
@click.option(
    "--format",
    "form",
    type=click.Choice(list(FORMATS)),
    default="text",
    show_default=True,
    help="Format of the report on stdout.",
)
@click.option(
    "-o",
    "--output",
    "outputs",
    type=OutputType(),
    multiple=True,
    metavar="[FORMAT:]FILE",
    help="Write the report to FILE as well, whole or not at all; FORMAT is --format, or json for .json. Repeatable.",
)
@click.option(
    "--effort",
    type=WholeType(),
    default=DEFAULT_EFFORT,
    show_default=True,
    metavar="N",
    help="Work one question may cost. What is found depends on it alone.",
)
@click.option(
    "--budget",
    type=SecondsType(),
    metavar="SECONDS",
    help="Give up on a mask after so long. Results then depend on the machine.",
)
@click.option("-v", "--verbose", count=True, help="Every report in full; -vv with the witnesses.")
@click.option("-q", "--quiet", is_flag=True, help="Show only what did not pass.")
@click.option("--allow-undecided", is_flag=True, help="Undecided is not a failure: exit 0 for it.")
@click.option(
    "--certificate",
    "certificates",
    metavar="DIR",
    type=click.Path(file_okay=False),
    help="Write the proof of each mask's verdicts into DIR, for `subdiv verify`.",
)
@click.option("--debug", is_flag=True, help="Show the traceback of an internal error.")
def command(
    targets: tuple[str, ...],
    parameters: tuple[str, ...],
    mask: str | None,
    start: int | None,
    arity: int | None,
    form: str,
    outputs: tuple[Output, ...],
    effort: int,
    budget: float | None,
    verbose: int,
    quiet: bool,
    allow_undecided: bool,
    certificates: str | None,
    debug: bool,
) -> ExitCode:
    """Check subdivision masks: convergence, order of smoothness, exponents, and what each file expects.

    A FILE is a TOML mask file; a DIR is searched for them; - reads one from stdin.
    """
    _usage(targets, mask, start, arity, verbose, quiet)
    overrides = _overrides(parameters)
    if overrides is None:
        return ExitCode.ERROR
    told: dict[str, Any] = {"work": effort, "seconds": budget, "debug": debug}
    if verbose:
        told["on_skipped"] = _tell_skipped
    if certificates is not None:
        told["certificates"] = certificates
    results, interrupted = _run(_targets(targets, mask, start, arity, overrides), overrides, told)
    verbosity = -1 if quiet else verbose
    printed = _print(results, form, verbosity, allow_undecided)
    written = _write(results, outputs, form, Look(verbosity=verbosity, allow_undecided=allow_undecided))
    if interrupted:
        emit(f"interrupted: {len(results)} mask{'' if len(results) == 1 else 's'} checked until then\n", sys.stderr)
    code = exit_code((result.status for result in results), allow_undecided=allow_undecided, interrupted=interrupted)
    return code if (printed and written) or interrupted else ExitCode.ERROR


def _usage(
    targets: Sequence[str], mask: str | None, start: int | None, arity: int | None, verbose: int, quiet: bool
) -> None:
    """Raise a usage error for options that do not go together."""
    if mask is None and not targets:
        raise click.UsageError("nothing to check: name a file, as in `subdiv check four-point.toml`")
    if mask is not None and targets:
        raise click.UsageError("--mask checks one mask from the command line: leave out the files, or --mask")
    if mask is None and (start is not None or arity is not None):
        option = "--start" if start is not None else "--arity"
        raise click.UsageError(f"{option} belongs to --mask; a file says it itself, under [mask]")
    if quiet and verbose:
        raise click.UsageError("-q and -v contradict each other")


def _overrides(parameters: Sequence[str]) -> dict[str, Fraction] | None:
    """The values of -p by name; None where one could not be read, which is then said on stderr."""
    if not parameters:
        return {}
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.option import parse_override

    overrides: dict[str, Fraction] = {}
    problems: list[Problem] = []
    for text in parameters:
        try:
            name, value = parse_override(text)
        except MaskFileError as error:
            problems += error.problems
            continue
        if overrides.setdefault(name, value) != value:
            raise click.UsageError(f"-p gives {name} twice: {overrides[name]} and {value}")
    if problems:
        _complain(problems)
        return None
    return overrides


def _targets(
    targets: Sequence[str], mask: str | None, start: int | None, arity: int | None, names: Collection[str]
) -> list[str | MaskFile] | Result:
    """What to check; an invalid Result where --mask cannot be read. `names` are those of -p, which a mask may use."""
    if mask is None:
        return list(targets)
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.option import from_option

    try:
        start, arity = 0 if start is None else start, 2 if arity is None else arity
        return [from_option(mask, start=start, arity=arity, names=names)]
    except MaskFileError as error:
        return Result(file="--mask", status="invalid", problems=tuple(error.problems))


def _run(
    targets: list[str | MaskFile] | Result, overrides: Mapping[str, Fraction], told: Mapping[str, Any]
) -> tuple[list[Result], bool]:
    """The results, and whether Ctrl-C ended them early."""
    if isinstance(targets, Result):
        return [targets], False
    results: list[Result] = []
    progress = Progress()
    try:
        from subdiv_cli.catalog.run import check_all

        for result in check_all(targets, overrides=overrides, **told):
            results.append(result)
            progress.step()
    except KeyboardInterrupt:
        return results, True
    except OSError as error:
        raise click.ClickException(f"certificates cannot be written: {error}") from None
    finally:
        progress.close()
    return results, False


def _tell_skipped(count: int) -> None:
    if count:
        emit(f"skipped {count} TOML file{'' if count == 1 else 's'} without kind, mask or matrices\n", sys.stderr)


def _print(results: Sequence[Result], form: str, verbosity: int, allow_undecided: bool) -> bool:
    """The report on stdout, and whether that could be written; the text format has the errors on stderr, and first."""
    if form == "text":
        _complain(problem for result in results for problem in result.problems)
    look = look_of(sys.stdout, verbosity=verbosity, allow_undecided=allow_undecided, problems=False)
    try:
        emit(renderer(form)(results, look), sys.stdout, encoding=None if form in FOR_PEOPLE else "utf-8")
    except UnwritableError as error:
        error.show()
        return False
    return True


def _complain(problems: Iterable[Problem]) -> None:
    """Problems on stderr; wrapped only on a terminal, so that a message can be grepped elsewhere."""
    from subdiv_cli.report.problems import render

    settings = {} if sys.stderr.isatty() else {"width": UNWRAPPED}
    if text := render(problems, look_of(sys.stderr, **settings)):
        emit(text + "\n", sys.stderr)


def _write(results: Sequence[Result], outputs: Sequence[Output], form: str, look: Look) -> bool:
    """The report in every file asked for; whether all could be written."""
    from subdiv_cli.catalog.files import write_whole

    written = True
    for output in outputs:
        try:
            write_whole(output.file, renderer(output.format or form)(results, look))
        except OSError as error:
            emit(f"error: {output.file} cannot be written: {error.strerror or error}\n", sys.stderr)
            written = False
    return written
