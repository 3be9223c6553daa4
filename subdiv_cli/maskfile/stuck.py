"""What to say where a TOML file cannot be read on: each function is one place to get stuck, and gives its fault."""

from __future__ import annotations

import re

from subdiv_cli.maskfile.bounds import MAX_NESTING
from subdiv_cli.maskfile.problems import Fault, shown

_ELEMENT = re.compile(r"[^,\[\]{}#\r\n\"']*")


def _element(text: str, start: int) -> str:
    """The unquoted text of a value, as far as it goes."""
    found = _ELEMENT.match(text, start)
    return shown(found.group().strip()) if found else ""


def _here(text: str, at: int) -> str:
    """The character at an offset in words."""
    if at >= len(text):
        return "the end of the file"
    if text[at] in "\"'":
        return "a quotation mark"
    return "the end of the line" if text[at] in "\r\n" else f'"{shown(text[at])}"'


def nesting(what: str, at: int) -> Fault:
    """Deeper than any mask needs."""
    return Fault("SD010", f"{what} is nested more than {MAX_NESTING} deep", "a mask file needs two levels", at)


def value(text: str, start: int) -> Fault:
    """No value begins here."""
    element = _element(text, start)
    if not element:
        return Fault(
            "SD001", f"a value was expected, not {_here(text, start)}", 'write a value, for instance "1/16"', start
        )
    if element.lower() in ("true", "false"):
        return Fault("SD001", f"{element} is not a TOML value", f"write {element.lower()} in lower case", start)
    if re.match(r"[+-]?\.[0-9]", element):
        mend = f'write 0 before the point, or a string: "{element}"'
        return Fault("SD001", "a decimal in TOML has a digit before its point", mend, start)
    at = start + (element[0] in "+-")
    message = "text and expressions must be quoted: no TOML value begins like this"
    return Fault("SD001", message, f'write it as a string: "{element}"', at)


def after_value(text: str, start: int, at: int) -> Fault:
    """Something directly after a value, or on the same line, that does not belong there. `start`: of the value."""
    c = text[at : at + 1]
    element = _element(text, start)
    if not element:  # a header, a string, an array or a table: there is nothing to quote
        return Fault("SD001", f"the line should end here, not continue with {_here(text, at)}", "start a new line", at)
    if c == "/":
        return Fault(
            "SD003", "fraction not quoted: TOML has no fractions", f'write exact numbers as strings: "{element}"', at
        )
    if c == ".":
        mend = f'write 1.0 for 1., or a string: "{element}"'
        return Fault("SD001", "a decimal in TOML has a digit after its point", mend, at)
    if c.isdigit() and text[start:at] in ("0", "-0", "+0"):
        return Fault(
            "SD001", "a number in TOML does not begin with 0", f"write {element.lstrip('+-0') or '0'} instead", at
        )
    if c and (c in "*^+-(−·×√" or c.isidentifier() or c.isdigit()):
        mend = f'write it as a string: "{element}"'
        return Fault("SD001", "expression not quoted: TOML has single numbers only", mend, at)
    return Fault("SD001", f"the value should end here, not continue with {_here(text, at)}", "start a new line", at)


def separator(text: str, opening: int, start: int, at: int, closing: str) -> Fault:
    """Neither a comma nor the end of an array or an inline table. `start`: of the value before."""
    same_line = "\n" not in text[start:at]
    if same_line and text[at] not in "\"'[{" and text[start] not in "\"'[{" and not text[at].isdigit():
        fault = after_value(text, start, at)
        if "quoted" in fault.message:
            return fault
    line = text.count("\n", 0, opening) + 1
    message = f'a comma or "{closing}" was expected, not {_here(text, at)}'
    mend = f'put a comma between values, or close the "{text[opening]}" of line {line}'
    return Fault("SD001", message, mend, at)


def unclosed(opening: int, bracket: str, closing: str) -> Fault:
    """The file ends inside an array or an inline table."""
    return Fault("SD001", f'this "{bracket}" is never closed', f'add the missing "{closing}"', opening)


def string(start: int, quote: str) -> Fault:
    """A string without end."""
    where = "" if len(quote) == 3 else " on its line"
    return Fault("SD001", f"this string is not closed{where}", f"add the missing {quote}", start)


def escape(text: str, at: int) -> Fault:
    """A backslash before a letter that TOML does not know."""
    mend = "write \\\\ for a backslash, or put the text in single quotes"
    return Fault("SD001", f'"{shown(text[at : at + 2])}" is no escape in TOML', mend, at)


def header(text: str, at: int, closing: str) -> Fault:
    """A table header without end."""
    message = f'"{closing}" was expected to close the table name, not {_here(text, at)}'
    return Fault("SD001", message, "write a table as [mask]", at)


def key(text: str, at: int) -> Fault:
    """No key begins here."""
    if text[at : at + 1].isidentifier():
        return Fault("SD001", f"{_here(text, at)} cannot stand in a bare key", 'quote the key: "ω" = "1/16"', at)
    return Fault("SD001", f"a key was expected, not {_here(text, at)}", "write one key = value on each line", at)


def equals(text: str, start: int, at: int) -> Fault:
    """A key without its "="."""
    name = shown(text[start:at].strip())
    message = f'"=" was expected after the key {name}, not {_here(text, at)}'
    return Fault("SD001", message, f"write {name} = value", at)
