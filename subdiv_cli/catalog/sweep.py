"""The rows of a sweep: one mask at many values of a parameter, checked as many masks are."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple

from subdiv_cli.catalog.run import check_all
from subdiv_cli.catalog.task import invalid
from subdiv_cli.kinds import kind_named
from subdiv_cli.maskfile import MaskFile, MaskFileError
from subdiv_cli.model import Effort, Result
from subdiv_cli.model.sweep import Column, Row, is_undecided, maximizing_product

if TYPE_CHECKING:
    from subdiv_cli.kinds.kind import Scheme


class ParameterFamily(NamedTuple):
    """A mask over one parameter."""

    mask: MaskFile
    parameter: str
    fixed: Mapping[str, Fraction]
    """The values of other parameters."""

    def scheme(self, value: Fraction) -> Scheme:
        """The scheme at a value of the parameter. Raises MaskFileError where there is none."""
        scheme: Scheme = self.mask.scheme({**self.fixed, self.parameter: value})
        return scheme


def rows(
    family: ParameterFamily, values: Sequence[Fraction], columns: Sequence[Column], work: int, **run: Any
) -> Iterator[Row]:
    """The rows of these values, in their order; one where there is no scheme has an invalid result.

    `work` is the effort for each question, `run` the further arguments of `check_all`: cache, jobs and listeners. No
    mask is checked where all columns are norms.
    """
    schemes: dict[Fraction, Scheme | Result] = {}
    for value in values:
        try:
            schemes[value] = family.scheme(value)
        except MaskFileError as error:
            schemes[value] = invalid(family.mask.file, error.problems)
    there = [value for value, scheme in schemes.items() if not isinstance(scheme, Result)]
    results: Iterator[Result] = (Result(file=family.mask.file, status="undecided") for _ in there)
    if there and any(column.about is not None for column in columns):
        overrides = {**{name: (value,) for name, value in family.fixed.items()}, family.parameter: there}
        target = family.mask if family.mask.file == "-" or not family.mask.source.toml else family.mask.file
        results = check_all([target], overrides=overrides, work=work, **run)
    for value, scheme in schemes.items():
        if isinstance(scheme, Result):
            yield Row(value, scheme)
        else:
            yield _row(value, next(results), scheme, columns, Effort(work))


def _row(value: Fraction, result: Result, scheme: Scheme, columns: Sequence[Column], effort: Effort) -> Row:
    """The row of a result, without its findings, which would fill the memory."""
    undecided = [c.name for c in columns if c.about is not None and is_undecided(result, c.about)]
    known: dict[str, Fraction] = {}
    norms = kind_named(scheme.kind).norms
    for column in columns:
        if column.about is not None or norms is None:
            continue
        powers = norms(scheme, column.nu, effort)
        if powers is None:
            continue
        for norm in islice(powers, column.level - 1, column.level):
            known[column.name] = norm
        if column.name not in known:
            undecided.append(column.name)
    lean = replace(result, findings=(), expectations=(), facts={}, hints=())
    return Row(value, lean, known, tuple(undecided), maximizing_product(result))
