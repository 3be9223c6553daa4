"""The command `subdiv show`: one mask taken apart."""

from __future__ import annotations

import sys
from fractions import Fraction
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from subdiv_cli.cli import single
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.options import debug as debug_option
from subdiv_cli.cli.outputs import promised
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import look_of, put, put_file, why_not
from subdiv_cli.cli.values import TOLERANCE
from subdiv_cli.report.look import Look
from subdiv_cli.report.show import FORMATS, renderer

if TYPE_CHECKING:
    from subdiv_cli.model import Result
    from subdiv_cli.model.blocks import Picture
    from subdiv_cli.pipeline import Checked

_EPILOG = """\b
Examples:
  subdiv show masks/scalar/four_point.toml
  subdiv show masks/scalar/four_point.toml -p w=1/20
  subdiv show --mask "[1, 4, 6, 4, 1]/8" --start -2 --tolerance 1e-6
  subdiv show masks/scalar/four_point.toml --format latex -o four_point.tex
  subdiv show masks/multivariate/loop.toml

\b
Exit codes:
  0    shown
  2    not shown: usage, an unreadable or invalid mask, an internal error
"""

SUFFIXES = {".json": "json", ".md": "markdown", ".markdown": "markdown", ".tex": "latex", ".txt": "text"}
_HEIGHT = 16
_WIDEST = 90


@click.command("show", epilog=_EPILOG, short_help="Take a mask apart: symbol, matrices, stencils, Q.")
@click.argument("file", required=False, type=click.Path(), metavar="[FILE | -]")
@single.options
@click.option(
    "--format",
    "form",
    type=click.Choice(FORMATS),
    help="Format of the page.  [default: text, or what the suffix of -o says]",
)
@click.option("-o", "--output", metavar="FILE", type=click.Path(), help="Write the page to FILE, whole or not at all.")
@click.option(
    "--tolerance",
    type=TOLERANCE,
    default="1e-3",
    show_default=True,
    metavar="T",
    help="How close to the limit the control polygon is to come, relative to the largest difference of the data.",
)
@click.option("--certificate", metavar="DIR", type=click.Path(file_okay=False), help="Write the proof into DIR.")
@debug_option
def command(
    file: str | None,
    parameters: tuple[str, ...],
    mask: str | None,
    start: tuple[int, ...] | None,
    arity: int | None,
    effort: int,
    form: str | None,
    output: str | None,
    tolerance: Fraction,
    certificate: str | None,
    debug: bool,
) -> ExitCode:
    """Take one mask apart.

    The symbol factored, polyphase components, derived schemes, refinement matrices and their spectra, the refinable
    function and its values, limit stencils, polynomials and Q, error bounds. Of a mask in several variables the
    directional factors of its symbol, a stencil for each coset, the refinable function and Q. Every verdict is
    certified and checked, as `check` does it.
    """
    if output is not None and (reason := why_not(output)) is not None:
        raise click.BadParameter(f"{output!r} cannot be written: {reason}", param_hint="-o")
    if output is not None and form is None and (foreign := promised(output, SUFFIXES)) is not None:
        raise click.BadParameter(f"no format {foreign}; say which, as in --format text -o {output}", param_hint="-o")
    files = () if file is None else (file,)
    one = single.read(single.Named("show", "portraits", files, mask, start, arity, parameters))
    form = form or _by_suffix(output)
    look = look_of(sys.stdout) if output is None else Look()
    _check_options(one)
    with Progress().watching():
        page = _page(one, form, tolerance, effort, certificate, look)
    encoding = "utf-8" if form == "json" else None
    done = put(page, encoding=encoding) if output is None else put_file(output, page)
    return ExitCode.PASSED if done else ExitCode.ERROR


def _check_options(one: single.One) -> None:
    """Raise a usage error for an option that means nothing for the kind of mask."""
    from subdiv_cli.kinds import kind_of

    portraits, context = kind_of(one.scheme).portraits, click.get_current_context()
    assert portraits is not None, "a mask of another kind is not read"
    given = {name for name in context.params if context.get_parameter_source(name) is ParameterSource.COMMANDLINE}
    single.refuse_others(given, portraits.options)


def _page(one: single.One, form: str, tolerance: Fraction, effort: int, certificate: str | None, look: Look) -> str:
    from subdiv_cli.model import Effort
    from subdiv_cli.pipeline import show

    checked, portrait = show(one.scheme, tolerance, Effort(effort))

    def draw(block: Picture) -> list[str]:
        from subdiv_cli.plot.panels import Drawn, panels, rows

        width = min(look.width - 2, _WIDEST)
        drawn = panels([Drawn("", "", (block,))])
        return [row for panel in drawn for row in rows(panel, width=width, unicode=look.unicode, height=_HEIGHT)]

    return renderer(form)(_labelled(one, checked, certificate), portrait, draw, look)


def _labelled(one: single.One, checked: Checked, certificate: str | None) -> Result:
    """The result with the name of the file; its certificate is written to the file of --certificate."""
    result = one.label(checked.result)
    if certificate is None or (text := checked.certificate_text()) is None:
        return result
    from dataclasses import replace

    return replace(result, certificate=_write_certificate(certificate, result, text))


def _by_suffix(output: str | None) -> str:
    from pathlib import PurePath

    return "text" if output is None else SUFFIXES.get(PurePath(output).suffix.lower(), "text")


def _write_certificate(directory: str, result: Result, text: str) -> str:
    from subdiv_cli.catalog.files import CertificateDirectory

    try:
        return CertificateDirectory(directory).write(result, text)
    except OSError as error:
        raise click.ClickException(f"the certificate cannot be written: {error}") from None
