"""The command `subdiv verify`: certificates in, a line for each; the checker decides and nothing else of subdiv."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click

from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.options import parameter
from subdiv_cli.cli.streams import complain, emit
from subdiv_cli.cli.values import WHOLE

if TYPE_CHECKING:
    from subdiv_cli.checker.plain import PlainMask

_EPILOG = """\b
Examples:
  subdiv check masks/ --certificate proofs/
  subdiv verify proofs/
  subdiv verify proofs/four_point.json --mask masks/scalar/four_point.toml

\b
Exit codes:
  0    all certificates are VERIFIED
  1    one is not, or it proves something about another mask
  2    a file cannot be read, or usage

The checker needs the standard library only and trusts nothing of the program that wrote a certificate:
python -m subdiv_cli.checker CERT runs it alone."""


@click.command("verify", epilog=_EPILOG, short_help="Check certificates independently.")
@click.argument("certificates", nargs=-1, metavar="CERT | DIR ...", type=click.Path())
@click.option(
    "--mask", metavar="FILE", type=click.Path(), help="Check that the certificate is about the mask of this file."
)
@parameter("Set a parameter of --mask.")
@click.option("--work", type=WHOLE, metavar="N", help="Work that the claims of each may ask for.  [default: 250000000]")
def command(certificates: tuple[str, ...], mask: str | None, parameters: tuple[str, ...], work: int | None) -> ExitCode:
    """Check certificates: each is VERIFIED, or a claim is named that fails.

    A DIR is searched for *.json files.
    """
    if not certificates:
        raise click.UsageError("nothing to verify: name a certificate, as in `subdiv verify four_point.json`")
    asked = None if mask is None else _asked(mask, parameters)
    names = [name for target in certificates for name in _files(target)]
    codes = [_verify(name, mask, asked, work, len(names) > 1) for name in names]
    if not names:
        emit("error: no *.json files there\n", sys.stderr)
        return ExitCode.ERROR
    return max(codes)


def _files(target: str) -> Iterator[str]:
    path = Path(target)
    yield from (str(file) for file in sorted(path.rglob("*.json"))) if path.is_dir() else (target,)


def _verify(name: str, mask: str | None, asked: _Asked | None, work: int | None, several: bool) -> ExitCode:
    from subdiv_cli.checker import check_file
    from subdiv_cli.checker.core import MAX_WORK
    from subdiv_cli.checker.plain import certified_mask

    try:
        outcome, text = check_file(name, MAX_WORK if work is None else work)
    except OSError as error:
        emit(f"error: {name} cannot be read: {error.strerror or error}\n", sys.stderr)
        return ExitCode.ERROR
    line, verified = outcome.line, outcome.verified
    if verified and asked is not None:
        verified = certified_mask(text) == asked.mask
        other = f"NOT VERIFIED mask: the certificate is about another mask than {mask}"
        line = f"{line} ({asked.how})" if verified else other
    shown = name if name.isprintable() else ascii(name)
    emit((f"{shown}: " if several else "") + line + "\n", sys.stdout)
    return ExitCode.PASSED if verified else ExitCode.FAILED


class _Asked(NamedTuple):
    """The mask that certificates are to be about, and how it was read."""

    mask: PlainMask | None
    how: str


def _asked(file: str, parameters: Sequence[str]) -> _Asked:
    """The mask of a file: a plain one by the checker's own reader; else parameters and symbols are expanded first."""
    from subdiv_cli.checker.plain import mask_of, plain_mask
    from subdiv_cli.kinds import kind_of
    from subdiv_cli.kinds.reading import read_path
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.option import parse_override

    try:
        overrides = dict(parse_override(text) for text in parameters)
        read = read_path(file)
        scheme = read.scheme(overrides)
    except MaskFileError as error:
        raise click.exceptions.Exit(complain(error.problems)) from None
    if (plain := plain_mask(read.source.text)) is not None:
        return _Asked(plain, f"the mask of {file}")
    return _Asked(
        mask_of(kind_of(scheme).canonical(scheme)), f"the mask of {file}, its parameters and symbol expanded by subdiv"
    )
