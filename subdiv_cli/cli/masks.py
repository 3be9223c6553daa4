"""The masks that `check` looks at: files, lists of files, `--mask`, and the values of `-p`."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import click

from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.options import CheckOptions, belongs_to_mask
from subdiv_cli.cli.streams import complain
from subdiv_cli.model import Expectation, Problem, Result

if TYPE_CHECKING:
    from subdiv_cli.maskfile import MaskFile

MOST_BYTES = 64 << 20
"""The most bytes of a list of files."""


def usage(options: CheckOptions) -> None:
    """Raise a usage error for options that do not go together."""
    if options.mask is None and not options.targets and options.files_from is None:
        help = "name a file, as in `subdiv check four-point.toml`, or set paths in [tool.subdiv] of pyproject.toml"
        raise click.UsageError(f"nothing to check: {help}")
    if options.mask is not None and (options.targets or options.files_from is not None):
        raise click.UsageError("--mask checks one mask from the command line: leave out the files, or --mask")
    belongs_to_mask(options.mask, options.start, options.arity, options.targets)
    if options.quiet and options.verbose:
        raise click.UsageError("-q and -v contradict each other")
    if options.statistics and options.form not in ("text", "json"):
        raise click.UsageError(f"--statistics is text or json, not {options.form}: other formats go to files, with -o")
    if options.files_from == "-" and "-" in options.targets:
        raise click.UsageError("standard input is either a list of files or a mask, not both")


def overrides(parameters: Sequence[str]) -> dict[str, tuple[Fraction, ...]]:
    """The different values of -p by name. Ends the command, all faults printed, where one cannot be read."""
    if not parameters:
        return {}
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.option import parse_override

    values: dict[str, tuple[Fraction, ...]] = {}
    problems: list[Problem] = []
    for text in parameters:
        try:
            name, value = parse_override(text)
        except MaskFileError as error:
            problems += error.problems
            continue
        if value not in values.setdefault(name, ()):
            values[name] += (value,)
    _end(problems)
    return values


def required(properties: Sequence[str]) -> tuple[Expectation, ...]:
    """The properties of --require. Ends the command, all faults printed, where one cannot be read."""
    if not properties:
        return ()
    from dataclasses import replace

    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.option import parse_property

    expectations: list[Expectation] = []
    problems: list[Problem] = []
    for text in properties:
        try:
            expectations.append(parse_property(text))
        except MaskFileError as error:
            problems += (replace(problem, key="--require") for problem in error.problems)
    _end(problems)
    return tuple(dict.fromkeys(expectations))


def _end(problems: Sequence[Problem]) -> None:
    if problems:
        complain(problems)
        raise click.exceptions.Exit(ExitCode.ERROR)


def targets(options: CheckOptions, names: Collection[str]) -> list[str | MaskFile] | Result:
    """The files and masks to check; an invalid Result where --mask cannot be read.

    `names` are those of -p, which a mask may use.
    """
    if options.mask is None:
        listed = () if options.files_from is None else _listed(options.files_from)
        return [*options.targets, *listed]
    from subdiv_cli.kinds.option import from_given
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.option import Given

    try:
        return [from_given(options.mask, Given(options.start, options.arity, tuple(names)))]
    except MaskFileError as error:
        return Result(file="--mask", status="invalid", problems=tuple(error.problems))


def _listed(file: str) -> list[str]:
    """The names in a list, one a line; with a NUL in it, as `find -print0` writes it, between those."""
    from os import fsdecode

    from subdiv_cli.maskfile.bounds import at_most

    try:
        data = at_most(file, MOST_BYTES)
    except OSError as error:
        raise click.UsageError(f"--files-from {file}: cannot be read: {error.strerror or error}") from None
    if len(data) > MOST_BYTES:
        raise click.UsageError(f"--files-from {file}: larger than {MOST_BYTES >> 20} MiB")
    lines = data.split(b"\0") if b"\0" in data else data.splitlines()
    return [fsdecode(line) for line in lines if line.strip()]
