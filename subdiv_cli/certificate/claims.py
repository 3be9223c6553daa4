"""Claims in the order they are made: each statement once, with what it uses, as FORMAT.md says."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

Json = dict[str, Any]


class Claims:
    """The claims of one certificate. `add` returns the number of a claim; the same claim is made only once."""

    def __init__(self) -> None:
        self.made: list[Json] = []
        self._numbers: dict[str, int] = {}

    def add(self, rule: str, statement: Json, witness: Json, uses: Sequence[int] = (), work: int = 1) -> int:
        claim = {"rule": rule, "statement": statement, "witness": witness, "uses": list(uses), "work": work}
        key = json.dumps(claim, sort_keys=True)
        if key not in self._numbers:
            self._numbers[key] = len(self.made)
            self.made.append(claim)
        return self._numbers[key]

    def prove(
        self, rule: str, statement: Json, witness: Json | None = None, uses: Sequence[int] = (), work: int = 1
    ) -> int:
        """As `add`; a statement without its property is of the one that has the name of the rule."""
        return self.add(rule, {"property": rule, **statement}, witness or {}, uses, work)

    def statement(self, number: int) -> Json:
        statement: Json = self.made[number]["statement"]
        return statement


def rational(x: Fraction | int) -> str:
    """`p/q`, or `p` for an integer. Huge integers are spelled piece by piece: Python refuses more than 4300 digits."""
    x = Fraction(x)
    return _integer(x.numerator) + ("" if x.denominator == 1 else f"/{_integer(x.denominator)}")


def _integer(n: int) -> str:
    if n.bit_length() < 13_000:
        return str(n)
    if n < 0:
        return "-" + _integer(-n)
    half = n.bit_length() * 15 // 100
    high, low = divmod(n, 10**half)
    return _integer(high) + _integer(low).zfill(half)


def polynomial(start: int, coefficients: Sequence[Fraction | int]) -> Json:
    return {"start": start, "coefficients": [rational(c) for c in coefficients]}


def document_text(document: Mapping[str, Any]) -> str:
    """The JSON text of a certificate, a line for each statement of the goal and for each claim."""
    lines = []
    for key, value in document.items():
        if isinstance(value, list):
            entries = ",\n  ".join(json.dumps(entry) for entry in value)
            lines.append(f"{json.dumps(key)}: [\n  {entries}\n ]" if value else f"{json.dumps(key)}: []")
        else:
            lines.append(f"{json.dumps(key)}: {json.dumps(value)}")
    return "{" + ",\n ".join(lines) + "}\n"


def matrices_document(matrices: Sequence[Sequence[Sequence[Fraction]]]) -> Mapping[str, Any]:
    return {"kind": "matrices", "matrices": [[[rational(x) for x in row] for row in rows] for rows in matrices]}


def mask_document(arity: int, start: int, coefficients: Sequence[Fraction]) -> Mapping[str, Any]:
    return {"kind": "scalar", "arity": arity, **polynomial(start, coefficients)}
