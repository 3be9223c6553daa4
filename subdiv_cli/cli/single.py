"""Commands about one mask: how the command line names it, and how it is read."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING, NamedTuple, NoReturn

import click

from subdiv_cli.cli import streams
from subdiv_cli.cli.options import all_of, belongs_to_mask, effort, named
from subdiv_cli.model import Problem, Result

if TYPE_CHECKING:
    from subdiv_cli.kinds.kind import Scheme
    from subdiv_cli.maskfile import MaskFile


class One(NamedTuple):
    """A mask at the values of its parameters."""

    mask: MaskFile
    parameters: dict[str, Fraction]
    scheme: Scheme

    def title(self, family: Sequence[One] = ()) -> str:
        """The name of the mask, and its parameters, among others only where some of these have the same name."""
        from subdiv_cli.model.closed import rational

        name = self.mask.name or self.mask.file
        alike = sum(other.mask.file == self.mask.file for other in family)
        given = f"{', '.join(f'{key} = {rational(value)}' for key, value in self.parameters.items())}"
        return f"{name}, {given}" if given and (alike > 1 or not family) else name

    def label(self, result: Result) -> Result:
        """The result with the names and parameters of the file."""
        return self.mask.labelled(result, self.parameters)


options = all_of(named, effort("Work one question may cost."))
"""The options that name one mask, and bound the work on it."""


BELONGS = {
    "tolerance": "--tolerance belongs to curves, those of masks in one variable",
    "derivatives": "--derivatives belongs to curves, the functions of masks in one variable: leave out --points",
    "closed": "--closed and --open belong to --points, for curves: those of masks in one variable",
    "levels": "--levels belongs to --points, or to the net of a mask in two variables, -o NET.obj",
    "points": "--points belongs to masks in one variable, or to the net of one in two, -o NET.obj",
    "samples": "--samples belongs to curves, those of masks in one variable",
    "style": "--as belongs to surfaces, those of masks in several variables, in -o FILE.svg, .png or .pdf",
}
"""The purpose of each option that not every kind of mask has."""


def refuse_others(given: Collection[str], taken: Collection[str]) -> None:
    """Raise a usage error for a given option that is not among those that are taken."""
    for option, what in BELONGS.items():
        if option in given and option not in taken:
            raise click.UsageError(what)


class Named(NamedTuple):
    """The masks that the command line names."""

    command: str
    capability: str
    """The capability that their kinds must declare, a field of `Kind`."""
    files: tuple[str, ...]
    mask: str | None
    start: tuple[int, ...] | None
    arity: int | None
    parameters: tuple[str, ...]

    def usage(self) -> None:
        """Raise a usage error for options that do not go together."""
        if bool(self.files) == (self.mask is not None):
            what = f"`subdiv {self.command} four_point.toml`"
            raise click.UsageError(f"name a mask: a FILE or --mask, and not both, as in {what}")
        belongs_to_mask(self.mask, self.start, self.arity, self.files)


def read(meant: Named) -> One:
    """The one mask that is named. Where it cannot be read, writes why to stderr and exits with 2."""
    family = read_family(meant)
    if len(family) > 1:
        raise click.UsageError(f"-p gives a parameter several values: `subdiv {meant.command}` takes one mask")
    return family[0]


def read_family(meant: Named) -> list[One]:
    """The masks that are named, at every combination of their parameters' values. Exits with 2 as `read` does."""
    meant.usage()
    from subdiv_cli.maskfile import MaskFileError
    from subdiv_cli.maskfile.mask import no_such_parameter
    from subdiv_cli.maskfile.option import parse_override

    try:
        values: dict[str, list[Fraction]] = {}
        for name, value in map(parse_override, meant.parameters):
            values.setdefault(name, []).append(value)
        masks = read_masks(meant, tuple(values))
        there = {name for mask in masks for name in mask.parameters}
        if len(masks) > 1 and (strange := [name for name in values if name not in there]):
            complain([no_such_parameter(name, there) for name in strange])
        return [one for mask in masks for one in _variants(mask, values, alone=len(masks) == 1)]
    except MaskFileError as error:
        complain(error.problems)


def read_masks(meant: Named, names: tuple[str, ...]) -> list[MaskFile]:
    """The masks that are named, at no values of their parameters yet; `names` are those that the command line gives.

    Raises MaskFileError.
    """
    from subdiv_cli.kinds.option import from_given
    from subdiv_cli.kinds.reading import read_path
    from subdiv_cli.maskfile.option import Given

    given = Given(meant.start, meant.arity, names)
    if meant.mask is not None:
        return [from_given(meant.mask, given)]
    return [read_path(file, capability=meant.capability, given=given) for file in meant.files]


def _variants(mask: MaskFile, values: Mapping[str, Sequence[Fraction]], *, alone: bool) -> Iterator[One]:
    """The mask at all combinations; beside other masks it takes only the parameters that it has."""
    names = [name for name in values if alone or name in mask.parameters]
    for combination in product(*(dict.fromkeys(values[name]) for name in names)):
        overrides = dict(zip(names, combination, strict=True))
        yield One(mask, mask.values(overrides), mask.scheme(overrides))


def complain(problems: Sequence[Problem]) -> NoReturn:
    """Write problems to stderr, and end the command with 2."""
    raise click.exceptions.Exit(streams.complain(problems))
