"""Results held to an earlier report: a mask fails where something is worse than it was there.

Verdicts: proved is better than undecided, undecided than refuted. Orders and degrees must not fall, and an enclosure
of an exponent must still meet the old one. What a file expects for the first time must be proved.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.model import INFINITY, Exponent, Judgement, Result, Verdict
from subdiv_cli.model.closed import rational
from subdiv_cli.model.properties import PROPERTIES

_LONG = ("findings", "facts")
"""The keys that nothing is held to: they are most of a result."""
_RANK = {"refuted": 0, "undecided": 1, "skipped": 1, "proved": 2}


_Key = tuple[str, tuple[tuple[str, str], ...]]
"""A file and its parameters, as a report spells them."""


class Baseline:
    """The results of a report, as JSON data, by their files and parameters."""

    def __init__(self, results: Sequence[Mapping[str, Any]]) -> None:
        self._old = {
            (_same(old["file"]), _at(old.get("parameters", {}))): {key: old[key] for key in old if key not in _LONG}
            for old in results
        }
        self._only: dict[str, _Key | None] = {}
        """The key of each file that the report has once; None for a file that it has at several parameters."""
        for key in self._old:
            self._only[key[0]] = key if key[0] not in self._only else None
        self._seen: set[_Key] = set()

    def judge(self, result: Result) -> Result:
        """The result with its regressions, which decide its status; unchanged where the baseline has no such mask."""
        key: _Key | None = (
            _same(result.file),
            _at({name: rational(value) for name, value in result.parameters.items()}),
        )
        if key not in self._old and not result.varied:
            key = self._only.get(_same(result.file))  # another default than then
        old = None if key is None else self._old.get(key)
        if key is not None:
            self._seen.add(key)
        if old is None or old["status"] == "invalid" or result.status == "invalid":
            return result
        worse = tuple(faults.BASELINE.problem(message, file=result.file) for message in _worse(result, old))
        return replace(result, regressions=worse, status="failed" if worse else "passed")

    def missing(self) -> tuple[str, ...]:
        """The files of the baseline that no result was about, with the parameters where it has several of a file."""
        return tuple(sorted(self._name(key, old["file"]) for key, old in self._old.items() if key not in self._seen))

    def _name(self, key: _Key, file: str) -> str:
        at = ",".join(f"{name}={value}" for name, value in key[1])
        return f"{file}[{at}]" if at and self._only[key[0]] is None else file


def _at(parameters: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted(parameters.items()))


def _same(file: str) -> str:
    return os.path.normpath(file)


def _worse(result: Result, old: Mapping[str, Any]) -> Iterator[str]:
    for row in PROPERTIES:
        if row.key not in old:  # the report is older than the property
            continue
        before, now = old[row.key], getattr(result, row.key)
        match row.form:
            case "verdict":
                yield from _verdict(row.phrase, before["verdict"], now)
            case "smoothness":
                order = INFINITY if before["order"] == "infinity" else before["order"]
                yield from _number(row.phrase, order, now.order)
            case "exponent":
                yield from _enclosure(row.phrase, before, now)
            case "order" | "degree" | "dimension":
                yield from _number(row.phrase, before, now)
    judged_before = {(e["key"], e["expected"]): e["verdict"] for e in old["expectations"]}
    for judged in result.expectations:
        yield from _expectation(judged, judged_before.get((judged.expectation.key, judged.expectation.text)))


def _verdict(name: str, old: str, new: Verdict) -> Iterator[str]:
    if _RANK[new.value] < _RANK[old]:
        yield f"{name} was {old} and is {new.value}"


def _number(name: str, old: int | float | None, new: int | float | None) -> Iterator[str]:
    if old is not None and (new is None or new < old):
        yield f"{name} was {old} and is {'not known' if new is None else new}"


def _enclosure(name: str, old: Mapping[str, Any] | None, new: Exponent | None) -> Iterator[str]:
    """A regression where two certified enclosures, which must have the exponent in common, do not meet."""
    if old is None:
        return
    if new is None:
        yield f"{name} was known and is not"
        return
    if (old["exact"] == "infinity") is not (new.exact == INFINITY):
        yield f"{name} was {old['exact']} and is {'infinity' if new.exact == INFINITY else 'finite'}"
        return
    below, above = _or(old["lower"], -1), _or(old["upper"], 1)
    lower, upper = _or(new.lower, -1), _or(new.upper, 1)
    if lower > above or upper < below:
        yield f"{name} was in [{below!r}, {above!r}] and is in [{lower!r}, {upper!r}]"


def _or(bound: float | None, sign: int) -> float:
    return sign * float("inf") if bound is None else bound


def _expectation(judged: Judgement, old: str | None) -> Iterator[str]:
    expected = f"{judged.expectation.key} {judged.expectation.text}"
    if old is not None:
        yield from _verdict(f"the expectation {expected}", old, judged.verdict)
    elif judged.verdict is not Verdict.PROVED:
        yield f"the new expectation {expected} is {judged.verdict.value}"
