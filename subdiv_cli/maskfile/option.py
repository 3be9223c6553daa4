"""Values of parameters and properties from the command line: `-p`, `--require`; properties that reports state."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_FILE_BYTES
from subdiv_cli.maskfile.expressions import evaluate
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Fault, MaskFileError, near, shown, shown_number
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
MOST_VALUES = 10_000
"""The most values of a parameter that a sweep takes."""


_PROPERTY = re.compile(r"([^\W\d]\w*)\s*([=<>≥≤].*)?", re.DOTALL)


def parse_override(text: str) -> tuple[str, Fraction]:
    """The name and the value that `-p w=1/20` gives, any expression in numbers. Raises MaskFileError."""
    try:
        name, value, at = _assignment(text, "-p w=1/20")
        if ":" in value:
            help = f"for a table over a range: `subdiv sweep FILE {shown(text)}`"
            message = f"-p gives {shown(name)} a value, not a range"
            raise Fault(faults.BAD_PARAMETER, message, help, at + value.index(":"))
        return name, _number(value, at)
    except Fault as fault:
        raise _of_option(text, fault, "-p") from None


def parse_values(text: str) -> tuple[str, tuple[Fraction, ...]]:
    """The name and the different values that `w=-1/2:1/2:1/100` or `w=1/16,1/20` gives, in this order.

    `a:b:h` is a, a + h, …, up to b. Raises MaskFileError.
    """
    try:
        name, rest, at = _assignment(text, "w=0:1/4:1/100")
        values: dict[Fraction, None] = {}
        for item in rest.split(","):
            values |= dict.fromkeys(_range(item, at))
            if len(values) > MOST_VALUES:
                raise _too_many(at)
            at += len(item) + 1
        return name, tuple(values)
    except Fault as fault:
        raise _of_option(text, fault, "NAME=FROM:TO:STEP") from None


def _assignment(text: str, example: str) -> tuple[str, str, int]:
    """The name, the text behind `=`, and where that begins. Raises Fault where one of them is missing."""
    left, equals, value = text.partition("=")
    name = left.strip()
    option, right = example.split("w=")
    if not equals:
        help = f"write NAME=VALUE: {option}{shown(name) if is_name(name) else 'w'}={right}"
        raise Fault(faults.BAD_PARAMETER, f'"{shown(text)}" gives no value', help, len(text))
    if not is_name(name):
        message = f'"{shown(name)}" cannot be a parameter\'s name'
        raise Fault(faults.BAD_PARAMETER, message, f"write NAME=VALUE: {example}")
    if not value.strip():
        help = f"write a number: {option}{shown(name)}={right}"
        raise Fault(faults.BAD_PARAMETER, f"no value for {shown(name)}", help, len(text))
    if len(text) > MAX_FILE_BYTES:
        raise Fault(faults.OUT_OF_BOUNDS, "the value is too long", "use a shorter number")
    return name, value, len(left) + 1


def _range(text: str, at: int) -> Iterator[Fraction]:
    """The values of an item, `a` or `a:b:h`. Raises Fault."""
    parts = text.split(":")
    if len(parts) not in (1, 3):
        help = "write FROM:TO:STEP, as in 0:1/4:1/100"
        raise Fault(faults.BAD_PARAMETER, f'"{shown(text.strip())}" is neither a value nor a range', help, at)
    numbers, places = [], []
    for part in parts:
        places.append(at)
        numbers.append(_number(part, at))
        at += len(part) + 1
    if len(parts) == 1:
        return iter(numbers)
    first, last, step = numbers
    if not step:
        raise Fault(faults.BAD_PARAMETER, "the step is 0", "a step leads from FROM towards TO", places[2])
    count = (last - first) // step + 1
    if count < 1:
        help = f"write {'-' if step > 0 else ''}{shown_number(abs(step))}, or exchange FROM and TO"
        raise Fault(faults.BAD_PARAMETER, f"the step leads away from {shown_number(last)}", help, places[2])
    if count > MOST_VALUES:
        raise _too_many(places[2])
    return (first + i * step for i in range(count))


def _too_many(at: int) -> Fault:
    """The fault of more values than are taken at once."""
    return Fault(faults.OUT_OF_BOUNDS, f"these are more than {MOST_VALUES} values", "take a larger step", at)


def _number(text: str, at: int) -> Fraction:
    """The number of an expression without names, which stands there in the text of an option. Raises Fault."""
    number = evaluate(parse(text, (), at=at), {}, Work()).constant()
    assert number is not None, "z is not declared here"
    return number


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
