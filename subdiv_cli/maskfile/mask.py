"""A mask file as read: expressions over its parameters, and the second step that puts numbers in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm
from typing import NamedTuple

from subdiv_cli.maskfile.bounds import MAX_BITS, MAX_DIGITS, MAX_EXPONENT, MAX_MASK_LENGTH
from subdiv_cli.maskfile.evaluate import evaluate, names_in
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.nodes import Node, Number
from subdiv_cli.maskfile.problems import Collector, Fault, KeyPath, Source, near, shown
from subdiv_cli.model import Expectation
from subdiv_cli.schemes.scalar import ScalarScheme


class Expression:
    """An exact number or expression as the file spells it, and its tree; equal to another wherever each stands."""

    __slots__ = ("node", "path", "text")

    def __init__(self, *, text: str, node: Node, path: KeyPath = ()) -> None:
        self.text, self.node, self.path = text, node, path

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Expression) and (self.text, self.node) == (other.text, other.node)

    def __hash__(self) -> int:
        return hash((self.text, self.node))


class Coefficients(NamedTuple):
    """a_start, a_(start+1), …, one expression without z each; at least one."""

    arity: int
    start: int
    entries: tuple[Expression, ...]


class Symbol(NamedTuple):
    """a(z) = Σ a_k z^k as one expression in z."""

    arity: int
    expression: Expression


@dataclass(frozen=True, slots=True, kw_only=True)
class MaskFile:
    """One mask file; equal to another when it says the same, wherever in the text."""

    file: str
    """As named on the command line; "-" is standard input."""
    body: Coefficients | Symbol
    name: str | None = None
    reference: str | None = None
    kind: str = "scalar"
    parameters: Mapping[str, Expression | None] = field(default_factory=dict)
    """In order of declaration; a default may use the parameters declared before it, None is no default."""
    expectations: tuple[Expectation, ...] = ()
    source: Source = field(default_factory=lambda: Source(None, "", toml=False), repr=False)
    """What positions of later problems refer to."""

    def values(self, overrides: Mapping[str, Fraction] | None = None) -> dict[str, Fraction]:
        """Every parameter's value, in order of declaration: its override, else its default.

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
        from subdiv_cli.maskfile.positions import line_and_column
        from subdiv_cli.maskfile.scanner import scan

        spot = scan(self.source.text).spots.get(path)
        return None if spot is None else line_and_column(self.source.text, spot.key)[0]

    def scheme(self, overrides: Mapping[str, Fraction] | None = None) -> ScalarScheme:
        """The scheme at the parameters' values. Raises MaskFileError as `values` does, SD009 for an all-zero mask."""
        problems = Collector(self.source)
        work = Work()
        values = parameter_values(self.parameters, overrides or {}, problems, work)
        problems.raise_any()
        coefficients = expand(self.body, values, problems, work)
        problems.raise_any()
        start = min(coefficients)
        dense = tuple(coefficients.get(k, Fraction(0)) for k in range(start, max(coefficients) + 1))
        return ScalarScheme(arity=self.body.arity, start=start, coefficients=dense)


def parameter_values(
    parameters: Mapping[str, Expression | None], overrides: Mapping[str, Fraction], problems: Collector, work: Work
) -> dict[str, Fraction]:
    """Every parameter's value, in order of declaration. What is wrong is recorded: SD010, SD011."""
    for name, value in overrides.items():
        if name not in parameters:
            problems.add(_no_parameter(name, parameters))
        elif max(value.numerator.bit_length(), value.denominator.bit_length()) > MAX_BITS:
            message = f"the value of {shown(name)} has more than {MAX_DIGITS} digits"
            problems.add(Fault("SD010", message, "use a shorter number"))
    values: dict[str, Fraction] = {}
    for name, default in parameters.items():
        if name in overrides:
            values[name] = overrides[name]
        elif default is None:
            mend = f"give it one: -p {shown(name)}=1/16, or a default in [parameters]"
            problems.add(Fault("SD011", f"the parameter {shown(name)} has no value", mend), ("parameters", name))
        else:
            number = number_of(default, values, problems, work)
            if number is not None:
                values[name] = number
    return values


def _no_parameter(name: str, parameters: Mapping[str, object]) -> Fault:
    message = f"this mask has no parameter {shown(name)}"
    if guess := near(name, parameters):
        return Fault("SD011", message, f"did you mean {shown(guess)}?")
    if parameters:
        return Fault("SD011", message, "its parameters: " + ", ".join(shown(p) for p in list(parameters)[:8]))
    return Fault("SD011", message, "it has none: leave -p out, or declare it in [parameters]")


def number_of(
    expression: Expression, values: Mapping[str, Fraction], problems: Collector, work: Work
) -> Fraction | None:
    """The value of an expression without z. None where that is a problem, which is recorded, or hangs on one."""
    if isinstance(expression.node, Number):
        return expression.node.value
    try:
        value = evaluate(expression.node, values, work).constant()
    except Fault as fault:
        problems.add(fault, expression.path)
        return None
    except KeyError:  # a parameter without a value, which is reported where it is declared
        return None
    assert value is not None, "z is refused when coefficients are read"
    return value


def expand(
    body: Coefficients | Symbol, values: Mapping[str, Fraction], problems: Collector, work: Work
) -> dict[int, Fraction]:
    """index -> coefficient, the non-zero ones. What is wrong is recorded: SD007 to SD011."""
    if isinstance(body, Symbol):
        path = body.expression.path
        try:
            coefficients = evaluate(body.expression.node, values, work).coefficients
        except Fault as fault:
            problems.add(fault, path)
            return {}
    else:
        path = body.entries[0].path[:-1]
        coefficients = {}
        complete = True
        for k, entry in enumerate(body.entries, body.start):
            value = number_of(entry, values, problems, work)
            complete &= value is not None
            if value:
                coefficients[k] = value
        if not complete:
            return {}
    if not coefficients:
        mend = "at least one coefficient must not be zero" + ("; try other parameters" if values else "")
        problems.add(Fault("SD009", "all coefficients of the mask are zero", mend), path)
    elif fault_of_size := _too_long(coefficients):
        problems.add(fault_of_size, path)
    return coefficients


def check_zero(body: Coefficients | Symbol, problems: Collector) -> None:
    """Expands a mask that does not hang on parameters, for SD009 and SD010."""
    entries = body.entries if isinstance(body, Coefficients) else (body.expression,)
    if all(names_in(entry.node) <= {"z"} for entry in entries):
        expand(body, {}, problems, Work())


def _too_long(coefficients: Mapping[int, Fraction]) -> Fault | None:
    first, last = min(coefficients), max(coefficients)
    if last - first >= MAX_MASK_LENGTH:
        message = f"the mask has {last - first + 1} coefficients; the limit is {MAX_MASK_LENGTH}"
        return Fault("SD010", message, "use a shorter mask")
    if max(-first, last) > 2 * MAX_EXPONENT:
        return Fault("SD010", f"an index beyond {2 * MAX_EXPONENT}", "shift the mask towards 0")
    common = 1
    for c in coefficients.values():
        common = lcm(common, c.denominator)
        if common.bit_length() > MAX_BITS:
            message = f"the coefficients' common denominator has more than {MAX_DIGITS} digits"
            return Fault("SD010", message, "use fractions with smaller denominators")
    return None


def from_scheme(
    scheme: ScalarScheme,
    *,
    file: str = "-",
    name: str | None = None,
    reference: str | None = None,
    expectations: tuple[Expectation, ...] = (),
) -> MaskFile:
    """The file of a scheme with literal coefficients, for `write`."""
    entries = tuple(Expression(text=str(c), node=literal(c)) for c in scheme.coefficients)
    body = Coefficients(arity=scheme.arity, start=scheme.start, entries=entries)
    return MaskFile(file=file, body=body, name=name, reference=reference, expectations=expectations)


def literal(value: Fraction) -> Node:
    """The tree that reading str(value) gives."""
    from subdiv_cli.maskfile.grammar import parse

    return parse(str(value), ())
