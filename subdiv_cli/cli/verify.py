"""The command `subdiv verify`: certificates in, a line for each; the checker decides and nothing else of subdiv."""

from __future__ import annotations

import json
import signal
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from enum import Enum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click

from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.options import jobs, parameter, text_or_json
from subdiv_cli.cli.streams import complain, emit
from subdiv_cli.cli.values import WHOLE

if TYPE_CHECKING:
    from subdiv_cli.checker.plain import PlainMask

_EPILOG = """\b
Examples:
  subdiv check masks/ --certificate proofs/
  subdiv verify proofs/
  subdiv verify proofs/four_point.json --mask masks/scalar/four_point.toml
  subdiv verify proofs/ -q --jobs 4

\b
Exit codes:
  0    all certificates are VERIFIED
  1    one is not, or it proves something about another mask
  2    a file cannot be read, or usage

The checker needs the standard library only and trusts nothing of the program that wrote a certificate:
python -m subdiv_cli.checker CERT runs it alone."""

FEWEST = 8
"""The fewest certificates for each process that make it worth starting it."""


@click.command("verify", epilog=_EPILOG, short_help="Check certificates independently.")
@click.argument("certificates", nargs=-1, metavar="CERT | DIR ...", type=click.Path())
@click.option(
    "--mask", metavar="FILE", type=click.Path(), help="Check that the certificate is about the mask of this file."
)
@parameter("Set a parameter of --mask.")
@click.option("--work", type=WHOLE, metavar="N", help="Work that the claims of each may ask for.  [default: 250000000]")
@text_or_json
@click.option("-q", "--quiet", is_flag=True, help="Show only what is not VERIFIED.")
@jobs
def command(
    certificates: tuple[str, ...],
    mask: str | None,
    parameters: tuple[str, ...],
    work: int | None,
    form: str,
    quiet: bool,
    jobs: int,
) -> ExitCode:
    """Check certificates: each is VERIFIED, or a claim is named that fails.

    A DIR is searched for *.json files. Of several a last line counts them.
    """
    if not certificates:
        raise click.UsageError("nothing to verify: name a certificate, as in `subdiv verify four_point.json`")
    subject = None if mask is None else _subject(mask, parameters)
    names = [name for target in certificates for name in _files(target)]
    if not names:
        emit("error: no *.json files there\n", sys.stderr)
        return ExitCode.ERROR
    counts = dict.fromkeys(_Outcome, 0)
    shown: list[dict[str, object]] = []
    for verification in _verifications(names, partial(_verify, work=work, mask=mask, subject=subject), jobs):
        counts[verification.outcome] += 1
        if verification.outcome is _Outcome.UNREADABLE:
            emit(f"error: {verification.line}\n", sys.stderr)
        if form == "json":
            shown.append(verification.as_data())
        elif verification.outcome is _Outcome.NOT_VERIFIED or (verification.outcome is _Outcome.VERIFIED and not quiet):
            _put_line(verification, several=len(names) > 1)
    summary = {"certificates": len(names), **{outcome.value: count for outcome, count in counts.items()}}
    if form == "json":
        report = {"format": "subdiv-verify", "version": 1, "summary": summary, "results": shown}
        emit(json.dumps(report, indent=2) + "\n", sys.stdout, encoding="utf-8")
    elif len(names) > 1 and not (quiet and counts[_Outcome.VERIFIED] == len(names)):
        emit(_summary(counts), sys.stdout)
    return max(_CODES[outcome] for outcome, count in counts.items() if count)


class _Outcome(Enum):
    VERIFIED = "verified"
    NOT_VERIFIED = "not_verified"
    UNREADABLE = "unreadable"


_CODES = {
    _Outcome.VERIFIED: ExitCode.PASSED,
    _Outcome.NOT_VERIFIED: ExitCode.FAILED,
    _Outcome.UNREADABLE: ExitCode.ERROR,
}


class _Verification(NamedTuple):
    """What came of a certificate: the line says it."""

    file: str
    outcome: _Outcome
    line: str
    claim: int | None = None

    def as_data(self) -> dict[str, object]:
        """The same as JSON data."""
        return {"file": self.file, "status": self.outcome.value, "line": self.line, "claim": self.claim}


def _files(target: str) -> Iterator[str]:
    path = Path(target)
    yield from (str(file) for file in sorted(path.rglob("*.json"))) if path.is_dir() else (target,)


def _put_line(verification: _Verification, *, several: bool) -> None:
    name = verification.file if verification.file.isprintable() else ascii(verification.file)
    emit((f"{name}: " if several else "") + verification.line + "\n", sys.stdout)


def _summary(counts: Mapping[_Outcome, int]) -> str:
    """The last line: `40 certificates: 38 VERIFIED, 2 NOT VERIFIED`."""
    words = {_Outcome.VERIFIED: "VERIFIED", _Outcome.NOT_VERIFIED: "NOT VERIFIED", _Outcome.UNREADABLE: "unreadable"}
    counted = ", ".join(f"{count} {words[outcome]}" for outcome, count in counts.items() if count)
    return f"{sum(counts.values())} certificates: {counted}\n"


def _verifications(names: Sequence[str], verify: Callable[[str], _Verification], jobs: int) -> Iterator[_Verification]:
    """The outcomes in the order of the names, from as many processes as are worth it."""
    jobs = min(jobs, len(names) // FEWEST)
    if jobs < 2:
        yield from map(verify, names)
        return
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    at_once = (signal.SIGINT, signal.SIG_DFL)  # Ctrl-C ends the processes without a word
    with ProcessPoolExecutor(jobs, initializer=signal.signal, initargs=at_once) as pool:
        try:
            yield from pool.map(verify, names)
        except BrokenProcessPool:
            raise click.ClickException("a process was killed; --jobs 1 works in this one") from None


def _verify(name: str, *, work: int | None, mask: str | None, subject: _Subject | None) -> _Verification:
    from subdiv_cli.checker import check_file
    from subdiv_cli.checker.core import MAX_WORK
    from subdiv_cli.checker.plain import certified_mask

    try:
        outcome, text = check_file(name, MAX_WORK if work is None else work)
    except OSError as error:
        return _Verification(name, _Outcome.UNREADABLE, f"{name} cannot be read: {error.strerror or error}")
    if not outcome.verified:
        return _Verification(name, _Outcome.NOT_VERIFIED, outcome.line, outcome.claim)
    if subject is None:
        return _Verification(name, _Outcome.VERIFIED, outcome.line)
    if certified_mask(text) == subject.mask:
        return _Verification(name, _Outcome.VERIFIED, f"{outcome.line} ({subject.how})")
    line = f"NOT VERIFIED mask: the certificate is about another mask than {mask}"
    return _Verification(name, _Outcome.NOT_VERIFIED, line)


class _Subject(NamedTuple):
    """The mask that certificates are to be about, and how it was read."""

    mask: PlainMask | None
    how: str


def _subject(file: str, parameters: Sequence[str]) -> _Subject:
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
        return _Subject(plain, f"the mask of {file}")
    return _Subject(
        mask_of(kind_of(scheme).canonical(scheme)), f"the mask of {file}, its parameters and symbol expanded by subdiv"
    )
