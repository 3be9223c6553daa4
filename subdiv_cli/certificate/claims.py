"""Claims in the order they are made: each statement once, with what it uses, as FORMAT.md says."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from subdiv_cli.model import DECIDED, Finding
from subdiv_cli.model.closed import rational

Json = dict[str, Any]
MOST_WORK = 50_000_000
"""The most work that the checker does for one certificate; a longer one is not written."""


class Claims:
    """The claims of one certificate. `add` returns the number of a claim; the same claim is made only once."""

    def __init__(self) -> None:
        self.made: list[Json] = []
        self._numbers: dict[str, int] = {}

    def add(self, rule: str, statement: Json, witness: Json, uses: Sequence[int] = (), work: int = 1) -> int:
        """The number of the claim; the same claim has the same number."""
        claim = {"rule": rule, "statement": statement, "witness": witness, "uses": list(uses), "work": work}
        key = json.dumps(claim, sort_keys=True)
        if key not in self._numbers:
            self._numbers[key] = len(self.made)
            self.made.append(claim)
        return self._numbers[key]

    def prove(
        self, rule: str, statement: Json, witness: Json | None = None, uses: Sequence[int] = (), work: int = 1
    ) -> int:
        """The number of the claim, as in `add`; a statement without a property has that of the rule's name."""
        return self.add(rule, {"property": rule, **statement}, witness or {}, uses, work)

    def statement(self, number: int) -> Json:
        """The statement of the claim with this number."""
        statement: Json = self.made[number]["statement"]
        return statement

    def document(self, mask: Mapping[str, Any], goal: Iterable[int]) -> Json | None:
        """The document as FORMAT.md has it, about this mask, with the statements of these claims as its goal.

        None without a goal, and where the claims need more work than the checker does.
        """
        statements = [self.statement(number) for number in dict.fromkeys(goal)]
        if not statements or sum(claim["work"] for claim in self.made) > MOST_WORK:
            return None
        return {"format": "subdiv-certificate", "version": 1, "mask": mask, "goal": statements, "claims": self.made}


class Certificate(NamedTuple):
    """A document as FORMAT.md has it, and for each finding the numbers of the claims that state it."""

    document: Json
    claims: tuple[tuple[int, ...], ...]


def certificate_of(
    claims: Claims, mask: Mapping[str, Any], findings: Iterable[Finding], claims_of: Callable[[Finding], Iterable[int]]
) -> Certificate | None:
    """The proof of the findings that are decided, its goal in their order.

    `claims_of` makes the claims that state a finding; none where its witness was too costly to compute. None where the
    whole needs more work than the checker does.
    """
    numbers = tuple(tuple(claims_of(found)) if found.verdict in DECIDED else () for found in findings)
    document = claims.document(mask, (number for several in numbers for number in several))
    return None if document is None else Certificate(document, numbers)


def polynomial(start: int, coefficients: Sequence[Fraction | int]) -> Json:
    """A polynomial as statements have it: its start and its coefficients."""
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
