"""A mask file as read: expressions over its parameters, and the second step that puts numbers in."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import lcm
from typing import Any, Protocol

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_BITS, MAX_DIGITS
from subdiv_cli.maskfile.expressions import Expression, is_fixed, number_of
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Collector, Fault, Source, near, shown
from subdiv_cli.model import Expectation, Problem, Result


class Body(Protocol):
    """The content of [mask], not yet at values of the parameters."""

    def expressions(self) -> Iterable[Expression]:
        """All expressions in it, for those that need no parameters and for the names that stand in them."""

    def scheme(self, values: Mapping[str, Fraction], problems: Collector, work: Work) -> Any | None:
        """The scheme at these values of the parameters; None where something is wrong, which is recorded."""


def check_fixed_mask(body: Body, problems: Collector) -> None:
    """Record the faults of the scheme of a mask without parameters."""
    if all(is_fixed(entry.node) for entry in body.expressions()):
        body.scheme({}, problems, Work())


def zero_mask(values: Mapping[str, Fraction]) -> Fault:
    """The fault of a mask whose coefficients are all zero at these values of the parameters."""
    help = "at least one coefficient must not be zero" + ("; try other parameters" if values else "")
    return Fault(faults.ZERO_MASK, "all coefficients of the mask are zero", help)


def too_precise(coefficients: Iterable[Fraction]) -> Fault | None:
    """The fault of coefficients with a common denominator that is too long; None where it is not."""
    common = 1
    for c in coefficients:
        common = lcm(common, c.denominator)
        if common.bit_length() > MAX_BITS:
            message = f"the coefficients' common denominator has more than {MAX_DIGITS} digits"
            return Fault(faults.OUT_OF_BOUNDS, message, "use fractions with smaller denominators")
    return None


@dataclass(frozen=True, slots=True, kw_only=True)
class MaskFile:
    """A mask file as read; two are equal when their contents are, wherever these stand in the text."""

    file: str
    """The name on the command line; "-" is standard input."""
    body: Body
    name: str | None = None
    reference: str | None = None
    kind: str = "scalar"
    parameters: Mapping[str, Expression | None] = field(default_factory=dict)
    """The defaults in order of declaration; one may use the parameters declared before it, None is no default."""
    expectations: tuple[Expectation, ...] = ()
    source: Source = field(default_factory=lambda: Source(None, "", toml=False), repr=False)
    """The text that positions of later problems refer to."""

    def values(self, overrides: Mapping[str, Fraction] | None = None) -> dict[str, Fraction]:
        """The values of all parameters, in order of declaration: the override, else the default.

        Raises MaskFileError: SD011 for an override of no parameter, a parameter without value or a division by zero,
        SD010 for sizes.
        """
        problems = Collector(self.source)
        values = parameter_values(self.parameters, overrides or {}, problems, Work())
        problems.raise_any()
        return values

    def line_of(self, *path: str) -> int | None:
        """The 1-based line of a key, `line_of("expect", "holder")`; None where the text does not state it."""
        if not self.source.toml:
            return None
        from subdiv_cli.maskfile.positions import line_and_column, scan

        spot = scan(self.source.text).spots.get(path)
        return None if spot is None else line_and_column(self.source.text, spot.key)[0]

    def scheme(self, overrides: Mapping[str, Fraction] | None = None) -> Any:
        """The scheme at the parameters' values. Raises MaskFileError as `values` does, SD009 for an all-zero mask."""
        problems = Collector(self.source)
        work = Work()
        values = parameter_values(self.parameters, overrides or {}, problems, work)
        problems.raise_any()
        scheme = self.body.scheme(values, problems, work)
        problems.raise_any()
        assert scheme is not None, "what keeps a mask from being expanded is a problem"
        return scheme

    def labelled(self, result: Result, parameters: Mapping[str, Fraction]) -> Result:
        """A result of this mask at these values, with what the file says about it."""
        return replace(
            result, file=self.file, name=self.name, kind=self.kind, reference=self.reference, parameters=parameters
        )


def parameter_values(
    parameters: Mapping[str, Expression | None], overrides: Mapping[str, Fraction], problems: Collector, work: Work
) -> dict[str, Fraction]:
    """The values of all parameters, in order of declaration. What is wrong is recorded: SD010, SD011."""
    for name, value in overrides.items():
        if name not in parameters:
            problems.add(_no_parameter(name, parameters))
        elif max(value.numerator.bit_length(), value.denominator.bit_length()) > MAX_BITS:
            message = f"the value of {shown(name)} has more than {MAX_DIGITS} digits"
            problems.add(Fault(faults.OUT_OF_BOUNDS, message, "use a shorter number"))
    values: dict[str, Fraction] = {}
    for name, default in parameters.items():
        if name in overrides:
            values[name] = overrides[name]
        elif default is None:
            help = f"give it one: -p {shown(name)}=1/16, or a default in [parameters]"
            problems.add(
                Fault(faults.BAD_PARAMETER, f"the parameter {shown(name)} has no value", help), ("parameters", name)
            )
        else:
            number = number_of(default, values, problems, work)
            if number is not None:
                values[name] = number
    return values


def no_such_parameter(name: str, parameters: Collection[str]) -> Problem:
    """The problem of a value for a parameter that none of several masks has, `parameters` being those of them all."""
    message = f"no mask here has a parameter {shown(name)}"
    guess = near(name, parameters)
    there = ", ".join(shown(p) for p in sorted(parameters)[:8])
    none = "declare it in [parameters], or leave it out"
    help = f"did you mean {shown(guess)}?" if guess else f"there are {there}" if there else none
    return faults.BAD_PARAMETER.problem(message, help, file="-p")


def _no_parameter(name: str, parameters: Mapping[str, object]) -> Fault:
    """The fault of a value for a parameter that the mask does not have."""
    message = f"this mask has no parameter {shown(name)}"
    if guess := near(name, parameters):
        return Fault(faults.BAD_PARAMETER, message, f"did you mean {shown(guess)}?")
    if parameters:
        return Fault(
            faults.BAD_PARAMETER, message, "its parameters: " + ", ".join(shown(p) for p in list(parameters)[:8])
        )
    return Fault(faults.BAD_PARAMETER, message, "it has none: leave -p out, or declare it in [parameters]")
