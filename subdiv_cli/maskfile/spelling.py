"""Values as TOML spells them, for the files that are written."""

from __future__ import annotations

import re
from collections.abc import Iterable

from subdiv_cli.maskfile.expressions import Expression

INTEGER = re.compile(r"0|-?[1-9][0-9]{0,17}")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_SHORT = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"}
_WIDTH = 100


def nested(value: object) -> str:
    """A value with lists in lists as TOML."""
    if isinstance(value, tuple):
        return f"[{', '.join(map(nested, value))}]"
    return number(value) if isinstance(value, Expression) else str(value)


def number(expression: Expression) -> str:
    """An expression as TOML: an integer as it is, others as a string."""
    return expression.text if INTEGER.fullmatch(expression.text) else quoted(expression.text)


def listed(key: str, items: Iterable[str]) -> list[str]:
    """The lines of a list under a key: one line where it fits, else as many as are needed."""
    items = list(items)
    if len(one := f"{key} = [{', '.join(items)}]") <= _WIDTH:
        return [one]
    lines, line = [f"{key} = ["], "   "
    for item in items:
        if len(line) + len(item) + 2 > _WIDTH and line.strip():
            lines.append(line)
            line = "   "
        line += f" {item},"
    return [*lines, line, "]"]


def key_of(name: str) -> str:
    """A name as a TOML key, quoted where it must be."""
    return name if _BARE_KEY.fullmatch(name) else quoted(name)


def quoted(text: str) -> str:
    """A text as a TOML string."""
    return '"' + "".join(_SHORT.get(c) or (c if c >= " " and c != "\x7f" else f"\\u{ord(c):04X}") for c in text) + '"'
