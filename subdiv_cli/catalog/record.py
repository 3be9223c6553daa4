"""Results as JSON and back, without loss, for the cache. The JSON report is for readers and forgets types.

Every class of `model` is known by its name, so a field that is added there is recorded too. Numbers of any length are
spelled in hexadecimal, which Python bounds nowhere.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from enum import Enum
from fractions import Fraction
from functools import cache
from typing import Any

from subdiv_cli import model

_PLAIN = (str, float, bool, type(None))
_LONG = 1 << 63


class UnreadableRecordError(ValueError):
    """Raised for data that is no record of ours."""


def encode(value: object) -> Any:
    """A value of `model` as JSON data; fields that have their defaults are left out. Raises TypeError for others."""
    if isinstance(value, _PLAIN):
        return value
    if isinstance(value, int):
        return value if -_LONG < value < _LONG else {"int": f"{value:x}"}
    if isinstance(value, Fraction):
        return {"fraction": f"{value.numerator:x}/{value.denominator:x}"}
    if isinstance(value, Mapping):
        return {"map": {key: encode(item) for key, item in value.items()}}
    if isinstance(value, Enum):
        return {"is": type(value).__name__, "value": value.value}
    if dataclasses.is_dataclass(value) or hasattr(value, "_fields"):
        name = type(value).__name__
        defaults = _defaults(_known(name))
        fields = {key: getattr(value, key) for key in _fields(value)}
        kept = {key: encode(v) for key, v in fields.items() if key not in defaults or v != defaults[key]}
        return {"is": name, "fields": kept}
    if isinstance(value, tuple):
        return [encode(item) for item in value]
    raise TypeError(f"{type(value).__name__} is not recorded")


def decode(data: Any) -> Any:
    """The value of a record. Raises UnreadableRecordError for what `encode` does not write."""
    try:
        return _decode(data)
    except (KeyError, TypeError, ValueError, AttributeError, ZeroDivisionError, RecursionError) as error:
        raise UnreadableRecordError(f"{type(error).__name__}: {error}") from None


def _decode(data: Any) -> Any:
    kind = type(data)
    if kind is list:
        return tuple(map(_decode, data))
    if kind is not dict:
        return data
    if "is" in data:
        known = _known(data["is"])
        if "value" in data:
            return known(data["value"])
        return known(**{key: _decode(item) for key, item in data["fields"].items()})
    if "fraction" in data:
        numerator, _, denominator = data["fraction"].partition("/")
        return Fraction(int(numerator, 16), int(denominator, 16))
    if "int" in data:
        return int(data["int"], 16)
    return {key: _decode(item) for key, item in data["map"].items()}


@cache
def _known(name: str) -> Any:
    """The class of `model` with this name. Raises TypeError where there is none."""
    member = getattr(model, name, None)
    if not isinstance(member, type) or not member.__module__.startswith(model.__name__):
        raise TypeError(f"there is no {name} in the model")
    return member


def _fields(value: Any) -> tuple[str, ...]:
    named: tuple[str, ...] = getattr(value, "_fields", ())
    return named or tuple(field.name for field in dataclasses.fields(value))


def _defaults(known: Any) -> Mapping[str, Any]:
    if hasattr(known, "_field_defaults"):
        defaults: Mapping[str, Any] = known._field_defaults
        return defaults
    return {f.name: f.default for f in dataclasses.fields(known) if f.default is not dataclasses.MISSING}
