"""Values of parameters and properties from the command line: `-p`, `--require`; properties that reports state."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_FILE_BYTES
from subdiv_cli.maskfile.expressions import evaluate
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Fault, MaskFileError, near, shown
from subdiv_cli.maskfile.properties import KEYS, ORDER, TRUTHS, comparison, expectation
from subdiv_cli.maskfile.tokens import is_name
from subdiv_cli.model import Expectation


class Given(NamedTuple):
    """The command line's words beside a mask that is no file."""

    start: tuple[int, ...] | None = None
    arity: int | None = None
    names: tuple[str, ...] = ()
    """The parameters that -p gives."""


NOTHING_GIVEN = Given()


_PROPERTY = re.compile(r"([^\W\d]\w*)\s*([=<>≥≤].*)?", re.DOTALL)


def parse_override(text: str) -> tuple[str, Fraction]:
    """The name and the value that `-p w=1/20` gives, any expression in numbers. Raises MaskFileError."""
    left, equals, value = text.partition("=")
    name = left.strip()
    try:
        if not equals:
            help = f"write NAME=VALUE: -p {shown(name) if is_name(name) else 'w'}=1/20"
            raise Fault(faults.BAD_PARAMETER, f'"{shown(text)}" gives no value', help, len(text))
        if not is_name(name):
            raise Fault(
                faults.BAD_PARAMETER, f'"{shown(name)}" cannot be a parameter\'s name', "write NAME=VALUE: -p w=1/20"
            )
        if not value.strip():
            raise Fault(
                faults.BAD_PARAMETER, f"no value for {shown(name)}", f"write a number: -p {shown(name)}=1/20", len(text)
            )
        if len(text) > MAX_FILE_BYTES:
            raise Fault(faults.OUT_OF_BOUNDS, "the value is too long", "use a shorter number")
        node = parse(value, (), at=len(left) + 1)
        number = evaluate(node, {}, Work()).constant()
    except Fault as fault:
        raise _of_option(text, fault, "-p") from None
    assert number is not None, "z is not declared here"
    return name, number


def parse_expectation(key: str, value: object) -> Expectation:
    """The expectation that `key = value` states in [expect]: value a bool, an int, a string or a `Decimal`.

    Raises MaskFileError: SD004, SD006, SD010 or SD012.
    """
    try:
        return expectation(key, value)
    except Fault as fault:
        raise _of_option(value if isinstance(value, str) else "", fault, key) from None


def parse_property(text: str) -> Expectation:
    """The expectation that `holder>=1.5`, `C1` (smoothness >= 1) or `stable=false` states. Raises MaskFileError."""
    try:
        return _property(text)
    except Fault as fault:
        raise _of_option(text, fault, None) from None


def _property(text: str) -> Expectation:
    """The expectation that a property states. Raises Fault."""
    body = text.strip()
    if len(body) > 10_000:
        raise Fault(faults.OUT_OF_BOUNDS, "the property is too long", "write for instance holder>=1.5")
    at = len(text) - len(text.lstrip())
    if match := ORDER.fullmatch(body):
        order = 1 if match[1] else 2
        return comparison("smoothness", f">={match[order]}", at + match.start(order) - 2)
    parts = _PROPERTY.fullmatch(body)
    if parts is None:
        raise Fault(
            faults.BAD_EXPECTATION,
            f'"{shown(text)}" is no property',
            "write for instance C1, holder>=1.5 or convergent",
            at,
        )
    key, rest = parts[1], parts[2]
    if key not in KEYS:
        guess = near(key, KEYS)
        help = f"did you mean {guess}?" if guess else "properties: C1, " + ", ".join(KEYS)
        raise Fault(faults.BAD_EXPECTATION, f'there is no property "{shown(key)}"', help, at)
    if key in TRUTHS:
        truth = rest.lstrip("= ").lower() if rest else "true"
        if truth not in ("true", "false") or (rest and not rest.startswith("=")):
            raise Fault(
                faults.BAD_EXPECTATION, f"{key} is true or false", f"write {key} or {key}=false", at + parts.start(2)
            )
        return expectation(key, truth == "true")
    if not rest:
        raise Fault(faults.BAD_EXPECTATION, f"{key} needs a number", f"write for instance {key}>=1", at + len(body))
    return comparison(key, rest, at + parts.start(2))


def _of_option(text: str, fault: Fault, key: str | None) -> MaskFileError:
    """The error of a fault in the text of an option; no position where there is no text."""
    if not text:
        return MaskFileError([fault.problem(key=key)])
    column = min(fault.at, len(text)) + 1
    return MaskFileError([fault.problem(key=key, line=1, column=column, source=text)])
