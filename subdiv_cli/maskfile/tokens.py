"""The tokens of an expression, and the exact value of a number as it is spelled."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_BITS, MAX_DIGITS
from subdiv_cli.maskfile.characters import MENDS, stray
from subdiv_cli.maskfile.problems import Fault, shown


class Token(NamedTuple):
    """A token of an expression."""

    kind: str
    """The kind: number, name, end, or the operator itself: + - * / ^ ( ) [ ] ,"""
    text: str
    at: int


_SPACE = re.compile(r"[ \t\r\n]*")
_NUMBER = re.compile(r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_ASCII_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_BASE = re.compile(r"(\)|[A-Za-z0-9_.]{1,30})[ \t]*\Z")
_POWER = re.compile(r"[ \t]*([+-]?[0-9]{1,10})")
_OPERATORS = frozenset("+-*/^()[],")


def tokens(text: str, at: int = 0) -> Iterator[Token]:
    """The tokens of `text`, then "end" for ever. Offsets count from `at`. Raises Fault at what cannot be a token."""
    position = 0
    while True:
        position = _SPACE.match(text, position).end()  # type: ignore[union-attr]
        if position == len(text):
            break
        c = text[position]
        if c in _OPERATORS:
            if text.startswith("**", position):
                base, power = _BASE.search(text, 0, position), _POWER.match(text, position + 2)
                own = f"{base[1] if base and base[1] != ')' else '(…)'}^{power[1] if power else 2}"
                help = f"write ^ for a power: {shown(own)}"
                raise Fault(faults.BAD_EXPRESSION, '"**" is not the power here', help, at + position)
            kind, end = c, position + 1
        elif number := _NUMBER.match(text, position):
            kind, end = "number", number.end()
        elif end := _name_end(text, position):
            kind = "name"
        else:
            raise stray(text, position, at + position)
        yield Token(kind, text[position:end], at + position)
        position = end
    while True:
        yield Token("end", "", at + len(text.rstrip(" \t\r\n")))


def is_name(text: str) -> bool:
    """Whether a text can be a parameter's name: a letter or _, then letters, digits and _."""
    return bool(text) and text[0] not in MENDS and _name_end(text, 0) == len(text)


def _name_end(text: str, start: int) -> int:
    """The offset at which the name at `start` ends; 0 where there is none."""
    if name := _ASCII_NAME.match(text, start):
        end = name.end()
    elif text[start].isidentifier():
        end = start + 1
    else:
        return 0
    while end < len(text) and text[end] not in MENDS and ("a" + text[end]).isidentifier():
        end += 1
    return end


def number(token: Token) -> Fraction:
    """The exact number that a token spells: 12, 0.5, .5, 1e-3. Raises Fault (SD010) for one that is too long."""
    mantissa, _, power = token.text.lower().partition("e")
    whole, _, decimals = mantissa.partition(".")
    digits = whole + decimals
    if len(digits) > MAX_DIGITS:
        message = f"the number has {len(digits)} digits; the limit is {MAX_DIGITS}"
        raise Fault(faults.OUT_OF_BOUNDS, message, "use a shorter number", token.at)
    exponent = 0
    if power:
        size = power.lstrip("+-").lstrip("0")
        if len(size) > len(str(MAX_DIGITS)) or int(size or "0") > MAX_DIGITS:
            message = f"the decimal exponent {shown(power, 20)} is too large; the limit is {MAX_DIGITS}"
            raise Fault(faults.OUT_OF_BOUNDS, message, "use a number of a sensible size", token.at)
        exponent = int(power)
    exponent -= len(decimals)
    value = Fraction(int(digits) * 10 ** max(exponent, 0), 10 ** max(-exponent, 0))
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > MAX_BITS:
        message = f"the number {shown(token.text, 30)} has more than {MAX_DIGITS} digits"
        raise Fault(faults.OUT_OF_BOUNDS, message, "use a number of a sensible size", token.at)
    return value
