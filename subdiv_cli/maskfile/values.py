"""Values as TOML gives them: decimals that keep their spelling, and words for types."""

from __future__ import annotations


class Decimal:
    """A TOML float, unconverted: its text without underscores."""

    __slots__ = ("text",)

    def __init__(self, text: str) -> None:
        self.text = text.replace("_", "")


def described(value: object) -> str:
    """The kind of a TOML value in words."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return "an integer"
    if isinstance(value, Decimal):
        return "a decimal"
    if isinstance(value, str):
        return "a string"
    if isinstance(value, list):
        return "an array"
    if isinstance(value, dict):
        return "a table"
    return "a date or time"
