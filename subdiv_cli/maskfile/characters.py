"""Characters that typography puts where a mask file wants plain ones, and what to write instead."""

from __future__ import annotations

import re

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.problems import Fault, shown

MENDS = dict.fromkeys("−–—‐‑‒﹣－", "-") | dict.fromkeys("×·⋅∙•∗✕", "*") | dict.fromkeys("÷⁄∕／", "/")
MENDS |= {"½": "(1/2)", "¼": "(1/4)", "¾": "(3/4)", "⅓": "(1/3)", "⅔": "(2/3)", "⅛": "(1/8)", "⁻": "^-", "＋": "+"}
MENDS |= {power: f"^{i}" for i, power in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")} | {"√": "", "\u00a0": "a space", "\u2009": "a space"}

QUOTES = frozenset("“”„‟‘’‚‛«»‹›″′")
RATIONAL_ONLY = "rational masks only: an irrational coefficient cannot be checked, and a parameter does not help"
_POWER = re.compile("([⁺⁻]?)([⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_BRACED = re.compile(r"\{\s*([+-]?[0-9]{1,10})\s*\}")
_BASE = re.compile(r"[^\W\d]\w*\^\Z")


def named(c: str) -> str:
    """A character as a message quotes it, with its code point where a terminal may show another in its place."""
    return f'"{c}" (U+{ord(c):04X})' if c > "~" and (c.isprintable() or c in MENDS) else f'"{shown(c)}"'


def instead(c: str) -> str:
    """The text to write in place of a character in MENDS."""
    return 'the ASCII minus "-"' if MENDS[c] == "-" else MENDS[c]


def mended(text: str) -> str:
    """The text in plain characters, typographic quotation marks dropped."""
    text = _POWER.sub(_power, text)
    plain = ((" " if MENDS[c] == "a space" else MENDS[c]) if c in MENDS and c != "√" else c for c in text)
    return "".join(c for c in plain if c not in QUOTES)


def _power(match: re.Match[str]) -> str:
    """A power as typography writes it, in plain characters."""
    return "^" + ("-" if match[1] == "⁻" else "") + "".join(MENDS[c][1] for c in match[2])


def stray(text: str, i: int, at: int) -> Fault:
    """The fault of the character at `i` of an expression, which begins no token; `at` is its offset for the fault."""
    c = text[i]
    if c == "√":
        return Fault(faults.BAD_EXPRESSION, "a square root is not rational", RATIONAL_ONLY, at)
    if power := _POWER.match(text, i):
        return Fault(
            faults.BAD_EXPRESSION,
            f"the character {named(c)} is not understood here",
            f"write {_power(power)} instead",
            at,
        )
    if c in MENDS:
        return Fault(
            faults.BAD_EXPRESSION, f"the character {named(c)} is not understood here", f"write {instead(c)} instead", at
        )
    if c in QUOTES:
        help = "leave it out: straight quotes are round the whole expression already"
        return Fault(faults.BAD_EXPRESSION, f"the character {named(c)} is not understood here", help, at)
    help = 'an expression has numbers, names, + - * / ^ and parentheses: "1/2 + w"'
    if c in "{}":
        help = "write parentheses in place of braces"
        if text[i - 1 : i] == "^" and (braced := _BRACED.match(text, i)):
            base = _BASE.search(text[max(0, i - 30) : i])
            power_of = shown(base[0]) if base else "^"
            help = f"write {power_of}{braced[1]} or {power_of}({braced[1]})"
    return Fault(faults.BAD_EXPRESSION, f"the character {named(c)} cannot stand in an expression", help, at)
