"""The command `subdiv jsr`: the joint spectral radius of a family of rational matrices, enclosed with proof."""

from __future__ import annotations

import sys
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import click

from subdiv_cli.cli import options
from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.progress import Progress
from subdiv_cli.cli.streams import complain, emit, look_of, put_file
from subdiv_cli.cli.values import SECONDS
from subdiv_cli.model import Effort
from subdiv_cli.model.family import FamilyRadius

if TYPE_CHECKING:
    from subdiv_cli.maskfile import MaskFile

_EPILOG = """\b
Examples:
  subdiv jsr family.toml
  subdiv jsr family.toml -p a=9/10 --format json
  subdiv jsr family.toml --certificate proof.json && subdiv verify proof.json

\b
A family is a TOML file with one list of square matrices, each a list of rows; numbers are exact:
  matrices = [[[1, 1], [0, 1]], [["4/5", 0], ["4/5", "4/5"]]]
The list alone is JSON, and read too. So are an array p x N x N of NumPy (.npy), and
the matrices of a .mat file, with pip install "subdiv[mat]".

\b
Exit codes:
  0    the radius is enclosed within a tenth of itself, or known exactly
  2    not computed: usage, an unreadable or invalid file, an internal error
  3    no such bounds within the effort, or a certificate is asked for and a bound has none
"""
_WIDE = 0.1
"""The relative width beyond which an enclosure is no answer."""


@click.command("jsr", epilog=_EPILOG, short_help="Joint spectral radius of matrices, with proof.")
@click.argument("file", type=click.Path())
@options.parameter("Set a parameter of FILE.")
@options.text_or_json
@options.effort("Work it may cost. What is found depends on it alone.")
@click.option("--budget", type=SECONDS, metavar="SECONDS", help="Stop after so long, with the bounds found by then.")
@click.option(
    "--certificate", metavar="FILE", type=click.Path(dir_okay=False), help="Write the proof, for `subdiv verify`."
)
@click.option("--transpose", is_flag=True, help="Take the transposes: for matrices that act on rows.")
@options.debug
def command(
    file: str,
    parameters: tuple[str, ...],
    form: str,
    effort: int,
    budget: float | None,
    certificate: str | None,
    transpose: bool,
    debug: bool,
) -> ExitCode:
    """The joint spectral radius of a family of rational matrices.

    That is the growth rate of the largest products, lim max ||M_(w_L) ... M_(w_1)||^(1/L). FILE is TOML, JSON or nested
    lists, .npy or .mat; - is stdin. Floats are taken as the decimals that they spell.
    """
    from subdiv_cli.maskfile import MaskFileError

    try:
        read, matrices, floats = _read(file, parameters)
    except MaskFileError as error:
        return complain(error.problems)
    if floats:
        emit("note: floats are taken as the decimals that they spell\n", sys.stderr)
    if transpose:
        matrices = tuple(tuple(zip(*matrix, strict=True)) for matrix in matrices)
    from subdiv_cli.pipeline import joint_spectral_radius

    with Progress().watching():
        checked = joint_spectral_radius(matrices, Effort(effort, budget))
    text = checked.certificate_text()
    if certificate is not None and text is not None and not put_file(certificate, text):
        return ExitCode.ERROR
    proof = certificate if text is not None else None
    render = _as_json if form == "json" else _as_text
    emit(render(read, checked.radius, proof), sys.stdout, encoding="utf-8" if form == "json" else None)
    unwritten = certificate is not None and text is None
    if unwritten:
        emit(f"warning: {certificate} is not written: nothing is proved\n", sys.stderr)
    if checked.radius.left_out:
        emit(f"warning: a better bound is left out: {checked.radius.left_out}\n", sys.stderr)
    unwritten = unwritten or (certificate is not None and checked.radius.left_out is not None)
    wide = not checked.radius.lower or checked.radius.width > _WIDE
    known = checked.radius.exact is not None or checked.radius.upper == 0
    return ExitCode.UNDECIDED if unwritten or (wide and not known) else ExitCode.PASSED


def _read(file: str, parameters: tuple[str, ...]) -> tuple[MaskFile, Any, bool]:
    """The file, its matrices, and whether they were floats."""
    from subdiv_cli.kinds.family_files import family_text
    from subdiv_cli.kinds.reading import read_text
    from subdiv_cli.maskfile.option import parse_override

    overrides: dict[str, Fraction] = dict(parse_override(text) for text in parameters)
    text, floats = family_text(file)
    read = read_text(text, file=file, wanted="matrices")
    return read, read.scheme(overrides).matrices, floats


def _as_json(_: MaskFile, radius: FamilyRadius, proof: str | None) -> str:
    import json

    report = {
        "format": "subdiv-jsr",
        "version": 1,
        "lower": radius.lower,
        "upper": radius.upper,
        "exact": radius.exact,
        "smp": [list(word) for word in radius.words],
        "certificate": proof,
        "order": radius.order,
        "matrices": radius.letters,
        "bounded": radius.bounded,
        "method": radius.method or None,
        "vertices": radius.vertices,
        "stopped": radius.stopped,
    }
    return json.dumps(report, ensure_ascii=False, indent=2, allow_nan=False) + "\n"


def _as_text(read: MaskFile, radius: FamilyRadius, proof: str | None) -> str:
    from subdiv_cli.report.jsr import render

    return render(radius, look_of(sys.stdout), file=read.file, name=read.name, proof=proof)
