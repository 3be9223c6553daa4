"""The command `subdiv smooth`: a new mask file, of a scheme whose limits are smoother."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import click

from subdiv_cli.cli import single
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.options import debug as debug_option
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import emit, put, put_file, speaks_mathematics, why_not
from subdiv_cli.model import DECIDED, Result, Verdict
from subdiv_cli.report import words
from subdiv_cli.report.letters import clean, letters
from subdiv_cli.report.marks import of_verdict

if TYPE_CHECKING:
    from subdiv_cli.kinds.kind import SmoothingStep
    from subdiv_cli.model import Expectation

_EPILOG = """\b
Examples:
  subdiv smooth masks/scalar/four_point.toml
  subdiv smooth masks/vector/double_knot_cubic.toml -n 3 -o smoother.toml
  subdiv smooth masks/scalar/four_point.toml -p w=1/20 --inverse
  subdiv smooth --mask "[1, 3, 3, 1]/4" | subdiv check -

\b
Exit codes:
  0    written and checked
  1    impossible: a hypothesis of the procedure fails, or the smoother scheme does not converge
  2    not written: usage, an unreadable or invalid mask, a file that cannot be written
  3    written, and it is not decided within the effort whether the scheme converges
"""
_MOST = 64


@click.command("smooth", epilog=_EPILOG, short_help="Write a smoother scheme: a new mask file.")
@click.argument("file", required=False, type=click.Path(), metavar="[FILE | -]")
@single.options
@click.option(
    "-n", "--times", type=click.IntRange(1, _MOST), default=1, show_default=True, metavar="TIMES",
    help="Orders of smoothness to gain, one for each step.",
)  # fmt: skip
@click.option("--inverse", is_flag=True, help="Write the derived scheme instead, whose limits are derivatives.")
@click.option("-o", "--output", metavar="OUT", type=click.Path(), help="Write the mask to OUT, which must be new.")
@debug_option
def command(
    file: str | None,
    parameters: tuple[str, ...],
    mask: str | None,
    start: tuple[int, ...] | None,
    arity: int | None,
    effort: int,
    times: int,
    inverse: bool,
    output: str | None,
    debug: bool,
) -> ExitCode:
    """Write a mask whose limits are one order smoother, TIMES over.

    Limits of the new scheme are integrals of those of the old one, so that their exponent grows by exactly 1 each time.
    The coefficients are exact. The new mask, with what it can be held to, goes to stdout or OUT; both schemes are
    checked as `check` does it, and what is proved of them goes to stderr.

    Scalar masks are multiplied by the smoothing factor; vector masks go through procedure 23 of Moosmueller & Dyn 2018,
    Hermite masks of a function and its derivative through procedure 40. The derived scheme of a Hermite mask is its
    Taylor scheme, of kind vector.
    """
    if output is not None and (reason := why_not(output) or _taken(output)) is not None:
        raise click.BadParameter(f"{output!r} cannot be written: {reason}", param_hint="-o")
    files = () if file is None else (file,)
    one = single.read(single.Named("smooth", "smoothing", files, mask, start, arity, parameters))
    from subdiv_cli.kinds import lacking
    from subdiv_cli.kinds.kind import NotSmoothedError
    from subdiv_cli.kinds.smoothing import smoothing_steps
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.model import Effort
    from subdiv_cli.pipeline import check_steps

    if (reason := lacking(one.scheme.kind, "smoothing")) is not None:  # a mask from the command line
        raise click.UsageError(reason)
    origin = Origin(one.title() if mask is None else mask, one.mask.reference)
    try:
        steps = smoothing_steps(one.scheme, times, inverse=inverse)
        _text(origin, steps, ())
    except NotSmoothedError as error:
        _say(f"✗ {origin.title}: {'there is no derived scheme' if inverse else 'not smoothed'}: {error}")
        return ExitCode.FAILED
    except MaskFileError as error:
        single.complain(error.problems)
    with Progress().watching():
        before, after = check_steps(one.scheme, steps, Effort(effort))
    useless = not inverse and after.convergent is Verdict.REFUTED
    if not useless and not _put(_text(origin, steps, _expectations(after)), output):
        return ExitCode.ERROR
    _say(f"  {origin.title}: {_headline(before)}")
    _say(f"{of_verdict(after.convergent).sign} {_done(steps)}{', not written' if useless else ''}: {_headline(after)}")
    if useless:
        return ExitCode.FAILED
    return ExitCode.UNDECIDED if after.convergent is Verdict.UNDECIDED else ExitCode.PASSED


def _put(text: str, output: str | None) -> bool:
    """Whether the new file could be written, to stdout or where -o says."""
    return put(text, encoding="utf-8") if output is None else put_file(output, text)


class Origin(NamedTuple):
    """The mask that a new one is made of, in words."""

    title: str
    reference: str | None


def _taken(output: str) -> str | None:
    """The reason why a new mask does not go into a file that is there; None where it may."""
    from pathlib import Path

    return "it exists; a mask is not overwritten" if Path(output).is_file() else None


def _text(origin: Origin, steps: Sequence[SmoothingStep], expectations: tuple[Expectation, ...]) -> str:
    """The file of the last scheme, read back. Raises MaskFileError where it is too large for a mask file."""
    from subdiv_cli.kinds.reading import read_text
    from subdiv_cli.kinds.writing import from_scheme, write

    how = ", then ".join(dict.fromkeys(step.procedure for step in steps))
    made = from_scheme(
        steps[-1].scheme,
        name=f"{origin.title}, {_done(steps)}",
        reference=how if origin.reference is None else f"{how}; from: {origin.reference}",
        expectations=expectations,
    )
    comments = [
        f"Made of {origin.title} by subdiv smooth.",
        *(f"{i}. {step.procedure}: {step.details}" for i, step in enumerate(steps, 1)),
    ]
    text = "".join(f"# {clean(comment)}\n" for comment in comments) + write(made)
    if read_text(text, file=_done(steps)).scheme() != steps[-1].scheme:
        raise AssertionError("the new file is read as another mask")
    return text


def _done(steps: Sequence[SmoothingStep]) -> str:
    """The steps in two or three words: `smoothed`, `derived twice`."""
    times = {1: "", 2: " twice"}.get(len(steps), f" {len(steps)} times")
    return f"{'smoothed' if steps[0].orders > 0 else 'derived'}{times}"


def _expectations(result: Result) -> tuple[Expectation, ...]:
    """The answers on convergence, smoothness, exponent and spectral condition that are proved, as expectations."""
    from subdiv_cli.maskfile.properties import expectation
    from subdiv_cli.model.closed import spelled
    from subdiv_cli.pipeline import judged

    stated: dict[str, bool | str | None] = {}
    if result.convergent in DECIDED:
        stated["convergent"] = result.convergent is Verdict.PROVED
    if result.smoothness.order is not None:
        order = str(result.smoothness.order)
        stated["smoothness"] = order if result.smoothness.sharp else f">= {order}"
    if result.holder is not None and result.holder.exact is not None:
        stated["holder"] = spelled(result.holder.exact)
    if result.spectral in DECIDED:
        stated["spectral"] = result.spectral is Verdict.PROVED
    wanted = tuple(expectation(key, value) for key, value in stated.items() if value is not None)
    return tuple(each.expectation for each in judged(wanted, result) if each.verdict is Verdict.PROVED)


def _headline(result: Result) -> str:
    """The headline of a result, with the support of the mask."""
    support = next(fact for fact in words.facts(result) if fact.startswith("support"))
    return f"{words.headline(result)}; {support}"


def _say(line: str) -> None:
    emit(letters(line, speaks_mathematics(sys.stderr)) + "\n", sys.stderr)
