"""The command `subdiv blend`: special rules between two masks, by S Q = Q σ, as a mask file that is checked."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

import click

from subdiv_cli.cli import options
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import complain, emit, put_file
from subdiv_cli.cli.values import SECONDS, SPACING, WHOLE
from subdiv_cli.model import Effort, Verdict

if TYPE_CHECKING:
    from subdiv_cli.kinds.piecewise.blend import Blend
    from subdiv_cli.kinds.piecewise.scheme import PiecewiseScheme
    from subdiv_cli.maskfile import MaskFile
    from subdiv_cli.model import Expectation, Result
    from subdiv_cli.pipeline import Checked

_EPILOG = """\b
Examples:
  subdiv blend four_point.toml cubic.toml
  subdiv blend cubic.toml cubic.toml --spacing 1,2 --positive -o spaced.toml
  subdiv blend chaikin.toml cubic.toml --degree 1 --best

\b
Exit codes:
  0    the scheme is written, and proved to converge
  1    there are no such rules, and why; or the scheme diverges (it is written)
  2    not done: usage, an unreadable or invalid file, an internal error
  3    the scheme is written, and not decided within the effort
"""


@click.command("blend", epilog=_EPILOG, short_help="Special rules between two masks that keep polynomials.")
@click.argument("left", type=click.Path())
@click.argument("right", type=click.Path())
@click.option(
    "--degree",
    type=click.IntRange(0, 60),
    metavar="M",
    help="Keep S Q = Q σ on polynomials of this degree.  [default: the largest one that both masks generate]",
)
@click.option(
    "--spacing", type=SPACING, default="1,1", metavar="A,B", help="Distances of old points left and right of 0."
)
@click.option("--support", type=WHOLE, metavar="N", help="Let each special rule read N old points.  [default: few]")
@click.option("--positive", is_flag=True, help="Allow no negative weights in special rules.")
@click.option("--best", is_flag=True, help="Search for rules with the largest certified exponent.")
@click.option("-o", "--output", metavar="FILE", type=click.Path(dir_okay=False), help="Write the mask file to FILE.")
@options.effort("Work that the search and the check may cost.")
@click.option("--budget", type=SECONDS, metavar="SECONDS", help="Stop the search after so long.")
@options.debug
def command(
    left: str,
    right: str,
    degree: int | None,
    spacing: tuple[Fraction, Fraction],
    support: int | None,
    positive: bool,
    best: bool,
    output: str | None,
    effort: int,
    budget: float | None,
    debug: bool,
) -> ExitCode:
    """Join two scalar masks, LEFT and RIGHT of 0, by special rules near it.

    Q, which takes polynomials to data, is that of each mask on its side; S Q = Q σ is solved for the rules that both
    masks leave open, on as few points as can be. The scheme is checked, and written as a mask file of kind piecewise.
    """
    from subdiv_cli.kinds.piecewise.blend import ImpossibleError, blended
    from subdiv_cli.kinds.reading import read_path
    from subdiv_cli.maskfile import MaskFileError

    try:
        files = [read_path(file, kind="scalar") for file in (left, right)]
        masks = [file.scheme({}) for file in files]
    except MaskFileError as error:
        return complain(error.problems)
    if masks[0].arity != masks[1].arity:
        raise click.UsageError(f"the masks must be of one arity, and there are {masks[0].arity} and {masks[1].arity}")
    try:
        blends = blended(masks[0], masks[1], spacing, degree, support, positive)
    except ImpossibleError as why:
        emit(f"no special rules:\n{why}\n", sys.stderr)
        return ExitCode.FAILED
    from subdiv_cli.pipeline import check

    part = Effort(effort, budget)
    with Progress().watching():
        checked = [(blends[0].scheme, check(blends[0].scheme, (), part))]
        most = min(_exponents(check(mask, (), part).result)[1] for mask in masks) if best else 0.0
        for blend in blends if best else ():
            for scheme in _others(blend, part, positive):
                if _exponents(max(checked, key=lambda pair: _exponent(pair[1]))[1].result)[0] >= most:
                    break
                checked.append((scheme, check(scheme, (), part)))
    scheme, known = max(checked, key=lambda pair: _exponent(pair[1])) if best else checked[0]
    text = _text(scheme, known, files, spacing, degree, support, positive, best)
    if output is None:
        emit(text, sys.stdout, encoding="utf-8")
    elif not put_file(output, text):
        return ExitCode.ERROR
    emit(_headline(known, output), sys.stderr)
    codes = {Verdict.PROVED: ExitCode.PASSED, Verdict.REFUTED: ExitCode.FAILED}
    return codes.get(known.result.convergent, ExitCode.UNDECIDED)


def _others(blend: Blend, effort: Effort, positive: bool) -> Iterator[PiecewiseScheme]:
    """The blend itself, and what a search from it finds."""
    from subdiv_cli.kinds.piecewise.blend import conditions
    from subdiv_cli.kinds.piecewise.search import improved

    scheme = blend.scheme
    yield scheme
    wanted = conditions(scheme.left, scheme.right, scheme.spacing, blend.degree, blend.boundary)
    yield from improved(blend, wanted, effort, positive)


def _exponents(result: Result) -> tuple[float, float]:
    """The certified bounds of the Hölder exponent from below and above."""
    holder = result.holder
    low, high = (None, None) if holder is None else (holder.lower, holder.upper)
    return (-1.0 if low is None else low), (float("inf") if high is None else high)


def _exponent(checked: Checked) -> tuple[float, float]:
    """The certified bounds from below of the exponent, and of that at 0, by which schemes are compared."""
    zero = checked.result.holder_at_zero
    return _exponents(checked.result)[0], (-1.0 if zero is None or zero.lower is None else zero.lower)


def _text(
    scheme: PiecewiseScheme,
    checked: Checked,
    files: list[MaskFile],
    spacing: tuple[Fraction, Fraction],
    degree: int | None,
    support: int | None,
    positive: bool,
    best: bool,
) -> str:
    """The mask file: how it came about, the scheme, and what is proved of it."""
    from subdiv_cli.kinds.writing import from_scheme, write

    names = [file.name or file.file for file in files]
    words = ["subdiv", "blend", *(file.file for file in files)]
    if set(spacing) != {Fraction(1)}:
        words += ["--spacing", f"{spacing[0]},{spacing[1]}"]
    words += [] if degree is None else ["--degree", str(degree)]
    words += [] if support is None else ["--support", str(support)]
    words += ["--positive"] * positive + ["--best"] * best
    title = f"{names[0]} joined to {names[1]}"
    mask = from_scheme(scheme, name=title, expectations=tuple(_expectations(checked)))
    return f"# {' '.join(map(shlex.quote, words))}\n{write(mask)}"


def _expectations(checked: Checked) -> Iterator[Expectation]:
    """What is proved of the scheme, as a file expects it."""
    from subdiv_cli.maskfile.properties import expectation
    from subdiv_cli.model.closed import spelled

    result = checked.result
    if result.convergent not in (Verdict.PROVED, Verdict.REFUTED):
        return
    yield expectation("convergent", result.convergent is Verdict.PROVED)
    if result.convergent is Verdict.REFUTED:
        return
    order = result.smoothness.order
    if isinstance(order, int):
        yield expectation("smoothness", order if result.smoothness.sharp else f">= {order}")
    for key, exponent in (("holder", result.holder), ("holder_at_zero", result.holder_at_zero)):
        text = None if exponent is None or exponent.exact is None else spelled(exponent.exact)
        if text is not None:
            yield expectation(key, text)
    if result.generation is not None:
        yield expectation("generation", result.generation)


def _headline(checked: Checked, output: str | None) -> str:
    """The answer of the check in a line."""
    from subdiv_cli.report import words

    return f"{'' if output is None else f'{output}: '}{words.headline(checked.result)}\n"
