"""Faults of texts that cannot be read on: each function is one place to get stuck, and gives its fault.

Loaded only when there is something wrong: a TOML file that breaks off, or a name that is not known in an expression.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_NESTING
from subdiv_cli.maskfile.characters import MENDS, QUOTES, RATIONAL_ONLY, instead, mended, named
from subdiv_cli.maskfile.problems import Fault, Reason, near, shown
from subdiv_cli.maskfile.tokens import Token, is_name

_VARIABLE = re.compile(r"z[0-9]*")
_NOT_FINITE = ("nan", "inf", "infinity")
_IRRATIONAL = ("sqrt", "cbrt", "root", "exp", "log", "ln", "sin", "cos", "tan", "pow", "pi", "phi", "tau", "e")


def unknown_name(token: Token, names: Collection[str], *, called: bool = False, logarithms: bool = False) -> Fault:
    """The fault of a name that is not known, with the likeliest help. `called`: a parenthesis follows."""
    name = token.text
    rule, reason = faults.BAD_EXPRESSION, None
    if name.lower() in _NOT_FINITE:
        rule, message, help = faults.BAD_NUMBER, f"{name} is not a rational number", "write a finite number"
    elif _VARIABLE.fullmatch(name):
        message, help = _variable(name, names)
    elif logarithms and name.lower().startswith(("log", "ln")):
        message, help = f'"{shown(name)}" needs its base and an argument', "write log2(64/9) or log3(11)/2"
    elif called and (name.lower() in _IRRATIONAL or len(name) > 1) and not _split(name, names):
        message = f'"{shown(name)}(…)" is a function call, and there are none'
        help = RATIONAL_ONLY if name.lower() in _IRRATIONAL else "write the value itself, or * to multiply"
    else:
        message = f'the name "{shown(name)}" is not declared'
        if meant := _meant(name, names, logarithms):
            reason, help = Reason.MISTAKEN, meant
        else:
            reason, help = Reason.UNDECLARED, _declared(name, names)
    return Fault(rule, message, help, token.at, reason=reason, about=name)


def _variable(name: str, names: Collection[str]) -> tuple[str, str]:
    """The message and the help for a variable where there are others, or none."""
    if "z1" in names:
        variables = sorted(known for known in names if _VARIABLE.fullmatch(known))
        help = "the variables here are " + ", ".join(variables)
        return (
            "z alone is no variable of a mask in several" if name == "z" else f"there is no variable {shown(name)}",
            help,
        )
    if "z" in names:
        help = 'write z; a mask in several variables has kind = "multivariate"'
        return f"a scalar mask has one variable, and {shown(name)} is not it", help
    help = "give the whole mask as a symbol to use z" if name == "z" else "give the whole mask as a symbol to use it"
    return f"{shown(name)} cannot stand in a single number", help


def _meant(name: str, names: Collection[str], logarithms: bool) -> str | None:
    """The help where something else is probably meant than a parameter of this name."""
    if parts := _split(name, names):
        return f"to multiply, write {'*'.join(parts)}"
    if name in ("x", "Z") and "z" in names:
        return "the variable of a symbol is z: (1+z)^4"
    if guess := near(name, names):
        return f"did you mean {shown(guess)}?"
    if name.lower() in _IRRATIONAL:
        return RATIONAL_ONLY
    return 'write a number or a closed form: "1.5", "log2(64/9)"' if logarithms else None


def _declared(name: str, names: Collection[str]) -> str:
    """The help on how a parameter of this name is declared."""
    if not names or names == {"z"}:
        return f'declare it in [parameters] of a mask file: {shown(name)} = "1/16"'
    known = ", ".join(sorted(shown(n, 20) for n in names)[:8])
    return f"known here: {known}; declare it in [parameters]: {shown(name)} = 1"


def _split(name: str, names: Collection[str]) -> list[str]:
    """The two known names that a name is put together of, zw of z and w; none where there are no such two."""
    for i in range(1, min(len(name), 30)):
        if name[:i] in names and name[i:] in names:
            return [name[:i], name[i:]]
    return []


_ELEMENT = re.compile(r"[^,\[\]{}#\r\n\"']*")
_TOML_NUMBER = re.compile(r"[+-]?(0|[1-9][0-9]*)(\.[0-9]+)?")
_KEY_LINE = re.compile(r"([^=#\"'\r\n]*)=[ \t]*([^\r\n]*)")
_REST = re.compile(r"[^\r\n]*")
_SAFE_VALUE = re.compile(r"(\"[^\"\\]{0,40}\"|[+-]?(?:0|[1-9][0-9]{0,9})(?:\.[0-9]{1,20})?)[ \t]*(?:#.*)?")
_WHOLE_PART = re.compile(r"(?<![0-9.])([+-]?[0-9]+),\Z")
_BESIDE_VALUES = ("//", "/*", ";")
_COMMENTS = (*_BESIDE_VALUES, "--", "%")


def _element(text: str, start: int) -> str:
    """The unquoted text of a value, as far as it goes."""
    match = _ELEMENT.match(text, start)
    return shown(match.group().strip()) if match else ""


def _here(text: str, at: int) -> str:
    """The character at an offset in words."""
    if at >= len(text):
        return "the end of the file"
    if text[at] in "\"'":
        return "a quotation mark"
    return "the end of the line" if text[at] in "\r\n" else named(text[at])


def _as_string(element: str) -> str:
    """The string to write for an unquoted expression, in characters that can then be read."""
    if "√" in element or "sqrt" in element:
        return RATIONAL_ONLY
    return f'write it as a string: "{mended(element)}"'


def _comment(text: str, at: int, marks: tuple[str, ...] = _COMMENTS) -> Fault | None:
    """The fault of a comment as other languages write it; None where there is none."""
    if not text.startswith(marks, at):
        return None
    message = f"a comment in TOML does not begin with {_here(text, at)}"
    return Fault(faults.TOML_SYNTAX, message, "comments begin with #", at)


def _typography(element: str, start: int) -> Fault | None:
    """The fault of typographic quotation marks, or of a value that begins with no plain character; None without."""
    plain = mended(element)
    for i, c in enumerate(element):
        if c in QUOTES:
            whole = element[0] in QUOTES and element[-1] in QUOTES and len(element) > 1
            help = f'write straight quotes: "{plain}"' if whole else 'write straight quotes: "1/8"'
            if whole and _TOML_NUMBER.fullmatch(plain):
                help = f"write it without quotes: {plain}"
            return Fault(faults.TOML_SYNTAX, f"the character {named(c)} is no quotation mark in TOML", help, start + i)
    first = element.lstrip("+-.")[:1]
    if first not in MENDS or first == "√":
        return None
    written = plain if _TOML_NUMBER.fullmatch(plain) else f'"{plain}"'
    message = f"the character {named(first)} cannot stand in a TOML value"
    return Fault(
        faults.TOML_SYNTAX, message, f"write {instead(first)} instead: {written}", start + element.index(first)
    )


def nesting(what: str, at: int) -> Fault:
    """The fault of nesting that is deeper than any mask needs."""
    return Fault(
        faults.OUT_OF_BOUNDS, f"{what} is nested more than {MAX_NESTING} deep", "a mask file needs two levels", at
    )


def value(text: str, start: int) -> Fault:
    """The fault where no value begins."""
    if fault := _comment(text, start, _BESIDE_VALUES):
        return fault
    element = _element(text, start)
    if not element:
        return Fault(
            faults.TOML_SYNTAX,
            f"a value was expected, not {_here(text, start)}",
            'write a value, for instance "1/16"',
            start,
        )
    if fault := _typography(element, start):
        return fault
    if element.lower() in ("true", "false"):
        return Fault(
            faults.TOML_SYNTAX, f"{element} is not a TOML value", f"write {element.lower()} in lower case", start
        )
    if re.match(r"[+-]?\.[0-9]", element):
        help = f'write 0 before the point, or a string: "{element}"'
        return Fault(faults.TOML_SYNTAX, "a decimal in TOML has a digit before its point", help, start)
    at = start + (element[0] in "+-")
    message = "text and expressions must be quoted: no TOML value begins like this"
    return Fault(faults.TOML_SYNTAX, message, _as_string(element), at)


def after_value(text: str, start: int, at: int) -> Fault:
    """The fault of what stands after a value, or on its line, and does not belong there. `start`: of the value."""
    if fault := _comment(text, at, _BESIDE_VALUES):
        return fault
    c = text[at : at + 1]
    if c and MENDS.get(c) == "a space":
        return Fault(
            faults.TOML_SYNTAX, f"the character {named(c)} is no space in TOML", "write a plain space instead", at
        )
    element = _element(text, start)
    if not element:  # a header, a string, an array or a table: there is nothing to quote
        return Fault(
            faults.TOML_SYNTAX, f"the line should end here, not continue with {_here(text, at)}", "start a new line", at
        )
    if c == "/":
        return Fault(
            faults.FRACTION_NOT_QUOTED,
            "fraction not quoted: TOML has no fractions",
            f'write exact numbers as strings: "{mended(element)}"',
            at,
            reason=Reason.NOT_QUOTED,
        )
    if c == ".":
        help = f'write 1.0 for 1., or a string: "{element}"'
        return Fault(faults.TOML_SYNTAX, "a decimal in TOML has a digit after its point", help, at)
    if c.isdigit() and text[start:at] == "0" and (whole := _WHOLE_PART.search(text, max(0, start - 20), start)):
        help = f"decimals need a point: {whole[1]}.{element}"
        return Fault(
            faults.TOML_SYNTAX, "a number in TOML does not begin with 0; is the comma a decimal comma?", help, at
        )
    if c.isdigit() and text[start:at] in ("0", "-0", "+0"):
        return Fault(
            faults.TOML_SYNTAX,
            "a number in TOML does not begin with 0",
            f"write {element.lstrip('+-0') or '0'} instead",
            at,
        )
    if c and (c in "*^+-(" or c in MENDS or c.isidentifier() or c.isdigit()):
        message = "expression not quoted: TOML has single numbers only"
        return Fault(faults.TOML_SYNTAX, message, _as_string(element), at, reason=Reason.NOT_QUOTED)
    return Fault(
        faults.TOML_SYNTAX, f"the value should end here, not continue with {_here(text, at)}", "start a new line", at
    )


def separator(text: str, opening: int, start: int, at: int, closing: str) -> Fault:
    """The fault where an array or an inline table neither goes on nor ends. `start`: of the value before."""
    same_line = "\n" not in text[start:at]
    if same_line and text[at] not in "\"'[{" and text[start] not in "\"'[{" and not text[at].isdigit():
        fault = after_value(text, start, at)
        if fault.reason is Reason.NOT_QUOTED:
            return fault
    line = text.count("\n", 0, opening) + 1
    message = f'a comma or "{closing}" was expected, not {_here(text, at)}'
    help = f'put a comma between values, or close the "{text[opening]}" of line {line}'
    return Fault(faults.TOML_SYNTAX, message, help, at)


def unclosed(opening: int, bracket: str, closing: str) -> Fault:
    """The fault of a file that ends inside an array or an inline table."""
    return Fault(faults.TOML_SYNTAX, f'this "{bracket}" is never closed', f'add the missing "{closing}"', opening)


def string(text: str, start: int, quote: str) -> Fault:
    """The fault of a string without end."""
    for at in range(start + 1, min(len(text), start + 1000)):
        if text[at] in "\r\n" or len(quote) == 3:
            break
        if text[at] in QUOTES:
            help = f"write a straight quote instead: {quote}"
            return Fault(faults.TOML_SYNTAX, f"the character {named(text[at])} is no quotation mark in TOML", help, at)
    where = "" if len(quote) == 3 else " on its line"
    return Fault(faults.TOML_SYNTAX, f"this string is not closed{where}", f"add the missing {quote}", start)


def escape(text: str, at: int) -> Fault:
    """The fault of a backslash before a letter that TOML does not know."""
    help = "write \\\\ for a backslash, or put the text in single quotes"
    return Fault(faults.TOML_SYNTAX, f'"{shown(text[at : at + 2])}" is no escape in TOML', help, at)


def header(text: str, at: int, closing: str) -> Fault:
    """The fault of a table header without end."""
    message = f'"{closing}" was expected to close the table name, not {_here(text, at)}'
    return Fault(faults.TOML_SYNTAX, message, "write a table as [mask]", at)


def key(text: str, at: int) -> Fault:
    """The fault where no key begins."""
    if fault := _comment(text, at) or _beyond_ascii(text, at, at):
        return fault
    return Fault(
        faults.TOML_SYNTAX, f"a key was expected, not {_here(text, at)}", "write one key = value on each line", at
    )


def _beyond_ascii(text: str, start: int, at: int) -> Fault | None:
    """The fault of a letter at `at` that a bare key cannot have, or of quotation marks that are none; None without."""
    c = text[at : at + 1]
    if c and c in QUOTES:
        return Fault(
            faults.TOML_SYNTAX, f"the character {named(c)} is no quotation mark in TOML", 'write straight quotes: "', at
        )
    if c.isascii() or not ("a" + c).isidentifier():
        return None
    help = 'quote the key: "ω" = "1/16"'
    if (line := _KEY_LINE.match(text, start)) and is_name(name := line[1].strip()):
        value = _SAFE_VALUE.fullmatch(line[2])
        help = f'quote the key: "{shown(name)}" = ' + (value[1] if value else '"1/16"')
    return Fault(faults.TOML_SYNTAX, f"{_here(text, at)} cannot stand in a bare key", help, at)


def equals(text: str, start: int, at: int) -> Fault:
    """The fault of a key without its "="."""
    if fault := _beyond_ascii(text, start, at):
        return fault
    name = shown(text[start:at].strip())
    message = f'"=" was expected after the key {name}, not {_here(text, at)}'
    line = _REST.match(text, at + 1)
    value = _SAFE_VALUE.fullmatch(line[0].strip()) if line and text[at : at + 1] == ":" else None
    help = f"write {name} = {value[1] if value else 'value'}"
    if text[at : at + 1] == ",":
        help = f'an index is a key in quotes: "{name},0" = 1'
    return Fault(faults.TOML_SYNTAX, message, help, at)
