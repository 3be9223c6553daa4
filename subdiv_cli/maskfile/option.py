"""Values of parameters and properties from the command line: `-p`, `--require`; properties that reports state."""

from __future__ import annotations

import re
from fractions import Fraction

from subdiv_cli.maskfile.bounds import MAX_FILE_BYTES
from subdiv_cli.maskfile.evaluate import evaluate
from subdiv_cli.maskfile.grammar import parse
from subdiv_cli.maskfile.laurent import Work
from subdiv_cli.maskfile.problems import Fault, MaskFileError, near, shown
from subdiv_cli.maskfile.properties import KEYS, TRUTHS, comparison, expectation
from subdiv_cli.maskfile.tokens import is_name
from subdiv_cli.model import Expectation, Problem

_ORDER = re.compile(r"C\^?([0-9]+)")
_PROPERTY = re.compile(r"([^\W\d]\w*)\s*([=<>≥≤].*)?", re.DOTALL)


def parse_override(text: str) -> tuple[str, Fraction]:
    """`-p w=1/20` -> ("w", 1/20); any expression in numbers. Raises MaskFileError (SD011, or what the number is)."""
    name, equals, value = text.partition("=")
    said = name.strip()
    try:
        if not equals:
            raise Fault("SD011", f'"{shown(text)}" gives no value', "write NAME=VALUE: -p w=1/20", len(text))
        if not is_name(said):
            raise Fault("SD011", f'"{shown(said)}" cannot be a parameter\'s name', "write NAME=VALUE: -p w=1/20")
        if not value.strip():
            raise Fault("SD011", f"no value for {shown(said)}", f"write a number: -p {shown(said)}=1/20", len(text))
        if len(text) > MAX_FILE_BYTES:
            raise Fault("SD010", "the value is too long", "use a shorter number")
        node = parse(value, (), at=len(name) + 1)
        number = evaluate(node, {}, Work()).constant()
    except Fault as fault:
        raise _of_option(text, fault, "-p") from None
    assert number is not None, "z is not declared here"
    return said, number


def parse_expectation(key: str, value: object) -> Expectation:
    """The expectation that `key = value` states in [expect]: value a bool, an int, a string or a `Decimal`.

    Raises MaskFileError: SD004, SD006, SD010 or SD012.
    """
    try:
        return expectation(key, value)
    except Fault as fault:
        raise _of_option(value if isinstance(value, str) else "", fault, key) from None


def parse_property(text: str) -> Expectation:
    """`holder>=1.5`, `smoothness=1`, `C1` (smoothness >= 1), `convergent`, `stable=false`. Raises MaskFileError."""
    try:
        return _property(text)
    except Fault as fault:
        raise _of_option(text, fault, None) from None


def _property(text: str) -> Expectation:
    body = text.strip()
    if len(body) > 10_000:
        raise Fault("SD010", "the property is too long", "write for instance holder>=1.5")
    at = len(text) - len(text.lstrip())
    if found := _ORDER.fullmatch(body):
        return comparison("smoothness", f">={found[1]}", at + found.start(1) - 2)
    parts = _PROPERTY.fullmatch(body)
    if parts is None:
        raise Fault("SD012", f'"{shown(text)}" is no property', "write for instance C1, holder>=1.5 or convergent", at)
    key, rest = parts[1], parts[2]
    if key not in KEYS:
        guess = near(key, KEYS)
        mend = f"did you mean {guess}?" if guess else "properties: C1, " + ", ".join(KEYS)
        raise Fault("SD012", f'there is no property "{shown(key)}"', mend, at)
    if key in TRUTHS:
        truth = rest.lstrip("= ").lower() if rest else "true"
        if truth not in ("true", "false") or (rest and not rest.startswith("=")):
            raise Fault("SD012", f"{key} is true or false", f"write {key} or {key}=false", at + parts.start(2))
        return expectation(key, truth == "true")
    if not rest:
        raise Fault("SD012", f"{key} needs a number", f"write for instance {key}>=1", at + len(body))
    return comparison(key, rest, at + parts.start(2))


def _of_option(text: str, fault: Fault, key: str | None) -> MaskFileError:
    at = min(fault.at, len(text))
    problem = Problem(
        code=fault.code,
        message=fault.message,
        help=fault.help,
        key=key,
        line=1 if text else None,
        column=at + 1 if text else None,
        source=text or None,
    )
    return MaskFileError([problem])
